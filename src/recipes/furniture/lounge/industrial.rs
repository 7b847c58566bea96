//! Industrial sofas: leather cushions in frames of pipe and square tube, planks, pallets.

use std::f64::consts::FRAC_PI_2;

use glam::DVec3;

use super::Sofa;
use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::kit::{Bay, Builder, SINK, cylinder, pipe, sweep};

/// Leather cushions on a frame of pipe, of square tube, of planks, or on pallets.
pub(super) fn industrial(sofa: &Sofa, builder: &mut Builder) {
    let (bay, high) = (sofa.bay, sofa.bay.high.y);
    let inner = sofa.between(0.055);
    match sofa.form {
        0 => pipe_frame(sofa, builder),
        1 => box_frame(sofa, builder),
        2 => plank_sides(sofa, builder),
        _ => {
            pallets(sofa, builder);
            let cushions = bay.inset(0.012, 0.0, 0.0);
            sofa.seat_cushions(builder, cushions.without(Side::Front, 0.01), sofa.seat * 0.6, 0.022);
            sofa.back_cushions(builder, cushions, high, 0.03);
            return;
        }
    }
    sofa.seat_cushions(builder, inner, sofa.seat * 0.58, 0.02);
    sofa.back_cushions(builder, inner, high - 0.012, sofa.back * 0.2);
    let deck = inner.inset(0.004, 0.0, 0.034).with_y([sofa.seat * 0.58 - 0.03, sofa.seat * 0.58 + 0.003]);
    builder.block(Slot::MetalDark, deck, 0.005);
    let straps = (inner.width() / 0.3).round().clamp(2.0, 8.0) as u32;
    for column in inner.inset(0.05, 0.0, 0.0).columns(straps, inner.width() / f64::from(straps) * 0.6) {
        let strap = column.slab(Side::Back, sofa.back * 0.22).with_y([sofa.seat * 0.5, high - 0.04]);
        builder.cuboid(
            if sofa.form == 1 { Slot::MetalDark } else { Slot::Leather },
            strap.without(Side::Back, sofa.back * 0.1),
        );
    }
}

/// Hoops of pipe as arms, and a rail of pipe behind.
fn pipe_frame(sofa: &Sofa, builder: &mut Builder) {
    let bay = sofa.bay;
    let radius = 0.02;
    let x = bay.high.x - radius;
    let top = sofa.arm_top() - radius;
    let z = [bay.low.z + 0.04, bay.high.z - radius];
    let hoop = [(0.0, 0), (top, 0), (top, 1), (0.0, 1)].map(|(y, end)| DVec3::new(x, y, z[end]));
    builder.add_pair(Slot::MetalDark, pipe(&hoop, radius, 0.07));
    let rail = [DVec3::new(x, sofa.seat * 0.5, z[1] - 0.01), DVec3::new(x, sofa.seat * 0.5, z[0])];
    builder.add_pair(Slot::MetalDark, sweep(&rail, radius * 0.8, 6));
    for (y, z) in [(sofa.seat * 0.5, z[1] - 0.035), (sofa.seat * 0.5, z[0] + 0.03)] {
        builder.add(Slot::MetalDark, sweep(&[DVec3::new(-x, y, z), DVec3::new(x, y, z)], radius * 0.8, 6));
    }
    let high = bay.high.y - radius;
    let back = [(x - 0.03, top - 0.1), (x - 0.03, high), (-x + 0.03, high), (-x + 0.03, top - 0.1)]
        .map(|(x, y)| DVec3::new(x, y, bay.low.z + radius));
    builder.add(Slot::MetalDark, pipe(&back, radius, 0.07));
    for y in [0.02, top * 0.55] {
        let flange = cylinder(radius * 1.5, [y - 0.008, y + 0.008], 8);
        for z in z {
            builder.add_pair(Slot::Metal, flange.clone().moved(x, 0.0, z));
        }
    }
}

/// A cage of square tube.
fn box_frame(sofa: &Sofa, builder: &mut Builder) {
    let bay = sofa.bay;
    let (tube, top) = (0.035, sofa.arm_top());
    for side in [Side::Left, Side::Right] {
        let frame = bay.slab(side, tube).with_y([0.0, top]);
        for end in [Side::Front, Side::Back] {
            builder.cuboid(Slot::MetalDark, frame.slab(end, tube).without(Side::Above, 0.03 - SINK));
        }
        builder.block(Slot::Wood, frame.slab(Side::Above, 0.03), 0.004);
        for y in [0.03, sofa.seat * 0.45] {
            builder.cuboid(Slot::MetalDark, frame.with_y([y, y + tube]).inset(0.003, 0.0, tube - SINK));
        }
    }
    let across = bay
        .inset(tube - SINK, 0.0, 0.003)
        .with_y([sofa.seat * 0.45, sofa.seat * 0.45 + tube])
        .inset(0.0, 0.002, 0.0);
    for end in [Side::Front, Side::Back] {
        builder.cuboid(Slot::MetalDark, across.slab(end, tube));
    }
    let posts = bay.inset(tube + 0.01, 0.0, 0.0).slab(Side::Back, tube * 0.8).with_y([0.1, bay.high.y]);
    builder.cuboid(Slot::MetalDark, posts.with_y([bay.high.y - tube, bay.high.y]));
    for side in [Side::Left, Side::Right] {
        builder.cuboid(
            Slot::MetalDark,
            posts.slab(side, tube).with_y([sofa.seat * 0.4, bay.high.y - 0.004]).inset(0.003, 0.0, 0.005),
        );
    }
}

/// Sides of planks on castors, held by angles.
fn plank_sides(sofa: &Sofa, builder: &mut Builder) {
    let bay = sofa.bay;
    let top = sofa.arm_top();
    for side in [Side::Left, Side::Right] {
        let wall = bay.slab(side, 0.05).with_y([0.09, top]);
        for row in wall.rows(3, 0.008) {
            builder.block(Slot::Wood, row, 0.005);
        }
        for end in [Side::Front, Side::Back] {
            let iron = wall.inset(0.004, 0.02, 0.06).slab(end, 0.04);
            builder.cuboid(Slot::MetalDark, iron.inset(-0.006, 0.0, 0.0));
            let wheel = cylinder(0.045, [-0.015, 0.015], 10).turned_z(FRAC_PI_2);
            let at = iron.center();
            builder.add(Slot::Rubber, wheel.moved(at.x, 0.045, at.z));
            builder.cuboid(Slot::Metal, Bay::around(DVec3::new(at.x, 0.068, at.z), 0.04, 0.048, 0.02));
        }
    }
    let back = bay.inset(0.045, 0.0, 0.0).slab(Side::Back, 0.03).with_y([0.12, bay.high.y - 0.006]);
    for row in back.rows(4, 0.01) {
        builder.block(Slot::Wood, row, 0.005);
    }
    let front =
        bay.inset(0.045, 0.0, 0.0).with_y([sofa.seat * 0.35, sofa.seat * 0.56]).slab(Side::Front, 0.03);
    builder.block(Slot::Wood, front.moved(0.0, 0.0, -0.006), 0.005);
}

/// Two pallets over each other and one behind.
fn pallets(sofa: &Sofa, builder: &mut Builder) {
    let bay = sofa.bay;
    let deck = sofa.seat * 0.6 + SINK;
    let stack = bay.with_y([0.0, deck]).without(Side::Back, 0.03);
    for pallet in stack.rows(2, 0.003) {
        let board = pallet.height() * 0.16;
        for slat in super::super::seating::depth_slats(pallet.slab(Side::Above, board), 4, 0.03) {
            builder.block(Slot::WoodLight, slat, 0.003);
        }
        for block in pallet.without(Side::Above, board - SINK).columns(3, pallet.width() * 0.34) {
            builder.cuboid(Slot::WoodLight, block.inset(0.0, 0.0, 0.004).without(Side::Below, board));
        }
        for slat in super::super::seating::depth_slats(
            pallet.slab(Side::Below, board + SINK),
            3,
            pallet.depth() * 0.2,
        ) {
            builder.cuboid(Slot::WoodLight, slat.inset(0.001, 0.0, 0.0));
        }
    }
    let back = bay.slab(Side::Back, 0.0305).with_y([0.02, bay.high.y - 0.03]);
    for row in back.rows(5, 0.035) {
        builder.block(Slot::WoodLight, row, 0.003);
    }
    for column in back.inset(0.03, 0.0, 0.004).columns(3, back.width() * 0.38) {
        builder.cuboid(Slot::WoodLight, column.inset(0.0, 0.004, 0.0));
    }
}
