//! Checks the catalogue as a whole: every class reaches a room part, and no entries contradict.

mod contradiction;
mod hierarchy;

pub(crate) use contradiction::check_programmes;
pub(crate) use hierarchy::find_depths;
