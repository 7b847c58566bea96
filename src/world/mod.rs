//! Rooms on demand: those around an eye are furnished in the background before one sees them, kept while one is near, and
//! forgotten when one is far (T. Germer, M. Schwarz, 2009, sections 4, 5 and 6.2).
//!
//! Callers may rely on:
//! - a room is the one that a bake with the same project and options writes, whatever was looked at before, in whatever order,
//!   with however many threads; a room that is forgotten and made again is equal;
//! - a room that is wanted twice at once is made once;
//! - what is held never exceeds the budget by more than the rooms that are being made;
//! - time per look has a bound that depends on the neighbourhood, not on the size of the city.
//!
//! `graph` has the rooms of a building and their openings; `sight` says which of them one sees, `near` which one reaches; `wish`
//! ranks them; `site` knows where the buildings stand; `store` holds what is made; `inputs` makes it; `journey` walks through a world and measures.

mod graph;
mod inputs;
mod journey;
mod near;
mod path;
mod room;
mod route;
mod sight;
mod site;
mod store;
#[cfg(test)]
mod tests;
mod wish;
#[expect(clippy::module_inception, reason = "the type that the folder is named after")]
mod world;

pub(crate) use graph::{BuildingGraph, Place};
pub use journey::{Pace, Spread, WalkReport, walk};
#[cfg(test)]
pub(crate) use path::PathFile;
pub use path::WalkPath;
pub use room::WorldRoom;
pub use store::Budget;
pub use wish::Need;
pub use world::{Change, DEFAULT_REACH, Eye, UnknownLevel, WantedRoom, World};
