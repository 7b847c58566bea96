//! Options for reading plans.

use std::path::PathBuf;

use super::{InputReport, Plan, RoomWords};
use crate::document::Faults;

/// The input of reading plans besides the files.
#[derive(Clone, Copy, Debug)]
pub struct PlanOptions<'a> {
    /// The room types and styles that exist, and what the words of foreign formats mean.
    pub words: &'a RoomWords,
}

/// The settings of project files for the whole run.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ProjectSettings {
    /// Further folders of configuration, in the order in which they are named, relative to the working folder.
    pub catalog: Vec<PathBuf>,
    /// Style of rooms that name none.
    pub style: Option<String>,
    /// Seed of the run.
    pub seed: Option<u64>,
}

/// The buildings that could be read, and what is wrong with the rest: one bad file does not stop the others.
#[derive(Clone, Debug, Default)]
pub struct PlanReading {
    /// The buildings, sorted by id.
    pub plan: Plan,
    /// Errors and warnings of all files, sorted by file and place. After an error of a file some of its rooms or
    /// buildings are missing from `plan`.
    pub faults: Faults,
    /// The report on each input, sorted by path; plans that projects name are not among them.
    pub reports: Vec<InputReport>,
}
