//! Apartment blocks as react-planner drawings with areas in well-known text.
//!
//! Two things are recognised:
//! - a folder of a site: `react_planner_projects.json`, `areas.json`, `floors.json`, and where present
//!   `plans.json`, `units.json`, `unit_areas.json`, `buildings.json`: one building per entry, all floors;
//! - a drawing `plan_N.json` with its areas in `areas_plan_N.json` beside it or in `../areas/`: a building `plan_N` of
//!   one floor.
//!
//! A faulty area is left out; a floor with a fault, or with a faulty drawing, is left out as a whole; the rest is
//! read.
//!
//! Drawings are in pixels, areas in metres, both in one frame; y points up.

pub(super) mod areas;
pub(super) mod drawing;
pub(super) mod level;
mod rooms;
mod single;
mod site;
mod tables;

#[cfg(test)]
mod tests;

use std::path::Path;

pub(super) use self::rooms::type_of;
use super::foreign::Parts;
use super::sample::Sample;
use crate::plan::RoomWords;
use crate::plan::read::reader::{ForeignFormat, ReadFormat, ReadResult};

/// The format's word in `room_words.yaml`.
pub(super) const NAME: &str = "archilyse";

/// The line of the table of readers.
pub(crate) const FORMAT: ForeignFormat = ForeignFormat {
    about: ReadFormat {
        name: NAME,
        title: "react-planner drawings with areas",
        input: "plan_N.json with areas_plan_N.json beside it or in ../areas; or a folder with \
                react_planner_projects.json, areas.json and floors.json",
        content: "areas, walls, railings, columns, doors and how they open, windows, flats; no furniture",
    },
    recognises,
    near_miss,
    read: |path, options| read(path, options.words),
    furniture: None,
};
/// The file that makes a folder a site.
const SITE_FILE: &str = "react_planner_projects.json";
/// The tables without which there is no site, and others of one.
const NEEDED: [&str; 3] = [SITE_FILE, "areas.json", "floors.json"];
const OPTIONAL: [&str; 4] = ["plans.json", "buildings.json", "units.json", "unit_areas.json"];
const PARTS: Parts = Parts { needed: &NEEDED, others: &OPTIONAL };
/// Bytes at the start of a file by which it is recognised.
const HEAD_SIZE: u64 = 4096;
/// Keys of the drawing's editor, one of which stands at the start of every drawing and of no native plan.
const EDITOR_KEYS: [&str; 2] = ["\"selectedLayer\"", "\"layer-1\""];

/// Whether a file or folder is of this format.
fn recognises(path: &Path) -> bool {
    let is_json = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("json"));
    if !is_json || path.is_dir() {
        return path.join(SITE_FILE).is_file();
    }
    let is_table = path.file_name().is_some_and(|name| name == SITE_FILE);
    let sample = Sample::read(path, HEAD_SIZE);
    // A list of drawings is a table of a site.
    !is_table && sample.is_object() && sample.holds_one_of(&EDITOR_KEYS)
}

/// The fault of a folder that has some tables of a site, with those that are needed.
fn near_miss(folder: &Path) -> Option<(&'static str, Parts)> {
    /// Tables that other programs do not name so.
    const TELLING: usize = 2;
    let tables = NEEDED.iter().chain(&OPTIONAL).filter(|name| folder.join(name).is_file());
    (tables.count() >= TELLING).then_some(("the site of a react-planner", PARTS))
}

/// Reads all buildings of a site, or the one of a drawing.
fn read(path: &Path, words: &RoomWords) -> ReadResult {
    if path.is_dir() { site::read(path, words) } else { single::read(path, words) }
}
