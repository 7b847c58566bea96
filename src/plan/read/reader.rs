//! The interface of a reader: what it is asked, and its answer. `readers.rs` lists the readers and says how to add one.

use std::path::Path;

use schemars::JsonSchema;
use serde::Serialize;

use super::drawn::DrawnPiece;
use super::foreign::Parts;
use crate::document::Faults;
use crate::plan::{BuildingDraft, PlanOptions, SiteOrigin, SitePlacement};

/// A format that plans are read in, for people.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct ReadFormat {
    /// The word in the answers of `formats` and `import`; by custom also the section of `room_words.yaml`.
    pub name: &'static str,
    /// The name for people.
    pub title: &'static str,
    /// The file or folder to name.
    pub input: &'static str,
    /// The parts of it that are read, and those that are not.
    pub content: &'static str,
}

/// A foreign format with its reader; a line of [`super::readers::FOREIGN_FORMATS`].
#[derive(Debug)]
pub(crate) struct ForeignFormat {
    /// How `roomwright formats` describes it.
    pub(crate) about: ReadFormat,
    /// Whether a file or folder is of this format, from names and the first bytes of files: every file below an input folder
    /// is asked about.
    pub(crate) recognises: fn(&Path) -> bool,
    /// For formats that are folders: if a folder has only some of the files, the name of the format for people and the files
    /// that it needs. `|_| None` for formats of one file.
    pub(crate) near_miss: fn(&Path) -> Option<(&'static str, Parts)>,
    /// Reads all buildings of a file or folder. Ids come from the data or from the name of the file.
    pub(crate) read: fn(&Path, &PlanOptions<'_>) -> ReadResult,
    /// Reads the furniture of a file, by the same ids of buildings and levels; `None` for formats without furniture.
    pub(crate) furniture: Option<ReadFurniture>,
}

/// Reads the furniture of a file.
pub(crate) type ReadFurniture = fn(&Path, &PlanOptions<'_>) -> Result<Vec<DrawnPiece>, Faults>;

/// All buildings of a file or folder, or why there is none.
pub(crate) type ReadResult = Result<ReadBuildings, Faults>;

/// The buildings of a file or folder of a foreign format.
#[derive(Debug)]
pub(crate) struct ReadBuildings {
    /// The buildings as far as they could be read.
    pub(crate) buildings: Vec<DraftedBuilding>,
    /// Warnings, and errors about what was left out.
    pub(crate) faults: Faults,
    /// Where the site is on the earth, if the file says.
    pub(crate) origin: Option<SiteOrigin>,
    /// The furniture that it draws, by the same ids of buildings and levels, where the options keep it: so that nobody reads a large
    /// file twice. A reader may leave it to its `furniture`.
    pub(crate) furniture: Option<Vec<DrawnPiece>>,
}

/// A building as a reader drafts it; `assemble` checks and completes it.
#[derive(Clone, Debug, Default)]
pub(crate) struct DraftedBuilding {
    /// Unique in the plan.
    pub(crate) id: String,
    /// Its levels, lengths in metres.
    pub(crate) draft: BuildingDraft,
    /// Where its frame is on the site, if the file says.
    pub(crate) placement: SitePlacement,
    /// Whether the building is taken as its native plan says it, so that `import` and `bake` of the result furnish it as `bake` of the
    /// file does, to the byte. New readers set it. Formats that were read before this was asked give the same rooms, but lengths
    /// that differ by up to 0.01 mm.
    pub(crate) is_settled: bool,
}

impl ReadBuildings {
    /// The answer of a reader; buildings without a level are left out.
    ///
    /// # Errors
    /// All faults, if they left no building.
    pub(crate) fn new(mut buildings: Vec<DraftedBuilding>, mut faults: Faults) -> ReadResult {
        buildings.retain(|building| !building.draft.levels.is_empty());
        faults.sort();
        if buildings.is_empty() && faults.has_errors() {
            Err(faults)
        } else {
            Ok(Self { buildings, faults, origin: None, furniture: None })
        }
    }
}
