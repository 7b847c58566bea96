//! Lengths in whole hundredths of a millimetre, so that equal shapes compare equal.

use crate::geometry::Point;

/// A length in hundredths of a millimetre.
///
/// Shapes of the shell are described in ticks before they are built: two walls that differ by rounding
/// errors only get one mesh, and corners that two faces share are the same bits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Ticks(pub i32);

/// Ticks in a metre; a coordinate may reach 21 km from the shape's own origin.
const PER_METRE: f64 = 1e5;

impl Ticks {
    /// The nearest tick; lengths out of range stop at its ends.
    pub(crate) fn of(metres: f64) -> Self {
        Self((metres * PER_METRE).round() as i32)
    }

    /// In metres.
    pub(crate) fn metres(self) -> f64 {
        f64::from(self.0) / PER_METRE
    }

    /// In metres, for a mesh.
    pub(crate) fn narrow(self) -> f32 {
        self.metres() as f32
    }
}

impl std::ops::Add for Ticks {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0.saturating_add(other.0))
    }
}

impl std::ops::Sub for Ticks {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(self.0.saturating_sub(other.0))
    }
}

impl std::ops::Neg for Ticks {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.saturating_neg())
    }
}

/// A plan point in ticks from an anchor.
pub(crate) fn point_in_ticks(point: Point, anchor: Point) -> [Ticks; 2] {
    [Ticks::of(point.x - anchor.x), Ticks::of(point.y - anchor.y)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_errors_vanish() {
        assert_eq!(Ticks::of(0.1 + 0.2), Ticks::of(0.3));
        assert_eq!(Ticks::of(4.0).metres(), 4.0);
        assert_eq!(Ticks::of(f64::INFINITY).0, i32::MAX);
    }
}
