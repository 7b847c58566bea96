//! Named materials of a style.

use std::collections::BTreeMap;

use crate::mesh::Material;
use crate::recipes::Slot;

/// Materials by slot (`wood`, `fabric`, `metal`): recipes name slots, the palette says what they are.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Palette {
    /// The word used in styles.
    pub id: String,
    /// Every slot.
    pub materials: BTreeMap<Slot, Material>,
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
