//! Traditional swivel chairs: a banker's chair of turned wood, a director's chair in buttoned leather.

use glam::DVec3;

use super::{ARM_RISE, HUB, Spokes, Swivel, flat_bar};
use crate::recipes::Slot;
use crate::recipes::furniture::parts::{SPINDLE, bowed_board, slanted_leg, turned_forward};
use crate::recipes::kit::{Bay, Builder, crowned, lathe, pipe, sweep};

/// Metres of a bent arm rail's radius.
const RAIL: f64 = 0.019;

/// Four wooden spokes at the corners and an iron screw in a turned collar.
fn wooden_foot(chair: &Swivel, builder: &mut Builder, slot: Slot, castor: Slot) {
    chair.spokes(builder, &Spokes { slot, wheel: castor, count: 4, thickness: 0.026 });
    let high = chair.under() - 0.004;
    let collar = [
        (0.03, HUB - 0.045),
        (0.05, HUB - 0.02),
        (0.05, HUB + 0.03),
        (0.034, HUB + 0.06),
        (0.04, HUB + 0.1),
        (0.026, HUB + 0.115),
    ];
    builder.add(slot, lathe(&collar, 8));
    builder.add(Slot::MetalDark, lathe(&[(0.017, HUB + 0.1), (0.017, high - 0.03), (0.07, high)], 8));
}

/// A bow of wood from one arm rest around the back to the other; gives its height.
fn arm_bow(chair: &Swivel, builder: &mut Builder, slot: Slot) -> f64 {
    let y = chair.seat + ARM_RISE + 0.01;
    let x = chair.bay.high.x - RAIL;
    let back = chair.lean(y) - 0.004;
    let front = chair.half * 0.5;
    let path = [
        DVec3::new(-x * 0.97, y, front),
        DVec3::new(-x, y, back * 0.35),
        DVec3::new(-x * 0.62, y, back),
        DVec3::new(x * 0.62, y, back),
        DVec3::new(x, y, back * 0.35),
        DVec3::new(x * 0.97, y, front),
    ];
    builder.add(slot, pipe(&path, RAIL, 0.09));
    for z in [0.42, 0.02] {
        let top = DVec3::new(x * 0.985, y, chair.half * z);
        let foot = DVec3::new(chair.half * 0.74, chair.seat - 0.015, chair.half * z * 0.95);
        builder.add_pair(slot, slanted_leg([foot, top], 0.014, &SPINDLE, 6));
    }
    y
}

/// A saddle seat, spindles through a bent arm rail up to a bowed crest.
pub(super) fn spindle_back(chair: &Swivel, builder: &mut Builder) {
    let slot = Slot::Wood;
    wooden_foot(chair, builder, slot, Slot::MetalDark);
    builder.add(slot, crowned(chair.seat_bay(0.045, 0.86), 0.025, 0.012));
    arm_bow(chair, builder, slot);
    let crest = crest(chair, builder, slot, 0.075);
    for step in -3_i32..=3 {
        let across = f64::from(step) / 3.0 * chair.half;
        let foot = DVec3::new(across * 0.56, chair.seat - 0.012, chair.lean(chair.seat) + 0.012);
        let top = DVec3::new(across * 0.7, crest, chair.lean(crest) + 0.006);
        let thick = if step.abs() == 3 { 0.014 } else { 0.009 };
        builder.add(slot, slanted_leg([foot, top], thick, &[(0.7, 0.0), (1.2, 0.4), (0.65, 1.0)], 6));
    }
}

/// A board along the top, bowed backwards; gives the height of its middle.
fn crest(chair: &Swivel, builder: &mut Builder, slot: Slot, tall: f64) -> f64 {
    let y = chair.bay.high.y - tall / 2.0;
    let middle = DVec3::new(0.0, y, chair.lean(y) + 0.002);
    builder.add(slot, bowed_board(middle, DVec3::new(chair.half * 1.56, tall, 0.024), 0.022));
    y
}

/// The same with broad slats, and a leather pad on the seat.
pub(super) fn slat_back(chair: &Swivel, builder: &mut Builder) {
    let slot = Slot::WoodDark;
    wooden_foot(chair, builder, slot, Slot::MetalDark);
    builder.block(slot, chair.seat_bay(0.035, 0.86).moved(0.0, -0.012, 0.0), 0.008);
    builder.add(Slot::Leather, crowned(chair.seat_bay(0.03, 0.8).inset(0.0, 0.0, 0.012), 0.014, 0.012));
    arm_bow(chair, builder, slot);
    let crest = crest(chair, builder, slot, 0.1);
    for (across, wide) in [(0.0, 0.16), (0.4, 0.09)] {
        let foot = DVec3::new(across * chair.half * 0.9, chair.seat - 0.02, chair.lean(chair.seat) + 0.01);
        let top = DVec3::new(foot.x, crest, chair.lean(crest) + 0.004);
        let slat = flat_bar([foot, top], wide * chair.half * 2.0, 0.013);
        if across > 0.0 {
            builder.add_pair(slot, slat);
        } else {
            builder.add(slot, slat);
        }
    }
}

/// Deep leather with rows of buttons, nailed on a frame; scrolled arm rests.
pub(super) fn buttoned(chair: &Swivel, builder: &mut Builder) {
    wooden_foot(chair, builder, Slot::WoodDark, Slot::Brass);
    upholstery(chair, builder, Slot::Leather, 0.062);
    for (row, rise) in [0.34, 0.54, 0.74].into_iter().enumerate() {
        let count = 3 - row as i32 % 2;
        for step in 0..count {
            let across = (f64::from(step) - f64::from(count - 1) / 2.0) * 0.42 * chair.half;
            let y = chair.rise(rise);
            let button = lathe(&[(0.012, -0.02), (0.012, 0.002), (0.006, 0.006)], 6);
            builder.add(Slot::Brass, turned_forward(button).moved(across, y, chair.lean(y) + 0.03));
        }
    }
    scrolled_arms(chair, builder, true);
}

/// Seat and back of a director's chair, in a rim of wood.
fn upholstery(chair: &Swivel, builder: &mut Builder, slot: Slot, deep: f64) {
    let rim = chair.seat_bay(0.05, 0.86).moved(0.0, -0.045, 0.0);
    builder.block(Slot::WoodDark, rim, 0.008);
    builder.add(slot, crowned(chair.seat_bay(0.075, 0.82).inset(0.0, 0.0, 0.008), 0.03, 0.03));
    let pad = [(0.06, 0.62), (0.12, 0.68), (0.5, 0.74), (0.84, 0.72), (0.94, 0.6)];
    builder.add(slot, chair.back(&pad, deep, 0.006));
    let outer = [(-0.08, 0.56), (0.1, 0.7), (0.5, 0.78), (0.86, 0.76), (0.97, 0.58), (0.995, 0.2)];
    builder.add(Slot::WoodDark, chair.back(&outer, 0.022, 0.0).moved(0.0, 0.0, -0.006));
}

/// Arm rests that sweep down before the seat, padded where asked for.
fn scrolled_arms(chair: &Swivel, builder: &mut Builder, is_padded: bool) {
    let (x, top) = (chair.bay.high.x - 0.022, chair.seat + ARM_RISE);
    let arm = [
        DVec3::new(chair.half * 0.7, top + 0.05, chair.lean(top) + 0.006),
        DVec3::new(x, top - 0.01, -chair.half * 0.3),
        DVec3::new(x, top - 0.012, chair.half * 0.4),
        DVec3::new(x * 0.98, top - 0.07, chair.half * 0.52),
        DVec3::new(x * 0.92, chair.seat - 0.05, chair.half * 0.3),
    ];
    builder.add_pair(Slot::WoodDark, pipe(&arm, 0.0215, 0.05));
    if is_padded {
        let pad = Bay::around(DVec3::new(x, top + 0.012, chair.half * 0.06), 0.05, 0.03, chair.half * 0.6);
        builder.add_pair(Slot::Leather, crowned(pad, 0.012, 0.008));
    }
}

/// A flat padded back in a frame with turned posts, open arm rests.
pub(super) fn framed_back(chair: &Swivel, builder: &mut Builder) {
    wooden_foot(chair, builder, Slot::WoodDark, Slot::Brass);
    let slot = Slot::FabricAccent;
    builder.block(Slot::WoodDark, chair.seat_bay(0.05, 0.86).moved(0.0, -0.03, 0.0), 0.008);
    builder.add(slot, crowned(chair.seat_bay(0.06, 0.8).inset(0.0, 0.0, 0.012), 0.026, 0.02));
    builder.add(slot, chair.back(&[(0.16, 0.54), (0.2, 0.6), (0.74, 0.6), (0.8, 0.52)], 0.036, 0.004));
    let crest = crest(chair, builder, Slot::WoodDark, 0.09);
    for rise in [0.1, 0.84] {
        let y = chair.rise(rise);
        let x = chair.half * 0.66;
        let rail = [DVec3::new(-x, y, chair.lean(y)), DVec3::new(x, y, chair.lean(y))];
        builder.add(Slot::WoodDark, sweep(&rail, 0.018, 4));
    }
    let post = [
        DVec3::new(chair.half * 0.66, chair.seat - 0.04, chair.lean(chair.seat)),
        DVec3::new(chair.half * 0.68, crest, chair.lean(crest)),
    ];
    let turned = [(1.0, 0.0), (0.8, 0.1), (1.15, 0.3), (0.75, 0.36), (1.1, 0.6), (0.75, 0.9), (0.9, 1.0)];
    builder.add_pair(Slot::WoodDark, slanted_leg(post, 0.02, &turned, 8));
    scrolled_arms(chair, builder, false);
}
