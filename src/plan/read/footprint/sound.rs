//! Makes regions of the rings of a file, mending those that cross or touch themselves.

use geo::algorithm::bool_ops::{FillRule, OpType};
use geo::algorithm::buffer::{BufferStyle, LineJoin};
use geo::algorithm::orient::Direction;
use geo::{Area, BooleanOps, Buffer, MultiPolygon, Orient, unary_union};

use super::drawn::Rings;
use crate::geometry::{Bounds, Point, Polygon, Region, Segment, edges};
use crate::plan::assemble::BoxIndex;
use crate::plan::clean::{
    Ring, RingFault, clean_region, clean_ring, largest_part, mean_width, to_points, to_surface,
};
use crate::plan::limits::OUTLINE_CORNERS;

/// Square metres below which nothing is a building: telephone boxes have one.
const SMALLEST_BUILDING: f64 = 1.0;
/// Metres below which nothing is a building: the mean width of a wall.
const NARROWEST_BUILDING: f64 = 0.6;

/// Square metres above which nothing is a building: the largest factories have half of it.
const LARGEST_BUILDING: f64 = 1_000_000.0;
/// Metres beyond which nothing is a building: the longest, galleries of accelerators and airports, have 3 km.
const LONGEST_BUILDING: f64 = 3_200.0;
/// Crossings of an outline with itself beyond which it is not mended: slips of the mouse leave one or two.
const MOST_CROSSINGS: usize = 1_000;
/// Surfaces whose boxes meet, for each surface, beyond which surfaces are not united: roofs, walls and floors of a building seen
/// from above have a dozen.
const MOST_MEETING: usize = 64;

/// Metres between pieces of one building that touch but for the rounding of their corners.
const JOINED_GAP: f64 = 0.04;
/// Radians of the sharpest corner that keeps its tip where an outline is grown or shrunk, 15°.
pub(super) const SHARPEST_TIP: f64 = 0.26;

/// A region and whether it had to be mended.
#[derive(Clone, Debug)]
pub(super) struct Sound {
    pub(super) region: Region,
    pub(super) is_mended: bool,
}

/// The region within some rings, in metres.
///
/// # Errors
/// The reason why there is none, in words.
pub(super) fn sound(rings: &Rings) -> Result<Sound, String> {
    let corner_count = rings.outer.len() + rings.holes.iter().map(Vec::len).sum::<usize>();
    if corner_count > OUTLINE_CORNERS {
        return Err(format!("its outline has {corner_count} corners"));
    }
    let (ring, mended_ring) = sound_ring(&rings.outer)?;
    let length = ring.polygon.bounds().size().max_element();
    if length > LONGEST_BUILDING {
        return Err(format!("it is {:.1} km long, more than any building", length / 1000.0));
    }
    let cleaned = clean_region(ring, &rings.holes);
    let is_mended = mended_ring || !cleaned.faults.is_empty();
    let region = Region { outline: cleaned.ring.polygon, holes: cleaned.holes };
    let (area, width) = (region.area(), mean_width(&region.outline));
    if area < SMALLEST_BUILDING {
        return Err(format!("it has {area:.2} m²"));
    }
    if area > LARGEST_BUILDING {
        return Err(format!("it has {area:.0} m², more than any building"));
    }
    if width < NARROWEST_BUILDING {
        return Err(format!("it is {width:.2} m wide"));
    }
    Ok(Sound { region, is_mended })
}

fn sound_ring(points: &[Point]) -> Result<(Ring, bool), String> {
    match clean_ring(points, &[]) {
        Ok(ring) => Ok((ring, false)),
        Err(RingFault::Polygon(fault @ crate::geometry::PolygonFault::SelfCrossing(..))) => {
            mended(points).map(|ring| (ring, true)).ok_or_else(|| fault.to_string())
        }
        Err(RingFault::Polygon(fault)) => Err(fault.to_string()),
        Err(RingFault::TooFar(_, distance)) => {
            Err(format!("it is {:.0} km from the middle of the map", distance / 1000.0))
        }
        Err(RingFault::TooManyCorners(count)) => Err(format!("its outline has {count} corners")),
        Err(RingFault::Sliver(area, _)) => Err(format!("it has {area:.2} m²")),
    }
}

/// The largest piece of what a ring encloses. `None` of a tangle, too.
fn mended(points: &[Point]) -> Option<Ring> {
    if has_more_crossings(points, MOST_CROSSINGS) {
        return None;
    }
    let line = points.iter().map(|point| geo::Coord { x: point.x, y: point.y }).collect();
    let crossed = geo::Polygon::new(line, Vec::new());
    let nothing = MultiPolygon::<f64>::new(Vec::new());
    let pieces = crossed.boolean_op_with_fill_rule(&nothing, OpType::Union, FillRule::NonZero);
    let (largest, _) = largest_part(pieces)?;
    clean_ring(&to_points(largest.exterior()), &[]).ok()
}

/// Whether edges of a ring cross each other more often than this.
fn has_more_crossings(points: &[Point], most: usize) -> bool {
    let all: Vec<Segment> = edges(points).collect();
    let are_crossing =
        |one: Segment, other: Segment| one.bounds().touches(other.bounds()) && one.crosses(other);
    let later = |index: usize| all[index + 1..].iter().map(move |other| (index, *other));
    let crossings = (0..all.len()).flat_map(later).filter(|&(index, other)| are_crossing(all[index], other));
    crossings.take(most + 1).count() > most
}

/// Whether the boxes of surfaces meet so often that to unite them would take long: no building is drawn like that.
pub(super) fn are_heaped(boxes: &[Bounds]) -> bool {
    let places = BoxIndex::of(boxes.iter().copied().zip(0_usize..));
    let most = MOST_MEETING * boxes.len();
    boxes.iter().flat_map(|bounds| places.meeting(*bounds)).take(most + 1).count() > most
}

/// The region as a surface of the crate `geo`, its holes in the other direction than its outline.
pub(super) fn surface_of(region: &Region) -> geo::Polygon<f64> {
    to_surface(&region.outline, &region.holes).orient(Direction::Default)
}

/// The regions that some regions cover together, the largest first. Those that all but touch are one. Of a heap of regions the
/// largest alone.
pub(super) fn united<'a>(regions: impl IntoIterator<Item = &'a Region>) -> Vec<Region> {
    let regions: Vec<&Region> = regions.into_iter().collect();
    let boxes: Vec<Bounds> = regions.iter().map(|region| region.outline.bounds()).collect();
    if are_heaped(&boxes) {
        let largest = regions.into_iter().reduce(|a, b| if b.area() > a.area() { b } else { a });
        return largest.into_iter().cloned().collect();
    }
    let surfaces: Vec<_> = regions.into_iter().map(surface_of).collect();
    let pieces = unary_union(&surfaces);
    if pieces.0.len() < 2 {
        return regions_of(pieces);
    }
    let style = |distance: f64| BufferStyle::new(distance).line_join(LineJoin::Miter(SHARPEST_TIP));
    let grown: Vec<_> =
        surfaces.iter().map(|surface| surface.buffer_with_style(style(JOINED_GAP / 2.0))).collect();
    let joined = unary_union(&grown).buffer_with_style(style(-JOINED_GAP / 2.0));
    regions_of(if joined.0.len() < pieces.0.len() { joined } else { pieces })
}

/// Square metres that two regions have in common.
pub(super) fn common_area(one: &Region, other: &Region) -> f64 {
    surface_of(one).intersection(&surface_of(other)).unsigned_area()
}

/// The regions of surfaces, as far as they are sound ones; the largest first.
pub(super) fn regions_of(surfaces: MultiPolygon<f64>) -> Vec<Region> {
    let rings = surfaces.0.iter().map(|surface| Rings {
        outer: to_points(surface.exterior()),
        holes: surface.interiors().iter().map(to_points).collect(),
    });
    let mut regions: Vec<Region> =
        rings.filter_map(|rings| sound(&rings).ok()).map(|sound| sound.region).collect();
    regions.sort_by(|a, b| b.area().total_cmp(&a.area()).then_with(|| lowest(&a.outline, &b.outline)));
    regions
}

fn lowest(a: &Polygon, b: &Polygon) -> std::cmp::Ordering {
    let (a, b) = (a.bounds().low, b.bounds().low);
    a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rings(outer: &[(f64, f64)], hole: &[(f64, f64)]) -> Rings {
        let points = |list: &[(f64, f64)]| list.iter().map(|&(x, y)| Point::new(x, y)).collect::<Vec<_>>();
        let holes = if hole.is_empty() { Vec::new() } else { vec![points(hole)] };
        Rings { outer: points(outer), holes }
    }

    #[test]
    fn a_closed_ring_in_any_direction_is_a_region() {
        let ring = rings(
            &[(0.0, 0.0), (0.0, 8.0), (8.0, 8.0), (8.0, 0.0), (0.0, 0.0)],
            &[(2.0, 2.0), (2.0, 4.0), (6.0, 4.0)],
        );
        let Sound { region, is_mended } = sound(&ring).unwrap();
        assert!((region.area() - 60.0).abs() < 1e-9);
        assert!(!is_mended);
    }

    #[test]
    fn the_larger_lobe_of_a_bow_tie_stays() {
        let ring = rings(&[(0.0, 0.0), (9.0, 9.0), (9.0, 0.0), (0.0, 3.0)], &[]);
        let Sound { region, is_mended } = sound(&ring).unwrap();
        assert!(is_mended);
        assert!((region.area() - 30.375).abs() < 1e-3, "{}", region.area());
    }

    #[test]
    fn what_is_no_building_has_a_reason() {
        let cases = [
            (vec![], "outline has 0 distinct corners, three are needed"),
            (vec![(0.0, 0.0), (1.0, 1.0)], "outline has 2 distinct corners, three are needed"),
            (vec![(0.0, 0.0), (0.5, 0.0), (0.5, 0.5)], "it has 0.12 m²"),
            (vec![(0.0, 0.0), (50.0, 0.0), (50.0, 0.2), (0.0, 0.2)], "it is 0.20 m wide"),
            (vec![(0.0, 0.0), (f64::NAN, 0.0), (5.0, 5.0)], "corner 1 is not a finite number"),
            (
                vec![(0.0, 0.0), (2e3, 0.0), (2e3, 2e3), (0.0, 2e3)],
                "it has 4000000 m², more than any building",
            ),
            (vec![(3e5, 4e5), (3e5, 4.1e5), (3.1e5, 4.1e5)], "it is 500 km from the middle of the map"),
        ];
        for (points, reason) in cases {
            assert_eq!(sound(&rings(&points, &[])).unwrap_err(), reason);
        }
    }

    #[test]
    fn what_is_larger_or_finer_than_any_building_has_a_reason() {
        let fault = |rings: &Rings| sound(rings).unwrap_err();
        let spit = rings(&[(0.0, 0.0), (90_000.0, 0.0), (90_000.0, 10.0), (0.0, 10.0)], &[]);
        assert_eq!(fault(&spit), "it is 90.0 km long, more than any building");
        let mut sieve = rings(&[(0.0, 0.0), (900.0, 0.0), (900.0, 900.0), (0.0, 900.0)], &[]);
        let hole = |number: usize| {
            let low = Point::new((number % 40) as f64, (number / 40) as f64) * 20.0 + 5.0;
            [(0.0, 0.0), (5.0, 0.0), (5.0, 5.0), (0.0, 5.0)].map(|corner| low + Point::from(corner)).to_vec()
        };
        sieve.holes = (0..1_100).map(hole).collect();
        assert_eq!(fault(&sieve), "its outline has 4404 corners");
    }

    #[test]
    fn a_tangle_is_not_mended() {
        // A star whose edges cross each other again and again.
        let corner = |number: usize| {
            let (sin, cos) = libm::sincos(number as f64 * 2.4);
            Point::new(cos, sin) * 50.0
        };
        let tangle: Vec<Point> = (0..150).map(corner).collect();
        assert!(has_more_crossings(&tangle, MOST_CROSSINGS));
        let fault = sound(&Rings { outer: tangle, holes: Vec::new() }).unwrap_err();
        assert!(fault.starts_with("outline crosses itself"), "{fault}");
    }

    #[test]
    fn of_a_heap_of_regions_the_largest_is_taken() {
        let region = |number: usize| {
            let size = Point::new(10.0 + number as f64 * 0.1, 10.0);
            Region::simple(Polygon::rectangle(Point::splat(number as f64 * 0.01), size))
        };
        let few: Vec<Region> = (0..20).map(region).collect();
        assert!((united(&few)[0].area() - 12.09 * 10.19).abs() < 2.0);
        let heap: Vec<Region> = (0..100).map(region).collect();
        assert_eq!(united(&heap), [heap[99].clone()]);
    }
}
