//! Room types for the words of spaces, with one warning for each unknown word.

use std::cell::RefCell;
use std::collections::BTreeMap;

use super::NAME;
use super::model::{Entity, Model};
use crate::plan::RoomWords;
use crate::plan::read::foreign::{TypeOfWord, unknown_words};

/// Where a space says what it is: `LongName`, `Name`, `ObjectType`.
const PLACES: [usize; 3] = [7, 2, 4];

/// Room types by word, remembering the words that are unknown.
pub(super) struct RoomTypes<'a> {
    words: &'a RoomWords,
    /// Word → (its first space, how many).
    unknown: RefCell<BTreeMap<String, (u64, usize)>>,
}

impl<'a> RoomTypes<'a> {
    pub(super) fn new(words: &'a RoomWords) -> Self {
        Self { words, unknown: RefCell::default() }
    }

    /// The type of a space, or that of generic rooms, with a warning to come.
    pub(super) fn of(&self, space: &Entity) -> TypeOfWord {
        let texts: Vec<Vec<String>> =
            PLACES.iter().filter_map(|place| space.text(*place)).map(plain_words).collect();
        if let Some(found) = texts.iter().find_map(|words| self.known(words)) {
            return TypeOfWord::known(&found);
        }
        let said = texts.into_iter().find(|words| !words.is_empty()).unwrap_or_default().join(" ");
        let read = TypeOfWord::unknown(&said);
        self.unknown.borrow_mut().entry(said).or_insert((space.id, 0)).1 += 1;
        read
    }

    /// The room type of the longest run of words that the table knows; of equals the last, which mostly carries the sense
    /// ("kitchen store").
    fn known(&self, words: &[String]) -> Option<String> {
        // Names of rooms are short; what goes on for long is a remark.
        const LONGEST: usize = 12;
        let words = &words[..words.len().min(LONGEST)];
        let runs = (1..=words.len()).rev().flat_map(|length| words.windows(length).rev());
        let mut types = runs.filter_map(|run| self.words.room_type(NAME, &run.join(" ")));
        types.next().map(str::to_owned)
    }

    /// One warning for each unknown word, at its first space.
    pub(super) fn warn(&self, model: &Model) {
        for (word, (id, count)) in self.unknown.borrow().iter() {
            let (message, hint) = unknown_words(NAME, (word, *count));
            model.warn(*id, message, &hint);
        }
    }
}

/// The words of a text in lower case, without numbers: "Bedroom 2.04" is a bedroom.
fn plain_words(text: &str) -> Vec<String> {
    let words = text.split(|letter: char| !letter.is_alphanumeric());
    let words = words.filter(|word| !word.is_empty() && !word.chars().any(char::is_numeric));
    words.map(str::to_lowercase).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_signs_are_no_words() {
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
        ];
        let table = table.map(|(word, kind)| (word.to_owned(), kind.to_owned()));
        let words = RoomWords { words: [(NAME.to_owned(), table.into())].into(), ..RoomWords::default() };
        let types = RoomTypes::new(&words);
        let known = |text: &str| types.known(&plain_words(text));
        assert_eq!(known("Large Living Room 3").as_deref(), Some("living_room"));
        assert_eq!(known("Kitchen store").as_deref(), Some("storeroom"));
        assert_eq!(known("Planetarium"), None);
    }
}
