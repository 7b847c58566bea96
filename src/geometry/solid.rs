//! Upright prisms: the solid parts of furniture, and regions that must stay free.

use super::convex::CLOSE;
use super::{Bounds, Convex, Point};

/// An upright convex prism: a footprint between two heights.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solid {
    /// The footprint in the level's plan frame.
    pub base: Convex,
    /// Metres of the underside above the room's floor.
    pub low: f64,
    /// Metres of the top above the room's floor.
    pub high: f64,
    /// The box around the footprint.
    pub bounds: Bounds,
}

impl Solid {
    /// A prism over a footprint, `low <= high`.
    #[must_use]
    pub fn new(base: Convex, low: f64, high: f64) -> Self {
        Self { base, low, high, bounds: base.bounds() }
    }

    /// The corners of the footprint, counter-clockwise.
    #[must_use]
    pub fn footprint(&self) -> &[Point] {
        self.base.corners()
    }

    /// Whether two prisms intersect by more than `tolerance` metres in every direction.
    #[must_use]
    pub fn overlaps(&self, other: &Self, tolerance: f64) -> bool {
        self.high.min(other.high) - self.low.max(other.low) > tolerance
            && self.bounds.overlaps(other.bounds, tolerance)
            && (self.fill_boxes_that_overlap(other, tolerance) || self.base.overlaps(&other.base, tolerance))
    }

    /// Whether both footprints are their boxes, as those of most furniture are, and these overlap by clearly more than
    /// `tolerance` metres: half of the tests that boxes do not decide otherwise, without a projection.
    fn fill_boxes_that_overlap(&self, other: &Self, tolerance: f64) -> bool {
        self.base.fills_its_bounds()
            && other.base.fills_its_bounds()
            && self.bounds.overlaps(other.bounds, tolerance + CLOSE)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_that_decide_answer_as_the_exact_test_does() {
        let mut met = [0, 0];
        for number in 0..4000 {
            let at = |step: f64| (f64::from(number) * step).rem_euclid(1.0);
            // Half of them along the axes, turned by whole quarters that are not quite that.
            let quarters = f64::from(number % 8) * core::f64::consts::FRAC_PI_2;
            let solid = |place: Point, half: Point, angle: f64| {
                Solid::new(Convex::rectangle(place, half, crate::geometry::direction(angle)), 0.0, 1.0)
            };
            let turn = if number % 2 == 0 { at(0.302_776) } else { 0.0 };
            let one = solid(Point::new(at(0.618_034), at(0.414_214)), Point::new(0.4, 0.2), quarters + turn);
            let other = solid(Point::splat(0.5), Point::new(at(0.732_051), 0.1) / 2.0, -quarters);
            for tolerance in [-0.01, 0.0, 5e-4, 0.01] {
                let exact = one.base.overlaps(&other.base, tolerance);
                assert_eq!(one.overlaps(&other, tolerance), exact, "{number} {tolerance}");
                met[usize::from(exact)] += 1;
            }
        }
        assert!(met[0] > 1_000 && met[1] > 1_000, "{met:?}");
        let flat = Solid::new(Convex::rectangle(Point::ZERO, Point::new(0.5, 0.0), Point::X), 0.0, 1.0);
        assert!(!flat.overlaps(&flat, 0.0), "what has no width overlaps nothing");
    }
}
