//! Small copiers on tables.

use super::{Slots, Stretch, keys, slope};
use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::furniture::parts::{LegKind, legs_at_corners};
use crate::recipes::kit::{Bay, Builder, SINK};

/// A small machine with a feeder on a table, on whose lower board packs of paper lie.
pub(super) fn desktop(builder: &mut Builder, (shell, dark): Slots) {
    let bay = builder.bay();
    let table = bay.height() * 0.52;
    let board = bay.with_y([table - 0.022, table]);
    builder.block(Slot::Laminate, board, 0.003);
    let frame = bay.with_y([0.0, table - 0.022 + SINK]).inset(0.02, 0.0, 0.02);
    legs_at_corners(builder, Slot::MetalDark, frame, 0.03, LegKind::Square);
    let lower = frame.inset(0.006, 0.0, 0.006).with_y([0.1, 0.118]);
    builder.cuboid(Slot::Laminate, lower);
    packs(builder, lower);
    let body = bay.with_y([table - SINK, bay.high.y]).inset(0.06, 0.0, 0.05);
    let height = body.height();
    let at = |share: f64| body.low.y + share * height;
    let cassette = body.with_y([at(0.03), at(0.26)]).without(Side::Front, 0.012);
    builder.cuboid(Slot::Rubber, body.with_y([at(0.0), at(0.04)]).inset(0.02, 0.0, 0.02));
    builder.block(shell, cassette, 0.008);
    let front = cassette.inset(0.02, 0.014, 0.0).with_z([cassette.high.z - SINK, cassette.high.z + 0.006]);
    builder.cuboid(dark, front);
    builder.cuboid(
        shell,
        front
            .inset(front.width() * 0.36, front.height() * 0.36, 0.0)
            .with_z([front.high.z - SINK, body.high.z]),
    );
    // The slot in which sheets come out lies between two cheeks.
    let neck =
        body.with_y([at(0.26) - SINK, at(0.5) + SINK]).without(Side::Front, 0.04).inset(0.004, 0.0, 0.004);
    builder.cuboid(shell, neck.slab(Side::Back, neck.depth() * 0.34));
    for side in [Side::Left, Side::Right] {
        builder.cuboid(
            shell,
            neck.slab(side, 0.05).without(Side::Back, neck.depth() * 0.34 - SINK).inset(0.001, 0.0, 0.0),
        );
    }
    let tray = neck.inset(0.055, 0.0, 0.0).without(Side::Back, neck.depth() * 0.3).slab(Side::Below, 0.02);
    builder.cuboid(dark, tray.moved(0.0, 0.002, 0.0));
    builder.cuboid(Slot::Paper, tray.inset(0.03, 0.0, 0.03).moved(0.0, 0.012, 0.0));
    let scanner = body.with_y([at(0.5), at(0.64)]).without(Side::Front, 0.03);
    builder.block(shell, scanner, 0.008);
    let panel = body.with_y([at(0.52), at(0.6)]).slab(Side::Front, 0.09).inset(0.02, 0.0, 0.0);
    keys(builder, (shell, dark), panel);
    let lid = scanner.inset(0.008, 0.0, 0.008).without(Side::Front, 0.06).with_y([at(0.64) - SINK, at(0.76)]);
    builder.block(shell, lid, 0.01);
    let feeder = lid.slab(Side::Left, lid.width() * 0.42).with_y([at(0.76) - SINK, at(0.94)]);
    builder.block(dark, feeder, 0.012);
    let ends = [(feeder.high.x - 0.02, at(0.82)), (lid.high.x, at(0.985) - 0.008)];
    slope(builder, dark, ends, Stretch { thickness: 0.008, z: [lid.low.z + 0.05, lid.high.z - 0.05] });
    let sheet = ends.map(|(x, y)| (x - 0.01, y + 0.005));
    slope(
        builder,
        Slot::Paper,
        sheet,
        Stretch { thickness: 0.008, z: [lid.low.z + 0.08, lid.high.z - 0.08] },
    );
}

/// Packs of paper side by side on a board, two high at the left.
fn packs(builder: &mut Builder, board: Bay) {
    for (index, place) in board.inset(0.06, 0.0, 0.12).columns(2, 0.05).into_iter().enumerate() {
        for level in 0..3 - index {
            let low = board.high.y + 0.055 * level as f64;
            let pack = place.with_y([low - SINK, low + 0.052]).inset(
                0.004 * level as f64,
                0.0,
                0.006 * level as f64,
            );
            builder.cuboid(Slot::Paper, pack);
            let band = pack.slab(Side::Left, pack.width() * 0.3).inset(-0.001, 0.006, -0.001).moved(
                pack.width() * 0.3,
                0.0,
                0.0,
            );
            builder.cuboid(Slot::PaintedAccent, band);
        }
    }
}
