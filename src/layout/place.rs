//! Where an agent stands or would stand, and on what.

use crate::catalog::{COVERING_HEIGHT, Side, Size};

use super::body::Pose;
use super::constants::CONTACT_TOLERANCE;

/// Index into [`super::environment::Environment::agents`].
pub(crate) type AgentIndex = usize;

/// A resting agent or a part of the room.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ParentPart {
    /// The floor.
    Floor,
    /// The ceiling.
    Ceiling,
    /// A wall by index into the room's walls.
    Wall(usize),
    /// An opening by index into the room's openings.
    Opening(usize),
    /// A column by index into the room's obstacles.
    Column(usize),
    /// A resting agent.
    Agent(AgentIndex),
}

/// A place that an agent takes or considers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Place {
    /// Position and direction.
    pub(crate) pose: Pose,
    /// On or beside what.
    pub(crate) parent: ParentPart,
    /// On which side of it.
    pub(crate) side: Side,
}

impl Place {
    /// Whether an object of a size lies there so flat on the floor that others stand on it.
    pub(crate) fn lies_flat(&self, size: Size) -> bool {
        self.parent == ParentPart::Floor
            && self.pose.elevation + size.height <= COVERING_HEIGHT + CONTACT_TOLERANCE
    }
}
