//! Finds listed levels among those that are to be baked.

use std::collections::BTreeMap;

use super::fault::{FaultCode, OutputFault};
use super::level_list::ChosenLevels;
use super::record::LevelKey;
use super::task::Task;
use crate::document::counted;

/// Levels that are named one by one in a message.
const NAMED_LEVELS: usize = 5;

/// Which of the jobs are chosen.
///
/// # Errors
/// If a level is not in the plan, or is made from other inputs now than when it was listed: its record would fit no other.
pub(super) fn chosen_among<T: Task>(chosen: &ChosenLevels, jobs: &[T]) -> Result<Vec<bool>, OutputFault> {
    let mut wanted = chosen.list.inputs();
    let is_chosen = |job: &T| match wanted.get(&job.key()) {
        Some(inputs) if *inputs == job.inputs() => wanted.remove(&job.key()).is_some(),
        _ => false,
    };
    let found = jobs.iter().map(is_chosen).collect();
    if wanted.is_empty() {
        return Ok(found);
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
        path: chosen.file.clone(),
        message: format!("{count} cannot be baked as listed: {}{more}", named.join(", ")),
        hint: Some("list the levels with the plans and options that they are baked with".to_owned()),
    })
}
