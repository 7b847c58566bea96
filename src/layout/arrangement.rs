//! Arrangements of the pieces that look for their places together, and what a room remembers of them.

use core::cell::OnceCell;

use super::place::{AgentIndex, Place};

/// A piece at its place.
#[derive(Clone, Debug)]
pub(crate) struct Standing {
    /// Who stands there.
    pub(crate) agent: AgentIndex,
    /// In which of its sizes and looks.
    pub(crate) variant: u32,
    /// Where.
    pub(crate) place: Place,
}

/// Where the first few pieces stand.
#[derive(Clone, Debug, Default)]
pub(crate) struct Arrangement {
    /// In the order in which they were placed.
    pub(crate) standings: Vec<Standing>,
    /// How good it is; compared within one search.
    pub(crate) points: f64,
}

/// What one search found.
#[derive(Clone, Debug)]
pub(crate) struct FoundArrangements {
    /// The best first.
    pub(crate) best_first: Vec<Arrangement>,
    /// The steps of the search.
    pub(crate) steps: u64,
}

/// The arrangements of the first attempt at a room, found once: each further attempt takes another of them. Without and with the
/// heed of tags ([`super::environment::Start::heeds_tags`]), which changes the points.
#[derive(Debug, Default)]
pub(crate) struct KnownArrangements([OnceCell<FoundArrangements>; 2]);

impl KnownArrangements {
    /// Those of before, or what `search` finds.
    pub(crate) fn get_or_find(
        &self,
        heeds_tags: bool,
        search: impl FnOnce() -> FoundArrangements,
    ) -> &FoundArrangements {
        self.0[usize::from(heeds_tags)].get_or_init(search)
    }
}
