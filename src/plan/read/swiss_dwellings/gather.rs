//! Gathers the rows of the chosen floors in one pass over the table, in whatever order they stand.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use csv::ByteRecord;

use super::columns::{Column, Columns};
use super::elements::{Element, plain_id};
use super::notes::Notes;
use super::records::{Records, line_of};
use super::selection::{Ids, Selection};
use crate::document::{Fault, Faults, counted};

/// Rows of all chosen floors, and bytes of their texts. Importing 391,000 rows takes 415 MB of memory; the published table has 3.3
/// million.
const MOST_ROWS: usize = 400_000;
const MOST_TEXT: usize = 256 << 20;
/// Ids of buildings and floors that are counted for a message.
const MOST_IDS: usize = 100_000;
/// Letters of the longest id.
const LONGEST_ID: usize = 40;

/// The elements of a floor by the id of the floor, by the id of the building.
pub(super) type Buildings = BTreeMap<String, BTreeMap<String, Vec<Element>>>;

/// Reads the floors that are chosen.
///
/// # Errors
/// If the file cannot be read at all, nothing is chosen, or so much that it is not held in memory.
pub(super) fn gather(path: &Path, selection: &Selection, notes: &mut Notes) -> Result<Buildings, Faults> {
    let (mut records, names) = Records::open(path)?;
    let columns = Columns::of(path, &names)?;
    let mut gathering = Gathering::default();
    let mut record = ByteRecord::new();
    loop {
        match records.next(path, &mut record) {
            Ok(true) => gathering.add(&record, &columns, selection, notes),
            Ok(false) => break,
            Err(fault) => {
                notes.fatal(fault);
                break;
            }
        }
    }
    gathering.finish(path)
}

#[derive(Default)]
struct Gathering {
    buildings: Buildings,
    rows: usize,
    text: usize,
    /// Whether more was chosen than is held in memory: then nothing is kept, and the rest is only counted.
    is_excessive: bool,
    /// The chosen ones, and all others.
    chosen: Counted,
    seen: Counted,
}

/// The ids of buildings and floors, as far as they are counted.
#[derive(Default)]
struct Counted {
    buildings: BTreeSet<String>,
    floors: BTreeSet<String>,
}

impl Counted {
    fn add(&mut self, ids: Ids<'_>) {
        add_id(&mut self.buildings, ids.building);
        add_id(&mut self.floors, ids.floor);
    }
}

fn add_id(known: &mut BTreeSet<String>, id: &str) {
    if known.len() < MOST_IDS && !known.contains(id) {
        known.insert(id.to_owned());
    }
}

impl Gathering {
    fn add(&mut self, record: &ByteRecord, columns: &Columns, selection: &Selection, notes: &mut Notes) {
        if record.len() != columns.count {
            let message = format!("the row has {} fields, the table {}", record.len(), columns.count);
            notes.error_of_row(line_of(record), &message, "the row is left out; is a comma not in quotes?");
            return;
        }
        let Some(ids) = ids_of(record, columns, notes) else { return };
        self.seen.add(ids);
        if !selection.holds(ids) {
            return;
        }
        self.chosen.add(ids);
        self.rows += 1;
        self.text += record.as_slice().len();
        if self.rows > MOST_ROWS || self.text > MOST_TEXT {
            self.is_excessive = true;
            self.buildings.clear();
        }
        if self.is_excessive {
            return;
        }
        let Some(element) = Element::of(record, columns, notes) else { return };
        if !self.buildings.contains_key(ids.building) {
            self.buildings.insert(ids.building.to_owned(), BTreeMap::new());
        }
        let Some(floors) = self.buildings.get_mut(ids.building) else { return };
        match floors.get_mut(ids.floor) {
            Some(elements) => elements.push(element),
            None => drop(floors.insert(ids.floor.to_owned(), vec![element])),
        }
    }

    fn finish(self, path: &Path) -> Result<Buildings, Faults> {
        let example = self.seen.buildings.first().map_or("2357", String::as_str);
        let hint = format!(
            "choose with --only: site_…, building_… or floor_… with the ids of the table, as `--only building_{example}`"
        );
        let size = |counted_ids: &Counted| {
            let more = if counted_ids.floors.len() >= MOST_IDS { "more than " } else { "" };
            let floors = counted(counted_ids.floors.len(), "floor");
            format!("{more}{floors} of {}", counted(counted_ids.buildings.len(), "building"))
        };
        if self.is_excessive {
            let message = format!("{} are more than are read at once", size(&self.chosen));
            return Err(Fault::of_file(path, message).with_hint(hint).into());
        }
        if self.rows == 0 && !self.seen.floors.is_empty() {
            let message = format!("none of its {} is chosen", size(&self.seen));
            return Err(Fault::of_file(path, message).with_hint(hint).into());
        }
        Ok(self.buildings)
    }
}

/// The ids of a row; `None` if it has none, which is noted.
fn ids_of<'a>(record: &'a ByteRecord, columns: &Columns, notes: &mut Notes) -> Option<Ids<'a>> {
    let mut id = |column: Column| {
        let text = columns.text(record, column).ok().flatten().map_or("", plain_id);
        let is_plain = |letter: u8| letter.is_ascii_alphanumeric() || matches!(letter, b'-' | b'_');
        let is_id = !text.is_empty() && text.len() <= LONGEST_ID && text.bytes().all(is_plain);
        let is_site = column == Column::Site;
        if !is_id && !is_site {
            let hint = "letters, digits, - and _ make an id; the row is left out";
            notes.error(line_of(record), column, &format!("\"{text}\" is no id"), hint);
        }
        (is_id || is_site).then_some(text)
    };
    let (site, building, floor) = (id(Column::Site)?, id(Column::Building)?, id(Column::Floor)?);
    Some(Ids { site, building, floor })
}
