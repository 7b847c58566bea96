//! The result of a reader of a foreign format.

use crate::document::Faults;
use crate::plan::BuildingDraft;

/// A building as a reader of a foreign format found it.
#[derive(Clone, Debug, Default)]
pub(crate) struct DraftedBuilding {
    /// Unique in the plan.
    pub(crate) id: String,
    /// Its levels, lengths in metres.
    pub(crate) draft: BuildingDraft,
}

/// The result of a reader of a foreign format.
#[derive(Debug)]
pub(crate) struct Found {
    /// The buildings as far as they could be read.
    pub(crate) buildings: Vec<DraftedBuilding>,
    /// Warnings, and errors about what was left out.
    pub(crate) faults: Faults,
}

impl Found {
    /// Buildings without a level are nothing.
    ///
    /// # Errors
    /// All faults, if they left no building.
    pub(crate) fn new(mut buildings: Vec<DraftedBuilding>, mut faults: Faults) -> ReadResult {
        buildings.retain(|building| !building.draft.levels.is_empty());
        faults.sort();
        if buildings.is_empty() && faults.has_errors() { Err(faults) } else { Ok(Self { buildings, faults }) }
    }
}

/// All buildings of a file or folder, or why there is none.
pub(crate) type ReadResult = Result<Found, Faults>;
