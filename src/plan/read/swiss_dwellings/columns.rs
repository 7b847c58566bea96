//! The columns of the table, by name: Swiss Dwellings and Modified Swiss Dwellings name the geometry differently, and the latter
//! has columns of its own.

use std::path::Path;

use csv::ByteRecord;

use crate::document::{Fault, Faults};

/// A column that is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Column {
    Site,
    Building,
    Floor,
    Apartment,
    Unit,
    Area,
    Type,
    Subtype,
    Geometry,
    Elevation,
    Height,
}

use Column::{Apartment, Area, Building, Elevation, Floor, Geometry, Height, Site, Subtype, Type, Unit};

/// All columns that are read, with the names that they have. `geom` is that of Modified Swiss Dwellings.
const COLUMNS: [(Column, &[&str]); 11] = [
    (Site, &["site_id"]),
    (Building, &["building_id"]),
    (Floor, &["floor_id"]),
    (Apartment, &["apartment_id"]),
    (Unit, &["unit_id"]),
    (Area, &["area_id"]),
    (Type, &["entity_type"]),
    (Subtype, &["entity_subtype"]),
    (Geometry, &["geometry", "geom"]),
    (Elevation, &["elevation"]),
    (Height, &["height"]),
];
/// The columns without which there is no plan.
const NEEDED: [Column; 5] = [Building, Floor, Type, Subtype, Geometry];

/// Where the columns of a table stand.
#[derive(Clone, Debug)]
pub(super) struct Columns {
    /// How many columns the table has.
    pub(super) count: usize,
    places: [Option<usize>; COLUMNS.len()],
}

impl Columns {
    /// Of the first record of a table.
    ///
    /// # Errors
    /// The columns that are missing, all in one.
    pub(super) fn of(path: &Path, names: &ByteRecord) -> Result<Self, Faults> {
        let columns = Self::find(names);
        let missing: Vec<&str> = NEEDED
            .iter()
            .filter(|column| columns.place(**column).is_none())
            .map(|column| name(*column))
            .collect();
        if missing.is_empty() {
            return Ok(columns);
        }
        let message = format!("the table has no column {}", missing.join(" and no "));
        let fault = Fault { position: Some((1, 1)), ..Fault::of_file(path, message) };
        Err(fault.with_hint("take `geometries.csv` of the data set as it was published").into())
    }

    /// Whether the beginning of a text has all columns that are needed.
    pub(super) fn are_in(head: &[u8]) -> bool {
        let line = head.split(|byte| matches!(byte, b'\n' | b'\r')).next().unwrap_or_default();
        let names: ByteRecord =
            line.split(|byte| *byte == b',').map(<[u8]>::to_vec).collect::<Vec<_>>().into();
        let columns = Self::find(&names);
        NEEDED.iter().all(|column| columns.place(*column).is_some())
    }

    fn find(names: &ByteRecord) -> Self {
        let places = COLUMNS.map(|(_, known)| {
            names.iter().position(|name| {
                let name = name.strip_prefix("\u{feff}".as_bytes()).unwrap_or(name).trim_ascii();
                // Of the beginning of a text, quotes are still there.
                let bare = name.strip_prefix(b"\"").and_then(|rest| rest.strip_suffix(b"\""));
                known.iter().any(|known| bare.unwrap_or(name).eq_ignore_ascii_case(known.as_bytes()))
            })
        });
        Self { count: names.len(), places }
    }

    fn place(&self, column: Column) -> Option<usize> {
        self.places[column as usize]
    }

    /// The text of a field without spaces around it; `None` where it is empty or the table has no such column.
    ///
    /// # Errors
    /// If the field is no text.
    pub(super) fn text<'a>(&self, record: &'a ByteRecord, column: Column) -> Result<Option<&'a str>, String> {
        let Some(field) = self.place(column).and_then(|place| record.get(place)) else { return Ok(None) };
        let text = std::str::from_utf8(field).map_err(|_| "is not UTF-8 text".to_owned())?.trim();
        Ok((!text.is_empty()).then_some(text))
    }
}

/// The name of a column, as the original data set has it.
pub(super) fn name(column: Column) -> &'static str {
    COLUMNS[column as usize].1[0]
}
