//! Slots of a lattice that were refused: in a hall of a thousand seats the last does not test the places of all others anew.

use crate::catalog::ClassIndex;

use super::furnished::RemovalReason;
use super::lattice::Lattice;
use super::place::ParentPart;

/// The refused slots of the lattice that was asked for last.
#[derive(Debug, Default)]
pub(crate) struct RefusedSlots {
    asked: Option<AskedSlots>,
    refused: Vec<Option<Refused>>,
}

/// What the poses of slots, and what may stand there, depend on.
#[derive(Debug, PartialEq)]
pub(crate) struct AskedSlots {
    /// Who asks.
    pub(crate) class: ClassIndex,
    /// In which size.
    pub(crate) variant: u32,
    /// The floor or the ceiling.
    pub(crate) parent: ParentPart,
    /// Where the slots are.
    pub(crate) lattice: Lattice,
}

/// Why a slot was refused.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Refused {
    /// The reason; it holds for all others of the class until somebody leaves the room.
    pub(crate) reason: RemovalReason,
    /// The work of finding out. It counts again, so that nothing depends on what is known.
    pub(crate) steps: u64,
}

impl RefusedSlots {
    /// Slots are asked for; what is known of others is forgotten.
    pub(crate) fn begin(&mut self, asked: AskedSlots) {
        if self.asked.as_ref() != Some(&asked) {
            *self = Self { asked: Some(asked), refused: Vec::new() };
        }
    }

    /// Somebody left, who may have been in the way.
    pub(crate) fn forget(&mut self) {
        self.asked = None;
    }

    /// What is known of a slot.
    pub(crate) fn known(&self, slot: usize) -> Option<Refused> {
        self.asked.as_ref()?;
        self.refused.get(slot).copied().flatten()
    }

    /// Notes what was found out about a slot.
    pub(crate) fn note(&mut self, slot: usize, refused: Refused) {
        if self.refused.len() <= slot {
            self.refused.resize(slot + 1, None);
        }
        self.refused[slot] = Some(refused);
    }
}
