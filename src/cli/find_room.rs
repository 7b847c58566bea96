//! The room that somebody means on the command line.

use std::path::Path;

use crate::document::{Fault, Faults, did_you_mean};
use crate::plan::{Level, PlacedBuilding, Room};

/// Rooms that are listed where several could be meant.
const MOST_LISTED: usize = 5;

/// What somebody says about a room.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wanted<'w> {
    /// `[BUILDING/][LEVEL/]ROOM`, or the name of the room.
    pub(crate) room: &'w str,
    /// The building, if that is said.
    pub(crate) building: Option<&'w str>,
    /// The level, if that is said.
    pub(crate) level: Option<&'w str>,
}

/// A room in its building.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Found<'a> {
    /// The building.
    pub(crate) placed: &'a PlacedBuilding,
    /// The level.
    pub(crate) level: &'a Level,
    /// Index in the level.
    pub(crate) room: usize,
}

impl<'a> Found<'a> {
    /// The room itself.
    pub(crate) fn room(&self) -> &'a Room {
        &self.level.rooms[self.room]
    }

    /// Ids of building, level and room.
    pub(crate) fn ids(&self) -> [&'a str; 3] {
        [&self.placed.id, &self.level.id, &self.room().id]
    }

    /// Whether the words are the ids of the room, of room and level, or of all three.
    fn is_called(&self, words: &str) -> bool {
        let ids = self.ids();
        (0..ids.len()).any(|skipped| ids[skipped..].join("/") == words)
    }
}

/// The one room of these ids, or, if there is none, of that name.
///
/// # Errors
/// If there is no such building, level or room, or more than one.
pub(crate) fn find_room<'a>(
    buildings: &'a [PlacedBuilding],
    wanted: Wanted<'_>,
) -> Result<Found<'a>, Faults> {
    let is_wanted = |wanted: Option<&str>, id: &str| wanted.is_none_or(|wanted| wanted == id);
    let in_buildings: Vec<&PlacedBuilding> =
        buildings.iter().filter(|placed| is_wanted(wanted.building, &placed.id)).collect();
    if let (Some(id), true) = (wanted.building, in_buildings.is_empty()) {
        return Err(unknown("building", id, buildings.iter().map(|placed| placed.id.clone()).collect()));
    }
    let of_building =
        |placed: &'a PlacedBuilding| placed.building.levels.iter().map(move |level| (placed, level));
    let levels: Vec<(&PlacedBuilding, &Level)> = in_buildings.into_iter().flat_map(of_building).collect();
    let in_levels: Vec<_> = levels.iter().filter(|(_, level)| is_wanted(wanted.level, &level.id)).collect();
    if let (Some(id), true) = (wanted.level, in_levels.is_empty()) {
        return Err(unknown("level", id, levels.iter().map(|(_, level)| level.id.clone()).collect()));
    }
    let of_level = |&(placed, level): &(&'a PlacedBuilding, &'a Level)| {
        (0..level.rooms.len()).map(move |room| Found { placed, level, room })
    };
    let all: Vec<Found<'a>> = in_levels.into_iter().flat_map(of_level).collect();
    choose(wanted.room, &all)
}

fn choose<'a>(words: &str, all: &[Found<'a>]) -> Result<Found<'a>, Faults> {
    let mut found: Vec<&Found<'a>> = all.iter().filter(|found| found.is_called(words)).collect();
    if found.is_empty() {
        found = all.iter().filter(|found| found.room().name.as_deref() == Some(words)).collect();
    }
    match found.as_slice() {
        [found] => Ok(**found),
        [] => {
            let known = all.iter().flat_map(|found| {
                let name = found.room().name.clone();
                [Some(found.room().id.clone()), Some(found.ids().join("/")), name].into_iter().flatten()
            });
            Err(unknown("room", words, known.collect()))
        }
        several => {
            let message = format!("{} rooms are called \"{words}\"", several.len());
            let ids: Vec<String> =
                several.iter().take(MOST_LISTED).map(|found| found.ids().join("/")).collect();
            let hint = format!("write it in full: {}", ids.join(", "));
            Err(Fault::of_file(Path::new("ROOM"), message).with_hint(hint).into())
        }
    }
}

fn unknown(what: &str, id: &str, known: Vec<String>) -> Faults {
    let place = if what == "room" { "ROOM".to_owned() } else { format!("--{what}") };
    let fault = Fault::of_file(Path::new(&place), format!("no {what} \"{id}\""));
    match did_you_mean(id, known) {
        Some(hint) => fault.with_hint(hint).into(),
        None => fault.into(),
    }
}
