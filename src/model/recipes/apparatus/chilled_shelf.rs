//! Open refrigerators of shops: 1.25, 1.87 or 2.5 m wide, 0.8 to 0.9 deep, 2.0 high, four or five shelves.

use glam::DVec2;

use crate::catalog::Side;
use crate::model::kit::{Axis, Bay, Builder, SINK, Sampler, extrude, lathe};
use crate::model::recipes::input::Draft;

/// Metres of the ends.
const END: f64 = 0.03;
/// Shelves over the foot.
const SHELVES: u32 = 4;
/// Metres of a shelf.
const BOARD: f64 = 0.014;
/// Metres that one row of goods takes.
const GOODS: f64 = 0.13;

/// An open refrigerator of a shop: shelves of goods under a lit canopy, between glass ends.
pub(in super::super) fn chilled_shelf(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let look = draft.input.look as usize % 4;
    let slot = ["plastic_dark", "painted", "metal", "painted_accent"][look];
    let (foot, head) = (bay.height() * 0.24, bay.height() * 0.9);
    let body = bay.inset(END, 0.0, 0.0);
    builder.add(slot, extrude(&side_view(bay, foot, head), Axis::X, body.x()));
    ends(builder, if look.is_multiple_of(2) { "glass" } else { slot }, foot);
    let front = bay.high.z;
    builder.cuboid(
        "lamp",
        body.inset(0.04, 0.0, 0.0)
            .with_y([head - 0.012, head + SINK])
            .with_z([front - bay.depth() * 0.4, front - bay.depth() * 0.34]),
    );
    builder.cuboid(
        "screen",
        body.inset(body.width() * 0.3, 0.0, 0.0)
            .with_y([foot * 0.3, foot * 0.5])
            .with_z([front - 0.0005, front + 0.0008]),
    );
    for shelf in 0..=SHELVES {
        let step = (head - foot) / f64::from(SHELVES + 1);
        let low = foot * 0.95 + (head - foot) * f64::from(shelf) / f64::from(SHELVES + 1);
        let deep = bay.depth() * (0.66 - 0.05 * f64::from(shelf));
        let back = bay.low.z + 0.085;
        let board = body.inset(0.012, 0.0, 0.0).with_y([low, low + BOARD]).with_z([back, back + deep]);
        if shelf > 0 {
            board_with_prices(builder, board);
        }
        let goods = board.with_y([low + BOARD - SINK, low + step - 0.03]).inset(0.02, 0.0, 0.02);
        row_of_goods(builder, &mut sampler, goods);
    }
}

/// Seen from the right: a deep foot, a thin back, a canopy.
fn side_view(bay: Bay, foot: f64, head: f64) -> [DVec2; 10] {
    let (back, front) = (bay.low.z, bay.high.z);
    [
        (front, 0.0),
        (front, foot * 0.86),
        (front - 0.05, foot),
        (back + 0.1, foot * 0.92),
        (back + 0.08, head),
        (front - bay.depth() * 0.3, head),
        (front - bay.depth() * 0.26, head + 0.05),
        (front - bay.depth() * 0.3, bay.high.y),
        (back, bay.high.y),
        (back, 0.0),
    ]
    .map(DVec2::from)
}

/// A pane or a board at both ends, with a bumper of metal at its foot.
fn ends(builder: &mut Builder, slot: &'static str, foot: f64) {
    let bay = builder.bay();
    for side in [Side::Left, Side::Right] {
        builder.cuboid(
            slot,
            bay.slab(side, END + SINK)
                .inset(0.0, 0.002, 0.002)
                .with_z([bay.low.z + 0.002, bay.high.z - bay.depth() * 0.12]),
        );
        builder.cuboid(
            "metal",
            bay.slab(side, END + SINK * 4.0).with_y([0.0005, foot * 0.6]).inset(0.0006, 0.0, 0.001),
        );
    }
}

/// A shelf with a strip for prices along its front.
fn board_with_prices(builder: &mut Builder, board: Bay) {
    builder.cuboid("metal", board);
    let strip = board.slab(Side::Front, 0.004).inset(0.001, 0.0, 0.0).moved(0.0, 0.003, 0.0035);
    builder.cuboid("paper", strip.with_y([board.low.y - 0.012, board.low.y + 0.026]));
}

/// Cartons and pairs of bottles side by side.
fn row_of_goods(builder: &mut Builder, sampler: &mut Sampler, goods: Bay) {
    let columns = (goods.width() / GOODS).round().clamp(2.0, 9.0) as u32;
    for column in goods.columns(columns, 0.012) {
        let tall = goods.height() * sampler.between(0.5, 0.85);
        let slot = sampler.pick(&["book", "paper", "fabric_accent", "leaf", "linen", "painted_accent"]);
        if !sampler.chance(0.35) {
            builder.cuboid(slot, column.slab(Side::Below, tall));
            continue;
        }
        let (radius, y, middle) = (column.width() * 0.42, column.low.y, column.center());
        let bottle =
            [(radius, y), (radius, y + tall * 0.6), (radius * 0.4, y + tall * 0.8), (radius * 0.4, y + tall)];
        for z in [0.24, -0.2] {
            builder.add(slot, lathe(&bottle, 6).moved(middle.x, 0.0, middle.z + z * column.depth()));
        }
    }
}
