//! Weight benches: pads 0.28 to 0.3 m wide, lying at 0.42 to 0.45 (IPF rules); bars 28 mm thick, plates up to 0.45 across.

use glam::{DVec2, DVec3};

use crate::geometry::Side;
use crate::recipes::furniture::parts::{LegKind, across, ball, legs_at_corners, turned_sideways};
use crate::recipes::kit::{Axis, Bay, Builder, SINK, extrude, pipe, sweep};
use crate::recipes::{Recipe, Slot};

/// Share of the height at which one lies.
const LYING: f64 = 0.37;
/// Metres of a bar's radius.
const BAR: f64 = 0.014;
/// Metres that a slanting back goes back at least; in less, its outline would cross itself.
const LEAST_BACK: f64 = 0.1;

/// A padded bench under a bar with weights: plain, of wood with globes, in a rack with bumper plates, or of thin tubes.
pub(in super::super) static EXERCISE_BENCH: Recipe = Recipe::furniture("exercise_bench", [1.5, 1.4, 1.2])
    .plain(|_, builder| flat(builder))
    .traditional(|_, builder| strongman(builder))
    .industrial(|_, builder| racked(builder))
    .budget(|_, builder| inclined(builder));

/// The pad of a bench to lie on, its head near the back.
fn pad(bay: Bay) -> Bay {
    let lying = bay.height() * LYING;
    Bay::new([-0.15, 0.15], [lying - 0.08, lying], [bay.low.z + bay.depth() * 0.1, bay.high.z])
}

/// Plates on both ends of a bar: shares of half the width between which each lies, and their radius.
fn plates(builder: &mut Builder, slot: Slot, shares: [f64; 2], radius: f64, at: DVec2) {
    let x = shares.map(|share| share * builder.bay().high.x);
    builder.add_pair(slot, across(radius, x, 14).moved(0.0, at.x, at.y));
}

/// The bar itself.
fn bar(builder: &mut Builder, slot: Slot, y: f64, z: f64) {
    let bay = builder.bay();
    builder.add(slot, across(BAR, bay.x(), 8).moved(0.0, y, z));
}

fn flat(builder: &mut Builder) {
    let bay = builder.bay();
    let pad = pad(bay);
    builder.cushion(Slot::Leather, pad, 0.03);
    let frame = pad.with_y([0.0, pad.low.y + SINK]).inset(0.03, 0.0, 0.05);
    builder.cuboid(Slot::MetalDark, frame.slab(Side::Above, 0.06));
    let under = frame.without(Side::Above, 0.06 - SINK).inset(0.002, 0.0, 0.002);
    legs_at_corners(builder, Slot::MetalDark, under, 0.06, LegKind::Square);
    let (y, z) = (bay.high.y - 0.2, bay.low.z + 0.2);
    let gap = bay.width() * 0.26;
    for x in [-gap, gap] {
        let foot = Bay::new([x - 0.03, x + 0.03], [0.0, 0.05], [bay.low.z, bay.low.z + 0.5]);
        builder.cuboid(Slot::Metal, foot);
        builder.cuboid(Slot::Metal, Bay::new([x - 0.028, x + 0.028], [0.05 - SINK, y], [z - 0.03, z + 0.03]));
    }
    bar(builder, Slot::Chrome, y, z);
    plates(builder, Slot::Rubber, [0.8, 0.94], 0.2, DVec2::new(y, z));
}

/// A trestle of wood with a leather pad; forked posts hold a bar between two globes.
fn strongman(builder: &mut Builder) {
    let bay = builder.bay();
    let pad = pad(bay);
    builder.cushion(Slot::Leather, pad, 0.035);
    let beam = pad.with_y([pad.low.y - 0.06, pad.low.y + SINK]).inset(0.05, 0.0, 0.04);
    builder.block(Slot::WoodDark, beam, 0.006);
    for z in [beam.low.z + 0.1, beam.high.z - 0.1] {
        let leg = [DVec3::new(0.24, 0.0, z), DVec3::new(0.08, pad.low.y - 0.01, z)];
        builder.add_pair(Slot::WoodDark, sweep(&leg, 0.03, 4));
        builder
            .add(Slot::WoodDark, sweep(&[DVec3::new(-0.18, 0.14, z), DVec3::new(0.18, 0.14, z)], 0.016, 4));
    }
    let globe = (bay.height() * 0.13).min(0.17);
    let (y, z) = (bay.high.y - globe, bay.low.z + globe + 0.04);
    let gap = bay.width() * 0.27;
    let post = [
        (gap - 0.035, 0.06),
        (gap + 0.035, 0.06),
        (gap + 0.045, y + 0.03),
        (gap + 0.02, y + 0.03),
        (gap + 0.017, y - 0.012),
        (gap - 0.017, y - 0.012),
        (gap - 0.02, y + 0.03),
        (gap - 0.045, y + 0.03),
    ];
    // The fork is open to the front and back, so it is cut from the side.
    let fork = post.map(|(x, y)| DVec2::new(x - gap + z, y));
    builder.add_pair(Slot::Wood, extrude(&fork, Axis::X, [gap - 0.03, gap + 0.03]));
    let foot = Bay::new([gap - 0.04, gap + 0.04], [0.0, 0.065], [bay.low.z, bay.low.z + 0.56]);
    for ends in [foot.x(), [-foot.high.x, -foot.low.x]] {
        builder.block(Slot::Wood, foot.with_x(ends), 0.012);
    }
    builder.cuboid(Slot::Wood, Bay::new([-gap, gap], [0.3, 0.38], [z - 0.018, z + 0.018]));
    bar(builder, Slot::MetalDark, y, z);
    builder.add_pair(Slot::MetalDark, turned_sideways(ball(globe, 14)).moved(bay.high.x - globe, y, z));
}

/// A rack of four posts with holes and spotter arms around a bench whose back is raised.
fn racked(builder: &mut Builder) {
    let bay = builder.bay();
    let (high, tube) = (bay.high.y, 0.07);
    let x = bay.width() * 0.3;
    let rack = Bay::new([-x - tube, x + tube], [0.0, high], [bay.low.z, bay.low.z + 0.6]);
    legs_at_corners(builder, Slot::MetalDark, rack, tube, LegKind::Square);
    for z in [rack.low.z + 0.004, rack.high.z - tube + 0.004] {
        for y in [0.006, high - tube - 0.006] {
            let beam = Bay::new([-x - SINK, x + SINK], [y, y + tube - 0.008], [z, z + tube - 0.008]);
            if y > tube || z < rack.center().z {
                builder.cuboid(Slot::MetalDark, beam);
            }
        }
    }
    for side in [Side::Left, Side::Right] {
        let cheek = rack.slab(side, tube).inset(0.006, 0.0, tube - SINK);
        for y in [0.008, high - tube - 0.002] {
            builder.cuboid(Slot::MetalDark, cheek.with_y([y, y + tube - 0.01]));
        }
        let arm = rack.slab(side, tube).inset(-0.012, 0.0, -0.02).with_y([high * 0.5, high * 0.5 + 0.05]);
        builder.cuboid(Slot::PaintedAccent, arm);
    }
    let (y, z) = (high * 0.86, rack.high.z + 0.045);
    let cup = Bay::new([x, x + tube], [y - 0.06, y - BAR + 0.001], [rack.high.z - SINK, rack.high.z + 0.09]);
    for ends in [cup.x(), [-cup.high.x, -cup.low.x]] {
        builder.block(Slot::PaintedAccent, cup.with_x(ends).inset(0.008, 0.0, 0.0), 0.006);
    }
    bar(builder, Slot::Chrome, y, z);
    plates(builder, Slot::Rubber, [0.7, 0.8], 0.16, DVec2::new(y, z));
    plates(builder, Slot::PaintedAccent, [0.81, 0.88], 0.16, DVec2::new(y, z));
    reclining(builder, Slot::Leather, Slot::MetalDark, bay.height() * LYING, [z - 0.1, bay.high.z]);
}

/// A level seat at the front and a slanting back, on a spine with two feet.
fn reclining(builder: &mut Builder, pad: Slot, frame: Slot, lying: f64, z: [f64; 2]) {
    let seat = Bay::new([-0.14, 0.14], [lying - 0.06, lying], [z[1] - 0.36, z[1]]);
    builder.cushion(pad, seat, 0.025);
    let hinge = seat.low.z.max(z[0] + LEAST_BACK);
    let (low, rise) = (hinge - 0.02, (hinge - z[0]) * 0.6);
    let back = [
        (low, lying - 0.05),
        (low, lying + 0.012),
        (z[0] + 0.045, lying + rise),
        (z[0], lying + rise - 0.05),
    ];
    builder.add(pad, extrude(&back.map(DVec2::from), Axis::X, [-0.14, 0.14]));
    let spine = Bay::new([-0.03, 0.03], [lying - 0.16, lying - 0.1], [z[0] + 0.06, z[1] - 0.04]);
    builder.cuboid(frame, spine);
    builder.cuboid(
        frame,
        Bay::new([-0.026, 0.026], [lying - 0.11, lying - 0.05], seat.inset(0.0, 0.0, 0.12).z()),
    );
    let stay = [DVec3::new(0.0, lying - 0.12, z[0] + 0.12), DVec3::new(0.0, lying + rise * 0.6, z[0] + 0.12)];
    builder.add(frame, sweep(&stay, 0.02, 4));
    for z in [spine.low.z + 0.03, spine.high.z - 0.03] {
        builder.cuboid(frame, Bay::around(DVec3::new(0.0, (lying - 0.1) / 2.0, z), 0.05, lying - 0.13, 0.05));
        builder.block(Slot::Rubber, Bay::around(DVec3::new(0.0, 0.02, z), 0.42, 0.04, 0.06), 0.008);
    }
}

/// A light bench of bent tubes with foam rollers for the legs and a bar with small plates.
fn inclined(builder: &mut Builder) {
    let bay = builder.bay();
    let (high, tube) = (bay.high.y, 0.02);
    let lying = bay.height() * LYING;
    reclining(builder, Slot::FabricAccent, Slot::Chrome, lying, [bay.low.z + 0.3, bay.high.z - 0.2]);
    let x = bay.width() * 0.2;
    let (y, z) = (high - 0.12, bay.low.z + 0.14);
    let frame = [
        DVec3::new(x * 1.6, tube, bay.low.z + tube),
        DVec3::new(x, 0.3, z),
        DVec3::new(x, high - tube, z - 0.03),
    ];
    builder.add_pair(Slot::Chrome, pipe(&frame, tube, 0.1));
    for height in [0.3, 0.62] {
        builder
            .add(Slot::Chrome, sweep(&[DVec3::new(-x, height, z), DVec3::new(x, height, z)], tube * 0.9, 6));
    }
    let spine = [DVec3::new(0.0, 0.3, z), DVec3::new(0.0, lying - 0.13, bay.low.z + 0.5)];
    builder.add(Slot::Chrome, sweep(&spine, tube, 6));
    let hook = Bay::new([x - 0.02, x + 0.02], [y - 0.06, y - BAR + 0.002], [z - 0.02, z + 0.06]);
    for ends in [hook.x(), [-hook.high.x, -hook.low.x]] {
        builder.cuboid(Slot::PlasticDark, hook.with_x(ends));
    }
    bar(builder, Slot::Chrome, y, z + 0.04);
    plates(builder, Slot::PlasticDark, [0.66, 0.8], 0.115, DVec2::new(y, z + 0.04));
    plates(builder, Slot::PlasticDark, [0.805, 0.9], 0.09, DVec2::new(y, z + 0.04));
    // The lever for the legs.
    let front = bay.high.z - 0.09;
    let lever = [
        DVec3::new(0.0, lying - 0.13, front - 0.16),
        DVec3::new(0.0, lying - 0.16, front),
        DVec3::new(0.0, 0.12, front),
    ];
    builder.add(Slot::Chrome, pipe(&lever, tube, 0.06));
    for y in [lying - 0.12, 0.14] {
        builder.add(Slot::Rubber, across(0.045, [-0.24, 0.24], 10).moved(0.0, y, bay.high.z - 0.045));
    }
}
