//! School chairs: seats 0.38 to 0.46 m high by size (EN 1729-1), stackable, with a grip in the back.

use glam::DVec3;

use super::plain::stretchers;
use super::traditional::back_posts;
use super::{Chair, TUBE};
use crate::geometry::Side;
use crate::recipes::furniture::parts::slanted_leg;
use crate::recipes::furniture::seating::depth_slats;
use crate::recipes::kit::{Bay, Builder, Solid, Station, cuboid, pipe, rounded_box, sheet, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// Metres of bent plywood.
const PLY: f64 = 0.011;

/// A pupil's chair: plywood on a skid, slats of wood, plywood bolted on tube, a moulded shell.
pub(in super::super::super) static SCHOOL_CHAIR: Recipe =
    Recipe::furniture("school_chair", [0.42, 0.46, 0.8]).every_set(school_chair);

fn school_chair(draft: &Draft, builder: &mut Builder) {
    let chair = Chair::new(builder);
    let form = draft.form();
    match draft.set() {
        GeometrySet::Plain => skid(&chair, builder, form),
        GeometrySet::Traditional => wooden(&chair, builder, form),
        GeometrySet::Industrial => bolted(&chair, builder, form),
        GeometrySet::Budget => shell(&chair, builder, form),
    }
}

/// A back between shares of the rise, bowed around the sitter.
fn back(chair: &Chair, [low, high]: [f64; 2], wide: f64, thickness: f64) -> Solid {
    let station = |rise: f64, share: f64| {
        let y = chair.rise(rise);
        let at = DVec3::new(0.0, y, chair.lean(y) + thickness);
        Station { at, half_width: chair.half * wide * share, sag: 0.012 }
    };
    let span = high - low;
    let stations = [
        station(low, 0.86),
        station(low + span * 0.18, 1.0),
        station(high - span * 0.2, 1.0),
        station(high, 0.84),
    ];
    sheet(&stations, DVec3::NEG_X, thickness, 4)
}

/// A seat of plywood whose front edge rolls down.
fn seat(chair: &Chair, thickness: f64) -> Solid {
    let bay = chair.bay;
    let station = |forward: f64, drop: f64, wide: f64| Station {
        at: chair.at(0.0, chair.seat - thickness / 2.0 - drop, forward),
        half_width: chair.half * wide,
        sag: 0.004,
    };
    let front = 1.0 - 0.006 / bay.depth();
    let stations = [
        station(front, 0.03, 0.86),
        station(front - 0.05, 0.002, 0.94),
        station(0.5, 0.008, 0.96),
        station(0.14, 0.0, 0.88),
    ];
    sheet(&stations, DVec3::NEG_X, thickness, 4)
}

/// One loop of tube on each side: along the floor, up in front, back under the seat, up behind the back.
fn skid(chair: &Chair, builder: &mut Builder, form: usize) {
    let slot = [Slot::Wood, Slot::WoodLight, Slot::PaintedAccent, Slot::Wood][form];
    let frame = [Slot::Metal, Slot::PaintedAccent, Slot::MetalDark, Slot::Chrome][form];
    builder.add(slot, seat(chair, PLY));
    builder.add(slot, back(chair, [0.42, 0.995], 0.92, PLY));
    let x = 1.0 - TUBE / chair.half;
    let under = chair.seat - 0.03;
    let top = chair.rise(0.86);
    let front = if form.is_multiple_of(2) { 0.9 } else { 0.52 };
    let loop_tube = [
        chair.at(x, TUBE, 0.03),
        chair.at(x, TUBE, 0.96),
        chair.at(x, under - 0.02, front),
        chair.at(x, under, front - 0.12),
        chair.at(x, under, 0.2),
        DVec3::new(x * chair.half, top, chair.lean(top) - 0.004),
    ];
    builder.add_pair(frame, pipe(&loop_tube, TUBE, 0.05));
    for forward in [0.3, front - 0.16] {
        let bar = [chair.at(-x, under - 0.004, forward), chair.at(x, under - 0.004, forward)];
        builder.add(frame, sweep(&bar, TUBE * 0.8, 6));
    }
    let floor = [chair.at(-x, TUBE * 1.1, 0.06), chair.at(x, TUBE * 1.1, 0.06)];
    builder.add(frame, sweep(&floor, TUBE * 0.8, 6));
}

/// Square legs that go on as posts, slats on the seat and across the back.
fn wooden(chair: &Chair, builder: &mut Builder, form: usize) {
    let slot = [Slot::Wood, Slot::WoodDark, Slot::Wood, Slot::WoodDark][form];
    let high = chair.bay.high.y;
    back_posts(chair, builder, slot, 0.026, high);
    for side in [Side::Left, Side::Right] {
        let leg = chair.bay.inset(0.004, 0.0, 0.004).slab(side, 0.03).slab(Side::Front, 0.03);
        builder.cuboid(slot, leg.with_y([0.0, chair.seat - 0.022]));
    }
    let board = chair.seat_bay(0.024).inset(0.002, 0.0, 0.0);
    if form.is_multiple_of(2) {
        builder.add(slot, rounded_box(board, DVec3::splat(0.007), 1));
    } else {
        depth_slats(board, 4, 0.01).into_iter().for_each(|slat| builder.cuboid(slot, slat));
    }
    let rail = chair.seat_bay(0.07).without(Side::Above, 0.0235).inset(0.02, 0.0, 0.014);
    for side in [Side::Left, Side::Right] {
        builder.cuboid(slot, rail.slab(side, 0.018).without(Side::Front, 0.001));
    }
    builder.cuboid(slot, rail.slab(Side::Front, 0.018).inset(0.01, 0.001, 0.0));
    let shares: &[[f64; 2]] =
        if form < 2 { &[[0.4, 0.56], [0.76, 0.97]] } else { &[[0.3, 0.42], [0.54, 0.66], [0.8, 0.97]] };
    for &[low, top] in shares {
        let (low, top) = (chair.rise(low), chair.rise(top));
        let at = DVec3::new(0.0, (low + top) / 2.0, chair.lean((low + top) / 2.0) - 0.004);
        builder.cuboid(slot, Bay::around(at, chair.half * 1.9, top - low, 0.014));
    }
    stretchers(chair, builder, slot, 0.34, 0.011);
}

/// Plywood on four legs of tube, bolts showing.
fn bolted(chair: &Chair, builder: &mut Builder, form: usize) {
    let slot = [Slot::Wood, Slot::WoodDark, Slot::Metal, Slot::Wood][form];
    let frame = [Slot::MetalDark, Slot::Metal, Slot::MetalDark, Slot::PaintedAccent][form];
    builder.add(slot, seat(chair, PLY * 1.1));
    builder.add(slot, back(chair, [0.5, 0.995], 0.98, PLY));
    let under = chair.seat - 0.034;
    let x = 0.86;
    let top = chair.rise(0.9);
    let hind = [
        chair.at(0.96, 0.0, 0.03),
        chair.at(x, under, 0.17),
        DVec3::new(x * chair.half, top, chair.lean(top) - 0.002),
    ];
    builder.add_pair(frame, sweep(&hind, TUBE, 6));
    let fore = [chair.at(0.96, 0.0, 0.96), chair.at(x, under, 0.82), chair.at(x, under, 0.19)];
    builder.add_pair(frame, sweep(&fore, TUBE, 6));
    for forward in [0.26, 0.7] {
        let bar = [chair.at(-x, under, forward), chair.at(x, under, forward)];
        builder.add(frame, sweep(&bar, TUBE * 0.8, 6));
    }
    let y = chair.seat * 0.4;
    let side = [chair.at(0.9, y, 0.1), chair.at(0.9, y, 0.9)];
    builder.add_pair(frame, sweep(&side, TUBE * 0.6, 4));
    for rise in [0.66, 0.84] {
        let y = chair.rise(rise);
        let head =
            Bay::around(DVec3::new(x * chair.half * 0.94, y, chair.lean(y) + 0.024), 0.016, 0.016, 0.012);
        builder.add_pair(Slot::Metal, cuboid(head));
    }
    for forward in [0.28, 0.68] {
        let head = Bay::around(chair.at(0.6, chair.seat - 0.004, forward), 0.016, 0.012, 0.016);
        builder.add_pair(Slot::Metal, cuboid(head));
    }
}

/// A shell with a grip in its back, on four legs of tube with plastic feet.
fn shell(chair: &Chair, builder: &mut Builder, form: usize) {
    let slot = [Slot::PaintedAccent, Slot::PlasticDark, Slot::Book, Slot::Leaf][form];
    builder.add(slot, chair.shell(0.01, 0.034, 0.9));
    let y = chair.rise(0.86);
    let grip = Bay::around(DVec3::new(0.0, y, chair.lean(y)), chair.half * 0.5, 0.022, 0.022);
    builder.add(Slot::MetalDark, rounded_box(grip, DVec3::splat(0.006), 1));
    let (top, frame) = (chair.seat - 0.072, [Slot::Metal, Slot::Chrome, Slot::MetalDark, Slot::Metal][form]);
    for (forward, up) in [(0.97, 0.74), (0.03, 0.28)] {
        let leg = [chair.at(0.3, top, up), chair.at(0.7, top, up), chair.at(0.955, 0.012, forward)];
        builder.add_pair(frame, sweep(&leg, TUBE, 6));
        let shoe = [chair.at(0.956, 0.0, forward), chair.at(0.945, 0.035, forward)];
        builder.add_pair(Slot::PlasticDark, slanted_leg(shoe, 0.015, &[(1.0, 0.0), (0.9, 1.0)], 6));
    }
    let plate =
        Bay::around(chair.at(0.0, top + 0.004, 0.5), chair.half * 0.7, 0.022, chair.bay.depth() * 0.52);
    builder.cuboid(frame, plate);
}
