//! Machines for offices, corridors and hotel rooms.

mod minibar;
mod printer;
mod vending;

pub(super) use minibar::MINIBAR;
pub(super) use printer::PRINTER;
pub(super) use vending::VENDING_MACHINE;
