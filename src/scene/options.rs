//! Options of a scene: lights, parts, door angle, palette variants.

use serde::Serialize;

/// The options of a scene beyond rooms and furniture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct SceneOptions {
    /// How lamps are lit; default their shades shine.
    pub lights: Lights,
    /// How many meshes there are; default few.
    pub parts: Parts,
    /// Degrees by which leaves on hinges stand open, but no further than the plan lets them; default as far as that.
    pub door_angle: Option<u16>,
    /// Whether every palette of the catalogue is a material variant of the level; default no.
    pub has_variants: bool,
}

/// How lamps are lit.
///
/// Viewers light a file by surroundings of their own and add its lights to them. They agree neither on the exposure that
/// candelas are meant for nor on how many lights they can draw: with the 14 of a house some draw white, some nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub enum Lights {
    /// Shades shine, and no lamp is a light of the file; its node says its lumens and kelvins.
    #[default]
    Shining,
    /// Each lamp is a light in candelas as well (`KHR_lights_punctual`).
    Physical,
    /// Shades are barely brighter than paper, and lamps have no nodes for their light.
    Off,
}

/// How many meshes a level has. Viewers draw each primitive of each by itself, which is what large levels cost them most.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub enum Parts {
    /// Walls with all that is fixed to them are one mesh a room, frames with sills and thresholds one an opening, and parts of
    /// a plain colour one primitive a piece of furniture.
    #[default]
    Merged,
    /// Every part has its own mesh, every slot of the palette its own material.
    Separate,
}
