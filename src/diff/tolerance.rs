//! The largest differences that are ignored, and the rounding of figures.

use schemars::JsonSchema;
use serde::Serialize;

/// The largest moves and turns that are not reported.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Tolerance {
    /// Metres up to which an object counts as neither moved nor resized. Less finds what single precision blurs, more
    /// overlooks what people see.
    pub metres: f64,
    /// Degrees up to which an object counts as not turned.
    pub degrees: f64,
}

impl Default for Tolerance {
    fn default() -> Self {
        Self { metres: 1e-4, degrees: 0.01 }
    }
}

impl Tolerance {
    /// Whether a length is a difference.
    pub(super) fn is_far(&self, metres: f64) -> bool {
        metres > self.metres
    }

    /// Whether an angle is a difference.
    pub(super) fn is_turn(&self, degrees: f64) -> bool {
        degrees > self.degrees
    }
}

/// Metres to the tenth of a millimetre, without a negative zero.
pub(super) fn round_metres(value: f64) -> f64 {
    (value * 1e4).round() / 1e4 + 0.0
}

/// Degrees to the hundredth, without a negative zero.
pub(super) fn round_degrees(value: f64) -> f64 {
    (value * 1e2).round() / 1e2 + 0.0
}
