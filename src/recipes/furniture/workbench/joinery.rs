//! Benches of wood.

use glam::DVec3;

use super::{VICE, screw_handle, top_bay, vice_middle};
use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::furniture::parts::{turned_forward, turned_sideways};
use crate::recipes::kit::{Bay, Builder, Outline, SINK, Slice, Solid, cylinder, lathe, loft, sweep};

/// Metres between the holes for bench dogs.
const DOG_PITCH: f64 = 0.15;

/// A thick top with holes for dogs on two trestles with sledge feet and wedged stretchers, a vice of wood at the front
/// and another at the right end (Ulmia).
pub(super) fn joiners_bench(builder: &mut Builder) {
    let bay = builder.bay();
    let tail = 0.17;
    let top = top_bay(bay, 0.085).without(Side::Right, tail);
    builder.block(Slot::WoodLight, top, 0.006);
    // A deeper plank along the front takes the dogs.
    let front = top.slab(Side::Front, 0.12).with_y([top.low.y - 0.035, top.low.y + SINK]);
    builder.block(Slot::WoodLight, front.inset(0.002, 0.0, 0.002), 0.004);
    for step in 0..((top.width() - 0.3) / DOG_PITCH) as u32 {
        let x = top.high.x - 0.1 - DOG_PITCH * f64::from(step);
        let hole = Bay::around(DVec3::new(x, top.high.y - 0.004, top.high.z - 0.05), 0.022, 0.009, 0.03);
        builder.cuboid(Slot::MetalDark, hole);
    }
    let frame = top.with_y([0.0, top.low.y + SINK]).inset(0.0, 0.0, 0.05);
    let legs = [frame.low.x + frame.width() * 0.12, frame.high.x - frame.width() * 0.1];
    legs.into_iter().for_each(|x| trestle(builder, frame, x));
    stretchers(builder, frame, legs);
    face_vice(builder, top);
    tail_vice(builder, top, tail);
}

/// Two posts between a foot like a sledge and a bearer, across the bench.
fn trestle(builder: &mut Builder, frame: Bay, x: f64) {
    let half = 0.035;
    let across = frame.with_x([x - half, x + half]);
    let foot = across.slab(Side::Below, 0.08);
    builder.block(Slot::Wood, foot.without(Side::Below, 0.016), 0.006);
    for side in [Side::Front, Side::Back] {
        builder.block(
            Slot::Wood,
            foot.slab(Side::Below, 0.02).slab(side, 0.12).inset(0.001, 0.0, 0.001),
            0.003,
        );
    }
    builder.block(Slot::Wood, across.slab(Side::Above, 0.07).inset(0.001, 0.0, 0.02), 0.006);
    let posts = across.with_y([0.08 - SINK, frame.high.y - 0.07 + SINK]).inset(0.004, 0.0, 0.06);
    for side in [Side::Front, Side::Back] {
        builder.cuboid(Slot::Wood, posts.slab(side, 0.085));
    }
}

/// Two boards between the trestles, their ends through the posts with wedges, and a shelf of slats on them.
fn stretchers(builder: &mut Builder, frame: Bay, [left, right]: [f64; 2]) {
    let y = [frame.high.y * 0.3, frame.high.y * 0.3 + 0.13];
    for z in [frame.low.z + 0.1, frame.high.z - 0.1] {
        let board = Bay::new([left - 0.075, right + 0.075], y, [z - 0.016, z + 0.016]);
        builder.cuboid(Slot::Wood, board);
        for x in [left - 0.05, right + 0.05] {
            builder.cuboid(
                Slot::WoodDark,
                Bay::new([x - 0.01, x + 0.01], [y[0] - 0.03, y[1] + 0.03], [z - 0.006, z + 0.019]),
            );
        }
    }
    let shelf = Bay::new(
        [left + 0.05, right - 0.05],
        [y[1] - 0.03, y[1] - 0.012],
        [frame.low.z + 0.115, frame.high.z - 0.115],
    );
    for slat in shelf.columns(5, 0.012) {
        builder.cuboid(Slot::WoodLight, slat);
    }
    plane(builder, DVec3::new((left + right) / 2.0 - 0.2, shelf.high.y - SINK, shelf.center().z));
    let box_bay =
        Bay::around(DVec3::new(right - 0.35, shelf.high.y + 0.09, shelf.center().z), 0.38, 0.18, 0.24);
    builder.block(Slot::WoodDark, box_bay.moved(0.0, -SINK, 0.0), 0.006);
    let lid = box_bay.slab(Side::Above, 0.02).inset(-0.006, 0.0, -0.006).moved(0.0, 0.012, 0.0);
    builder.block(Slot::WoodDark, lid, 0.004);
    builder.cuboid(
        Slot::Brass,
        Bay::around(
            DVec3::new(box_bay.center().x, box_bay.high.y - 0.02, box_bay.high.z + 0.006),
            0.03,
            0.04,
            0.006,
        ),
    );
}

/// A jack plane.
fn plane(builder: &mut Builder, at: DVec3) {
    let sole = Bay::around(at + DVec3::Y * 0.03, 0.36, 0.06, 0.065);
    builder.block(Slot::WoodDark, sole, 0.006);
    let handle = [at + DVec3::new(0.12, 0.05, 0.0), at + DVec3::new(0.14, 0.13, 0.0)];
    builder.add(Slot::Wood, sweep(&handle, 0.014, 6));
    builder.add(
        Slot::Wood,
        lathe(&[(0.012, 0.05), (0.02, 0.085), (0.012, 0.1)], 8).moved(at.x - 0.13, at.y, at.z),
    );
    let iron = [at + DVec3::new(0.0, 0.04, 0.0), at + DVec3::new(0.035, 0.11, 0.0)];
    builder.add(Slot::Metal, sweep(&iron, 0.014, 4));
}

/// A jaw of wood before the top's edge on a screw and two guide bars; two dogs stand up behind it.
fn face_vice(builder: &mut Builder, top: Bay) {
    let bay = builder.bay();
    let x = vice_middle(bay);
    let half = bay.width() * VICE * 0.4;
    let edge = top.high.z;
    let jaw =
        Bay::new([x - half, x + half], [top.low.y - 0.07, top.high.y + 0.002], [edge + 0.003, edge + 0.034]);
    builder.block(Slot::Wood, jaw, 0.006);
    for side in [-0.7, 0.7] {
        let bar = turned_forward(cylinder(0.014, [edge - 0.25, edge + 0.01], 6));
        builder.add(Slot::MetalDark, bar.moved(x + half * side, top.low.y - 0.05, 0.0));
    }
    for side in [-0.6, 0.6] {
        let dog = Bay::around(DVec3::new(x + half * side, 0.0, edge - 0.05), 0.024, 1.0, 0.034);
        builder.block(Slot::WoodDark, dog.with_y([top.high.y - 0.02, top.high.y + 0.035]), 0.003);
    }
    holdfast(builder, DVec3::new(x + half * 1.1, top.high.y, edge - 0.11));
    screw_handle(
        builder,
        [Slot::WoodDark, Slot::WoodLight],
        DVec3::new(x, top.low.y - 0.03, edge + 0.03),
        0.3,
    );
}

/// A bent iron in a hole of the top, at `foot`; it holds a board to the left of it.
fn holdfast(builder: &mut Builder, foot: DVec3) {
    let radius = 0.011;
    let rise = builder.bay().high.y - radius - foot.y;
    let board = 0.022;
    let at = |x: f64, y: f64| foot + DVec3::new(-x, y, 0.0);
    let path = [
        at(0.0, -0.01),
        at(0.0, rise * 0.76),
        at(0.03, rise),
        at(0.075, rise * 0.96),
        at(0.13, board + radius),
        at(0.16, board + radius * 0.7),
    ];
    builder.add(Slot::MetalDark, sweep(&path, radius, 6));
    let held = Bay::new([foot.x - 0.26, foot.x - 0.06], [foot.y - SINK, foot.y + board], [0.0, 0.0]);
    builder.cuboid(Slot::WoodLight, held.with_z([foot.z - 0.035, foot.z + 0.035]));
}

/// A block at the right end that a screw pulls along the front; its bar hangs at the end.
fn tail_vice(builder: &mut Builder, top: Bay, room: f64) {
    let block =
        top.with_x([top.high.x + 0.016, top.high.x + room - 0.055]).slab(Side::Front, top.depth() * 0.42);
    builder.block(Slot::Wood, block.without(Side::Below, -0.03).moved(0.0, -0.0008, 0.0), 0.006);
    let middle = block.center() - DVec3::Y * 0.015;
    let screw = turned_sideways(cylinder(0.019, [top.high.x - 0.02, builder.bay().high.x], 10));
    builder.add(Slot::WoodDark, screw.moved(0.0, middle.y, middle.z));
    let x = builder.bay().high.x - 0.024;
    let bar =
        [DVec3::new(x, middle.y - 0.2, middle.z - 0.06), DVec3::new(x, middle.y + 0.06, middle.z + 0.018)];
    builder.add(Slot::WoodLight, sweep(&bar, 0.009, 6));
    for z in [-0.09, 0.09] {
        let rod = turned_sideways(cylinder(0.012, [top.high.x - 0.02, block.low.x + 0.02], 6));
        builder.add(Slot::MetalDark, rod.moved(0.0, middle.y, middle.z + z));
    }
}

/// A square bar from a foot to a head, both level, that stands aslant.
fn slanted_bar([foot, head]: [DVec3; 2], half: f64) -> Solid {
    let slice = |at: DVec3| Slice::new(at.y, half, half * 0.6).at(at.x, at.z);
    loft(&Outline::Square, &[slice(foot), slice(head)])
}

/// A sheet of plywood on two sawhorses, held by a clamp; a tool box stands below.
pub(super) fn on_trestles(builder: &mut Builder) {
    let bay = builder.bay();
    let top = top_bay(bay, 0.03);
    builder.cuboid(Slot::WoodLight, top.without(Side::Below, 0.01));
    builder.cuboid(Slot::Wood, top.slab(Side::Below, 0.0104).inset(0.0004, 0.0, 0.0004));
    for side in [-1.0, 1.0] {
        sawhorse(builder, top, side * bay.width() * 0.3);
    }
    clamp(builder, top);
    tool_box(builder, DVec3::new(bay.width() * 0.02, 0.0, bay.center().z));
}

/// A beam across the bench on four legs that spread, with a board between them.
fn sawhorse(builder: &mut Builder, top: Bay, x: f64) {
    let beam =
        top.with_x([x - 0.022, x + 0.022]).with_y([top.low.y - 0.09, top.low.y + SINK]).inset(0.0, 0.0, 0.02);
    builder.cuboid(Slot::WoodLight, beam);
    for side in [-1.0, 1.0] {
        let at = |spread: f64, y: f64, z: f64| DVec3::new(x + side * spread, y, z);
        for (foot, head) in [(beam.low.z + 0.02, beam.low.z + 0.1), (beam.high.z - 0.02, beam.high.z - 0.1)] {
            let ends = [at(0.2, 0.0, foot), at(0.038, beam.high.y - 0.012, head)];
            builder.add(Slot::WoodLight, slanted_bar(ends, 0.024));
        }
        let (low, high) = (at(0.148, 0.3, 0.0), at(0.128, 0.38, 0.0));
        let board = Bay::new([0.0, 0.0], [low.y, high.y], [beam.low.z + 0.02, beam.high.z - 0.02]);
        builder.cuboid(Slot::Wood, board.with_x([low.x.min(high.x) - 0.004, low.x.max(high.x) + 0.004]));
    }
    let shelf = beam.with_x([x - 0.14, x + 0.14]).with_y([0.365, 0.378]).inset(0.0, 0.0, 0.09);
    builder.cuboid(Slot::WoodLight, shelf);
}

/// A bar clamp over the edge of the sheet: a fixed arm above, a sliding one with a spindle below.
fn clamp(builder: &mut Builder, top: Bay) {
    let bay = builder.bay();
    let x = vice_middle(bay);
    let (edge, high) = (top.high.z, bay.high.y);
    let bar = Bay::new(
        [x - 0.006, x + 0.006],
        [high - 0.36, high - 0.004],
        [bay.high.z - 0.03, bay.high.z - 0.004],
    );
    builder.cuboid(Slot::Metal, bar);
    let arm = |y: f64, slot, builder: &mut Builder| {
        let arm = Bay::new([x - 0.011, x + 0.011], [y - 0.028, y], [edge - 0.1, bay.high.z]);
        builder.block(slot, arm, 0.004);
    };
    arm(high, Slot::PaintedAccent, builder);
    arm(top.low.y - 0.07, Slot::PaintedAccent, builder);
    // Boards that are glued, under the arm's pad.
    let pad = high - 0.028;
    let glued = Bay::around(DVec3::new(x, 0.0, edge - 0.085), bay.width() * VICE * 0.5, 0.0, 0.11);
    for board in glued.with_y([top.high.y - SINK, pad - 0.012]).rows(3, 0.0015) {
        builder.cuboid(Slot::Wood, board);
    }
    let pad = cylinder(0.02, [pad - 0.012 - SINK, pad + SINK], 8);
    builder.add(Slot::MetalDark, pad.moved(x, 0.0, edge - 0.085));
    let spindle =
        [DVec3::new(x, top.low.y + SINK, edge - 0.085), DVec3::new(x, top.low.y - 0.14, edge - 0.085)];
    builder.add(Slot::Metal, sweep(&spindle, 0.007, 6));
    let grip = cylinder(0.017, [top.low.y - 0.25, top.low.y - 0.13], 8);
    builder.add(Slot::Wood, grip.moved(x, 0.0, edge - 0.085));
}

/// A tool box of plastic with a bow over its lid.
fn tool_box(builder: &mut Builder, at: DVec3) {
    let body = Bay::around(at + DVec3::Y * 0.1, 0.46, 0.2, 0.24);
    builder.block(Slot::PlasticDark, body, 0.014);
    let lid = body.with_y([0.2 - SINK, 0.25]).inset(0.004, 0.0, 0.004);
    builder.block(Slot::PaintedAccent, lid, 0.014);
    for x in [-0.15, 0.15] {
        let latch = Bay::around(DVec3::new(at.x + x, 0.2, body.high.z + 0.002), 0.05, 0.06, 0.016);
        builder.cuboid(Slot::PaintedAccent, latch);
    }
    let path = [(-0.13, 0.24), (-0.11, 0.29), (0.11, 0.29), (0.13, 0.24)];
    let path = path.map(|(x, y)| DVec3::new(at.x + x, y, at.z));
    builder.add(Slot::PlasticDark, sweep(&path, 0.012, 6));
}
