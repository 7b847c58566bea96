//! The record of a search, for `explain`: how many places each agent tried, and what was in the way there. Without `explain` a
//! refused place costs one look at a field, a free place nothing.

use std::collections::{BTreeMap, BTreeSet};

use super::furnished::RemovalReason;
use super::place::AgentIndex;

/// The records of all agents of an attempt.
pub(crate) struct Trace {
    /// By agent.
    records: Vec<Record>,
}

/// The record of one agent, over all its searches.
#[derive(Clone, Debug, Default)]
pub(crate) struct Record {
    /// How often it searched, in any size.
    pub(crate) searches: u32,
    /// Whether it was pushed, as the head of its group.
    pub(crate) was_pushed: bool,
    /// Places that were tested.
    pub(crate) places: u32,
    /// Those that were refused.
    pub(crate) refused: Refused,
}

/// Refused places.
#[derive(Clone, Debug, Default)]
pub(crate) struct Refused {
    /// How many, by reason.
    pub(crate) by_reason: BTreeMap<RemovalReason, u32>,
    /// The obstacles; one place may have several.
    pub(crate) obstacles: BTreeMap<(RemovalReason, Obstacle), u32>,
}

impl Refused {
    /// Counts a place.
    pub(crate) fn add(&mut self, reason: RemovalReason, obstacles: BTreeSet<Obstacle>) {
        *self.by_reason.entry(reason).or_default() += 1;
        for obstacle in obstacles {
            *self.obstacles.entry((reason, obstacle)).or_default() += 1;
        }
    }
}

/// Something that keeps an agent from a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Obstacle {
    /// The body of another agent.
    Body(AgentIndex),
    /// The clearance of another agent.
    ClearanceOf(AgentIndex),
    /// A body in the agent's own clearance.
    InOwnClearance(AgentIndex),
    /// A wall that leaves the agent's own clearance no room.
    WallInOwnClearance(usize),
    /// The agent's own clearance would lie outside the room.
    OwnClearanceOutside,
    /// A column in the agent's own clearance.
    ColumnInOwnClearance,
    /// A wall through the agent's body.
    Wall(usize),
    /// Not even the middle lies in the room.
    BeyondWalls,
    /// A column.
    Column,
    /// The swing or approach of an opening, by index into the level's openings.
    Opening(usize),
    /// A way that was closed before and is kept free now.
    Way,
    /// There is no wall behind what hangs.
    NoWall,
    /// The floor or the ceiling.
    Height,
    /// A window that it would darken.
    WindowBehind,
    /// The place of somebody who sits.
    Seat,
    /// The agent would have less room itself than is good.
    OwnComfort,
    /// A needed relation, by index in the class.
    Relation(usize),
}

impl Trace {
    /// Nothing has happened yet.
    pub(crate) fn new(agent_count: usize) -> Self {
        Self { records: vec![Record::default(); agent_count] }
    }

    /// The record of an agent.
    pub(crate) fn record(&self, agent: AgentIndex) -> &Record {
        &self.records[agent]
    }

    /// The same, to be added to.
    pub(crate) fn record_mut(&mut self, agent: AgentIndex) -> &mut Record {
        &mut self.records[agent]
    }
}
