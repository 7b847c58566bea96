//! Guesses the types of rooms whose words no table has, by their shape, openings, fixtures and neighbours.
//!
//! The rules are data (`guesses` in `room_words.yaml`); the first that fits counts. Every guess is reported with its
//! reasons.

mod facts;
mod stack;

use std::collections::{BTreeMap, BTreeSet};

use schemars::JsonSchema;
use serde::Deserialize;

use super::{BuildingDraft, Level, LevelDraft, Problem, RoomDraft, RoomWords, Subject};
use facts::Surroundings;
use stack::Stack;

/// Guesses of an input that are reported one by one; of the others, the level reports counts by type.
const TOLD_GUESSES: usize = 20;
/// The hint of every guess.
const HINT: &str = "guessed by shape and neighbours: name the type if it is another";

/// When a room without a known word is taken to be of a type. Ranges include their ends; what is left out may be anything.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GuessRule {
    /// The room type.
    pub read_as: String,
    /// Square metres.
    pub area: Option<[f64; 2]>,
    /// Metres across the rectangle that has the room's area and perimeter.
    pub width: Option<[f64; 2]>,
    /// Number of windows; anything where a level draws none.
    pub windows: Option<[usize; 2]>,
    /// Number of doors, passages and stretches without a wall; anything where most rooms of a level have none.
    pub doors: Option<[usize; 2]>,
    /// Number of other rooms to which these lead.
    pub leads_to: Option<[usize; 2]>,
    /// Whether a good part of its border is a railing to the open air.
    pub railing: Option<bool>,
    /// Fixtures, one of which the plan draws in it, by the plan's words.
    #[serde(default)]
    pub fixtures: Vec<String>,
    /// Fixtures of which the level draws none at all: where it does, a room without one is something else.
    #[serde(default)]
    pub none_on_level: Vec<String>,
    /// Room types, one of which a known room has that lies at the same place on the next level above or below.
    #[serde(default)]
    pub above_or_below: Vec<String>,
    /// Families (`families`), to one of which most known rooms of the building belong.
    #[serde(default)]
    pub building: Vec<String>,
}

impl GuessRule {
    /// The ranges that are given, by key.
    pub(crate) fn ranges(&self) -> Vec<(&'static str, [f64; 2])> {
        let counts = [("windows", self.windows), ("doors", self.doors), ("leads_to", self.leads_to)];
        let counts = counts.map(|(key, range)| (key, range.map(|ends| ends.map(|end| end as f64))));
        let measures = [("area", self.area), ("width", self.width)];
        measures.into_iter().chain(counts).filter_map(|(key, range)| Some((key, range?))).collect()
    }
}

/// The family to which most rooms belong whose words are known or whose fixtures tell what they are, of equals the first
/// by name; without such rooms the usual one of the format.
fn family_of<'a>(draft: &BuildingDraft, words: &'a RoomWords) -> Option<&'a str> {
    let told_by = |room: &RoomDraft| {
        let mut rules = words.guesses.iter().filter(|rule| rule.building.is_empty());
        let rule = rules.find(|rule| rule.fixtures.iter().any(|kind| room.fixtures.contains(kind)));
        rule.map(|rule| rule.read_as.as_str())
    };
    let rooms = draft.levels.iter().flat_map(|level| &level.rooms);
    let known: Vec<&str> = rooms
        .filter_map(|room| match &room.unknown_word {
            None => Some(room.room_type.as_str()),
            Some(_) => told_by(room),
        })
        .collect();
    let count = |types: &BTreeSet<String>| known.iter().filter(|kind| types.contains(**kind)).count();
    let counts = words.families.iter().map(|(family, types)| (family.as_str(), count(types)));
    let most = counts.reduce(|best, next| if next.1 > best.1 { next } else { best })?;
    if most.1 > 0 {
        return Some(most.0);
    }
    words.families.keys().map(String::as_str).find(|family| draft.usual_family == Some(*family))
}

/// By what the rooms of a building are guessed.
pub(super) struct Guessing<'a> {
    words: &'a RoomWords,
    family: Option<&'a str>,
    stack: Stack,
    /// Guesses of the input that were told so far.
    told: &'a mut usize,
}

impl<'a> Guessing<'a> {
    /// None for a building whose words are all known.
    pub(super) fn of(draft: &BuildingDraft, words: &'a RoomWords, told: &'a mut usize) -> Option<Self> {
        let mut rooms = draft.levels.iter().flat_map(|level| &level.rooms);
        rooms.any(|room| room.unknown_word.is_some()).then(|| Self {
            words,
            family: family_of(draft, words),
            stack: Stack::of(draft),
            told,
        })
    }

    /// Gives the rooms of a draft with unknown words the types that they are taken for: how many these are, and warnings.
    /// `level` is what became of the draft before, `place` that of the level in the building.
    pub(super) fn guess(
        &mut self,
        draft: &mut LevelDraft,
        place: usize,
        level: &Level,
    ) -> (usize, Vec<Problem>) {
        let rooms: BTreeMap<&str, usize> =
            level.rooms.iter().enumerate().map(|(index, room)| (room.id.as_str(), index)).collect();
        let fixtures: BTreeSet<String> =
            draft.rooms.iter().flat_map(|room| &room.fixtures).cloned().collect();
        let surroundings = Surroundings::of(level, self.family, &fixtures);
        let mut problems = Vec::new();
        let mut others: BTreeMap<String, usize> = BTreeMap::new();
        let mut count = 0;
        for (number, room) in draft.rooms.iter_mut().enumerate() {
            let Some(word) = &room.unknown_word else { continue };
            let Some(index) = rooms.get(room.id.as_str()) else { continue };
            let facts = surroundings.facts(*index, &room.fixtures, self.stack.types_at(place, &room.outline));
            if let Some(rule) = self.words.guesses.iter().find(|rule| facts.fit(rule)) {
                room.room_type.clone_from(&rule.read_as);
            }
            count += 1;
            if *self.told >= TOLD_GUESSES {
                *others.entry(room.room_type.clone()).or_default() += 1;
                continue;
            }
            *self.told += 1;
            let word = if word.is_empty() { String::new() } else { format!(" ({word})") };
            let fact =
                format!("room \"{}\"{word}: read as {}: {}", room.id, room.room_type, facts.in_words());
            problems.push(Problem::warning(Subject::Room(number), fact, Some(HINT)));
        }
        problems.extend(summary(&others));
        (count, problems)
    }
}

/// The guesses for rooms of a level that are not reported one by one.
fn summary(others: &BTreeMap<String, usize>) -> Option<Problem> {
    let rooms = match others.values().sum() {
        0 => return None,
        1 => "1 more room with an unknown word".to_owned(),
        count => format!("{count} more rooms with unknown words"),
    };
    let kinds: Vec<String> = others.iter().map(|(kind, count)| format!("{count} {kind}")).collect();
    Some(Problem::warning(Subject::Level, format!("{rooms}: read as {}", kinds.join(", ")), Some(HINT)))
}

#[cfg(test)]
mod tests;
