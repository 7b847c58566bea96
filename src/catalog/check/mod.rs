//! What can only be said about the catalogue as a whole: who reaches the floor, and what contradicts.

mod contradiction;
mod hierarchy;

pub(crate) use contradiction::check_programmes;
pub(crate) use hierarchy::find_depths;
