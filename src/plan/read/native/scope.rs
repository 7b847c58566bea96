//! The source and target of parts: a level or a prototype, and the level that they go to.

use std::collections::BTreeSet;

use super::file::RoomFile;
use super::motion::Motion;
use super::units::LengthUnit;
use crate::document::PathStep;
use crate::geometry::Point;

/// Where parts come from and go to: a level's own, or one copy of a prototype.
#[derive(Clone)]
pub(super) struct Scope<'a> {
    pub(super) units: LengthUnit,
    /// Number of the level.
    pub(super) level: i64,
    /// Style of rooms that name none.
    pub(super) style: Option<&'a String>,
    /// Household of rooms that name none.
    pub(super) household: Option<&'a String>,
    pub(super) motion: Motion,
    /// Document path of what holds the lists of parts.
    pub(super) path: Vec<PathStep>,
    /// Id of the copy and the document path of its place, for prototypes.
    pub(super) instance: Option<(String, Vec<PathStep>)>,
    /// The prototype's rooms, for which its openings have short names.
    pub(super) rooms: &'a [RoomFile],
    /// Document paths of rooms that are not placed.
    pub(super) left_out: &'a BTreeSet<Vec<PathStep>>,
}

impl Scope<'_> {
    pub(super) fn instance_id(&self) -> Option<&str> {
        self.instance.as_ref().map(|(id, _)| id.as_str())
    }

    /// A point as written, in metres.
    pub(super) fn point(&self, [x, y]: [f64; 2]) -> Point {
        Point::new(self.units.to_metres(x), self.units.to_metres(y))
    }
}
