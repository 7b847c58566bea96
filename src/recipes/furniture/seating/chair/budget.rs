//! Cheap chairs: plastic on thin tube.

use glam::DVec3;

use super::{BACK_DEPTH, Chair, TUBE};
use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::furniture::parts::{bowed_board, slanted_leg};
use crate::recipes::kit::{Bay, Builder, Station, crowned, pipe, sheet, sweep};

/// A moulded shell on four thin tubes.
pub(super) fn plastic_shell(chair: &Chair, builder: &mut Builder) {
    builder.add(Slot::Plastic, chair.shell(0.009, 0.042, 0.9));
    tube_legs(chair, builder, Slot::Chrome);
}

/// Two bows of tube, one before the other, that carry a seat.
fn tube_legs(chair: &Chair, builder: &mut Builder, slot: Slot) {
    let (top, radius) = (chair.seat - 0.068, 0.009);
    for (z, up) in [(0.97, 0.8), (0.03, 0.22)] {
        let path = both_sides(&[chair.at(0.74, top, up), chair.at(0.95, 0.01, z)]);
        builder.add(slot, pipe(&path, radius, 0.05));
        let shoe = slanted_leg(
            [chair.at(0.955, 0.0, z), chair.at(0.945, 0.03, z)],
            0.014,
            &[(1.0, 0.0), (0.9, 1.0)],
            6,
        );
        builder.add_pair(Slot::Rubber, shoe);
    }
    let spine = Bay::around(chair.at(0.0, top + 0.004, 0.5), 0.05, 0.02, chair.bay.depth() * 0.62);
    builder.cuboid(slot, spine);
}

/// A path on the right, from near the middle outwards, with its mirror image before it.
fn both_sides(right: &[DVec3]) -> Vec<DVec3> {
    let mirror = |point: &DVec3| DVec3::new(-point.x, point.y, point.z);
    right.iter().rev().map(mirror).chain(right.iter().copied()).collect()
}

/// Separate plastic seat and back on one bent tube.
pub(super) fn stacking(chair: &Chair, builder: &mut Builder) {
    let (high, seat) = (chair.bay.high.y, chair.seat);
    builder.add(
        Slot::PaintedAccent,
        crowned(chair.seat_bay(0.03).without(Side::Back, 0.04).inset(0.02, 0.0, 0.0), 0.014, 0.004),
    );
    let radius = TUBE * 0.9;
    let x = 1.0 - radius / chair.half;
    let side = [
        chair.at(x, 0.0, 0.96),
        chair.at(x - 0.1, seat - 0.032, 0.9),
        chair.at(x - 0.1, seat - 0.032, 0.17),
        DVec3::new((x - 0.1) * chair.half, high - 0.03, chair.lean(high) + 0.004),
    ];
    builder.add_pair(Slot::MetalDark, pipe(&side, radius, 0.06));
    builder.add_pair(
        Slot::MetalDark,
        sweep(&[chair.at(x, 0.0, 0.04), chair.at(x - 0.1, seat - 0.032, 0.26)], radius, 6),
    );
    for z in [0.3, 0.75] {
        builder.add(
            Slot::MetalDark,
            sweep(&[chair.at(-0.85, seat - 0.034, z), chair.at(0.85, seat - 0.034, z)], radius * 0.7, 6),
        );
    }
    let station = |rise: f64, wide: f64| {
        let y = chair.rise(rise);
        Station { at: DVec3::new(0.0, y, chair.lean(y) + 0.02), half_width: chair.half * wide, sag: 0.02 }
    };
    let back = [(0.42, 0.84), (0.48, 0.92), (0.9, 0.94), (0.995, 0.8)];
    let back: Vec<Station> = back.iter().map(|&(rise, wide)| station(rise, wide)).collect();
    builder.add(Slot::PaintedAccent, sheet(&back, DVec3::NEG_X, 0.01, 4));
}

/// A garden-like chair moulded in one piece, its back of staves.
pub(super) fn monobloc(chair: &Chair, builder: &mut Builder) {
    let (high, seat) = (chair.bay.high.y, chair.seat);
    builder.add(Slot::Plastic, crowned(chair.seat_bay(0.026).inset(0.003, 0.0, 0.0), 0.012, 0.003));
    builder.cuboid(Slot::Plastic, chair.seat_bay(0.05).inset(0.02, 0.0, 0.02).without(Side::Above, 0.0255));
    for (x, z, end) in [(0.95, 0.965, 0.88), (0.95, 0.035, 0.12)] {
        let leg = slanted_leg(
            [chair.at(x, 0.0, z), chair.at(0.8, seat - 0.02, end)],
            0.024,
            &[(0.8, 0.0), (1.3, 1.0)],
            4,
        );
        builder.add_pair(Slot::Plastic, leg);
    }
    let along = |x: [f64; 2], wide: f64| {
        let station = |rise: f64, share: f64| {
            let y = chair.rise(rise) - 0.008;
            let across = (x[0] * (1.0 - rise) + x[1] * rise) * chair.half;
            Station { at: DVec3::new(across, y, chair.lean(y) + 0.006), half_width: wide * share, sag: 0.0 }
        };
        sheet(&[station(0.0, 1.0), station(0.4, 0.9), station(0.94, 1.0)], DVec3::X, 0.012, 1)
    };
    builder.add_pair(Slot::Plastic, along([0.78, 0.8], 0.026));
    for x in [-0.42, -0.14, 0.14, 0.42] {
        builder.add(Slot::Plastic, along([x, x * 1.08], 0.019));
    }
    let rail = bowed_board(
        DVec3::new(0.0, high - 0.04, chair.lean(high) + 0.014),
        DVec3::new(chair.half * 1.9, 0.08, 0.02),
        -0.012,
    );
    builder.add(Slot::Plastic, rail);
}

/// Crossed tubes with a thin pad as seat and another as back.
pub(super) fn folding(chair: &Chair, builder: &mut Builder) {
    let (high, seat) = (chair.bay.high.y, chair.seat);
    let (outer, inner) = (1.0 - 0.01 / chair.half, 0.86);
    let z = chair.lean(high) + 0.002;
    let frame = [
        DVec3::new(outer * chair.half, high - 0.01, z),
        DVec3::new(outer * chair.half, seat, chair.bay.low.z + BACK_DEPTH - 0.004),
        chair.at(outer, 0.0, 0.97),
    ];
    builder.add(Slot::Metal, pipe(&both_sides(&frame), 0.0095, 0.05));
    let hind = [chair.at(inner, 0.0, 0.03), chair.at(inner, seat - 0.03, 0.78)];
    builder.add_pair(Slot::Metal, sweep(&hind, 0.0095, 6));
    for (end, y, z) in [(outer, 0.11, 0.79), (inner, 0.1, 0.2)] {
        builder.add(Slot::Metal, sweep(&[chair.at(-end, y, z), chair.at(end, y, z)], 0.007, 6));
    }
    builder.add(
        Slot::PlasticDark,
        crowned(chair.seat_bay(0.03).inset(0.026, 0.0, 0.0).without(Side::Back, 0.07), 0.012, 0.008),
    );
    builder.add(
        Slot::Metal,
        sweep(&[chair.at(-inner, seat - 0.032, 0.77), chair.at(inner, seat - 0.032, 0.77)], 0.008, 6),
    );
    let rise = |share: f64| chair.rise(share);
    let back: Vec<Station> = [0.55, 0.6, 0.88, 0.93]
        .iter()
        .map(|&share| Station {
            at: DVec3::new(0.0, rise(share), chair.lean(rise(share)) + 0.008),
            half_width: chair.half * 0.97,
            sag: 0.01,
        })
        .collect();
    builder.add(Slot::PlasticDark, sheet(&back, DVec3::NEG_X, 0.016, 3));
}
