//! The levels of a plan as a list: `bake --list-levels` writes it, so that drivers of many machines can cut the work by its cost;
//! `--only-levels` and `merge --levels` read it.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::fault::{FaultCode, OutputFault};
use super::job::list_jobs;
use super::program::PROGRAM;
use super::record::LevelKey;
use super::task::Task;
use super::work::BakeInput;
use crate::document::{Fault, Faults, Source, counted};

/// Levels that are named one by one in a message.
const NAMED_LEVELS: usize = 5;

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
    /// The levels of a plan, in the order of the manifest.
    pub(crate) fn of(input: &BakeInput<'_>, sources: Vec<PathBuf>) -> Self {
        let jobs = list_jobs(input.plan, input.edits, input.catalog, &input.options.level);
        let levels = jobs.into_iter().map(|job| {
            let mut rooms = BTreeMap::new();
            for room in &job.homes.apply(job.level).rooms {
                *rooms.entry(room.room_type.clone()).or_default() += 1;
            }
            let (building, level) = (job.placed.id.clone(), job.level.id.clone());
            PlannedLevel { building, level, path: job.path, inputs: job.inputs, rooms }
        });
        Self { program: PROGRAM.to_owned(), sources, levels: levels.collect() }
    }

    /// Reads a list.
    ///
    /// # Errors
    /// All faults of the file; one if another program has listed the levels.
    pub fn read(path: &Path) -> Result<Self, Faults> {
        let list: Self = Source::read(path)?.parse()?;
        if list.program == PROGRAM {
            return Ok(list);
        }
        let message = format!("lists levels for the program {}, and this is {PROGRAM}", list.program);
        let hint = "list the levels with this program: `roomwright bake … --list-levels --json`";
        Err(Fault::of_file(path, message).with_hint(hint).into())
    }

    /// The inputs of each level.
    pub(crate) fn inputs(&self) -> BTreeMap<LevelKey, &str> {
        self.levels.iter().map(|level| (level.key(), level.inputs.as_str())).collect()
    }
}

/// Levels to bake, by name, in place of a share that is dealt.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ChosenLevels {
    /// The file that names them.
    pub file: PathBuf,
    /// The levels.
    pub list: LevelList,
}

impl ChosenLevels {
    /// Which of the jobs are chosen.
    ///
    /// # Errors
    /// If a level is not in the plan, or is made from other inputs now than when it was listed: its record would fit no other.
    pub(super) fn among<T: Task>(&self, jobs: &[T]) -> Result<Vec<bool>, OutputFault> {
        let mut wanted = self.list.inputs();
        let is_chosen = |job: &T| match wanted.get(&job.key()) {
            Some(inputs) if *inputs == job.inputs() => wanted.remove(&job.key()).is_some(),
            _ => false,
        };
        let chosen = jobs.iter().map(is_chosen).collect();
        if wanted.is_empty() {
            return Ok(chosen);
        }
        let known: BTreeMap<LevelKey, &str> = jobs.iter().map(|job| (job.key(), job.inputs())).collect();
        let reason = |key: &LevelKey| match known.contains_key(key) {
            true => "has other inputs now",
            false => "is not in the plans",
        };
        let named = wanted.keys().take(NAMED_LEVELS);
        let named: Vec<String> =
            named.map(|key| format!("{}/{} {}", key.building, key.level, reason(key))).collect();
        let more = if wanted.len() > NAMED_LEVELS { ", …" } else { "" };
        let count = counted(wanted.len(), "level");
        Err(OutputFault {
            code: FaultCode::OtherLevels,
            path: self.file.clone(),
            message: format!("{count} cannot be baked as listed: {}{more}", named.join(", ")),
            hint: Some("list the levels with the plans and options that they are baked with".to_owned()),
        })
    }
}
