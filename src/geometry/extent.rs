//! Boxes that stand alone: how large they are, and their sides.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Metres: x width, y depth, z height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Size {
    /// Left to right.
    pub width: f64,
    /// Front to back.
    pub depth: f64,
    /// Underside to top.
    pub height: f64,
}

/// One of the six sides of a box.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Side {
    /// Where one uses it from.
    Front,
    /// Opposite the front.
    Back,
    /// Left of the person before the front.
    Left,
    /// Right of the person before the front.
    Right,
    /// The top.
    Above,
    /// The underside.
    Below,
}

impl Side {
    /// All sides, in the order of [`Side::index`].
    pub const ALL: [Self; 6] = [Self::Front, Self::Back, Self::Left, Self::Right, Self::Above, Self::Below];

    /// Position in [`Side::ALL`].
    #[must_use]
    pub fn index(self) -> usize {
        self as usize
    }

    /// The side that touches this one: below touches above.
    #[must_use]
    pub fn opposite(self) -> Self {
        match self {
            Self::Front => Self::Back,
            Self::Back => Self::Front,
            Self::Left => Self::Right,
            Self::Right => Self::Left,
            Self::Above => Self::Below,
            Self::Below => Self::Above,
        }
    }

    /// The word in configuration and output.
    #[must_use]
    pub fn name(self) -> &'static str {
        ["front", "back", "left", "right", "above", "below"][self.index()]
    }
}
