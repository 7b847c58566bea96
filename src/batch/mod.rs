//! Bakes many plans into many files: schedules the levels, keeps unchanged ones, writes the manifest, reports progress.
//!
//! Callers may rely on:
//! - every file appears whole or not at all;
//! - a file that this program did not write, or that was changed since, is replaced only if the options say so;
//! - the files and the manifest are the same for any number of threads, shards and runs;
//! - a fault of one level, also one of the program itself, does not stop the others.

mod bug;
mod chosen;
mod claim;
mod coarser;
mod context;
mod event;
mod fault;
mod file_name;
mod finished;
mod folder;
mod in_place;
mod job;
mod join;
mod journal;
mod level;
mod level_list;
mod listed_inputs;
mod listing;
mod manifest;
mod options;
mod part_file;
mod parts;
mod place;
mod plan_paths;
mod planned;
mod program;
mod record;
mod shared;
mod sources;
mod state;
mod task;
mod unplanned;
mod work;

pub(crate) use bug::catch_bug;
pub use bug::collect_panics;
pub use event::{BakeReport, Event, LevelFailure, LevelMisfit, Observer, Stage};
#[cfg(test)]
pub(crate) use fault::FaultCode;
pub use fault::OutputFault;
pub(crate) use file_name::distinct_names;
pub(crate) use finished::{FinishedInput, write_finished};
pub use folder::OutputFolder;
pub use join::{Joined, MergeReport, merge};
pub use level_list::{ChosenLevels, LevelList, PlannedLevel};
pub use listed_inputs::ListedInputs;
pub(crate) use listing::{Listing, is_bake, list_levels};
#[cfg(test)]
pub(crate) use manifest::Manifest;
pub(crate) use manifest::{LARGEST_RECORDS, MANIFEST_NAME, parse_manifest};
pub use options::{BakeOptions, Shard, Unplanned};
pub use parts::{PartsReport, merge_parts};
pub use plan_paths::{record_plans, recorded_plan};
pub(crate) use planned::planned_levels;
pub use program::PROGRAM;
pub use record::{FileRecord, Totals};
pub use unplanned::Leftovers;
pub use work::{BakeInput, bake};
