//! The bench of old stations: slats and an arched rail between standards of cast iron, an arm rest beside each seat.

use glam::{DVec2, DVec3};

use super::{LEAN, Row, depth_slats};
use crate::recipes::Slot;
use crate::recipes::kit::{Axis, Bay, Builder, cuboid, extrude, sweep};

/// Metres of a standard's thickness.
const IRON: f64 = 0.032;

pub(super) fn build(row: &Row, builder: &mut Builder) {
    let (bay, seat) = (row.bay, row.seat);
    let (wood, iron) = [
        (Slot::Wood, Slot::MetalDark),
        (Slot::WoodDark, Slot::MetalDark),
        (Slot::WoodDark, Slot::Brass),
        (Slot::Wood, Slot::PaintedAccent),
    ][row.look];
    let (back, front) = (bay.low.z, bay.high.z);
    let seats = bay.inset(0.006, 0.0, 0.0).with_y([seat - 0.028, seat]).with_z([back + 0.13, front - 0.01]);
    for slat in depth_slats(seats, 5, 0.014) {
        builder.block(wood, slat, 0.006);
    }
    let foot = back + 0.035 + (bay.high.y - seat) * libm::tan(LEAN);
    let long = (bay.high.y - seat - 0.13) / libm::cos(LEAN);
    let half = bay.high.x - 0.012;
    for row in Bay::new([-half, half], [0.07, long], [-0.02, 0.0]).rows(3, 0.03) {
        builder.add(wood, cuboid(row).turned_x(-LEAN).moved(0.0, seat, foot));
    }
    let (low, ends) = (bay.high.y - 0.13, bay.high.y - 0.05);
    let rail = [
        (-half, low),
        (half, low),
        (half, ends),
        (half * 0.6, bay.high.y),
        (-half * 0.6, bay.high.y),
        (-half, ends),
    ]
    .map(DVec2::from);
    builder.add(wood, extrude(&rail, Axis::Z, [back, back + 0.03]));
    let joints = row.joints(IRON);
    for (index, &x) in joints.iter().enumerate() {
        let sides = [x - IRON / 2.0, x + IRON / 2.0];
        let at = |y: f64, z: f64| DVec3::new(x, y, z);
        let post = [at(seat - 0.06, foot - 0.036), at(ends, back + 0.015)];
        builder.add(iron, sweep(&post, 0.013, 4));
        builder.add(iron, extrude(&arm(row), Axis::X, [sides[0] + 0.001, sides[1] - 0.001]));
        // Every other one stands on the floor, and both at the ends.
        if index.is_multiple_of(2) || index + 1 == joints.len() {
            builder.add(iron, extrude(&standard(row), Axis::X, sides));
        }
    }
}

/// An arch on two feet under the seat, from the side.
fn standard(row: &Row) -> [DVec2; 8] {
    let (back, front, seat) = (row.bay.low.z, row.bay.high.z, row.seat);
    [
        (back + 0.01, 0.0),
        (back + 0.07, 0.0),
        (back + 0.16, seat * 0.62),
        (front - 0.15, seat * 0.62),
        (front - 0.07, 0.0),
        (front, 0.0),
        (front - 0.05, seat - 0.02),
        (back + 0.1, seat - 0.02),
    ]
    .map(DVec2::from)
}

/// A post at the front with an arm rest to the back, whose end rolls over.
fn arm(row: &Row) -> [DVec2; 9] {
    let (back, front, seat) = (row.bay.low.z, row.bay.high.z, row.seat);
    let rest = seat + 0.21;
    [
        (front - 0.1, seat - 0.04),
        (front - 0.06, seat - 0.04),
        (front - 0.05, rest - 0.05),
        (front - 0.004, rest - 0.05),
        (front - 0.004, rest - 0.01),
        (front - 0.05, rest + 0.03),
        (back + 0.07, rest + 0.02),
        (back + 0.07, rest - 0.015),
        (front - 0.1, rest - 0.015),
    ]
    .map(DVec2::from)
}
