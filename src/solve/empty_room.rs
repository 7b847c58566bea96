//! The room that is searched, without its furniture, and the steps that are left for it.

use crate::catalog::{AuditRules, Catalog};
use crate::plan::RoomRef;

use super::budget::Budget;

/// An empty room, for the questions of one judgement.
pub(crate) struct EmptyRoom<'a> {
    /// The room.
    pub(crate) at: RoomRef<'a>,
    /// Classes and thresholds.
    pub(crate) catalog: &'a Catalog,
    /// The steps that the judgement may still make.
    pub(crate) budget: Budget,
}

impl<'a> EmptyRoom<'a> {
    /// A room with so many steps to spend.
    pub(crate) fn new(at: RoomRef<'a>, catalog: &'a Catalog, steps: u64) -> Self {
        Self { at, catalog, budget: Budget::new(steps) }
    }

    /// The thresholds.
    pub(crate) fn rules(&self) -> &'a AuditRules {
        &self.catalog.audit
    }
}
