//! Reads the native format, YAML or JSON.

mod built;
mod check;
mod expand;
mod file;
mod ids;
mod level_parts;
mod motion;
mod numbers;
mod openings;
mod origins;
mod parts;
mod pattern;
mod report;
mod scope;
mod styles;
mod units;

use crate::disk::unpacked_name;
use crate::document::{Faults, Source, suggest};
use crate::plan::{BuildingDraft, RoomWords};

pub(crate) use built::NativeChecks;
pub(crate) use file::{PlanFile, VERSION};
pub(crate) use ids::{FILE_NAME_FORBIDDEN, NODE_NAME_FORBIDDEN, id_fault};
pub(crate) use numbers::number_of_id;
pub(crate) use origins::{LevelOrigins, ProblemList};
pub(crate) use pattern::{PatternValues, expand as expand_pattern, names_value};
pub(crate) use report::{Report, item, step};
pub(crate) use styles::check_style;

/// A native plan as drafts, and where everything stands in its file.
pub(crate) struct NativeDraft {
    /// Id of the building.
    pub(crate) id: String,
    /// Its levels, prototypes placed and levels repeated.
    pub(crate) draft: BuildingDraft,
    /// By level of the draft.
    pub(crate) origins: Vec<LevelOrigins>,
    /// Faults that do not stop the furnishing: styles that do not exist.
    pub(crate) faults: Faults,
}

/// Reads a native plan.
///
/// # Errors
/// All faults of the file that show before rooms are put together: syntax, keys, types, numbers, ids and
/// names of rooms, prototypes and room types.
pub(crate) fn read_native(source: &Source, words: &RoomWords) -> Result<NativeDraft, Faults> {
    let file: PlanFile = source.parse()?;
    let mut report = Report::new(source);
    let left_out = check::check_file(&file, words, &mut report);
    let expanded = expand::expand_building(&file, &left_out, &mut report);
    let id = building_id(&file, &mut report);
    let is_usable = !report.is_useless();
    let mut faults = report.finish();
    let mut report = Report::new(source);
    styles::check_styles(&file, words, &mut report);
    faults.merge(report.finish());
    let expand::Expanded { mut draft, origins } = expanded;
    styles::drop_unknown(&mut draft, words);
    if is_usable { Ok(NativeDraft { id, draft, origins, faults }) } else { Err(faults) }
}

/// Whether a text is to be a plan: it has one of its keys, one much like them, or such errors that none can be told.
pub(crate) fn may_be_plan(source: &Source) -> bool {
    const KEYS: [&str; 9] =
        ["version", "id", "units", "style", "walls", "outlines", "prototypes", "levels", "project"];
    let keys = source.top_keys();
    keys.iter().any(|key| KEYS.contains(&key.as_str()) || suggest(key, ["levels", "project"]).is_some())
        || !source.is_sound()
}

fn building_id(file: &PlanFile, report: &mut Report<'_>) -> String {
    let stem =
        unpacked_name(report.source().file()).file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let id = file.id.clone().unwrap_or(stem);
    if let Some(message) = id_fault(&id, FILE_NAME_FORBIDDEN) {
        let hint = match file.id {
            Some(_) => "it names a folder of the output",
            None => {
                "without an `id`, the plan has that of its file, and it names a folder of the output: rename the file or write `id:`"
            }
        };
        report.error(&["id".into()], message, Some(hint.to_owned()));
    }
    id
}
