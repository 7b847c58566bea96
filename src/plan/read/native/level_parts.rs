//! A level while its rooms and openings are collected.

use std::collections::{BTreeMap, BTreeSet};

use super::origins::{LevelOrigins, Origin};
use crate::document::PathStep;
use crate::plan::LevelDraft;

/// A level while it is filled.
#[derive(Default)]
pub(super) struct LevelParts {
    pub(super) draft: LevelDraft,
    pub(super) origins: LevelOrigins,
    /// Index of each room in the draft, by id.
    pub(super) names: BTreeMap<String, usize>,
    /// Ids of rooms that were left out; openings that name them are left out too.
    pub(super) left_out: BTreeSet<String>,
    /// Where each opening's id was written, by id.
    pub(super) opening_ids: BTreeMap<String, Vec<PathStep>>,
}

impl LevelParts {
    /// The origin of a room, for messages.
    pub(super) fn room_origin(&self, id: &str) -> Option<&Origin> {
        self.origins.rooms.get(*self.names.get(id)?)
    }
}
