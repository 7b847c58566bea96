//! Room types for the words of areas, which are those of the program that the data set was made with.

use std::collections::BTreeMap;

use crate::plan::RoomWords;
use crate::plan::read::archilyse::{NAME, type_of};
use crate::plan::read::foreign::TypeOfWord;

/// Room types by word, remembering the words that are unknown.
pub(super) struct RoomTypes<'a> {
    words: &'a RoomWords,
    /// Word → (the first line with it, how many areas).
    pub(super) unknown: BTreeMap<String, (usize, usize)>,
}

impl<'a> RoomTypes<'a> {
    pub(super) fn new(words: &'a RoomWords) -> Self {
        Self { words, unknown: BTreeMap::new() }
    }

    /// The type of an area's word; for an unknown one a warning comes later.
    pub(super) fn of(&mut self, word: &str, is_toilet: bool, line: usize) -> TypeOfWord {
        type_of(self.words, word, is_toilet).unwrap_or_else(|| {
            let (first, count) = self.unknown.entry(word.to_owned()).or_insert((line, 0));
            *first = line.min(*first);
            *count += 1;
            TypeOfWord::unknown(word)
        })
    }

    /// The section of the table of words.
    pub(super) const SECTION: &'static str = NAME;
}
