//! The motion of a prototype or a building: mirrored, turned, moved.

use crate::geometry::Point;

/// A motion of the plane; angles that are multiples of 90 degrees are exact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Motion {
    /// Whether x becomes −x first.
    pub(crate) is_mirrored: bool,
    /// Cosine and sine of the turn that follows.
    turn: Point,
    /// The move that comes last.
    offset: Point,
}

impl Motion {
    /// Leaves everything where it is.
    pub(crate) const NONE: Self = Self { is_mirrored: false, turn: Point::X, offset: Point::ZERO };

    /// Mirrors, then turns by degrees counter-clockwise, then moves.
    pub(crate) fn new(is_mirrored: bool, degrees: f64, offset: Point) -> Self {
        Self { is_mirrored, turn: direction(degrees), offset }
    }

    /// Where a point goes.
    pub(crate) fn apply(&self, point: Point) -> Point {
        self.turn_only(point) + self.offset
    }

    /// Where a direction goes.
    pub(crate) fn turn_only(&self, vector: Point) -> Point {
        let mirrored = if self.is_mirrored { Point::new(-vector.x, vector.y) } else { vector };
        self.turn.rotate(mirrored)
    }

    /// The same motion, moved further.
    pub(crate) fn moved(self, by: Point) -> Self {
        Self { offset: self.offset + by, ..self }
    }
}

/// Cosine and sine of an angle in degrees.
fn direction(degrees: f64) -> Point {
    let quarters = degrees.rem_euclid(360.0) / 90.0;
    let quarter = [Point::X, Point::Y, Point::NEG_X, Point::NEG_Y].into_iter().enumerate();
    let exact = quarter.filter(|(index, _)| *index as f64 == quarters).map(|(_, direction)| direction).next();
    exact.unwrap_or_else(|| {
        let (sine, cosine) = libm::sincos(degrees.to_radians());
        Point::new(cosine, sine)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarter_turns_are_exact() {
        let point = Point::new(1.1, 0.3);
        for (degrees, expected) in
            [(90.0, Point::new(-0.3, 1.1)), (-90.0, Point::new(0.3, -1.1)), (180.0, -point), (720.0, point)]
        {
            assert_eq!(Motion::new(false, degrees, Point::ZERO).apply(point), expected, "{degrees}");
        }
    }

    #[test]
    fn mirrored_first_then_turned_then_moved() {
        let motion = Motion::new(true, 90.0, Point::new(10.0, 0.0)).moved(Point::new(0.0, 5.0));
        assert_eq!(motion.apply(Point::new(2.0, 1.0)), Point::new(9.0, 3.0));
        assert_eq!(motion.turn_only(Point::X), Point::NEG_Y);
    }

    #[test]
    fn other_angles_turn_too() {
        let turned = Motion::new(false, 45.0, Point::ZERO).apply(Point::X);
        assert!((turned - Point::splat(0.5_f64.sqrt())).length() < 1e-15);
    }
}
