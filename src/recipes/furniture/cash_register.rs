//! Tills: drawers 0.35 to 0.45 m wide, with a display for each side.

use glam::{DVec2, DVec3};

use super::parts::{across, turned_forward};
use super::screens::{Shell, display};
use crate::geometry::Side;
use crate::recipes::kit::{Axis, Bay, Builder, SINK, cuboid, cylinder, extrude, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// A till: a wedge of keys over a drawer; a cast body with round keys and a crank; a screen on an arm; a small box that prints.
pub(super) static CASH_REGISTER: Recipe =
    Recipe::furniture("cash_register", [0.4, 0.45, 0.4]).every_set(cash_register);

fn cash_register(draft: &Draft, builder: &mut Builder) {
    match draft.set() {
        GeometrySet::Plain => wedge(builder),
        GeometrySet::Traditional => {
            cast(builder, [Slot::Brass, Slot::Metal, Slot::WoodDark, Slot::Brass][draft.form()])
        }
        GeometrySet::Industrial => screen_on_arm(builder),
        GeometrySet::Budget => portable(builder),
    }
}

/// A drawer in a case, its front a little smaller than the case; gives its height.
fn drawer(builder: &mut Builder, case: Slot, front: Slot, share: f64) -> f64 {
    let bay = builder.bay();
    let high = bay.height() * share;
    let body = bay.slab(Side::Below, high);
    builder.block(case, body.without(Side::Front, 0.012), 0.006);
    builder.cuboid(front, body.slab(Side::Front, 0.012 + SINK).inset(bay.width() * 0.03, high * 0.15, 0.0));
    high
}

/// A field of keys on a slope from `low` to `high`, (z, y), `half` wide to both sides.
fn keys(builder: &mut Builder, slot: Slot, thick: f64, [low, high]: [(f64, f64); 2], half: f64) {
    let (run, rise) = (low.0 - high.0, high.1 - low.1);
    let (slope, length) = (libm::atan2(rise, run), libm::sqrt(run * run + rise * rise));
    for row in 0..4 {
        for column in 0..4 {
            let z = length * (0.1 + 0.22 * f64::from(row));
            let left = half * (-0.94 + 0.48 * f64::from(column));
            let key = Bay::new([left, left + half * 0.38], [-SINK * 2.0, thick], [z, z + length * 0.16]);
            builder.add(slot, cuboid(key).turned_x(slope).moved(0.0, high.1, high.0));
        }
    }
}

fn wedge(builder: &mut Builder) {
    let bay = builder.bay();
    let drawer = drawer(builder, Slot::MetalDark, Slot::Metal, 0.28);
    let (low, high) = (bay.low.z + bay.depth() * 0.1, bay.high.z - bay.depth() * 0.12);
    let top = bay.height() * 0.62;
    let profile = [(high, drawer - SINK), (high, drawer + 0.03), (low, top), (low, drawer - SINK)];
    let x = bay.width() * 0.44;
    builder.add(Slot::Plastic, extrude(&profile.map(DVec2::from), Axis::X, [-x, x]));
    let along = |share: f64| (low + (high - low) * share, top + (drawer + 0.03 - top) * share);
    keys(builder, Slot::PlasticDark, 0.006, [along(0.96), along(0.24)], x);
    let post = Bay::new([-0.02, 0.02], [top - 0.06, bay.high.y - 0.03], [low + 0.01, low + 0.035]);
    builder.cuboid(Slot::PlasticDark, post);
    let panel = Bay::new([-x * 0.6, x * 0.6], [bay.height() * 0.74, bay.high.y], [low, low + 0.045]);
    display(builder, panel, Shell { slot: Slot::PlasticDark, border: 0.012 });
}

/// A body that swells towards the buttons, under a crown with a window for the price; a crank at the right.
fn cast(builder: &mut Builder, slot: Slot) {
    let bay = builder.bay();
    let (high, depth) = (bay.height(), bay.depth());
    let drawer = drawer(builder, Slot::WoodDark, Slot::Wood, 0.24);
    let x = bay.width() * 0.42;
    let (back, front) = (bay.low.z + depth * 0.12, bay.high.z - depth * 0.06);
    let at =
        |z: f64, y: f64| DVec2::new(back + (front - back) * z, drawer - SINK + (high * 0.74 - drawer) * y);
    let body = [
        at(0.0, 0.0),
        at(1.0, 0.0),
        at(1.0, 0.16),
        at(0.88, 0.26),
        at(0.6, 0.52),
        at(0.52, 0.72),
        at(0.4, 0.92),
        at(0.24, 1.0),
        at(0.0, 1.0),
    ];
    builder.add(slot, extrude(&body, Axis::X, [-x, x]));
    round_keys(builder, x, at);
    let crown =
        Bay::new([-x * 0.96, x * 0.96], [high * 0.74 - 0.003, high], [back + 0.004, back + depth * 0.24]);
    let arch = [
        (-0.9, 0.0),
        (0.9, 0.0),
        (1.0, 0.3),
        (0.9, 0.62),
        (0.4, 0.8),
        (0.0, 1.0),
        (-0.4, 0.8),
        (-0.9, 0.62),
        (-1.0, 0.3),
    ];
    let arch = arch.map(|(side, y)| DVec2::new(side * crown.high.x, crown.low.y + y * crown.height()));
    builder.add(slot, extrude(&arch, Axis::Z, crown.z()));
    let window = crown
        .inset(x * 0.28, 0.0, 0.0)
        .with_y([crown.low.y + crown.height() * 0.16, crown.low.y + crown.height() * 0.58]);
    builder.cuboid(Slot::Linen, window.with_z([crown.high.z - SINK, crown.high.z + 0.003]));
    for (index, digit) in window.inset(0.02, 0.012, 0.0).columns(3, 0.012).into_iter().enumerate() {
        let slot = [Slot::PlasticDark, Slot::Book, Slot::PlasticDark][index];
        builder.cuboid(slot, digit.with_z([crown.high.z + 0.0025, crown.high.z + 0.005]));
    }
    crank(builder, x, drawer + high * 0.22);
}

/// Buttons on stems on the slope of a body, whose surface is at shares of its depth and height.
fn round_keys(builder: &mut Builder, x: f64, at: impl Fn(f64, f64) -> DVec2) {
    for row in 0..4 {
        for column in 0..5 {
            let share = 0.3 + 0.2 * f64::from(row);
            let root = at(0.9 - 0.28 * share * 1.1, 0.26 + 0.3 * share - 0.02);
            let left = x * (-0.76 + 0.3 * f64::from(column));
            let (y, z) = (root.y + 0.018, root.x + 0.014);
            let stem = [DVec3::new(left, root.y - 0.02, root.x - 0.012), DVec3::new(left, y, z)];
            builder.add(Slot::Metal, sweep(&stem, 0.004, 4));
            let key = cylinder(0.014, [0.0, 0.006], 8).turned_x(0.9).moved(left, y, z);
            builder.add(if (row + column) % 5 == 0 { Slot::Book } else { Slot::Linen }, key);
        }
    }
}

/// A crank with a grip at the right of a body, `x` from the middle.
fn crank(builder: &mut Builder, x: f64, y: f64) {
    let bay = builder.bay();
    let middle = (y, bay.center().z);
    builder.add(Slot::Metal, across(0.012, [x - SINK, bay.high.x - 0.004], 8).moved(0.0, middle.0, middle.1));
    let arm = Bay::new(
        [bay.high.x - 0.014, bay.high.x - 0.002],
        [middle.0 - 0.06, middle.0 + 0.012],
        [middle.1 - 0.01, middle.1 + 0.01],
    );
    builder.cuboid(Slot::Metal, arm);
    builder.add(
        Slot::WoodDark,
        across(0.012, [x + 0.006, bay.high.x], 8).moved(0.0, middle.0 - 0.055, middle.1),
    );
}

/// A screen to touch on a bent arm, with a small one behind it for the buyer, a printer beside, over a drawer of sheet.
fn screen_on_arm(builder: &mut Builder) {
    let bay = builder.bay();
    let (high, depth) = (bay.height(), bay.depth());
    let drawer = drawer(builder, Slot::MetalDark, Slot::MetalDark, 0.26);
    let lock = turned_forward(cylinder(0.014, [-0.006, 0.002], 10));
    builder.add(Slot::Chrome, lock.moved(0.0, drawer * 0.55, bay.high.z));
    let (x, z) = (-bay.width() * 0.14, bay.low.z + depth * 0.34);
    builder.add(Slot::Metal, cylinder(0.07, [drawer - SINK, drawer + 0.012], 14).moved(x, 0.0, z));
    let arm = [DVec3::new(x, drawer, z), DVec3::new(x, high * 0.5, z), DVec3::new(x, high * 0.72, z + 0.06)];
    builder.add(Slot::Metal, sweep(&arm, 0.018, 8));
    let tilt = 0.5;
    let width = bay.width() * 0.66;
    let tall = (high - drawer) * 0.62;
    let slab = cuboid(Bay::new([-width / 2.0, width / 2.0], [-tall / 2.0, tall / 2.0], [0.0, 0.022]));
    let glass = cuboid(Bay::new([-width * 0.47, width * 0.47], [-tall * 0.45, tall * 0.45], [0.02, 0.0235]));
    let middle = DVec3::new(x, high - tall * 0.46, z + 0.06);
    for (slot, solid) in [(Slot::PlasticDark, slab), (Slot::Screen, glass)] {
        builder.add(slot, solid.turned_x(-tilt).moved(middle.x, middle.y, middle.z));
    }
    let own = Bay::new([x - 0.07, x + 0.07], [high * 0.62, high * 0.84], [z - 0.045, z - 0.025]);
    builder.block(Slot::PlasticDark, own, 0.004);
    builder.cuboid(Slot::Screen, own.inset(0.008, 0.01, 0.0).with_z([own.low.z - 0.002, own.low.z + SINK]));
    builder.cuboid(
        Slot::Metal,
        Bay::new([x - 0.012, x + 0.012], [high * 0.66, high * 0.7], [z - 0.03, z + 0.03]),
    );
    let printer = Bay::new(
        [bay.high.x - 0.13, bay.high.x - 0.012],
        [drawer - SINK, high * 0.66],
        [bay.center().z - 0.06, bay.center().z + 0.1],
    );
    builder.block(Slot::Plastic, printer, 0.012);
    let slip = Bay::around(printer.center(), 0.07, 0.0, 0.001)
        .with_y([printer.high.y - 0.01, printer.high.y + 0.05]);
    builder.cuboid(Slot::Paper, slip.moved(0.0, 0.0, 0.03));
}

/// A rounded box with keys, a roll of paper behind a bow and a display that stands up at the back.
fn portable(builder: &mut Builder) {
    let bay = builder.bay();
    let (high, depth) = (bay.height(), bay.depth());
    let drawer = drawer(builder, Slot::PlasticDark, Slot::Plastic, 0.22);
    let x = bay.width() * 0.36;
    let (back, front) = (bay.low.z + depth * 0.16, bay.high.z - depth * 0.2);
    let top = high * 0.5;
    let profile = [
        (front, drawer - SINK),
        (front + 0.02, drawer + 0.02),
        (front, drawer + 0.045),
        (back + 0.1, top),
        (back + 0.04, top + 0.03),
        (back, top),
        (back, drawer - SINK),
    ];
    builder.add(Slot::Plastic, extrude(&profile.map(DVec2::from), Axis::X, [-x, x]));
    let along =
        |share: f64| (back + 0.1 + (front - back - 0.1) * share, top + (drawer + 0.045 - top) * share);
    keys(builder, Slot::PaintedAccent, 0.008, [along(0.98), along(0.12)], x * 0.84);
    let roll = (top + 0.045, back + 0.05);
    builder.add(Slot::Paper, across(0.036, [-x * 0.8, -x * 0.1], 12).moved(0.0, roll.0, roll.1));
    for side in [-x * 0.86, -x * 0.04] {
        builder.cuboid(
            Slot::PlasticDark,
            Bay::around(DVec3::new(side, roll.0 - 0.01, roll.1), 0.012, 0.06, 0.04),
        );
    }
    let slip =
        Bay::new([-x * 0.74, -x * 0.16], [roll.0 - 0.02, roll.0 + 0.08], [roll.1 + 0.034, roll.1 + 0.0355]);
    builder.cuboid(Slot::Paper, slip);
    let post = cylinder(0.014, [top - 0.02, high * 0.82], 8);
    builder.add(Slot::PlasticDark, post.moved(x * 0.5, 0.0, back + 0.03));
    let panel = Bay::new([x * 0.04, x * 0.98], [high * 0.78, high], [back + 0.01, back + 0.05]);
    display(builder, panel, Shell { slot: Slot::PlasticDark, border: 0.01 });
}
