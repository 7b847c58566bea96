//! The readers of foreign formats.
//!
//! To add one:
//! 1. write its file or folder here, with a `const FORMAT: ForeignFormat` (`imdf/` is a short one): it turns its input into
//!    [`crate::plan::BuildingDraft`]s, whose comments say what a draft leaves open, and reports faults with their places;
//! 2. add its `mod` line to `mod.rs` and its `FORMAT` to the list below: recognition, `roomwright formats`, `import` and hints follow;
//! 3. add a section with its words for rooms to `configs/room_words.yaml`, if it has any;
//! 4. take it out of `unread.rs`, if the program knew it as a format that it does not read: a test compares the two lists;
//! 5. add a case to `tests/cases/plan_import/`, and the format to `docs/commands.md`.

use super::formats::{ForeignFormat, OWN_FORMATS, ReadFormat};
use super::{archilyse, ifc, imdf};

/// All formats but the native one, in the order in which they are asked.
pub(crate) const FOREIGN_FORMATS: &[ForeignFormat] = &[archilyse::FORMAT, imdf::FORMAT, ifc::FORMAT];

/// All formats that are read, for people.
#[must_use]
pub fn read_formats() -> Vec<ReadFormat> {
    OWN_FORMATS.into_iter().chain(FOREIGN_FORMATS.iter().map(|format| format.about)).collect()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::super::unread::unread_formats;
    use super::*;

    #[test]
    fn a_format_is_read_or_not_read() {
        let read = read_formats();
        let names: BTreeSet<&str> = read.iter().map(|format| format.name).collect();
        assert_eq!(names.len(), read.len());
        // A packed form, or one file of a folder, may be unread where the format is read.
        let is_whole = |name: &str| !name.contains("ZIP archive") && !name.starts_with("a file of");
        for (unread, _) in unread_formats().into_iter().filter(|(name, _)| is_whole(name)) {
            let mut words = unread.split(|letter: char| !letter.is_alphanumeric()).map(str::to_lowercase);
            assert!(!words.any(|word| names.contains(word.as_str())), "{unread} is read now");
        }
    }
}
