//! Finds the room types for the words of spaces, with one warning for each unknown word.

use std::cell::RefCell;
use std::collections::BTreeMap;

use super::NAME;
use super::model::{Entity, Model};
use super::relations::Relations;
use crate::plan::RoomWords;
use crate::plan::read::foreign::{TypeOfWord, unknown_words};
use crate::plan::read::room_names::{most_telling, plain_words, type_of_words};

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
        let found = most_telling(texts.iter().filter_map(|words| type_of_words(self.words, &[NAME], words)));
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
