//! Reads `configs/` into a checked [`Catalog`]: classes, room types, styles, palettes and the thresholds of the audit.
//!
//! Later stages may rely on:
//! - all inheritance is resolved;
//! - every class index points into [`Catalog::classes`], every name into its table;
//! - sizes are positive;
//! - every palette fills every slot;
//! - styles and palettes are references into [`Catalog::styles`] and [`Catalog::palettes`] wherever one names another;
//! - recipes, material slots and geometry sets are values, no names that later stages look up;
//! - no class has itself as its only ancestor.

mod audit;
mod building_style;
mod builtin;
mod by_id;
mod check;
mod class;
mod class_names;
mod describe;
mod digest;
mod file;
mod households;
mod light;
mod load;
mod palette;
mod read;
mod report;
mod resolve;
mod shape;
mod style;
mod table;
#[cfg(test)]
mod tests;
mod variety;

use std::collections::BTreeMap;
use std::path::PathBuf;

#[cfg(test)]
pub(crate) use audit::AuditFile;
pub use audit::{AccessRules, AuditRules, DoorRules, WalkingRules};
pub use building_style::{BuildingStyle, Share, WeightedStyle};
pub use builtin::{builtin_file, builtin_files};
pub use by_id::{ById, Definition, PaletteRef, StyleRef};
pub use class::{
    Along, COVERING_HEIGHT, Class, ClassIndex, Clearance, FittedPart, Grid, ModelSource, Orientation,
    ParentName, ParentRule, Relation, RelationKind, SideOffer, Turn, VariantRef, WallWishes,
};
pub use describe::{Description, describe, style_differences};
#[cfg(test)]
pub(crate) use file::{ClassFile, HouseholdsFile, PaletteFile, RoomFile, StyleFile, WordsFile};
pub use households::{Claim, Homes, Household, Households, Role};
pub use light::{Light, LightSide};
#[cfg(test)]
pub(crate) use load::builtin_catalog;
pub use load::load_catalog;
pub(crate) use load::load_catalog_so_far;
pub use palette::{Palette, SURFACES};
pub(crate) use resolve::{srgb_encoded, srgb_linear};
pub use shape::{Extent, PrismRule, Shape};
pub use style::{
    Access, Count, Dado, Era, Finish, ForWhom, Plausible, Request, RoomType, Style, Untidiness, WEALTH,
};
pub(crate) use variety::KINDS;
pub use variety::{SHAPES, Variety};

pub use crate::geometry::{Side, Size};
pub use crate::mesh::Material;
use crate::plan::RoomWords;
use crate::storey::Typologies;

/// Everything that configuration says about furniture and rooms.
#[derive(Clone, Debug, Default)]
pub struct Catalog {
    /// The classes, sorted by id.
    pub classes: Vec<Class>,
    /// Room types by id.
    pub room_types: BTreeMap<String, RoomType>,
    /// The styles; always with [`DEFAULT_STYLE`].
    pub styles: ById<Style>,
    /// The style of rooms for which nobody names one.
    pub default_style: StyleRef,
    /// Building styles by id; none has the id of a style.
    pub building_styles: BTreeMap<String, BuildingStyle>,
    /// The palettes.
    pub palettes: ById<Palette>,
    /// The room words of plan formats.
    pub room_words: RoomWords,
    /// Who lives in dwellings, and what their rooms are then.
    pub households: Households,
    /// The kinds of buildings, for those of which only the outline is known.
    pub typologies: Typologies,
    /// The thresholds of the audit.
    pub audit: AuditRules,
    /// Where each definition is written: the last place where later folders replace earlier ones.
    pub origins: BTreeMap<(DefinitionKind, String), Origin>,
    /// SHA-256 over all configuration and model files that were read.
    pub digest: [u8; 32],
}

/// Where a definition is written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Origin {
    /// The file; built-in ones stand below `configs/`.
    pub file: PathBuf,
    /// The line of its id, counted from 1, where the file writes it in a line of its own.
    pub line: Option<usize>,
    /// The id of the definition that it extends.
    pub extends: Option<String>,
}

/// The kinds of definitions in `configs/`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum DefinitionKind {
    /// A class of furniture.
    Class,
    /// A room type.
    RoomType,
    /// A style.
    Style,
    /// A building style.
    BuildingStyle,
    /// A palette.
    Palette,
}

impl DefinitionKind {
    /// All kinds.
    pub const ALL: [Self; 5] = [Self::Class, Self::RoomType, Self::Style, Self::BuildingStyle, Self::Palette];

    /// The word in messages.
    #[must_use]
    pub fn name(self) -> &'static str {
        ["class", "room type", "style", "building style", "palette"][self as usize]
    }

    /// The word for several.
    #[must_use]
    pub fn plural(self) -> &'static str {
        ["classes", "room types", "styles", "building styles", "palettes"][self as usize]
    }
}

/// The style of rooms for which neither plan nor command line name one.
pub const DEFAULT_STYLE: &str = "default";

impl Catalog {
    /// The ids of all styles, then those of all building styles, each sorted.
    pub fn style_ids(&self) -> impl Iterator<Item = &str> + Clone {
        self.styles.ids().chain(self.building_styles.keys().map(String::as_str))
    }

    /// Whether there is a style or building style of that id.
    #[must_use]
    pub fn has_style(&self, id: &str) -> bool {
        self.styles.contains(id) || self.building_styles.contains_key(id)
    }

    /// Index of a class by id.
    #[must_use]
    pub fn class_index(&self, id: &str) -> Option<ClassIndex> {
        self.classes.binary_search_by(|class| class.id.as_str().cmp(id)).ok()
    }
}
