//! Portable computers and screens for pictures.

use glam::DVec2;

use super::input::Draft;
use crate::catalog::Side;
use crate::model::kit::{Axis, Builder, SINK, extrude};

/// An open portable computer.
pub(super) fn laptop(_draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let base = (bay.height() * 0.08).min(0.02);
    let lean = (bay.depth() * 0.25).min(bay.height() * 0.35);
    let deck = bay.with_y([0.0, base]).without(Side::Back, lean * 0.7);
    builder.block("metal", deck, base * 0.25);
    let keys = deck.slab(Side::Back, deck.depth() * 0.6).inset(deck.width() * 0.06, 0.0, deck.depth() * 0.06);
    builder.cuboid("plastic_dark", keys.with_y([base - SINK, base + 0.0015]));
    let pad = deck.slab(Side::Front, deck.depth() * 0.3).inset(deck.width() * 0.34, 0.0, deck.depth() * 0.03);
    builder.cuboid("metal_dark", pad.with_y([base - SINK, base + 0.0007]));
    let (foot, head) = (deck.low.z, bay.low.z);
    let thick = 0.008_f64.min(bay.depth() * 0.05);
    let lid =
        [(foot, base * 0.5), (foot + thick, base * 0.5), (head + thick, bay.high.y), (head, bay.high.y)];
    builder.add("metal", extrude(&lid.map(DVec2::from), Axis::X, bay.inset(0.001, 0.0, 0.0).x()));
    let along =
        |share: f64| (foot + thick + (head - foot) * share, base * 0.5 + (bay.high.y - base * 0.5) * share);
    let (low, high) = (along(0.1), along(0.95));
    let glass =
        [(low.0 - 0.002, low.1), (low.0 + 0.001, low.1), (high.0 + 0.001, high.1), (high.0 - 0.002, high.1)];
    let border = bay.width() * 0.03;
    builder
        .add("screen", extrude(&glass.map(DVec2::from), Axis::X, [bay.low.x + border, bay.high.x - border]));
}

/// A pull-down screen with its case above.
pub(super) fn projection_screen(_draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let case = (bay.height() * 0.08).min(0.1);
    builder.block("painted", bay.slab(Side::Above, case), bay.depth() * 0.15);
    let z = bay.center().z;
    let sheet = bay.inset(bay.width() * 0.02, 0.0, 0.0).with_y([0.012, bay.high.y - case + SINK]);
    builder.cuboid("metal_dark", sheet.with_z([z - 0.002, z + 0.002]));
    let picture =
        sheet.inset(bay.width() * 0.02, 0.0, 0.0).without(Side::Below, 0.05).without(Side::Above, 0.05);
    builder.cuboid("paper", picture.with_z([z + 0.001, z + 0.004]));
    builder.cuboid("metal", sheet.with_y([0.0, 0.025]).inset(-0.01, 0.0, 0.0).with_z([z - 0.012, z + 0.012]));
}
