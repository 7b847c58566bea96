//! Copiers on drawers of paper.

use glam::DVec2;

use super::Slots;
use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::furniture::parts::{LegKind, legs_at_corners};
use crate::recipes::kit::{Axis, Bay, Builder, SINK, extrude};

/// A copier on castors: paper drawers, a slot with sheets, a tilted panel, a feeder on top, a tray at its side.
pub(super) fn cassette_copier(builder: &mut Builder, (shell, dark): Slots, look: u32) {
    let bay = builder.bay();
    let height = bay.height();
    let tray = bay.width() * 0.2;
    let body = bay.without(Side::Right, tray);
    let foot = height * 0.05;
    legs_at_corners(
        builder,
        Slot::Rubber,
        body.with_y([0.0, foot + SINK]).inset(0.03, 0.0, 0.05),
        0.05,
        LegKind::Square,
    );
    cassettes(builder, (shell, dark), body.with_y([foot, height * 0.5]), 3 + look % 2);
    engine(builder, (shell, dark), body);
    scanner(builder, (shell, dark), body);
    feeder(builder, (shell, dark), body);
    // The tray for finished sheets rises outwards.
    let out = [
        (body.high.x - 0.005, height * 0.56),
        (bay.high.x, height * 0.64),
        (bay.high.x, height * 0.65),
        (body.high.x - 0.005, height * 0.575),
    ]
    .map(DVec2::from);
    builder.add(dark, extrude(&out, Axis::Z, [body.low.z + 0.08, body.high.z - 0.14]));
    builder.cuboid(
        shell,
        body.slab(Side::Right, 0.02)
            .inset(0.0, 0.0, 0.106)
            .moved(0.006, 0.0, -0.02)
            .with_y([height * 0.497, height * 0.7]),
    );
}

/// Drawers for paper, each with a grip and a label.
fn cassettes(builder: &mut Builder, (shell, dark): Slots, bay: Bay, count: u32) {
    let drawers = bay.without(Side::Front, 0.012);
    builder.block(shell, drawers, 0.006);
    for row in drawers.inset(0.012, 0.012, 0.0).rows(count, 0.01) {
        let front = row.with_z([drawers.high.z - SINK, drawers.high.z + 0.008]);
        builder.block(shell, front, 0.003);
        let grip = front.slab(Side::Above, row.height() * 0.3).inset(row.width() * 0.34, 0.004, 0.0);
        builder.cuboid(dark, grip.with_z([front.high.z - SINK, bay.high.z]));
        builder.cuboid(
            Slot::Paper,
            front
                .slab(Side::Left, 0.05)
                .inset(0.012, row.height() * 0.3, 0.0)
                .with_z([front.high.z - SINK, front.high.z + 0.001]),
        );
    }
}

/// The engine, with the slot in which sheets come out.
fn engine(builder: &mut Builder, (shell, dark): Slots, body: Bay) {
    let height = body.height();
    let neck =
        body.with_y([height * 0.5 - SINK, height * 0.72]).without(Side::Front, 0.03).inset(0.004, 0.0, 0.004);
    builder.cuboid(shell, neck.slab(Side::Back, neck.depth() * 0.4));
    builder.cuboid(
        shell,
        neck.without(Side::Back, neck.depth() * 0.4 - SINK)
            .slab(Side::Left, body.width() * 0.22)
            .inset(0.0005, 0.001, 0.0),
    );
    let hollow = neck
        .without(Side::Back, neck.depth() * 0.4 - SINK)
        .without(Side::Left, body.width() * 0.22 - SINK * 3.0);
    builder.cuboid(dark, hollow.with_y([neck.low.y + 0.0024, neck.low.y + 0.03]).inset(0.0, 0.0, 0.001));
    builder
        .cuboid(Slot::Paper, hollow.with_y([neck.low.y + 0.029, neck.low.y + 0.042]).inset(0.05, 0.0, 0.04));
}

/// The scanner, and the tilted panel before it.
fn scanner(builder: &mut Builder, (shell, dark): Slots, body: Bay) {
    let (bay, height) = (builder.bay(), body.height());
    let scanner = body.with_y([height * 0.72 - SINK, height * 0.82]);
    builder.block(shell, scanner.without(Side::Front, 0.02), 0.008);
    let panel = [
        (bay.high.z - 0.06, height * 0.76),
        (bay.high.z, height * 0.77),
        (bay.high.z - 0.03, height * 0.84),
        (bay.high.z - 0.09, height * 0.83),
    ]
    .map(DVec2::from);
    let width = body.width() * 0.42;
    let right = body.high.x - 0.02;
    builder.add(dark, extrude(&panel, Axis::X, [right - width, right]));
    let glow = [
        (bay.high.z - 0.0005, height * 0.775),
        (bay.high.z + 0.0008, height * 0.7755),
        (bay.high.z - 0.0262, height * 0.836),
        (bay.high.z - 0.028, height * 0.835),
    ]
    .map(DVec2::from);
    builder.add(Slot::Screen, extrude(&glow, Axis::X, [right - width * 0.9, right - width * 0.3]));
}

/// The feeder: a low box with a slope for originals.
fn feeder(builder: &mut Builder, (shell, dark): Slots, body: Bay) {
    let height = body.height();
    let lid =
        body.inset(0.01, 0.0, 0.02).with_y([height * 0.82 - SINK, height * 0.88]).without(Side::Front, 0.08);
    builder.block(shell, lid, 0.01);
    let feeder = lid.slab(Side::Left, lid.width() * 0.4).with_y([height * 0.88 - SINK, height]);
    builder.block(shell, feeder, 0.012);
    let slope = [
        (feeder.high.x - 0.01, height * 0.9),
        (lid.high.x - 0.02, height * 0.95),
        (lid.high.x - 0.02, height * 0.96),
        (feeder.high.x - 0.01, height * 0.915),
    ]
    .map(DVec2::from);
    builder.add(dark, extrude(&slope, Axis::Z, [lid.low.z + 0.06, lid.high.z - 0.06]));
    let sheet = slope.map(|point| point + DVec2::new(0.004, 0.008));
    builder.add(Slot::Paper, extrude(&sheet, Axis::Z, [lid.low.z + 0.1, lid.high.z - 0.1]));
}
