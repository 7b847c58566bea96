//! Machines for offices, corridors and hotel rooms.

mod minibar;
mod printer;
mod vending;

pub(super) use minibar::minibar;
pub(super) use printer::printer;
pub(super) use vending::vending_machine;
