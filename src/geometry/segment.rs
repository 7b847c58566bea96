//! Segments, straight lines with two sides, and the edges of rings.

use super::{Bounds, Point};

/// A straight piece of a wall, of an outline or of a way, from one point to another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// Where it begins.
    pub start: Point,
    /// Where it ends.
    pub end: Point,
}

impl Segment {
    /// From one point to another.
    #[must_use]
    pub fn new(start: Point, end: Point) -> Self {
        Self { start, end }
    }

    /// From start to end, as long as the segment.
    #[must_use]
    pub fn vector(self) -> Point {
        self.end - self.start
    }

    /// Metres.
    #[must_use]
    pub fn length(self) -> f64 {
        self.vector().length()
    }

    /// Unit vector from start to end; zero if they are one point.
    #[must_use]
    pub fn direction(self) -> Point {
        self.vector().normalize_or_zero()
    }

    /// Unit vector to the left; zero if start and end are one point.
    #[must_use]
    pub fn normal(self) -> Point {
        self.direction().perp()
    }

    /// The point at a share of its length: the start at 0, the end at 1.
    #[must_use]
    pub fn at(self, share: f64) -> Point {
        self.start.lerp(self.end, share)
    }

    /// The point so many metres after its start.
    #[must_use]
    pub fn after(self, metres: f64) -> Point {
        self.start + self.direction() * metres
    }

    /// The point halfway.
    #[must_use]
    pub fn middle(self) -> Point {
        self.start.midpoint(self.end)
    }

    /// From the end to the start.
    #[must_use]
    pub fn reversed(self) -> Self {
        Self { start: self.end, end: self.start }
    }

    /// At another place.
    #[must_use]
    pub fn moved(self, by: Point) -> Self {
        Self { start: self.start + by, end: self.end + by }
    }

    /// Metres that a point lies to the left of its straight line, times its length; below zero to the right.
    #[must_use]
    pub fn side(self, point: Point) -> f64 {
        self.vector().perp_dot(point - self.start)
    }

    /// Whether a ray from a point towards east meets it; its higher end does not count, so that rings are crossed once at a corner.
    pub(super) fn is_east_of(self, point: Point) -> bool {
        let Self { start: a, end: b } = self;
        (a.y > point.y) != (b.y > point.y) && point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)
    }

    /// Whether it and another cross each other: a mere touch is no crossing.
    #[must_use]
    pub fn crosses(self, other: Self) -> bool {
        let parts = |line: Self, of: Self| line.side(of.start) * line.side(of.end) < 0.0;
        parts(self, other) && parts(other, self)
    }

    /// Its point nearest to another.
    #[must_use]
    pub fn nearest(self, point: Point) -> Point {
        let along = self.vector();
        let length_squared = along.length_squared();
        if length_squared == 0.0 {
            return self.start;
        }
        self.start + along * ((point - self.start).dot(along) / length_squared).clamp(0.0, 1.0)
    }

    /// Metres to a point.
    #[must_use]
    pub fn distance(self, point: Point) -> f64 {
        point.distance(self.nearest(point))
    }

    /// Square metres of the square over the distance to a point.
    #[must_use]
    pub fn distance_squared(self, point: Point) -> f64 {
        point.distance_squared(self.nearest(point))
    }

    /// The axis-parallel box around it.
    #[must_use]
    pub fn bounds(self) -> Bounds {
        Bounds::new(self.start.min(self.end), self.start.max(self.end))
    }
}

/// A straight line without ends that has a direction, and so a left and a right.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// A point on it.
    pub point: Point,
    /// Unit vector.
    pub direction: Point,
}

impl Line {
    /// Metres that a point lies to the right; below zero to the left.
    #[must_use]
    pub fn right_of(self, point: Point) -> f64 {
        -self.direction.perp_dot(point - self.point)
    }

    /// The same line the other way round: left is right.
    #[must_use]
    pub fn reversed(self) -> Self {
        Self { direction: -self.direction, ..self }
    }
}

/// The edges of a ring of corners that have a length; the inside of a counter-clockwise one is on the left.
pub fn edges(ring: &[Point]) -> impl Iterator<Item = Segment> + '_ {
    // Not by the remainder of a division, which would take longer than most of what is asked of an edge.
    let next = move |i: usize| if i + 1 == ring.len() { 0 } else { i + 1 };
    let all = (0..ring.len()).map(move |i| Segment::new(ring[i], ring[next(i)]));
    all.filter(|edge| edge.start != edge.end)
}

/// Metres from a point to a convex ring of corners, counter-clockwise; zero inside.
#[must_use]
pub fn distance_to_convex(ring: &[Point], point: Point) -> f64 {
    if edges(ring).all(|edge| edge.side(point) >= 0.0) {
        return 0.0;
    }
    let to_edge = edges(ring).map(|edge| edge.distance_squared(point));
    to_edge.fold(f64::INFINITY, f64::min).sqrt()
}

/// Metres between two convex rings of corners, counter-clockwise; zero where a corner of one is in the other.
#[must_use]
pub fn distance_of_convex(ring: &[Point], other: &[Point]) -> f64 {
    let least = |ring: &[Point], corners: &[Point]| {
        corners.iter().map(|&corner| distance_to_convex(ring, corner)).fold(f64::INFINITY, f64::min)
    };
    // The nearest two points of polygons that are apart include a corner of one of them.
    least(ring, other).min(least(other, ring))
}

/// Lengths of a direction along a ray to a segment; `None` where it does not meet it, or is parallel.
pub(crate) fn ray_hit(origin: Point, direction: Point, segment: Segment) -> Option<f64> {
    let (edge, to_start) = (segment.vector(), segment.start - origin);
    let cross = direction.perp_dot(edge);
    if cross == 0.0 {
        return None;
    }
    let distance = to_start.perp_dot(edge) / cross;
    let share = to_start.perp_dot(direction) / cross;
    ((0.0..=1.0).contains(&share) && distance >= 0.0).then_some(distance)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_distance_of_two_rings_is_that_of_their_nearest_points() {
        let square = |x: f64, y: f64| {
            [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(a, b)| Point::new(a + x, b + y))
        };
        assert_eq!(distance_of_convex(&square(0.0, 0.0), &square(3.0, 0.25)), 2.0);
        assert_eq!(distance_of_convex(&square(0.0, 0.0), &square(4.0, 5.0)), 5.0);
        assert_eq!(distance_of_convex(&square(0.0, 0.0), &square(0.5, 0.5)), 0.0);
    }

    #[test]
    fn the_nearest_point_of_a_segment_is_on_it_or_one_of_its_ends() {
        let segment = Segment::new(Point::new(1.0, 1.0), Point::new(5.0, 1.0));
        assert_eq!(segment.nearest(Point::new(2.5, 4.0)), Point::new(2.5, 1.0));
        assert_eq!(segment.nearest(Point::new(9.0, 4.0)), segment.end);
        assert_eq!((segment.distance(Point::new(9.0, 4.0)), segment.length()), (5.0, 4.0));
        let spot = Segment::new(Point::ONE, Point::ONE);
        assert_eq!((spot.nearest(Point::ZERO), spot.direction()), (Point::ONE, Point::ZERO));
    }

    #[test]
    fn left_of_a_segment_and_of_a_line_is_left_of_who_looks_along_it() {
        let north = Segment::new(Point::ZERO, Point::new(0.0, 2.0));
        assert_eq!((north.side(Point::new(-3.0, 1.0)), north.normal()), (6.0, Point::NEG_X));
        assert_eq!(
            (north.reversed().side(Point::new(-3.0, 1.0)), north.at(0.25)),
            (-6.0, Point::new(0.0, 0.5))
        );
        let line = Line { point: Point::ZERO, direction: north.direction() };
        assert_eq!((line.right_of(Point::new(-3.0, 7.0)), line.right_of(Point::new(3.0, 7.0))), (-3.0, 3.0));
    }
}
