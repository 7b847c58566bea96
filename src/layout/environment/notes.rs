//! Notes of the search for an explanation: the places that an agent tried, and the obstacles there.

use std::collections::BTreeSet;

use crate::layout::furnished::RemovalReason;
use crate::layout::place::{AgentIndex, Place};
use crate::layout::rules::{Factor, unmet_need, weigh};
use crate::layout::trace::Obstacle;

use super::Environment;
use super::obstruction::Recorder;

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

    /// A group was pushed; it is noted for its head.
    pub(crate) fn note_push(&self, agent: AgentIndex) {
        if let Some(trace) = &self.trace {
            trace.borrow_mut().record_mut(agent).was_pushed = true;
        }
    }

    /// Why an agent cannot or will not stand at a place; what is in the way is noted.
    pub(crate) fn refusal(&self, agent: AgentIndex, place: &Place) -> Option<RemovalReason> {
        // The usual case, in every search: the compiler leaves out all that would record.
        if self.trace.is_none() {
            return self.refusal_by(agent, place, &mut ());
        }
        let mut obstacles = BTreeSet::new();
        let reason = self.refusal_by(agent, place, &mut obstacles)?;
        self.note_refused(agent, reason, obstacles);
        Some(reason)
    }

    fn refusal_by<R: Recorder>(
        &self,
        agent: AgentIndex,
        place: &Place,
        recorder: &mut R,
    ) -> Option<RemovalReason> {
        self.obstruction(agent, place, recorder).or_else(|| {
            let unmet = unmet_need(self, agent, place)?;
            recorder.record(Obstacle::Relation(unmet));
            Some(RemovalReason::Relation)
        })
    }

    /// A free place was refused because it would make the room tight or dark.
    pub(crate) fn note_discomfort(&self, agent: AgentIndex, place: &Place) {
        if self.trace.is_some() {
            self.note_refused(agent, RemovalReason::Comfort, self.discomforts(agent, place));
        }
    }

    fn discomforts(&self, agent: AgentIndex, place: &Place) -> BTreeSet<Obstacle> {
        let mut found = BTreeSet::new();
        weigh(self, agent, place, |factor, _| match factor {
            Factor::Wish(_) | Factor::Wall | Factor::SuitsWall => {}
            Factor::BeforeWindow => found.record(Obstacle::WindowBehind),
            Factor::SeatsInWays | Factor::TakesSeat => found.record(Obstacle::Seat),
            Factor::Tight { takes, lacks } => {
                if lacks {
                    found.record(Obstacle::OwnComfort);
                }
                if takes {
                    self.takes_comfort(agent, place, &mut found);
                }
            }
        });
        found
    }

    fn note_refused(&self, agent: AgentIndex, reason: RemovalReason, obstacles: BTreeSet<Obstacle>) {
        let Some(trace) = &self.trace else { return };
        let mut trace = trace.borrow_mut();
        let record = trace.record_mut(agent);
        record.places += 1;
        record.refused.add(reason, obstacles);
    }
}
