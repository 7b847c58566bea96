//! Decides who lives in each dwelling of a building, and what each of its rooms is: main bedroom, child's room, study.
//!
//! Later stages may rely on:
//! - a room whose type says what it is keeps that type; only types that a role of `households.yaml` names are narrowed;
//! - the same building, id, configuration and seed give the same households, in whatever order levels are asked for;
//! - a dwelling depends on its own rooms and openings only: no other dwelling changes it, and no edit does;
//! - shapes, numbers and ids of rooms stay, and with them the seeds of their furniture.

mod claims;
mod draw;
mod groups;
mod living;
mod occupancy;
mod rooms;
#[cfg(test)]
mod tests;

pub(crate) use draw::shared_draw;
pub use occupancy::{LevelHomes, Occupancy, occupied};
