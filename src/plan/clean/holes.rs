//! Keeps holes that lie inside their outline and touch neither it nor each other.

use geo::algorithm::buffer::{BufferStyle, LineJoin};
use geo::{BooleanOps, Buffer, Distance, Euclidean, unary_union};

use super::surface::to_points;
use super::{Ring, RingFault, clean_ring, largest_part, refuse_sliver, to_surface};
use crate::geometry::{Point, Polygon};
use crate::plan::assemble::BoxIndex;

/// Square metres of the smallest hole: a pipe's casing; smaller ones are drawing noise.
const SMALLEST_HOLE: f64 = 0.005;
/// Borders closer than this many metres touch.
const TOUCHING: f64 = 0.005;
/// Touching holes are grown by this many metres, so that they really merge.
const MERGING_MARGIN: f64 = 0.006;
/// Longest spur of a grown hole's corner, in margins.
const MITRE_LIMIT: f64 = 4.0;
/// Square metres up to which a part of a room that is cut off by its holes is not reported.
const NEGLIGIBLE_PART: f64 = 0.01;
/// An edge this close in metres to an edge as found came from it.
const SAME_EDGE: f64 = 0.003;

/// An outline and its holes, sound together.
#[derive(Clone, Debug)]
pub(in crate::plan) struct Cleaned {
    /// The outline, perhaps with notches where holes lay on the border.
    pub(in crate::plan) ring: Ring,
    /// The holes.
    pub(in crate::plan) holes: Vec<Polygon>,
    /// The faults of the holes.
    pub(in crate::plan) faults: Vec<HoleFault>,
}

/// The fault of a hole; indices are those of the holes as found.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::plan) enum HoleFault {
    /// No usable ring; it was left out.
    Ring(usize, RingFault),
    /// Holes touch each other or the outline; they were merged.
    Merged,
    /// The holes cut off this many square metres of the room; the largest part stays.
    CutOff(f64),
    /// The holes leave no sound room; all were left out.
    AllDropped,
}

/// Cleans the holes of an outline and cuts them out where they touch it or each other.
pub(in crate::plan) fn clean_region(outline: Ring, holes: &[Vec<Point>]) -> Cleaned {
    let mut faults = Vec::new();
    let mut sound = Vec::new();
    for (index, hole) in holes.iter().enumerate() {
        match clean_ring(hole, &[]).and_then(|ring| refuse_sliver(ring, SMALLEST_HOLE)) {
            Ok(ring) => sound.push(ring.polygon),
            Err(fault) => faults.push(HoleFault::Ring(index, fault)),
        }
    }
    let mut cleaned = separate_holes(outline, sound);
    faults.append(&mut cleaned.faults);
    Cleaned { faults, ..cleaned }
}

/// Merges holes that touch each other or the outline.
pub(in crate::plan) fn separate_holes(outline: Ring, holes: Vec<Polygon>) -> Cleaned {
    if holes.is_empty() || are_apart(&outline.polygon, &holes) {
        return Cleaned { ring: outline, holes, faults: Vec::new() };
    }
    let Some((ring, kept, cut_off)) = cut_out(&outline, &holes) else {
        return Cleaned { ring: outline, holes: Vec::new(), faults: vec![HoleFault::AllDropped] };
    };
    let mut faults = vec![HoleFault::Merged];
    if cut_off > NEGLIGIBLE_PART {
        faults.push(HoleFault::CutOff(cut_off));
    }
    Cleaned { ring, holes: kept, faults }
}

fn are_apart(outline: &Polygon, holes: &[Polygon]) -> bool {
    let surfaces: Vec<_> = holes.iter().map(|hole| to_surface(hole, &[])).collect();
    let border = to_surface(outline, &[]).exterior().clone();
    let places = BoxIndex::of(holes.iter().map(Polygon::bounds).zip(0..));
    let near = |index: usize| {
        let others = places.meeting(holes[index].bounds().inflated(TOUCHING));
        others.filter(move |other| *other < index)
    };
    surfaces.iter().enumerate().all(|(index, surface)| {
        outline.contains(holes[index].corners()[0])
            && Euclidean.distance(surface.exterior(), &border) > TOUCHING
            && near(index).all(|other| Euclidean.distance(surface, &surfaces[other]) > TOUCHING)
    })
}

/// Takes the merged holes off the outline. `None` if nothing sound remains.
fn cut_out(outline: &Ring, holes: &[Polygon]) -> Option<(Ring, Vec<Polygon>, f64)> {
    let grown = grow(holes);
    let room = to_surface(&outline.polygon, &[]);
    let (part, cut_off) = largest_part(room.difference(&grown))?;
    let ring = clean_ring(&to_points(part.exterior()), &[]).ok()?;
    let ring = trace(ring.polygon, outline);
    let kept: Vec<Polygon> = part
        .interiors()
        .iter()
        .filter_map(|hole| clean_ring(&to_points(hole), &[]).ok())
        .map(|hole| hole.polygon)
        .collect();
    are_apart(&ring.polygon, &kept).then_some((ring, kept, cut_off))
}

fn grow(holes: &[Polygon]) -> geo::MultiPolygon<f64> {
    let style = BufferStyle::new(MERGING_MARGIN).line_join(LineJoin::Miter(MITRE_LIMIT));
    let grown: Vec<_> =
        holes.iter().map(|hole| to_surface(hole, &[]).buffer_with_style(style.clone())).collect();
    unary_union(grown.iter())
}

/// Finds for each edge of a changed polygon the edge as found on which it lies.
pub(in crate::plan) fn trace(polygon: Polygon, origin: &Ring) -> Ring {
    let edges = polygon
        .edges()
        .map(|changed| {
            origin.polygon.edges().zip(&origin.edges).find_map(|(found, &edge)| {
                let (along, offset) = (found.direction(), changed.middle() - found.start);
                let place = offset.dot(along);
                let is_on = offset.perp_dot(along).abs() < SAME_EDGE
                    && place > 0.0
                    && place < found.length()
                    && changed.direction().perp_dot(along).abs() * changed.length() < SAME_EDGE * 2.0;
                is_on.then_some(edge).flatten()
            })
        })
        .collect();
    Ring { polygon, edges }
}
