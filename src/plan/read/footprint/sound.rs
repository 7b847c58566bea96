//! Makes regions of the rings of a file, mending those that cross or touch themselves.

use geo::algorithm::bool_ops::{FillRule, OpType};
use geo::algorithm::buffer::{BufferStyle, LineJoin};
use geo::algorithm::orient::Direction;
use geo::{Area, BooleanOps, Buffer, MultiPolygon, Orient, unary_union};

use super::drawn::Rings;
use crate::geometry::{Point, Polygon, Region};
use crate::plan::clean::{
    Ring, RingFault, clean_region, clean_ring, largest_part, mean_width, to_points, to_surface,
};

/// Square metres below which nothing is a building: telephone boxes have one.
const SMALLEST_BUILDING: f64 = 1.0;
/// Metres below which nothing is a building: the mean width of a wall.
const NARROWEST_BUILDING: f64 = 0.6;

/// Square metres above which nothing is a building: the largest factories have half of it.
const LARGEST_BUILDING: f64 = 1_000_000.0;

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
    let (ring, mended_ring) = sound_ring(&rings.outer)?;
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

/// The largest piece of what a ring encloses.
fn mended(points: &[Point]) -> Option<Ring> {
    let line = points.iter().map(|point| geo::Coord { x: point.x, y: point.y }).collect();
    let crossed = geo::Polygon::new(line, Vec::new());
    let nothing = MultiPolygon::<f64>::new(Vec::new());
    let pieces = crossed.boolean_op_with_fill_rule(&nothing, OpType::Union, FillRule::NonZero);
    let (largest, _) = largest_part(pieces)?;
    clean_ring(&to_points(largest.exterior()), &[]).ok()
}

/// The region as a surface of the crate `geo`, its holes in the other direction than its outline.
pub(super) fn surface_of(region: &Region) -> geo::Polygon<f64> {
    to_surface(&region.outline, &region.holes).orient(Direction::Default)
}

/// The regions that some regions cover together, the largest first. Those that all but touch are one.
pub(super) fn united<'a>(regions: impl IntoIterator<Item = &'a Region>) -> Vec<Region> {
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
}
