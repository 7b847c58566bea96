//! Doors on the outlines of rooms. A door is a corner of the rooms that it joins, and the wall goes on beyond it almost straight.

use std::collections::BTreeSet;

use super::sort::corners;
use crate::geometry::Point;
use crate::plan::limits::OUTLINE_CORNERS;
use crate::plan::read::rings::Rings;
use crate::plan::units::LocalPlane;

/// Parts of a degree, a centimetre, in which corners are the same place.
const DEGREE_PARTS: f64 = 1e7;
/// Metres that a door may be beside the straight wall between its neighbours: degrees are written to a centimetre, and hands are
/// less exact. Where it is farther off, the door is in a corner.
const BESIDE: f64 = 0.1;
/// Metres from the end of a wall to a door: half the thickness of the wall there, and a frame.
const FRAME: f64 = 0.1;
/// Metres of the narrowest door that a short wall makes of a wider one.
const NARROWEST: f64 = 0.5;

/// A place in degrees, to compare it with others.
pub(super) type PlaceKey = (i64, i64);

pub(super) fn key_of(at: Point) -> PlaceKey {
    ((at.x * DEGREE_PARTS).round() as i64, (at.y * DEGREE_PARTS).round() as i64)
}

/// An area in degrees on a plane, without those corners that are nothing but doors in straight walls.
pub(super) fn on_plane(area: &Rings, plane: &LocalPlane, doors: &BTreeSet<PlaceKey>) -> Rings {
    let ring = |ring: &Vec<Point>| {
        let corners = ring.iter();
        let corners = corners.map(|at| (plane.project(at.x, at.y), doors.contains(&key_of(*at))));
        straightened(&corners.collect::<Vec<_>>())
    };
    Rings { outer: ring(&area.outer), holes: area.holes.iter().map(ring).collect() }
}

/// A ring without its doors in straight walls; a flag marks the doors.
fn straightened(ring: &[(Point, bool)]) -> Vec<Point> {
    let mut kept: Vec<Point> = Vec::with_capacity(ring.len());
    let mut left = ring.len();
    for (index, &(corner, is_door)) in ring.iter().enumerate() {
        let before = kept.last().copied().unwrap_or(ring[ring.len() - 1].0);
        let after = ring[(index + 1) % ring.len()].0;
        if is_door && left > 3 && place_on(corner, before, after).0 <= BESIDE {
            left -= 1;
        } else {
            kept.push(corner);
        }
    }
    kept
}

/// Distance of a place from an edge, and metres from the edge's start to the nearest place on it.
fn place_on(at: Point, start: Point, end: Point) -> (f64, f64) {
    let length = start.distance(end);
    if length <= f64::EPSILON {
        return (at.distance(start), 0.0);
    }
    let along = (end - start) / length;
    let metres = (at - start).dot(along).clamp(0.0, length);
    (at.distance(start + along * metres), metres)
}

/// A door that fits into a wall.
#[derive(Debug, PartialEq)]
pub(super) struct Fit {
    pub(super) center: Point,
    /// Along the wall, a metre.
    pub(super) along: Point,
    pub(super) width: f64,
}

/// A door of a width near a place, moved along the shortest wall that it is in so that the wall holds it, and made narrower where
/// that is too short. `None` where no wall is near.
pub(super) fn fitted<'a>(at: Point, width: f64, areas: impl Iterator<Item = &'a Rings>) -> Option<Fit> {
    let walls = areas.filter_map(|area| wall_near(at, area));
    let (start, end) = walls.min_by(|a, b| a.0.distance(a.1).total_cmp(&b.0.distance(b.1)))?;
    let length = start.distance(end);
    let width = width.min((length - 2.0 * FRAME).max(NARROWEST));
    let margin = (width / 2.0 + FRAME).min(length / 2.0);
    let along = (end - start) / length;
    let metres = place_on(at, start, end).1.clamp(margin, length - margin);
    Some(Fit { center: start + along * metres, along, width })
}

/// The longest of the edges that go through a place.
fn wall_near(at: Point, area: &Rings) -> Option<(Point, Point)> {
    // Larger outlines are no rooms.
    if corners(area).count() > OUTLINE_CORNERS {
        return None;
    }
    let edges = std::iter::once(&area.outer).chain(&area.holes).flat_map(|ring| {
        let ends = ring.iter().cycle().skip(1);
        ring.iter().copied().zip(ends.copied())
    });
    let near =
        edges.filter(|(start, end)| place_on(at, *start, *end).0 <= BESIDE && start.distance(*end) > BESIDE);
    near.max_by(|a, b| a.0.distance(a.1).total_cmp(&b.0.distance(b.1)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(corners: &[(f64, f64)]) -> Vec<Point> {
        corners.iter().copied().map(Point::from).collect()
    }

    #[test]
    fn doors_in_straight_walls_are_no_corners() {
        let drawn = [
            ((0.0, 0.0), false),
            ((2.0, 0.04), true),
            ((4.0, 0.0), false),
            ((4.0, 1.0), false),
            ((4.0, 3.0), true),
            ((0.0, 3.0), false),
        ];
        let drawn = drawn.map(|((x, y), is_door)| (Point::new(x, y), is_door));
        assert_eq!(straightened(&drawn), ring(&[(0.0, 0.0), (4.0, 0.0), (4.0, 1.0), (4.0, 3.0), (0.0, 3.0)]));
    }

    #[test]
    fn a_ring_of_doors_stays_a_ring() {
        let flat = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (3.0, 0.01)].map(|at| (Point::from(at), true));
        assert_eq!(straightened(&flat).len(), 3);
        assert!(straightened(&[]).is_empty());
    }

    #[test]
    fn a_door_near_a_corner_moves_into_the_wall() {
        let room = Rings { outer: ring(&[(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)]), holes: vec![] };
        let fit = fitted(Point::new(0.2, 0.0), 1.0, [&room].into_iter()).unwrap();
        assert!(fit.center.distance(Point::new(0.6, 0.0)) < 1e-9 && fit.width == 1.0, "{fit:?}");
        let narrow =
            Rings { outer: ring(&[(0.0, 0.0), (0.9, 0.0), (0.9, -3.0), (0.0, -3.0)]), holes: vec![] };
        let fit = fitted(Point::new(0.2, 0.0), 1.0, [&room, &narrow].into_iter()).unwrap();
        assert!(
            fit.center.distance(Point::new(0.45, 0.0)) < 1e-9 && (fit.width - 0.7).abs() < 1e-9,
            "{fit:?}"
        );
        assert_eq!(fitted(Point::new(2.0, 1.5), 1.0, [&room].into_iter()), None);
    }
}
