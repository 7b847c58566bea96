//! The words of plans for rooms, and the room types that they mean.

use std::collections::{BTreeMap, BTreeSet};

use super::GuessRule;

/// Maps each format's room words to room types. Filled from `configs/room_words.yaml` and the user's own
/// additions, so that a new word needs no code.
#[derive(Clone, Debug, Default)]
pub struct RoomWords {
    /// Every room type that exists, for checking native plans; with none every type is taken.
    pub known: BTreeSet<String>,
    /// Every style and building style that exists, for checking native plans and projects; with none every style is taken.
    pub styles: BTreeSet<String>,
    /// format → word (lower case) → room type.
    pub words: BTreeMap<String, BTreeMap<String, String>>,
    /// Guesses for rooms with other words, by their looks: the first rule that fits counts.
    pub guesses: Vec<GuessRule>,
    /// Kinds of buildings, by the room types that are typical of them.
    pub families: BTreeMap<String, BTreeSet<String>>,
}

/// The room type of rooms with unknown words for which no guess fits.
pub const GENERIC_ROOM_TYPE: &str = "generic";

impl RoomWords {
    /// Takes every room type and style.
    pub(crate) fn accept_everything(&mut self) {
        self.known.clear();
        self.styles.clear();
    }

    /// Whether rooms can be furnished in a style.
    pub(crate) fn has_style(&self, style: &str) -> bool {
        self.styles.is_empty() || self.styles.contains(style)
    }

    /// The room type that a word stands for in any format: `hallway` is a corridor.
    pub(crate) fn meant(&self, word: &str) -> Option<&str> {
        let plain = word.to_lowercase().replace(['_', '-'], " ");
        let found = self.words.values().find_map(|table| table.get(plain.trim()))?;
        self.known.contains(found).then_some(found.as_str())
    }

    /// The room type of a word in a format, or `None` where the table has no entry.
    #[must_use]
    pub fn room_type(&self, format: &str, word: &str) -> Option<&str> {
        self.words.get(format)?.get(&word.to_lowercase()).map(String::as_str)
    }
}
