//! Traditional sofas: rolled arms, buttons, camel backs, wings.

use std::f64::consts::FRAC_PI_2;

use glam::{DVec2, DVec3};

use super::Sofa;
use super::plain::slanted_feet;
use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::furniture::parts::{SPINDLE, slanted_leg};
use crate::recipes::kit::{
    Axis, Bay, Builder, Outline, SINK, Slice, cylinder, extrude, lathe, loft, rounded_box, sweep,
};

/// Rolled arms on turned feet, a tufted back, a camel back with show wood, or wings where there is one seat.
pub(super) fn traditional(sofa: &Sofa, builder: &mut Builder) {
    let (bay, seat, high) = (sofa.bay, sofa.seat, sofa.bay.high.y);
    let foot = [0.1, 0.09, 0.16, 0.03][sofa.form as usize];
    match sofa.form {
        0 | 1 => bun_feet(sofa, builder, foot),
        2 => slanted_feet(sofa, builder, Slot::WoodDark, foot, &SPINDLE),
        _ => skirt(sofa, builder, foot),
    }
    let base = foot + (seat - foot) * 0.5;
    sofa.carcass(builder, foot, base, sofa.arm);
    if sofa.form == 2 {
        let band = bay.with_y([foot - 0.004, foot + 0.028]).inset(sofa.arm * 0.5 - 0.006, 0.0, 0.003);
        builder.block(Slot::WoodDark, band, 0.006);
    }
    rolled_arms(sofa, builder, foot);
    let inner = sofa.between(sofa.arm);
    let deep = sofa.back * 0.5;
    match sofa.form {
        1 => {
            sofa.back_wall(builder, inner, [foot + 0.01, high], sofa.back * 0.86);
            tufts(sofa, builder, inner, sofa.back * 0.86);
            let roll = cylinder(sofa.back * 0.24, [inner.low.x - 0.008, inner.high.x + 0.008], 10)
                .turned_z(-FRAC_PI_2);
            builder.add(sofa.slot, roll.moved(0.0, high - sofa.back * 0.24, bay.low.z + sofa.back * 0.74));
        }
        2 => camel_back(sofa, builder, inner, foot),
        _ => {
            sofa.back_wall(builder, inner, [foot + 0.01, high - 0.045], deep);
            sofa.back_cushions(builder, inner, high, deep * 0.9);
        }
    }
    sofa.seat_cushions(builder, inner, base - SINK, 0.028);
    if sofa.seats == 1 && sofa.form != 2 {
        wings(sofa, builder);
    }
}

/// Round feet like buns, on small necks.
fn bun_feet(sofa: &Sofa, builder: &mut Builder, foot: f64) {
    let bay = sofa.bay;
    for z in [bay.low.z + 0.07, bay.high.z - 0.07] {
        let at = |y: f64| DVec3::new(bay.high.x - 0.07, y, z);
        let bun = [(0.55, 0.0), (0.95, 0.2), (1.0, 0.45), (0.6, 0.72), (0.75, 0.85), (0.7, 1.0)];
        builder.add_pair(Slot::WoodDark, slanted_leg([at(0.0), at(foot + 0.006)], 0.04, &bun, 8));
    }
}

/// A pleated skirt down to the floor.
fn skirt(sofa: &Sofa, builder: &mut Builder, foot: f64) {
    let skirt = sofa.bay.with_y([0.0, foot + sofa.seat * 0.3]).inset(0.002, 0.0, 0.002);
    let front = skirt.slab(Side::Front, 0.05);
    let count = (skirt.width() / 0.16).round().clamp(2.0, 14.0) as u32;
    builder.block(sofa.slot, skirt.without(Side::Front, 0.012), 0.006);
    for column in front.inset(0.003, 0.0, 0.0).columns(count, 0.006) {
        builder.block(sofa.slot, column.without(Side::Above, 0.004).without(Side::Below, 0.002), 0.008);
    }
}

/// Arms with a roll along their top and a scroll with a knob on their front.
fn rolled_arms(sofa: &Sofa, builder: &mut Builder, foot: f64) {
    let (bay, arm) = (sofa.bay, sofa.arm);
    let (radius, top) = (arm * 0.5, sofa.arm_top());
    let z = [bay.low.z + 0.003, bay.high.z - 0.006];
    let x = bay.high.x - radius;
    let roll = [(radius * 0.9, z[0]), (radius, z[0] + 0.012), (radius, z[1] - 0.012), (radius * 0.9, z[1])];
    builder.add_pair(sofa.slot, lathe(&roll, 14).turned_x(FRAC_PI_2).moved(x, top - radius, 0.0));
    let disc = lathe(&[(radius * 0.66, 0.0), (radius * 0.62, 0.005), (radius * 0.24, 0.0058)], 10);
    let slot = if sofa.form == 2 { Slot::WoodDark } else { sofa.slot };
    builder.add_pair(slot, disc.turned_x(FRAC_PI_2).moved(x, top - radius, z[1] - SINK));
    let wall = Bay::new(
        [x - radius * 0.62, x + radius * 0.62],
        [foot + 0.012, top - radius],
        [z[0] + 0.001, z[1] - 0.003],
    );
    builder.add_pair(sofa.slot, rounded_box(wall, DVec3::splat(0.012), 1));
}

/// Buttons in a diamond pattern with soft squares between them on the front of the back.
fn tufts(sofa: &Sofa, builder: &mut Builder, inner: Bay, deep: f64) {
    let z = sofa.bay.low.z + deep;
    let (low, high) = (sofa.seat + 0.05, sofa.bay.high.y - sofa.back * 0.5);
    let columns = (inner.width() / 0.3).round().clamp(2.0, 6.0) as u32;
    let field = inner.with_y([low, high]);
    for (row, band) in field.rows(2, 0.006).into_iter().enumerate() {
        for (index, cell) in band.columns(columns, 0.006).into_iter().enumerate() {
            let half = cell.extent() / 2.0;
            let slices = [
                Slice::new(-0.01, half.x, half.y).softened(0.02),
                Slice::new(0.004, half.x, half.y).softened(0.02),
                Slice::new(0.016, half.x * 0.72, half.y * 0.72).softened(0.02),
                Slice::new(0.02, half.x * 0.3, half.y * 0.3).softened(0.01),
            ];
            let pad = loft(&Outline::Soft(1), &slices).smooth(60.0).turned_x(FRAC_PI_2);
            builder.add(sofa.slot, pad.moved(cell.center().x, cell.center().y, z));
            if row == 0 && index > 0 {
                let button = lathe(&[(0.014, -0.004), (0.014, 0.012), (0.007, 0.018)], 5).turned_x(FRAC_PI_2);
                builder.add(Slot::WoodDark, button.moved(cell.low.x - 0.003, band.high.y + 0.003, z));
            }
        }
    }
}

/// One long back whose top swings up to the middle under a wooden rail.
fn camel_back(sofa: &Sofa, builder: &mut Builder, inner: Bay, foot: f64) {
    let (half, high, low) = (inner.width() / 2.0 + 0.01, sofa.bay.high.y, sofa.arm_top() + 0.02);
    let swing = |share: f64| low + (high - low) * (0.5 + 0.5 * libm::cos(share * std::f64::consts::PI));
    let shares = [-1.0, -0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 0.75, 1.0];
    let mut profile: Vec<DVec2> =
        shares.iter().map(|&share| DVec2::new(share * half, swing(share) - 0.02)).collect();
    profile.extend([DVec2::new(half, foot + 0.02), DVec2::new(-half, foot + 0.02)]);
    let z = sofa.bay.low.z;
    builder.add(sofa.slot, extrude(&profile, Axis::Z, [z + 0.006, z + sofa.back * 0.75]));
    let rail: Vec<DVec3> =
        shares.iter().map(|&share| DVec3::new(share * half, swing(share) - 0.016, z + 0.028)).collect();
    builder.add(Slot::WoodDark, sweep(&rail, 0.018, 6));
}

/// The wings of a grandfather chair: beside the back, within its depth.
fn wings(sofa: &Sofa, builder: &mut Builder) {
    let bay = sofa.bay;
    let wing = bay
        .slab(Side::Right, sofa.arm * 0.62)
        .slab(Side::Back, 0.235)
        .with_y([sofa.arm_top() - 0.03, bay.high.y - 0.012]);
    builder.add_pair(
        sofa.slot,
        rounded_box(
            wing.moved(-sofa.arm * 0.1, 0.0, 0.0).without(Side::Back, 0.004),
            DVec3::new(0.03, 0.05, 0.05),
            2,
        ),
    );
}
