//! Apparatus of laboratories and shops.

mod checkout;
mod chilled_shelf;
mod fume_cupboard;

pub(super) use checkout::checkout;
pub(super) use chilled_shelf::chilled_shelf;
pub(super) use fume_cupboard::fume_cupboard;
