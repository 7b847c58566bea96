//! The questions of the audit about a room, with the answers that were found.

use crate::audit::{Held, Question};
use crate::catalog::ClassIndex;
use crate::layout::Suggestion;

use super::empty_room::EmptyRoom;
use super::hold::{Stands, can_hold, can_hold_comfortably, free_stands, has_room_beside};
use super::known::Known;
use super::together::{Together, place_together};

/// Answers that depend on level, room and catalogue alone.
#[derive(Debug, Default)]
pub(crate) struct Answers {
    /// Whether the room holds a class with its smallest clearances.
    held: Known<ClassIndex, bool>,
    /// Whether it holds a size of a class, in the bits of its lengths, with its good clearances.
    held_comfortably: Known<(ClassIndex, [u64; 3]), bool>,
    /// The free places of the smallest size of a class.
    stands: Known<ClassIndex, Stands>,
    /// Whether it holds one piece of each of some classes.
    together: Known<Vec<ClassIndex>, Together>,
}

impl Answers {
    /// The answer to a question of the audit; [`Held::Unknown`] where the budget of the room is spent.
    pub(crate) fn answer(&self, room: &EmptyRoom<'_>, question: &Question<'_>) -> Held {
        match *question {
            Question::Class(class) => {
                let search = || can_hold(room, class);
                Held::of(self.held.answer(class, &room.budget, search))
            }
            Question::Comfortably { class, size } => {
                let bits = [size.width, size.depth, size.height].map(f64::to_bits);
                let search = || can_hold_comfortably(room, class, size);
                Held::of(self.held_comfortably.answer((class, bits), &room.budget, search))
            }
            Question::Together(classes) => match self.together(room, classes) {
                Together::Fit(_) => Held::Yes,
                Together::TooMuch => Held::No,
                Together::Unknown => Held::Unknown,
            },
            // Asked of what stands there now: no other arrangement asks the same.
            Question::Beside { class, size, among, line } => {
                let is_held = has_room_beside(room, class, size, among, line);
                Held::of((is_held || !room.budget.is_overdrawn()).then_some(is_held))
            }
        }
    }

    /// A place for one piece of each class at the same time, if the search found them.
    pub(crate) fn places_together(
        &self,
        room: &EmptyRoom<'_>,
        classes: &[ClassIndex],
    ) -> Option<Vec<Suggestion>> {
        match self.together(room, classes) {
            Together::Fit(suggestions) => Some(suggestions),
            Together::TooMuch | Together::Unknown => None,
        }
    }

    fn together(&self, room: &EmptyRoom<'_>, classes: &[ClassIndex]) -> Together {
        let stands_of =
            |class: ClassIndex| self.stands.answer(class, &room.budget, || free_stands(room, class));
        // The places of a class are remembered by themselves: other sets of classes ask for them too.
        let search = || place_together(room, classes, stands_of);
        let answer = self.together.answer(classes.to_vec(), &room.budget, search);
        answer.unwrap_or(Together::Unknown)
    }
}
