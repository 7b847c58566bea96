//! Household and office machines.

use glam::DVec3;

use super::input::Draft;
use super::kitchen::{hob, oven_front};
use super::parts::{Fittings, HandleKind, LegKind, handle, legs_at_corners, turned_forward};
use crate::catalog::Side;
use crate::model::kit::{Bay, Builder, Outline, SINK, Slice, cylinder, lathe, loft, loft_ring, sweep};

/// Metres by which handles stand out.
const REACH: f64 = 0.025;
/// Metres by which a hob stands over the top of a cooker.
const HOB: f64 = 0.004;

fn steel(front: &'static str) -> Fittings {
    Fittings { front, handle: "metal", reach: REACH, is_traditional: false }
}

/// The body of a machine on a dark foot; gives the bay of its fronts.
fn machine(builder: &mut Builder, fittings: &Fittings, bay: Bay, slot: &'static str) -> Bay {
    let foot = (bay.height() * 0.1).min(0.07);
    let kick = bay.slab(Side::Below, foot + SINK).inset(0.008, 0.0, 0.008).without(Side::Front, 0.05);
    builder.cuboid("plastic_dark", kick);
    let body = bay.without(Side::Below, foot);
    fittings.carcass(builder, slot, body);
    body.inset(0.003, 0.003, 0.0)
}

/// A machine under its own top; gives its fittings and the bay of its fronts.
fn machine_under_top(builder: &mut Builder) -> (Fittings, Bay) {
    let bay = builder.bay();
    builder.block("appliance", bay.slab(Side::Above, 0.025), 0.004);
    let fittings = steel("appliance");
    let body = bay.without(Side::Above, 0.025 - SINK).inset(0.002, 0.0, 0.002);
    let face = machine(builder, &fittings, body, "appliance");
    (fittings, face)
}

/// A free-standing cooker: four zones over an oven.
pub(super) fn cooker(_draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let top = bay.slab(Side::Above, 0.03).without(Side::Above, HOB);
    builder.block("metal", top, 0.004);
    hob(builder, top);
    let fittings = steel("appliance");
    let body = bay.with_y([0.0, top.low.y + SINK]).inset(0.002, 0.0, 0.002);
    let face = machine(builder, &fittings, body, "appliance");
    oven_front(builder, &fittings, face.without(Side::Below, face.height() * 0.22));
    fittings.drawer(builder, face.slab(Side::Below, face.height() * 0.22 - 0.004));
}

/// A dishwasher under its own top.
pub(super) fn dishwasher(_draft: &Draft, builder: &mut Builder) {
    let (fittings, face) = machine_under_top(builder);
    let strip = face.slab(Side::Above, face.height() * 0.14);
    fittings.panel(builder, strip);
    let door = face.without(Side::Above, face.height() * 0.14 + 0.004);
    fittings.panel(builder, door);
    let surface = face.high.z - REACH;
    let grip = DVec3::new(0.0, door.high.y - 0.04, surface);
    handle(builder, "metal", (HandleKind::Level, door.width() * 0.7), grip, REACH);
    let display = strip.inset(strip.width() * 0.32, strip.height() * 0.3, 0.0);
    builder.cuboid("screen", display.with_z([surface - SINK, surface + 0.002]));
}

/// A washing machine with a porthole and a drawer for powder.
pub(super) fn washing_machine(draft: &Draft, builder: &mut Builder) {
    let (fittings, face) = machine_under_top(builder);
    let strip = face.slab(Side::Above, face.height() * 0.16);
    let surface = face.high.z - REACH;
    fittings.panel(builder, face.without(Side::Above, face.height() * 0.16 + 0.003));
    fittings.panel(builder, strip);
    let powder = strip.slab(Side::Left, strip.width() * 0.3).inset(0.015, 0.015, 0.0);
    builder.cuboid("plastic", powder.with_z([surface - SINK, surface + 0.004]));
    let knob = turned_forward(cylinder(strip.height() * 0.28, [-SINK, REACH * 0.8], 12));
    builder.add("plastic_dark", knob.moved(strip.width() * 0.05, strip.center().y, surface));
    let display = strip.slab(Side::Right, strip.width() * 0.32).inset(0.02, 0.02, 0.0);
    builder.cuboid("screen", display.with_z([surface - SINK, surface + 0.002]));
    let radius = (face.width() * 0.34).min(face.height() * 0.34);
    let y = face.low.y + (face.height() * 0.84) * 0.52;
    let ring = [
        Slice::round(-SINK, radius),
        Slice::round(REACH * 0.6, radius * 0.97),
        Slice::round(REACH, radius * 0.85),
        Slice::round(REACH * 0.8, radius * 0.68),
        Slice::round(-SINK, radius * 0.66),
    ];
    let slot = draft.sampler().pick(&["metal", "plastic_dark"]);
    builder.add(slot, turned_forward(loft_ring(&Outline::Round(20), &ring)).moved(0.0, y, surface));
    let glass =
        lathe(&[(radius * 0.67, 0.002), (radius * 0.67, REACH * 0.5), (radius * 0.3, REACH * 0.8)], 20);
    builder.add("screen", turned_forward(glass).moved(0.0, y, surface));
}

/// A cooker hood: a skirt under a chimney.
pub(super) fn hood(_draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let (half, middle) = (bay.extent() / 2.0, bay.height() * 0.4);
    let (lip, chimney) = (bay.height() * 0.08, [half.x * 0.4, half.z * 0.5]);
    let back = -half.z + chimney[1];
    let skirt = [
        Slice::new(0.0, half.x, half.z),
        Slice::new(lip, half.x, half.z),
        Slice::new(middle, chimney[0], chimney[1]).at(0.0, back),
    ];
    builder.add("metal", loft(&Outline::Square, &skirt));
    let pipe = Bay::new(
        [-chimney[0], chimney[0]],
        [middle - SINK, bay.high.y],
        [-half.z, -half.z + chimney[1] * 2.0],
    );
    builder.cuboid("metal", pipe.inset(0.004, 0.0, 0.004));
    let strip =
        Bay::new([-half.x * 0.25, half.x * 0.25], [lip * 0.25, lip * 0.75], [half.z - 0.001, half.z + 0.001]);
    builder.cuboid("screen", strip);
}

/// A microwave oven.
pub(super) fn microwave(_draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let reach = 0.018;
    let foot = bay.height() * 0.04;
    builder.block("appliance", bay.without(Side::Front, reach).without(Side::Below, foot), 0.006);
    let feet = bay.slab(Side::Below, foot + SINK * 2.0).inset(0.03, 0.0, 0.03).without(Side::Front, reach);
    legs_at_corners(builder, "rubber", feet, 0.025, LegKind::Square);
    let surface = bay.high.z - reach;
    let face = bay.without(Side::Below, foot).inset(0.012, 0.014, 0.0);
    let door = face.slab(Side::Left, face.width() * 0.74);
    builder.cuboid("screen", door.with_z([surface - SINK, surface + 0.004]));
    let grip = DVec3::new(door.high.x - 0.02, door.center().y, surface + 0.004);
    handle(builder, "metal", (HandleKind::Upright, door.height() * 0.8), grip, reach - 0.004);
    let keys = face.slab(Side::Right, face.width() * 0.22);
    builder.cuboid(
        "screen",
        keys.slab(Side::Above, keys.height() * 0.2).with_z([surface - SINK, surface + 0.002]),
    );
    for row in keys.without(Side::Above, keys.height() * 0.28).rows(3, keys.height() * 0.06) {
        row.columns(2, 0.008).into_iter().for_each(|key| {
            builder.cuboid("plastic_dark", key.with_z([surface - SINK, surface + 0.003]));
        });
    }
}

/// A coffee machine: water tank behind, spout over a drip tray.
pub(super) fn coffee_machine(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let slot = draft.sampler().pick(&["metal", "plastic_dark"]);
    let height = bay.height();
    let base = bay.slab(Side::Below, height * 0.13);
    builder.block(slot, base, 0.006);
    let grid = base.slab(Side::Front, bay.depth() * 0.42).inset(bay.width() * 0.12, 0.0, bay.depth() * 0.03);
    builder.cuboid("metal_dark", grid.with_y([base.high.y - SINK, base.high.y + 0.004]));
    let column = bay.without(Side::Front, bay.depth() * 0.48).with_y([base.high.y - SINK, height * 0.7]);
    builder.cuboid(slot, column.inset(0.006, 0.0, 0.006));
    let head = bay.with_y([height * 0.68, height * 0.97]).without(Side::Front, bay.depth() * 0.06);
    builder.block(slot, head, 0.01);
    builder
        .cuboid("metal_dark", head.slab(Side::Above, 0.004).moved(0.0, 0.0035, 0.0).inset(0.02, 0.0, 0.02));
    let spout = [
        DVec3::new(0.0, height * 0.69, bay.high.z - bay.depth() * 0.26),
        DVec3::new(0.0, height * 0.56, bay.high.z - bay.depth() * 0.26),
    ];
    builder.add("chrome", sweep(&spout, bay.width() * 0.07, 8));
    let panel = head.inset(bay.width() * 0.2, head.height() * 0.25, 0.0);
    builder.cuboid("screen", panel.with_z([head.high.z - SINK, head.high.z + 0.002]));
    let front = bay.high.z;
    let lever = [
        DVec3::new(bay.width() * 0.38, height * 0.8, head.high.z - 0.004),
        DVec3::new(bay.width() * 0.38, height * 0.8, front - 0.007),
        DVec3::new(bay.width() * 0.38, height * 0.6, front - 0.007),
    ];
    builder.add("chrome", sweep(&lever, 0.007, 6));
    let cups = [
        DVec3::new(-bay.width() * 0.2, 0.0, -bay.depth() * 0.2),
        DVec3::new(bay.width() * 0.15, 0.0, -bay.depth() * 0.2),
    ];
    for at in cups {
        let cup =
            lathe(&[(0.025, height * 0.97), (0.034, height), (0.03, height), (0.022, height * 0.975)], 10);
        builder.add("ceramic", cup.moved(at.x, 0.0, at.z));
    }
}

/// An electric kettle with a spout to the right and a handle to the left.
pub(super) fn kettle(_draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let height = bay.height();
    let radius = bay.depth() / 2.0;
    let x = bay.width() * 0.04;
    let base =
        lathe(&[(radius * 0.94, 0.0), (radius * 0.94, height * 0.07), (radius * 0.8, height * 0.1)], 12);
    builder.add("plastic_dark", base.moved(x, 0.0, 0.0));
    let body = [
        (radius * 0.9, height * 0.095),
        (radius, height * 0.3),
        (radius * 0.82, height * 0.75),
        (radius * 0.66, height * 0.9),
        (radius * 0.2, height * 0.95),
    ];
    builder.add("metal", lathe(&body, 12).moved(x, 0.0, 0.0));
    builder.add("plastic_dark", lathe(&[(0.008, height * 0.94), (0.014, height)], 8).moved(x, 0.0, 0.0));
    let at = |share: f64, y: f64| DVec3::new(x + share, height * y, 0.0);
    let spout = [at(radius * 0.6, 0.62), at(bay.high.x - x - 0.01, 0.82)];
    builder.add("metal", sweep(&spout, radius * 0.15, 6));
    let left = bay.low.x - x + 0.009;
    let grip = [at(-radius * 0.55, 0.86), at(left, 0.84), at(left, 0.3), at(-radius * 0.9, 0.22)];
    builder.add("plastic_dark", sweep(&grip, 0.009, 6));
}

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
