//! Plain modern sofas: box arms, slim arms, a shell on a steel base, loose cushions in a wooden frame.

use std::f64::consts::FRAC_PI_2;

use glam::DVec3;

use super::Sofa;
use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::furniture::parts::{CONE, slanted_leg};
use crate::recipes::kit::{Bay, Builder, SINK, pillow, sweep};

/// Plain modern: box arms, slim arms on wooden legs, a shell on a steel base, or a wooden frame with loose cushions.
pub(super) fn plain(sofa: &Sofa, builder: &mut Builder) {
    let (bay, seat) = (sofa.bay, sofa.seat);
    let high = bay.high.y;
    if sofa.form == 3 {
        wooden_frame(sofa, builder);
        return;
    }
    let arm = [1.0, 0.5, 0.72][sofa.form as usize] * sofa.arm;
    let foot = [0.05, 0.15, 0.12][sofa.form as usize];
    let inner = sofa.between(arm);
    match sofa.form {
        0 => {
            let plinth = bay.with_y([0.0, foot + SINK]).inset(0.04, 0.0, 0.05);
            builder.cuboid(Slot::WoodDark, plinth);
        }
        1 => slanted_feet(sofa, builder, Slot::Wood, foot, &CONE),
        _ => {
            for side in [Side::Left, Side::Right] {
                let x = if side == Side::Left { bay.low.x + 0.09 } else { bay.high.x - 0.09 };
                let z = [bay.low.z + 0.08, bay.high.z - 0.08];
                let path = [(foot + 0.01, 0), (0.008, 0), (0.008, 1), (foot + 0.01, 1)]
                    .map(|(y, end)| DVec3::new(x, y, z[end]));
                builder.add(Slot::MetalDark, sweep(&path, 0.011, 4));
            }
        }
    }
    let base = foot + (seat - foot) * 0.45;
    sofa.carcass(builder, foot, base, arm);
    for side in [Side::Left, Side::Right] {
        let top = [sofa.arm_top(), sofa.arm_top(), high * 0.72][sofa.form as usize].min(bay.height() * 0.77);
        builder.cushion(
            sofa.slot,
            bay.slab(side, arm).with_y([foot + 0.004, top]).without(Side::Back, 0.002),
            [0.025, 0.02, 0.045][sofa.form as usize],
        );
    }
    let wall = sofa.back * 0.42;
    let wall_top = if sofa.form == 2 { high * 0.99 } else { high - 0.05 };
    sofa.back_wall(builder, inner, [foot + 0.01, wall_top], wall);
    sofa.seat_cushions(builder, inner, base - SINK, if sofa.form == 1 { 0.012 } else { 0.02 });
    sofa.back_cushions(builder, inner, high, wall);
    throw_pillows(sofa, builder, inner);
}

/// Round slanted legs under the corners.
pub(super) fn slanted_feet(
    sofa: &Sofa,
    builder: &mut Builder,
    slot: Slot,
    foot: f64,
    profile: &[(f64, f64)],
) {
    let bay = sofa.bay;
    for (z, inwards) in [(bay.low.z, 1.0), (bay.high.z, -1.0)] {
        let at = |y: f64, off: f64| DVec3::new(bay.high.x - off, y, z + inwards * off);
        builder.add_pair(slot, slanted_leg([at(0.0, 0.035), at(foot + 0.01, 0.075)], 0.024, profile, 8));
    }
    if sofa.seats > 2 {
        let at = |y: f64| DVec3::new(0.0, y, bay.high.z - 0.09);
        builder.add(slot, slanted_leg([at(0.0), at(foot + 0.01)], 0.022, profile, 8));
    }
}

/// Loose cushions in a frame of round wood with flat arm rests.
fn wooden_frame(sofa: &Sofa, builder: &mut Builder) {
    let (bay, seat, high) = (sofa.bay, sofa.seat, sofa.bay.high.y);
    let arm = 0.06;
    let inner = sofa.between(arm);
    let rest = sofa.arm_top();
    for side in [-1.0, 1.0] {
        let x = side * (bay.high.x - arm * 0.5);
        let at = |y: f64, z: f64| DVec3::new(x, y, z);
        let front = [at(0.0, bay.high.z - 0.04), at(rest - 0.01, bay.high.z - 0.07)];
        let hind = [at(0.0, bay.low.z + 0.03), at(rest - 0.01, bay.low.z + 0.16)];
        for ends in [front, hind] {
            builder.add(Slot::Wood, slanted_leg(ends, 0.021, &[(0.7, 0.0), (1.0, 0.6), (0.8, 1.0)], 8));
        }
        let pad =
            Bay::new([x - arm * 0.5, x + arm * 0.5], [rest - 0.022, rest], [bay.low.z + 0.1, bay.high.z]);
        builder.rounded(Slot::Wood, pad, DVec3::new(0.02, 0.01, 0.03), 2);
        builder.add(
            Slot::Wood,
            sweep(&[at(seat * 0.62, bay.high.z - 0.05), at(seat * 0.56, bay.low.z + 0.06)], 0.019, 6),
        );
    }
    for (y, z) in [(seat * 0.63, bay.high.z - 0.06), (seat * 0.57, bay.low.z + 0.1)] {
        builder.block(Slot::Wood, Bay::around(DVec3::new(0.0, y, z), bay.width() - arm, 0.055, 0.025), 0.005);
    }
    let slats = (inner.width() / 0.12).round().clamp(3.0, 20.0) as u32;
    for column in inner.inset(0.04, 0.0, 0.0).columns(slats, inner.width() / f64::from(slats) * 0.75) {
        let x = column.center().x;
        let path =
            [DVec3::new(x, seat * 0.6, bay.low.z + 0.1), DVec3::new(x, high - 0.06, bay.low.z + 0.018)];
        builder.add(Slot::Wood, sweep(&path, 0.009, 4));
    }
    let rail = Bay::new(
        inner.inset(-arm * 0.6, 0.0, 0.0).x(),
        [high - 0.09, high - 0.03],
        [bay.low.z, bay.low.z + 0.026],
    );
    builder.block(Slot::Wood, rail, 0.006);
    sofa.seat_cushions(builder, inner, seat * 0.66, 0.012);
    sofa.back_cushions(builder, inner, high, 0.04);
}

/// A loose pillow or two against the back.
fn throw_pillows(sofa: &Sofa, builder: &mut Builder, inner: Bay) {
    if sofa.seats == 1 {
        return;
    }
    let side = 0.42_f64.min(inner.width() * 0.3);
    let lean = |x: f64, turn: f64, slot: Slot, builder: &mut Builder| {
        let soft = pillow(side, 0.13, side).turned_x(FRAC_PI_2 - 0.42).turned_y(turn);
        builder.add(slot, soft.moved(x, sofa.seat + side * 0.45, sofa.bay.low.z + sofa.back + side * 0.26));
    };
    let x = inner.high.x - side * 0.55;
    lean(x, -0.25, Slot::FabricAccent, builder);
    if sofa.form != 1 {
        lean(-x, 0.2, Slot::FabricLight, builder);
    }
}
