//! What judgements of a room found out about the empty room.

use core::cell::Cell;

use crate::catalog::ClassIndex;

use super::budget::Known;
use super::fit::Stands;
use super::together::Together;

/// Answers that depend on level, room and catalogue alone.
#[derive(Debug, Default)]
pub(crate) struct RoomKnowledge {
    /// Whether the room holds a class with its smallest clearances.
    pub(crate) held: Known<ClassIndex, bool>,
    /// Whether it holds a size of a class, in the bits of its lengths, with its good clearances.
    pub(crate) held_comfortably: Known<(ClassIndex, [u64; 3]), bool>,
    /// The free places of the smallest size of a class.
    pub(crate) stands: Known<ClassIndex, Stands>,
    /// Whether it holds one piece of each of some classes.
    pub(crate) together: Known<Vec<ClassIndex>, Together>,
    /// Steps made to find it out.
    pub(crate) steps: Cell<u64>,
}
