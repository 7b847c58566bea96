//! The notes of a reading: what of a map was merged, mended, dropped or not understood.

use std::collections::BTreeMap;
use std::path::Path;

use schemars::JsonSchema;
use serde::Serialize;

use crate::document::{Fault, Faults};

/// Faults of one kind that are told one by one; the last counts the others.
const TOLD: usize = 20;

/// What became of the buildings of a map that are no footprints of their own. All lists are sorted.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, JsonSchema)]
pub struct SiteNotes {
    /// Buildings and parts of buildings that the file draws. Each is a footprint, or stands in `duplicates`, `parts` or
    /// `left_out`, but for areas of several pieces (`split`).
    pub drawn: usize,
    /// Buildings that the file draws twice: the one with more facts stays.
    pub duplicates: Vec<Joined>,
    /// Parts that belong to a building.
    pub parts: Vec<Joined>,
    /// Areas of several pieces, each of which is a building.
    pub split: Vec<Split>,
    /// Buildings made of their parts, as the file does not draw them as a whole.
    pub made_of_parts: Vec<String>,
    /// Buildings without a usable outline.
    pub left_out: Vec<LeftOut>,
    /// Buildings whose outline crossed or touched itself.
    pub mended: Vec<String>,
    /// What the file says of itself and does not mean.
    pub assumed: Vec<String>,
    /// Values that nobody can read.
    pub unreadable: Vec<Unreadable>,
    /// How many features are no buildings, by the reason.
    pub no_buildings: BTreeMap<String, usize>,
}

/// A thing that became one with a building.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, JsonSchema)]
pub struct Joined {
    /// Its id.
    pub id: String,
    /// Id of the building.
    pub with: String,
}

/// An area of several pieces.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, JsonSchema)]
pub struct Split {
    /// The id in the file; the buildings have `-1`, `-2` and so on behind it, the largest first.
    pub id: String,
    /// How many pieces are buildings.
    pub pieces: usize,
}

/// A building that is no footprint.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, JsonSchema)]
pub struct LeftOut {
    /// Its id, or its place in the file.
    pub id: String,
    /// The reason.
    pub reason: String,
}

/// A value that nobody can read.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, JsonSchema)]
pub struct Unreadable {
    /// Id of the building.
    pub id: String,
    /// The key.
    pub key: String,
    /// The value.
    pub value: String,
}

impl SiteNotes {
    /// Counts a feature that is no building.
    pub(super) fn skip(&mut self, reason: &str) {
        *self.no_buildings.entry(reason.to_owned()).or_default() += 1;
    }

    /// Notes a building that is no footprint.
    pub(super) fn leave_out(&mut self, id: impl Into<String>, reason: impl Into<String>) {
        self.left_out.push(LeftOut { id: id.into(), reason: reason.into() });
    }

    /// Sorts all lists: the order of features in the file must not show.
    pub(super) fn sort(&mut self) {
        self.duplicates.sort();
        self.parts.sort();
        self.split.sort();
        self.made_of_parts.sort();
        self.left_out.sort();
        self.mended.sort();
        self.unreadable.sort();
    }

    /// Warnings about what was left out and what nobody can read.
    pub(super) fn faults(&self, file: &Path) -> Faults {
        let warning = |message: String| Fault::of_file(file, message).as_warning();
        let mut faults = Faults::default();
        self.assumed.iter().for_each(|assumed| faults.push(warning(assumed.clone())));
        for LeftOut { id, reason } in self.left_out.iter().take(TOLD) {
            faults.push(warning(format!("building \"{id}\" is left out: {reason}")));
        }
        for Unreadable { id, key, value } in self.unreadable.iter().take(TOLD) {
            faults.push(warning(format!(
                "building \"{id}\": \"{key}\" is \"{value}\", which is no number that a building has"
            )));
        }
        for (count, what) in [
            (self.left_out.len(), "buildings are left out"),
            (self.unreadable.len(), "values are no numbers that buildings have"),
        ] {
            if count > TOLD {
                faults.push(warning(format!("{} more {what}", count - TOLD)));
            }
        }
        faults
    }
}
