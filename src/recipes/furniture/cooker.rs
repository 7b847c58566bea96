//! Free-standing cookers: flush, a range, one of a restaurant's kitchen, of thin sheet.

use glam::DVec3;

use super::ovens::{hob, hob_height, oven_front, oven_slots};
use super::parts::{
    Fittings, HandleForm, HandleKind, LegKind, handle, legs_at_corners, raised_panel, turned_forward,
};
use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, Outline, SINK, Slice, lathe, loft_ring};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// Metres by which handles and knobs stand out.
const REACH: f64 = 0.028;
/// The same where the front is flush.
const FLUSH_REACH: f64 = 0.014;
/// Metres by which a guard at the back stands over the top.
const GUARD: f64 = 0.05;

/// A free-standing cooker: four zones over an oven.
pub(super) static COOKER: Recipe =
    Recipe::furniture("cooker", [0.6, 0.6, 0.9]).symbol(Symbol::Cooker).every_set(cooker);

fn cooker(draft: &Draft, builder: &mut Builder) {
    let slots = oven_slots(draft);
    match draft.set() {
        GeometrySet::Plain => flush(draft, builder, slots),
        GeometrySet::Traditional => range(builder, slots),
        GeometrySet::Industrial => of_a_restaurant(builder, slots),
        GeometrySet::Budget => of_sheet(draft, builder, slots),
    }
}

fn fittings([front, handle]: [Slot; 2], reach: f64) -> Fittings {
    Fittings { front, handle, reach, is_traditional: false }
}

/// The foot that steps back under the fronts.
fn kick(builder: &mut Builder, body: Bay, foot: f64) {
    let kick = body.slab(Side::Below, foot + SINK).inset(0.008, 0.0, 0.008).without(Side::Front, 0.05);
    builder.cuboid(Slot::PlasticDark, kick);
}

/// A flush front with a touch panel over a door of glass and a drawer with a groove.
fn flush(draft: &Draft, builder: &mut Builder, slots: [Slot; 2]) {
    let bay = builder.bay();
    let lift = hob_height(GeometrySet::Plain);
    let top = bay.without(Side::Above, lift).slab(Side::Above, 0.02);
    builder.block(Slot::Metal, top, 0.004);
    hob(draft, builder, top);
    let foot = (bay.height() * 0.08).min(0.06);
    let body = bay.with_y([0.0, top.low.y + SINK]).inset(0.002, 0.0, 0.002);
    kick(builder, body, foot);
    let fittings = fittings(slots, FLUSH_REACH);
    let body = body.without(Side::Below, foot);
    fittings.carcass(builder, slots[0], body);
    let face = body.inset(0.003, 0.003, 0.0);
    let surface = face.high.z - FLUSH_REACH;
    let strip = face.slab(Side::Above, face.height() * 0.1);
    let drawer = face.slab(Side::Below, face.height() * 0.22);
    let door = face.with_y([drawer.high.y + 0.004, strip.low.y - 0.004]);
    for panel in [strip, door, drawer] {
        fittings.panel(builder, panel);
    }
    builder.cuboid(Slot::Screen, strip.inset(0.004, 0.004, 0.0).with_z([surface - SINK, surface + 0.003]));
    let glass = door.inset(0.004, 0.004, 0.0).without(Side::Above, door.height() * 0.14);
    builder.cuboid(Slot::Screen, glass.with_z([surface - SINK, surface + 0.004]));
    // One bar along the whole door, one along the whole drawer.
    for panel in [door, drawer] {
        let bar = panel.slab(Side::Above, 0.022).inset(0.004, 0.003, 0.0);
        builder.cuboid(slots[1], bar.with_z([surface - SINK, face.high.z]));
    }
}

/// A range: two panelled doors under big knobs and a rail, on turned feet, with cast rings.
fn range(builder: &mut Builder, slots: [Slot; 2]) {
    let bay = builder.bay();
    let [front, metal] = slots;
    let lift = hob_height(GeometrySet::Traditional);
    let top = bay.without(Side::Above, lift).slab(Side::Above, 0.035);
    builder.block(Slot::MetalDark, top, 0.01);
    cast_rings(builder, metal, top.high.y);
    let foot = (bay.height() * 0.16).min(0.13);
    let body = bay.with_y([0.0, top.low.y + SINK]).inset(0.004, 0.0, 0.004);
    let feet = body.with_y([0.0, foot + SINK]).without(Side::Front, REACH + 0.01).inset(0.006, 0.0, 0.006);
    legs_at_corners(builder, metal, feet, 0.07, LegKind::Turned);
    let body = body.without(Side::Below, foot);
    let fittings = fittings(slots, REACH);
    fittings.carcass(builder, front, body);
    let plinth = body.slab(Side::Below, 0.03).without(Side::Front, REACH - 0.008).inset(-0.003, 0.0, 0.0);
    builder.block(front, plinth.moved(0.0, -0.001, 0.0).without(Side::Back, 0.01), 0.006);
    let face = body.without(Side::Below, 0.032).inset(0.003, 0.003, 0.0);
    let surface = face.high.z - REACH;
    let strip = face.slab(Side::Above, face.height() * 0.2);
    fittings.panel(builder, strip);
    let size = (strip.height() * 0.24).min(0.03);
    let knob = turned_forward(lathe(&[(size, -SINK), (size * 1.1, 0.008), (size * 0.7, REACH * 0.9)], 10));
    for place in [-0.36, -0.18, 0.0, 0.18, 0.36] {
        builder.add(
            metal,
            knob.clone().moved(place * strip.width(), strip.low.y + strip.height() * 0.34, surface),
        );
    }
    let rail = DVec3::new(0.0, strip.high.y - strip.height() * 0.16, surface);
    handle(builder, metal, HandleForm { kind: HandleKind::Level, length: strip.width() * 0.94 }, rail, REACH);
    let doors = face.without(Side::Above, strip.height() + 0.004);
    let share = doors.width() * 0.6;
    for (index, door) in [doors.slab(Side::Left, share - 0.002), doors.without(Side::Left, share + 0.002)]
        .into_iter()
        .enumerate()
    {
        fittings.panel(builder, door);
        let margin = door.width().min(door.height()) * 0.16;
        let field = door.inset(margin, margin, 0.0).with_z([surface - SINK, surface + 0.012]);
        raised_panel(builder, front, field);
        if index == 0 {
            let window = field.inset(field.width() * 0.2, field.height() * 0.28, 0.0);
            builder.cuboid(Slot::Screen, window.with_z([surface, surface + 0.014]));
        }
        let bar = DVec3::new(door.center().x, door.high.y - margin * 0.5, surface);
        handle(
            builder,
            metal,
            HandleForm { kind: HandleKind::Level, length: door.width() * 0.6 },
            bar,
            REACH,
        );
    }
}

/// Four rings with crowns on a top at a height.
fn cast_rings(builder: &mut Builder, metal: Slot, top: f64) {
    let bay = builder.bay();
    let radius = bay.width().min(bay.depth()) * 0.17;
    for (x, z) in [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)] {
        let size = radius * if x * z > 0.0 { 1.0 } else { 0.8 };
        let ring = [(top - SINK, 1.0), (bay.high.y, 0.92), (bay.high.y, 0.68), (top - SINK, 0.6)];
        let slices = ring.map(|(y, share)| Slice::round(y, size * share));
        let at = [x * bay.width() * 0.24, z * bay.depth() * 0.22];
        builder.add(Slot::MetalDark, loft_ring(&Outline::Round(14), &slices).moved(at[0], 0.0, at[1]));
        let crown =
            [(size * 0.45, top - SINK), (size * 0.3, top + hob_height(GeometrySet::Traditional) * 0.7)];
        builder.add(metal, lathe(&crown, 8).moved(at[0], 0.0, at[1]));
    }
}

/// Heavy grates and a guard at the back on a body of steel over an open frame of square legs.
fn of_a_restaurant(builder: &mut Builder, slots: [Slot; 2]) {
    let bay = builder.bay();
    let [front, metal] = slots;
    let top = bay.without(Side::Above, GUARD).slab(Side::Above, 0.05);
    builder.block(Slot::Metal, top, 0.006);
    let guard = bay.slab(Side::Back, 0.03).inset(0.001, 0.0, 0.001).with_y([top.high.y - SINK, bay.high.y]);
    builder.cuboid(Slot::Metal, guard);
    let room = top.inset(0.03, 0.0, 0.03).without(Side::Back, 0.02);
    for grate in room.columns(2, 0.012) {
        let high = top.high.y + 0.034;
        for side in [Side::Front, Side::Back] {
            let sill = grate.slab(side, 0.016).with_y([top.high.y - SINK, high - 0.008]);
            builder.cuboid(Slot::MetalDark, sill);
        }
        for bar in grate.inset(0.004, 0.0, -0.002).columns(4, grate.width() * 0.18) {
            builder.cuboid(Slot::MetalDark, bar.with_y([high - 0.02, high]));
        }
        for share in [0.27, 0.73] {
            let crown = [(0.05, top.high.y - SINK), (0.045, top.high.y + 0.01), (0.03, top.high.y + 0.012)];
            let at = DVec3::new(grate.center().x, 0.0, grate.low.z + grate.depth() * share);
            builder.add(Slot::MetalDark, lathe(&crown, 10).moved(at.x, 0.0, at.z));
        }
    }
    let foot = bay.height() * 0.24;
    let body = bay.with_y([0.0, top.low.y + SINK]).inset(0.004, 0.0, 0.004);
    let frame = body.with_y([0.0, foot + SINK]).without(Side::Front, REACH + 0.01);
    legs_at_corners(builder, Slot::Metal, frame.inset(0.006, 0.0, 0.006), 0.04, LegKind::Square);
    let shelf = frame.inset(0.012, 0.0, 0.012).with_y([foot * 0.36, foot * 0.36 + 0.02]);
    builder.cuboid(Slot::MetalDark, shelf);
    let body = body.without(Side::Below, foot);
    let fittings = fittings(slots, REACH);
    fittings.carcass(builder, front, body);
    let face = body.inset(0.003, 0.003, 0.0);
    let surface = face.high.z - REACH;
    let strip = face.slab(Side::Above, face.height() * 0.2);
    let door = face.without(Side::Above, strip.height() + 0.004);
    fittings.panel(builder, strip);
    fittings.panel(builder, door);
    let size = (strip.height() * 0.3).min(0.026);
    let knob = turned_forward(lathe(&[(size, -SINK), (size, REACH * 0.6), (size * 0.4, REACH * 0.9)], 6));
    for place in [-0.38, -0.2, 0.2, 0.38] {
        builder.add(metal, knob.clone().moved(place * strip.width(), strip.center().y, surface));
    }
    let field = door.inset(door.width() * 0.08, door.height() * 0.12, 0.0).without(Side::Above, 0.05);
    builder.block(front, field.with_z([surface - SINK, surface + 0.008]), 0.003);
    let bar = DVec3::new(0.0, door.high.y - 0.04, surface);
    handle(builder, metal, HandleForm { kind: HandleKind::Level, length: door.width() * 0.92 }, bar, REACH);
}

/// Thin sheet: a shallow top, knobs, an oven with a small window over a drawer.
fn of_sheet(draft: &Draft, builder: &mut Builder, slots: [Slot; 2]) {
    let bay = builder.bay();
    let lift = hob_height(GeometrySet::Budget);
    let top = bay.without(Side::Above, lift).slab(Side::Above, 0.012).without(Side::Front, REACH * 0.6);
    builder.cuboid(slots[0], top);
    hob(draft, builder, top);
    let foot = (bay.height() * 0.05).min(0.04);
    let body = bay.with_y([0.0, top.low.y + SINK]).inset(0.002, 0.0, 0.002).without(Side::Front, -0.002);
    let feet = body.with_y([0.0, foot + SINK]).inset(0.02, 0.0, 0.02).without(Side::Front, 0.04);
    legs_at_corners(builder, Slot::PlasticDark, feet, 0.04, LegKind::Square);
    let body = body.without(Side::Below, foot);
    let fittings = fittings(slots, REACH);
    fittings.carcass(builder, slots[0], body);
    let face = body.inset(0.003, 0.003, 0.0);
    let low = face.height() * 0.26;
    oven_front(draft, builder, face.without(Side::Below, low));
    fittings.drawer(builder, face.slab(Side::Below, low - 0.004));
}
