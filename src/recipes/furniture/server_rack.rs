//! Racks for computers: 19 inch (0.483 m) between posts of 0.6 m, 1.0 to 1.1 deep, 42 units of 44 mm (IEC 60297).

use glam::DVec3;

use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, SINK, Sampler, pipe, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// Metres of a unit of height.
const UNIT: f64 = 0.0445;

/// Computers over each other: behind a door of mesh; behind a framed pane; in an open frame with its cables; towers on
/// shelves.
pub(super) static SERVER_RACK: Recipe =
    Recipe::furniture("server_rack", [0.6, 1.07, 2.0]).symbol(Symbol::Diagonal).every_set(server_rack);

fn server_rack(draft: &Draft, builder: &mut Builder) {
    let mut sampler = draft.sampler();
    match draft.set() {
        GeometrySet::Plain => mesh_door(builder, &mut sampler),
        GeometrySet::Traditional => glazed(builder, &mut sampler),
        GeometrySet::Industrial => open_frame(builder, &mut sampler),
        GeometrySet::Budget => shelves_of_towers(builder, &mut sampler),
    }
}

/// Devices of one to four units from below upwards in a bay whose front is that of the fronts; lights, ports or disks
/// on each. Gives up at the top of the bay.
fn devices(builder: &mut Builder, sampler: &mut Sampler, bay: Bay, has_ears: bool) {
    let mut low = bay.low.y;
    loop {
        let units = f64::from(sampler.pick(&[1, 1, 2, 2, 3, 4]));
        let high = low + units * UNIT;
        if high > bay.high.y {
            return;
        }
        let slot = sampler.pick(&[Slot::PlasticDark, Slot::Metal, Slot::MetalDark]);
        let device = bay.with_y([low + 0.002, high - 0.002]);
        builder.cuboid(slot, device);
        let face = device.with_z([bay.high.z - SINK, bay.high.z + 0.003]).inset(0.05, UNIT * 0.22, 0.0);
        if sampler.chance(0.4) {
            for disk in face.slab(Side::Left, face.width() * 0.6).columns(4, 0.01) {
                builder.cuboid(if slot == Slot::Metal { Slot::PlasticDark } else { Slot::Metal }, disk);
            }
        } else {
            builder.cuboid(Slot::PlasticDark, face.slab(Side::Left, face.width() * 0.5));
        }
        for light in face.slab(Side::Right, 0.05).columns(2, 0.014) {
            builder.cuboid(Slot::Lamp, light.slab(Side::Above, 0.012));
        }
        if has_ears {
            for side in [Side::Left, Side::Right] {
                let ear = device.slab(side, 0.012).with_z([bay.high.z - 0.002, bay.high.z + 0.002]);
                builder.cuboid(Slot::Metal, ear.inset(-0.008, 0.002, 0.0));
            }
        }
        low = high;
    }
}

/// A case whose front is open: sides, back, floor and roof of a thickness.
fn case(builder: &mut Builder, slot: Slot, bay: Bay, thick: f64) {
    for side in [Side::Left, Side::Right] {
        builder.cuboid(slot, bay.slab(side, thick));
    }
    let between = bay.inset(thick - SINK, 0.0, 0.0);
    builder.cuboid(slot, between.slab(Side::Above, thick).inset(0.0, 0.0, 0.001).moved(0.0, -0.001, 0.0));
    builder.cuboid(slot, between.slab(Side::Below, thick).inset(0.0, 0.0, 0.001).moved(0.0, 0.001, 0.0));
    let behind = between.slab(Side::Back, thick).inset(0.0, thick, 0.0).moved(0.0, 0.0, 0.002);
    builder.cuboid(slot, behind);
}

/// A dark cabinet with a framed door of upright strips, a handle with a lock, and castors behind a plinth.
fn mesh_door(builder: &mut Builder, sampler: &mut Sampler) {
    let bay = builder.bay();
    let body = bay.without(Side::Front, 0.05);
    case(builder, Slot::MetalDark, body.without(Side::Below, 0.03), 0.03);
    builder.cuboid(Slot::PlasticDark, body.slab(Side::Below, 0.032).inset(0.02, 0.0, 0.02));
    let inside = body.inset(0.058, 0.09, 0.0).without(Side::Back, 0.3).without(Side::Front, 0.03);
    devices(builder, sampler, inside, true);
    let door = bay.without(Side::Below, 0.035).with_z([body.high.z + 0.002, bay.high.z - 0.02]);
    for side in [Side::Left, Side::Right] {
        builder.cuboid(Slot::MetalDark, door.slab(side, 0.05).inset(0.003, 0.004, 0.0));
    }
    let between = door.inset(0.052, 0.0045, 0.001);
    for side in [Side::Above, Side::Below] {
        builder.cuboid(Slot::MetalDark, between.slab(side, 0.06));
    }
    for strip in between.inset(0.002, 0.058, 0.008).columns(18, 0.014) {
        builder.cuboid(Slot::MetalDark, strip);
    }
    let handle = Bay::around(DVec3::new(bay.high.x - 0.028, bay.height() * 0.52, 0.0), 0.022, 0.2, 1.0);
    builder.block(Slot::Chrome, handle.with_z([door.high.z - SINK, bay.high.z]), 0.004);
}

/// A light cabinet on a broad plinth, a pane in a frame with round bars, louvres in its head.
fn glazed(builder: &mut Builder, sampler: &mut Sampler) {
    let bay = builder.bay();
    let slot = sampler.pick(&[Slot::Appliance, Slot::Painted, Slot::Metal]);
    let body = bay.without(Side::Front, 0.06);
    let (plinth, head) = (bay.height() * 0.06, bay.height() * 0.1);
    builder.block(Slot::MetalDark, body.slab(Side::Below, plinth).inset(0.012, 0.0, 0.012), 0.004);
    let middle = body.with_y([plinth - SINK, bay.high.y - head + SINK]);
    case(builder, slot, middle, 0.05);
    builder.block(slot, bay.slab(Side::Above, head).without(Side::Front, 0.026), 0.02);
    for slat in bay.slab(Side::Above, head).inset(0.09, head * 0.24, 0.0).rows(4, head * 0.07) {
        builder.cuboid(Slot::MetalDark, slat.with_z([bay.high.z - 0.03, bay.high.z - 0.02]));
    }
    let inside = middle.inset(0.064, 0.06, 0.0).without(Side::Back, 0.3).without(Side::Front, 0.06);
    devices(builder, sampler, inside, true);
    let door = middle.inset(0.008, 0.008, 0.0).with_z([body.high.z + 0.001, bay.high.z - 0.024]);
    for side in [Side::Left, Side::Right] {
        builder.block(slot, door.slab(side, 0.07), 0.008);
    }
    let between = door.inset(0.066, 0.001, 0.002);
    builder.block(slot, between.slab(Side::Above, 0.08), 0.008);
    builder.block(slot, between.slab(Side::Below, 0.2), 0.008);
    builder.cuboid(
        Slot::Glass,
        between.without(Side::Above, 0.076).without(Side::Below, 0.196).inset(0.0, 0.0, 0.014),
    );
    let badge = between.slab(Side::Below, 0.2).inset(between.width() * 0.34, 0.07, 0.0);
    builder.cuboid(Slot::Brass, badge.with_z([between.high.z - SINK, between.high.z + 0.003]));
    let (x, z) = (door.high.x - 0.035, bay.high.z - 0.009);
    let at = |y: f64, z: f64| DVec3::new(x, y * bay.height(), z);
    let bow = [at(0.46, door.high.z - 0.002), at(0.46, z), at(0.6, z), at(0.6, door.high.z - 0.002)];
    builder.add(Slot::Chrome, sweep(&bow, 0.009, 6));
    for y in [0.2, 0.8] {
        let hinge =
            Bay::around(DVec3::new(door.low.x, bay.height() * y, door.high.z - 0.01), 0.016, 0.09, 0.026);
        builder.cuboid(Slot::Chrome, hinge.moved(0.004, 0.0, 0.004));
    }
}

/// Four posts between frames, devices of different depth, trays of cables over them and bundles at the side.
fn open_frame(builder: &mut Builder, sampler: &mut Sampler) {
    let bay = builder.bay();
    let post = 0.045;
    for (side, z) in [
        (Side::Left, Side::Front),
        (Side::Right, Side::Front),
        (Side::Left, Side::Back),
        (Side::Right, Side::Back),
    ] {
        let corner = bay.slab(side, post).slab(z, post);
        let upright = corner.without(Side::Below, 0.003);
        builder.cuboid(Slot::Metal, upright.slab(side, 0.005));
        builder.cuboid(Slot::Metal, upright.slab(z, 0.005).inset(0.001, 0.001, 0.0).without(z, 0.0012));
        builder.cuboid(
            Slot::MetalDark,
            corner.slab(Side::Below, 0.012).inset(-0.0006, 0.0, 0.0006).without(side, 0.0015),
        );
    }
    for y in [[0.05, 0.09], [bay.high.y - 0.05, bay.high.y - 0.008]] {
        for side in [Side::Left, Side::Right] {
            let rail = bay.slab(side, 0.028).with_y(y).inset(0.0, 0.0, 0.02);
            builder.cuboid(Slot::Metal, rail.without(side, 0.0025));
        }
        for side in [Side::Front, Side::Back] {
            let rail = bay.slab(side, 0.028).with_y([y[0] + 0.001, y[1] - 0.001]).inset(0.03, 0.0, 0.0);
            builder.cuboid(Slot::Metal, rail.without(side, 0.003));
        }
    }
    let devices_bay = bay.inset(0.058, 0.0, 0.0).with_z([bay.low.z + 0.25, bay.high.z - 0.009]);
    devices(builder, sampler, devices_bay.with_y([0.1, bay.height() * 0.5]), true);
    devices(builder, sampler, devices_bay.with_y([bay.height() * 0.58, bay.height() * 0.9]), true);
    patch_panel(builder, devices_bay.with_y([bay.height() * 0.52, bay.height() * 0.52 + UNIT * 1.4]));
    for (x, slot) in [(-0.02, Slot::Rubber), (0.02, Slot::PaintedAccent)] {
        let at = |y: f64, z: f64| DVec3::new(bay.low.x + 0.07 + x, y * bay.height(), bay.low.z + z);
        builder.add(slot, pipe(&[at(0.06, 0.12), at(0.96, 0.12), at(0.975, 0.5 + x)], 0.016, 0.08));
    }
}

/// A panel of ports, with cables down to the right.
fn patch_panel(builder: &mut Builder, panel: Bay) {
    let bay = builder.bay();
    builder.cuboid(Slot::PlasticDark, panel.slab(Side::Front, 0.03));
    let ports = panel.inset(0.02, UNIT * 0.4, 0.0).columns(12, 0.012);
    for (index, port) in ports.into_iter().enumerate() {
        let front = port.with_z([panel.high.z - SINK, panel.high.z + 0.002]);
        builder.cuboid(Slot::Metal, front);
        if index % 2 == 0 {
            let slot = [Slot::PaintedAccent, Slot::Book, Slot::Leaf][index / 2 % 3];
            let (at, z) = (front.center(), bay.high.z - 0.006);
            let side = bay.high.x - 0.05 - 0.003 * index as f64;
            let down = at.y - 0.1 - 0.05 * index as f64;
            let path = [
                DVec3::new(at.x, at.y, at.z - 0.002),
                DVec3::new(at.x, at.y - 0.012, z),
                DVec3::new(side, at.y - 0.04, z),
                DVec3::new(side, down, z),
            ];
            builder.add(slot, sweep(&path, 0.0045, 4));
        }
    }
}

/// Shelves on slotted posts with towers beside each other, their cables at the back, and a screen at the height of eyes.
fn shelves_of_towers(builder: &mut Builder, sampler: &mut Sampler) {
    let bay = builder.bay();
    let post = 0.04;
    for x in [bay.slab(Side::Left, post), bay.slab(Side::Right, post)] {
        for z in [Side::Front, Side::Back] {
            builder.cuboid(Slot::Metal, x.slab(z, post));
        }
    }
    let levels = 4;
    let pitch = (bay.height() - 0.1) / f64::from(levels);
    for level in 0..levels {
        let y = 0.08 + pitch * f64::from(level);
        let shelf = bay.inset(0.003, 0.0, 0.003).with_y([y - 0.03, y]);
        builder.cuboid(Slot::Metal, shelf);
        let room = shelf.with_y([y - SINK, y + pitch * 0.86]).inset(0.045, 0.0, 0.05);
        towers(builder, sampler, room.without(Side::Front, 0.05));
    }
    builder
        .cuboid(Slot::Metal, bay.inset(0.003, 0.0, 0.003).with_y([bay.high.y - 0.035, bay.high.y - 0.004]));
}

/// Two or three towers with drives, a button and a light, their fronts at the front of a bay.
fn towers(builder: &mut Builder, sampler: &mut Sampler, room: Bay) {
    for (index, column) in room.columns(2, 0.07).into_iter().enumerate() {
        let tall = room.height().min(0.44) * sampler.between(0.86, 1.0);
        let slot = sampler.pick(&[Slot::PlasticDark, Slot::Plastic, Slot::MetalDark]);
        let tower =
            column.slab(Side::Below, tall).without(Side::Back, 0.18).inset(column.width() * 0.06, 0.0, 0.0);
        builder.block(slot, tower, 0.006);
        let dark = if slot == Slot::Plastic { Slot::PlasticDark } else { Slot::Metal };
        let face = tower.inset(0.02, 0.02, 0.0).with_z([tower.high.z - SINK, tower.high.z + 0.004]);
        for (low, high) in [(0.84, 0.93), (0.72, 0.81)] {
            builder.cuboid(dark, face.with_y([tower.low.y + low * tall, tower.low.y + high * tall]));
        }
        let vents = face.with_y([tower.low.y + 0.06 * tall, tower.low.y + 0.4 * tall]).inset(0.03, 0.0, 0.0);
        vents.rows(5, 0.012).into_iter().for_each(|vent| builder.cuboid(dark, vent));
        let button =
            Bay::around(DVec3::new(tower.center().x, tower.low.y + 0.56 * tall, 0.0), 0.02, 0.02, 1.0);
        builder.cuboid(Slot::Lamp, button.with_z([tower.high.z - SINK, tower.high.z + 0.006]));
        let at = |y: f64, z: f64| DVec3::new(tower.center().x, y, z);
        let back = tower.low.z + 0.004;
        let start = tower.low.y + tall * (0.6 - 0.2 * index as f64);
        let cable = [at(start, back), at(start - 0.02, back - 0.09), at(tower.low.y + 0.01, back - 0.11)];
        builder.add(Slot::Rubber, sweep(&cable, 0.006, 4));
    }
}
