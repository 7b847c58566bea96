//! Options for reading plans.

use std::collections::BTreeMap;
use std::path::PathBuf;

use super::{DrawnPiece, InputReport, Plan, RoomWords, SiteOrigin};
use crate::document::Faults;
use crate::storey::{Choices, Typologies};

/// The input of reading plans besides the files.
#[derive(Clone, Copy, Debug)]
pub struct PlanOptions<'a> {
    /// The room types and styles that exist, and what the words of foreign formats mean.
    pub words: &'a RoomWords,
    /// How buildings are planned of which only the outline is known; none where such maps are not read.
    pub planning: Option<Planning<'a>>,
    /// Whether the furniture that files draw is kept apart from the plan, so that no reader need report it as left out.
    pub keeps_furniture: bool,
    /// Whether the buildings are written as native plans. Others are taken as their native plans say them, so that both are the same
    /// to the byte; one that was taken so and is written again may come back with openings that are moved by 0.01 mm once more.
    pub is_for_writing: bool,
}

/// How buildings are planned of which only the outline is known.
#[derive(Clone, Copy, Debug)]
pub struct Planning<'a> {
    /// The kinds of buildings.
    pub typologies: &'a Typologies,
    /// What is chosen in place of what the map says.
    pub choices: &'a Choices,
}

impl<'a> PlanOptions<'a> {
    /// Options for floor plans alone.
    #[must_use]
    pub fn new(words: &'a RoomWords) -> Self {
        Self { words, planning: None, keeps_furniture: false, is_for_writing: false }
    }

    /// The same, with maps of outlines.
    #[must_use]
    pub fn with_planning(self, typologies: &'a Typologies, choices: &'a Choices) -> Self {
        Self { planning: Some(Planning { typologies, choices }), ..self }
    }
}

/// The settings of project files for the whole run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ProjectSettings {
    /// Further folders of configuration, in the order in which they are named, relative to the working folder.
    pub catalog: Vec<PathBuf>,
    /// Style of rooms that name none.
    pub style: Option<String>,
    /// Seed of the run.
    pub seed: Option<u64>,
    /// Where the site is on the earth.
    pub origin: Option<SiteOrigin>,
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
    /// Where the site is on the earth, if the only file that was read says so; projects say it in their settings.
    pub origin: Option<SiteOrigin>,
    /// The furniture that is kept, by file, as far as it was read on the way; [`super::drawn_furniture`] reads that of the others.
    pub furniture: BTreeMap<PathBuf, Vec<DrawnPiece>>,
}
