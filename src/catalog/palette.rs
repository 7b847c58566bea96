//! Named materials of a style.

use std::collections::BTreeMap;

use crate::recipes::Slot;

/// Materials by slot (`wood`, `fabric`, `metal`): recipes name slots, the palette says what they are.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Palette {
    /// The word used in styles.
    pub id: String,
    /// Every slot.
    pub materials: BTreeMap<Slot, Material>,
}

/// A glTF metallic-roughness material.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Linear red, green, blue and opacity, each 0 to 1.
    pub base_color: [f32; 4],
    /// 0 for everything but bare metal.
    pub metallic: f32,
    /// 0 a mirror, 1 chalk.
    pub roughness: f32,
    /// Linear light given off, each 0 to 1.
    pub emissive: [f32; 3],
    /// Multiplies the light given off where lamps are lit (`KHR_materials_emissive_strength`), from 0 on.
    pub emissive_strength: f32,
    /// Share of light that passes (`KHR_materials_transmission`); 0 for what is not glass.
    pub transmission: f32,
    /// The surface whose textures lie on it, one of [`SURFACES`].
    pub texture: Option<&'static str>,
    /// Further base colours, linear; an object of the palette has one of all, by seed.
    pub tints: Vec<[f32; 4]>,
}

/// All surfaces that a slot can have, sorted: the words of `texture:`.
pub const SURFACES: [&str; 13] = [
    "brushed",
    "carpet",
    "concrete",
    "fabric",
    "leather",
    "linen",
    "linoleum",
    "parquet",
    "plaster",
    "stone",
    "tile",
    "tile_wall",
    "wood",
];
