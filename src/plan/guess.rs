//! What rooms are whose words no table knows: judged by their shape, their openings and the rooms around them.
//!
//! The rules are data (`guesses` in `room_words.yaml`); the first that fits counts. A guess is always told, with what it
//! rests on.

use std::collections::{BTreeMap, BTreeSet};

use schemars::JsonSchema;
use serde::Deserialize;

use super::clean::mean_width;
use super::{BuildingDraft, Level, LevelDraft, OpeningKind, Problem, Room, RoomWords, Subject, WallKind};
use crate::geometry::Polygon;

/// Share of the other rooms of a level that must have a way in before a room without one is taken to be closed: many maps
/// draw few doors.
const DOORED_SHARE: f64 = 0.75;
/// Share of a room's border that is a railing where it lies in the open air.
const RAILED_SHARE: f64 = 0.2;
/// Metres of width below which the width is a reason worth telling.
const NARROW: f64 = 1.5;

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
    /// Whether a good part of its border is a railing.
    pub railing: Option<bool>,
    /// Families (`families`), to one of which most known rooms of the building belong.
    #[serde(default)]
    pub building: Vec<String>,
}

/// What is known of a room.
struct Facts<'a> {
    area: f64,
    width: f64,
    /// None where the level draws no window at all.
    windows: Option<usize>,
    /// None where most rooms have no way in.
    doors: Option<usize>,
    leads_to: usize,
    is_railed: bool,
    building: Option<&'a str>,
}

/// The family to which most rooms with known words belong; of equals the first by name.
pub(super) fn family_of<'a>(draft: &BuildingDraft, words: &'a RoomWords) -> Option<&'a str> {
    let rooms = draft.levels.iter().flat_map(|level| &level.rooms);
    let known: Vec<&str> =
        rooms.filter(|room| room.unknown_word.is_none()).map(|room| room.room_type.as_str()).collect();
    let count = |types: &BTreeSet<String>| known.iter().filter(|kind| types.contains(**kind)).count();
    let counts = words.families.iter().map(|(family, types)| (family.as_str(), count(types)));
    let most = counts.reduce(|best, next| if next.1 > best.1 { next } else { best })?;
    (most.1 > 0).then_some(most.0)
}

/// Gives the rooms of a draft with unknown words the types that they are taken for; each guess as a warning. `level` is
/// what became of the draft before.
pub(super) fn guess_rooms(
    draft: &mut LevelDraft,
    level: &Level,
    (words, building): (&RoomWords, Option<&str>),
) -> Vec<Problem> {
    let places: BTreeMap<&str, usize> =
        level.rooms.iter().enumerate().map(|(place, room)| (room.id.as_str(), place)).collect();
    let surroundings = Surroundings::of(level, building);
    let mut problems = Vec::new();
    for (number, room) in draft.rooms.iter_mut().enumerate() {
        let Some(word) = &room.unknown_word else { continue };
        let Some(place) = places.get(room.id.as_str()) else { continue };
        let facts = surroundings.facts(*place);
        if let Some(rule) = words.guesses.iter().find(|rule| facts.fit(rule)) {
            room.room_type.clone_from(&rule.read_as);
        }
        let fact = format!("room \"{}\" ({word}): read as {}: {}", room.id, room.room_type, facts.in_words());
        problems.push(Problem::warning(
            Subject::Room(number),
            fact,
            Some("it is a guess by its shape and neighbours"),
        ));
    }
    problems
}

/// What the rooms of a level have in common.
struct Surroundings<'a> {
    level: &'a Level,
    building: Option<&'a str>,
    draws_windows: bool,
    is_doored: bool,
}

impl<'a> Surroundings<'a> {
    fn of(level: &'a Level, building: Option<&'a str>) -> Self {
        let reached = level.rooms.iter().filter(|room| !ways(level, room).is_empty()).count();
        let draws_windows = level.openings.iter().any(|opening| opening.kind == OpeningKind::Window);
        let is_doored = reached as f64 >= level.rooms.len() as f64 * DOORED_SHARE;
        Self { level, building, draws_windows, is_doored }
    }

    fn facts(&self, place: usize) -> Facts<'a> {
        let room = &self.level.rooms[place];
        let openings = room.openings.iter().map(|entry| &self.level.openings[entry.opening]);
        let windows = openings.filter(|opening| opening.kind == OpeningKind::Window).count();
        let ways = ways(self.level, room);
        let sides = ways.iter().flat_map(|way| &self.level.openings[*way].sides);
        let others: BTreeSet<usize> = sides.map(|side| side.room).filter(|other| *other != place).collect();
        let length = |railed: bool| {
            let walls = room.walls.iter().filter(|wall| !railed || wall.kind != WallKind::Solid);
            walls.map(|wall| wall.length()).sum::<f64>()
        };
        Facts {
            area: room.region.area(),
            width: width_of(&room.region.outline),
            windows: self.draws_windows.then_some(windows),
            doors: self.is_doored.then_some(ways.len()),
            leads_to: others.len(),
            is_railed: length(true) > length(false) * RAILED_SHARE,
            building: self.building,
        }
    }
}

/// Metres across the rectangle that has a room's area and perimeter; of shapes rounder than any rectangle, of the square.
fn width_of(outline: &Polygon) -> f64 {
    // Of a rectangle `a` by `b`: area a b over half the perimeter a + b.
    let mean = mean_width(outline);
    let half = outline.area() / mean / 2.0;
    half - (half * half - outline.area()).max(0.0).sqrt()
}

/// The openings of a room that people walk through.
fn ways(level: &Level, room: &Room) -> BTreeSet<usize> {
    let openings = room.openings.iter().map(|entry| entry.opening);
    openings.filter(|opening| level.openings[*opening].kind.is_walkable()).collect()
}

impl Facts<'_> {
    fn fit(&self, rule: &GuessRule) -> bool {
        let holds = |range: Option<[f64; 2]>, value: f64| {
            range.is_none_or(|[low, high]| (low..=high).contains(&value))
        };
        let counts = |range: Option<[usize; 2]>, value: Option<usize>| match (range, value) {
            (Some([low, high]), Some(value)) => (low..=high).contains(&value),
            _ => true,
        };
        holds(rule.area, self.area)
            && holds(rule.width, self.width)
            && counts(rule.windows, self.windows)
            && counts(rule.doors, self.doors)
            && counts(rule.leads_to, Some(self.leads_to))
            && rule.railing.is_none_or(|railing| railing == self.is_railed)
            && (rule.building.is_empty()
                || self.building.is_some_and(|family| rule.building.iter().any(|name| name == family)))
    }

    /// What a guess rests on, as "3.1 m², no window, one door".
    fn in_words(&self) -> String {
        let counted = |count: usize, what: &str| match count {
            0 => format!("no {what}"),
            1 => format!("one {what}"),
            count => format!("{count} {what}s"),
        };
        let mut facts = vec![format!("{:.1} m²", self.area)];
        if self.width < NARROW {
            facts.push(format!("{:.2} m wide", self.width));
        }
        facts.extend(self.windows.map(|count| counted(count, "window")));
        facts.extend(self.doors.map(|count| counted(count, "door")));
        if self.leads_to > 2 {
            facts.push(format!("leads to {} rooms", self.leads_to));
        }
        facts.extend(self.is_railed.then(|| "with a railing".to_owned()));
        facts.extend(self.building.map(|family| format!("among rooms of the family {family}")));
        facts.join(", ")
    }
}

#[cfg(test)]
mod tests;
