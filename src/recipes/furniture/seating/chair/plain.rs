//! Plain modern chairs: bent plywood, slim round wood, padded shells.

use glam::DVec3;

use super::Chair;
use crate::recipes::Slot;
use crate::recipes::furniture::parts::{CONE, bowed_board, slanted_leg};
use crate::recipes::kit::{Bay, Builder, Station, crowned, pipe, sheet, sweep};

/// A shell of plywood on four slanted legs.
pub(super) fn bent_ply(chair: &Chair, builder: &mut Builder) {
    builder.add(Slot::Wood, chair.shell(0.014, 0.02, 0.72));
    chair.slanted_legs(builder, Slot::Wood, 0.019, &CONE);
    let under =
        Bay::around(chair.at(0.0, chair.seat - 0.062, 0.5), chair.half * 1.35, 0.03, chair.bay.depth() * 0.6);
    builder.block(Slot::WoodDark, under, 0.006);
}

/// A soft seat and a soft curved back on a wooden frame.
pub(super) fn upholstered(chair: &Chair, builder: &mut Builder) {
    builder.add(Slot::Fabric, crowned(chair.seat_bay(0.075), 0.025, 0.018));
    chair.slanted_legs(builder, Slot::Wood, 0.021, &CONE);
    let (low, high) = (chair.rise(0.21), chair.bay.high.y);
    let station = |share: f64, wide: f64| {
        let y = low + (high - low) * share;
        Station { at: DVec3::new(0.0, y, chair.lean(y) - 0.002), half_width: chair.half * wide, sag: 0.006 }
    };
    let back = [(0.0, 0.8), (0.1, 0.88), (0.5, 0.93), (0.88, 0.86), (0.97, 0.78), (0.995, 0.62)];
    let back: Vec<Station> = back.iter().map(|&(share, wide)| station(share, wide)).collect();
    builder.add(Slot::Fabric, sheet(&back, DVec3::NEG_X, 0.036, 4));
    let path = [
        chair.at(0.6, chair.seat - 0.05, 0.14),
        chair.at(0.6, chair.rise(0.12), 0.14),
        DVec3::new(0.6 * chair.half, chair.rise(0.5), chair.lean(chair.rise(0.5)) + 0.008),
    ];
    builder.add_pair(Slot::Wood, sweep(&path, 0.013, 6));
}

/// Round posts, a bent rail as back and a woven seat.
pub(super) fn curved_rail(chair: &Chair, builder: &mut Builder) {
    let high = chair.bay.high.y;
    builder.add(Slot::FabricLight, crowned(chair.seat_bay(0.035).inset(0.012, 0.0, 0.012), 0.012, 0.008));
    let ends = [chair.at(0.92, 0.0, 0.96), chair.at(0.92, chair.seat - 0.004, 0.96)];
    builder.add_pair(Slot::Wood, slanted_leg(ends, 0.02, &[(0.7, 0.0), (1.0, 0.8), (0.9, 1.0)], 8));
    let post = [
        chair.at(0.95, 0.0, 0.04),
        chair.at(0.94, chair.seat, 0.13),
        DVec3::new(0.94 * chair.half, high - 0.05, chair.lean(high) + 0.005),
    ];
    builder.add_pair(Slot::Wood, sweep(&post, 0.016, 8));
    let frame = chair.seat_bay(0.03).moved(0.0, -0.012, 0.0).inset(0.03, 0.0, 0.025);
    builder.block(Slot::Wood, frame, 0.006);
    let rail = bowed_board(
        DVec3::new(0.0, high - 0.055, chair.lean(high) + 0.024),
        DVec3::new(chair.half * 2.0, 0.11, 0.022),
        -0.03,
    );
    builder.add(Slot::Wood, rail);
    for y in [0.32, 0.52] {
        let y = chair.rise(y);
        let rod = chair.lean(y) + 0.005;
        builder.add(
            Slot::Wood,
            sweep(&[DVec3::new(-0.94 * chair.half, y, rod), DVec3::new(0.94 * chair.half, y, rod)], 0.009, 6),
        );
    }
    stretchers(chair, builder, Slot::Wood, 0.24, 0.009);
}

/// Two bars along the sides and one across between the legs.
pub(super) fn stretchers(chair: &Chair, builder: &mut Builder, slot: Slot, rise: f64, radius: f64) {
    let y = chair.seat * rise;
    let side = [chair.at(0.92, y, 0.08), chair.at(0.92, y, 0.95)];
    builder.add_pair(slot, sweep(&side, radius, 6));
    builder.add(slot, sweep(&[chair.at(-0.92, y, 0.5), chair.at(0.92, y, 0.5)], radius, 6));
}

/// A padded shell on a sled of steel rod.
pub(super) fn padded_sled(chair: &Chair, builder: &mut Builder) {
    builder.add(Slot::Fabric, chair.shell(0.034, 0.028, 0.86));
    sled(chair, builder, Slot::MetalDark, 0.008);
}

/// One closed run of rod on either side that goes under the seat.
fn sled(chair: &Chair, builder: &mut Builder, slot: Slot, radius: f64) {
    let x = 1.0 - radius / chair.half;
    let top = chair.seat - 0.088;
    let path = [
        chair.at(0.3, top, 0.72),
        chair.at(0.55, top, 0.72),
        chair.at(x, radius, 0.97),
        chair.at(x, radius, 0.03),
        chair.at(0.55, top, 0.28),
        chair.at(0.3, top, 0.28),
    ];
    builder.add_pair(slot, pipe(&path, radius, 0.04));
    let plate = Bay::around(chair.at(0.0, top + 0.012, 0.5), chair.half * 1.0, 0.02, chair.bay.depth() * 0.5);
    builder.cuboid(slot, plate);
}
