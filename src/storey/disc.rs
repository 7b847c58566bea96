//! The largest disc inside a ring: how wide a room is where it is widest.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use crate::geometry::{Point, Polygon, edges, ring_contains};

use super::ring::bounds;

/// Metres by which the answer may be too small.
const TOLERANCE: f64 = 0.02;
/// Squares that are looked into at most.
const MOST_SQUARES: usize = 600;

/// A square that may hold the middle of the disc (V. Agafonkin's search for the pole of inaccessibility).
struct Square {
    middle: Point,
    half: f64,
    /// Metres from the middle to the border, below zero outside.
    distance: f64,
    /// Metres that no point of the square exceeds.
    most: f64,
}

impl PartialEq for Square {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Square {}

impl PartialOrd for Square {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Square {
    fn cmp(&self, other: &Self) -> Ordering {
        let by_place =
            || other.middle.x.total_cmp(&self.middle.x).then(other.middle.y.total_cmp(&self.middle.y));
        self.most.total_cmp(&other.most).then_with(by_place)
    }
}

/// Metres from a point to the border of rings, below zero outside; the first ring is the outline, the others are holes.
fn distance(rings: &[&[Point]], point: Point) -> f64 {
    let gaps = rings.iter().flat_map(|ring| edges(ring)).map(|edge| edge.distance_squared(point));
    let least = gaps.fold(f64::INFINITY, f64::min).sqrt();
    // Inside the outline and outside of all holes: within an odd number of rings.
    let around = rings.iter().filter(|ring| ring_contains(ring, point)).count();
    if around % 2 == 1 { least } else { -least }
}

/// The diameter in metres of the largest disc inside, and its middle; the search ends early once `enough` is reached.
pub(super) fn largest_disc(rings: &[&[Point]], enough: f64) -> (f64, Point) {
    let Some(outline) = rings.first().filter(|ring| ring.len() > 2) else { return (0.0, Point::ZERO) };
    let extent = bounds(outline);
    let size = extent.size();
    let half = (size.min_element() / 2.0).max(TOLERANCE);
    let square = |middle: Point, half: f64| {
        let distance = distance(rings, middle);
        Square { middle, half, distance, most: distance + half * std::f64::consts::SQRT_2 }
    };
    let mut queue = BinaryHeap::new();
    let mut best = (distance(rings, extent.center()), extent.center());
    let counts = (size / (2.0 * half)).ceil().max(Point::ONE).min(Point::splat(16.0));
    let step = size / counts;
    for column in 0..counts.x as u32 {
        for row in 0..counts.y as u32 {
            let middle = extent.low + step * (Point::new(f64::from(column), f64::from(row)) + 0.5);
            queue.push(square(middle, step.max_element() / 2.0));
        }
    }
    for _ in 0..MOST_SQUARES {
        let Some(next) = queue.pop() else { break };
        if next.distance > best.0 {
            best = (next.distance, next.middle);
        }
        if next.most - best.0 < TOLERANCE / 2.0 || 2.0 * best.0 >= enough {
            break;
        }
        let half = next.half / 2.0;
        for corner in [Point::new(-1., -1.), Point::new(1., -1.), Point::new(-1., 1.), Point::new(1., 1.)] {
            queue.push(square(next.middle + corner * half, half));
        }
    }
    (2.0 * best.0.max(0.0), best.1)
}

/// Whether a disc of this diameter fits, to a centimetre.
pub(super) fn is_as_wide_as(ring: &[Point], width: f64) -> bool {
    // Most rooms are rectangles, in whose middle it is; any place will do.
    let least = width - 0.01;
    2.0 * distance(&[ring], bounds(ring).center()) >= least || largest_disc(&[ring], width).0 >= least
}

/// A point well inside a ring.
pub(super) fn inner_point(ring: &[Point]) -> Point {
    largest_disc(&[ring], 0.6).1
}

/// Whether a ring is a valid polygon.
pub(super) fn is_simple(ring: &[Point]) -> bool {
    Polygon::new(ring).is_ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_largest_disc_of_an_l_is_in_its_corner() {
        let corners = [(0., 0.), (6., 0.), (6., 2.), (2., 2.), (2., 8.), (0., 8.)].map(Point::from);
        let (width, middle) = largest_disc(&[&corners], f64::INFINITY);
        assert!((width - 2.343).abs() < 0.03, "{width}");
        assert!(middle.distance(Point::splat(1.17)) < 0.05);
        assert!(is_as_wide_as(&corners, 2.3) && !is_as_wide_as(&corners, 2.4));
    }
}
