//! The light of lamps.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The light of a lamp, the same in all directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// Luminous flux in lumens.
    pub lumens: f64,
    /// Colour temperature in kelvins.
    pub kelvin: f64,
    /// Where it comes out of the lamp's box.
    pub from: LightSide,
}

/// The side of a lamp's box before whose middle its light begins: outside, for a light inside of a closed mesh is
/// dark.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum LightSide {
    /// Under it, as from ceilings.
    #[default]
    Below,
    /// Over it, as out of a shade.
    Above,
    /// Before it, as from walls.
    Front,
}

impl LightSide {
    /// The word in configuration.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Below => "below",
            Self::Above => "above",
            Self::Front => "front",
        }
    }
}
