//! Open shelves, racks and show cases.

mod bookshelf;
mod display_case;
mod gondola;
mod magazine_rack;
mod shelf;

pub(super) use bookshelf::bookshelf;
pub(super) use display_case::display_case;
pub(super) use gondola::gondola;
pub(super) use magazine_rack::magazine_rack;
pub(super) use shelf::shelf;

/// Metres of a board.
const BOARD: f64 = 0.02;
