//! What a format is, and the formats that are this program's own.

use std::path::Path;

use schemars::JsonSchema;
use serde::Serialize;

use super::found::ReadResult;
use crate::plan::RoomWords;

/// A format that plans are read in, for people.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct ReadFormat {
    /// The word in `room_words.yaml`; `native` and `project` have none there.
    pub name: &'static str,
    /// The name for people.
    pub title: &'static str,
    /// The file or folder to name.
    pub input: &'static str,
    /// The parts of it that are read, and those that are not.
    pub content: &'static str,
}

/// A foreign format with its reader; a line of [`super::readers::FOREIGN_FORMATS`].
#[derive(Debug)]
pub(crate) struct ForeignFormat {
    /// How `roomwright formats` describes it.
    pub(crate) about: ReadFormat,
    /// Whether a file or folder is of this format, from names and the beginning of files.
    pub(crate) recognises: fn(&Path) -> bool,
    /// Reads all buildings of a file or folder; ids come from the data or the name of the file.
    pub(crate) read: fn(&Path, &RoomWords) -> ReadResult,
}

/// The formats of this program itself.
pub(super) const OWN_FORMATS: [ReadFormat; 2] = [
    ReadFormat {
        name: "native",
        title: "native YAML or JSON",
        input: "a file with the key `levels`; its edits lie beside it in <name>.edits.yaml",
        content: "everything; the schema is configs/schema/plan.schema.json",
    },
    ReadFormat {
        name: "project",
        title: "projects",
        input: "a file with the key `project`",
        content: "plans of any format, placed many times; the schema is configs/schema/project.schema.json",
    },
];
