//! Collects the faults of a model at their places in its text; what many rooms share is said once, with a count.

use std::collections::BTreeMap;

use super::model::Place;
use crate::document::{Faults, Source, counted};
use crate::plan::read::told::DocumentFaults;

/// Something that is said once for all parts of a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Topic {
    /// The part, in the singular.
    what: &'static str,
    /// What became of it.
    fact: &'static str,
    hint: &'static str,
}

/// Rooms that are no rooms.
pub(super) const PLENUM: Topic = Topic {
    what: "plenum",
    fact: "left out: nobody stands between a ceiling and the floor above",
    hint: "name its program otherwise if it is a room",
};
/// Rooms under slopes.
pub(super) const SLOPING: Topic = Topic {
    what: "room",
    fact: "with a sloping or stepped ceiling, read as a flat one",
    hint: "the ceiling is at its lowest part, and 2 m high at least",
};
/// Rooms above or below the floor of their storey.
pub(super) const STEPPED: Topic = Topic {
    what: "room",
    fact: "with a floor above that of the storey, read as level with it",
    hint: "give the rooms a storey of their own if they lie above others",
};
/// Windows above windows.
pub(super) const STACKED: Topic = Topic {
    what: "window",
    fact: "above or over another in the same wall, read as one with it",
    hint: "a stretch of wall has one opening",
};
/// Windows above doors.
pub(super) const OVER_DOOR: Topic = Topic {
    what: "window",
    fact: "left out: a door stands in the same stretch of wall",
    hint: "a stretch of wall has one opening, and doors come first",
};
/// Windows of models that are no models of buildings.
pub(super) const TOO_MANY: Topic = Topic {
    what: "wall",
    fact: "without its windows: the model has more than 200000",
    hint: "divide it into several models",
};
/// Openings that are none.
pub(super) const TINY: Topic = Topic {
    what: "opening",
    fact: "left out: narrower or lower than 0.1 m, or below the floor",
    hint: "delete it, or draw it larger",
};
/// Rooms that stand for several.
pub(super) const MULTIPLIED: Topic = Topic {
    what: "room",
    fact: "that the model multiplies, read once: it does not say where the others are",
    hint: "build the storeys themselves (in Grasshopper, the model of DF Model To Honeybee with full geometry)",
};
/// Rooms without doors.
pub(super) const NO_WAY_IN: Topic = Topic {
    what: "room",
    fact: "without a way in: the model draws neither a door nor an air boundary",
    hint: "add doors or air boundaries in the model, or to the plan that `import` writes",
};
/// Walls that lead nowhere.
pub(super) const NO_NEIGHBOUR: Topic = Topic {
    what: "wall",
    fact: "against a room that the model does not hold on this storey, read as if nothing were behind",
    hint: "solve adjacency again in the program that wrote the file",
};
/// Walls whose neighbours lie elsewhere.
pub(super) const APART: Topic = Topic {
    what: "wall",
    fact: "not beside the room that it names as adjacent",
    hint: "solve adjacency again in the program that wrote the file; doors join what lies beside them",
};

/// The faults so far.
pub(super) struct Notes {
    faults: DocumentFaults,
    /// Topic → its first place, and how often.
    topics: BTreeMap<Topic, (Place, usize)>,
}

impl Notes {
    pub(super) fn new(source: Source) -> Self {
        Self { faults: DocumentFaults::new(source), topics: BTreeMap::new() }
    }

    /// A part that is left out.
    pub(super) fn error(&mut self, place: &Place, message: impl Into<String>, hint: &str) {
        self.faults.error(place, message, hint);
    }

    /// A part that is read otherwise than it is written.
    pub(super) fn warn(&mut self, place: &Place, message: impl Into<String>, hint: &str) {
        self.faults.warn(place, message, hint);
    }

    /// One more part of which a topic is true.
    pub(super) fn count(&mut self, topic: Topic, place: impl FnOnce() -> Place) {
        self.topics.entry(topic).or_insert_with(|| (place(), 0)).1 += 1;
    }

    /// How often a topic was counted.
    #[cfg(test)]
    pub(super) fn counted(&self, topic: Topic) -> usize {
        self.topics.get(&topic).map_or(0, |(_, count)| *count)
    }

    pub(super) fn finish(mut self) -> Faults {
        for (Topic { what, fact, hint }, (place, count)) in std::mem::take(&mut self.topics) {
            let message = format!("{} {fact}", counted(count, what));
            self.faults.warn_always(&place, message, hint);
        }
        self.faults.finish()
    }
}
