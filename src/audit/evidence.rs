//! The evidence that the checks of a room share, collected once for all of them.

use crate::walk::Floor;

use super::possible::Ask;
use super::subject::Subject;
use super::taking::Taking;
use super::zone::{NearPair, Zone};

/// A furnished room with what people need free in it, and what is near what.
#[derive(Clone, Copy)]
pub(crate) struct Evidence<'e, 'a> {
    /// The room.
    pub(crate) subject: &'e Subject<'a>,
    /// The regions that must or should stay free.
    pub(crate) zones: &'e [Zone],
    /// Which bodies are near it.
    pub(crate) hits: &'e [NearPair<'e>],
    /// Pairs of bodies, by index, that are near each other.
    pub(crate) collisions: &'e [(usize, usize)],
    /// The takings of the good clearances.
    pub(crate) comfort: &'e [Taking],
    /// The floor that people walk on; `None` without doors or without bodies in the way, where there is nothing to judge.
    pub(crate) floor: Option<&'e Floor>,
    /// Answers what the empty room could hold.
    pub(crate) ask: Ask<'e>,
}
