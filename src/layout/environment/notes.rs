//! What agents meet on their search, noted where somebody wants to know.

use crate::layout::furnished::RemovalReason;
use crate::layout::place::{AgentIndex, Place};
use crate::layout::rules::unmet_need;
use crate::layout::trace::Obstacle;

use super::Environment;

impl Environment<'_> {
    /// An agent begins to search.
    pub(crate) fn note_search(&self, agent: AgentIndex) {
        if let Some(trace) = &self.trace {
            trace.borrow_mut().record_mut(agent).searches += 1;
        }
    }

    /// A place was free.
    pub(crate) fn note_free(&self, agent: AgentIndex) {
        if let Some(trace) = &self.trace {
            trace.borrow_mut().record_mut(agent).places += 1;
        }
    }

    /// A group was pushed; its head tells.
    pub(crate) fn note_push(&self, agent: AgentIndex) {
        if let Some(trace) = &self.trace {
            trace.borrow_mut().record_mut(agent).was_pushed = true;
        }
    }

    /// A place was refused.
    pub(crate) fn note_refusal(&self, agent: AgentIndex, place: &Place, reason: RemovalReason) {
        if self.trace.is_some() {
            self.record_refusal(agent, place, reason);
        }
    }

    #[cold]
    fn record_refusal(&self, agent: AgentIndex, place: &Place, reason: RemovalReason) {
        let Some(trace) = &self.trace else { return };
        let obstacles = match reason {
            RemovalReason::Relation => {
                unmet_need(self, agent, place).map(Obstacle::Relation).into_iter().collect()
            }
            _ => self.obstacles(agent, place, reason),
        };
        let mut trace = trace.borrow_mut();
        let record = trace.record_mut(agent);
        record.places += 1;
        record.refused.add(reason, obstacles);
    }
}
