//! Projects: the plans, edits, catalogue and models of a run, for a bake or for one room on demand.
//!
//! Callers may rely on:
//! - a [`Project`] that was read holds at least one building;
//! - inputs that could not be read are missing from it and named in [`Project::faults`];
//! - a room that [`Rooms`] furnishes is the one that a bake with the same options writes.

mod plausible;
mod read;
mod rooms;
mod unknown;
mod writer;

pub use read::{EditsChoice, Project, ProjectPaths};
pub use rooms::{FinishedRoom, Rooms};
pub use unknown::{UnknownRoom, UnknownStyle};
pub(crate) use writer::{RoomView, RoomWriter, WrittenRoom};
