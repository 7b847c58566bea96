//! Material slots: what a part is made of, before a palette says what that looks like.

use std::fmt;

use serde::{Deserialize, Serialize};

/// The enum, the list of all slots, their words and uses, from one list.
macro_rules! slots {
    ($($slot:ident = $word:literal: $use:literal,)*) => {
        /// The material of a part, as far as recipes and the shells of rooms know: palettes say what each slot looks like.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
        pub enum Slot {
            $(#[doc = concat!("`", $word, "`: ", $use, ".")] $slot,)*
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

            /// Its use, for the page about recipes.
            #[cfg(test)]
            fn about(self) -> &'static str {
                match self {
                    $(Self::$slot => $use,)*
                }
            }
        }
    };
}

slots! {
    Wood = "wood": "wood of a middle tone",
    WoodDark = "wood_dark": "dark wood",
    WoodLight = "wood_light": "light wood",
    Painted = "painted": "painted or lacquered wood and board; painted metal",
    PaintedAccent = "painted_accent": "the same in an accent colour",
    Laminate = "laminate": "board with a hard face: worktops, desk tops, doors of cupboards",
    Metal = "metal": "light metal: steel, aluminium",
    MetalDark = "metal_dark": "dark metal: frames, feet, hinges",
    Chrome = "chrome": "bright metal: taps, rails, handles",
    Brass = "brass": "brass: knobs, lamps, old fittings",
    Glass = "glass": "clear glass",
    Mirror = "mirror": "mirror glass",
    Ceramic = "ceramic": "glazed ceramic: toilets, basins, cups",
    Fabric = "fabric": "cloth of covers",
    FabricAccent = "fabric_accent": "cloth in an accent colour: cushions, stripes",
    FabricLight = "fabric_light": "light cloth: curtains, blankets",
    Leather = "leather": "leather",
    Mattress = "mattress": "covers of mattresses",
    Linen = "linen": "bed linen and white cloth",
    Plastic = "plastic": "light plastic",
    PlasticDark = "plastic_dark": "dark plastic: keys, housings, castors",
    Rubber = "rubber": "rubber: feet, tyres, hoses",
    Stone = "stone": "stone: worktops, table tops",
    Concrete = "concrete": "concrete and rough ceramic",
    Plaster = "plaster": "plaster of walls",
    Ceiling = "ceiling": "ceilings of rooms",
    Tile = "tile": "tiles of floors",
    TileWall = "tile_wall": "tiles of walls",
    Parquet = "parquet": "parquet of floors",
    Carpet = "carpet": "carpet of floors, and rugs",
    Linoleum = "linoleum": "linoleum of floors",
    Paper = "paper": "paper, card and labels",
    Book = "book": "backs and covers of books",
    Leaf = "leaf": "leaves",
    Soil = "soil": "soil in pots",
    Terracotta = "terracotta": "pots of plants, and bricks",
    Screen = "screen": "dark glass: screens, doors of ovens",
    Lamp = "lamp": "light sources: bulbs, tubes, panels",
    Shade = "shade": "shades of lamps, which glow",
    Appliance = "appliance": "housings of machines: fridges, washing machines",
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

#[cfg(test)]
mod tests {
    use super::*;

    const HEAD: &str = "| slot | for |\n|---|---|\n";

    #[test]
    fn the_page_about_recipes_has_the_table_of_slots() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/recipe.md");
        let page = std::fs::read_to_string(path).unwrap();
        let row = |slot: &Slot| format!("| `{slot}` | {} |\n", slot.about());
        let table = format!("{HEAD}{}", Slot::ALL.iter().map(row).collect::<String>());
        let from = page.find(HEAD).expect("the page has the table");
        let length = page[from..].find("\n\n").expect("the table ends") + 1;
        let shown = &page[from..from + length];
        if std::env::var_os("UPDATE_GOLDENS").is_some() {
            return std::fs::write(path, page.replace(shown, &table)).unwrap();
        }
        assert_eq!(shown, table, "renew it with UPDATE_GOLDENS=1 cargo test --lib the_page_about_recipes");
    }
}
