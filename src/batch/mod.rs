//! Many plans to many files: scheduling, levels that are kept, manifest, progress.

mod bug;
mod claim;
mod context;
mod event;
mod fault;
mod file_name;
mod floor;
mod folder;
mod in_place;
mod job;
mod join;
mod journal;
mod listing;
mod manifest;
mod options;
mod place;
mod plan_paths;
mod program;
mod record;
mod shared;
mod sources;
mod state;
mod unplanned;
mod work;

pub(crate) use bug::catch_bug;
pub use bug::collect_panics;
pub use event::{BakeReport, Event, LevelFailure, LevelMisfit, Stage};
#[cfg(test)]
pub(crate) use fault::FaultCode;
pub use fault::OutputFault;
pub(crate) use file_name::distinct_names;
pub use folder::OutputFolder;
pub use join::{Joined, MergeReport, merge};
pub(crate) use listing::{Listing, list_levels};
#[cfg(test)]
pub(crate) use manifest::Manifest;
pub(crate) use manifest::{LARGEST_RECORDS, MANIFEST_NAME, parse_manifest};
pub use options::{BakeOptions, Shard, Unplanned};
pub use plan_paths::{record_plans, recorded_plan};
pub use program::PROGRAM;
pub use record::{FileRecord, Totals};
pub use unplanned::Leftovers;
pub use work::{BakeInput, bake};
