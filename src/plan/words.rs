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
    /// Every household that exists, for checking native plans; with none every household is taken.
    pub households: BTreeSet<String>,
    /// format → word (lower case) → room type.
    pub words: BTreeMap<String, BTreeMap<String, String>>,
    /// format → word for a piece of furniture (lower case) → its class.
    pub pieces: BTreeMap<String, BTreeMap<String, String>>,
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
        self.households.clear();
    }

    /// Whether rooms can be furnished in a style.
    pub(crate) fn has_style(&self, style: &str) -> bool {
        self.styles.is_empty() || self.styles.contains(style)
    }

    /// Whether a household may live in a dwelling.
    pub(crate) fn has_household(&self, household: &str) -> bool {
        self.households.is_empty() || self.households.contains(household)
    }

    /// The room type that a word stands for in any format: `hallway` is a corridor.
    pub(crate) fn meant(&self, word: &str) -> Option<&str> {
        let word = word.trim().to_lowercase();
        let plain = word.replace(['_', '-'], " ");
        let found =
            self.words.values().find_map(|table| table.get(&word).or_else(|| table.get(plain.trim())))?;
        self.known.contains(found).then_some(found.as_str())
    }

    /// The class of a piece of furniture, by the first of the words that a format has.
    #[must_use]
    pub fn class_of_piece(&self, format: &str, words: &[&str]) -> Option<&str> {
        let table = self.pieces.get(format)?;
        words.iter().find_map(|word| table.get(&word.to_lowercase())).map(String::as_str)
    }

    /// The room type of a word in a format, or `None` where the table has no entry.
    #[must_use]
    pub fn room_type(&self, format: &str, word: &str) -> Option<&str> {
        self.words.get(format)?.get(&word.to_lowercase()).map(String::as_str)
    }
}

#[cfg(test)]
mod tests {
    use crate::catalog::builtin_catalog;
    use crate::plan::read::real_data::published;

    #[test]
    fn each_word_of_the_published_vocabularies_has_a_room_type() {
        let table = &builtin_catalog().room_words;
        for (format, least) in [("archilyse", 107), ("imdf", 60), ("osm", 40)] {
            let mut words = published(format);
            assert!(words.len() >= least, "{format}: {}", words.len());
            words.retain(|word| table.room_type(format, word).is_none());
            assert!(words.is_empty(), "{format}: {words:?}");
        }
        assert_eq!(table.meant("OPEN_PLAN_OFFICE"), Some("office"));
        assert_eq!(table.meant("open-plan living"), Some("living_kitchen"));
    }
}
