//! Cars: 4.2 to 4.8 m long, 1.75 to 1.85 wide, 1.45 to 1.5 high, wheels 0.6 to 0.7 across. The front looks where one uses a
//! class from.

use std::f64::consts::PI;

use glam::{DVec2, DVec3};

use super::parts::{across, ball, turned_forward};
use crate::geometry::Side;
use crate::recipes::kit::{Axis, Bay, Builder, Outline, SINK, Slice, cylinder, extrude, loft, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// A car: round as they are today; with mudguards and running boards; with an open bed behind the cab; a small one with an
/// upright tail.
pub(super) static CAR: Recipe = Recipe::furniture("car", [1.8, 4.5, 1.48]).every_set(car);

fn car(draft: &Draft, builder: &mut Builder) {
    let paint = draft.sampler().pick(&[Slot::PaintedAccent, Slot::Metal, Slot::MetalDark, Slot::Painted]);
    match draft.set() {
        GeometrySet::Plain => saloon(builder, paint),
        GeometrySet::Traditional => {
            oldtimer(builder, [paint, Slot::Book, Slot::Leaf, Slot::Painted][draft.form()])
        }
        GeometrySet::Industrial => pick_up(builder, paint),
        GeometrySet::Budget => hatchback(builder, paint),
    }
}

/// The middle of a wheel.
struct Hub {
    slot: Slot,
    /// Share of the wheel's radius.
    share: f64,
}

/// Four wheels of a radius and a width on two axles.
fn wheels(builder: &mut Builder, radius: f64, broad: f64, axles: [f64; 2], hub: Hub) {
    let right = builder.bay().high.x - 0.005;
    for z in axles {
        builder.add_pair(Slot::Rubber, across(radius, [right - broad, right], 14).moved(0.0, radius, z));
        let cap = across(radius * hub.share, [right - broad - 0.005, right + 0.005], 12);
        builder.add_pair(hub.slot, cap.moved(0.0, radius, z));
    }
}

/// Where the axles are, by shares of the length from both ends.
fn axles(bay: Bay, [back, front]: [f64; 2]) -> [f64; 2] {
    [bay.low.z + bay.depth() * back, bay.high.z - bay.depth() * front]
}

/// Glass all round on a foot, narrower at the roof, which lies on it.
fn cabin(builder: &mut Builder, paint: Slot, foot: Bay, roof: Bay) {
    let slice = |bay: Bay, y: f64| {
        let middle = bay.center();
        Slice::new(y, bay.width() / 2.0, bay.depth() / 2.0).at(middle.x, middle.z).softened(0.08)
    };
    let glass = [slice(foot, foot.low.y), slice(roof, roof.low.y + SINK)];
    builder.add(Slot::Screen, loft(&Outline::Soft(2), &glass));
    let lid =
        [slice(roof.inset(-0.012, 0.0, -0.012), roof.low.y), slice(roof.inset(0.05, 0.0, 0.08), roof.high.y)];
    builder.add(paint, loft(&Outline::Soft(2), &lid));
    // Posts between the doors.
    for share in [0.36, 0.62] {
        let at = |bay: Bay, y: f64| DVec3::new(bay.high.x - 0.012, y, bay.low.z + share * bay.depth());
        let post = [at(foot, foot.low.y), at(roof, roof.low.y + SINK)];
        builder.add_pair(paint, sweep(&post, 0.03, 4));
    }
}

/// Lamps at both ends of a body.
fn lamps(builder: &mut Builder, body: Bay, y: [f64; 2]) {
    for side in [Side::Left, Side::Right] {
        let corner = body.inset(body.width() * 0.05, 0.0, 0.0).slab(side, body.width() * 0.18).with_y(y);
        builder.cuboid(Slot::Lamp, corner.slab(Side::Front, 0.06).moved(0.0, 0.0, 0.004));
        builder.cuboid(Slot::Book, corner.slab(Side::Back, 0.06).moved(0.0, 0.0, -0.004));
    }
}

fn saloon(builder: &mut Builder, paint: Slot) {
    let bay = builder.bay();
    let (width, high, depth) = (bay.width(), bay.high.y, bay.depth());
    let wheel = high * 0.22;
    let body = bay.with_y([wheel * 0.7, high * 0.62]).inset(0.03, 0.0, 0.0);
    builder.rounded(paint, body, DVec3::new(0.12, 0.12, 0.25), 3);
    let cabin = bay.with_y([high * 0.5, high]).inset(width * 0.1, 0.0, 0.0);
    let cabin = cabin.with_z([bay.low.z + depth * 0.14, bay.high.z - depth * 0.34]);
    builder.rounded(Slot::Screen, cabin.without(Side::Above, 0.03), DVec3::new(0.12, 0.25, 0.5), 3);
    let roof = cabin.slab(Side::Above, 0.09).inset(width * 0.03, 0.0, depth * 0.09);
    builder.rounded(paint, roof, DVec3::new(0.1, 0.04, 0.2), 3);
    wheels(builder, wheel, 0.215, axles(bay, [0.19, 0.19]), Hub { slot: Slot::Chrome, share: 0.55 });
    for side in [Side::Left, Side::Right] {
        let corner = body.inset(width * 0.08, 0.0, 0.0).slab(side, width * 0.2);
        let lamp = corner.with_y([high * 0.42, high * 0.5]);
        builder.cuboid(Slot::Lamp, lamp.slab(Side::Front, 0.06).moved(0.0, 0.0, -0.004));
        builder.cuboid(Slot::Book, lamp.slab(Side::Back, 0.06).moved(0.0, 0.0, 0.004));
    }
}

/// A narrow body with an upright grille between arched mudguards, with running boards and round lamps.
fn oldtimer(builder: &mut Builder, paint: Slot) {
    let bay = builder.bay();
    let (half, high, depth) = (bay.high.x, bay.high.y, bay.depth());
    let wheel = high * 0.24;
    let axles = axles(bay, [0.2, 0.17]);
    let at = |z: f64, y: f64| DVec2::new(bay.low.z + z * depth, y * high);
    let side = [
        at(0.1, 0.2),
        at(0.93, 0.2),
        at(0.94, 0.6),
        at(0.6, 0.66),
        at(0.58, 0.68),
        at(0.14, 0.68),
        at(0.06, 0.5),
        at(0.04, 0.3),
    ];
    builder.add(paint, extrude(&side, Axis::X, [-half * 0.6, half * 0.6]));
    let foot = bay
        .with_y([high * 0.67, high])
        .inset(half * 0.42, 0.0, 0.0)
        .with_z([at(0.13, 0.0).x, at(0.58, 0.0).x]);
    let roof = foot
        .with_y([high * 0.93, high])
        .inset(0.05, 0.0, 0.0)
        .without(Side::Back, 0.1)
        .without(Side::Front, 0.06);
    cabin(builder, paint, foot, roof);
    for z in axles {
        let ring = |radius: f64, step: i32| {
            let (sine, cosine) = libm::sincos(PI * (0.02 + 0.96 * f64::from(step) / 8.0));
            DVec2::new(z + cosine * radius, wheel + sine * radius)
        };
        let mut guard: Vec<DVec2> = (0..=8).map(|step| ring(wheel * 1.32, step)).collect();
        guard.extend((0..=8).rev().map(|step| ring(wheel * 1.16, step)));
        builder.add_pair(paint, extrude(&guard, Axis::X, [half * 0.58, half]));
    }
    let board = Bay::new(
        [half * 0.58, half - 0.02],
        [wheel * 0.9, wheel * 1.05],
        [axles[0] + wheel * 1.2, axles[1] - wheel * 1.2],
    );
    for ends in [board.x(), [-board.high.x, -board.low.x]] {
        builder.block(Slot::Rubber, board.with_x(ends), 0.01);
    }
    wheels(builder, wheel, 0.16, axles, Hub { slot: Slot::Chrome, share: 0.6 });
    face(builder, at(0.94, 0.0).x);
    spare_wheel(builder, wheel * 0.9);
}

/// An upright grille between round lamps, and bumpers on stays at both ends.
fn face(builder: &mut Builder, front: f64) {
    let bay = builder.bay();
    let (half, high) = (bay.high.x, bay.high.y);
    let grille =
        Bay::new([-half * 0.3, half * 0.3], [high * 0.24, high * 0.64], [front - 0.06, front + 0.04]);
    builder.block(Slot::Chrome, grille, 0.03);
    for bar in grille.inset(0.03, 0.04, 0.0).columns(7, 0.02) {
        builder.cuboid(Slot::MetalDark, bar.with_z([grille.high.z - SINK, grille.high.z + 0.006]));
    }
    let lamp = turned_forward(cylinder(0.09, [-0.1, 0.06], 12));
    builder.add_pair(Slot::Chrome, lamp.moved(half * 0.46, high * 0.56, front));
    builder.add_pair(Slot::Lamp, ball(0.082, 10).moved(half * 0.46, high * 0.56, front + 0.02));
    for (z, y) in [(bay.low.z, 0.24), (bay.high.z - 0.05, 0.24)] {
        let bumper = Bay::new([-half * 0.96, half * 0.96], [high * y, high * (y + 0.05)], [z, z + 0.05]);
        builder.block(Slot::Chrome, bumper, 0.015);
        let stay = bumper.inset(0.0, 0.01, 0.0).with_z(if z < 0.0 {
            [z + 0.04, z + 0.3]
        } else {
            [z - 0.25, z + 0.01]
        });
        builder.cuboid(Slot::MetalDark, stay.with_x([half * 0.32, half * 0.38]));
        builder.cuboid(Slot::MetalDark, stay.with_x([-half * 0.38, -half * 0.32]));
    }
}

/// A wheel on the tail, between two round lamps.
fn spare_wheel(builder: &mut Builder, radius: f64) {
    let bay = builder.bay();
    let (half, high, depth) = (bay.high.x, bay.high.y, bay.depth());
    let spare = turned_forward(cylinder(radius, [0.0, 0.15], 14));
    builder.add(Slot::Rubber, spare.moved(0.0, high * 0.46, bay.low.z + 0.06));
    builder.add(Slot::Book, ball(0.05, 8).moved(half * 0.66, high * 0.4, bay.low.z + depth * 0.05));
    builder.add(Slot::Book, ball(0.05, 8).moved(-half * 0.66, high * 0.4, bay.low.z + depth * 0.05));
}

/// A cab and an open bed on large wheels, with bumpers of steel and a bow behind the cab.
fn pick_up(builder: &mut Builder, paint: Slot) {
    let bay = builder.bay();
    let (high, depth) = (bay.high.y, bay.depth());
    let wheel = high * 0.26;
    let waist = high * 0.64;
    let body = bay.inset(0.06, 0.0, 0.1).with_y([wheel * 0.8, waist]);
    let z = |share: f64| bay.low.z + share * depth;
    let front = body.with_z([z(0.4), body.high.z]);
    builder.rounded(paint, front, DVec3::new(0.05, 0.06, 0.1), 2);
    let bed = body.with_z([body.low.z, z(0.4) - 0.02]);
    open_bed(builder, paint, bed);
    let foot = front.with_y([waist - 0.02, high]).inset(0.05, 0.0, 0.0).with_z([z(0.41), z(0.74)]);
    let roof = foot
        .with_y([high * 0.94, high])
        .inset(0.07, 0.0, 0.0)
        .without(Side::Front, 0.3)
        .without(Side::Back, 0.03);
    cabin(builder, paint, foot, roof);
    wheels(builder, wheel, 0.25, axles(bay, [0.21, 0.19]), Hub { slot: Slot::MetalDark, share: 0.6 });
    for share in [0.21, 0.81] {
        let arch = across(wheel * 1.18, [body.high.x - 0.18, body.high.x + 0.02], 14);
        builder.add_pair(Slot::PlasticDark, arch.moved(0.0, wheel * 1.05, z(share)));
    }
    for side in [Side::Front, Side::Back] {
        let bumper = bay.slab(side, 0.12).with_y([wheel * 0.9, wheel * 1.5]).inset(0.08, 0.0, 0.0);
        builder.block(Slot::MetalDark, bumper, 0.02);
    }
    let face = front
        .slab(Side::Front, 0.004)
        .inset(front.width() * 0.24, 0.0, 0.0)
        .with_y([waist * 0.66, waist * 0.9]);
    for bar in face.rows(4, 0.02) {
        builder.cuboid(Slot::MetalDark, bar.moved(0.0, 0.0, 0.002));
    }
    lamps(builder, body, [waist * 0.68, waist * 0.9]);
    let x = body.high.x - 0.1;
    let bow = [(-x, waist - 0.05), (-x * 0.86, high * 0.93), (x * 0.86, high * 0.93), (x, waist - 0.05)];
    let bow = bow.map(|(x, y)| DVec3::new(x, y, bed.high.z - 0.1));
    builder.add(Slot::Chrome, sweep(&bow, 0.03, 8));
}

/// A bed open to the sky, lined with rubber.
fn open_bed(builder: &mut Builder, paint: Slot, bed: Bay) {
    builder.cuboid(
        paint,
        bed.slab(Side::Below, bed.height() * 0.55).inset(0.004, 0.0, 0.004).moved(0.0, 0.006, 0.0),
    );
    for side in [Side::Left, Side::Right] {
        builder.block(paint, bed.slab(side, 0.07), 0.012);
    }
    for side in [Side::Front, Side::Back] {
        builder.block(
            paint,
            bed.slab(side, 0.06).inset(0.068, 0.003, 0.002).without(Side::Above, 0.003),
            0.01,
        );
    }
    builder.cuboid(
        Slot::Rubber,
        bed.inset(0.069, 0.0, 0.059)
            .with_y([bed.low.y + bed.height() * 0.5, bed.low.y + bed.height() * 0.57]),
    );
}

/// A body in one sweep with a short bonnet and an upright tail, on small wheels; plain bumpers, a rack on the roof.
fn hatchback(builder: &mut Builder, paint: Slot) {
    let bay = builder.bay();
    let (half, high, depth) = (bay.high.x - 0.02, bay.high.y, bay.depth());
    let wheel = high * 0.2;
    let at = |z: f64, y: f64| DVec2::new(bay.low.z + z * depth, y * high);
    let side = [
        at(0.012, 0.14),
        at(0.988, 0.14),
        at(1.0, 0.3),
        at(0.985, 0.48),
        at(0.94, 0.54),
        at(0.76, 0.62),
        at(0.02, 0.62),
        at(0.0, 0.5),
    ];
    builder.add(paint, extrude(&side, Axis::X, [-half, half]));
    let foot =
        bay.with_y([high * 0.61, high]).inset(0.07, 0.0, 0.0).with_z([at(0.02, 0.0).x, at(0.77, 0.0).x]);
    let roof = foot
        .with_y([high * 0.9, high * 0.97])
        .inset(0.08, 0.0, 0.0)
        .without(Side::Front, depth * 0.15)
        .without(Side::Back, 0.1);
    cabin(builder, paint, foot, roof);
    wheels(builder, wheel, 0.19, axles(bay, [0.17, 0.17]), Hub { slot: Slot::Plastic, share: 0.66 });
    for side in [Side::Left, Side::Right] {
        let strip = bay.slab(side, 0.022).with_z([at(0.28, 0.0).x, at(0.72, 0.0).x]);
        builder.cuboid(Slot::PlasticDark, strip.with_y([high * 0.36, high * 0.4]));
        let handle = bay.slab(side, 0.03).with_z([at(0.44, 0.0).x, at(0.49, 0.0).x]);
        builder.cuboid(Slot::PlasticDark, handle.with_y([high * 0.52, high * 0.54]));
        let rail = roof.slab(side, 0.03).with_y([high * 0.985, high]).inset(0.0, 0.0, 0.2);
        builder.cuboid(Slot::MetalDark, rail.moved(if side == Side::Left { 0.1 } else { -0.1 }, 0.0, 0.0));
    }
    for share in [0.3, 0.7] {
        let bar = roof.inset(0.08, 0.0, 0.0).with_y([high * 0.94, high * 0.99]);
        let z = roof.low.z + share * roof.depth();
        builder.cuboid(Slot::MetalDark, bar.with_z([z - 0.02, z + 0.02]));
    }
    for side in [Side::Front, Side::Back] {
        let bumper = bay.slab(side, 0.1).with_y([high * 0.2, high * 0.32]).inset(0.008, 0.0, 0.0);
        builder.block(Slot::PlasticDark, bumper, 0.025);
    }
    let body = bay.with_z([at(0.004, 0.0).x, at(0.985, 0.0).x]).inset(0.04, 0.0, 0.0);
    lamps(builder, body, [high * 0.36, high * 0.48]);
}
