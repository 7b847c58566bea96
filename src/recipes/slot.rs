//! Material slots: what a part is made of, before a palette says what that looks like.

use std::fmt;

use serde::{Deserialize, Serialize};

/// The enum, the list of all slots and their words, from one list.
macro_rules! slots {
    ($($slot:ident = $word:literal,)*) => {
        /// The material of a part, as far as recipes and the shells of rooms know: palettes say what each slot looks like.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
        pub enum Slot {
            $(#[doc = concat!("`", $word, "`.")] $slot,)*
        }

        impl Slot {
            /// All slots, in the order of their squares in the images of swatches.
            pub const ALL: &[Self] = &[$(Self::$slot,)*];

            /// The word in palettes and finishes.
            #[must_use]
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$slot => $word,)*
                }
            }
        }
    };
}

slots! {
    Wood = "wood",
    WoodDark = "wood_dark",
    WoodLight = "wood_light",
    Painted = "painted",
    PaintedAccent = "painted_accent",
    Laminate = "laminate",
    Metal = "metal",
    MetalDark = "metal_dark",
    Chrome = "chrome",
    Brass = "brass",
    Glass = "glass",
    Mirror = "mirror",
    Ceramic = "ceramic",
    Fabric = "fabric",
    FabricAccent = "fabric_accent",
    FabricLight = "fabric_light",
    Leather = "leather",
    Mattress = "mattress",
    Linen = "linen",
    Plastic = "plastic",
    PlasticDark = "plastic_dark",
    Rubber = "rubber",
    Stone = "stone",
    Concrete = "concrete",
    Plaster = "plaster",
    Ceiling = "ceiling",
    Tile = "tile",
    TileWall = "tile_wall",
    Parquet = "parquet",
    Carpet = "carpet",
    Linoleum = "linoleum",
    Paper = "paper",
    Book = "book",
    Leaf = "leaf",
    Soil = "soil",
    Terracotta = "terracotta",
    Screen = "screen",
    Lamp = "lamp",
    Shade = "shade",
    Appliance = "appliance",
}

impl Slot {
    /// The slot of a word, if there is one.
    #[must_use]
    pub fn find(word: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|slot| slot.name() == word)
    }
}

impl fmt::Display for Slot {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(self.name())
    }
}
