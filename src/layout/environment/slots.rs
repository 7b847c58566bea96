//! What an environment knows of the slots of a lattice.

use crate::layout::furnished::RemovalReason;
use crate::layout::lattice::Lattice;
use crate::layout::place::{AgentIndex, ParentPart};
use crate::layout::refused_slots::{AskedSlots, Refused};

use super::Environment;

impl Environment<'_> {
    /// An agent begins to ask for the slots of a lattice. Explanations know nothing: they say what is in the way.
    pub(crate) fn begin_slots(&self, agent: AgentIndex, parent: ParentPart, lattice: Lattice) {
        let mut slots = self.refused_slots.borrow_mut();
        let piece = self.agents[agent].piece;
        // An agent is not in the way of its own children, others are: what it is refused says nothing of them.
        if self.trace.is_some() || !self.agents[agent].children.is_empty() {
            return slots.forget();
        }
        slots.begin(AskedSlots { class: piece.class, variant: piece.variant, parent, lattice });
    }

    /// Why a slot was refused before, and is still.
    pub(crate) fn known_refusal(&self, slot: usize) -> Option<RemovalReason> {
        let Refused { reason, steps } = self.refused_slots.borrow().known(slot)?;
        self.count_steps(steps);
        Some(reason)
    }

    /// Notes that a slot was refused with so many steps, if that holds for all others of the class until somebody leaves the room.
    pub(crate) fn note_refusal(&self, slot: usize, reason: RemovalReason, steps: u64) {
        // Clearances are asked last: what is refused for them may be refused for a body tomorrow.
        if matches!(reason, RemovalReason::Outside | RemovalReason::Collision) {
            self.refused_slots.borrow_mut().note(slot, Refused { reason, steps });
        }
    }
}
