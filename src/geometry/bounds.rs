//! Axis-parallel boxes of the plane.

use super::Point;

/// An axis-parallel box of the plan, in metres; also that of a point or of a line along an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The south-western corner.
    pub low: Point,
    /// The north-eastern corner.
    pub high: Point,
}

impl Bounds {
    /// Contains nothing; the neutral value of [`Bounds::union`].
    pub const EMPTY: Self = Self { low: Point::INFINITY, high: Point::NEG_INFINITY };

    /// From the lowest corner to the highest.
    #[must_use]
    pub fn new(low: Point, high: Point) -> Self {
        Self { low, high }
    }

    /// The smallest box around points; [`Bounds::EMPTY`] around none.
    #[must_use]
    pub fn around(points: impl IntoIterator<Item = Point>) -> Self {
        points.into_iter().fold(Self::EMPTY, |bounds, point| bounds.union(Self::new(point, point)))
    }

    /// The square that reaches so many metres to each side of a point.
    #[must_use]
    pub fn around_point(middle: Point, reach: f64) -> Self {
        Self { low: middle - reach, high: middle + reach }
    }

    /// The smallest box around both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// Larger by so many metres on each side.
    #[must_use]
    pub fn inflated(self, margin: f64) -> Self {
        Self { low: self.low - margin, high: self.high + margin }
    }

    /// At another place.
    #[must_use]
    pub fn moved(self, by: Point) -> Self {
        Self { low: self.low + by, high: self.high + by }
    }

    /// Width and depth.
    #[must_use]
    pub fn size(self) -> Point {
        self.high - self.low
    }

    /// The middle.
    #[must_use]
    pub fn center(self) -> Point {
        (self.low + self.high) / 2.0
    }

    /// The corners, counter-clockwise from the lowest.
    #[must_use]
    pub fn corners(self) -> [Point; 4] {
        let Self { low, high } = self;
        [low, Point::new(high.x, low.y), high, Point::new(low.x, high.y)]
    }

    /// Whether a point lies inside or on the border.
    #[must_use]
    pub fn contains(self, point: Point) -> bool {
        self.low.cmple(point).all() && point.cmple(self.high).all()
    }

    /// Whether two boxes have a point in common.
    #[must_use]
    pub fn touches(self, other: Self) -> bool {
        self.low.cmple(other.high).all() && other.low.cmple(self.high).all()
    }

    /// Metres to another box; zero where they touch.
    #[must_use]
    pub fn gap(self, other: Self) -> f64 {
        (self.low - other.high).max(other.low - self.high).max(Point::ZERO).length()
    }

    /// Whether two boxes overlap by more than `tolerance` metres.
    #[must_use]
    pub fn overlaps(self, other: Self, tolerance: f64) -> bool {
        (self.high.min(other.high) - self.low.max(other.low)).cmpgt(Point::splat(tolerance)).all()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_box_around_points_has_them_at_its_border_and_that_around_none_overlaps_nothing() {
        let points = [Point::new(2.0, -1.0), Point::new(-3.0, 4.0), Point::ZERO];
        let bounds = Bounds::around(points);
        assert_eq!(bounds, Bounds::new(Point::new(-3.0, -1.0), Point::new(2.0, 4.0)));
        assert!(points.into_iter().all(|point| bounds.contains(point)));
        assert!(!bounds.contains(Point::new(2.0, 4.001)));
        assert_eq!((bounds.size(), bounds.center()), (Point::new(5.0, 5.0), Point::new(-0.5, 1.5)));
        assert!(!Bounds::around([]).overlaps(bounds, 0.0));
    }

    #[test]
    fn boxes_overlap_by_more_than_the_tolerance_along_both_axes() {
        let at = |x: f64, y: f64| Bounds::new(Point::new(x, y), Point::new(x + 1.0, y + 1.0));
        assert!(at(0.0, 0.0).overlaps(at(0.9, 0.5), 0.05));
        assert!(!at(0.0, 0.0).overlaps(at(0.9, 0.5), 0.15));
        assert!(!at(0.0, 0.0).overlaps(at(1.0, 0.0), 0.0), "contact is no overlap");
        assert!(at(0.0, 0.0).inflated(0.1).overlaps(at(1.0, 0.0), 0.0));
        assert!(!at(0.0, 0.0).overlaps(at(0.5, 2.0), 0.0));
    }
}
