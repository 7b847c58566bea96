//! The inputs of the levels of a list, for the merge of a city's records: a list in whole takes ten times as much memory as all that
//! is kept of the records.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{BufReader, Read};
use std::path::Path;

use serde::Deserialize;
use serde::de::IgnoredAny;

use super::level_list::{LevelList, check_program};
use super::manifest::LARGEST_RECORDS;
use super::record::LevelKey;
use crate::disk::open_regular;
use crate::document::Faults;

/// The inputs of each level of a list.
pub struct ListedInputs(pub(super) BTreeMap<LevelKey, Box<str>>);

/// A list of which only the inputs are kept.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct List {
    program: String,
    #[serde(default, rename = "sources")]
    _sources: IgnoredAny,
    levels: Vec<Level>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Level {
    building: String,
    level: String,
    #[serde(rename = "path")]
    _path: IgnoredAny,
    inputs: Box<str>,
    #[serde(rename = "rooms")]
    _rooms: IgnoredAny,
}

impl ListedInputs {
    /// Reads a list as [`LevelList::read`] does, value by value: its text is never in memory.
    ///
    /// # Errors
    /// As [`LevelList::read`].
    pub fn read(path: &Path) -> Result<Self, Faults> {
        let Some(list) = open_regular(path).ok().and_then(|(file, _)| read_json(file)) else {
            // The slow reader knows what is wrong with it, and other formats.
            return LevelList::read(path).map(|list| Self::of(&list));
        };
        check_program(path, &list.program)?;
        let levels = list.levels.into_iter();
        Ok(Self(
            levels
                .map(|Level { building, level, inputs, .. }| (LevelKey { building, level }, inputs))
                .collect(),
        ))
    }

    fn of(list: &LevelList) -> Self {
        let levels = list.levels.iter();
        Self(levels.map(|level| (level.key(), level.inputs.clone().into_boxed_str())).collect())
    }
}

fn read_json(file: File) -> Option<List> {
    serde_json::from_reader(BufReader::new(file.take(LARGEST_RECORDS))).ok()
}
