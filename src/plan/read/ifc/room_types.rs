//! Finds the room types for the words of spaces, with one warning for each unknown word.

use std::cell::RefCell;

use super::NAME;
use super::model::{Entity, Model};
use super::relations::Relations;
use crate::plan::RoomWords;
use crate::plan::read::foreign::TypeOfWord;
use crate::plan::read::room_names::{TypedNames, plain_words};

/// Where a space says what it is: `LongName`, `Name`, `ObjectType`.
const PLACES: [usize; 3] = [7, 2, 4];
/// Where a classification says what its products are: `Name`, `ItemReference` (COBie's exporters write both into either).
const CLASS_PLACES: [usize; 2] = [2, 1];

/// Room types by word, remembering the words that are unknown.
pub(super) struct RoomTypes<'a> {
    model: &'a Model,
    relations: &'a Relations,
    /// A place is the number of a space.
    names: RefCell<TypedNames<'a, u64>>,
}

impl<'a> RoomTypes<'a> {
    pub(super) fn new(words: &'a RoomWords, model: &'a Model, relations: &'a Relations) -> Self {
        Self { model, relations, names: RefCell::new(TypedNames::new(words, NAME)) }
    }

    /// The type of a space, by its names, then by its classifications; for unknown words a warning comes later.
    pub(super) fn of(&self, space: &Entity) -> TypeOfWord {
        let mut texts: Vec<Vec<String>> =
            PLACES.iter().filter_map(|place| space.text(*place)).map(plain_words).collect();
        texts.extend(self.class_words(space));
        let texts: Vec<&[String]> = texts.iter().map(Vec::as_slice).collect();
        let said = texts.iter().copied().find(|words| !words.is_empty()).unwrap_or_default();
        self.names.borrow_mut().of_texts(&texts, said, || space.id)
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
        for (id, message, hint) in self.names.borrow().unknown() {
            model.warn(*id, message, &hint);
        }
    }
}
