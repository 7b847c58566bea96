//! Kitchen units and counters.

use glam::DVec3;

use super::input::Draft;
use super::parts::{Fittings, REVEAL, slab_top, tap, turned_forward};
use crate::catalog::Side;
use crate::model::kit::{Bay, Builder, Outline, SINK, Slice, cylinder, loft, loft_ring};

/// Metres of a worktop.
const TOP: f64 = 0.04;
/// Metres of a toe kick's height and depth.
const TOE: [f64; 2] = [0.1, 0.05];
/// Metres of a working surface over the floor, where a box is higher for a tap's sake.
const WORKING_HEIGHT: f64 = 0.9;
/// Metres by which a hob or the rim of a basin stands over the top.
const ON_TOP: f64 = 0.004;
/// Boxes over this height, in metres, have their working surface below the top.
const HIGH_FROM: f64 = 1.0;

/// A base unit of a kitchen: carcass, toe kick, front and top; with a `sink`, a `hob`, an `oven` or `drawers`.
pub(super) fn worktop(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let work = if bay.height() > HIGH_FROM { WORKING_HEIGHT } else { bay.height() };
    // What lies on the top is part of the box.
    let work = if draft.is_set("hob") || draft.is_set("sink") { work - ON_TOP } else { work };
    let top = bay.with_y([work - TOP.min(work * 0.2), work]);
    let is_traditional = draft.is_traditional();
    let fittings = Fittings { front: "laminate", handle: "metal", reach: 0.022, is_traditional };
    if draft.is_set("sink") {
        sink(builder, top, bay);
    } else {
        slab_top(builder, "stone", top, is_traditional);
    }
    if draft.is_set("hob") {
        hob(builder, top);
    }
    let toe = TOE[0].min(work * 0.2);
    let body = bay.with_y([toe, top.low.y + SINK]).inset(0.001, 0.0, 0.001);
    let kick = body.with_y([0.0, toe + SINK]).without(Side::Front, TOE[1]).inset(0.002, 0.0, 0.002);
    builder.cuboid("plastic_dark", kick);
    // The basin hangs in the carcass, which is lower there.
    let carcass =
        if draft.is_set("sink") { body.without(Side::Above, 0.2_f64.min(work * 0.3)) } else { body };
    fittings.carcass(builder, "laminate", carcass);
    if draft.is_set("sink") {
        let apron = body
            .inset(0.0004, 0.0, 0.0)
            .without(Side::Back, 0.0004)
            .slab(Side::Above, 0.21_f64.min(work * 0.3))
            .without(Side::Front, fittings.depth() - SINK);
        builder.cuboid("laminate", apron.slab(Side::Front, 0.02).inset(SINK, 0.0, 0.0));
        for side in [Side::Left, Side::Right, Side::Back] {
            let inset = if side == Side::Back { 0.0155 } else { 0.0 };
            builder.cuboid(
                "laminate",
                apron
                    .without(Side::Front, 0.02 - SINK)
                    .slab(side, 0.016)
                    .without(Side::Back, if side == Side::Back { 0.0 } else { 0.0003 })
                    .inset(inset, SINK / 2.0, 0.0),
            );
        }
    }
    unit_fronts(draft, builder, &fittings, body);
}

fn unit_fronts(draft: &Draft, builder: &mut Builder, fittings: &Fittings, body: Bay) {
    let face = body.inset(REVEAL / 2.0, REVEAL / 2.0, 0.0).without(Side::Above, REVEAL);
    if draft.is_set("oven") {
        oven_front(builder, fittings, face);
        return;
    }
    if draft.is_set("drawers") {
        face.rows(draft.count("drawers", 3), REVEAL)
            .into_iter()
            .for_each(|row| fittings.drawer(builder, row));
        return;
    }
    let count = (body.width() / 0.55).round().clamp(1.0, 6.0) as u32;
    let has_drawer = !draft.is_set("sink") && draft.sampler().chance(0.6);
    let doors = if has_drawer { face.without(Side::Above, 0.15) } else { face };
    for (index, column) in doors.columns(count, REVEAL).into_iter().enumerate() {
        let hinge = if index % 2 == 0 { Side::Left } else { Side::Right };
        fittings.door(builder, column, hinge, 0.82);
        if has_drawer {
            let drawer = column.with_y([doors.high.y + REVEAL, face.high.y]);
            fittings.drawer(builder, drawer);
        }
    }
}

/// An oven door with a window, a long handle and a strip of knobs.
pub(super) fn oven_front(builder: &mut Builder, fittings: &Fittings, face: Bay) {
    let strip = face.slab(Side::Above, 0.11_f64.min(face.height() * 0.2));
    let door = face.without(Side::Above, strip.height() + REVEAL);
    let metal = Fittings { front: "appliance", handle: "metal", is_traditional: false, ..*fittings };
    metal.panel(builder, strip);
    metal.panel(builder, door);
    let surface = face.high.z - fittings.reach;
    let glass =
        door.inset(door.width() * 0.13, door.height() * 0.18, 0.0).with_z([surface - SINK, surface + 0.003]);
    builder.cuboid("screen", glass.moved(0.0, -door.height() * 0.04, 0.0));
    let bar = DVec3::new(0.0, door.high.y - 0.05_f64.min(door.height() * 0.1), surface);
    super::parts::handle(
        builder,
        "metal",
        (super::parts::HandleKind::Level, door.width() * 0.8),
        bar,
        fittings.reach,
    );
    let knob = turned_forward(cylinder(0.018, [-SINK, fittings.reach * 0.8], 8));
    for column in strip.inset(strip.width() * 0.08, 0.0, 0.0).columns(4, 0.02) {
        let middle = column.center();
        builder.add("metal_dark", knob.clone().moved(middle.x, middle.y, surface));
    }
}

/// A worktop with a basin let into it, and a tap where the box reaches over the top.
fn sink(builder: &mut Builder, top: Bay, bay: Bay) {
    let half = top.extent() / 2.0;
    let hole = [(half.x - 0.06).min(0.3).max(half.x * 0.4), (half.z - 0.09).max(half.z * 0.4)];
    let forward = 0.02;
    let inner = |y: f64| Slice::new(y, hole[0], hole[1]).at(0.0, forward);
    let outer = |y: f64| Slice::new(y, half.x, half.z);
    let slices = [outer(top.low.y), outer(top.high.y), inner(top.high.y), inner(top.low.y)];
    builder.add("stone", loft_ring(&Outline::Square, &slices));
    let depth = 0.16_f64.min(bay.height() * 0.18);
    let rim = |y: f64, x: f64| Slice::new(y, hole[0] + x, hole[1] + x).at(0.0, forward).softened(0.03);
    let high = top.high.y + ON_TOP;
    // Down the outside, over the rim onto the top, and down the inside.
    let basin = [
        rim(high - depth, -0.012),
        rim(top.high.y - 0.001, -0.001),
        rim(top.high.y - SINK, 0.012),
        rim(high, 0.012),
        rim(high, -0.004),
        rim(high - depth + 0.004, -0.02),
    ];
    builder.add("chrome", loft(&Outline::Soft(2), &basin));
    if bay.high.y - top.high.y > 0.08 {
        let foot = DVec3::new(0.0, top.high.y, forward - hole[1] - 0.035);
        tap(builder, foot, bay.high.y - top.high.y, bay.depth() * 0.2);
    }
}

/// Four cooking zones on black glass.
pub(super) fn hob(builder: &mut Builder, top: Bay) {
    let width = (top.width() - 0.06).min(0.58);
    let depth = (top.depth() - 0.08).min(0.51);
    let (surface, radius) = (top.high.y, width.min(depth) * 0.19);
    let glass =
        Bay::around(top.center(), width, 0.004, depth).with_y([surface - SINK, surface + ON_TOP * 0.8]);
    builder.cuboid("screen", glass);
    for x in [-1.0, 1.0] {
        for z in [-1.0, 1.0] {
            let size = if x * z > 0.0 { radius } else { radius * 0.8 };
            let zone = cylinder(size, [surface + ON_TOP * 0.6, surface + ON_TOP], 12);
            builder.add("metal_dark", zone.moved(x * width * 0.25, 0.0, z * depth * 0.25));
        }
    }
}

/// A solid counter for a reception, a bar or a shop: panelled front for guests at the back side, worktop inside.
pub(super) fn counter(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let is_traditional = draft.is_traditional();
    let top = TOP.min(bay.height() * 0.2);
    slab_top(
        builder,
        draft.sampler().pick(&["stone", "wood_dark"]),
        bay.slab(Side::Above, top),
        is_traditional,
    );
    let overhang = if is_traditional { 0.016 } else { 0.01 };
    let body = bay.without(Side::Above, top - SINK).inset(overhang, 0.0, overhang);
    let kick = 0.09_f64.min(bay.height() * 0.15);
    builder.cuboid("metal_dark", body.slab(Side::Below, kick + SINK).inset(0.03, 0.0, 0.03));
    let carcass = body.without(Side::Below, kick).inset(0.0, 0.0, 0.016);
    builder.cuboid("wood", carcass);
    let count = (bay.width() / 0.6).round().clamp(1.0, 12.0) as u32;
    for (side, slot) in [(Side::Front, "wood"), (Side::Back, "wood")] {
        let face = body.without(Side::Below, kick).slab(side, 0.016 + SINK).inset(0.004, 0.004, 0.0);
        for column in face.columns(count, 0.008) {
            builder.cuboid(slot, column);
        }
    }
}

/// A tall refrigerator with a freezer door below or above.
pub(super) fn fridge(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let fittings = Fittings { front: "appliance", handle: "metal", reach: 0.03, is_traditional: false };
    let foot = 0.04_f64.min(bay.height() * 0.1);
    builder.cuboid(
        "plastic_dark",
        bay.slab(Side::Below, foot + SINK).inset(0.01, 0.0, 0.01).without(Side::Front, 0.06),
    );
    let body = bay.without(Side::Below, foot);
    builder.block("appliance", body.without(Side::Front, fittings.depth() + 0.02 - SINK), 0.006);
    let share = sampler.between(0.3, 0.38);
    let freezer_low = sampler.chance(0.6);
    let cut = body.low.y + body.height() * if freezer_low { share } else { 1.0 - share };
    let doors = [body.with_y([body.low.y, cut - 0.003]), body.with_y([cut + 0.003, body.high.y])];
    for (index, door) in doors.into_iter().enumerate() {
        builder.block("appliance", door.without(Side::Front, fittings.reach).slab(Side::Front, 0.038), 0.008);
        if door.height() < 0.1 {
            continue;
        }
        let length = (door.height() * 0.4).min(0.45);
        let y = if index == 0 { door.high.y - length * 0.65 } else { door.low.y + length * 0.65 };
        let at = DVec3::new(door.low.x + 0.05, y, door.high.z - fittings.reach);
        super::parts::handle(
            builder,
            "metal",
            (super::parts::HandleKind::Upright, length),
            at,
            fittings.reach,
        );
    }
}
