//! Fire extinguishers: 6 kg of powder 0.16 m thick and 0.50 to 0.55 high, 5 kg of CO2 0.14 thick with a horn of 0.3
//! (EN 3).

use glam::{DVec2, DVec3};

use super::parts::turned_forward;
use crate::geometry::Side;
use crate::recipes::kit::{
    Axis, Bay, Builder, Outline, SINK, Slice, cylinder, extrude, lathe, loft_ring, sweep,
};
use crate::recipes::{Recipe, Slot};

/// Corners of a bottle.
const SIDES: usize = 10;
/// What the bottle is painted with: red (ISO 3864).
const RED: Slot = Slot::Book;

/// A fire extinguisher on a wall: powder with gauge and hose; a cone of copper; CO2 with a horn; a small bottle
/// strapped to a plate under its sign.
pub(super) static FIRE_EXTINGUISHER: Recipe = Recipe::accessory("fire_extinguisher", [0.18, 0.16, 0.55])
    .plain(|_, builder| powder(builder))
    .traditional(|draft, builder| cone(builder, draft.input.look as usize % 2))
    .industrial(|_, builder| carbon_dioxide(builder))
    .budget(|_, builder| plate(builder));

/// A body through (share of the radius, share of the height) around an upright axis.
fn turned(profile: &[(f64, f64)], radius: f64, height: f64, z: f64) -> crate::recipes::kit::Solid {
    let profile: Vec<(f64, f64)> =
        profile.iter().map(|&(wide, rise)| (wide * radius, rise * height)).collect();
    lathe(&profile, SIDES).moved(0.0, 0.0, z)
}

/// The lever and the fixed grip below it, to the right of a valve.
fn grips(builder: &mut Builder, middle: DVec3, length: f64, rise: f64, slot: Slot) {
    let lower =
        Bay::new([middle.x - 0.012, middle.x + length], [middle.y, middle.y + rise * 0.2], [0.0, 0.0]);
    let half = 0.009;
    builder.cuboid(slot, lower.with_z([middle.z - half, middle.z + half]));
    // The lever turns about the end of the grip.
    let tail = (middle.x - 0.011, middle.y + rise * 0.1);
    let lever = [
        tail,
        (middle.x + length * 0.9, middle.y + rise * 0.84),
        (middle.x + length * 0.9, middle.y + rise),
        (tail.0, middle.y + rise * 0.5),
    ];
    builder
        .add(slot, extrude(&lever.map(DVec2::from), Axis::Z, [middle.z - half * 1.1, middle.z + half * 1.1]));
}

/// A bracket between the wall and a bottle.
fn bracket(builder: &mut Builder, radius: f64, z: f64, y: [f64; 2]) {
    let back = builder.bay().low.z;
    builder.cuboid(Slot::MetalDark, Bay::new([-radius * 0.45, radius * 0.45], y, [back, z - radius * 0.6]));
}

/// Powder under pressure: a domed bottle on a black foot, a gauge before the valve, a hose clipped to the left.
fn powder(builder: &mut Builder) {
    let bay = builder.bay();
    let height = bay.height();
    let radius = (bay.width() * 0.41).min(bay.depth() * 0.46);
    let z = bay.high.z - radius;
    let body = [(0.98, 0.045), (1.0, 0.06), (1.0, 0.68), (0.84, 0.77), (0.3, 0.83)];
    builder.add(RED, turned(&body, radius, height, z));
    builder.add(Slot::PlasticDark, turned(&[(0.93, 0.0), (0.96, 0.06)], radius, height, z));
    builder.add(Slot::Paper, turned(&[(1.012, 0.34), (1.012, 0.56)], radius, height, z));
    let head = DVec3::new(0.0, height * 0.855, z);
    builder.cuboid(Slot::Metal, Bay::around(head, radius * 0.5, height * 0.084, radius * 0.5));
    grips(builder, DVec3::new(0.0, height * 0.895, z), bay.high.x, height * 0.105, Slot::PlasticDark);
    let gauge = turned_forward(cylinder(radius * 0.2, [radius * 0.2, radius * 0.36], 6));
    builder.add(Slot::Painted, gauge.moved(0.0, head.y, z));
    let hose_radius = radius * 0.11;
    let left = bay.low.x + hose_radius * 1.3;
    let at = |x: f64, share: f64| DVec3::new(x, height * share, z);
    let hose = [at(-radius * 0.1, 0.86), at(left * 0.86, 0.83), at(left, 0.7), at(left, 0.3)];
    builder.add(Slot::Rubber, sweep(&hose, hose_radius, 5));
    let nozzle = lathe(&[(hose_radius * 1.3, height * 0.12), (hose_radius * 0.9, height * 0.31)], 6);
    builder.add(Slot::PlasticDark, nozzle.moved(left, 0.0, z));
    bracket(builder, radius, z, [height * 0.6, height * 0.66]);
}

/// A pointed cone of sheet with a cap, a spout and a ring to carry it by, as from 1920 on (Minimax).
fn cone(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let height = bay.height();
    let radius = (bay.width() * 0.5).min(bay.depth() * 0.47);
    let z = bay.high.z - radius;
    let slot = [Slot::Brass, RED][look];
    let body = [(0.96, 0.0), (1.0, 0.02), (1.0, 0.07), (0.94, 0.085), (0.3, 0.87)];
    builder.add(slot, turned(&body, radius, height, z));
    let cap = [(0.36, 0.865), (0.36, 0.89), (0.14, 0.92), (0.2, 0.97), (0.1, 1.0)];
    builder.add(Slot::Brass, turned(&cap, radius, height, z));
    builder.add([Slot::Paper, Slot::Brass][look], turned(&[(0.777, 0.3), (0.679, 0.42)], radius, height, z));
    let spout = [DVec3::new(radius * 0.3, height * 0.78, z), DVec3::new(bay.high.x * 0.99, height * 0.86, z)];
    builder.add(Slot::Brass, sweep(&spout, radius * 0.07, 5));
    let at = |out: f64, share: f64| DVec3::new(-out, height * share, z);
    let reach = bay.high.x - radius * 0.07;
    let ring = [at(radius * 0.6, 0.42), at(reach, 0.46), at(reach, 0.6), at(radius * 0.42, 0.68)];
    builder.add(Slot::MetalDark, sweep(&ring, radius * 0.06, 4));
    bracket(builder, radius, z, [height * 0.32, height * 0.36]);
    let hook = Bay::new(
        [-radius * 0.1, radius * 0.1],
        [height * 0.72, height * 0.76],
        [bay.low.z, z - radius * 0.2],
    );
    builder.cuboid(Slot::MetalDark, hook);
}

/// A slim bottle of steel with a round shoulder and a black horn on a bent pipe, which hangs down at the left.
fn carbon_dioxide(builder: &mut Builder) {
    let bay = builder.bay();
    let height = bay.height();
    let radius = (bay.width() * 0.33).min(bay.depth() * 0.4);
    let z = bay.high.z - radius * 1.1;
    let body = [(0.97, 0.0), (1.0, 0.02), (1.0, 0.62), (0.84, 0.72), (0.28, 0.8)];
    let middle = bay.high.x - radius * 1.2;
    builder.add(RED, turned(&body, radius, height, z).moved(middle, 0.0, 0.0));
    let label = turned(&[(1.012, 0.36), (1.012, 0.54)], radius, height, z);
    builder.add(Slot::Paper, label.moved(middle, 0.0, 0.0));
    let valve =
        [(radius * 0.24, height * 0.79), (radius * 0.32, height * 0.83), (radius * 0.2, height * 0.89)];
    builder.add(Slot::Brass, lathe(&valve, 6).moved(middle, 0.0, z));
    grips(builder, DVec3::new(middle, height * 0.885, z), radius * 1.2, height * 0.115, Slot::Metal);
    let out = bay.low.x + radius * 0.6;
    let at = |x: f64, share: f64| DVec3::new(x, height * share, z);
    let pipe = [at(middle, 0.845), at(out + 0.012, 0.845), at(out, 0.82), at(out, 0.6)];
    builder.add(Slot::Rubber, sweep(&pipe, radius * 0.13, 5));
    let horn = [(radius * 0.6, height * 0.2), (radius * 0.4, height * 0.44), (radius * 0.16, height * 0.66)];
    builder.add(Slot::PlasticDark, lathe(&horn, 7).moved(out, 0.0, z));
    let back = Bay::new(
        [middle - radius * 0.5, middle + radius * 0.5],
        [height * 0.5, height * 0.56],
        [bay.low.z, z],
    );
    builder.cuboid(Slot::Metal, back.without(Side::Front, radius * 0.5));
}

/// A small bottle held by a strap to a plate of plastic, under a sign with a flame.
fn plate(builder: &mut Builder) {
    let bay = builder.bay();
    let height = bay.height();
    let radius = (bay.width() * 0.31).min(bay.depth() * 0.4);
    let z = bay.high.z - radius;
    let board = bay.slab(Side::Back, (bay.depth() * 0.1).min(0.014));
    builder.cuboid(Slot::Plastic, board);
    let sign = board.slab(Side::Above, height * 0.24).inset(bay.width() * 0.08, height * 0.02, 0.0);
    let red = sign.with_z([board.high.z - SINK, board.high.z + 0.003]);
    builder.cuboid(RED, red);
    let (middle, size) = (red.center(), red.height());
    let flame =
        [(0.0, 0.42), (-0.12, 0.1), (-0.26, 0.16), (-0.24, -0.24), (0.0, -0.38), (0.24, -0.24), (0.2, 0.08)];
    let flame = flame.map(|(x, y)| DVec2::new(middle.x + x * size, middle.y + y * size));
    builder.add(Slot::Paper, extrude(&flame, Axis::Z, [red.high.z - SINK, red.high.z + 0.002]));
    let body = [(0.92, 0.0), (1.0, 0.03), (1.0, 0.46), (0.8, 0.53), (0.26, 0.57)];
    builder.add(RED, turned(&body, radius, height, z));
    let strap = |y: f64, share: f64| Slice::round(y, radius * share);
    let strap = [
        strap(height * 0.24, 1.05),
        strap(height * 0.29, 1.05),
        strap(height * 0.29, 0.9),
        strap(height * 0.24, 0.9),
    ];
    builder.add(Slot::PlasticDark, loft_ring(&Outline::Round(SIDES), &strap).moved(0.0, 0.0, z));
    let arm = Bay::new(
        [-radius * 0.3, radius * 0.3],
        [height * 0.245, height * 0.285],
        [board.high.z - SINK, z - radius * 0.9],
    );
    builder.cuboid(Slot::PlasticDark, arm);
    builder.cuboid(
        Slot::PlasticDark,
        Bay::around(DVec3::new(0.0, height * 0.595, z), radius * 0.5, height * 0.074, radius * 0.5),
    );
    grips(builder, DVec3::new(0.0, height * 0.63, z), radius * 1.1, height * 0.09, Slot::PlasticDark);
    let nozzle = [DVec3::new(0.0, height * 0.6, z), DVec3::new(-radius * 0.95, height * 0.58, z)];
    builder.add(Slot::PlasticDark, sweep(&nozzle, radius * 0.13, 5));
}
