//! Apparatus of laboratories and shops.

mod checkout;
mod chest_freezer;
mod chilled_shelf;
mod fume_cupboard;

pub(super) use checkout::CHECKOUT;
pub(super) use chest_freezer::CHEST_FREEZER;
pub(super) use chilled_shelf::CHILLED_SHELF;
pub(super) use fume_cupboard::FUME_CUPBOARD;
