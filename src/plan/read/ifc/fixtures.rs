//! Reads fixtures and furniture of rooms, which hint at the type of a room without a known word.

use std::collections::{BTreeMap, BTreeSet};

use super::furniture::KINDS;
use super::level::Storey;
use super::model::Model;
use super::relations::Relations;
use crate::plan::RoomWords;
use crate::plan::read::room_names::plain_words;

/// Gives the rooms of storeys the words of what the file puts into their spaces, as far as guesses ask for them; only where
/// there is something to guess.
pub(super) fn note_fixtures(model: &Model, relations: &Relations, words: &RoomWords, storeys: &mut [Storey]) {
    let mut rooms = storeys.iter().flat_map(|storey| &storey.draft.rooms);
    if rooms.all(|room| room.unknown_word.is_none()) {
        return;
    }
    let telling: BTreeSet<&str> =
        words.guesses.iter().flat_map(|rule| &rule.fixtures).map(String::as_str).collect();
    let mut fixtures: BTreeMap<u64, BTreeSet<String>> = BTreeMap::new();
    for product in model.all(&KINDS) {
        let Some(whole) = relations.wholes(product.id).next() else { continue };
        let mut said = plain_words(product.text(2).unwrap_or_default());
        said.retain(|word| telling.contains(word.as_str()));
        fixtures.entry(whole).or_default().extend(said);
    }
    for storey in storeys {
        for (space, places) in &storey.rooms_of {
            let Some(found) = fixtures.get(space) else { continue };
            places.iter().for_each(|place| storey.draft.rooms[*place].fixtures.clone_from(found));
        }
    }
}
