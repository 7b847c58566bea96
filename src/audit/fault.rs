//! The result of a check: what is wrong, without a code yet. The table ([`super::checks`]) says which finding it becomes.

use crate::catalog::ClassIndex;
use crate::geometry::Point;

use super::possible::Held;
use super::quantity::Quantity;

/// An object or a part of a room that a finding is about, or a class of which a piece is missing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Element {
    /// An object, by index into the placements of the room.
    Object(usize),
    /// By index into the level's openings.
    Opening(usize),
    /// By index into the room's walls.
    Wall(usize),
    /// By index into the room's obstacles.
    Column(usize),
    /// A class of which a piece is missing.
    Class(ClassIndex),
}

/// An element with its id in the output.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Named {
    /// The id.
    pub(crate) id: String,
    /// What it is.
    pub(crate) element: Element,
}

/// A region of floor: corners in plan metres, counter-clockwise.
pub type FloorRegion = Vec<Point>;

/// A fault of a furnished room.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Fault {
    /// The elements that it is about.
    pub(crate) subjects: Vec<Named>,
    /// The measured quantity.
    pub(crate) quantity: Quantity,
    /// The measured value, in the unit of the quantity.
    pub(crate) measured: f64,
    /// The threshold that it breaks, in the same unit.
    pub(crate) threshold: f64,
    /// The floor that it is about; empty where it is about elements only.
    pub(crate) region: Vec<FloorRegion>,
    /// Whether the plan leaves another choice.
    pub(crate) is_possible: Held,
}

impl Fault {
    /// A fault that another arrangement of the room need not have.
    pub(crate) fn new(quantity: Quantity, subjects: Vec<Named>, measured: f64, threshold: f64) -> Self {
        Self { subjects, quantity, measured, threshold, region: Vec::new(), is_possible: Held::Yes }
    }

    /// The same with the floor that it is about.
    pub(crate) fn about(self, region: Vec<FloorRegion>) -> Self {
        Self { region, ..self }
    }

    /// The same after a search for whether the plan leaves another choice.
    pub(crate) fn if_possible(self, is_possible: Held) -> Self {
        Self { is_possible, ..self }
    }
}
