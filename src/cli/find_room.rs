//! Finds the room that the command line names.

use std::path::Path;

use crate::document::{Fault, Faults, did_you_mean, suggest};
use crate::plan::{Level, PlacedBuilding, RoomRef};

/// Rooms that are listed where several could be meant.
const MOST_LISTED: usize = 5;

/// The parts of a room's name on the command line.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wanted<'w> {
    /// `[BUILDING/][LEVEL/]ROOM`, or the name of the room.
    pub(crate) room: &'w str,
    /// The building, if that is said.
    pub(crate) building: Option<&'w str>,
    /// The level, if that is said.
    pub(crate) level: Option<&'w str>,
    /// Where the room stands on the command line, for messages.
    pub(crate) argument: &'static str,
}

/// A room in its building.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FoundRoom<'a> {
    /// The building.
    pub(crate) placed: &'a PlacedBuilding,
    /// The room.
    pub(crate) at: RoomRef<'a>,
}

impl<'a> FoundRoom<'a> {
    /// Ids of building, level and room.
    pub(crate) fn ids(&self) -> [&'a str; 3] {
        [&self.placed.id, &self.at.level.id, &self.at.room.id]
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
) -> Result<FoundRoom<'a>, Faults> {
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
        (0..level.rooms.len()).map(move |room| FoundRoom { placed, at: level.room(room) })
    };
    let all: Vec<FoundRoom<'a>> = in_levels.into_iter().flat_map(of_level).collect();
    choose(wanted, &all)
}

fn choose<'a>(wanted: Wanted<'_>, all: &[FoundRoom<'a>]) -> Result<FoundRoom<'a>, Faults> {
    let words = wanted.room;
    let mut found: Vec<&FoundRoom<'a>> = all.iter().filter(|found| found.is_called(words)).collect();
    if found.is_empty() {
        found = all.iter().filter(|found| found.at.room.name.as_deref() == Some(words)).collect();
    }
    match found.as_slice() {
        [found] => Ok(**found),
        [] => Err(no_room(wanted, all).into()),
        several => {
            let message = format!("{} rooms are called \"{words}\"", several.len());
            let ids: Vec<String> =
                several.iter().take(MOST_LISTED).map(|found| found.ids().join("/")).collect();
            let hint = format!("write it in full: {}", ids.join(", "));
            Err(Fault::of_file(Path::new(wanted.argument), message).with_hint(hint).into())
        }
    }
}

/// Suggests a room of similar id or name, or names all by their shortest ids if they are few.
fn no_room(wanted: Wanted<'_>, all: &[FoundRoom<'_>]) -> Fault {
    let message = match wanted.room {
        "" => "which room?".to_owned(),
        words => format!("no room \"{words}\""),
    };
    // `stdy` is compared with ids of rooms, `ground/stdy` with those of levels and rooms.
    let depth = wanted.room.matches('/').count().min(2);
    let ids: Vec<String> = all.iter().map(|found| found.ids()[2 - depth..].join("/")).collect();
    let names = all.iter().filter_map(|found| found.at.room.name.clone());
    let near = suggest(wanted.room, ids.iter().cloned().chain(names));
    let hint =
        near.map(|near| format!("did you mean \"{near}\"?")).or_else(|| did_you_mean(wanted.room, ids));
    let fault = Fault::of_file(Path::new(wanted.argument), message);
    fault.with_hint(hint.unwrap_or_else(|| "`roomwright draw` shows the rooms of a plan".to_owned()))
}

fn unknown(what: &str, id: &str, known: Vec<String>) -> Faults {
    let fault = Fault::of_file(Path::new(&format!("--{what}")), format!("no {what} \"{id}\""));
    match did_you_mean(id, known) {
        Some(hint) => fault.with_hint(hint).into(),
        None => fault.into(),
    }
}
