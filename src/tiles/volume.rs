//! Boxes around tiles, and the matrices that place them.

use glam::{DMat4, DVec3};
use serde_json::{Value, json};

use crate::scene::LevelBounds;

/// A box along the axes of a frame, in metres: never empty.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Volume {
    pub(super) low: DVec3,
    pub(super) high: DVec3,
}

impl Volume {
    /// The box of a level, in the frame of its building.
    pub(super) fn of(bounds: &LevelBounds) -> Self {
        Self { low: DVec3::from(bounds.low), high: DVec3::from(bounds.high) }
    }

    /// The box around both.
    pub(super) fn joined(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// The box around the corners of this one, placed by a matrix.
    pub(super) fn placed(self, matrix: &DMat4) -> Self {
        let corner = |index: usize| {
            let pick = |axis: usize| if index >> axis & 1 == 0 { self.low[axis] } else { self.high[axis] };
            matrix.transform_point3(DVec3::new(pick(0), pick(1), pick(2)))
        };
        let first = Self { low: corner(0), high: corner(0) };
        (1..8).map(corner).fold(first, |found, corner| found.joined(Self { low: corner, high: corner }))
    }

    /// The same, moved.
    pub(super) fn moved(self, by: DVec3) -> Self {
        Self { low: self.low + by, high: self.high + by }
    }

    /// The same with ends at whole millimetres, outside of it: then no box sticks out of the one around it by a rounding error.
    pub(super) fn rounded(self) -> Self {
        let parts = 1000.0;
        Self { low: (self.low * parts).floor() / parts, high: (self.high * parts).ceil() / parts }
    }

    /// The middle, seen from above.
    pub(super) fn middle(self) -> [f64; 2] {
        let middle = (self.low + self.high) / 2.0;
        [middle.x, middle.y]
    }

    /// `boundingVolume`: the middle, then half of each side.
    pub(super) fn json(self) -> Value {
        let tidy = |number: f64| (number * 1e4).round() / 1e4 + 0.0;
        let middle = ((self.low + self.high) / 2.0).to_array().map(tidy);
        let [x, y, z] = ((self.high - self.low) / 2.0).to_array().map(tidy);
        json!({"box": [middle[0], middle[1], middle[2], x, 0, 0, 0, y, 0, 0, 0, z]})
    }
}

/// A matrix as `transform`: sixteen numbers, column by column.
pub(super) fn transform(matrix: &DMat4) -> Value {
    json!(matrix.to_cols_array().map(|number| number + 0.0))
}
