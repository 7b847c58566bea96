//! The types of the files in `configs/`, one module for each kind of file.
//!
//! A key is optional if inheritance or a default can fill it. Values are checked for their type only.

mod building_style;
mod class;
mod extent;
mod households;
mod palette;
mod room;
mod style;
mod value;
mod words;

use serde::Deserialize;

pub(crate) use building_style::{BuildingStyleEntry, ChoiceEntry};
pub(crate) use class::{
    ClassEntry, ClassFile, ClearanceEntry, ModelEntry, ModelFields, Parameter, ParentEntry, PartEntry,
    RelationEntry, ShapeEntry, SideEntry, WallsEntry,
};
pub(crate) use extent::{ExtentFault, read_extent};
pub(crate) use households::{
    ClaimEntry, HomesEntry, HouseholdEntry, HouseholdsFile, LivingEntry, PickWord, RoleEntry,
};
pub(crate) use palette::{MaterialEntry, PaletteEntry, PaletteFile};
pub(crate) use room::{CountEntry, CountFields, RequestEntry, RoomFile, RoomTypeEntry};
pub(crate) use style::{StyleEntry, StyleFile};
pub(crate) use value::{Edges, ExtentText, OneOrMany, Pair, VariedEntry};
pub(crate) use words::WordsFile;

/// The version of the file formats that this program reads.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(try_from = "u32")]
pub(crate) struct FormatVersion;

/// The value of the first key of every file.
const FORMAT_VERSION: u32 = 1;

impl TryFrom<u32> for FormatVersion {
    type Error = String;

    fn try_from(version: u32) -> Result<Self, String> {
        if version == FORMAT_VERSION {
            return Ok(Self);
        }
        Err(format!("version {version} is not known; this program reads version {FORMAT_VERSION}"))
    }
}

impl schemars::JsonSchema for FormatVersion {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "FormatVersion".into()
    }

    fn inline_schema() -> bool {
        true
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({"description": "Version of the file format.", "const": FORMAT_VERSION})
    }
}
