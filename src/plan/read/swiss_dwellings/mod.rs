//! Swiss Dwellings: tables of apartment buildings (`geometries.csv`), and Modified Swiss Dwellings, which were made of them.
//!
//! One row of the table is an element of a floor: an area, a separator (wall, railing, column), an opening (door, entrance door,
//! window) or a feature (kitchen, toilet, stairs, ...), as a polygon in well-known text, in metres, y up. Floors of one
//! `building_id` are the levels of one building, by elevation. The words are those of the program that the data set was made with,
//! and floors become levels as there (`archilyse/`).
//!
//! The table of the data set has 3.3 million rows in no order. It is read once from beginning to end; rows of floors that are not
//! chosen (`--only`) are passed over, and of those that are, elements are kept, up to [a limit](mod@gather).
//!
//! Sources of the columns: the description of the data set (Standfest et al., Swiss Dwellings 3.0.0, Zenodo 7788422), and programs
//! that read it: github.com/caspervanengelenburg/msd (columns, all subtypes, and those of MSD with `geom`, `zoning`, `roomtype`).

mod columns;
mod elements;
mod fixtures;
mod gather;
mod notes;
mod records;
mod room_types;
mod selection;
mod storey;

#[cfg(test)]
mod tests;

use std::path::Path;

use self::columns::Columns;
use self::elements::{Element, NAME};
use self::gather::{Buildings, gather};
use self::notes::Notes;
use self::room_types::RoomTypes;
use self::selection::Selection;
use self::storey::Storey;
use super::drawn::DrawnPiece;
use super::foreign::head;
use super::reader::{DraftedBuilding, ForeignFormat, ReadBuildings, ReadFormat, ReadResult};
use crate::document::{Fault, Faults, counted};
use crate::plan::limits::BUILDING_LEVELS;
use crate::plan::{BuildingDraft, LevelDraft, PlanOptions};

/// The line of the table of readers.
pub(crate) const FORMAT: ForeignFormat = ForeignFormat {
    about: ReadFormat {
        name: NAME,
        title: "Swiss Dwellings and MSD",
        input: "geometries.csv, or a table with its columns, of any size",
        content: "areas, walls, railings, columns, doors, windows, flats, levels; kitchens and baths with `import --keep-furniture`; floors by --only",
    },
    recognises: |path| !path.is_dir() && Columns::are_in(&head(path, HEAD_SIZE)),
    near_miss: |_| None,
    read,
    furniture: Some(furniture),
};
/// Bytes at the start of a table in which the names of its columns stand.
const HEAD_SIZE: u64 = 4096;
/// By which the data set asks to be named.
const ATTRIBUTION: &str = "Swiss Dwellings by Archilyse AG, CC BY 4.0";

/// Reads the chosen floors of a table.
fn read(path: &Path, options: &PlanOptions<'_>) -> ReadResult {
    let mut notes = Notes::new(path);
    let buildings = gather(path, &selection(options), &mut notes)?;
    let mut types = RoomTypes::new(options.words);
    let mut furniture: Option<(usize, usize)> = None;
    let mut drafted = Vec::with_capacity(buildings.len());
    let mut kept = options.keeps_furniture.then(Vec::new);
    for (building, storeys) in storeys_of(buildings, &mut notes) {
        for piece in storeys
            .iter()
            .flat_map(|storey| &storey.elements)
            .filter(|element| fixtures::is_furniture(element))
        {
            let (line, count) = furniture.get_or_insert((piece.line, 0));
            (*line, *count) = (piece.line.min(*line), *count + 1);
        }
        if let Some(kept) = &mut kept {
            kept.extend(pieces_of(&building, &storeys));
        }
        let draft = BuildingDraft {
            attribution: Some(ATTRIBUTION.to_owned()),
            levels: levels(&storeys, &mut types, &mut notes),
            ..BuildingDraft::default()
        };
        drafted.push(DraftedBuilding { id: building, draft, is_settled: true, ..DraftedBuilding::default() });
    }
    notes.unknown_words(RoomTypes::SECTION, &types.unknown);
    if let Some((line, count)) = furniture.filter(|_| !options.keeps_furniture) {
        let message = format!("{} of furniture left out: rooms are furnished anew", counted(count, "piece"));
        notes.warn(
            line,
            &message,
            "`import --keep-furniture` keeps what the catalogue has, kitchens and baths first",
        );
    }
    let mut faults = notes.finish();
    if drafted.is_empty() && !faults.has_errors() {
        faults.push(
            Fault::of_file(path, "the table has no rows").with_hint("one line for each element is needed"),
        );
    }
    ReadBuildings::new(drafted, faults).map(|read| ReadBuildings { furniture: kept, ..read })
}

/// The furniture of the chosen floors.
fn furniture(path: &Path, options: &PlanOptions<'_>) -> Result<Vec<DrawnPiece>, Faults> {
    let mut notes = Notes::new(path);
    let buildings = gather(path, &selection(options), &mut notes)?;
    let storeys = storeys_of(buildings, &mut notes);
    Ok(storeys.iter().flat_map(|(building, storeys)| pieces_of(building, storeys)).collect())
}

/// The furniture of the storeys of a building.
fn pieces_of(building: &str, storeys: &[Storey]) -> Vec<DrawnPiece> {
    storeys.iter().flat_map(|storey| fixtures::pieces(storey, building)).collect()
}

/// The floors that `--only` names.
fn selection(options: &PlanOptions<'_>) -> Selection {
    options.planning.map_or_else(Selection::default, |planning| Selection::of(&planning.choices.only))
}

/// The storeys of each building, lowest first, by the id that the building gets.
fn storeys_of(buildings: Buildings, notes: &mut Notes) -> Vec<(String, Vec<Storey>)> {
    let storeys = |(building, floors): (String, std::collections::BTreeMap<String, Vec<Element>>)| {
        let mut storeys: Vec<Storey> =
            floors.into_iter().map(|(floor, elements)| Storey::of(&floor, elements)).collect();
        storeys.sort_by(|one, two| one.elevation.total_cmp(&two.elevation).then_with(|| one.id.cmp(&two.id)));
        if let Some(first) = storeys.get(BUILDING_LEVELS) {
            let message = format!("building {building} has {}", counted(storeys.len(), "floor"));
            let line = first.elements.first().map_or(1, |element| element.line);
            notes.error_of_row(line, &message, &format!("the lowest {BUILDING_LEVELS} are read"));
            storeys.truncate(BUILDING_LEVELS);
        }
        (format!("building_{building}"), storeys)
    };
    buildings.into_iter().map(storeys).collect()
}

/// The levels of a building; floors without an area are none.
fn levels(storeys: &[Storey], types: &mut RoomTypes<'_>, notes: &mut Notes) -> Vec<LevelDraft> {
    let level = |(number, storey): (usize, &Storey)| {
        let above = storeys.get(number + 1).map(|above| above.elevation - storey.elevation);
        storey.draft(above, types, notes)
    };
    storeys.iter().enumerate().map(level).filter(|draft| !draft.rooms.is_empty()).collect()
}
