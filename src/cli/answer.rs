//! The answers of commands with `--json`. The JSON Schemas of these types are published in `configs/schema/answers/`.

use std::collections::BTreeMap;
use std::path::PathBuf;

use schemars::JsonSchema;
use serde::Serialize;

use super::audit::JudgedLevel;
#[cfg(test)]
use super::navigation::NavigationAnswer;
#[cfg(test)]
use super::plan::{PlanAnswer, ReportFile};
#[cfg(test)]
use super::version::VersionAnswer;
#[cfg(test)]
use super::walk::WalkAnswer;
use crate::audit::AuditSummary;
#[cfg(test)]
use crate::batch::LevelList;
use crate::batch::Totals;
use crate::catalog::Side;
use crate::contract::{ElementId, FindingExtras};
use crate::document::{Fault, Faults, show_path};
use crate::edits::RoomEntry;
use crate::layout::{MissingStory, ObjectStory};
use crate::plan::{InputReport, ReadFormat};

/// A fault of an input.
#[derive(Serialize, JsonSchema)]
pub(crate) struct FaultAnswer {
    /// The file or folder.
    pub(crate) file: String,
    /// Counted from 1; none where the fault is of the whole file.
    pub(crate) line: Option<usize>,
    /// Counted from 1.
    pub(crate) column: Option<usize>,
    /// Where in the document, as `levels[0].rooms[3].outline[2]`.
    pub(crate) path: String,
    /// Whether a part of the input is left out because of it.
    pub(crate) severity: FaultWord,
    /// The fact.
    pub(crate) message: String,
    /// Advice for the user.
    pub(crate) hint: Option<String>,
}

/// How bad a fault is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum FaultWord {
    /// A part of the input is left out.
    Error,
    /// All of the input is used.
    Warning,
}

/// The answers of all faults.
pub(crate) fn fault_answers(faults: &Faults) -> Vec<FaultAnswer> {
    faults.0.iter().map(FaultAnswer::from).collect()
}

impl From<&Fault> for FaultAnswer {
    fn from(fault: &Fault) -> Self {
        Self {
            file: fault.file.display().to_string(),
            line: fault.position.map(|(line, _)| line),
            column: fault.position.map(|(_, column)| column),
            path: show_path(&fault.path),
            severity: if fault.is_error() { FaultWord::Error } else { FaultWord::Warning },
            message: fault.message.clone(),
            hint: fault.hint.clone(),
        }
    }
}

/// `bake`.
#[derive(Serialize, JsonSchema)]
pub(crate) struct BakeAnswer {
    /// The output folder.
    pub(crate) out: String,
    /// The manifest, or the part of one that a shard has written; none where it could not be written.
    pub(crate) manifest: Option<String>,
    /// Whether all levels of the plan are in the manifest.
    pub(crate) is_complete: bool,
    /// Levels that were baked now.
    pub(crate) baked_levels: usize,
    /// Levels that were in place already.
    pub(crate) kept_levels: usize,
    /// Levels that were not tried after the output folder failed.
    pub(crate) skipped_levels: usize,
    /// Sums over all levels that are in place.
    pub(crate) totals: Totals,
    /// Levels and rooms that could not be made.
    pub(crate) failures: Vec<FailureAnswer>,
    /// Edits that do not fit.
    pub(crate) misfits: Vec<MisfitAnswer>,
    /// Files of earlier bakes that the plan has no use for.
    pub(crate) leftovers: LeftoversAnswer,
}

/// A level or a room that could not be made.
#[derive(Serialize, JsonSchema)]
pub(crate) struct FailureAnswer {
    /// The stable word of the failure.
    pub(crate) code: String,
    /// Building id.
    pub(crate) building: String,
    /// Level id.
    pub(crate) level: String,
    /// Room id; none where the whole level failed.
    pub(crate) room: Option<String>,
    /// The fact.
    pub(crate) message: String,
    /// Advice for the user.
    pub(crate) hint: Option<String>,
    /// The seed of the run.
    pub(crate) seed: u64,
}

/// An edit that does not fit.
#[derive(Serialize, JsonSchema)]
pub(crate) struct MisfitAnswer {
    /// Building id.
    pub(crate) building: String,
    /// Level id.
    pub(crate) level: String,
    /// Room id.
    pub(crate) room: String,
    /// Whether it was made all the same.
    pub(crate) is_made: bool,
    /// Where it is written, and what is wrong.
    pub(crate) fault: FaultAnswer,
}

/// Files of earlier bakes.
#[derive(Serialize, JsonSchema)]
pub(crate) struct LeftoversAnswer {
    /// Levels whose files stay.
    pub(crate) levels: Vec<LevelAnswer>,
    /// Shared files that stay although no level uses them.
    pub(crate) files: Vec<String>,
    /// Files that were removed.
    pub(crate) removed: Vec<String>,
    /// Files that were to be removed, but were changed since: they stay, and are listed no longer.
    pub(crate) changed: Vec<String>,
}

/// A level by its ids.
#[derive(Serialize, JsonSchema)]
pub(crate) struct LevelAnswer {
    /// Building id.
    pub(crate) building: String,
    /// Level id.
    pub(crate) level: String,
}

/// A line of `bake --progress json`.
#[derive(Serialize, JsonSchema)]
#[serde(tag = "event", rename_all = "snake_case")]
pub(crate) enum ProgressLine {
    /// The bake begins.
    Started {
        /// Levels to bake.
        levels: usize,
        /// Their rooms.
        rooms: usize,
        /// Levels that are in place already.
        kept_levels: usize,
    },
    /// A level is in place.
    Baked {
        /// Building id.
        building: String,
        /// Level id.
        level: String,
        /// Rooms of the level.
        rooms: u64,
        /// Its pieces of furniture.
        objects: u64,
    },
    /// A level or a room could not be made.
    Failed(FailureAnswer),
    /// The bake is at its end.
    Finished {
        /// Since it began.
        seconds: f64,
        /// Levels that were baked.
        levels: usize,
        /// Levels that were in place already.
        kept_levels: usize,
        /// Rooms that were furnished.
        rooms: u64,
        /// Bytes that were written.
        bytes: u64,
        /// Seconds of all threads together by stage.
        stage_seconds: BTreeMap<String, f64>,
    },
}

/// `check`.
#[derive(Serialize, JsonSchema)]
pub(crate) struct CheckAnswer {
    /// Buildings that could be read.
    pub(crate) buildings: usize,
    /// Their levels.
    pub(crate) levels: usize,
    /// Their rooms.
    pub(crate) rooms: usize,
    /// Faults because of which parts of the input are left out.
    pub(crate) errors: usize,
    /// Other faults.
    pub(crate) warnings: usize,
    /// All faults.
    pub(crate) faults: Vec<FaultAnswer>,
}

/// `audit`.
#[derive(Serialize, JsonSchema)]
pub(crate) struct AuditAnswer<'a> {
    /// Counts over all levels.
    pub(crate) totals: AuditSummary,
    /// The levels, in the order of the arguments.
    pub(crate) levels: &'a [JudgedLevel],
    /// Faults that keep files and rooms from being judged.
    pub(crate) faults: Vec<FaultAnswer>,
}

/// `edits capture`, `edits lock` and `edits reroll`.
#[derive(Serialize, JsonSchema)]
pub(crate) struct EditsAnswer<'a> {
    /// The edits file.
    pub(crate) file: String,
    /// The added text.
    pub(crate) edits: &'a [RoomEntry],
    /// Changes that no edit can express.
    pub(crate) notes: Vec<String>,
}

/// `merge`.
#[derive(Serialize, JsonSchema)]
pub(crate) struct MergeAnswer {
    /// The manifest; none where parts are missing or contradict each other.
    pub(crate) manifest: Option<String>,
    /// Sums over all levels.
    pub(crate) totals: Totals,
    /// Bakes that are still at work in the folder.
    pub(crate) living_runs: usize,
    /// Records that were left out; with `--records`, missing parts and levels, and contradictions.
    pub(crate) rejected_records: Vec<FaultAnswer>,
}

/// `init`.
#[derive(Serialize, JsonSchema)]
pub(crate) struct InitAnswer {
    /// Files that were written.
    pub(crate) written: Vec<String>,
    /// Files that were there already.
    pub(crate) kept: Vec<String>,
    /// Commands to go on with.
    pub(crate) next: Vec<String>,
}

/// `formats`.
#[derive(Serialize, JsonSchema)]
pub(crate) struct FormatsAnswer {
    /// Formats that are read.
    pub(crate) read: Vec<ReadFormat>,
    /// Formats that are recognised and not read.
    pub(crate) not_read: Vec<UnreadFormatAnswer>,
}

/// A format that is not read.
#[derive(Serialize, JsonSchema)]
pub(crate) struct UnreadFormatAnswer {
    /// Its name.
    pub(crate) name: String,
    /// Advice for the user.
    pub(crate) advice: String,
}

/// `import`.
#[derive(Serialize, JsonSchema)]
pub(crate) struct ImportAnswer<'a> {
    /// The plans that were written.
    pub(crate) buildings: Vec<ImportedAnswer>,
    /// The faults of the input.
    pub(crate) faults: Vec<FaultAnswer>,
    /// The report on each input, with `--report`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) report: Option<&'a [InputReport]>,
}

/// A plan that was written.
#[derive(Serialize, JsonSchema)]
pub(crate) struct ImportedAnswer {
    /// Building id.
    pub(crate) id: String,
    /// The file.
    pub(crate) path: String,
    /// How many levels it has.
    pub(crate) levels: usize,
    /// How many rooms.
    pub(crate) rooms: usize,
    /// How many openings.
    pub(crate) openings: usize,
    /// The edits file beside it, with `--keep-furniture` and if some furniture is kept.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) edits: Option<KeptFurnitureAnswer>,
}

/// Furniture of a plan that is kept in an edits file.
#[derive(Serialize, JsonSchema)]
pub(crate) struct KeptFurnitureAnswer {
    /// The file.
    pub(crate) path: String,
    /// How many pieces are locked.
    pub(crate) kept: usize,
    /// How many pieces the plan draws.
    pub(crate) drawn: usize,
}

/// `explain`.
#[derive(Serialize, JsonSchema)]
pub(crate) struct ExplainAnswer<'a> {
    /// Building id.
    pub(crate) building: &'a str,
    /// Level id.
    pub(crate) level: &'a str,
    /// Room id.
    pub(crate) room: &'a str,
    /// Room type.
    #[serde(rename = "type")]
    pub(crate) room_type: &'a str,
    /// Its type in the plan, where `type` is its role in its dwelling instead.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) planned_type: Option<&'a str>,
    /// Who lives in its dwelling.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) household: Option<&'a str>,
    /// Square metres of floor.
    pub(crate) area: f64,
    /// The seed of the run.
    pub(crate) seed: u64,
    /// Style used.
    pub(crate) style: &'a str,
    /// Pieces that were asked for.
    pub(crate) requested: u32,
    /// Pieces that rest.
    pub(crate) placed: usize,
    /// Which of the alternatives of `--effort` it is, from 1.
    pub(crate) arrangement: u32,
    /// Which attempt at it was kept, from 1.
    pub(crate) attempt: u32,
    /// How often it was furnished.
    pub(crate) attempts: u32,
    /// The furniture.
    pub(crate) objects: Vec<ExplainedObject<'a>>,
    /// Missing pieces.
    pub(crate) missing: &'a [MissingStory],
    /// The findings of the audit.
    pub(crate) findings: Vec<FindingExtras>,
    /// Ids of objects that are edited after the arrangement, which is what is explained.
    pub(crate) edited_afterwards: &'a [String],
}

/// A piece of furniture, and why it is where it is.
#[derive(Serialize, JsonSchema)]
pub(crate) struct ExplainedObject<'a> {
    /// Why it is there.
    #[serde(flatten)]
    pub(crate) story: &'a ObjectStory,
    /// Class id.
    pub(crate) class: &'a str,
    /// The object or room part that it stands on or belongs to.
    pub(crate) parent: ElementId,
    /// The parent's side that it touches.
    pub(crate) side: Side,
    /// Metres east, north and above the floor.
    pub(crate) position: [f64; 3],
    /// Degrees counter-clockwise from facing south.
    pub(crate) turn: f64,
}

/// `catalog --docs`.
#[derive(Serialize, JsonSchema)]
pub(crate) struct CatalogFilesAnswer {
    /// The files that were written.
    pub(crate) files: Vec<PathBuf>,
}

/// The JSON Schema of each answer by its command. That of `diff` stands apart, for it is also a file; what `catalog`
/// answers otherwise has the keys of configuration files.
#[cfg(test)]
pub(crate) fn answer_schemas() -> Vec<(&'static str, schemars::Schema)> {
    vec![
        ("audit", schemars::schema_for!(AuditAnswer<'_>)),
        ("bake-list-levels", schemars::schema_for!(LevelList)),
        ("bake-progress", schemars::schema_for!(ProgressLine)),
        ("bake", schemars::schema_for!(BakeAnswer)),
        ("catalog-docs", schemars::schema_for!(CatalogFilesAnswer)),
        ("check", schemars::schema_for!(CheckAnswer)),
        ("edits", schemars::schema_for!(EditsAnswer<'_>)),
        ("explain", schemars::schema_for!(ExplainAnswer<'_>)),
        ("formats", schemars::schema_for!(FormatsAnswer)),
        ("import", schemars::schema_for!(ImportAnswer<'_>)),
        ("init", schemars::schema_for!(InitAnswer)),
        ("merge", schemars::schema_for!(MergeAnswer)),
        ("navigation", schemars::schema_for!(NavigationAnswer)),
        ("plan", schemars::schema_for!(PlanAnswer)),
        ("plan-report", schemars::schema_for!(ReportFile)),
        ("version", schemars::schema_for!(VersionAnswer)),
        ("walk", schemars::schema_for!(WalkAnswer)),
    ]
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    #[test]
    fn a_fault_for_machines_has_place_value_and_hint() {
        let fault = Fault {
            position: Some((3, 7)),
            path: vec!["levels".into(), 0.into()],
            ..Fault::of_file(Path::new("a.yaml"), "odd").as_warning().with_hint("mend it")
        };
        assert_eq!(
            serde_json::to_value(FaultAnswer::from(&fault)).unwrap(),
            serde_json::json!({"file": "a.yaml", "line": 3, "column": 7, "path": "levels[0]",
                "severity": "warning", "message": "odd", "hint": "mend it"})
        );
    }
}
