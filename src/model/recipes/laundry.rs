//! Machines that wash and dry.

use glam::DVec3;

use super::input::{Draft, GeometrySet};
use super::parts::{Fittings, HandleKind, handle, turned_forward};
use crate::catalog::Side;
use crate::model::kit::{Bay, Builder, Outline, SINK, Slice, cylinder, lathe, loft_ring};

/// Metres by which handles, knobs and doors stand out.
const REACH: f64 = 0.025;

/// What a machine of a set is made of: its body, its front and its handles.
fn slots(draft: &Draft) -> [&'static str; 3] {
    let look = draft.input.look as usize % 4;
    let choices = match draft.set() {
        GeometrySet::Plain => [
            ["appliance", "appliance", "metal"],
            ["metal", "metal", "metal_dark"],
            ["appliance", "appliance", "metal_dark"],
            ["metal_dark", "metal_dark", "chrome"],
        ],
        GeometrySet::Traditional => [
            ["appliance", "painted", "brass"],
            ["painted_accent", "painted_accent", "chrome"],
            ["appliance", "appliance", "chrome"],
            ["painted", "painted", "brass"],
        ],
        GeometrySet::Industrial => [
            ["metal", "metal", "metal_dark"],
            ["metal_dark", "metal", "metal"],
            ["metal", "metal", "plastic_dark"],
            ["metal", "painted_accent", "metal"],
        ],
        GeometrySet::Budget => [
            ["appliance", "appliance", "plastic"],
            ["appliance", "plastic", "plastic_dark"],
            ["plastic", "appliance", "plastic"],
            ["appliance", "appliance", "plastic_dark"],
        ],
    };
    choices[look]
}

/// Top, foot and carcass of a machine; gives the bay of its fronts and what they are made of.
fn case(draft: &Draft, builder: &mut Builder) -> (Fittings, Bay) {
    let bay = builder.bay();
    let [body, front, metal] = slots(draft);
    builder.block(body, bay.slab(Side::Above, 0.025).without(Side::Front, REACH * 0.6), 0.004);
    let fittings = Fittings { front, handle: metal, reach: REACH, is_traditional: false };
    let room = bay.without(Side::Above, 0.025 - SINK).inset(0.002, 0.0, 0.002).without(Side::Front, -0.002);
    let foot = (bay.height() * 0.1).min(0.05);
    let kick = room.slab(Side::Below, foot + SINK).inset(0.008, 0.0, 0.008).without(Side::Front, 0.05);
    builder.cuboid("plastic_dark", kick);
    let room = room.without(Side::Below, foot);
    fittings.carcass(builder, body, room);
    // The sides of the box.
    let band =
        room.without(Side::Front, fittings.depth() + 0.01).with_y([room.low.y + 0.02, room.low.y + 0.03]);
    builder.cuboid(body, band.inset(-0.002, 0.0, 0.01));
    (fittings, room.inset(0.003, 0.003, 0.0))
}

/// A washing machine with a porthole and a drawer for powder; with `dryer`, a door without glass, a filter and slits.
pub(super) fn washing_machine(draft: &Draft, builder: &mut Builder) {
    let (fittings, face) = case(draft, builder);
    let is_dryer = draft.is_set("dryer");
    let strip = face.slab(Side::Above, face.height() * 0.16);
    let surface = face.high.z - REACH;
    let front = face.without(Side::Above, face.height() * 0.16 + 0.003);
    fittings.panel(builder, front);
    fittings.panel(builder, strip);
    controls(draft, builder, strip, surface);
    porthole(draft, builder, face, surface, is_dryer);
    let flap = front.slab(Side::Below, 0.09).inset(0.02, 0.015, 0.0);
    if is_dryer {
        for slit in flap.inset(front.width() * 0.1, 0.0, 0.0).rows(4, 0.008) {
            builder.cuboid("plastic_dark", slit.with_z([surface - SINK, surface + 0.0015]));
        }
    } else {
        let hatch = flap.slab(
            if draft.input.look.is_multiple_of(2) { Side::Left } else { Side::Right },
            front.width() * 0.22,
        );
        builder.cuboid("plastic", hatch.with_z([surface - SINK, surface + 0.003]));
    }
}

/// Drawer, knob, display and keys.
fn controls(draft: &Draft, builder: &mut Builder, strip: Bay, surface: f64) {
    let metal = slots(draft)[2];
    let out = |lift: f64| [surface - SINK, surface + lift];
    let drawer = strip.slab(Side::Left, strip.width() * 0.28).inset(0.015, 0.015, 0.0);
    builder.block("plastic", drawer.with_z(out(0.006)), 0.002);
    builder.cuboid("plastic_dark", drawer.slab(Side::Below, 0.02).inset(0.03, 0.004, 0.0).with_z(out(0.008)));
    let radius = strip.height() * 0.3;
    let knob = [
        (radius * 1.15, -SINK),
        (radius * 1.1, REACH * 0.2),
        (radius * 0.85, REACH * 0.25),
        (radius * 0.75, REACH * 0.95),
    ];
    let knob = turned_forward(lathe(&knob, 14));
    builder.add(metal, knob.moved(0.0, strip.center().y, surface));
    let right = strip.slab(Side::Right, strip.width() * 0.36).inset(0.02, strip.height() * 0.22, 0.0);
    if draft.set() == GeometrySet::Traditional
        || draft.set() == GeometrySet::Budget && draft.input.look.is_multiple_of(2)
    {
        for column in right.columns(3, 0.012) {
            let key = column.inset(column.width() * 0.2, column.height() * 0.2, 0.0);
            builder.block("plastic", key.with_z(out(0.008)), 0.002);
        }
    } else {
        builder.cuboid("screen", right.slab(Side::Left, right.width() * 0.6).with_z(out(0.002)));
        for key in right.slab(Side::Right, right.width() * 0.32).rows(3, 0.008) {
            builder.cuboid("plastic_dark", key.with_z(out(0.003)));
        }
    }
}

fn porthole(draft: &Draft, builder: &mut Builder, face: Bay, surface: f64, is_dryer: bool) {
    let size = [0.36, 0.33, 0.35, 0.31][draft.input.look as usize % 4];
    let radius = (face.width() * size).min(face.height() * size);
    let y = face.low.y + face.height() * 0.45;
    let ring = [
        Slice::round(-SINK, radius),
        Slice::round(REACH * 0.6, radius * 0.97),
        Slice::round(REACH, radius * 0.87),
        Slice::round(REACH * 0.8, radius * 0.7),
        Slice::round(-SINK, radius * 0.68),
    ];
    let rim = match (draft.set(), draft.input.look % 2) {
        (GeometrySet::Plain, 0) | (GeometrySet::Traditional, _) => "chrome",
        (GeometrySet::Industrial, _) => "metal",
        (GeometrySet::Budget, 0) => "plastic",
        _ => "plastic_dark",
    };
    let place = |solid: crate::model::kit::Solid| turned_forward(solid).moved(0.0, y, surface);
    builder.add(rim, place(loft_ring(&Outline::Round(24), &ring)));
    let bulge = [(radius * 0.69, 0.002), (radius * 0.69, REACH * 0.5), (radius * 0.3, REACH * 0.8)];
    builder.add(if is_dryer { slots(draft)[1] } else { "screen" }, place(lathe(&bulge, 24)));
    let x = if is_dryer { -1.0 } else { 1.0 };
    let grip = Bay::around(
        DVec3::new(x * radius * 0.86, y, surface + REACH * 0.85),
        radius * 0.12,
        radius * 0.36,
        REACH * 0.3,
    );
    builder.block("plastic_dark", grip.with_z([surface + REACH * 0.5, surface + REACH]), 0.003);
    if is_dryer {
        for line in 0..5 {
            let across = radius * (0.5 - 0.06 * f64::from(line % 3));
            let bar = Bay::around(
                DVec3::new(0.0, y + radius * 0.1 * (f64::from(line) - 2.0), surface),
                across,
                0.006,
                0.0,
            );
            builder.cuboid("plastic_dark", bar.with_z([surface + REACH * 0.4, surface + REACH * 0.83]));
        }
    }
}

/// A dishwasher under its own top: a full front with a groove, or a panel of keys over a door with a bar.
pub(super) fn dishwasher(draft: &Draft, builder: &mut Builder) {
    let (fittings, face) = case(draft, builder);
    let surface = face.high.z - REACH;
    let metal = slots(draft)[2];
    let out = |lift: f64| [surface - SINK, surface + lift];
    let share = if draft.set() == GeometrySet::Plain { 0.09 } else { 0.15 };
    let strip = face.slab(Side::Above, face.height() * share);
    let door = face.without(Side::Above, face.height() * share + 0.004);
    fittings.panel(builder, strip);
    fittings.panel(builder, door);
    let bar = DVec3::new(0.0, door.high.y - 0.04, surface);
    match draft.set() {
        GeometrySet::Budget => builder.block(
            "plastic_dark",
            strip
                .slab(Side::Below, strip.height() * 0.4)
                .inset(strip.width() * 0.3, 0.004, 0.0)
                .with_z(out(REACH)),
            0.004,
        ),
        _ => handle(
            builder,
            metal,
            (
                HandleKind::Level,
                door.width() * if draft.set() == GeometrySet::Industrial { 0.9 } else { 0.7 },
            ),
            bar,
            REACH,
        ),
    }
    let display =
        strip.inset(strip.width() * 0.38, strip.height() * 0.3, 0.0).moved(0.0, strip.height() * 0.1, 0.0);
    builder.cuboid("screen", display.with_z(out(0.002)));
    let keys = strip.slab(Side::Right, strip.width() * 0.3).inset(0.02, strip.height() * 0.34, 0.0);
    for key in keys.columns(4, 0.01) {
        builder.cuboid("plastic_dark", key.moved(0.0, strip.height() * 0.1, 0.0).with_z(out(0.003)));
    }
    let knob = turned_forward(cylinder((strip.height() * 0.25).min(0.02), [-SINK, REACH * 0.6], 10));
    builder.add(metal, knob.moved(strip.low.x + strip.width() * 0.12, strip.center().y, surface));
    let badge = Bay::around(DVec3::new(0.0, door.low.y + 0.05, surface), 0.07, 0.012, 0.0);
    builder.cuboid("metal", badge.with_z(out(0.002)));
}
