//! Benches of steel.

use glam::{DVec2, DVec3};

use super::{RISE, VICE, screw_handle, top_bay, vice_middle};
use crate::geometry::Side;
use crate::recipes::furniture::parts::{Fittings, LegKind, leg, legs_at_corners, turned_forward};
use crate::recipes::kit::{Axis, Bay, Builder, SINK, cylinder, extrude, sweep};
use crate::recipes::{Draft, Slot};

/// A top of beech on legs of square tube, a chest of drawers under its right end, a board at the feet of the other,
/// and an iron vice.
pub(super) fn with_drawers(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let top = top_bay(bay, 0.045);
    builder.block(Slot::WoodLight, top, 0.004);
    let frame = top.with_y([0.0, top.low.y + SINK]).inset(0.03, 0.0, 0.03);
    legs_at_corners(builder, Slot::MetalDark, frame, 0.05, LegKind::Square);
    let apron = frame.slab(Side::Above, 0.05 + SINK).inset(0.049, 0.0, 0.006);
    for side in [Side::Front, Side::Back] {
        builder.cuboid(Slot::MetalDark, apron.slab(side, 0.03).without(Side::Above, SINK * 2.0));
    }
    let chest =
        frame.without(Side::Above, 0.004).slab(Side::Right, bay.width() * 0.28).inset(0.054, 0.0, 0.004);
    let chest = chest.without(Side::Below, bay.height() * 0.14).moved(0.0, 0.0, 0.004);
    let slot = draft.sampler().pick(&[Slot::PaintedAccent, Slot::Painted, Slot::Metal]);
    let fittings = Fittings { front: slot, handle: Slot::Metal, reach: 0.022, is_traditional: false };
    fittings.carcass(builder, slot, chest);
    let rows = chest.inset(0.006, 0.006, 0.0).rows(5, 0.006);
    // The lowest drawer is twice as high as the others.
    fittings.drawer(builder, rows[0].with_y([rows[0].low.y, rows[1].high.y]));
    rows.iter().skip(2).for_each(|row| fittings.drawer(builder, *row));
    let shelf = frame.inset(0.02, 0.0, 0.02).with_y([0.16, 0.185]).without(Side::Front, frame.depth() * 0.3);
    builder.cuboid(Slot::Metal, shelf.with_x([shelf.low.x, chest.low.x - 0.01]));
    let low = 0.185 - SINK;
    let case = Bay::around(DVec3::new(shelf.low.x + 0.32, low + 0.1, shelf.center().z), 0.42, 0.2, 0.22);
    builder.block(Slot::PaintedAccent, case, 0.012);
    builder
        .cuboid(Slot::MetalDark, case.slab(Side::Above, 0.012).inset(0.14, 0.0, 0.09).moved(0.0, 0.03, 0.0));
    for x in [-0.07, 0.07] {
        let at = DVec3::new(case.center().x + x, case.high.y + 0.01, case.center().z);
        builder.cuboid(Slot::MetalDark, Bay::around(at, 0.012, 0.03, 0.02));
    }
    iron_vice(builder, top);
}

/// Two jaws with grooved plates, a guide with a screw between them, on a base plate bolted to the edge of the top.
fn iron_vice(builder: &mut Builder, top: Bay) {
    let bay = builder.bay();
    let x = vice_middle(bay);
    let half = (bay.width() * VICE * 0.2).min(0.085);
    let (edge, high) = (top.high.z, bay.high.y);
    let wide = [x - half, x + half];
    // Behind the edge, on the bench; before it, down its front.
    let rear = Bay::new(wide, [top.low.y - 0.03, high], [edge - 0.045, edge + 0.006]);
    builder.block(Slot::Metal, rear.slab(Side::Above, RISE + SINK * 2.0), 0.006);
    let base = Bay::new(
        [x - half * 1.2, x + half * 1.2],
        [top.high.y - SINK, top.high.y + 0.012],
        [edge - 0.13, edge - 0.01],
    );
    builder.block(Slot::Metal, base, 0.004);
    for side in [-0.9, 0.9] {
        builder.add(
            Slot::MetalDark,
            cylinder(0.01, [top.high.y, top.high.y + 0.02], 6).moved(x + half * side, 0.0, edge - 0.1),
        );
    }
    let front = Bay::new(wide, [top.low.y - 0.05, high - 0.0008], [edge + 0.012, edge + 0.036]);
    builder.block(Slot::Metal, front, 0.006);
    for jaw in [rear.with_z([edge - 0.001, edge + 0.009]), front.with_z([edge + 0.0095, edge + 0.02])] {
        builder.cuboid(
            Slot::MetalDark,
            jaw.slab(Side::Above, 0.03).inset(0.004, 0.0, 0.0).without(Side::Above, 0.002),
        );
    }
    for side in [-0.6, 0.6] {
        let rod = turned_forward(cylinder(0.011, [edge - 0.2, edge + 0.02], 6));
        builder.add(Slot::MetalDark, rod.moved(x + half * side, top.low.y - 0.03, 0.0));
    }
    screw_handle(
        builder,
        [Slot::MetalDark, Slot::Metal],
        DVec3::new(x, top.low.y - 0.012, edge + 0.03),
        0.24,
    );
}

/// A thick top in an edge of angle on legs of angle, with braces, a grating below, a board full of tools at the back,
/// and a smith's vice whose leg stands on the floor.
pub(super) fn welded(builder: &mut Builder) {
    let bay = builder.bay();
    let top = top_bay(bay, 0.06);
    builder.cuboid(Slot::Wood, top.inset(0.006, 0.0, 0.006));
    for side in [Side::Front, Side::Back] {
        builder.cuboid(
            Slot::MetalDark,
            top.slab(side, 0.0065)
                .without(Side::Above, 0.003)
                .without(Side::Below, -0.001)
                .inset(0.0006, 0.0, 0.0),
        );
    }
    for side in [Side::Left, Side::Right] {
        builder.cuboid(
            Slot::MetalDark,
            top.slab(side, 0.0065)
                .without(Side::Above, 0.0035)
                .without(Side::Below, -0.0015)
                .inset(0.0, 0.0, 0.001),
        );
    }
    let frame = top.with_y([0.0, top.low.y + SINK]).inset(0.012, 0.0, 0.012);
    legs_at_corners(builder, Slot::MetalDark, frame.without(Side::Below, 0.008), 0.065, LegKind::Angle);
    legs_at_corners(
        builder,
        Slot::Metal,
        frame.slab(Side::Below, 0.01).inset(-0.008, 0.0, -0.008),
        0.1,
        LegKind::Square,
    );
    let radius = 0.014;
    for side in [-1.0, 1.0] {
        let x = side * (frame.high.x - 0.03);
        let brace =
            [DVec3::new(x, 0.2, frame.low.z + 0.03), DVec3::new(x, top.low.y - 0.02, frame.high.z - 0.04)];
        builder.add(Slot::MetalDark, sweep(&brace, radius, 4));
    }
    grating(builder, frame);
    tool_board(builder, frame.with_y([0.3, top.low.y - 0.02]).inset(0.08, 0.0, 0.03).slab(Side::Back, 0.012));
    smiths_vice(builder, top);
}

/// Flat bars on two rails between the legs.
fn grating(builder: &mut Builder, frame: Bay) {
    let y = 0.18;
    for side in [Side::Front, Side::Back] {
        let rail = frame.slab(side, 0.03).inset(0.012, 0.0, 0.0).with_y([y - 0.04, y]);
        builder
            .cuboid(Slot::MetalDark, rail.moved(0.0, 0.0, if side == Side::Front { -0.012 } else { 0.012 }));
    }
    let bars = frame.inset(0.07, 0.0, 0.013).with_y([y - 0.012, y + 0.006]);
    let count = (bars.width() / 0.07).round().clamp(4.0, 40.0) as u32;
    for bar in bars.columns(count, 0.032) {
        builder.cuboid(Slot::Metal, bar);
    }
    let can = cylinder(0.09, [y + 0.006 - SINK, y + 0.24], 12);
    builder.add(Slot::PaintedAccent, can.moved(frame.low.x + frame.width() * 0.34, 0.0, frame.center().z));
    let crate_bay = Bay::around(DVec3::new(frame.width() * 0.2, y + 0.08, frame.center().z), 0.4, 0.15, 0.28);
    let floor = crate_bay.slab(Side::Below, 0.02);
    builder.cuboid(Slot::WoodLight, floor.moved(0.0, -0.0002, 0.0).inset(0.0015, 0.0, 0.001));
    for side in [Side::Front, Side::Back] {
        for slat in crate_bay.slab(side, 0.014).inset(0.0, 0.004, 0.0).rows(2, 0.03) {
            builder.cuboid(Slot::WoodLight, slat);
        }
    }
    for side in [Side::Left, Side::Right] {
        builder.cuboid(Slot::WoodLight, crate_bay.slab(side, 0.016).inset(0.001, 0.008, 0.012));
    }
}

/// A perforated sheet with a hammer, a wrench, a square and a saw on hooks.
fn tool_board(builder: &mut Builder, board: Bay) {
    builder.cuboid(Slot::Metal, board);
    let front = board.high.z;
    for row in board.inset(0.03, 0.04, 0.0).rows(4, 0.0) {
        for hole in row.columns(14, 0.0) {
            let at = hole.center();
            builder.cuboid(
                Slot::PlasticDark,
                Bay::around(at, 0.009, 0.009, 0.0).with_z([front - 0.001, front + 0.0007]),
            );
        }
    }
    let (middle, step) = (board.center(), board.width() / 6.0);
    let hang = |index: f64| DVec3::new(middle.x + index * step, board.high.y - 0.05, front + 0.014);
    let at = hang(-0.6);
    builder.add(Slot::WoodLight, sweep(&[at, at - DVec3::Y * 0.26], 0.011, 6));
    builder.block(Slot::MetalDark, Bay::around(at + DVec3::new(0.012, -0.015, 0.0), 0.1, 0.034, 0.03), 0.006);
    let at = hang(0.2);
    builder.cuboid(Slot::Chrome, Bay::around(at - DVec3::Y * 0.1, 0.018, 0.2, 0.008));
    for y in [-0.005, -0.205] {
        let ring = turned_forward(cylinder(0.02, [-0.006, 0.006], 8));
        builder.add(Slot::Chrome, ring.moved(at.x, at.y + y, at.z));
    }
    let at = hang(1.0);
    let blade = [(0.0, 0.0), (0.0, -0.11), (0.34, -0.05), (0.34, -0.015)];
    let blade = blade.map(|(x, y)| DVec2::new(at.x - 0.1 + x, at.y + y));
    builder.add(Slot::Chrome, extrude(&blade, Axis::Z, [at.z - 0.0015, at.z + 0.0015]));
    builder.block(Slot::WoodDark, Bay::around(at + DVec3::new(-0.13, -0.055, 0.0), 0.09, 0.12, 0.02), 0.008);
    let at = hang(2.2);
    builder.add(Slot::MetalDark, sweep(&[at, at - DVec3::Y * 0.3], 0.009, 6));
    builder.add(Slot::PaintedAccent, sweep(&[at - DVec3::Y * 0.01, at - DVec3::Y * 0.13], 0.016, 6));
}

/// Jaws of forged iron over the edge; the rear one ends in a leg on the floor.
fn smiths_vice(builder: &mut Builder, top: Bay) {
    let bay = builder.bay();
    let x = vice_middle(bay);
    let (edge, high) = (top.high.z, bay.high.y);
    let half = (bay.width() * VICE * 0.16).min(0.07);
    let plate = Bay::new(
        [x - half * 1.2, x + half * 1.2],
        [top.high.y - SINK, top.high.y + 0.008],
        [edge - 0.16, edge],
    );
    builder.block(Slot::MetalDark, plate, 0.003);
    let jaw = |z: [f64; 2], top: f64| Bay::new([x - half, x + half], [high - 0.06, top], z);
    builder.block(Slot::Metal, jaw([edge - 0.03, edge + 0.016], high), 0.007);
    builder.block(Slot::Metal, jaw([edge + 0.019, edge + 0.04], high - 0.001), 0.006);
    let post = Bay::new([x - 0.026, x + 0.026], [0.012, high - 0.05], [edge + 0.001, edge + 0.0155]);
    leg(builder, Slot::MetalDark, post, LegKind::Square);
    let arm = Bay::new([x - 0.022, x + 0.022], [high - 0.42, high - 0.05], [edge + 0.021, edge + 0.037]);
    leg(builder, Slot::MetalDark, arm, LegKind::Square);
    builder.cuboid(
        Slot::MetalDark,
        Bay::new([x - 0.034, x + 0.034], [high - 0.43, high - 0.4], [edge, edge + 0.04]),
    );
    let foot = cylinder(0.024, [0.0, 0.02], 8);
    builder.add(Slot::Metal, foot.moved(x, 0.0, edge + 0.008));
    screw_handle(builder, [Slot::Metal, Slot::Metal], DVec3::new(x, high - 0.15, edge + 0.03), 0.26);
}
