//! Questions about the empty room that the audit asks to judge a furnished one; its caller answers them.
//!
//! A finding counts against the furniture only if the plan leaves another choice. Whether it does takes a search, which is
//! no judgement: the answers come from outside ([`Ask`]).

use crate::catalog::{ClassIndex, Size};
use crate::geometry::{Line, Solid};

/// Whether a room has a place for something.
#[derive(Clone, Copy, Debug)]
pub enum Question<'q> {
    /// For some size of a class, with its smallest clearances, on the empty floor.
    Class(ClassIndex),
    /// For a size of a class, with its good clearances, on the empty floor.
    Comfortably {
        /// The class.
        class: ClassIndex,
        /// The size.
        size: Size,
    },
    /// For one piece of each class at the same time, in its smallest size and with its smallest clearances, on the empty
    /// floor, so that ways to doors and to all used sides stay open.
    Together(&'q [ClassIndex]),
    /// For a size of a class, with its smallest clearances, among some bodies on one side of a line.
    Beside {
        /// The class.
        class: ClassIndex,
        /// The size.
        size: Size,
        /// The bodies that stand on the floor.
        among: &'q [&'q Solid],
        /// The piece stays to the left of it.
        line: Line,
    },
}

/// Whether a room has a place for something.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Held {
    /// It has.
    Yes,
    /// It has not.
    No,
    /// The search was given up.
    Unknown,
}

/// Answers the questions of one judgement.
pub type Ask<'a> = &'a dyn Fn(&Question<'_>) -> Held;

impl Held {
    /// An answer, or none where the search was given up.
    #[must_use]
    pub fn of(answer: Option<bool>) -> Self {
        match answer {
            Some(true) => Self::Yes,
            Some(false) => Self::No,
            None => Self::Unknown,
        }
    }

    /// Whether any of some questions, asked until one is answered yes, is.
    pub(crate) fn any(answers: impl Iterator<Item = Self>) -> Self {
        let mut known = Self::No;
        for answer in answers {
            match answer {
                Self::Yes => return Self::Yes,
                Self::Unknown => known = Self::Unknown,
                Self::No => {}
            }
        }
        known
    }
}
