//! Mends outlines that touch or cross themselves a little.

use geo::{Area, BooleanOps};

use super::surface::{largest_part, ring_surface, to_points};
use super::{Ring, clean_ring};
use crate::geometry::Point;

/// The share that the largest part of an outline that crosses itself must have: the rest is a loop that drawing left behind.
const MAIN_SHARE: f64 = 0.9;

/// The outer border and the holes of a ring that touches or crosses itself: one that comes back to a corner after it went around a
/// hole, or that has a small loop. None of a bow tie, whose halves are equal. Its edges do not know where they come from.
pub(in crate::plan) fn untangled(points: &[Point]) -> Option<(Ring, Vec<Vec<Point>>)> {
    let tangled = geo::MultiPolygon::new(vec![ring_surface(points)]);
    let (main, rest) = largest_part(tangled.union(&geo::MultiPolygon::new(Vec::new())))?;
    let area = main.unsigned_area();
    if area < MAIN_SHARE * (area + rest) {
        return None;
    }
    let mut ring = clean_ring(&to_points(main.exterior()), &[]).ok()?;
    ring.edges.fill(None);
    Some((ring, main.interiors().iter().map(to_points).collect()))
}
