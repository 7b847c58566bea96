//! Household and office machines.

use glam::DVec3;

use super::input::Draft;
use super::parts::{Fittings, HandleKind, LegKind, handle, legs_at_corners};
use crate::catalog::Side;
use crate::model::kit::{Bay, Builder, SINK};

/// Metres by which handles stand out.
const REACH: f64 = 0.025;

/// An office printer with a paper drawer and a sheet in its tray.
pub(super) fn printer(_draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let height = bay.height();
    let body = bay.without(Side::Front, 0.015);
    let drawer = body.slab(Side::Below, height * 0.28);
    builder.block("plastic", drawer, 0.004);
    let front = drawer.inset(0.012, height * 0.03, 0.0).with_z([drawer.high.z - SINK, drawer.high.z + 0.006]);
    builder.cuboid("plastic", front);
    let grip = DVec3::new(0.0, drawer.center().y, drawer.high.z + 0.006);
    handle(builder, "plastic_dark", (HandleKind::Level, bay.width() * 0.3), grip, 0.009);
    let engine = body.with_y([drawer.high.y - SINK, height * 0.62]).inset(0.004, 0.0, 0.004);
    builder.cuboid("plastic", engine.slab(Side::Back, engine.depth() * 0.55));
    builder.cuboid(
        "plastic",
        engine
            .without(Side::Back, engine.depth() * 0.55 - SINK)
            .slab(Side::Left, bay.width() * 0.2)
            .inset(0.0005, 0.0, 0.0),
    );
    let tray = engine
        .without(Side::Back, engine.depth() * 0.55 - SINK)
        .without(Side::Left, bay.width() * 0.2 - SINK);
    builder.cuboid("plastic_dark", tray.slab(Side::Below, height * 0.06).inset(0.001, 0.001, 0.001));
    let sheet = tray
        .inset(bay.width() * 0.08, 0.0, 0.02)
        .with_y([tray.low.y + height * 0.06, tray.low.y + height * 0.075]);
    builder.cuboid("paper", sheet.moved(0.0, -0.002, 0.0));
    let scanner = body.with_y([height * 0.62 - SINK, height * 0.92]);
    builder.block("plastic", scanner, 0.006);
    builder.block(
        "plastic_dark",
        scanner.inset(0.02, 0.0, 0.02).with_y([height * 0.92 - SINK, height]),
        0.006,
    );
    let panel = scanner.slab(Side::Right, bay.width() * 0.4).inset(0.03, height * 0.07, 0.0);
    builder.cuboid("screen", panel.with_z([scanner.high.z - SINK, scanner.high.z + 0.003]));
}

/// A machine that sells drinks and snacks behind glass.
pub(super) fn vending_machine(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let slot = sampler.pick(&["painted_accent", "metal_dark"]);
    let foot = 0.06;
    legs_at_corners(
        builder,
        "metal_dark",
        bay.with_y([0.0, foot + 3.0 * SINK]).inset(0.02, 0.0, 0.02),
        0.06,
        LegKind::Square,
    );
    let body = bay.without(Side::Below, foot);
    let window = body
        .slab(Side::Left, bay.width() * 0.68)
        .inset(bay.width() * 0.05, 0.0, 0.0)
        .without(Side::Above, bay.height() * 0.06)
        .without(Side::Below, bay.height() * 0.24);
    let depth = (bay.depth() * 0.3).min(0.25);
    builder.cuboid(slot, body.without(Side::Front, depth).inset(0.0005, 0.0005, 0.0));
    // The front is a frame around the window.
    let front = body.slab(Side::Front, depth + SINK);
    builder.cuboid(slot, front.with_x([body.low.x, window.low.x]));
    builder.cuboid(slot, front.with_x([window.high.x, body.high.x]));
    let between = front.with_x([window.low.x - SINK, window.high.x + SINK]).without(Side::Front, 0.002);
    builder.cuboid(slot, between.with_y([window.high.y, body.high.y - 0.0012]));
    builder.cuboid(slot, between.with_y([body.low.y + 0.0012, window.low.y]));
    let glass = window.slab(Side::Front, 0.012).without(Side::Front, 0.004).inset(-SINK, -SINK, 0.0);
    builder.cuboid("glass", glass);
    let niche = front.with_x(window.x()).with_y(window.y()).without(Side::Front, 0.05);
    for shelf in niche.rows(5, 0.0) {
        let board = shelf.slab(Side::Below, 0.015).inset(-SINK, 0.0, 0.002);
        builder.cuboid("metal", board.moved(0.0, SINK, 0.0));
        let goods = shelf.without(Side::Below, 0.015).inset(0.02, 0.0, 0.03);
        for column in goods.columns(5, goods.width() * 0.06) {
            let tall = goods.height() * sampler.between(0.5, 0.8);
            let slot = sampler.pick(&["book", "paper", "fabric_accent", "leaf"]);
            builder.cuboid(slot, column.slab(Side::Below, tall).moved(0.0, SINK * 0.5, 0.0));
        }
    }
    let surface = bay.high.z;
    let panel = front.with_x([window.high.x + 0.04, body.high.x - 0.04]);
    let keys = panel.with_y([bay.height() * 0.5, bay.height() * 0.68]);
    builder.cuboid("screen", keys.with_z([surface - 0.004, surface - 0.002]).inset(0.0, 0.0, -0.0025));
    let slit = panel.with_y([bay.height() * 0.4, bay.height() * 0.43]).inset(panel.width() * 0.2, 0.0, 0.0);
    builder.cuboid("metal", slit.with_z([surface - 0.005, surface + 0.0008]));
    let flap = between.with_y([body.low.y + 0.12, window.low.y - 0.1]).inset(0.06, 0.0, 0.0);
    builder.cuboid("plastic_dark", flap.with_z([between.high.z - 0.004, surface - 0.001]));
}

/// A small refrigerator of a hotel room.
pub(super) fn minibar(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let slot = draft.sampler().pick(&["plastic_dark", "wood_dark", "appliance"]);
    let fittings = Fittings { front: slot, handle: "metal", reach: REACH, is_traditional: false };
    let foot = bay.height() * 0.05;
    let feet = bay.with_y([0.0, foot + SINK]).inset(0.02, 0.0, 0.02).without(Side::Front, 0.05);
    legs_at_corners(builder, "rubber", feet, 0.04, LegKind::Square);
    let body = bay.without(Side::Below, foot);
    fittings.carcass(builder, slot, body);
    fittings.door(builder, body.inset(0.003, 0.003, 0.0), Side::Right, 0.78);
    let badge = DVec3::new(0.0, body.high.y - 0.06, bay.high.z - REACH);
    builder.cuboid("metal", Bay::around(badge, bay.width() * 0.2, 0.014, 0.003));
}
