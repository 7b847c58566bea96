//! Apparatus of laboratories and shops.

mod checkout;
mod chest_freezer;
mod chilled_shelf;
mod fume_cupboard;

pub(super) use checkout::checkout;
pub(super) use chest_freezer::chest_freezer;
pub(super) use chilled_shelf::chilled_shelf;
pub(super) use fume_cupboard::fume_cupboard;
