//! Screens and what is plugged in beside them.

use glam::{DVec2, DVec3};

use super::input::Draft;
use super::parts::turned_forward;
use crate::catalog::Side;
use crate::model::kit::{Axis, Bay, Builder, SINK, cuboid, cylinder, extrude, lathe};

/// A keyboard with rows of keys, and a mouse where the box is wide.
pub(super) fn keyboard(_draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let has_mouse = bay.width() > bay.depth() * 3.4 || bay.width() > 0.52;
    let board = if has_mouse { bay.slab(Side::Left, bay.width() * 0.78) } else { bay };
    let base = bay.height() * 0.6;
    builder.block("plastic_dark", board.with_y([0.0, base]), base * 0.25);
    let keys = board.with_y([base - SINK, bay.high.y]).inset(board.width() * 0.02, 0.0, board.depth() * 0.06);
    let rows = super::seating::depth_slats(keys, 5, keys.depth() * 0.04);
    for (index, row) in rows.into_iter().enumerate() {
        let is_space_row = index == 4;
        if is_space_row {
            let [left, right] =
                [row.slab(Side::Left, row.width() * 0.25), row.slab(Side::Right, row.width() * 0.3)];
            let space = row.without(Side::Left, row.width() * 0.27).without(Side::Right, row.width() * 0.32);
            [left, space, right].into_iter().for_each(|key| builder.cuboid("plastic", key));
        } else {
            row.columns(3, row.width() * 0.02).into_iter().for_each(|key| builder.cuboid("plastic", key));
        }
    }
    if has_mouse {
        let pad = bay.slab(Side::Right, bay.width() * 0.16);
        let mouse = Bay::around(pad.center(), pad.width(), bay.height(), (bay.depth() * 0.8).min(0.11));
        builder.rounded("plastic_dark", mouse, mouse.extent() * DVec3::new(0.4, 0.45, 0.4), 1);
    }
}

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

/// A projector; its lens looks to the front.
pub(super) fn projector(_draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let body = bay.without(Side::Front, bay.depth() * 0.06).without(Side::Below, bay.height() * 0.06);
    builder.block("plastic", body, bay.height() * 0.1);
    let radius = bay.height() * 0.28;
    let x = bay.width() * 0.22;
    let rise = body.center().y;
    let ring = [(radius, 0.0), (radius, 0.09), (radius * 0.8, 0.09), (radius * 0.6, 0.05)];
    let profile: Vec<(f64, f64)> =
        ring.iter().map(|&(radius, share)| (radius, share * bay.depth())).collect();
    let front = bay.high.z - bay.depth() * 0.09;
    builder.add("plastic_dark", turned_forward(lathe(&profile, 12)).moved(x, rise, front));
    builder.add(
        "screen",
        turned_forward(cylinder(radius * 0.7, [0.001, bay.depth() * 0.06], 12)).moved(x, rise, front),
    );
    for strip in body
        .slab(Side::Left, bay.width() * 0.4)
        .inset(bay.width() * 0.05, bay.height() * 0.2, 0.0)
        .rows(4, bay.height() * 0.06)
    {
        builder.cuboid("plastic_dark", strip.with_z([body.high.z - 0.002, body.high.z + 0.001]));
    }
    super::parts::legs_at_corners(
        builder,
        "rubber",
        body.with_y([0.0, bay.height() * 0.06 + SINK]).inset(0.02, 0.0, 0.02),
        0.016,
        super::parts::LegKind::Square,
    );
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

/// A till: drawer, keys and a display for each side.
pub(super) fn cash_register(_draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let drawer = bay.height() * 0.28;
    builder.block("metal_dark", bay.slab(Side::Below, drawer).without(Side::Front, 0.012), 0.006);
    let front = bay.slab(Side::Below, drawer).slab(Side::Front, 0.012 + SINK).inset(
        bay.width() * 0.03,
        drawer * 0.15,
        0.0,
    );
    builder.cuboid("metal", front);
    let (low, high) = (bay.low.z + bay.depth() * 0.1, bay.high.z - bay.depth() * 0.12);
    let top = bay.height() * 0.62;
    let wedge =
        [(high, drawer - SINK), (high, drawer + 0.03), (low, top), (low, drawer - SINK)].map(DVec2::from);
    let x = bay.width() * 0.44;
    builder.add("plastic", extrude(&wedge, Axis::X, [-x, x]));
    let slope = libm::atan2(top - drawer - 0.03, high - low);
    let length = (high - low) / libm::cos(slope);
    for row in 0..4 {
        for column in 0..4 {
            let z = length * (0.3 + 0.16 * f64::from(row));
            let left = -x * 0.85 + x * 0.42 * f64::from(column);
            let key = cuboid(Bay::new([left, left + x * 0.34], [-SINK * 2.0, 0.006], [z, z + length * 0.12]));
            builder.add("plastic_dark", key.turned_x(slope).moved(0.0, top, low));
        }
    }
    builder.cuboid(
        "plastic_dark",
        Bay::new([-0.02, 0.02], [top - 0.06, bay.high.y - 0.03], [low + 0.01, low + 0.035]),
    );
    let panel = Bay::new([-x * 0.6, x * 0.6], [bay.height() * 0.74, bay.high.y], [low, low + 0.045]);
    super::screens::display(builder, panel, ("plastic_dark", 0.012));
}
