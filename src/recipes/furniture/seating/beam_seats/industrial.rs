//! Seats of bent bands of steel on a channel that is bolted to the floor.

use glam::DVec3;

use super::{LEAN, Row};
use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::kit::{Bay, Builder, SINK, Station, sheet, sweep};

/// Metres between neighbouring seats.
const GAP: f64 = 0.05;
/// Bands of a seat, and metres of their thickness.
const BANDS: u32 = 4;
const STEEL: f64 = 0.008;

pub(super) fn build(row: &Row, builder: &mut Builder) {
    let (bay, seat) = (row.bay, row.seat);
    let (bands, frame) = [
        (Slot::Metal, Slot::MetalDark),
        (Slot::MetalDark, Slot::MetalDark),
        (Slot::Wood, Slot::MetalDark),
        (Slot::Metal, Slot::PaintedAccent),
    ][row.look];
    let middle = bay.center().z - 0.03;
    channel(row, builder, frame, middle);
    for cell in row.cells(GAP) {
        for band in cell.columns(BANDS, 0.022) {
            builder.add(bands, sheet(&path(row, band), DVec3::NEG_X, STEEL, 1));
        }
        let bar = |y: f64, z: f64| [cell.low.x + 0.01, cell.high.x - 0.01].map(|x| DVec3::new(x, y, z));
        let under = seat - STEEL - 0.012;
        for (y, z) in [(under, bay.high.z - 0.12), (under - 0.01, middle), (seat + 0.22, bay.low.z + 0.012)] {
            builder.add(frame, sweep(&bar(y, z), 0.014, 4));
        }
        let x = cell.center().x;
        let arm = [
            DVec3::new(x, under, bay.high.z - 0.13),
            DVec3::new(x, seat - 0.1, middle),
            DVec3::new(x, seat - 0.02, bay.low.z + 0.1),
            DVec3::new(x, seat + 0.07, bay.low.z + 0.034),
            DVec3::new(x, seat + 0.23, bay.low.z + 0.013),
        ];
        builder.add(frame, sweep(&arm, 0.017, 4));
    }
    if !row.look.is_multiple_of(2) {
        arm_rests(row, builder, frame, middle);
    }
}

/// One band: over the front edge, along the seat, up the back.
fn path(row: &Row, band: Bay) -> [Station; 6] {
    let (bay, seat) = (row.bay, row.seat);
    let (x, half_width) = (band.center().x, band.width() / 2.0);
    let (top, back) = (bay.high.y - 0.001, bay.low.z + STEEL / 2.0);
    let lean = back + (top - seat - 0.05) * libm::tan(LEAN * 0.7);
    [
        (seat - 0.05, bay.high.z - STEEL / 2.0),
        (seat - STEEL / 2.0, bay.high.z - 0.05),
        (seat - 0.02, lean + 0.1),
        (seat + 0.02, lean + 0.025),
        (seat + 0.07, lean),
        (top, back),
    ]
    .map(|(y, z)| Station { at: DVec3::new(x, y, z), half_width, sag: 0.0 })
}

/// A channel of steel on two posts with plates and bolts.
fn channel(row: &Row, builder: &mut Builder, frame: Slot, middle: f64) {
    let (bay, seat) = (row.bay, row.seat);
    let beam = Bay::around(DVec3::new(0.0, seat - 0.13, middle), bay.width(), 0.1, 0.06);
    builder.cuboid(frame, beam.slab(Side::Back, 0.01));
    for side in [Side::Above, Side::Below] {
        builder
            .cuboid(frame, beam.slab(side, 0.01).without(Side::Back, 0.01 - SINK).inset(0.001, 0.0001, 0.0));
    }
    for x in row.legs() {
        let post = Bay::around(DVec3::new(x, 0.0, middle + 0.005), 0.07, 1.0, 0.036);
        builder.cuboid(frame, post.with_y([0.008, beam.high.y - 0.006]));
        builder.cuboid(frame, Bay::new([x - 0.09, x + 0.09], [0.0, 0.012], [middle - 0.13, middle + 0.15]));
        for (x, z) in
            [(-0.065, -0.1), (0.065, -0.1), (-0.065, 0.12), (0.065, 0.12)].map(|(side, z)| (x + side, z))
        {
            builder.cuboid(Slot::Metal, Bay::around(DVec3::new(x, 0.016, middle + z), 0.026, 0.02, 0.026));
        }
        for z in [-0.115, 0.135] {
            let stay = [DVec3::new(x, 0.008, middle + z), DVec3::new(x, seat * 0.5, middle + 0.006)];
            builder.add(frame, sweep(&stay, 0.014, 4));
        }
    }
}

/// Bows of flat steel between the seats.
fn arm_rests(row: &Row, builder: &mut Builder, frame: Slot, middle: f64) {
    let (bay, seat) = (row.bay, row.seat);
    let joints = row.joints(GAP);
    for &x in &joints[1..joints.len() - 1] {
        let path = [
            (seat - 0.09, middle + 0.02),
            (seat + 0.19, middle + 0.1),
            (seat + 0.19, bay.low.z + 0.14),
            (seat - 0.09, middle),
        ]
        .map(|(y, z)| DVec3::new(x, y, z));
        builder.add(frame, sweep(&path, 0.014, 4));
    }
}
