//! Finds the room types for the words of spaces, with one warning for each unknown word.

use std::cell::RefCell;
use std::collections::BTreeMap;

use super::NAME;
use super::model::{Entity, Model};
use super::relations::Relations;
use crate::plan::read::foreign::{TypeOfWord, unknown_words};
use crate::plan::{GENERIC_ROOM_TYPE, RoomWords};

/// Where a space says what it is: `LongName`, `Name`, `ObjectType`.
const PLACES: [usize; 3] = [7, 2, 4];
/// Where a classification says what its products are: `Name`, `ItemReference` (COBie's exporters write both into either).
const CLASS_PLACES: [usize; 2] = [2, 1];

/// Room types by word, remembering the words that are unknown.
pub(super) struct RoomTypes<'a> {
    words: &'a RoomWords,
    model: &'a Model,
    relations: &'a Relations,
    /// Word → (its first space, how many).
    unknown: RefCell<BTreeMap<String, (u64, usize)>>,
}

impl<'a> RoomTypes<'a> {
    pub(super) fn new(words: &'a RoomWords, model: &'a Model, relations: &'a Relations) -> Self {
        Self { words, model, relations, unknown: RefCell::default() }
    }

    /// The type of a space, by its names, then by its classifications; for unknown words a warning comes later.
    pub(super) fn of(&self, space: &Entity) -> TypeOfWord {
        let mut texts: Vec<Vec<String>> =
            PLACES.iter().filter_map(|place| space.text(*place)).map(plain_words).collect();
        texts.extend(self.class_words(space));
        let found = most_telling(texts.iter().filter_map(|words| known(self.words, words)));
        let said = texts.into_iter().find(|words| !words.is_empty()).unwrap_or_default().join(" ");
        if let Some(found) = found {
            return TypeOfWord::known(&said, found);
        }
        let read = TypeOfWord::unknown(&said);
        self.unknown.borrow_mut().entry(said).or_insert((space.id, 0)).1 += 1;
        read
    }

    /// The words of the classifications of a space.
    fn class_words(&self, space: &Entity) -> Vec<Vec<String>> {
        let classes = self.relations.classes(space.id).iter().filter_map(|class| self.model.get(*class).ok());
        let classes = classes.filter(|class| class.is(&["IFCCLASSIFICATIONREFERENCE"]));
        classes
            .flat_map(|class| CLASS_PLACES.map(|place| class.text(place).map(plain_words)))
            .flatten()
            .collect()
    }

    /// Warnings for unknown words, at their first spaces.
    pub(super) fn warn(&self, model: &Model) {
        for (id, message, hint) in unknown_words(NAME, &self.unknown.borrow()) {
            model.warn(*id, message, &hint);
        }
    }
}

/// The room type of the longest run of words that the table knows; of equals the last, which mostly carries the sense
/// ("kitchen store").
fn known<'a>(table: &'a RoomWords, words: &[String]) -> Option<&'a str> {
    // Names of rooms are short; what goes on for long is a remark.
    const LONGEST: usize = 12;
    let words = &words[..words.len().min(LONGEST)];
    let runs = (1..=words.len()).rev().flat_map(|length| words.windows(length).rev());
    most_telling(runs.filter_map(|run| table.room_type(NAME, &run.join(" "))))
}

/// The first type, but that of generic rooms only where there is no other: an "office space" is an office.
fn most_telling<'a>(types: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let types: Vec<&str> = types.collect();
    types.iter().find(|kind| **kind != GENERIC_ROOM_TYPE).or(types.first()).copied()
}

/// The words of a text in lower case, without numbers: "Bedroom 2.04" is a bedroom.
pub(super) fn plain_words(text: &str) -> Vec<String> {
    let words = text.split(|letter: char| !letter.is_alphanumeric());
    let words = words.filter(|word| !word.is_empty() && !word.chars().any(char::is_numeric));
    words.map(str::to_lowercase).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::load_catalog;
    use crate::plan::read::real_data::published;

    #[test]
    fn numbers_and_signs_are_not_room_words() {
        assert_eq!(plain_words("A-102 Living Room"), ["a", "living", "room"]);
        assert_eq!(plain_words("WC/Dusche 1.04"), ["wc", "dusche"]);
        assert!(plain_words("2.14").is_empty());
    }

    #[test]
    fn the_longest_known_run_counts_and_the_last_of_equals() {
        let table = [
            ("living room", "living_room"),
            ("room", "room"),
            ("kitchen", "kitchen"),
            ("store", "storeroom"),
            ("space", "generic"),
        ];
        let table = table.map(|(word, kind)| (word.to_owned(), kind.to_owned()));
        let words = RoomWords { words: [(NAME.to_owned(), table.into())].into(), ..RoomWords::default() };
        let known = |text: &str| known(&words, &plain_words(text));
        assert_eq!(known("Large Living Room 3"), Some("living_room"));
        assert_eq!(known("Kitchen store"), Some("storeroom"));
        assert_eq!(known("Kitchen space"), Some("kitchen"), "a space is no more than a room");
        assert_eq!(known("Space 12"), Some("generic"));
        assert_eq!(known("Planetarium"), None);
    }

    #[test]
    fn each_published_function_of_rooms_is_more_than_a_room() {
        let table = load_catalog(&[]).expect("the built-in catalogue is sound").value.room_words;
        let type_of = |word: &str| known(&table, &plain_words(word));
        for vocabulary in ["omniclass", "din_277"] {
            let mut words = published(vocabulary);
            assert!(words.len() > 100, "{vocabulary}");
            words.retain(|word| matches!(type_of(word), None | Some(GENERIC_ROOM_TYPE)));
            assert!(words.is_empty(), "{vocabulary}: {words:?}");
        }
        assert_eq!(type_of("13-15 31 11: Control Room"), Some("security"), "and no bedroom");
        assert_eq!(type_of("Assembly Hall"), Some("auditorium"), "and no corridor");
    }
}
