//! Open shelves, racks and show cases.

mod bookshelf;
mod display_case;
mod gondola;
mod magazine_rack;
mod shelf;

pub(super) use bookshelf::BOOKSHELF;
pub(super) use display_case::DISPLAY_CASE;
pub(super) use gondola::GONDOLA;
pub(super) use magazine_rack::MAGAZINE_RACK;
pub(super) use shelf::SHELF;

/// Metres of a board.
const BOARD: f64 = 0.02;
