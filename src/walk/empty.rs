//! The floors of an empty room, from which the furnished ones are made.

use core::cell::OnceCell;
use std::rc::Rc;

use crate::catalog::AuditRules;
use crate::plan::RoomRef;

use super::floor::Floor;

/// The floors of an empty room, for people and for wheelchairs: each is made where it is first asked for, and serves all
/// arrangements of the room.
#[derive(Debug)]
pub(crate) struct EmptyFloors<'a> {
    at: RoomRef<'a>,
    rules: &'a AuditRules,
    walking: OnceCell<Option<Rc<Floor>>>,
    wheelchair: OnceCell<Option<Rc<Floor>>>,
}

impl<'a> EmptyFloors<'a> {
    /// Those of a room.
    pub(crate) fn new(at: RoomRef<'a>, rules: &'a AuditRules) -> Self {
        Self { at, rules, walking: OnceCell::new(), wheelchair: OnceCell::new() }
    }

    /// The room.
    pub(crate) fn at(&self) -> RoomRef<'a> {
        self.at
    }

    /// The floor for people; `None` where no door leads in.
    pub(crate) fn walking(&self) -> Option<&Floor> {
        self.walking.get_or_init(|| Floor::empty(self.at, &self.rules.walking)).as_deref()
    }

    /// The floor for wheelchairs; `None` where no door leads in.
    pub(crate) fn wheelchair(&self) -> Option<&Floor> {
        self.wheelchair.get_or_init(|| Floor::empty_for_wheelchair(self.at, self.rules)).as_deref()
    }
}
