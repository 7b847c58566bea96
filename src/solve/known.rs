//! Answers that are remembered, each with the steps that it took.
//!
//! The answers depend on level, room and catalogue alone, so that further arrangements of the same room need not search
//! again. A remembered answer is charged like one that is searched for: whether a judgement gives up depends on the
//! room that it judges, never on those judged before.

use core::cell::RefCell;
use std::collections::BTreeMap;

use super::budget::Budget;

/// Answers by question, each with what it took.
#[derive(Debug)]
pub(crate) struct Known<K, V> {
    answers: RefCell<BTreeMap<K, Answer<V>>>,
}

#[derive(Clone, Copy, Debug)]
enum Answer<V> {
    /// Found out in so many steps.
    Found(V, u64),
    /// Takes more than so many steps.
    Beyond(u64),
}

impl<K, V> Default for Known<K, V> {
    fn default() -> Self {
        Self { answers: RefCell::new(BTreeMap::new()) }
    }
}

impl<K: Ord, V: Clone> Known<K, V> {
    /// The answer to a question: a remembered one, or what `search` finds; nothing where the budget does not suffice.
    pub(crate) fn answer(&self, question: K, budget: &Budget, search: impl FnOnce() -> V) -> Option<V> {
        let known = self.answers.borrow().get(&question).cloned();
        match known {
            Some(Answer::Found(answer, steps)) => return budget.charge(steps).then_some(answer),
            Some(Answer::Beyond(steps)) if budget.left() <= steps => {
                // An earlier search gave up with as many steps as are left now. This one would too: the budget is overdrawn as by
                // it.
                budget.charge(u64::MAX);
                return None;
            }
            _ => {}
        }
        let before = budget.left();
        if budget.is_overdrawn() {
            return None;
        }
        let found = search();
        let is_found = !budget.is_overdrawn();
        let answer = if is_found {
            Answer::Found(found.clone(), before - budget.left())
        } else {
            Answer::Beyond(before)
        };
        self.answers.borrow_mut().insert(question, answer);
        is_found.then_some(found)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Asks for something that takes 10 steps; the answer, what is left, and whether it was searched for.
    fn ask(known: &Known<u8, u8>, steps: u64) -> (Option<u8>, u64, bool) {
        let budget = Budget::new(steps);
        let mut has_searched = false;
        let answer = known.answer(1, &budget, || {
            has_searched = true;
            (0..10).for_each(|_| _ = budget.spend(1));
            7
        });
        (answer, budget.left(), has_searched)
    }

    #[test]
    fn a_remembered_answer_costs_as_much_as_one_that_is_searched_for() {
        for steps in [0, 9, 10, 25] {
            let known = Known::default();
            let (first, left, _) = ask(&known, steps);
            assert_eq!(first, (steps >= 10).then_some(7), "{steps} steps");
            for _ in 0..2 {
                assert_eq!(ask(&known, steps), (first, left, false), "{steps} steps");
            }
        }
    }

    #[test]
    fn a_search_that_was_given_up_is_made_again_with_more_steps() {
        let known = Known::default();
        assert_eq!(ask(&known, 9), (None, 0, true));
        assert_eq!(ask(&known, 8), (None, 0, false));
        assert_eq!(ask(&known, 12), (Some(7), 2, true));
        assert_eq!(ask(&known, 9), (None, 0, false));
    }

    #[test]
    fn an_overdrawn_budget_gets_no_further_answers() {
        let (budget, known) = (Budget::new(5), Known::<u8, u8>::default());
        assert!(budget.spend(5) && !budget.is_overdrawn());
        assert!(!budget.spend(1) && !budget.spend(0));
        assert_eq!(known.answer(1, &budget, || 7), None);
    }
}
