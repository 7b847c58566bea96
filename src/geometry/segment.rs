//! Segments and the edges of rings.

use super::Point;

/// The edges of a ring of corners that have a length; the inside of a counter-clockwise one is on the left.
pub fn edges(ring: &[Point]) -> impl Iterator<Item = (Point, Point)> + '_ {
    let all = (0..ring.len()).map(|i| (ring[i], ring[(i + 1) % ring.len()]));
    all.filter(|(start, end)| start != end)
}

/// The point of a segment nearest to `point`.
#[must_use]
pub fn nearest_on_segment(point: Point, (start, end): (Point, Point)) -> Point {
    let along = end - start;
    let length_squared = along.length_squared();
    if length_squared == 0.0 {
        return start;
    }
    start + along * ((point - start).dot(along) / length_squared).clamp(0.0, 1.0)
}

/// Metres from a point to a convex ring of corners, counter-clockwise; zero inside.
#[must_use]
pub fn distance_to_convex(ring: &[Point], point: Point) -> f64 {
    if edges(ring).all(|(start, end)| (end - start).perp_dot(point - start) >= 0.0) {
        return 0.0;
    }
    let to_edge = edges(ring).map(|edge| point.distance_squared(nearest_on_segment(point, edge)));
    to_edge.fold(f64::INFINITY, f64::min).sqrt()
}
