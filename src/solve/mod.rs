//! The search for places in an empty room: which pieces it could hold, and where. A stage between `audit` and `best`.
//!
//! The audit judges what stands and asks, of what does not, whether the plan leaves a place for it
//! ([`crate::audit::Question`]). The solver answers by search, and gives the places it found to the next
//! attempt of the layout. It takes the audit's geometry and the ways of `walk`, and places nothing itself.
//!
//! A search is paid from the budget of a judgement ([`budget`]): where that is spent, the answer is that nothing is known.

mod answers;
mod borders;
mod budget;
mod constants;
mod empty_room;
mod footprint;
mod hold;
mod known;
mod space;
mod spots;
#[cfg(test)]
mod tests;
mod together;

use core::cell::Cell;

use crate::audit::{self, Verdict};
use crate::catalog::Catalog;
use crate::layout::{Furnished, Suggestion};
use crate::plan::RoomRef;
use crate::walk::EmptyFloors;

use answers::Answers;
use constants::MOST_STEPS;
use empty_room::EmptyRoom;

/// Judges one furnished room.
///
/// `furnished` is what the layout made of the room.
///
/// # Panics
/// If `furnished` names a class, parent, wall or opening that does not exist.
#[must_use]
pub fn judge_room(at: RoomRef<'_>, furnished: &Furnished, catalog: &Catalog) -> Verdict {
    RoomSolver::new(at, catalog).judge(furnished)
}

/// Judges several arrangements of one room; what it finds out about the empty room for one of them it knows for the others.
/// No answer depends on what was asked before.
#[derive(Debug)]
pub struct RoomSolver<'a> {
    catalog: &'a Catalog,
    empty_floors: EmptyFloors<'a>,
    answers: Answers,
    /// Steps made so far.
    steps: Cell<u64>,
}

impl<'a> RoomSolver<'a> {
    /// Knows nothing of the room yet.
    #[must_use]
    pub fn new(at: RoomRef<'a>, catalog: &'a Catalog) -> Self {
        let empty_floors = EmptyFloors::new(at, &catalog.audit);
        Self { catalog, empty_floors, answers: Answers::default(), steps: Cell::new(0) }
    }

    /// Judges one arrangement.
    ///
    /// # Panics
    /// As [`judge_room`].
    #[must_use]
    pub fn judge(&self, furnished: &Furnished) -> Verdict {
        self.search(|room| {
            let ask = |question: &audit::Question<'_>| self.answers.answer(room, question);
            audit::judge(&self.empty_floors, furnished, self.catalog, &ask)
        })
    }

    /// Where the pieces could stand that the room misses and cannot do without, beside whatever else it cannot do without:
    /// places found in the empty room, for [`crate::layout::RoomLayout`]. Empty where nothing is missing or no
    /// such places were found.
    ///
    /// # Panics
    /// As [`judge_room`].
    #[must_use]
    pub fn suggest_places(&self, furnished: &Furnished) -> Vec<Suggestion> {
        let missing = audit::missing_pieces(&self.empty_floors, furnished, self.catalog);
        self.search(|room| {
            // In the order of the missing pieces: the first list of which all pieces find places together.
            let mut places = missing.iter().map(|classes| self.answers.places_together(room, classes));
            places.find_map(|places| places).unwrap_or_default()
        })
    }

    /// Steps that were made so far to find out what the empty room could hold, the same on every machine.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.steps.get()
    }

    /// Searches with a new budget, and counts what it took.
    fn search<T>(&self, work: impl FnOnce(&EmptyRoom<'a>) -> T) -> T {
        let room = EmptyRoom::new(self.empty_floors.at(), self.catalog, MOST_STEPS);
        let found = work(&room);
        self.steps.set(self.steps.get() + room.budget.made());
        found
    }
}
