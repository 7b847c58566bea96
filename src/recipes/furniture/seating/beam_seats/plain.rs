//! Pads for seat and back between frames of flat metal on a beam.

use glam::DVec3;

use super::{LEAN, Row};
use crate::recipes::Slot;
use crate::recipes::kit::{Bay, Builder, SINK, rounded_box, sweep};

/// Metres between neighbouring pads, in which the frames stand.
const GAP: f64 = 0.05;
/// Metres of a pad's thickness.
const PAD: f64 = 0.055;

pub(super) fn build(row: &Row, builder: &mut Builder) {
    let (bay, seat) = (row.bay, row.seat);
    let (cover, metal) = [
        (Slot::Fabric, Slot::Metal),
        (Slot::Leather, Slot::Chrome),
        (Slot::FabricAccent, Slot::MetalDark),
        (Slot::Leather, Slot::MetalDark),
    ][row.look];
    let middle = bay.center().z;
    let beam = Bay::around(DVec3::new(0.0, seat - 0.13, middle), bay.width() - 0.02, 0.05, 0.07);
    builder.cuboid(metal, beam);
    for x in row.legs() {
        let at = |y: f64, z: f64| DVec3::new(x, y, z);
        let path = [at(0.018, bay.high.z - 0.05), at(seat - 0.14, middle), at(0.018, bay.low.z + 0.05)];
        builder.add(metal, sweep(&path, 0.026, 4));
        for z in [bay.high.z - 0.05, bay.low.z + 0.05] {
            builder.cuboid(Slot::Rubber, Bay::around(at(0.008, z), 0.05, 0.016, 0.05));
        }
    }
    let back = bay.high.y - seat - 0.05;
    for cell in row.cells(GAP) {
        let pad = cell.with_y([seat - PAD, seat]).with_z([bay.low.z + 0.13, bay.high.z]);
        builder.block(cover, pad, 0.018);
        let half = cell.width() / 2.0;
        let upright = Bay::new([-half, half], [0.0, back / libm::cos(LEAN)], [-PAD, 0.0]);
        let foot = bay.low.z + PAD * libm::cos(LEAN) + back * libm::tan(LEAN);
        let upright = rounded_box(upright, DVec3::splat(0.018), 1).turned_x(-LEAN);
        builder.add(cover, upright.moved(cell.center().x, seat + 0.05, foot));
        let carrier = Bay::around(DVec3::new(cell.center().x, 0.0, middle), 0.1, 1.0, 0.2);
        builder.cuboid(metal, carrier.with_y([beam.high.y - SINK, pad.low.y + SINK]));
    }
    frames(row, builder, metal);
}

/// Arm rests between the seats, and the bars that hold them apart.
fn frames(row: &Row, builder: &mut Builder, metal: Slot) {
    let (bay, seat) = (row.bay, row.seat);
    let middle = bay.center().z;
    let (rest, top) = (seat + 0.2, bay.high.y - 0.06);
    for x in row.joints(GAP) {
        // Up before the seat, back along the arm rest, up behind the back.
        let at = |y: f64, z: f64| DVec3::new(x, y, z);
        let path = [
            at(seat - 0.12, middle - 0.02),
            at(seat - 0.06, bay.high.z - 0.06),
            at(rest, bay.high.z - 0.1),
            at(rest, bay.low.z + 0.15),
            at(top, bay.low.z + 0.05),
        ];
        builder.add(metal, sweep(&path, 0.014, 4));
        let pad = Bay::new(
            [x - 0.022, x + 0.022],
            [rest + 0.008, rest + 0.026],
            [bay.low.z + 0.17, bay.high.z - 0.11],
        );
        builder.cuboid(Slot::PlasticDark, pad);
        let brace = [at(seat - 0.03, bay.low.z + 0.2), at(rest, bay.low.z + 0.16)];
        builder.add(metal, sweep(&brace, 0.012, 4));
    }
    // Bars through the pads hold the frames apart.
    for (y, z) in [(seat - 0.03, bay.low.z + 0.2), (top - 0.02, bay.low.z + 0.05)] {
        let bar = [bay.low.x + GAP / 2.0, bay.high.x - GAP / 2.0].map(|x| DVec3::new(x, y, z));
        builder.add(metal, sweep(&bar, 0.012, 4));
    }
}
