//! Plans, edits, catalogue and models that belong together: what a bake or a room on demand starts from.
//!
//! What callers may rely on: a [`Project`] that was read holds at least one building; what could not be read is missing from
//! it and named in [`Project::faults`]. A room that [`Rooms`] furnishes is the one that a bake with the same options writes.

mod plausible;
mod read;
mod rooms;

pub use read::{EditsChoice, Project, ProjectPaths};
pub use rooms::{FinishedRoom, RoomId, Rooms, UnknownRoom};
