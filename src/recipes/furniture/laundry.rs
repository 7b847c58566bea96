//! Machines that wash and dry.

use glam::DVec3;

use super::parts::{Fittings, HandleForm, HandleKind, LegKind, handle, legs_at_corners, turned_forward};
use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, Outline, SINK, Slice, cylinder, lathe, loft_ring};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// Metres by which handles, knobs and doors stand out.
const REACH: f64 = 0.025;

/// What a machine of a set is made of: its body, its front and its handles.
fn slots(draft: &Draft) -> [Slot; 3] {
    let look = draft.form();
    let choices = match draft.set() {
        GeometrySet::Plain => [
            [Slot::Appliance, Slot::Appliance, Slot::Metal],
            [Slot::Metal, Slot::Metal, Slot::MetalDark],
            [Slot::Appliance, Slot::Appliance, Slot::MetalDark],
            [Slot::MetalDark, Slot::MetalDark, Slot::Chrome],
        ],
        GeometrySet::Traditional => [
            [Slot::Appliance, Slot::Painted, Slot::Brass],
            [Slot::PaintedAccent, Slot::PaintedAccent, Slot::Chrome],
            [Slot::Appliance, Slot::Appliance, Slot::Chrome],
            [Slot::Painted, Slot::Painted, Slot::Brass],
        ],
        GeometrySet::Industrial => [
            [Slot::Metal, Slot::Metal, Slot::MetalDark],
            [Slot::MetalDark, Slot::Metal, Slot::Metal],
            [Slot::Metal, Slot::Metal, Slot::PlasticDark],
            [Slot::Metal, Slot::PaintedAccent, Slot::Metal],
        ],
        GeometrySet::Budget => [
            [Slot::Appliance, Slot::Appliance, Slot::Plastic],
            [Slot::Appliance, Slot::Plastic, Slot::PlasticDark],
            [Slot::Plastic, Slot::Appliance, Slot::Plastic],
            [Slot::Appliance, Slot::Appliance, Slot::PlasticDark],
        ],
    };
    choices[look]
}

/// What a machine stands on.
#[derive(Clone, Copy)]
enum Foot {
    /// A plinth that steps back.
    Kick,
    /// Short round feet.
    Feet,
    /// Turned feet, as of a stove.
    Turned,
    /// A plinth as wide as the machine.
    Plinth,
}

/// Top, foot and carcass of a machine; gives the bay of its fronts and what they are made of.
fn case(draft: &Draft, builder: &mut Builder, foot: Foot) -> (Fittings, Bay) {
    let bay = builder.bay();
    let [body, front, metal] = slots(draft);
    builder.block(body, bay.slab(Side::Above, 0.025).without(Side::Front, REACH * 0.6), 0.004);
    let fittings = Fittings { front, handle: metal, reach: REACH, is_traditional: false };
    let room = bay.without(Side::Above, 0.025 - SINK).inset(0.002, 0.0, 0.002).without(Side::Front, -0.002);
    let high = match foot {
        Foot::Kick | Foot::Feet => (bay.height() * 0.1).min(0.05),
        Foot::Turned | Foot::Plinth => (bay.height() * 0.15).min(0.11),
    };
    let under = room.slab(Side::Below, high + SINK).inset(0.008, 0.0, 0.008).without(Side::Front, 0.05);
    match foot {
        Foot::Kick => builder.cuboid(Slot::PlasticDark, under),
        Foot::Feet => legs_at_corners(builder, Slot::Rubber, under, 0.05, LegKind::Round),
        Foot::Turned => legs_at_corners(builder, metal, under, 0.07, LegKind::Turned),
        Foot::Plinth => builder.block(Slot::Concrete, under.without(Side::Front, -0.04), 0.006),
    }
    let room = room.without(Side::Below, high);
    fittings.carcass(builder, body, room);
    // The sides of the box.
    let band =
        room.without(Side::Front, fittings.depth() + 0.01).with_y([room.low.y + 0.02, room.low.y + 0.03]);
    builder.cuboid(body, band.inset(-0.002, 0.0, 0.01));
    (fittings, room.inset(0.003, 0.003, 0.0))
}

/// A washing machine with a porthole and a drawer for powder; with `dryer`, a door without glass, a filter and slits.
/// Flush on a kick, on turned feet with a raised front, a laundry's on a plinth, or with a flap of its own.
pub(super) static WASHING_MACHINE: Recipe = Recipe::furniture("washing_machine", [0.6, 0.6, 0.85])
    .with(&[("dryer", 0.0)])
    .symbol(Symbol::Drum)
    .every_set(washing_machine);

fn washing_machine(draft: &Draft, builder: &mut Builder) {
    let foot = match draft.set() {
        GeometrySet::Plain => Foot::Kick,
        GeometrySet::Traditional => Foot::Turned,
        GeometrySet::Industrial => Foot::Plinth,
        GeometrySet::Budget => Foot::Feet,
    };
    let (fittings, face) = case(draft, builder, foot);
    let is_dryer = draft.is_set("dryer");
    let share = match draft.set() {
        GeometrySet::Plain => 0.12,
        GeometrySet::Industrial => 0.24,
        GeometrySet::Traditional | GeometrySet::Budget => 0.17,
    };
    let strip = face.slab(Side::Above, face.height() * share);
    let surface = face.high.z - REACH;
    let front = face.without(Side::Above, strip.height() + 0.003);
    fittings.panel(builder, front);
    fittings.panel(builder, strip);
    controls(draft, builder, strip, surface);
    porthole(draft, builder, front, surface, is_dryer);
    let flap = front.slab(Side::Below, 0.09).inset(0.02, 0.015, 0.0);
    if is_dryer {
        for slit in flap.inset(front.width() * 0.1, 0.0, 0.0).rows(4, 0.008) {
            builder.cuboid(Slot::PlasticDark, slit.with_z([surface - SINK, surface + 0.0015]));
        }
    } else if draft.set() != GeometrySet::Industrial {
        let hatch = flap.slab(
            if draft.input.look.is_multiple_of(2) { Side::Left } else { Side::Right },
            front.width() * 0.22,
        );
        builder.cuboid(Slot::Plastic, hatch.with_z([surface - SINK, surface + 0.003]));
    }
}

/// Drawer, knobs, display and keys: a strip of glass, two big knobs, buttons in a case, or one knob beside keys.
fn controls(draft: &Draft, builder: &mut Builder, strip: Bay, surface: f64) {
    let metal = slots(draft)[2];
    let out = |lift: f64| [surface - SINK, surface + lift];
    let knobs: &[f64] = match draft.set() {
        GeometrySet::Plain => {
            let glass = strip.without(Side::Left, strip.width() * 0.3).inset(0.006, 0.006, 0.0);
            builder.cuboid(Slot::Screen, glass.with_z(out(0.003)));
            &[]
        }
        GeometrySet::Traditional => &[0.05, 0.34],
        GeometrySet::Industrial => {
            buttons_in_a_case(builder, strip, surface);
            &[]
        }
        GeometrySet::Budget => {
            flat_keys(builder, strip, surface);
            &[0.0]
        }
    };
    let drawer = strip.slab(Side::Left, strip.width() * 0.28).inset(0.015, 0.015, 0.0);
    builder.block(Slot::Plastic, drawer.with_z(out(0.006)), 0.002);
    builder
        .cuboid(Slot::PlasticDark, drawer.slab(Side::Below, 0.02).inset(0.03, 0.004, 0.0).with_z(out(0.008)));
    let radius = strip.height() * 0.3;
    let knob = [
        (radius * 1.15, -SINK),
        (radius * 1.1, REACH * 0.2),
        (radius * 0.85, REACH * 0.25),
        (radius * 0.75, REACH * 0.95),
    ];
    let knob = turned_forward(lathe(&knob, 12));
    for &place in knobs {
        builder.add(metal, knob.clone().moved(place * strip.width(), strip.center().y, surface));
    }
}

/// Three big buttons in a case of sheet metal.
fn buttons_in_a_case(builder: &mut Builder, strip: Bay, surface: f64) {
    let case = strip.without(Side::Left, strip.width() * 0.4).inset(0.02, 0.02, 0.0);
    builder.block(Slot::MetalDark, case.with_z([surface - SINK, surface + REACH * 0.7]), 0.004);
    let keys = case.inset(0.03, case.height() * 0.25, 0.0).columns(3, 0.03);
    for (key, slot) in keys.into_iter().zip([Slot::PaintedAccent, Slot::Plastic, Slot::Plastic]) {
        builder.block(slot, key.with_z([surface, surface + REACH * 0.95]), 0.003);
    }
}

/// Three small keys at the right end.
fn flat_keys(builder: &mut Builder, strip: Bay, surface: f64) {
    let right = strip.slab(Side::Right, strip.width() * 0.36).inset(0.02, strip.height() * 0.22, 0.0);
    for column in right.columns(3, 0.012) {
        let key = column.inset(column.width() * 0.2, column.height() * 0.2, 0.0);
        builder.block(Slot::Plastic, key.with_z([surface - SINK, surface + 0.008]), 0.002);
    }
}

fn porthole(draft: &Draft, builder: &mut Builder, face: Bay, surface: f64, is_dryer: bool) {
    let size = [0.36, 0.33, 0.35, 0.31][draft.form()] * rim_size(draft.set());
    let radius = (face.width() * size).min(face.height() * size);
    let y = face.low.y + face.height() * 0.54;
    let shares = rim_profile(draft.set());
    let rings = shares
        .iter()
        .map(|&(out, share)| Slice::round(if out > 0.0 { REACH * out } else { -SINK }, radius * share));
    let ring: Vec<Slice> = rings.collect();
    let rim = rim_slot(draft);
    let place = |solid: crate::recipes::kit::Solid| turned_forward(solid).moved(0.0, y, surface);
    builder.add(rim, place(loft_ring(&Outline::Round(20), &ring)));
    let bulge = [(radius * 0.69, 0.002), (radius * 0.69, REACH * 0.5), (radius * 0.3, REACH * 0.8)];
    builder.add(if is_dryer { slots(draft)[1] } else { Slot::Screen }, place(lathe(&bulge, 20)));
    let x = if is_dryer { -1.0 } else { 1.0 };
    if draft.set() == GeometrySet::Industrial {
        lever_and_hinge(builder, [x * radius, y, surface], radius);
    } else {
        let grip = Bay::around(DVec3::new(x * radius * 0.86, y, 0.0), radius * 0.12, radius * 0.36, 0.0);
        builder.block(Slot::PlasticDark, grip.with_z([surface + REACH * 0.5, surface + REACH]), 0.003);
    }
    if is_dryer {
        for line in 0..5 {
            let across = radius * (0.5 - 0.06 * f64::from(line % 3));
            let bar = Bay::around(
                DVec3::new(0.0, y + radius * 0.1 * (f64::from(line) - 2.0), surface),
                across,
                0.006,
                0.0,
            );
            builder.cuboid(Slot::PlasticDark, bar.with_z([surface + REACH * 0.4, surface + REACH * 0.83]));
        }
    }
}

/// A lever to the rim at one side, and a hinge across from it.
fn lever_and_hinge(builder: &mut Builder, [side, y, surface]: [f64; 3], radius: f64) {
    let lever = Bay::around(DVec3::new(side, y, 0.0), radius * 0.44, 0.03, 0.0);
    builder.block(Slot::MetalDark, lever.with_z([surface + REACH * 0.4, surface + REACH]), 0.004);
    let hinge = Bay::around(DVec3::new(-side, y, 0.0), radius * 0.24, radius * 0.5, 0.0);
    builder.block(Slot::MetalDark, hinge.with_z([surface - SINK, surface + REACH * 0.8]), 0.004);
}

/// Factor on the size of a porthole.
fn rim_size(set: GeometrySet) -> f64 {
    match set {
        GeometrySet::Plain => 1.08,
        GeometrySet::Traditional => 0.9,
        GeometrySet::Industrial => 1.16,
        GeometrySet::Budget => 0.8,
    }
}

/// What a porthole's rim is made of.
fn rim_slot(draft: &Draft) -> Slot {
    match (draft.set(), draft.input.look % 2) {
        (GeometrySet::Plain, 0) | (GeometrySet::Traditional, _) => Slot::Chrome,
        (GeometrySet::Industrial, _) => Slot::Metal,
        (GeometrySet::Budget, 0) => Slot::Plastic,
        _ => Slot::PlasticDark,
    }
}

/// The profile of a porthole's rim: shares of how far it stands out, and of its radius.
fn rim_profile(set: GeometrySet) -> &'static [(f64, f64)] {
    match set {
        GeometrySet::Plain => &[(0.0, 1.0), (0.8, 1.0), (1.0, 0.97), (0.8, 0.7), (0.0, 0.68)],
        GeometrySet::Traditional => {
            &[(0.0, 1.0), (0.4, 1.0), (0.5, 0.93), (1.0, 0.84), (0.8, 0.7), (0.0, 0.68)]
        }
        GeometrySet::Industrial => &[(0.0, 1.0), (0.6, 1.0), (0.6, 0.8), (0.0, 0.7)],
        GeometrySet::Budget => &[(0.0, 1.0), (0.6, 0.97), (1.0, 0.87), (0.8, 0.7), (0.0, 0.68)],
    }
}

/// A dishwasher under its own top: a full front with a groove, or a panel of keys over a door with a bar.
pub(super) static DISHWASHER: Recipe =
    Recipe::furniture("dishwasher", [0.6, 0.6, 0.85]).symbol(Symbol::Diagonal).every_set(dishwasher);

fn dishwasher(draft: &Draft, builder: &mut Builder) {
    let (fittings, face) = case(draft, builder, Foot::Kick);
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
            Slot::PlasticDark,
            strip
                .slab(Side::Below, strip.height() * 0.4)
                .inset(strip.width() * 0.3, 0.004, 0.0)
                .with_z(out(REACH)),
            0.004,
        ),
        _ => handle(
            builder,
            metal,
            HandleForm {
                kind: HandleKind::Level,
                length: door.width() * if draft.set() == GeometrySet::Industrial { 0.9 } else { 0.7 },
            },
            bar,
            REACH,
        ),
    }
    let display =
        strip.inset(strip.width() * 0.38, strip.height() * 0.3, 0.0).moved(0.0, strip.height() * 0.1, 0.0);
    builder.cuboid(Slot::Screen, display.with_z(out(0.002)));
    let keys = strip.slab(Side::Right, strip.width() * 0.3).inset(0.02, strip.height() * 0.34, 0.0);
    for key in keys.columns(4, 0.01) {
        builder.cuboid(Slot::PlasticDark, key.moved(0.0, strip.height() * 0.1, 0.0).with_z(out(0.003)));
    }
    let knob = turned_forward(cylinder((strip.height() * 0.25).min(0.02), [-SINK, REACH * 0.6], 10));
    builder.add(metal, knob.moved(strip.low.x + strip.width() * 0.12, strip.center().y, surface));
    let badge = Bay::around(DVec3::new(0.0, door.low.y + 0.05, surface), 0.07, 0.012, 0.0);
    builder.cuboid(Slot::Metal, badge.with_z(out(0.002)));
}
