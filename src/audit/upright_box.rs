//! The box around a body or a region.

use glam::DVec3;

/// An axis-parallel box: plan metres, elevation above the room's floor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct UprightBox {
    /// Lowest corner.
    pub(crate) low: DVec3,
    /// Highest corner.
    pub(crate) high: DVec3,
}

impl UprightBox {
    /// Contains nothing; the neutral value of [`UprightBox::union`].
    pub(crate) const EMPTY: Self =
        Self { low: DVec3::splat(f64::INFINITY), high: DVec3::splat(f64::NEG_INFINITY) };

    /// The smallest box around both.
    pub(crate) fn union(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// Whether it contains nothing.
    pub(crate) fn is_empty(&self) -> bool {
        !self.low.cmple(self.high).all()
    }
}
