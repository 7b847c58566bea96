//! Reads the tables of a site: JSON lists, row by row if one row is faulty.

use std::path::Path;

use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::Value;

use crate::document::{Faults, Source};

/// A table as far as it could be read.
pub(super) struct Table<T> {
    /// Its file.
    pub(super) source: Source,
    /// By place in the file; `None` for faulty rows.
    rows: Vec<Option<T>>,
}

impl<T> Table<T> {
    /// The sound rows with their places in the file.
    pub(super) fn rows(&self) -> impl Iterator<Item = (usize, &T)> {
        self.rows.iter().enumerate().filter_map(|(index, row)| Some((index, row.as_ref()?)))
    }

    /// The sound rows.
    pub(super) fn into_rows(self) -> Vec<T> {
        self.rows.into_iter().flatten().collect()
    }
}

impl<T> Table<T>
where
    T: for<'de> Deserialize<'de> + JsonSchema,
{
    /// Reads a file; what is wrong with its rows is added to the faults, and those rows are left out.
    ///
    /// # Errors
    /// If the file cannot be read or has no sound row.
    pub(super) fn read(file: &Path, faults: &mut Faults) -> Result<Self, Faults> {
        let source = Source::read(file)?;
        let rows = match source.parse::<Vec<T>>() {
            Ok(rows) => rows.into_iter().map(Some).collect(),
            Err(found) => {
                let Some(rows) = sound_rows(&source) else { return Err(found) };
                faults.merge(found);
                rows
            }
        };
        Ok(Self { source, rows })
    }
}

/// The rows that can be read by themselves; `None` if none can, or the file is no list at all.
fn sound_rows<T: for<'de> Deserialize<'de>>(source: &Source) -> Option<Vec<Option<T>>> {
    let rows: Vec<Value> = serde_json::from_str(source.text()).ok()?;
    let rows: Vec<Option<T>> = rows.into_iter().map(|row| serde_json::from_value(row).ok()).collect();
    rows.iter().any(Option::is_some).then_some(rows)
}
