//! Dispensers of paper and soap on the walls of bathrooms.

use super::input::Draft;
use crate::catalog::Side;
use crate::model::kit::{Builder, SINK};

/// A paper or soap dispenser on a wall.
pub(super) fn dispenser(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let slot = draft.sampler().pick(&["plastic", "metal"]);
    builder.block(
        slot,
        bay.without(Side::Below, bay.height() * 0.1).without(Side::Front, bay.depth() * 0.06),
        bay.depth() * 0.15,
    );
    let mouth =
        bay.slab(Side::Below, bay.height() * 0.1 + SINK).inset(bay.width() * 0.25, 0.0, bay.depth() * 0.3);
    builder.cuboid("paper", mouth);
    let window =
        bay.inset(bay.width() * 0.42, bay.height() * 0.25, 0.0).slab(Side::Front, bay.depth() * 0.08);
    builder.cuboid("plastic_dark", window);
}
