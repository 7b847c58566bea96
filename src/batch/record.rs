//! The manifest's record of one level.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::audit::{AuditSummary, Grade};
use crate::contract::FindingExtras;
use crate::disk::content_hash;
use crate::output;
use crate::scene::LevelBounds;

/// One level of one building as it was written. The keys and their order are part of the output.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LevelRecord {
    /// Building id.
    pub building: String,
    /// Level id.
    pub level: String,
    /// The program that wrote it, where it is not the one that wrote the manifest.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub program: Option<String>,
    /// Hash of all that the level was made from.
    pub inputs: String,
    /// The seed of the run.
    pub seed: u64,
    /// Where the building stands.
    pub site: SiteRecord,
    /// The box around all that it shows; none where it shows nothing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bounds: Option<LevelBounds>,
    /// The files, the one to open first.
    pub files: Vec<FileRecord>,
    /// Paths of shared geometry that the files refer to, sorted.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub library: Vec<String>,
    /// Sums over the rooms.
    pub totals: Totals,
    /// Objects by class id.
    pub classes: BTreeMap<String, u64>,
    /// Faulty parts of the plan that the level lacks, in words.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub left_out: Vec<String>,
    /// The text by which the source of the plan asks to be named, if it does.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub attribution: Option<String>,
    /// Rooms with missing pieces or findings, in the plan's order.
    pub rooms: Vec<RoomRecord>,
}

/// Whether the files of a level are those of a format with files over all levels.
pub(super) fn has_index(files: &[FileRecord]) -> bool {
    let paths: Vec<&str> = files.iter().map(|file| file.path.as_str()).collect();
    output::has_index(&paths)
}

/// A building's place on the site.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SiteRecord {
    /// Metres east and north.
    pub position: [f64; 2],
    /// Radians counter-clockwise.
    pub turn: f64,
}

/// A file in the output folder.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
pub struct FileRecord {
    /// Relative to the output folder, with `/`.
    pub path: String,
    /// SHA-256 of the content.
    pub sha256: String,
    /// Length.
    pub bytes: u64,
}

impl FileRecord {
    /// A file's bytes with what the manifest says about them.
    pub(crate) fn with_bytes(path: String, bytes: Vec<u8>) -> (Self, Vec<u8>) {
        (Self { path, sha256: content_hash(&bytes), bytes: bytes.len() as u64 }, bytes)
    }
}

/// Sums over rooms.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Totals {
    /// All rooms, furnished or not.
    pub rooms: u64,
    /// Pieces that were asked for.
    pub requested: u64,
    /// Pieces that rest.
    pub placed: u64,
    /// Pieces that are missing.
    pub removed: u64,
    /// Rooms by grade, findings by code, scores.
    #[serde(flatten)]
    pub audit: AuditSummary,
    /// Rejected edits.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub misfits: u64,
    /// Rooms left empty by a fault of the program; their level is baked again next time.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub broken: u64,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "the signature that serde asks for")]
fn is_zero(count: &u64) -> bool {
    *count == 0
}

impl Totals {
    /// Adds another sum. Counts in a manifest that was tampered with may have any size.
    pub fn add(&mut self, other: &Self) {
        self.rooms = self.rooms.saturating_add(other.rooms);
        self.requested = self.requested.saturating_add(other.requested);
        self.placed = self.placed.saturating_add(other.placed);
        self.removed = self.removed.saturating_add(other.removed);
        self.audit.merge(&other.audit);
        self.misfits = self.misfits.saturating_add(other.misfits);
        self.broken = self.broken.saturating_add(other.broken);
    }
}

/// The missing pieces and the findings of one room.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct RoomRecord {
    /// Room id.
    pub room: String,
    /// The grade of the audit.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub grade: Option<Grade>,
    /// The score of the audit; none if no piece was requested.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub score: Option<f64>,
    /// Missing pieces in the order of removal.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub removed: Vec<RemovedRecord>,
    /// Findings of the audit.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub findings: Vec<FindingExtras>,
    /// Edits that do not fit.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub misfits: Vec<String>,
    /// Why the room could not be furnished: a fault of the program.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub failure: Option<String>,
}

/// A missing piece.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct RemovedRecord {
    /// Class id.
    pub class: String,
    /// Why.
    pub reason: String,
}

/// A level by its ids; the order of the manifest.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct LevelKey {
    pub(crate) building: String,
    pub(crate) level: String,
}

impl LevelRecord {
    /// Building id and level id.
    pub(crate) fn key(&self) -> LevelKey {
        LevelKey { building: self.building.clone(), level: self.level.clone() }
    }
}
