//! Cheap swivel chairs: a typist's chair with two pads on a bar, loops as arm rests, a moulded shell.

use glam::DVec3;

use super::{ARM_RISE, BACK_DEPTH, Swivel, flat_bar};
use crate::recipes::Slot;
use crate::recipes::kit::{Bay, Builder, Station, crowned, pipe, rounded_box, sheet};

/// Metres of the flat bar that carries the back.
const BAR: f64 = 0.05;

/// A thin seat, and a small back on a bar of steel in a rubber sleeve.
pub(super) fn typist(chair: &Swivel, builder: &mut Builder) {
    chair.five_star(builder, Slot::PlasticDark, Slot::PlasticDark);
    seat(chair, builder, Slot::Fabric, 0.8);
    bar(chair, builder, 0.8);
    let pad = [(0.46, 0.5), (0.52, 0.62), (0.9, 0.62), (0.99, 0.46)];
    builder.add(Slot::Fabric, chair.back(&pad, 0.036, 0.016));
}

/// A seat pad over a pan of plastic.
fn seat(chair: &Swivel, builder: &mut Builder, slot: Slot, share: f64) {
    builder.add(slot, rounded_box(chair.seat_bay(0.05, share), DVec3::new(0.04, 0.02, 0.04), 2));
    let pan = chair.seat_bay(0.03, share - 0.05).moved(0.0, -0.035, 0.0).inset(0.0, 0.0, 0.02);
    builder.cuboid(Slot::PlasticDark, pan);
}

/// The bar behind a back: level under the seat, upright behind it.
fn bar(chair: &Swivel, builder: &mut Builder, share: f64) {
    let y = chair.under() - 0.008;
    let (heel, top) = (chair.lean(chair.seat) - 0.034, chair.rise(share));
    let under = Bay::new([-BAR / 2.0, BAR / 2.0], [y - 0.005, y + 0.005], [heel - 0.005, -chair.half * 0.2]);
    builder.cuboid(Slot::MetalDark, under);
    let ends = [DVec3::new(0.0, y, heel), DVec3::new(0.0, top, chair.lean(top) - 0.012)];
    builder.add(Slot::MetalDark, flat_bar(ends, BAR * 0.98, 0.009));
}

/// A full back with closed loops of plastic as arm rests.
pub(super) fn loop_arms(chair: &Swivel, builder: &mut Builder) {
    chair.five_star(builder, Slot::PlasticDark, Slot::PlasticDark);
    seat(chair, builder, Slot::FabricAccent, 0.8);
    bar(chair, builder, 0.55);
    let pad = [(0.12, 0.56), (0.2, 0.7), (0.6, 0.72), (0.92, 0.62), (0.99, 0.44)];
    builder.add(Slot::FabricAccent, chair.back(&pad, 0.045, 0.02));
    let (x, top, y) = (chair.bay.high.x - 0.018, chair.seat + ARM_RISE, chair.seat - 0.045);
    let (front, back) = (chair.half * 0.38, -chair.half * 0.46);
    let handle = [
        DVec3::new(chair.half * 0.6, y, 0.0),
        DVec3::new(x, y, front * 0.5),
        DVec3::new(x, top - 0.03, front),
        DVec3::new(x, top - 0.018, back * 0.7),
        DVec3::new(x, y + 0.03, back),
        DVec3::new(chair.half * 0.6, y, back * 0.6),
    ];
    builder.add_pair(Slot::PlasticDark, pipe(&handle, 0.016, 0.05));
}

/// A shell moulded in one piece, on the foot alone.
pub(super) fn plastic_shell(chair: &Swivel, builder: &mut Builder) {
    chair.five_star(builder, Slot::PlasticDark, Slot::Metal);
    let (thickness, rim) = (0.012, 0.05);
    let heel = chair.bay.low.z + BACK_DEPTH;
    let station = |z: f64, y: f64, wide: f64, share: f64| Station {
        at: DVec3::new(0.0, y, z),
        half_width: chair.half * wide,
        sag: rim * share,
    };
    let upper = |rise: f64, wide: f64, share: f64| {
        let y = chair.rise(rise);
        station(chair.lean(y), y, wide, share)
    };
    let seat = chair.seat - thickness;
    let stations = [
        station(chair.half * 0.84, seat - 0.045, 0.66, 0.0),
        station(chair.half * 0.76, seat - 0.008, 0.76, 0.2),
        station(chair.half * 0.3, seat - 0.012, 0.8, 0.5),
        station(heel + 0.09, seat - 0.03, 0.8, 1.0),
        station(heel, seat + 0.03, 0.78, 1.0),
        upper(0.4, 0.8, 0.9),
        upper(0.93, 0.74, 0.5),
        upper(0.995, 0.56, 0.3),
    ];
    builder.add(Slot::Plastic, sheet(&stations, DVec3::NEG_X, thickness, 4));
    let under = chair.seat_bay(0.03, 0.5).moved(0.0, -0.04, 0.0).inset(0.0, 0.0, chair.half * 0.24);
    builder.cuboid(Slot::PlasticDark, under);
}

/// Artificial leather in two pads, one for the loins and one for the shoulders.
pub(super) fn two_pads(chair: &Swivel, builder: &mut Builder) {
    chair.five_star(builder, Slot::Chrome, Slot::Chrome);
    builder.add(Slot::Leather, crowned(chair.seat_bay(0.06, 0.8), 0.026, 0.012));
    bar(chair, builder, 0.86);
    let low = [(0.16, 0.54), (0.2, 0.64), (0.46, 0.66), (0.5, 0.58)];
    let high = [(0.56, 0.58), (0.6, 0.64), (0.92, 0.56), (0.99, 0.4)];
    builder.add(Slot::Leather, chair.back(&low, 0.044, 0.014));
    builder.add(Slot::Leather, chair.back(&high, 0.044, 0.014));
}
