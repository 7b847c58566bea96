//! The wishes of agents: each file is one rule, a pure function from what an agent sees to the poses that it
//! would like, best first. `environment` tests whether a pose is free.

mod beside;
mod corner;
mod floor;
mod grid;
mod poor_places;
mod relation;
mod sight;
mod surface;
mod swing;
mod turn;
mod wall;

pub(crate) use corner::fills_niche;
pub use poor_places::PoorPlaces;
pub(crate) use poor_places::is_out_of_place;
pub(crate) use relation::{Factor, Measured, Score, measure, meets_needs, score, unmet_need, weigh};
pub(crate) use swing::distance_to_swings;
pub(crate) use turn::angle_of_front;
pub(crate) use wall::{Line, closings, floor_along, free_stretches, steps_along};

use crate::catalog::{Class, ParentRule, Side, Size};

use super::body::Pose;
use super::constants::STEPS_A_PROPOSAL;
use super::environment::Environment;
use super::lattice::Slots;
use super::place::{AgentIndex, ParentPart};
use super::seed::{RoomKey, Stream};

/// The view of an agent that considers a side of a parent.
#[derive(Clone, Copy)]
pub(crate) struct View<'a> {
    /// The room and all agents.
    pub(crate) environment: &'a Environment<'a>,
    /// Itself.
    pub(crate) agent: AgentIndex,
    /// Its class.
    pub(crate) class: &'a Class,
    /// Its size.
    pub(crate) size: Size,
    /// The line of its description under which the parent was found.
    pub(crate) rule: &'a ParentRule,
    /// The parent.
    pub(crate) parent: ParentPart,
    /// The side.
    pub(crate) side: Side,
}

/// Appends the poses that an agent would take at a side of a parent, best first; of a lattice the first few, and says which slots they
/// are.
pub(crate) fn propose(
    view: &View<'_>,
    key: &RoomKey,
    stream: &mut Stream,
    poses: &mut Vec<Pose>,
) -> Option<Slots> {
    view.environment.count_steps(STEPS_A_PROPOSAL);
    if let (Some(grid), ParentPart::Floor | ParentPart::Ceiling) = (&view.class.grid, view.parent) {
        return Some(grid::propose(view, grid, key, poses));
    }
    match view.parent {
        ParentPart::Floor | ParentPart::Ceiling => floor::propose(view, stream, poses),
        ParentPart::Wall(wall) => wall::propose(view, wall, stream, poses),
        ParentPart::Opening(opening) => wall::propose_at_opening(view, opening, stream, poses),
        ParentPart::Column(column) => beside::propose_at_column(view, column, stream, poses),
        ParentPart::Agent(parent) => match view.side {
            Side::Above | Side::Below => surface::propose(view, parent, stream, poses),
            Side::Front | Side::Back | Side::Left | Side::Right => {
                beside::propose_at_agent(view, parent, stream, poses);
            }
        },
    }
    None
}

/// Appends all other poses of a lattice, and says which slots they are.
pub(crate) fn propose_other_slots(
    view: &View<'_>,
    key: &RoomKey,
    slots: Slots,
    poses: &mut Vec<Pose>,
) -> Option<Slots> {
    let grid = view.class.grid.as_ref()?;
    Some(grid::propose_others(view, grid, key, slots, poses))
}

/// Appends a scan along the rows in which the agent's class stands, if any: who found no place of its own stays in line.
pub(crate) fn propose_rows(view: &View<'_>, key: &RoomKey, poses: &mut Vec<Pose>) {
    if let (Some(grid), ParentPart::Floor | ParentPart::Ceiling) = (&view.class.grid, view.parent) {
        grid::scan(view, grid, key, poses);
    }
}

/// Appends a regular scan of a floor, ceiling or top for an agent that found no good place at random; a thorough one
/// is finer, tries every turn and walls too: for what has no place at all and cannot be missed.
pub(crate) fn propose_scan(view: &View<'_>, is_thorough: bool, stream: &mut Stream, poses: &mut Vec<Pose>) {
    match (view.parent, view.side) {
        (ParentPart::Floor | ParentPart::Ceiling, _) => floor::scan(view, is_thorough, stream, poses),
        (ParentPart::Wall(wall), _) if is_thorough => wall::scan(view, wall, stream, poses),
        (ParentPart::Agent(parent), Side::Above) => surface::scan(view, parent, stream, poses),
        _ => {}
    }
}
