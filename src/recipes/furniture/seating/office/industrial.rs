//! Industrial swivel chairs: machinists' chairs on four legs of steel, planks and perforated sheet on castors.

use glam::DVec3;

use super::{ARM_RISE, HUB, Spokes, Swivel, flat_bar};
use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::furniture::parts::turned_forward;
use crate::recipes::furniture::seating::depth_slats;
use crate::recipes::kit::{Bay, Builder, cuboid, cylinder, lathe, sweep};

/// Metres of a back rest on a flat spring: 0.12 to 0.16 are usual.
const REST: f64 = 0.15;

/// A screw with a hand wheel's hub between legs and seat.
fn screw(chair: &Swivel, builder: &mut Builder) {
    let high = chair.under();
    builder.add(Slot::Metal, cylinder(0.016, [high * 0.55, high + 0.03], 8));
    let nut = [(0.03, high - 0.07), (0.045, high - 0.05), (0.045, high - 0.02), (0.03, high)];
    builder.add(Slot::MetalDark, lathe(&nut, 8));
}

/// A round seat of wood, and a rest of bent sheet on a flat spring, as at lathes and drawing boards.
pub(super) fn machinist(chair: &Swivel, builder: &mut Builder) {
    chair.four_legs(builder, Slot::MetalDark, 0.017);
    screw(chair, builder);
    round_seat(chair, builder, Slot::Wood);
    rest(chair, builder, Slot::Metal);
}

/// The same with leather.
pub(super) fn leather_stool(chair: &Swivel, builder: &mut Builder) {
    chair.four_legs(builder, Slot::MetalDark, 0.015);
    screw(chair, builder);
    round_seat(chair, builder, Slot::Leather);
    rest(chair, builder, Slot::Leather);
}

/// A dished round seat on a plate.
fn round_seat(chair: &Swivel, builder: &mut Builder, slot: Slot) {
    let radius = chair.half * 0.66;
    let is_soft = slot == Slot::Leather;
    let rise = if is_soft { 0.0 } else { -0.008 };
    let low = chair.under() + 0.024;
    let profile = [
        (radius * 0.9, low),
        (radius, low + 0.012),
        (radius, chair.seat - 0.014),
        (radius * 0.93, chair.seat - 0.002),
        (radius * 0.4, chair.seat + rise),
    ];
    builder.add(slot, lathe(&profile, 16));
    builder.add(Slot::MetalDark, lathe(&[(radius * 0.4, low - 0.008), (radius * 0.8, low + 0.002)], 12));
}

/// A rest across the back on a flat spring from under the seat.
fn rest(chair: &Swivel, builder: &mut Builder, slot: Slot) {
    let (y, high) = (chair.under() + 0.008, chair.bay.high.y);
    let heel = chair.lean(chair.seat) - 0.04;
    let top = DVec3::new(0.0, high - REST * 0.4, chair.lean(high) - 0.006);
    let spring = [DVec3::new(0.0, y, 0.0), DVec3::new(0.0, y, heel)];
    builder.cuboid(
        Slot::MetalDark,
        Bay::new([-0.019, 0.019], [y - 0.004, y + 0.004], [heel - 0.004, spring[0].z]),
    );
    builder.add(Slot::MetalDark, flat_bar([spring[1], top], 0.036, 0.007));
    let share = REST / (high - chair.seat);
    let profile = [(1.0 - share, 0.5), (1.0 - share * 0.75, 0.62), (1.0 - share * 0.2, 0.62), (0.997, 0.5)];
    let thickness = if slot == Slot::Leather { 0.032 } else { 0.006 };
    builder.add(slot, chair.back(&profile, thickness, 0.05).moved(0.0, 0.0, thickness * 0.5));
    for rise in [0.3, 0.7] {
        let y = high - REST * rise;
        let bolt = turned_forward(lathe(&[(0.009, 0.0), (0.009, 0.006), (0.005, 0.009)], 6));
        builder.add(Slot::Metal, bolt.moved(0.0, y, chair.lean(y) + thickness * 0.9));
    }
}

/// Planks on a frame of square tube, on castors of iron.
pub(super) fn planks(chair: &Swivel, builder: &mut Builder) {
    tube_frame(chair, builder);
    let seat = chair.seat_bay(0.028, 0.84);
    for plank in depth_slats(seat, 3, 0.006) {
        builder.block(Slot::Wood, plank, 0.005);
    }
    for rise in [0.42, 0.66, 0.9] {
        let y = chair.rise(rise);
        let middle = DVec3::new(0.0, y, chair.lean(y) + 0.016);
        let plank = Bay::around(middle, chair.half * 1.56, chair.rise(0.2) - chair.seat, 0.022);
        builder.block(Slot::Wood, plank, 0.005);
    }
}

/// Perforated sheet in the same frame.
pub(super) fn perforated(chair: &Swivel, builder: &mut Builder) {
    tube_frame(chair, builder);
    let seat = chair.seat_bay(0.012, 0.84);
    builder.block(Slot::Metal, seat, 0.005);
    holes(builder, seat.inset(0.05, 0.0, 0.05), true);
    let (low, high) = (chair.rise(0.3), chair.rise(0.97));
    let sheet = Bay::around(
        DVec3::new(0.0, (low + high) / 2.0, chair.lean(low) + 0.004),
        chair.half * 1.5,
        high - low,
        0.008,
    );
    builder.block(Slot::Metal, sheet, 0.003);
    holes(builder, sheet.inset(0.06, 0.06, 0.0), false);
}

/// Rows of slots in a sheet, as dark strips on it.
fn holes(builder: &mut Builder, field: Bay, is_level: bool) {
    let strips = if is_level {
        depth_slats(field.slab(Side::Above, 0.004).moved(0.0, 0.001, 0.0), 5, field.depth() * 0.12)
    } else {
        field.slab(Side::Front, 0.004).moved(0.0, 0.0, 0.001).rows(5, field.height() * 0.12)
    };
    for strip in strips {
        builder.cuboid(Slot::MetalDark, strip);
    }
}

/// Posts of tube that bend from under the seat up behind the back, and arm rests of the same tube.
fn tube_frame(chair: &Swivel, builder: &mut Builder) {
    let tube = 0.014;
    chair.spokes(builder, &Spokes { slot: Slot::MetalDark, wheel: Slot::Metal, count: 5, thickness: 0.018 });
    builder.add(Slot::MetalDark, cylinder(0.03, [HUB - 0.03, HUB + 0.04], 8));
    builder.add(Slot::Metal, cylinder(0.02, [HUB, chair.under() + 0.01], 8));
    let (x, y) = (chair.half * 0.6, chair.seat - 0.045);
    let top = chair.bay.high.y - tube * 0.6;
    let post = [
        DVec3::new(x, y, chair.half * 0.7),
        DVec3::new(x, y, chair.lean(chair.seat) - 0.016),
        DVec3::new(x, top, chair.lean(top) - 0.006),
    ];
    builder.add_pair(Slot::MetalDark, sweep(&post, tube, 4));
    for z in [-0.36, 0.5] {
        let bar = Bay::around(DVec3::new(0.0, y - 0.004, z * chair.half), x * 2.0, 0.02, 0.03);
        builder.cuboid(Slot::MetalDark, bar);
    }
    let (out, rest) = (chair.bay.high.x - tube, chair.seat + ARM_RISE);
    let arm = [
        DVec3::new(x, y, chair.half * 0.4),
        DVec3::new(out, y + 0.02, chair.half * 0.4),
        DVec3::new(out, rest, chair.half * 0.4),
        DVec3::new(out, rest, chair.lean(rest) * 0.8),
        DVec3::new(x, rest, chair.lean(rest) - 0.01),
    ];
    builder.add_pair(Slot::MetalDark, sweep(&arm, tube * 0.9, 4));
    let pad = Bay::around(DVec3::new(out, rest + 0.014, chair.half * 0.02), 0.036, 0.022, chair.half * 0.6);
    builder.add_pair(Slot::Wood, cuboid(pad));
}
