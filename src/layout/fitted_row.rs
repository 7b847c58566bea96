//! Rows of fitted units that are free in a room.

use super::spot::Spot;

/// A unit in its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FittedUnit {
    /// Which unit, by index.
    pub(crate) unit: usize,
    /// The variant of its class.
    pub(crate) variant: u32,
    /// Where its back is.
    pub(crate) spot: Spot,
    /// Its metres along the wall.
    pub(crate) width: f64,
}

impl FittedUnit {
    /// Metres from the wall's start to its nearer side.
    pub(crate) fn from(&self) -> f64 {
        self.spot.from
    }

    /// Metres from the wall's start to its farther side.
    pub(crate) fn to(&self) -> f64 {
        self.spot.from + self.width
    }

    /// Whether it stands before an open side.
    pub(crate) fn is_bar(&self) -> bool {
        self.spot.is_before_opening()
    }
}

/// The walls at the backs of units and the open sides that they are bars along, sorted.
pub(crate) fn walls_of(standings: &[FittedUnit]) -> Vec<(usize, bool)> {
    let mut walls: Vec<(usize, bool)> =
        standings.iter().map(|standing| (standing.spot.wall, standing.is_bar())).collect();
    walls.sort_unstable();
    walls.dedup();
    walls
}

/// A row that is free of everything.
#[derive(Clone, Debug)]
pub(crate) struct FreeRow {
    /// Who stands where; units in corners first.
    pub(crate) standings: Vec<FittedUnit>,
    /// How good it is, with the space before its units.
    pub(crate) points: f64,
    /// Whether a unit has less space before it than is good.
    pub(crate) is_tight: bool,
}
