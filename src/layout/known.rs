//! What a room remembers of the searches of its first attempt, so that further attempts take another of what was found.

use core::cell::OnceCell;

/// What one search found.
#[derive(Clone, Debug)]
pub(crate) struct Found<T> {
    /// The best first.
    pub(crate) best_first: Vec<T>,
    /// The steps of the search.
    pub(crate) steps: u64,
}

/// What a search found that a room makes once at most.
pub(crate) type Known<T> = OnceCell<Found<T>>;
