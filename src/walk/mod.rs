//! Where people get to on the floor of a room: level, room and solids to groups of places that are reached from
//! each other. Never decides what that means: the layout clears the ways that it closed, the audit judges.
//!
//! A person is a disc on a grid of 5 cm, in rooms whose box has more than 28,000 m² of 10 or 15, which bounds memory and
//! time: passages there are known to a cell only, and what is thinner than one may be missed. Distances are exact, tested
//! against asking every cell.

mod floor;
mod queue;
mod raster;
mod way;

pub(crate) use floor::{Floor, Goal, Walk, is_in_the_way};
pub(crate) use raster::CELL;
pub(crate) use way::{EmptyWalks, Way, blocked_ways};
