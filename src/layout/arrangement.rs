//! Arrangements of the pieces that look for their places together.

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
