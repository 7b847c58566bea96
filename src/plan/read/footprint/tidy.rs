//! Takes off an outline what no wall follows: surveyors' noise, needles, light wells too small to stand in.

use geo::Simplify;

use super::drawn::Rings;
use super::frame::snapped;
use super::needles::without_needles;
use super::sound::{sound, surface_of};
use crate::geometry::{Point, Polygon, Region};
use crate::plan::clean::to_points;

/// Metres that a corner may lie off the line of a wall.
const SIMPLIFIED: f64 = 0.10;
/// Square metres of the smallest courtyard; smaller ones are shafts of the building.
const SMALLEST_COURTYARD: f64 = 4.0;

/// The region without what no wall follows. Its borders begin at their lowest corners, whatever the file begins with.
pub(super) fn tidied(mut region: Region) -> Region {
    region.holes.retain(|hole| hole.area() >= SMALLEST_COURTYARD);
    let region = in_order(region);
    let region = simplified(&region).unwrap_or(region);
    let region = match without_needles(&region) {
        Some(blunt) => simplified(&in_order(blunt.clone())).unwrap_or(blunt),
        None => region,
    };
    in_order(region)
}

/// With fewer corners. `None` if that breaks it.
fn simplified(region: &Region) -> Option<Region> {
    let surface = surface_of(region).simplify(SIMPLIFIED);
    let ring = |line: &geo::LineString<f64>| to_points(line).into_iter().map(snapped).collect();
    let rings =
        Rings { outer: ring(surface.exterior()), holes: surface.interiors().iter().map(ring).collect() };
    let sound = sound(&rings).ok()?;
    let is_whole = !sound.is_mended && sound.region.holes.len() == region.holes.len();
    is_whole.then_some(sound.region)
}

/// With borders that begin at their lowest corners, and holes by those.
fn in_order(region: Region) -> Region {
    let mut holes: Vec<Polygon> = region.holes.into_iter().map(from_lowest).collect();
    holes.sort_by(|a, b| order(&a.corners()[0], &b.corners()[0]));
    Region { outline: from_lowest(region.outline), holes }
}

fn from_lowest(polygon: Polygon) -> Polygon {
    let mut corners = polygon.corners().to_vec();
    let lowest = (0..corners.len()).min_by(|&a, &b| order(&corners[a], &corners[b])).unwrap_or_default();
    corners.rotate_left(lowest);
    // The same corners from another one on; should a test at its edge of precision differ, the order stays.
    Polygon::new(&corners).unwrap_or(polygon)
}

fn order(a: &Point, b: &Point) -> std::cmp::Ordering {
    a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polygon(corners: &[(f64, f64)]) -> Polygon {
        Polygon::new(&corners.iter().map(|&(x, y)| Point::new(x, y)).collect::<Vec<_>>()).unwrap()
    }

    #[test]
    fn corners_off_the_line_by_less_than_ten_centimetres_go() {
        let wavy = polygon(&[(5.0, 0.05), (10.0, 0.0), (10.0, 8.0), (0.0, 8.0), (0.0, 0.0)]);
        let tidy = tidied(Region::simple(wavy));
        assert_eq!(tidy.outline, polygon(&[(0.0, 0.0), (10.0, 0.0), (10.0, 8.0), (0.0, 8.0)]));
    }

    #[test]
    fn small_courtyards_are_filled() {
        let hole = |side: f64| Polygon::rectangle(Point::splat(2.0), Point::splat(side));
        let outline = || Polygon::rectangle(Point::ZERO, Point::splat(12.0));
        let tidy = |side: f64| tidied(Region { outline: outline(), holes: vec![hole(side)] });
        assert_eq!(tidy(1.9).holes.len(), 0);
        assert_eq!(tidy(2.1).holes.len(), 1);
    }

    #[test]
    fn a_needle_goes_and_a_wing_stays() {
        let needle = polygon(&[
            (0.0, 0.0),
            (20.0, 0.0),
            (20.0, 5.0),
            (23.0, 5.1),
            (20.0, 5.3),
            (20.0, 10.0),
            (0.0, 10.0),
        ]);
        let tidy = tidied(Region::simple(needle));
        assert_eq!(tidy.outline, polygon(&[(0.0, 0.0), (20.0, 0.0), (20.0, 10.0), (0.0, 10.0)]));
        let wing = polygon(&[
            (0.0, 0.0),
            (20.0, 0.0),
            (20.0, 5.0),
            (23.0, 5.0),
            (23.0, 6.0),
            (20.0, 6.0),
            (20.0, 10.0),
            (0.0, 10.0),
        ]);
        assert_eq!(tidied(Region::simple(wing.clone())).outline, wing);
    }
}
