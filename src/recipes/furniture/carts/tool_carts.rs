//! Carts for tools that are no chests of drawers of steel.

use glam::DVec3;

use super::{castor, castors};
use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::furniture::parts::{ball, turned_forward, turned_sideways};
use crate::recipes::kit::{Bay, Builder, SINK, cylinder, pipe, sweep};

/// Three trays of steel with rims between posts, a drawer under the upper one, a bow to push; boxes and tools on them.
pub(super) fn open_cart(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let slot = [Slot::PaintedAccent, Slot::MetalDark, Slot::Metal, Slot::Book][look];
    let lift = 0.13;
    let bow = 0.08;
    let frame = bay.without(Side::Right, bow);
    castors(builder, frame.inset(0.02, 0.0, 0.02), lift);
    for x in [Side::Left, Side::Right] {
        for z in [Side::Front, Side::Back] {
            let post = frame.slab(x, 0.03).slab(z, 0.03).with_y([lift - 0.02, bay.high.y * 0.94]);
            builder.cuboid(Slot::MetalDark, post.inset(0.0012, 0.0, 0.0012));
        }
    }
    for (index, share) in [0.18, 0.5, 0.84].into_iter().enumerate() {
        let y = bay.high.y * share;
        let by = 0.0004 * index as f64;
        let tray = frame.inset(by, 0.0, by).with_y([y - 0.012, y]);
        builder.cuboid(slot, tray);
        let rim = tray.with_y([y - 0.011, y + 0.05]);
        for side in [Side::Front, Side::Back] {
            builder.cuboid(slot, rim.slab(side, 0.006).without(side, -0.0005).inset(-0.0002, 0.0, 0.0));
        }
        for side in [Side::Left, Side::Right] {
            builder.cuboid(slot, rim.slab(side, 0.006).without(side, -0.0003).inset(0.0, 0.001, 0.005));
        }
        load(builder, tray.with_y([y - SINK, y + 0.2]), index);
    }
    let drawer = frame.inset(0.034, 0.0, 0.0).with_y([bay.high.y * 0.84 - 0.11, bay.high.y * 0.84 - 0.014]);
    builder.cuboid(slot, drawer.without(Side::Front, 0.01).without(Side::Back, 0.02));
    let grip = drawer.slab(Side::Front, 0.011).inset(0.12, 0.036, 0.0);
    builder.cuboid(Slot::Metal, grip.without(Side::Front, 0.001));
    let (y, x) = (bay.high.y - 0.014, bay.high.x - 0.014);
    let at = |x: f64, y: f64, z: f64| DVec3::new(x, y, z);
    let (near, far) = (frame.high.z - 0.015, frame.low.z + 0.015);
    let path = [
        at(frame.high.x - 0.02, bay.high.y * 0.7, near),
        at(x, y, near),
        at(x, y, far),
        at(frame.high.x - 0.02, bay.high.y * 0.7, far),
    ];
    builder.add(Slot::Metal, pipe(&path, 0.0135, 0.05));
}

/// What lies on a tray: a case and a can below, boxes of parts in the middle, wrenches above.
fn load(builder: &mut Builder, tray: Bay, level: usize) {
    let (middle, y) = (tray.center(), tray.low.y);
    match level {
        0 => {
            let case = Bay::around(DVec3::new(middle.x - 0.08, y + 0.08, middle.z), 0.34, 0.16, 0.2);
            builder.block(Slot::Book, case, 0.012);
            let handle = case.slab(Side::Above, 0.02).inset(0.1, 0.0, 0.085).moved(0.0, 0.019, 0.0);
            builder.cuboid(Slot::MetalDark, handle);
            let can = cylinder(0.06, [y, y + 0.2], 10);
            builder.add(Slot::Metal, can.moved(middle.x + 0.2, 0.0, middle.z));
        }
        1 => {
            let row = tray.inset(0.05, 0.0, 0.1).with_y([y, y + 0.1]);
            for (index, bin) in row.columns(4, 0.015).into_iter().enumerate() {
                builder.block([Slot::Leaf, Slot::Book, Slot::Brass, Slot::PaintedAccent][index], bin, 0.006);
                builder.cuboid(
                    Slot::MetalDark,
                    bin.inset(0.012, 0.0, 0.014).with_y([bin.high.y - 0.004, bin.high.y + 0.001]),
                );
            }
        }
        _ => {
            for (index, z) in [-0.1, -0.04, 0.03].into_iter().enumerate() {
                let length = 0.3 - 0.05 * index as f64;
                let shank =
                    Bay::around(DVec3::new(middle.x - 0.06, y + 0.006, middle.z + z), length, 0.008, 0.018);
                builder.cuboid(Slot::Chrome, shank);
                for end in [shank.low.x, shank.high.x] {
                    let ring = cylinder(0.02, [y, y + 0.0125], 8);
                    builder.add(Slot::Chrome, ring.moved(end, 0.0, middle.z + z));
                }
            }
            let driver = turned_sideways(cylinder(0.014, [0.0, 0.1], 6));
            builder.add(Slot::Book, driver.moved(middle.x + 0.1, y + 0.012, middle.z + 0.1));
            let blade = turned_sideways(cylinder(0.005, [-0.12, 0.01], 6));
            builder.add(Slot::Chrome, blade.moved(middle.x + 0.1, y + 0.012, middle.z + 0.1));
        }
    }
}

/// A machinist's chest of wood with an open lid and many flat drawers on a cabinet with two doors.
pub(super) fn wooden_chest(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let slot = [Slot::Wood, Slot::WoodDark, Slot::Wood, Slot::WoodDark][look];
    let (lift, height) = (0.1, bay.height());
    let middle = height * 0.52;
    castors(builder, bay.inset(0.03, 0.0, 0.03), lift);
    let lower = bay
        .with_y([lift - SINK, middle])
        .without(Side::Front, 0.03)
        .without(Side::Back, 0.002)
        .inset(0.004, 0.0, 0.0);
    builder.block(slot, lower, 0.006);
    builder.block(slot, bay.with_y([lift - 0.001, lift + 0.05]).without(Side::Front, 0.012), 0.008);
    builder.block(
        slot,
        bay.with_y([middle - 0.015, middle + 0.012]).without(Side::Front, 0.006).without(Side::Back, 0.001),
        0.006,
    );
    let face = lower.with_y([lift + 0.06, middle - 0.025]).inset(0.016, 0.0, 0.0);
    for (index, door) in face.columns(2, 0.006).into_iter().enumerate() {
        let z = [lower.high.z - SINK, lower.high.z + 0.012];
        builder.cuboid(slot, door.with_z(z));
        builder.block(
            Slot::WoodLight,
            door.inset(0.05, 0.05, 0.0).with_z([z[1] - SINK, z[1] + 0.006]),
            0.005,
        );
        let x = if index == 0 { door.high.x - 0.025 } else { door.low.x + 0.025 };
        let knob = turned_forward(cylinder(0.009, [0.0, 0.016], 8));
        builder.add(Slot::Brass, knob.moved(x, door.center().y, z[1] - SINK));
    }
    let upper = bay
        .with_y([middle + 0.012 - SINK, height * 0.86])
        .inset(0.04, 0.0, 0.0)
        .without(Side::Front, 0.05)
        .without(Side::Back, 0.03);
    builder.block(slot, upper, 0.006);
    flat_drawers(builder, upper);
    open_lid(builder, slot, upper);
}

/// Many flat drawers with pulls of brass.
fn flat_drawers(builder: &mut Builder, upper: Bay) {
    let rows = upper.inset(0.018, 0.016, 0.0).rows(5, 0.006);
    for (index, row) in rows.into_iter().enumerate() {
        for drawer in row.columns(if index == 4 { 3 } else { 2 - u32::from(index == 0) }, 0.006) {
            let z = [upper.high.z - SINK, upper.high.z + 0.008];
            builder.cuboid(Slot::WoodLight, drawer.with_z(z));
            let pulls: &[f64] = if drawer.width() > 0.25 { &[-0.3, 0.3] } else { &[0.0] };
            for share in pulls {
                let at = DVec3::new(drawer.center().x + share * drawer.width(), drawer.center().y, z[1]);
                builder.add(
                    Slot::Brass,
                    turned_forward(cylinder(0.008, [-SINK, 0.014], 6)).moved(at.x, at.y, at.z),
                );
            }
        }
    }
}

/// A lid that stands open at the back of a chest, hammers and rules in front of it, and grips at the sides.
fn open_lid(builder: &mut Builder, slot: Slot, chest: Bay) {
    let bay = builder.bay();
    let lid = chest.with_y([chest.high.y - 0.05, bay.high.y]).with_z([bay.low.z, chest.low.z + 0.003]);
    builder.block(slot, lid.inset(0.002, 0.0, 0.0), 0.006);
    builder.cuboid(
        Slot::Leaf,
        lid.inset(0.03, 0.0, 0.0)
            .with_y([chest.high.y + 0.002, bay.high.y - 0.025])
            .with_z([lid.high.z - SINK, lid.high.z + 0.002]),
    );
    let rim = chest.with_y([chest.high.y - SINK, chest.high.y + 0.014]);
    for side in [Side::Left, Side::Right] {
        builder.cuboid(slot, rim.slab(side, 0.012).inset(0.0, 0.0, 0.006).without(side, 0.004));
    }
    builder.cuboid(
        slot,
        rim.slab(Side::Front, 0.012)
            .inset(0.006, 0.0, 0.0)
            .without(Side::Front, 0.005)
            .without(Side::Above, 0.001),
    );
    let y = chest.high.y + 0.012;
    let shaft = [DVec3::new(-0.16, y, chest.center().z), DVec3::new(0.1, y, chest.center().z + 0.04)];
    builder.add(Slot::WoodLight, sweep(&shaft, 0.01, 6));
    builder.block(Slot::MetalDark, Bay::around(shaft[1], 0.03, 0.026, 0.1), 0.005);
    for side in [-1.0, 1.0] {
        let at = |x: f64, y: f64, z: f64| DVec3::new(side * x, chest.center().y + y, chest.center().z + z);
        let x = chest.high.x;
        let bow = [
            at(x - 0.002, 0.0, -0.06),
            at(x + 0.03, -0.012, -0.05),
            at(x + 0.03, -0.012, 0.05),
            at(x - 0.002, 0.0, 0.06),
        ];
        builder.add(Slot::Brass, sweep(&bow, 0.006, 5));
    }
}

/// Boxes of plastic on each other: a deep bin on two wheels, a box of small drawers, a case with a bow; a handle to
/// draw them stands behind.
pub(super) fn stacked_boxes(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let slot = [Slot::PaintedAccent, Slot::Book, Slot::Brass, Slot::Leaf][look];
    let height = bay.height();
    let body = bay.without(Side::Back, 0.05).inset(0.03, 0.0, 0.0);
    wheels(builder);
    for x in [-0.5, 0.5] {
        castor(builder, DVec3::new(x * body.width() * 0.7, 0.0, body.high.z - 0.07), 0.05);
    }
    let bin = body.with_y([0.05 - SINK, height * 0.42]);
    builder.block(Slot::PlasticDark, bin.inset(0.012, 0.0, 0.004).without(Side::Front, 0.012), 0.02);
    builder.block(slot, bin.slab(Side::Above, 0.06).without(Side::Front, 0.006), 0.014);
    let chest = body
        .with_y([height * 0.42 - SINK, height * 0.62])
        .inset(0.016, 0.0, 0.003)
        .without(Side::Front, 0.016);
    builder.block(Slot::PlasticDark, chest, 0.012);
    for row in chest.inset(0.02, 0.014, 0.0).rows(2, 0.01) {
        let drawer = row.with_z([chest.high.z - SINK, chest.high.z + 0.008]);
        builder.cuboid(Slot::Plastic, drawer);
        builder.cuboid(
            slot,
            drawer
                .slab(Side::Above, 0.016)
                .inset(0.14, 0.0, 0.0)
                .moved(0.0, -0.002, 0.0)
                .with_z([drawer.high.z - SINK, drawer.high.z + 0.008]),
        );
    }
    let case = body
        .with_y([height * 0.62 - SINK, height * 0.82])
        .inset(0.012, 0.0, 0.005)
        .without(Side::Front, 0.014);
    builder.block(Slot::PlasticDark, case.without(Side::Above, 0.07), 0.014);
    builder.block(slot, case.slab(Side::Above, 0.075).inset(-0.004, 0.0, -0.004), 0.018);
    for level in [0.42, 0.62, 0.745] {
        for x in [-0.28, 0.28] {
            let latch = Bay::around(DVec3::new(x * body.width(), height * level, 0.0), 0.06, 0.07, 1.0);
            builder.cuboid(
                if level > 0.7 { Slot::Plastic } else { slot },
                latch.with_z([body.high.z - 0.03, bay.high.z - if level > 0.7 { 0.001 } else { 0.0 }]),
            );
        }
    }
    bows(builder, body, case);
}

/// A bow on the lid of a case, and a handle on two rods behind the boxes.
fn bows(builder: &mut Builder, body: Bay, case: Bay) {
    let bay = builder.bay();
    let height = bay.height();
    let at = |x: f64, y: f64| DVec3::new(x, y, case.center().z);
    let bow = [
        at(-0.13, case.high.y - 0.01),
        at(-0.11, case.high.y + 0.05),
        at(0.11, case.high.y + 0.05),
        at(0.13, case.high.y - 0.01),
    ];
    builder.add(Slot::PlasticDark, pipe(&bow, 0.013, 0.03));
    let (x, z) = (body.high.x * 0.62, bay.low.z + 0.026);
    let handle = [
        DVec3::new(-x, height * 0.2, z),
        DVec3::new(-x, height - 0.0125, z),
        DVec3::new(x, height - 0.0125, z),
        DVec3::new(x, height * 0.2, z),
    ];
    builder.add(Slot::Metal, pipe(&handle, 0.0125, 0.04));
    for side in [-1.0, 1.0] {
        builder.add(Slot::PlasticDark, ball(0.02, 8).moved(side * x, height * 0.2, z));
        let clip = Bay::around(DVec3::new(side * x, height * 0.36, z + 0.02), 0.05, 0.05, 0.05);
        builder.cuboid(Slot::PlasticDark, clip);
    }
}

/// Two wheels at the sides, behind.
fn wheels(builder: &mut Builder) {
    let bay = builder.bay();
    let radius = 0.085;
    for side in [-1.0, 1.0] {
        let wheel = turned_sideways(cylinder(radius, [-0.03, 0.03], 14));
        builder.add(Slot::Rubber, wheel.moved(side * (bay.high.x - 0.03), radius, bay.low.z + radius));
        let hub = turned_sideways(cylinder(radius * 0.5, [-0.032, 0.032], 8));
        builder.add(Slot::Plastic, hub.moved(side * (bay.high.x - 0.033), radius, bay.low.z + radius));
    }
}
