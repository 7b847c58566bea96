//! The levels of a plan as a list: `bake --list-levels` writes it, so that drivers of many machines can cut the work by its cost;
//! `--only-levels` and `merge --levels` read it.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::program::PROGRAM;
use super::record::LevelKey;
use crate::document::{Fault, Faults, Source};

/// Levels of a plan.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "Levels of a plan")]
pub struct LevelList {
    /// The program that lists them: version and hash of its sources.
    pub program: String,
    /// Files and folders that the plan was read from.
    #[serde(default)]
    pub sources: Vec<PathBuf>,
    /// The levels, sorted by building and level.
    pub levels: Vec<PlannedLevel>,
}

/// A level that is to be baked.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlannedLevel {
    /// Building id.
    pub building: String,
    /// Level id.
    pub level: String,
    /// `<building>/<level>` in the output folder, without extension.
    pub path: String,
    /// Hash of all that the level is made from, the program excepted.
    pub inputs: String,
    /// Rooms by room type, after the people of each dwelling have shared out its rooms.
    pub rooms: BTreeMap<String, u64>,
}

impl PlannedLevel {
    /// Building id and level id.
    pub(crate) fn key(&self) -> LevelKey {
        LevelKey { building: self.building.clone(), level: self.level.clone() }
    }
}

impl LevelList {
    /// Reads a list.
    ///
    /// # Errors
    /// All faults of the file; one if another program has listed the levels.
    pub fn read(path: &Path) -> Result<Self, Faults> {
        let list: Self = Source::read(path)?.parse()?;
        check_program(path, &list.program)?;
        Ok(list)
    }

    /// The inputs of each level.
    pub(crate) fn inputs(&self) -> BTreeMap<LevelKey, &str> {
        self.levels.iter().map(|level| (level.key(), level.inputs.as_str())).collect()
    }
}

/// Refuses a list that another program has made.
pub(super) fn check_program(path: &Path, program: &str) -> Result<(), Faults> {
    if program == PROGRAM {
        return Ok(());
    }
    let message = format!("lists levels for the program {program}, and this is {PROGRAM}");
    let hint = "list the levels with this program: `roomwright bake … --list-levels --json`";
    Err(Fault::of_file(path, message).with_hint(hint).into())
}

/// Levels to bake, by name, in place of a share that is dealt.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ChosenLevels {
    /// The file that names them.
    pub file: PathBuf,
    /// The levels.
    pub list: LevelList,
}
