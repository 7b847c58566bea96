//! Small machines on worktops: kettles and coffee machines.

use glam::DVec3;

use super::parts::turned_forward;
use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, SINK, Solid, cylinder, lathe, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// A kettle with a spout to the right and a handle to the left or above: a jug on its base, one with a belly and a bail,
/// a goose neck, or one of plastic.
pub(super) static KETTLE: Recipe = Recipe::accessory("kettle", [0.22, 0.16, 0.24]).every_set(kettle);

fn kettle(draft: &Draft, builder: &mut Builder) {
    let look = draft.form();
    if draft.is_traditional() {
        kettle_with_bail(builder, [Slot::PaintedAccent, Slot::Chrome, Slot::Brass, Slot::Painted][look]);
    } else {
        kettle_on_base(builder, draft.set(), look);
    }
}

/// Metres by which a kettle's body stands to the right of the middle, for its handle's sake.
fn kettle_middle(bay: Bay) -> f64 {
    bay.width() * 0.04
}

/// A kettle's body through (share of the radius, share of the height).
fn kettle_body(bay: Bay, profile: &[(f64, f64)], sides: usize) -> Solid {
    let (radius, height) = (bay.depth() / 2.0, bay.height());
    let profile: Vec<(f64, f64)> = profile.iter().map(|&(share, y)| (radius * share, height * y)).collect();
    lathe(&profile, sides).moved(kettle_middle(bay), 0.0, 0.0)
}

/// A point beside a kettle's axis at a share of its height.
fn kettle_point(bay: Bay, out: f64, y: f64) -> DVec3 {
    DVec3::new(kettle_middle(bay) + out, bay.height() * y, 0.0)
}

/// One with a belly and a bail over its lid.
fn kettle_with_bail(builder: &mut Builder, slot: Slot) {
    let bay = builder.bay();
    let (height, radius, x) = (bay.height(), bay.depth() / 2.0, kettle_middle(bay));
    let at = |out: f64, y: f64| kettle_point(bay, out, y);
    let right = bay.high.x - x;
    let left = bay.low.x - x;
    let turned = |profile: &[(f64, f64)]| kettle_body(bay, profile, 12);
    builder
        .add(slot, turned(&[(0.86, 0.0), (1.0, 0.14), (1.0, 0.26), (0.8, 0.46), (0.42, 0.58), (0.3, 0.6)]));
    builder.add(Slot::WoodDark, turned(&[(0.08, 0.59), (0.14, 0.63), (0.05, 0.68)]));
    builder.add(
        slot,
        sweep(
            &[at(radius * 0.8, 0.22), at(right * 0.8, 0.4), at(right - radius * 0.1, 0.52)],
            radius * 0.13,
            6,
        ),
    );
    let low = left + radius * 0.12;
    let bail = [
        at(-radius * 0.82, 0.42),
        at(low, 0.7),
        at(-radius * 0.5, 0.955),
        at(radius * 0.5, 0.955),
        at(radius * 0.86, 0.7),
        at(radius * 0.8, 0.42),
    ];
    builder.add(Slot::MetalDark, sweep(&bail, radius * 0.07, 4));
    builder.cuboid(
        slot,
        Bay::new([bay.low.x, x - radius * 0.9], [height * 0.5, height * 0.53], [-0.006, 0.006]),
    );
}

/// One on a base with its handle at the left: a jug, a goose neck, or one of plastic.
fn kettle_on_base(builder: &mut Builder, set: GeometrySet, look: usize) {
    let bay = builder.bay();
    let (slot, grip) = match set {
        GeometrySet::Industrial => {
            ([Slot::Metal, Slot::MetalDark, Slot::Metal, Slot::Brass][look], Slot::WoodDark)
        }
        GeometrySet::Budget => {
            ([Slot::Plastic, Slot::PlasticDark, Slot::PaintedAccent, Slot::Plastic][look], Slot::PlasticDark)
        }
        _ => ([Slot::Metal, Slot::PlasticDark, Slot::Painted, Slot::Glass][look], Slot::PlasticDark),
    };
    builder.add(Slot::PlasticDark, kettle_body(bay, &[(0.94, 0.0), (0.94, 0.05), (0.8, 0.08)], 12));
    let is_goose = set == GeometrySet::Industrial;
    let body: &[(f64, f64)] = if is_goose {
        &[(1.0, 0.075), (0.96, 0.2), (0.62, 0.7), (0.5, 0.74), (0.2, 0.78)]
    } else if set == GeometrySet::Budget {
        &[(0.96, 0.075), (0.98, 0.3), (0.78, 0.86), (0.72, 0.9), (0.3, 0.95)]
    } else {
        &[(0.9, 0.075), (1.0, 0.26), (0.84, 0.72), (0.66, 0.9), (0.2, 0.95)]
    };
    builder.add(slot, kettle_body(bay, body, 12));
    let lid = body[4].1;
    let knob = [(0.06, lid - 0.01), (0.16, lid + 0.02), (0.1, 1.0)];
    builder.add(grip, kettle_body(bay, &knob, 8));
    kettle_spout(builder, slot, is_goose);
    kettle_handle(builder, grip, is_goose);
}

/// A goose neck from low on the body, or a short spout at the rim.
fn kettle_spout(builder: &mut Builder, slot: Slot, is_goose: bool) {
    let bay = builder.bay();
    let (radius, right) = (bay.depth() / 2.0, bay.high.x - kettle_middle(bay));
    let at = |out: f64, y: f64| kettle_point(bay, out, y);
    if is_goose {
        let pipe = radius * 0.07;
        let neck = [
            at(radius * 0.7, 0.2),
            at(right * 0.62, 0.3),
            at(right * 0.7, 0.6),
            at(right - pipe * 1.2, 0.74),
        ];
        builder.add(slot, sweep(&neck, pipe, 5));
    } else {
        builder
            .add(slot, sweep(&[at(radius * 0.6, 0.62), at(right - radius * 0.14, 0.82)], radius * 0.15, 6));
    }
}

/// A bow at the left.
fn kettle_handle(builder: &mut Builder, grip: Slot, is_goose: bool) {
    let bay = builder.bay();
    let (radius, left) = (bay.depth() / 2.0, bay.low.x - kettle_middle(bay));
    let at = |out: f64, y: f64| kettle_point(bay, out, y);
    let thick = radius * 0.11;
    let (top, low) = if is_goose { (0.68, 0.24) } else { (0.86, 0.22) };
    let bow = [
        at(-radius * 0.5, top),
        at(left + thick, top - 0.03),
        at(left + thick, low + 0.08),
        at(-radius * 0.9, low),
    ];
    builder.add(grip, sweep(&bow, thick, 5));
}

/// A coffee machine: automatic, with a jug under a filter, or with a lever and a sieve holder.
pub(super) static COFFEE_MACHINE: Recipe =
    Recipe::furniture("coffee_machine", [0.3, 0.4, 0.38]).every_set(coffee_machine);

fn coffee_machine(draft: &Draft, builder: &mut Builder) {
    let look = draft.form();
    let form = match draft.set() {
        GeometrySet::Plain => [0, 2, 0, 1],
        GeometrySet::Traditional => [2, 1, 2, 2],
        GeometrySet::Industrial => [2, 2, 0, 2],
        GeometrySet::Budget => [1, 1, 0, 1],
    }[look];
    let slot = match draft.set() {
        GeometrySet::Plain => [Slot::PlasticDark, Slot::Metal, Slot::Metal, Slot::Plastic],
        GeometrySet::Traditional => [Slot::Brass, Slot::PaintedAccent, Slot::Chrome, Slot::Painted],
        GeometrySet::Industrial => [Slot::Metal, Slot::MetalDark, Slot::Metal, Slot::Chrome],
        GeometrySet::Budget => [Slot::Plastic, Slot::PlasticDark, Slot::PlasticDark, Slot::PaintedAccent],
    }[look];
    let bay = builder.bay();
    let height = bay.height();
    let base = bay.slab(Side::Below, height * 0.12);
    builder.block(slot, base, 0.006);
    match form {
        0 => automatic(builder, slot, base),
        1 => filter(builder, slot, base),
        _ => espresso(builder, slot, base),
    }
}

fn grid(builder: &mut Builder, base: Bay) {
    let grid = base.slab(Side::Front, base.depth() * 0.5).inset(base.width() * 0.1, 0.0, base.depth() * 0.03);
    builder.cuboid(Slot::MetalDark, grid.with_y([base.high.y - SINK, base.high.y + 0.003]));
    for bar in grid.inset(0.004, 0.0, 0.004).columns(7, grid.width() * 0.05) {
        builder.cuboid(Slot::Metal, bar.with_y([base.high.y + 0.002, base.high.y + 0.006]));
    }
}

/// A cup on the grid or on the top.
fn cup(builder: &mut Builder, at: DVec3, size: f64) {
    let profile = [(0.6, 0.0), (1.0, 0.5), (1.0, 1.4), (0.9, 1.4), (0.6, 0.2)];
    let cup = lathe(&profile.map(|(radius, y)| (radius * size, at.y + y * size)), 10);
    builder.add(Slot::Ceramic, cup.moved(at.x, 0.0, at.z));
}

fn automatic(builder: &mut Builder, slot: Slot, base: Bay) {
    let bay = builder.bay();
    let height = bay.height();
    grid(builder, base);
    let column = bay.without(Side::Front, bay.depth() * 0.48).with_y([base.high.y - SINK, height * 0.7]);
    builder.cuboid(slot, column.inset(0.006, 0.0, 0.006));
    let head = bay.with_y([height * 0.68, height * 0.93]).without(Side::Front, bay.depth() * 0.05);
    builder.block(slot, head, 0.01);
    let hopper = head.slab(Side::Back, head.depth() * 0.5).inset(head.width() * 0.16, 0.0, 0.02);
    builder.block(Slot::Glass, hopper.with_y([head.high.y - SINK, height]), 0.006);
    let z = bay.high.z - bay.depth() * 0.24;
    for x in [-0.05, 0.05] {
        let x = x * bay.width();
        builder.add(
            Slot::Chrome,
            cylinder(bay.width() * 0.03, [height * 0.54, height * 0.69], 8).moved(x, 0.0, z),
        );
    }
    builder.block(
        slot,
        Bay::around(DVec3::new(0.0, height * 0.64, z), bay.width() * 0.26, height * 0.1, bay.depth() * 0.14),
        0.004,
    );
    let panel = head.inset(head.width() * 0.16, head.height() * 0.22, 0.0);
    builder.cuboid(Slot::Screen, panel.with_z([head.high.z - SINK, head.high.z + 0.002]));
    let knob = turned_forward(cylinder(head.height() * 0.13, [0.0, bay.depth() * 0.05], 12));
    builder.add(Slot::Chrome, knob.moved(head.width() * 0.28, head.center().y, head.high.z));
    cup(builder, DVec3::new(0.0, base.high.y + 0.0055, z), height * 0.085);
}

fn filter(builder: &mut Builder, slot: Slot, base: Bay) {
    let bay = builder.bay();
    let height = bay.height();
    let tank = bay.slab(Side::Back, bay.depth() * 0.38).with_y([base.high.y - SINK, height * 0.99]);
    builder.block(slot, tank.inset(0.004, 0.0, 0.002), 0.01);
    let head = bay.with_y([height * 0.66, height]).without(Side::Front, bay.depth() * 0.04);
    builder.block(slot, head.slab(Side::Above, head.height() * 0.5).inset(0.0, 0.0, 0.001), 0.012);
    let z = bay.high.z - bay.depth() * 0.32;
    let radius = (bay.width() * 0.36).min(bay.depth() * 0.27);
    let cone = [(radius * 0.35, height * 0.63), (radius * 0.95, height * 0.84)];
    builder.add(Slot::PlasticDark, lathe(&cone, 12).moved(0.0, 0.0, z));
    builder.add(
        Slot::MetalDark,
        cylinder(radius * 0.9, [base.high.y - SINK, base.high.y + 0.005], 14).moved(0.0, 0.0, z),
    );
    let low = base.high.y + 0.0045;
    let jug = [
        (radius * 0.8, low),
        (radius, low + height * 0.12),
        (radius * 0.96, low + height * 0.26),
        (radius * 0.62, low + height * 0.42),
        (radius * 0.68, low + height * 0.46),
    ];
    builder.add(Slot::Glass, lathe(&jug, 12).moved(0.0, 0.0, z));
    let coffee = [
        (radius * 0.7, low + 0.003),
        (radius * 0.9, low + height * 0.12),
        (radius * 0.9, low + height * 0.2),
    ];
    builder.add(Slot::Soil, lathe(&coffee, 12).moved(0.0, 0.0, z));
    let front = bay.high.z - 0.008;
    let bow = [
        DVec3::new(0.0, low + height * 0.42, z + radius * 0.6),
        DVec3::new(0.0, low + height * 0.42, front),
        DVec3::new(0.0, low + height * 0.1, front),
        DVec3::new(0.0, low + height * 0.08, z + radius * 0.94),
    ];
    builder.add(Slot::PlasticDark, sweep(&bow, 0.008, 6));
    let light = Bay::around(DVec3::new(bay.width() * 0.36, base.center().y, base.high.z), 0.02, 0.014, 0.0);
    builder
        .cuboid(Slot::Lamp, light.with_z([base.high.z - 0.004, base.high.z - SINK]).moved(0.0, 0.0, 0.001));
}

fn espresso(builder: &mut Builder, slot: Slot, base: Bay) {
    let bay = builder.bay();
    let height = bay.height();
    grid(builder, base);
    let column = bay.without(Side::Front, bay.depth() * 0.5).with_y([base.high.y - SINK, height * 0.72]);
    builder.cuboid(slot, column.inset(0.004, 0.0, 0.004));
    let head = bay.with_y([height * 0.64, height * 0.88]).without(Side::Front, bay.depth() * 0.16);
    builder.block(slot, head, 0.012);
    for side in [Side::Front, Side::Back, Side::Left, Side::Right] {
        let thin = if matches!(side, Side::Left | Side::Right) { 0.0007 } else { 0.0 };
        let rail = head
            .inset(0.012 + thin, 0.0, 0.012 + thin)
            .with_y([height * 0.9, height * 0.915])
            .inset(0.0, thin, 0.0);
        builder.cuboid(Slot::Chrome, rail.slab(side, 0.005));
    }
    let z = head.high.z - bay.depth() * 0.1;
    let radius = bay.width() * 0.12;
    builder.add(
        Slot::Chrome,
        lathe(&[(radius * 0.9, height * 0.54), (radius, height * 0.56), (radius, height * 0.66)], 12)
            .moved(0.0, 0.0, z),
    );
    let holder = [DVec3::new(0.0, height * 0.555, z), DVec3::new(0.0, height * 0.53, bay.high.z - 0.006)];
    builder.add(Slot::WoodDark, sweep(&holder, (height * 0.03).min(0.012), 8));
    builder.cuboid(
        Slot::WoodDark,
        Bay::around(DVec3::new(0.0, height * 0.53, bay.high.z - 0.006), 0.016, 0.02, 0.012),
    );
    knobs_and_gauge(builder, head);
    steam_wand(builder, head, z);
    let size = height * 0.07;
    cup(builder, DVec3::new(0.0, base.high.y + 0.0055, z), size);
    for place in [-0.22, 0.18] {
        cup(
            builder,
            DVec3::new(place * bay.width(), head.high.y - SINK, head.center().z - bay.depth() * 0.1),
            size * 0.85,
        );
    }
    builder.cuboid(
        slot,
        Bay::around(DVec3::new(0.0, height * 0.94, head.low.z + 0.05), bay.width() * 0.4, 0.0, 0.06)
            .with_y([head.high.y - SINK, height]),
    );
}

/// A gauge between two knobs.
fn knobs_and_gauge(builder: &mut Builder, head: Bay) {
    let bay = builder.bay();
    for x in [-0.3, 0.3] {
        let knob = turned_forward(lathe(&[(0.012, -SINK), (0.018, 0.01), (0.014, 0.026)], 8));
        builder.add(Slot::PlasticDark, knob.moved(x * bay.width(), head.center().y, head.high.z));
    }
    let gauge = turned_forward(lathe(
        &[(head.height() * 0.26, -SINK), (head.height() * 0.26, 0.006), (head.height() * 0.2, 0.007)],
        14,
    ));
    builder.add(Slot::Paper, gauge.moved(0.0, head.center().y, head.high.z));
}

/// A bent pipe at the right.
fn steam_wand(builder: &mut Builder, head: Bay, z: f64) {
    let bay = builder.bay();
    let height = bay.height();
    let x = bay.width() * 0.42;
    let wand = [
        DVec3::new(x, head.low.y + 0.01, z),
        DVec3::new(x, height * 0.4, z + 0.02),
        DVec3::new(x * 0.9, height * 0.26, z + 0.03),
    ];
    builder.add(Slot::Chrome, sweep(&wand, 0.006, 6));
}
