//! Plain modern swivel chairs: mesh in a frame, a padded shell, a high executive chair, bent plywood.

use glam::DVec3;

use super::{ARM_RISE, BACK_DEPTH, HUB, PAD, SPRING, Spokes, Swivel};
use crate::recipes::Slot;
use crate::recipes::kit::{
    Bay, Builder, Solid, Station, crowned, cuboid, cylinder, pipe, rounded_box, sheet,
};

/// A net in a frame with a bar across the loins, arm rests on posts.
pub(super) fn mesh_back(chair: &Swivel, builder: &mut Builder) {
    chair.five_star(builder, Slot::PlasticDark, Slot::Metal);
    chair.t_arms(builder, Slot::MetalDark, Slot::PlasticDark);
    chair.spine(builder, Slot::PlasticDark, 0.34, 0.02);
    builder.add(Slot::Fabric, crowned(chair.seat_bay(PAD, 0.82), 0.03, 0.012));
    frame(chair, builder, [(0.1, 0.62), (0.52, 0.74), (0.985, 0.66)]);
    builder.add(Slot::Fabric, chair.back(&[(0.12, 0.6), (0.52, 0.72), (0.97, 0.64)], 0.005, 0.012));
    let y = chair.rise(0.32);
    let loins = Bay::around(DVec3::new(0.0, y, chair.lean(y) - 0.014), chair.half * 1.35, 0.05, 0.016);
    builder.block(Slot::PlasticDark, loins, 0.005);
}

/// A round bar about a back, through (rise, share of the half width) from its lower end to its upper one.
fn frame(chair: &Swivel, builder: &mut Builder, corners: [(f64, f64); 3]) {
    let at = |(rise, wide): (f64, f64)| {
        let y = chair.rise(rise);
        DVec3::new(wide * chair.half, y, chair.lean(y) + 0.008)
    };
    let right = corners.map(at);
    let left = right.map(|point| DVec3::new(-point.x, point.y, point.z));
    let foot = DVec3::new(0.004, right[0].y, right[0].z);
    let mut path = vec![foot];
    path.extend(right);
    path.extend(left.iter().rev());
    path.push(DVec3::new(-foot.x, foot.y, foot.z));
    builder.add(Slot::PlasticDark, pipe(&path, 0.011, 0.05));
}

/// Seat and back in one padded sheet on four spokes of polished metal, with loops as arm rests.
pub(super) fn padded_shell(chair: &Swivel, builder: &mut Builder) {
    four_spokes(chair, builder, Slot::Chrome);
    builder.add(Slot::Leather, shell(chair, 0.034, 0.024));
    let (x, top) = (chair.bay.high.x - 0.012, chair.seat + ARM_RISE);
    let (front, back) = (chair.half * 0.42, -chair.half * 0.5);
    let loop_arm = [
        DVec3::new(chair.half * 0.76, chair.seat - 0.03, front * 0.6),
        DVec3::new(x, chair.seat + 0.03, front),
        DVec3::new(x, top, front * 0.9),
        DVec3::new(x, top, back),
        DVec3::new(chair.half * 0.74, top + 0.02, chair.lean(top) + 0.03),
    ];
    builder.add_pair(Slot::Chrome, pipe(&loop_arm, 0.012, 0.05));
}

/// Four spokes towards the corners, and the gas spring on them.
fn four_spokes(chair: &Swivel, builder: &mut Builder, slot: Slot) {
    chair.spokes(builder, &Spokes { slot, wheel: Slot::Rubber, count: 4, thickness: 0.016 });
    builder.add(slot, cylinder(SPRING, [HUB - 0.02, chair.under() - 0.01], 8));
    chair.mechanism(builder, Slot::MetalDark);
}

/// Seat and back of one thickness in one sheet whose edges are raised by `rim` metres.
fn shell(chair: &Swivel, thickness: f64, rim: f64) -> Solid {
    let front = chair.half * 0.86;
    let heel = chair.bay.low.z + BACK_DEPTH;
    let station = |z: f64, y: f64, wide: f64, share: f64| Station {
        at: DVec3::new(0.0, y - thickness / 2.0, z),
        half_width: chair.half * wide,
        sag: rim * share,
    };
    let upper = |rise: f64, wide: f64| {
        let y = chair.rise(rise);
        station(chair.lean(y), y + thickness / 2.0, wide, 0.8)
    };
    let seat = chair.seat;
    let stations = [
        station(front, seat - 0.03, 0.7, 0.2),
        station(front - 0.05, seat, 0.78, 0.5),
        station(0.0, seat - 0.012, 0.8, 1.0),
        station(heel + 0.06, seat - 0.008, 0.78, 1.0),
        station(heel + 0.004, seat + 0.05, 0.76, 1.0),
        upper(0.4, 0.78),
        upper(0.94, 0.74),
        upper(0.995, 0.62),
    ];
    sheet(&stations, DVec3::NEG_X, thickness, 4)
}

/// Deep cushions in leather, a rest for the head, padded arm rests.
pub(super) fn executive(chair: &Swivel, builder: &mut Builder) {
    chair.five_star(builder, Slot::Chrome, Slot::Chrome);
    chair.t_arms(builder, Slot::Chrome, Slot::Leather);
    chair.spine(builder, Slot::MetalDark, 0.3, 0.022);
    builder.add(Slot::Leather, crowned(chair.seat_bay(PAD + 0.02, 0.84), 0.035, 0.022));
    builder
        .add(Slot::Leather, chair.back(&[(0.04, 0.7), (0.1, 0.78), (0.37, 0.8), (0.4, 0.74)], 0.06, 0.008));
    builder
        .add(Slot::Leather, chair.back(&[(0.41, 0.74), (0.44, 0.8), (0.7, 0.78), (0.73, 0.7)], 0.06, 0.008));
    builder
        .add(Slot::Leather, chair.back(&[(0.75, 0.5), (0.79, 0.6), (0.96, 0.58), (0.99, 0.46)], 0.05, 0.012));
    let y = chair.rise(0.5);
    let plate =
        Bay::around(DVec3::new(0.0, y, chair.lean(y) - 0.022), chair.half * 0.7, chair.rise(0.86) - y, 0.02);
    builder.cuboid(Slot::MetalDark, plate);
}

/// A shell of plywood with pads before it, and arm rests of wood.
pub(super) fn bent_ply(chair: &Swivel, builder: &mut Builder) {
    chair.five_star(builder, Slot::Wood, Slot::MetalDark);
    let board = chair.seat_bay(0.014, 0.84).moved(0.0, -0.045, 0.0);
    builder.block(Slot::Wood, board, 0.005);
    let pad = chair.seat_bay(0.05, 0.8).inset(0.0, 0.0, 0.012);
    builder.add(Slot::FabricAccent, crowned(pad, 0.022, 0.012));
    let outer = [(0.06, 0.6), (0.2, 0.72), (0.6, 0.78), (0.95, 0.66), (0.995, 0.5)];
    builder.add(Slot::Wood, chair.back(&outer, 0.012, 0.024));
    let front = [(0.2, 0.58), (0.28, 0.64), (0.7, 0.66), (0.88, 0.54)];
    builder.add(Slot::FabricAccent, chair.back(&front, 0.03, 0.016).moved(0.0, 0.0, 0.016));
    chair.spine(builder, Slot::MetalDark, 0.3, 0.018);
    let (x, top) = (chair.bay.high.x - 0.022, chair.seat + ARM_RISE);
    let post = Bay::around(DVec3::new(x, chair.seat + ARM_RISE * 0.36, 0.0), 0.018, ARM_RISE * 1.2, 0.05);
    builder.add_pair(Slot::MetalDark, cuboid(post));
    let bracket = Bay::around(DVec3::new(x * 0.8, post.low.y + 0.006, 0.0), x * 0.41, 0.0125, 0.046);
    builder.add_pair(Slot::MetalDark, cuboid(bracket));
    let rest = Bay::around(DVec3::new(x, top - 0.01, 0.01), 0.044, 0.022, chair.half * 0.84);
    builder.add_pair(Slot::Wood, rounded_box(rest, DVec3::splat(0.008), 1));
}
