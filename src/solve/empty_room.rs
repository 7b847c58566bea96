//! The room that is searched, without its furniture, and the steps that are left for it.

use crate::catalog::{AuditRules, Catalog};
use crate::plan::{Level, Room};

use super::budget::Budget;

/// An empty room, for the questions of one judgement.
pub(crate) struct EmptyRoom<'a> {
    /// The level around it.
    pub(crate) level: &'a Level,
    /// The room.
    pub(crate) room: &'a Room,
    /// Classes and thresholds.
    pub(crate) catalog: &'a Catalog,
    /// What the judgement may still spend.
    pub(crate) budget: Budget,
}

impl<'a> EmptyRoom<'a> {
    /// A room of a level, by index into its rooms, with so many steps to spend.
    pub(crate) fn new(level: &'a Level, room: usize, catalog: &'a Catalog, steps: u64) -> Self {
        Self { level, room: &level.rooms[room], catalog, budget: Budget::new(steps) }
    }

    /// The thresholds.
    pub(crate) fn rules(&self) -> &'a AuditRules {
        &self.catalog.audit
    }
}
