//! The elements of floors: one row of the table each.

use csv::ByteRecord;

use super::columns::{Column, Columns};
use super::notes::Notes;
use super::records::line_of;
use crate::geometry::Bounds;
use crate::plan::limits::{COORDINATE, is_place};
use crate::plan::read::archilyse::areas::{Outline, outlines};

/// The format's word, and that of its furniture in `room_words.yaml`.
pub(super) const NAME: &str = "swiss_dwellings";
/// The hash of an empty text (MD5), which stands for no apartment.
const NO_APARTMENT: &str = "d41d8cd98f00b204e9800998ecf8427e";
/// Letters of an apartment's hash by which it is told from others of its building.
const APARTMENT_LETTERS: usize = 8;

/// What an element is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Entity {
    Area,
    Separator,
    Opening,
    Feature,
}

impl Entity {
    fn of(word: &str) -> Option<Self> {
        match word.to_ascii_lowercase().as_str() {
            "area" => Some(Self::Area),
            "separator" => Some(Self::Separator),
            "opening" => Some(Self::Opening),
            "feature" => Some(Self::Feature),
            _ => None,
        }
    }
}

/// One element of a floor; lengths in metres.
#[derive(Clone, Debug)]
pub(super) struct Element {
    /// Line of its row.
    pub(super) line: usize,
    pub(super) entity: Entity,
    /// In capitals, as the data set writes it.
    pub(super) subtype: Box<str>,
    /// At least one, each of at least three corners, none of them further away than plans reach.
    pub(super) outlines: Vec<Outline>,
    pub(super) elevation: Option<f64>,
    pub(super) height: Option<f64>,
    /// Of areas.
    pub(super) area_id: Option<i64>,
    /// The apartment that it belongs to.
    pub(super) dwelling: Option<String>,
}

impl Element {
    /// The element of a row; `None` if it is left out, which is noted.
    pub(super) fn of(record: &ByteRecord, columns: &Columns, notes: &mut Notes) -> Option<Self> {
        let line = line_of(record);
        let mut text = |column: Column| match columns.text(record, column) {
            Ok(text) => Some(text.unwrap_or_default()),
            Err(message) => {
                notes.error(line, column, &message, "save the table in UTF-8");
                None
            }
        };
        let (word, subtype, geometry) =
            (text(Column::Type)?, text(Column::Subtype)?, text(Column::Geometry)?);
        let (apartment, unit, area) = (text(Column::Apartment)?, text(Column::Unit)?, text(Column::Area)?);
        let (elevation, height) = (text(Column::Elevation)?, text(Column::Height)?);
        let Some(entity) = Entity::of(word) else {
            notes.unknown_kind(line, word);
            return None;
        };
        let outlines = match sound_outlines(geometry) {
            Ok(outlines) => outlines,
            Err(message) => {
                let hint = "POLYGON ((x y, ...)) in metres is needed; the row is left out";
                notes.error(line, Column::Geometry, &message, hint);
                return None;
            }
        };
        let mut number = |column: Column, text: &str| match text.parse::<f64>() {
            Ok(value) if value.is_finite() => Some(value),
            _ if text.is_empty() => None,
            _ => {
                notes.error(
                    line,
                    column,
                    &format!("\"{text}\" is no number"),
                    "metres are needed; the row is left out",
                );
                None
            }
        };
        let is_number_missing = |text: &str, value: Option<f64>| !text.is_empty() && value.is_none();
        let elevation = (elevation, number(Column::Elevation, elevation));
        let height = (height, number(Column::Height, height));
        if is_number_missing(elevation.0, elevation.1) || is_number_missing(height.0, height.1) {
            return None;
        }
        Some(Self {
            line,
            entity,
            subtype: subtype.to_ascii_uppercase().into(),
            outlines,
            elevation: elevation.1,
            height: height.1,
            area_id: plain_id(area).parse().ok(),
            dwelling: dwelling(apartment, unit),
        })
    }

    /// The box around its first outline.
    pub(super) fn bounds(&self) -> Bounds {
        Bounds::around(self.outlines[0].outer.iter().copied())
    }
}

/// An id without the `.0` of tables that were written as numbers.
pub(super) fn plain_id(text: &str) -> &str {
    text.strip_suffix(".0").unwrap_or(text)
}

/// The apartment of a row, in a word: the same on all floors of a building.
fn dwelling(apartment: &str, unit: &str) -> Option<String> {
    if apartment == NO_APARTMENT {
        return None;
    }
    let short: String = plain_id(apartment).chars().take(APARTMENT_LETTERS).collect();
    match (short.is_empty(), unit.is_empty()) {
        (false, _) => Some(format!("apartment {short}")),
        (true, false) => Some(format!("unit {}", plain_id(unit))),
        (true, true) => None,
    }
}

/// The outlines of a text, those that have corners.
fn sound_outlines(text: &str) -> Result<Vec<Outline>, String> {
    let mut found = outlines(text)?;
    found.retain(|outline| outline.outer.len() >= 3);
    if found.is_empty() {
        return Err("has no corners".to_owned());
    }
    let corners =
        || found.iter().flat_map(|outline| outline.outer.iter().chain(outline.holes.iter().flatten()));
    match corners().find(|corner| !is_place(**corner)) {
        Some(corner) => Err(format!("corner ({}, {}) is more than {COORDINATE} m away", corner.x, corner.y)),
        None => Ok(found),
    }
}
