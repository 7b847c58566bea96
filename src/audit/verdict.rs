//! All that the audit says about one room.

use serde::Serialize;

use super::finding::{Finding, Grade};
use super::score::Score;

/// The verdict on a furnished room.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Verdict {
    /// Sorted by code, then by objects; none in a good room.
    pub findings: Vec<Finding>,
    /// How good the room is beside that; `None` where nothing was asked for.
    pub score: Option<Score>,
    /// The share of the floor that people reach from each door; empty where nothing stands in the way.
    pub walkable: Vec<DoorRate>,
}

/// The walkable rate of a door (PhyScene, Yang et al. 2024).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DoorRate {
    /// `door:<id>`.
    pub door: String,
    /// Share of all places where somebody could stand that are reached from this door.
    pub rate: f64,
}

impl Verdict {
    /// The grade of the room.
    #[must_use]
    pub fn grade(&self) -> Grade {
        Grade::of(&self.findings)
    }
}
