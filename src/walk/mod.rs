//! Finds where people can walk in a room: from level, room and solids come groups of places that can be reached from each other.
//! A *way* is a stretch of floor by which a disc as wide as a person gets from one place to another. The layout uses this to
//! clear the ways that furniture closes, the audit to judge them.
//!
//! A person is a disc on a grid of cells. Cells are 5 cm wide; in rooms whose box has more than 28,000 m² they are 10 or 15 cm
//! wide, which bounds memory and time. A passage between obstacles is known to half a centimetre (`gaps`), and a body
//! thinner than a cell may be missed. Distances between cells are exact.

mod empty;
mod floor;
mod furnished;
mod gaps;
mod known;
mod leaves;
mod queue;
mod raster;
mod way;

pub(crate) use empty::EmptyFloors;
pub(crate) use floor::{Floor, Goal, Walk, is_in_the_way};
pub(crate) use raster::{CELL, Raster, cell_around};
pub(crate) use way::{EmptyWalks, Way, blocked_ways};
