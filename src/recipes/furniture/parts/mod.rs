//! Pieces that several recipes share.

mod books;
mod carcass;
mod foliage;
mod fronts;
mod handles;
mod legs;
mod panel;
mod tap;
mod tops;
mod turned;

pub(super) use books::fill_with_books;
pub(super) use carcass::{Fittings, REVEAL, cornice};
pub(super) use foliage::{Foliage, PotSize, Species, grow, pot};
pub(super) use fronts::Fronts;
pub(super) use handles::{HandleForm, HandleKind, handle};
pub(super) use legs::{CONE, LegKind, SPINDLE, bowed_board, leg, legs_at_corners, slanted_leg};
pub(super) use panel::wall_panel;
pub(super) use tap::{Tap, tap, wall_mixer};
pub(super) use tops::{raised_panel, slab_top, turned_forward};
pub(super) use turned::{across, ball, turned_sideways};
