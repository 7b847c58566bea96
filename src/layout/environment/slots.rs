//! Slots of a lattice that were refused: in a hall of a thousand seats the last does not test the places of all others anew.

use crate::catalog::ClassIndex;
use crate::layout::furnished::RemovalReason;
use crate::layout::lattice::Lattice;
use crate::layout::place::{AgentIndex, ParentPart};

use super::Environment;

/// The refused slots of the lattice that was asked for last.
#[derive(Debug, Default)]
pub(super) struct RefusedSlots {
    asked: Option<Asked>,
    refused: Vec<Option<Refused>>,
}

/// What the poses of slots, and what may stand there, depend on.
#[derive(Debug, PartialEq)]
struct Asked {
    class: ClassIndex,
    variant: u32,
    parent: ParentPart,
    lattice: Lattice,
}

/// Why a slot was refused.
#[derive(Clone, Copy, Debug)]
struct Refused {
    reason: RemovalReason,
    /// The work of finding out. It counts again, so that nothing depends on what is known.
    steps: u64,
}

impl RefusedSlots {
    /// Somebody left, who may have been in the way.
    pub(super) fn forget(&mut self) {
        self.asked = None;
    }
}

impl Environment<'_> {
    /// An agent begins to ask for the slots of a lattice. Explanations know nothing: they say what is in the way.
    pub(crate) fn begin_slots(&self, agent: AgentIndex, parent: ParentPart, lattice: Lattice) {
        let mut slots = self.refused_slots.borrow_mut();
        let piece = self.agents[agent].piece;
        // The children of an agent are in nobody's way but that of others.
        if self.trace.is_some() || !self.agents[agent].children.is_empty() {
            return slots.forget();
        }
        let asked = Some(Asked { class: piece.class, variant: piece.variant, parent, lattice });
        if slots.asked != asked {
            *slots = RefusedSlots { asked, refused: Vec::new() };
        }
    }

    /// Why a slot was refused before, and is still.
    pub(crate) fn known_refusal(&self, slot: usize) -> Option<RemovalReason> {
        let slots = self.refused_slots.borrow();
        let Refused { reason, steps } = slots.refused.get(slot).copied().flatten()?;
        slots.asked.as_ref()?;
        self.count_steps(steps);
        Some(reason)
    }

    /// Notes that a slot was refused with so many steps, if that holds for all others of the class until somebody leaves the room.
    pub(crate) fn note_refusal(&self, slot: usize, reason: RemovalReason, steps: u64) {
        // Clearances are asked last: what is refused for them may be refused for a body tomorrow.
        if !matches!(reason, RemovalReason::Outside | RemovalReason::Collision) {
            return;
        }
        let refused = &mut self.refused_slots.borrow_mut().refused;
        if refused.len() <= slot {
            refused.resize(slot + 1, None);
        }
        refused[slot] = Some(Refused { reason, steps });
    }
}
