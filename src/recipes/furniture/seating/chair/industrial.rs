//! Industrial chairs: pressed steel, pipe and planks, angles and bars.

use glam::DVec3;

use super::traditional::back_posts;
use super::{BACK_DEPTH, Chair, TUBE};
use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::furniture::parts::{bowed_board, slanted_leg};
use crate::recipes::kit::{Bay, Builder, Station, crowned, cuboid, lathe, pipe, sheet, sweep};

/// Pressed steel: a dished seat on slanted channels, a bent tube with one wide slat as back.
pub(super) fn sheet_metal(chair: &Chair, builder: &mut Builder) {
    let (high, seat) = (chair.bay.high.y, chair.seat);
    let dish = chair.seat_bay(0.02).inset(0.004, 0.0, 0.002);
    builder.block(Slot::MetalDark, dish.slab(Side::Below, 0.014), 0.006);
    builder.add(Slot::MetalDark, crowned(dish.inset(0.02, 0.0, 0.02).moved(0.0, -0.0005, 0.0), 0.02, 0.006));
    let skirt = chair.seat_bay(0.055).inset(0.014, 0.0, 0.014).without(Side::Above, 0.015);
    builder.cuboid(Slot::MetalDark, skirt);
    for (x, z, end) in [(0.96, 0.965, 0.9), (0.96, 0.035, 0.14)] {
        let leg = slanted_leg(
            [chair.at(x, 0.0, z), chair.at(0.82, seat - 0.03, end)],
            0.021,
            &[(0.75, 0.0), (1.35, 1.0)],
            4,
        );
        builder.add_pair(Slot::MetalDark, leg);
    }
    let z = chair.lean(high) + 0.002;
    let path = [
        chair.at(0.86, seat - 0.02, 0.14),
        DVec3::new(0.96 * chair.half, high - TUBE, z),
        DVec3::new(-0.96 * chair.half, high - TUBE, z),
        chair.at(-0.86, seat - 0.02, 0.14),
    ];
    builder.add(Slot::MetalDark, pipe(&path, TUBE, 0.11));
    let slat: Vec<Station> = [0.0, 0.35, 0.7, 0.985]
        .iter()
        .map(|&rise| {
            let y = chair.rise(rise) - 0.012;
            Station {
                at: DVec3::new(0.0, y, chair.lean(y) + 0.004),
                half_width: chair.half * 0.36,
                sag: 0.006,
            }
        })
        .collect();
    builder.add(Slot::MetalDark, sheet(&slat, DVec3::X, 0.006, 3));
    let y = seat * 0.55;
    builder.add_pair(Slot::MetalDark, sweep(&[chair.at(0.89, y, 0.08), chair.at(0.89, y, 0.94)], 0.006, 4));
}

/// A bolt's head towards the front or upwards.
fn bolt(builder: &mut Builder, at: DVec3, is_up: bool) {
    let head = lathe(&[(0.008, -0.004), (0.008, 0.003), (0.005, 0.006)], 6);
    let head = if is_up { head } else { head.turned_x(std::f64::consts::FRAC_PI_2) };
    builder.add(Slot::Metal, head.moved(at.x, at.y, at.z));
}

/// Planks bolted on a frame of pipe.
pub(super) fn pipe_and_planks(chair: &Chair, builder: &mut Builder) {
    let (high, seat) = (chair.bay.high.y, chair.seat);
    let x = 1.0 - 0.014 / chair.half;
    let radius = 0.0135;
    let side = [
        chair.at(x, 0.0, 0.97),
        chair.at(x, seat - 0.045, 0.97),
        chair.at(x, seat - 0.045, 0.15),
        DVec3::new(x * chair.half, high, chair.lean(high) + 0.006),
    ];
    builder.add_pair(Slot::MetalDark, pipe(&side, radius, 0.05));
    builder.add_pair(
        Slot::MetalDark,
        sweep(&[chair.at(x, 0.0, 0.04), chair.at(x, seat - 0.045, 0.16)], radius, 6),
    );
    for (y, z) in [(seat - 0.045, 0.8), (seat - 0.045, 0.22), (seat * 0.35, 0.955)] {
        builder.add(Slot::MetalDark, sweep(&[chair.at(-x, y, z), chair.at(x, y, z)], radius * 0.8, 6));
    }
    let boards = chair.seat_bay(0.032).without(Side::Back, 0.035);
    for (index, board) in super::super::depth_slats(boards, 3, 0.006).into_iter().enumerate() {
        builder.block(Slot::Wood, board.inset(0.002 * index as f64, 0.0, 0.0), 0.004);
        for x in [-0.86, 0.86] {
            bolt(builder, DVec3::new(x * chair.half, seat, board.center().z), true);
        }
    }
    for rise in [0.42, 0.74] {
        let y = chair.rise(rise + 0.1);
        let z = chair.lean(y) + 0.024;
        builder.block(Slot::Wood, Bay::around(DVec3::new(0.0, y, z), chair.half * 2.0, 0.1, 0.02), 0.004);
        for x in [-0.93, 0.93] {
            bolt(builder, DVec3::new(x * chair.half, y, z + 0.01), false);
        }
    }
}

/// Seat and back of steel bars in a frame of angles.
pub(super) fn lattice(chair: &Chair, builder: &mut Builder) {
    let (high, seat) = (chair.bay.high.y, chair.seat);
    back_posts(chair, builder, Slot::MetalDark, 0.022, high);
    let front = Bay::new(
        [chair.half - 0.026, chair.half - 0.002],
        [0.0, seat - 0.0008],
        [chair.bay.high.z - 0.024, chair.bay.high.z],
    );
    builder.add_pair(Slot::MetalDark, cuboid(front));
    let frame =
        chair.bay.with_y([seat - 0.03, seat - 0.004]).inset(0.003, 0.0, 0.001).without(Side::Back, 0.05);
    for side in [Side::Left, Side::Right] {
        builder.cuboid(Slot::MetalDark, frame.slab(side, 0.022).inset(0.0, 0.0, 0.002));
    }
    for side in [Side::Front, Side::Back] {
        builder.cuboid(Slot::MetalDark, frame.slab(side, 0.02).inset(0.01, 0.0015, 0.0));
    }
    for bar in frame.inset(0.02, 0.0, 0.012).columns(9, 0.024) {
        builder.cuboid(Slot::Metal, bar.slab(Side::Above, 0.007).moved(0.0, 0.002, 0.0));
    }
    for y in [chair.rise(0.3), high - 0.024] {
        let rail = Bay::around(DVec3::new(0.0, y, chair.lean(y) + 0.002), chair.half * 1.94, 0.03, 0.014);
        builder.cuboid(Slot::MetalDark, rail);
    }
    let (low, high) = (chair.rise(0.3), high - 0.024);
    let inner = chair.bay.inset(0.05, 0.0, 0.0);
    for bar in inner.columns(6, 0.03) {
        let x = bar.center().x;
        let path =
            [DVec3::new(x, low, chair.lean(low) + 0.002), DVec3::new(x, high, chair.lean(high) + 0.002)];
        builder.add(Slot::Metal, sweep(&path, 0.007, 4));
    }
    let y = seat * 0.4;
    builder.add_pair(Slot::MetalDark, sweep(&[chair.at(0.93, y, 0.06), chair.at(0.93, y, 0.96)], 0.009, 4));
}

/// A workshop seat: a round board on a screw between four pipes, with a small back on a bent strip.
pub(super) fn screw_seat(chair: &Chair, builder: &mut Builder) {
    let (high, seat) = (chair.bay.high.y, chair.seat);
    let middle = chair.at(0.0, 0.0, 0.53);
    let radius = chair.half.min(chair.bay.depth() * 0.47) * 0.95;
    let profile =
        [(radius * 0.9, seat - 0.035), (radius, seat - 0.03), (radius, seat - 0.008), (radius * 0.95, seat)];
    builder.add(Slot::Wood, lathe(&profile, 20).moved(middle.x, 0.0, middle.z));
    builder.add(
        Slot::Metal,
        lathe(&[(0.016, seat * 0.42), (0.016, seat - 0.06), (0.07, seat - 0.045), (0.07, seat - 0.034)], 10)
            .moved(middle.x, 0.0, middle.z),
    );
    for (x, z) in [(0.94, 0.96), (0.94, 0.04)] {
        let path = [
            chair.at(x, 0.0, z),
            chair.at(0.3, seat * 0.62, 0.5 + (z - 0.5) * 0.4),
            chair.at(0.02, seat * 0.62, 0.5 + (z - 0.5) * 0.1),
        ];
        builder.add_pair(Slot::MetalDark, pipe(&path, 0.013, 0.05));
    }
    let ring = Bay::around(middle + DVec3::Y * seat * 0.6, 0.11, 0.05, 0.11);
    builder.block(Slot::MetalDark, ring, 0.01);
    let y = seat * 0.3;
    let hoop = |x: f64, z: f64| chair.at(x, y, z);
    for (from, to) in [((-0.7, 0.83), (0.7, 0.83)), ((-0.7, 0.17), (0.7, 0.17))] {
        builder.add(Slot::MetalDark, sweep(&[hoop(from.0, from.1), hoop(to.0, to.1)], 0.008, 6));
    }
    let strip = [
        chair.at(0.0, seat - 0.05, 0.4),
        chair.at(0.0, seat - 0.05, 0.16),
        DVec3::new(0.0, chair.rise(0.3), chair.bay.low.z + BACK_DEPTH - 0.03),
        DVec3::new(0.0, high - 0.06, chair.lean(high) + 0.006),
    ];
    builder.add(Slot::MetalDark, pipe(&strip, 0.013, 0.06));
    let rest = bowed_board(
        DVec3::new(0.0, high - 0.075, chair.lean(high) + 0.042),
        DVec3::new(chair.half * 2.0, 0.15, 0.02),
        -0.05,
    );
    builder.add(Slot::Wood, rest);
}
