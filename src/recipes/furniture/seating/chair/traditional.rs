//! Traditional chairs: turned legs, spindles, splats, ladders.

use glam::{DVec2, DVec3};

use super::plain::stretchers;
use super::{BACK_DEPTH, Chair};
use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::furniture::parts::{SPINDLE, bowed_board, slanted_leg};
use crate::recipes::kit::{Axis, Bay, Builder, Station, crowned, cuboid, extrude, lathe, sheet, sweep};

/// A saddle seat, slanted turned legs with an H of stretchers, and spindles under a bent crest.
pub(super) fn spindle_back(chair: &Chair, builder: &mut Builder) {
    builder.add(Slot::Wood, crowned(chair.seat_bay(0.042), 0.02, 0.01));
    chair.slanted_legs(builder, Slot::Wood, 0.022, &SPINDLE);
    let y = chair.seat * 0.38;
    builder.add_pair(
        Slot::Wood,
        slanted_leg(
            [chair.at(0.9, y - 0.001, 0.1), chair.at(0.9, y + 0.02, 0.92)],
            0.011,
            &[(0.8, 0.0), (0.8, 1.0)],
            6,
        ),
    );
    builder.add(Slot::Wood, sweep(&[chair.at(-0.9, y + 0.01, 0.5), chair.at(0.9, y + 0.01, 0.5)], 0.01, 6));
    let high = chair.bay.high.y;
    let crest = high - 0.045;
    builder.add(
        Slot::Wood,
        bowed_board(
            DVec3::new(0.0, crest, chair.lean(high) + 0.016),
            DVec3::new(chair.half * 1.98, 0.09, 0.022),
            -0.022,
        ),
    );
    for step in -3_i32..=3 {
        let across = f64::from(step) / 3.0;
        let foot =
            DVec3::new(across * chair.half * 0.74, chair.seat - 0.012, chair.bay.low.z + BACK_DEPTH - 0.022);
        let top = DVec3::new(across * chair.half * 0.86, crest, chair.lean(high) + 0.014);
        let thick = if step.abs() == 3 { 0.013 } else { 0.008 };
        let spindle = [(0.7, 0.0), (1.25, 0.35), (1.25, 0.42), (0.6, 1.0)];
        builder.add(Slot::Wood, slanted_leg([foot, top], thick, &spindle, 6));
    }
}

/// Posts that go on as hind legs, leaning as the back does.
pub(super) fn back_posts(chair: &Chair, builder: &mut Builder, slot: Slot, width: f64, high: f64) {
    let corner = |z: f64, y: f64| DVec2::new(chair.bay.low.z + z, y);
    let profile = [
        corner(0.004, 0.0),
        corner(0.032, 0.0),
        corner(BACK_DEPTH, chair.seat - 0.05),
        corner(BACK_DEPTH - 0.006, chair.seat),
        corner(0.026, high),
        corner(0.0, high),
        corner(BACK_DEPTH - 0.038, chair.seat),
        corner(BACK_DEPTH - 0.038, chair.seat - 0.05),
    ];
    let post = extrude(&profile, Axis::X, [chair.half - width - 0.004, chair.half - 0.004]);
    builder.add_pair(slot, post);
}

/// Front legs of one radius under the seat.
fn turned_front(chair: &Chair, builder: &mut Builder, slot: Slot, radius: f64) {
    let at = |y: f64| DVec3::new(chair.half - radius - 0.002, y, chair.bay.high.z - radius - 0.002);
    let profile = [
        (0.5, 0.0),
        (0.8, 0.05),
        (0.5, 0.1),
        (0.42, 0.13),
        (0.85, 0.55),
        (0.95, 0.66),
        (0.5, 0.72),
        (0.9, 0.75),
        (0.9, 0.79),
        (0.6, 0.8),
    ];
    builder.add_pair(slot, slanted_leg([at(0.0), at(chair.seat - 0.03)], radius, &profile, 8));
    let block = Bay::around(at(chair.seat - 0.075), radius * 1.9, 0.09, radius * 1.9);
    builder.add_pair(slot, cuboid(block));
}

/// Rails under the seat on all four sides.
fn seat_rails(chair: &Chair, builder: &mut Builder, slot: Slot, height: f64) {
    let top = chair.seat - 0.03;
    let band = chair
        .bay
        .with_y([top - height, top])
        .inset(0.012, 0.0, 0.012)
        .without(Side::Back, BACK_DEPTH - 0.045);
    for side in [Side::Left, Side::Right] {
        builder.cuboid(slot, band.slab(side, 0.02).inset(0.0, 0.001, 0.01));
    }
    for side in [Side::Front, Side::Back] {
        builder.cuboid(slot, band.slab(side, 0.02).inset(0.015, 0.0, 0.0));
    }
}

/// A vase-shaped splat under a shaped crest, with box stretchers.
pub(super) fn splat_back(chair: &Chair, builder: &mut Builder) {
    let (high, post) = (chair.bay.high.y, 0.03);
    back_posts(chair, builder, Slot::WoodDark, post, high - 0.03);
    turned_front(chair, builder, Slot::WoodDark, 0.023);
    seat_rails(chair, builder, Slot::WoodDark, 0.055);
    builder.add(Slot::Fabric, crowned(chair.seat_bay(0.038).inset(0.008, 0.0, 0.008), 0.014, 0.014));
    let station = |rise: f64, wide: f64| {
        let y = chair.rise(rise);
        Station { at: DVec3::new(0.0, y, chair.lean(y) + 0.006), half_width: chair.half * wide, sag: 0.0 }
    };
    let vase = [(0.05, 0.3), (0.2, 0.2), (0.3, 0.16), (0.5, 0.34), (0.66, 0.38), (0.8, 0.24), (0.93, 0.34)];
    let splat: Vec<Station> = vase.iter().map(|&(rise, wide)| station(rise, wide)).collect();
    builder.add(Slot::WoodDark, sheet(&splat, DVec3::X, 0.012, 1));
    crest(chair, builder, Slot::WoodDark, 0.07);
    stretchers(chair, builder, Slot::WoodDark, 0.3, 0.01);
}

/// A top rail with a rise in its middle and ears at its ends.
fn crest(chair: &Chair, builder: &mut Builder, slot: Slot, tall: f64) {
    let high = chair.bay.high.y;
    let point = |x: f64, y: f64| DVec2::new(x * chair.half * 0.998, high - tall * (1.0 - y));
    let over = [(-1.0, 0.55), (-0.92, 0.75), (-0.6, 0.62), (-0.3, 0.85), (0.0, 1.0)];
    let mut profile: Vec<DVec2> = over.iter().map(|&(x, y)| point(x, y)).collect();
    profile.extend(over[..4].iter().rev().map(|&(x, y)| point(-x, y)));
    profile.extend([(0.96, 0.2), (0.5, 0.02), (-0.5, 0.0), (-0.96, 0.22)].map(|(x, y)| point(x, y)));
    let z = chair.lean(high);
    builder.add(slot, extrude(&profile, Axis::Z, [z - 0.011, z + 0.016]));
}

/// Bowed slats between turned posts with knobs, and a rush seat.
pub(super) fn ladder_back(chair: &Chair, builder: &mut Builder) {
    let (high, x) = (chair.bay.high.y, chair.half - 0.018);
    builder.add(Slot::FabricLight, crowned(chair.seat_bay(0.04).inset(0.004, 0.0, 0.002), 0.016, 0.008));
    let (foot, knee) = (
        DVec3::new(x, 0.0, chair.bay.low.z + 0.02),
        DVec3::new(x, chair.seat, chair.bay.low.z + BACK_DEPTH - 0.02),
    );
    let top = DVec3::new(x, high, chair.bay.low.z + 0.02);
    builder.add_pair(Slot::Wood, slanted_leg([foot, knee], 0.018, &[(0.7, 0.0), (0.9, 0.1), (0.9, 1.0)], 8));
    let knob = [(0.9, -0.02), (0.8, 0.86), (0.45, 0.88), (0.4, 0.9), (0.9, 0.93), (0.9, 0.96), (0.35, 1.0)];
    builder.add_pair(Slot::Wood, slanted_leg([knee, top], 0.018, &knob, 8));
    for rise in [0.22, 0.45, 0.68] {
        let y = chair.rise(rise + 0.06);
        let slat =
            bowed_board(DVec3::new(0.0, y, chair.lean(y) + 0.001), DVec3::new(x * 2.0, 0.062, 0.01), -0.022);
        builder.add(Slot::Wood, slat);
    }
    turned_front(chair, builder, Slot::Wood, 0.02);
    for rise in [0.28, 0.5] {
        let y = chair.seat * rise;
        builder.add_pair(Slot::Wood, sweep(&[chair.at(0.9, y, 0.1), chair.at(0.9, y, 0.95)], 0.009, 6));
        let y = y + 0.03;
        builder.add(Slot::Wood, sweep(&[chair.at(-0.9, y, 0.955), chair.at(0.9, y, 0.955)], 0.009, 6));
    }
}

/// A padded back in a carved frame and a deep sprung seat.
pub(super) fn framed_back(chair: &Chair, builder: &mut Builder) {
    let high = chair.bay.high.y;
    builder.add(Slot::FabricAccent, crowned(chair.seat_bay(0.06).inset(0.006, 0.0, 0.004), 0.022, 0.025));
    back_posts(chair, builder, Slot::WoodDark, 0.034, high - 0.03);
    turned_front(chair, builder, Slot::WoodDark, 0.026);
    seat_rails(chair, builder, Slot::WoodDark, 0.07);
    crest(chair, builder, Slot::WoodDark, 0.085);
    let y = chair.rise(0.16);
    let rail = DVec3::new(chair.half * 1.86, 0.045, 0.024);
    builder.cuboid(Slot::WoodDark, Bay::around(DVec3::new(0.0, y, chair.lean(y)), rail.x, rail.y, rail.z));
    let pad: Vec<Station> = [(0.22, 0.72), (0.26, 0.8), (0.5, 0.82), (0.74, 0.8), (0.79, 0.7)]
        .iter()
        .map(|&(rise, wide)| {
            let y = chair.rise(rise);
            Station {
                at: DVec3::new(0.0, y, chair.lean(y) + 0.004),
                half_width: chair.half * wide,
                sag: -0.012,
            }
        })
        .collect();
    builder.add(Slot::FabricAccent, sheet(&pad, DVec3::X, 0.036, 4));
    for (x, rise) in [(-0.4, 0.4), (0.0, 0.4), (0.4, 0.4), (-0.2, 0.6), (0.2, 0.6)] {
        let y = chair.rise(rise);
        let button =
            lathe(&[(0.011, -0.03), (0.011, 0.0), (0.006, 0.005)], 6).turned_x(std::f64::consts::FRAC_PI_2);
        builder.add(Slot::Brass, button.moved(x * chair.half, y, chair.lean(y) + 0.028));
    }
}
