//! How much work one judgement may spend on questions about the empty room.

use core::cell::Cell;

/// Steps that are left. A step is a place, a border or a body that is looked at, or a few cells of a floor: some
/// nanoseconds.
#[derive(Debug)]
pub(crate) struct Budget {
    left: Cell<u64>,
    is_overdrawn: Cell<bool>,
    /// Steps that were really made.
    made: Cell<u64>,
}

impl Budget {
    pub(crate) fn new(steps: u64) -> Self {
        Self { left: Cell::new(steps), is_overdrawn: Cell::new(false), made: Cell::new(0) }
    }

    /// Makes some steps; answers whether there were as many.
    pub(crate) fn spend(&self, steps: u64) -> bool {
        self.made.set(self.made.get() + steps);
        self.charge(steps)
    }

    /// Steps that were made, without those of remembered answers.
    pub(crate) fn made(&self) -> u64 {
        self.made.get()
    }

    /// Charges some steps that were made before; answers whether there were as many.
    pub(crate) fn charge(&self, steps: u64) -> bool {
        let left = self.left.get();
        self.left.set(left.saturating_sub(steps));
        if steps > left {
            self.is_overdrawn.set(true);
        }
        // Once overdrawn it stays so, even for free steps: a small search must not succeed after a large one that gave up, or
        // answers would depend on the order of the questions.
        !self.is_overdrawn.get()
    }

    /// Whether more steps were asked for than there were: all that is searched from now on is given up.
    pub(crate) fn is_overdrawn(&self) -> bool {
        self.is_overdrawn.get()
    }

    /// Steps that are left.
    pub(crate) fn left(&self) -> u64 {
        self.left.get()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_budget_that_was_overdrawn_once_stays_overdrawn() {
        let budget = Budget::new(5);
        assert!(budget.spend(5) && !budget.is_overdrawn());
        assert!(!budget.spend(1) && !budget.spend(0) && budget.is_overdrawn());
    }
}
