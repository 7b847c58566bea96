//! Suggested places, from `solve`: an agent is sure to fit there if it comes first.

use crate::catalog::{ClassIndex, Size};
use crate::geometry::Point;

/// One of the arrangements of a room.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Alternative {
    /// Counts the arrangements of a room from 0.
    pub number: u32,
    /// Where some pieces should try to stand first.
    pub suggestions: Vec<Suggestion>,
    /// Whether required pieces that find no place are replaced by what may stand in for them.
    pub takes_substitutes: bool,
    /// Whether the others search only when all required pieces stand and the ways to them are clear.
    pub puts_required_first: bool,
    /// Missing pieces, and steps down for those that others stand in for, with which it is given up before it is finished: the caller
    /// has an arrangement that lacks no more. `None` if it is finished anyway.
    pub gives_up_at: Option<u32>,
}

impl Alternative {
    /// An arrangement without suggestions.
    #[must_use]
    pub fn numbered(number: u32) -> Self {
        Self { number, ..Self::default() }
    }
}

/// A place on the floor for the first piece of a class.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Suggestion {
    /// Index into the catalogue's classes.
    pub class: ClassIndex,
    /// One of the class's sizes.
    pub size: Size,
    /// Middle of the underside, in the level's plan frame.
    pub position: Point,
    /// Radians counter-clockwise; at zero the front faces −y.
    pub angle: f64,
    /// The wall that it has its back to, by index into the room's walls.
    pub wall: Option<usize>,
}
