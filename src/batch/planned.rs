//! Lists the levels of a plan.

use std::collections::BTreeMap;
use std::path::PathBuf;

use super::job::list_jobs;
use super::level_list::{LevelList, PlannedLevel};
use super::program::PROGRAM;
use super::work::BakeInput;

/// The levels of a plan, in the order of the manifest.
pub(crate) fn planned_levels(input: &BakeInput<'_>, sources: Vec<PathBuf>) -> LevelList {
    let jobs = list_jobs(input.plan, input.edits, input.catalog, &input.options.level);
    let levels = jobs.into_iter().map(|job| {
        let mut rooms = BTreeMap::new();
        for room in &job.homes.apply(job.level).rooms {
            *rooms.entry(room.room_type.clone()).or_default() += 1;
        }
        let (building, level) = (job.placed.id.clone(), job.level.id.clone());
        PlannedLevel { building, level, path: job.path, inputs: job.inputs, rooms }
    });
    LevelList { program: PROGRAM.to_owned(), sources, levels: levels.collect() }
}
