//! The report of a comparison as JSON (`configs/schema/diff.schema.json`).

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Serialize;

use super::change::Change;
use super::kind::Kind;
use super::tolerance::Tolerance;

/// The version of the structure; a key that changes its meaning, or goes, counts it up.
pub const REPORT_VERSION: u32 = 1;

/// The differences between two bakes, or two files.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Report {
    /// The version of this structure.
    pub diff: u32,
    /// The program that compared.
    pub program: String,
    /// The folder or file before.
    pub old: String,
    /// The folder or file after.
    pub new: String,
    /// The largest moves and turns that are not reported.
    pub tolerance: Tolerance,
    /// Counts.
    pub summary: Summary,
    /// Buildings that were added or removed, by id.
    pub buildings: BTreeMap<String, Presence>,
    /// Levels that differ or cannot be compared, by building and level.
    pub levels: Vec<LevelDiff>,
    /// Shared textures and geometry that were added, removed or changed, by path.
    pub shared: BTreeMap<String, Presence>,
    /// Files, levels and rooms that cannot be read.
    pub troubles: Vec<Trouble>,
}

/// Counts over a report.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Summary {
    /// Levels by what became of them.
    pub levels: LevelCounts,
    /// Rooms that were added, removed or changed in levels that both sides have.
    pub rooms: u64,
    /// Changes by kind; kinds without a change are left out.
    pub changes: BTreeMap<Kind, u64>,
}

/// Levels by what became of them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, JsonSchema)]
pub struct LevelCounts {
    /// The same bytes, or differences within the tolerance.
    pub identical: u64,
    /// Differences within.
    pub changed: u64,
    /// In the new side only.
    pub added: u64,
    /// In the old side only.
    pub removed: u64,
    /// Not readable on a side.
    pub unreadable: u64,
}

/// Whether a level, room or file was added, removed, changed or the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Presence {
    /// On the new side only.
    Added,
    /// On the old side only.
    Removed,
    /// On both sides, not the same.
    Changed,
    /// Not readable on a side.
    Unreadable,
}

/// A level that differs.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct LevelDiff {
    /// Building id.
    pub building: String,
    /// Level id.
    pub level: String,
    /// Whether it was added, removed, changed or the same.
    pub state: Presence,
    /// Its file before, relative to the side's folder.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub old_file: Option<String>,
    /// Its file after.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub new_file: Option<String>,
    /// Changes that belong to no room: openings, the shell, settings.
    pub changes: Vec<Change>,
    /// Rooms that differ, by id.
    pub rooms: Vec<RoomDiff>,
}

/// A room that differs.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RoomDiff {
    /// Room id.
    pub room: String,
    /// Its type, the new one.
    #[serde(rename = "type")]
    pub room_type: String,
    /// Whether it was added, removed, changed or the same.
    pub state: Presence,
    /// Its changes by kind, then object.
    pub changes: Vec<Change>,
}

/// A file, level or room that cannot be read or compared.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, JsonSchema)]
pub struct Trouble {
    /// The file.
    pub file: String,
    /// The fact.
    pub message: String,
    /// Advice for the user.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hint: Option<String>,
}

impl LevelDiff {
    /// All changes with the room that they are in.
    pub fn all_changes(&self) -> impl Iterator<Item = (Option<&RoomDiff>, &Change)> {
        let of_rooms =
            self.rooms.iter().flat_map(|room| room.changes.iter().map(move |change| (Some(room), change)));
        self.changes.iter().map(|change| (None, change)).chain(of_rooms)
    }
}

impl Report {
    /// Whether both sides are equal, and all could be read.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.levels.is_empty() && self.shared.is_empty() && self.troubles.is_empty()
    }

    /// How many changes are of a kind.
    #[must_use]
    pub fn count(&self, kind: Kind) -> u64 {
        self.summary.changes.get(&kind).copied().unwrap_or(0)
    }
}

impl Summary {
    /// The counts of some levels, besides those that were identical.
    #[must_use]
    pub fn of(identical: u64, levels: &[LevelDiff], shared: usize) -> Self {
        let mut summary =
            Self { levels: LevelCounts { identical, ..LevelCounts::default() }, ..Self::default() };
        for level in levels {
            let counts = &mut summary.levels;
            *match level.state {
                Presence::Added => &mut counts.added,
                Presence::Removed => &mut counts.removed,
                Presence::Changed => &mut counts.changed,
                Presence::Unreadable => &mut counts.unreadable,
            } += 1;
            summary.rooms += level.rooms.len() as u64;
            for (_, change) in level.all_changes() {
                *summary.changes.entry(change.kind).or_default() += 1;
            }
        }
        if shared > 0 {
            *summary.changes.entry(Kind::Looks).or_default() += shared as u64;
        }
        summary
    }
}
