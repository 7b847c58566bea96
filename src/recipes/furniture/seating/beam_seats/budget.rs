//! Moulded shells on a beam with two feet.

use glam::DVec3;

use super::Row;
use crate::recipes::Slot;
use crate::recipes::kit::{Bay, Builder, Solid, Station, sheet, sweep};

/// Metres between neighbouring shells, and of their thickness.
const GAP: f64 = 0.03;
const SHELL: f64 = 0.012;

pub(super) fn build(row: &Row, builder: &mut Builder) {
    let (bay, seat) = (row.bay, row.seat);
    let shells = [
        [Slot::Plastic, Slot::Plastic],
        [Slot::PaintedAccent, Slot::PaintedAccent],
        [Slot::PlasticDark, Slot::PlasticDark],
        [Slot::Plastic, Slot::PaintedAccent],
    ][row.look];
    let middle = bay.center().z;
    let beam = Bay::around(DVec3::new(0.0, seat - 0.11, middle), bay.width() - 0.02, 0.05, 0.05);
    builder.cuboid(Slot::MetalDark, beam);
    for x in row.legs() {
        let post = [DVec3::new(x, 0.04, middle), DVec3::new(x, seat - 0.1, middle)];
        builder.add(Slot::MetalDark, sweep(&post, 0.026, 6));
        // The foot is bent down to the floor at both ends.
        let foot = [
            (0.01, bay.high.z - 0.03),
            (0.05, middle + 0.06),
            (0.05, middle - 0.06),
            (0.01, bay.low.z + 0.03),
        ]
        .map(|(y, z)| DVec3::new(x, y, z));
        builder.add(Slot::MetalDark, sweep(&foot, 0.02, 4));
        for z in [bay.high.z - 0.04, bay.low.z + 0.04] {
            builder.cuboid(Slot::Rubber, Bay::around(DVec3::new(x, 0.012, z), 0.045, 0.024, 0.06));
        }
    }
    // Shells reach the sides of the box.
    let cells = bay.columns(row.count, GAP);
    for (index, cell) in cells.iter().enumerate() {
        builder.add(shells[index % 2], shell(row, *cell));
        let bracket = Bay::around(DVec3::new(cell.center().x, seat - 0.07, middle), 0.2, 0.06, 0.12);
        builder.cuboid(Slot::MetalDark, bracket);
    }
}

/// One seat and back in a bent sheet.
fn shell(row: &Row, cell: Bay) -> Solid {
    let (x, half, seat) = (cell.center().x, cell.width() / 2.0, row.seat);
    let (low, high) = (cell.low.z, cell.high.z);
    let top = cell.high.y - 0.003 + SHELL / 2.0;
    let station = |y: f64, z: f64, share: f64| Station {
        at: DVec3::new(x, y - SHELL / 2.0, z),
        half_width: half * share,
        sag: 0.02,
    };
    let lean = low + 0.012 + SHELL / 2.0;
    let path = [
        station(seat - 0.03, high - 0.008, 0.9),
        station(seat, high - 0.05, 0.98),
        station(seat - 0.03, low + 0.22, 1.0),
        station(seat - 0.01, low + 0.14, 0.92),
        station(seat + 0.06, low + 0.1, 0.86),
        station(seat + 0.2, lean + 0.04, 0.94),
        station(top - 0.06, lean + 0.004, 0.92),
        station(top, lean, 0.7),
    ];
    sheet(&path, DVec3::NEG_X, SHELL, 4)
}
