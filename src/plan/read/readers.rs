//! The readers of foreign formats.

use std::path::Path;

use super::found::ReadResult;
use super::{archilyse, ifc, imdf};
use crate::plan::RoomWords;

/// A foreign format. To add one, write its file and add a line to [`FOREIGN_FORMATS`] and to [`super::READ_FORMATS`].
#[derive(Debug)]
pub(crate) struct ForeignFormat {
    /// The word in `room_words.yaml`, and in [`super::READ_FORMATS`], which describes the format for people.
    pub(crate) name: &'static str,
    /// Whether a file or folder is of this format, from names and the beginning of files.
    pub(crate) recognises: fn(&Path) -> bool,
    /// Reads all buildings of a file or folder; ids come from the data or the name of the file.
    pub(crate) read: fn(&Path, &RoomWords) -> ReadResult,
}

/// All formats but the native one, in the order in which they are asked.
pub(crate) const FOREIGN_FORMATS: &[ForeignFormat] = &[
    ForeignFormat { name: archilyse::NAME, recognises: archilyse::recognises, read: archilyse::read },
    ForeignFormat { name: imdf::NAME, recognises: imdf::recognises, read: imdf::read },
    ForeignFormat { name: ifc::NAME, recognises: ifc::recognises, read: ifc::read },
];
