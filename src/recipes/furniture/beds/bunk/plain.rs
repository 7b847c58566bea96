//! Smooth boards: a full one at the head, one with an opening at the foot, high sides.

use glam::DVec2;

use super::Bunk;
use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::kit::{Axis, Bay, Builder, SINK, extrude};

/// Metres of a board, and of the ladder before the sides.
const BOARD: f64 = 0.024;
const LADDER: f64 = 0.026;

pub(super) fn frame(bunk: &Bunk, builder: &mut Builder) {
    let (bay, [low, high]) = (bunk.bay, bunk.bases);
    let (slot, step) = [
        (Slot::Painted, Slot::Wood),
        (Slot::WoodLight, Slot::WoodLight),
        (Slot::PaintedAccent, Slot::WoodLight),
        (Slot::Wood, Slot::Painted),
    ][bunk.look];
    builder.block(slot, bay.slab(Side::Back, BOARD), 0.006);
    let foot = bay.slab(Side::Front, BOARD);
    for side in [Side::Left, Side::Right] {
        builder.cuboid(slot, foot.slab(side, 0.1));
    }
    let between = foot.inset(0.1 - SINK, 0.0, 0.001);
    builder.cuboid(slot, between.with_y([low - 0.06, low + 0.34]));
    builder.cuboid(slot, between.with_y([high - 0.06, bay.high.y - 0.001]));
    let sides = bay.inset(LADDER - SINK, 0.0, BOARD - SINK);
    let ends = sides.z();
    for side in [Side::Left, Side::Right] {
        builder.cuboid(slot, sides.slab(side, BOARD).with_y([low, low + 0.2]));
    }
    let guard = bay.high.y - 0.02;
    builder.cuboid(slot, sides.slab(Side::Left, BOARD).with_y([high, guard]));
    // The board on the right is low where the ladder leads over it.
    let board = [
        (ends[0], high),
        (ends[1], high),
        (ends[1], high + 0.2),
        (bunk.way_in[0] - 0.006, high + 0.2),
        (bunk.way_in[0] - 0.006, guard),
        (ends[0], guard),
    ]
    .map(DVec2::from);
    builder.add(slot, extrude(&board, Axis::X, sides.slab(Side::Right, BOARD).x()));
    bunk.decks(builder, slot, [LADDER + BOARD - 2.0 * SINK, BOARD - 4.0 * SINK]);
    let ladder = bay.slab(Side::Right, LADDER + SINK).with_z(bunk.way_in).with_y([0.0, high + 0.24]);
    for end in [Side::Front, Side::Back] {
        builder.cuboid(step, ladder.slab(end, 0.045));
    }
    for rung in ladder.with_y([low, high]).inset(0.002, 0.02, 0.045 - SINK).rows(4, 0.2) {
        builder.cuboid(step, Bay::around(rung.center(), rung.width(), 0.06, rung.depth()));
    }
}
