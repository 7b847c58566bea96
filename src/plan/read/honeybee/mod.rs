//! Energy models of Ladybug Tools: dragonfly's (`.dfjson`) and honeybee's (`.hbjson`).
//!
//! Of dragonfly's buildings each is a building here, honeybee's rooms are one together. Of both are read:
//! - rooms: the floors of dragonfly's, drawn as outlines with heights; of honeybee's bodies the floor faces, seen from above;
//! - storeys with their heights and repetitions; honeybee's by the names of storeys in the rooms, else by the heights of floors;
//! - windows and doors as they are drawn in walls, and those that dragonfly's parameters ask for;
//! - what adjoins: an opening in a wall between two rooms joins these two, and an air boundary is no wall;
//! - room types by the names of rooms and their programs.
//!
//! Not read: roofs, skylights, shades, constructions, schedules, systems, results.
//!
//! Models draw walls without thickness, so that rooms reach to each other: areas are those of the model. Lengths are in the
//! units of the model. What a model leaves open stays open: a room without a door gets a warning, and no door.

mod floor;
mod level;
mod model;
mod notes;
mod openings;
mod recipes;
mod room2d;
mod room3d;
mod room_types;
mod schema;
mod storeys;

#[cfg(test)]
mod real_models;
#[cfg(test)]
mod tests;

use std::path::Path;

use self::model::{Place, Storey, part};
use self::notes::Notes;
use self::room_types::{NAME, Naming};
use self::schema::{Building, Model};
use super::foreign::{UniqueIds, id_of_file, slug};
use super::reader::{DraftedBuilding, ForeignFormat, ReadBuildings, ReadFormat, ReadResult};
use super::recentred::{recentring, shift};
use super::sample::Sample;
use crate::document::{Fault, Source, did_you_mean};
use crate::plan::units::model_unit;
use crate::plan::{BuildingDraft, RoomWords};

/// The line of the table of readers.
pub(crate) const FORMAT: ForeignFormat = ForeignFormat {
    about: ReadFormat {
        name: NAME,
        title: "dragonfly and honeybee",
        input: "a model of Ladybug Tools: .dfjson, .hbjson, or JSON with the same keys",
        content: "rooms, storeys and how often they stand on each other, windows and doors, air boundaries, what adjoins; no roofs, skylights and shades",
    },
    recognises,
    near_miss: |_| None,
    read: |path, options| read(path, options.words),
    furniture: None,
};
/// Bytes at the start of a file in which a small model shows what it is.
const HEAD_SIZE: u64 = 16 * 1024;
/// Bytes of a large one, whose constructions and schedules may stand before its rooms.
const LARGE_HEAD_SIZE: u64 = 1024 * 1024;
/// Words of which one stands in each model of any size, and in no other format.
const TELLING: [&str; 6] = [
    "\"ModelProperties\"",
    "\"ModelEnergyProperties\"",
    "\"Room2D\"",
    "\"unique_stories\"",
    "\"RoomPropertiesAbridged\"",
    "\"FacePropertiesAbridged\"",
];
/// Units of models, as the schema spells them.
const UNITS: [&str; 5] = ["Meters", "Millimeters", "Feet", "Inches", "Centimeters"];

/// Whether a file is JSON with the types of a model.
fn recognises(path: &Path) -> bool {
    if path.is_dir() {
        return false;
    }
    let small = Sample::read(path, HEAD_SIZE);
    if !small.is_object() || small.is_geojson() {
        return false;
    }
    let is_longer = || small.head.len() as u64 == HEAD_SIZE;
    small.holds_one_of(&TELLING)
        || (is_longer() && Sample::read(path, LARGE_HEAD_SIZE).holds_one_of(&TELLING))
}

fn read(path: &Path, words: &RoomWords) -> ReadResult {
    let source = Source::read(path)?;
    let model: Model = source.parse()?;
    let mut notes = Notes::new(source);
    let stem = id_of_file(path, "model");
    let Some(unit) = checked(&model, &mut notes) else { return Err(notes.finish()) };
    let mut naming = Naming::new(words, NAME);
    let mut drafted = Vec::new();
    let mut add = |id: String, name: Option<&String>, levels| {
        let draft = BuildingDraft { name: name.cloned(), levels, ..BuildingDraft::default() };
        drafted.push(DraftedBuilding { id, draft, is_settled: true, ..DraftedBuilding::default() });
    };
    let buildings = model.buildings.as_deref().unwrap_or_default();
    let mut ids = UniqueIds::default();
    for (number, building) in buildings.iter().enumerate() {
        let place = vec!["buildings".into(), number.into()];
        let storeys = storeys_of(building, unit, &place, &mut notes);
        let levels = level::drafts(storeys, &mut naming, &mut notes);
        let id = if buildings.len() == 1 {
            stem.clone()
        } else {
            building_id(building, &stem, number + 1, &mut ids)
        };
        add(id, building.display_name.as_ref(), levels);
    }
    if let Some(rooms) = model.rooms.as_ref().filter(|rooms| !rooms.is_empty()) {
        let place = vec!["rooms".into()];
        let spaces = room3d::spaces(rooms, unit, &place, &mut notes);
        let levels = level::drafts(storeys::storeys(spaces, &place), &mut naming, &mut notes);
        add(stem, model.display_name.as_ref(), levels);
    }
    // All by the same: buildings keep their places to each other.
    let by = recentring(drafted.iter().flat_map(|building| &building.draft.levels));
    drafted.iter_mut().flat_map(|building| &mut building.draft.levels).for_each(|level| shift(level, by));
    for (place, message, hint) in naming.unknown() {
        notes.warn(place, message, &hint);
    }
    let has_rooms = drafted.iter().any(|building| !building.draft.levels.is_empty());
    let mut faults = notes.finish();
    if !has_rooms && !faults.has_errors() {
        let hint = "plenums alone are left out";
        faults.push(Fault::of_file(path, "the model has no room to furnish").with_hint(hint));
    }
    ReadBuildings::new(drafted, faults)
}

/// The metres of a length of 1, if the file is a model of something.
fn checked(model: &Model, notes: &mut Notes) -> Option<f64> {
    let kind = model.kind.as_deref().unwrap_or("Model");
    if kind != "Model" {
        let hint = "export a whole model: DF Model or HB Model, then DF Dump or HB Dump";
        notes.error(&vec!["type".into()], format!("is a {kind}, no Model"), hint);
        return None;
    }
    let is_empty =
        model.buildings.as_ref().is_none_or(Vec::is_empty) && model.rooms.as_ref().is_none_or(Vec::is_empty);
    if is_empty {
        notes.error(&Vec::new(), "the model has neither buildings nor rooms", "add rooms to it");
        return None;
    }
    let word = model.units.as_deref().unwrap_or(UNITS[0]);
    let unit = model_unit(word);
    if unit.is_none() {
        let known = UNITS.map(str::to_owned);
        let hint =
            did_you_mean(word, known.iter()).unwrap_or_else(|| format!("known are {}", UNITS.join(", ")));
        notes.error(&vec!["units".into()], format!("unknown unit \"{word}\""), &hint);
    }
    unit
}

/// The storeys of a building of dragonfly; its rooms that are bodies stand on the storeys that they name.
fn storeys_of(building: &Building, unit: f64, place: &Place, notes: &mut Notes) -> Vec<Storey> {
    let stories = building.unique_stories.as_deref().unwrap_or_default();
    let mut storeys = room2d::storeys(stories, unit, place, notes);
    let Some(rooms) = building.room_3ds.as_ref().filter(|rooms| !rooms.is_empty()) else { return storeys };
    let place = part(place, ["room_3ds".into()]);
    let bodies = room3d::spaces(rooms, unit, &place, notes);
    storeys::add(bodies, &mut storeys, &place);
    storeys
}

/// A name that reads well in paths; `number` counts the buildings of the file from 1.
fn building_id(building: &Building, stem: &str, number: usize, ids: &mut UniqueIds) -> String {
    let name = building.display_name.as_deref().unwrap_or(&building.identifier);
    let own = [slug(name), slug(&building.identifier), format!("{stem}_{number}")];
    // Without a number it is the id of the building of the rooms that no building has.
    let copies = (2..).map(|number| format!("{stem}_{number}"));
    ids.first_free(own.into_iter().chain(copies)).unwrap_or_else(|| stem.to_owned())
}
