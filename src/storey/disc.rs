//! The largest disc inside a ring: how wide a room is where it is widest.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use crate::geometry::{Point, Polygon, Segment, edges};

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

/// The edges of an outline and of its holes, in the form in which many points are looked at.
struct Border(Vec<Edge>);

struct Edge {
    start: Point,
    vector: Point,
    length_squared: f64,
}

impl Border {
    fn of(rings: &[&[Point]]) -> Self {
        let edge = |edge: Segment| Edge {
            start: edge.start,
            vector: edge.vector(),
            length_squared: edge.vector().length_squared(),
        };
        Self(rings.iter().flat_map(|ring| edges(ring)).map(edge).collect())
    }

    /// Metres from a point to the border, below zero outside.
    fn distance(&self, point: Point) -> f64 {
        let mut least = f64::INFINITY;
        // Inside the outline and outside of all holes: a ray to the east meets an odd number of edges.
        let mut is_inside = false;
        for &Edge { start, vector, length_squared } in &self.0 {
            let to_point = point - start;
            let share = (to_point.dot(vector) / length_squared).clamp(0.0, 1.0);
            let gap = (to_point - vector * share).length_squared();
            // Not `min`, which looks for what is no number.
            if gap < least {
                least = gap;
            }
            if (to_point.y < 0.0) != (to_point.y < vector.y) {
                is_inside ^= to_point.x < to_point.y / vector.y * vector.x;
            }
        }
        if is_inside { least.sqrt() } else { -least.sqrt() }
    }
}

/// The diameter in metres of the largest disc inside, and its middle; the search ends early once `enough` is reached.
pub(super) fn largest_disc(rings: &[&[Point]], enough: f64) -> (f64, Point) {
    search(rings, enough, 0.0)
}

/// As [`largest_disc`]; the answer is of no use where it is below a diameter.
fn search(rings: &[&[Point]], enough: f64, needed: f64) -> (f64, Point) {
    let Some(outline) = rings.first().filter(|ring| ring.len() > 2) else { return (0.0, Point::ZERO) };
    let border = Border::of(rings);
    let extent = bounds(outline);
    let size = extent.size();
    let half = (size.min_element() / 2.0).max(TOLERANCE);
    let square = |middle: Point, half: f64| {
        let distance = border.distance(middle);
        Square { middle, half, distance, most: distance + half * std::f64::consts::SQRT_2 }
    };
    let mut queue = BinaryHeap::new();
    let mut best = (border.distance(extent.center()), extent.center());
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
        let is_known = 2.0 * best.0 >= enough || 2.0 * next.most < needed;
        if is_known || next.most - best.0 < TOLERANCE / 2.0 {
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
    let least = width - 0.01;
    let extent = bounds(ring);
    // Most rooms are rectangles, in whose middle it is; any place will do.
    let is_at_middle = || 2.0 * Border::of(&[ring]).distance(extent.center()) >= least;
    extent.size().min_element() >= least && (is_at_middle() || search(&[ring], width, least).0 >= least)
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
