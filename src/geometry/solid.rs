//! Upright prisms: the solid parts of furniture, and regions that must stay free.

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
            && self.base.overlaps(&other.base, tolerance)
    }
}
