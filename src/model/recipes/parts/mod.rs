//! Pieces that several recipes share.

mod books;
mod carcass;
mod foliage;
mod handles;
mod legs;
mod tap;
mod tops;

pub(super) use books::fill_with_books;
pub(super) use carcass::{Fittings, REVEAL, cornice};
pub(super) use foliage::{Foliage, grow, pot};
pub(super) use handles::{HandleKind, handle};
pub(super) use legs::{LegKind, leg, legs_at_corners};
pub(super) use tap::tap;
pub(super) use tops::{slab_top, turned_forward};
