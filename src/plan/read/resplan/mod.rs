//! ResPlan: flats as polygons by class, in JSON.
//!
//! The data set (Abouagour and Garyfallidis, ResPlan, 2025, arXiv 2508.14006; github.com/m-agour/ResPlan) is published as a pickle,
//! which is a program and is not read. Its plans come as JSON in three forms, alone or in a list:
//! - a plan with a key for each class, as it is in the pickle (`docs/importing.md` has the lines that write it);
//! - a plan with these keys under `geometries` (github.com/Xyrces/resPlan.NET);
//! - a plan in metres with `metadata` and `instances`, each of which has a `geom`
//!   (github.com/numanmuttaqi/Geometry-to-Ontology).
//!
//! Geometries are GeoJSON or well-known text, y up. The plans are drawn on a canvas without a scale (256 units); metres come from
//! `net_area`, else from `area`, else from `--scale`.
//!
//! One building of one level for each plan.

mod geometry;
mod level;
mod notes;
mod scale;
mod sheet;

#[cfg(test)]
mod tests;

use std::path::Path;

use serde_json::Value;

use self::level::Classes;
use self::notes::{NAME, Notes};
use self::sheet::sheets;
use super::foreign::{UniqueIds, id_of_file, slug};
use super::reader::{DraftedBuilding, ForeignFormat, ReadBuildings, ReadFormat, ReadResult};
use super::sample::Sample;
use crate::document::{Fault, Source};
use crate::plan::{BuildingDraft, PlanOptions};

/// The line of the table of readers.
pub(crate) const FORMAT: ForeignFormat = ForeignFormat {
    about: ReadFormat {
        name: NAME,
        title: "ResPlan",
        input: "a JSON file with one plan or a list of them, not the pickle",
        content: "rooms, walls, doors, windows; metres by the stated area or --scale; no furniture",
    },
    recognises,
    near_miss: |_| None,
    read,
    furniture: None,
};
/// Bytes at the start of a text in which classes stand: their corners are some kilobytes.
const HEAD_SIZE: u64 = 64 * 1024;
/// Keys of plans, of which other formats have not so many.
const ROOM_KEYS: [&str; 5] = ["\"living\"", "\"bedroom\"", "\"bathroom\"", "\"kitchen\"", "\"balcony\""];
const OTHER_KEYS: [&str; 7] =
    ["\"front_door\"", "\"wall\"", "\"window\"", "\"door\"", "\"inner\"", "\"wall_depth\"", "\"net_area\""];

/// Words of native plans, and of maps with rooms.
const OTHER_FORMATS: [&str; 2] = ["\"levels\"", "\"FeatureCollection\""];
/// Places of a word that are looked at.
const MOST_WORDS: usize = 1_000;

/// Whether a file is of this format: JSON with the name of the data set, or with several of its classes and geometries.
fn recognises(path: &Path) -> bool {
    if path.is_dir() {
        return false;
    }
    is_plan(&Sample::read(path, HEAD_SIZE).text)
}

/// Whether a text begins as a plan does. Maps of rooms have the same words as values of their tags.
fn is_plan(text: &str) -> bool {
    if !text.starts_with(['{', '[']) || OTHER_FORMATS.iter().any(|word| text.contains(word)) {
        return false;
    }
    let is_key = |word: &str| {
        let ends = text.match_indices(word).map(|(at, found)| at + found.len());
        ends.take(MOST_WORDS).any(|end| text[end..].trim_start().starts_with(':'))
    };
    let count = |words: &[&str]| words.iter().filter(|word| is_key(word)).count();
    let is_named = text.contains("\"ResPlan\"") && is_key("\"dataset\"");
    let has_shapes = text.contains("POLYGON") || text.contains("Polygon");
    is_named || (has_shapes && count(&ROOM_KEYS) >= 2 && count(&OTHER_KEYS) >= 1)
}

/// Reads all plans of a file.
fn read(path: &Path, options: &PlanOptions<'_>) -> ReadResult {
    let source = Source::read(path)?;
    let value: Value = source.parse()?;
    let mut notes = Notes::new(source);
    let mut classes = Classes::new(options.words);
    let stem = id_of_file(path, NAME);
    let sheets = sheets(&value, &mut notes);
    let is_single = sheets.len() == 1;
    let given = options.planning.and_then(|planning| planning.choices.metres_per_unit);
    let mut ids = UniqueIds::default();
    let mut drafted = Vec::with_capacity(sheets.len());
    for sheet in &sheets {
        let Some(metres) = scale::metres_per_unit(sheet, given, &mut notes) else { continue };
        let Some(level) = level::draft(sheet, metres, &mut classes, &mut notes) else { continue };
        let own = slug(&sheet.id);
        let id = if is_single || own.is_empty() { stem.clone() } else { format!("{stem}_{own}") };
        let id = ids.numbered(&id);
        let draft = BuildingDraft { levels: vec![level], ..BuildingDraft::default() };
        drafted.push(DraftedBuilding { id, draft, is_settled: true, ..DraftedBuilding::default() });
    }
    classes.report(&mut notes);
    let mut faults = notes.finish();
    if drafted.is_empty() && !faults.has_errors() {
        let hint = "a plan has keys such as \"bedroom\" and \"front_door\" with polygons";
        faults.push(Fault::of_file(path, "the file has no plan with rooms").with_hint(hint));
    }
    ReadBuildings::new(drafted, faults)
}
