//! Garden chairs: weatherproof, stackable or folding, seats 0.42 to 0.45 m high (EN 581).

use glam::DVec3;

use super::traditional::back_posts;
use super::{Chair, TUBE};
use crate::geometry::Side;
use crate::recipes::furniture::parts::{bowed_board, slanted_leg};
use crate::recipes::furniture::seating::depth_slats;
use crate::recipes::kit::{Bay, Builder, Station, cuboid, pipe, rounded_box, sheet, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// A chair for outdoors: cloth on a frame of tube, scrolled iron or slatted teak, straps of steel, moulded plastic.
pub(in super::super::super) static GARDEN_CHAIR: Recipe =
    Recipe::furniture("garden_chair", [0.48, 0.52, 0.85]).every_set(garden_chair);

fn garden_chair(draft: &Draft, builder: &mut Builder) {
    let chair = Chair::new(builder);
    let form = draft.form();
    match draft.set() {
        GeometrySet::Plain => sling(&chair, builder, form),
        GeometrySet::Traditional if form.is_multiple_of(2) => wrought_iron(&chair, builder, form),
        GeometrySet::Traditional => slatted(&chair, builder, form),
        GeometrySet::Industrial => straps(&chair, builder, form),
        GeometrySet::Budget => moulded(&chair, builder, form),
    }
}

/// Cloth stretched from the front edge to the top of a frame of tube.
fn sling(chair: &Chair, builder: &mut Builder, form: usize) {
    let frame = [Slot::MetalDark, Slot::Painted, Slot::Wood, Slot::Metal][form];
    let cloth = [Slot::Fabric, Slot::FabricLight, Slot::FabricAccent, Slot::PlasticDark][form];
    let x = chair.half - TUBE;
    let high = chair.bay.high.y;
    let rail = [
        DVec3::new(x, chair.seat - 0.012, chair.bay.high.z - TUBE),
        DVec3::new(x, chair.seat - 0.02, chair.bay.low.z + 0.1),
        DVec3::new(x, high - TUBE, chair.lean(high) + 0.002),
    ];
    builder.add_pair(frame, pipe(&rail, TUBE, 0.05));
    for end in [rail[0], rail[2]] {
        let bar = [DVec3::new(-x, end.y, end.z), DVec3::new(x, end.y, end.z)];
        builder.add(frame, sweep(&bar, TUBE * 0.98, 6));
    }
    let station = |y: f64, z: f64, sag: f64| Station { at: DVec3::new(0.0, y, z), half_width: x, sag };
    let middle = chair.rise(0.5);
    let web = [
        station(chair.seat - 0.012, chair.bay.high.z - TUBE, 0.0),
        station(chair.seat - 0.03, chair.bay.low.z + 0.26, 0.012),
        station(chair.seat - 0.026, chair.bay.low.z + 0.12, 0.014),
        station(chair.seat + 0.03, chair.bay.low.z + 0.085, 0.012),
        station(middle, chair.lean(middle), 0.01),
        station(high - TUBE, chair.lean(high) + 0.002, 0.0),
    ];
    builder.add(cloth, sheet(&web, DVec3::NEG_X, 0.005, 2));
    for (foot, top) in [(0.97, 0.66), (0.03, 0.36)] {
        let leg = [
            chair.at(1.0 - TUBE / chair.half, 0.0, foot),
            chair.at(1.0 - TUBE * 1.2 / chair.half, chair.seat - 0.02, top),
        ];
        builder.add_pair(frame, sweep(&leg, TUBE * 0.94, 6));
    }
    let y = chair.seat * 0.45;
    let stay = [chair.at(-0.94, y, 0.17), chair.at(0.94, y, 0.17)];
    builder.add(frame, sweep(&stay, TUBE * 0.7, 6));
}

/// Bars of iron bent to a hoop with scrolls in it, on curved legs.
fn wrought_iron(chair: &Chair, builder: &mut Builder, form: usize) {
    let slot = if form == 0 { Slot::Painted } else { Slot::MetalDark };
    let iron = 0.008;
    let x = chair.half * 0.9;
    let at = |x: f64, rise: f64| DVec3::new(x, chair.rise(rise), chair.lean(chair.rise(rise)) + 0.004);
    let hoop = [
        at(-x, 0.0),
        at(-x * 1.02, 0.55),
        at(-x * 0.7, 0.9),
        at(0.0, 0.985),
        at(x * 0.7, 0.9),
        at(x * 1.02, 0.55),
        at(x, 0.0),
    ];
    builder.add(slot, pipe(&hoop, iron, 0.09));
    for side in [-1.0, 1.0] {
        let scroll = [
            at(side * x * 0.1, 0.06),
            at(side * x * 0.55, 0.3),
            at(side * x * 0.6, 0.55),
            at(side * x * 0.25, 0.7),
            at(side * x * 0.1, 0.5),
            at(side * x * 0.32, 0.42),
        ];
        builder.add(slot, sweep(&scroll, iron * 0.75, 5));
    }
    builder.add(slot, sweep(&[at(0.0, 0.02), at(0.0, 0.97)], iron * 0.7, 5));
    let seat = chair.seat_bay(0.02).inset(0.004, 0.0, 0.0);
    builder.add(slot, rounded_box(seat.slab(Side::Below, 0.012), DVec3::splat(0.005), 1));
    let slats = seat.slab(Side::Above, 0.0085).inset(0.03, 0.0, 0.02);
    for slat in slats.columns(6, slats.width() * 0.05) {
        builder.cuboid(slot, slat);
    }
    for (forward, up) in [(0.96, 0.84), (0.04, 0.18)] {
        let leg = [
            chair.at(0.97, 0.0, forward),
            chair.at(0.86, chair.seat * 0.3, forward * 0.9 + 0.05),
            chair.at(0.94, chair.seat * 0.75, up),
            chair.at(0.84, chair.seat - 0.012, up),
        ];
        builder.add_pair(slot, sweep(&leg, iron, 6));
    }
    let y = chair.seat * 0.34;
    for (from, to) in [((-0.86, 0.9), (0.86, 0.1)), ((0.86, 0.9), (-0.86, 0.1))] {
        let lift = if from.0 < 0.0 { 0.0 } else { iron };
        let stay = [chair.at(from.0, y + lift, from.1), chair.at(to.0, y + lift, to.1)];
        builder.add(slot, sweep(&stay, iron * 0.6, 5));
    }
}

/// Teak: square legs, slats along the seat and up the back.
fn slatted(chair: &Chair, builder: &mut Builder, form: usize) {
    let slot = if form == 1 { Slot::Wood } else { Slot::WoodDark };
    let (high, post) = (chair.bay.high.y, 0.034);
    back_posts(chair, builder, slot, post * 0.8, high - 0.02);
    for side in [Side::Left, Side::Right] {
        let leg = chair.bay.inset(0.004, 0.0, 0.004).slab(side, post).slab(Side::Front, post);
        builder.cuboid(slot, leg.with_y([0.0, chair.seat - 0.016]));
    }
    let frame = chair.seat_bay(0.06).without(Side::Above, 0.0175).inset(0.012, 0.0, 0.012);
    for side in [Side::Left, Side::Right] {
        builder.cuboid(slot, frame.slab(side, 0.02));
    }
    builder.cuboid(slot, frame.slab(Side::Front, 0.02).inset(0.01, 0.001, 0.0));
    for slat in depth_slats(chair.seat_bay(0.018), 6, 0.012) {
        builder.cuboid(slot, slat);
    }
    for rise in [0.14, 0.9] {
        let y = chair.rise(rise);
        let rail = Bay::around(DVec3::new(0.0, y, chair.lean(y) - 0.004), chair.half * 1.86, 0.05, 0.022);
        builder.cuboid(slot, rail);
    }
    for step in -3_i32..=3 {
        let x = f64::from(step) / 3.0 * chair.half * 0.7;
        let (low, top) = (chair.rise(0.14), chair.rise(0.9));
        let ends = [DVec3::new(x, low, chair.lean(low) - 0.002), DVec3::new(x, top, chair.lean(top) - 0.002)];
        builder.add(slot, sweep(&ends, 0.011, 4));
    }
    let crest = DVec3::new(0.0, high - 0.026, chair.lean(high) + 0.003);
    builder.add(slot, bowed_board(crest, DVec3::new(chair.half * 1.9, 0.052, 0.02), 0.0));
}

/// Folding: crossed bars of flat steel, straps across seat and back.
fn straps(chair: &Chair, builder: &mut Builder, form: usize) {
    let frame = [Slot::MetalDark, Slot::Metal, Slot::PaintedAccent, Slot::MetalDark][form];
    let strap = [Slot::Wood, Slot::Metal, Slot::PaintedAccent, Slot::WoodDark][form];
    let high = chair.bay.high.y;
    let (outer, inner) = (1.0 - 0.009 / chair.half, 0.88);
    let long = [
        chair.at(outer, 0.0, 0.97),
        chair.at(outer, chair.seat - 0.02, 0.24),
        DVec3::new(outer * chair.half, high - 0.006, chair.lean(high)),
    ];
    builder.add_pair(frame, sweep(&long, 0.009, 4));
    let short = [chair.at(inner, 0.0, 0.03), chair.at(inner, chair.seat - 0.026, 0.86)];
    builder.add_pair(frame, sweep(&short, 0.009, 4));
    let rail = [chair.at(inner, chair.seat - 0.026, 0.2), chair.at(inner, chair.seat - 0.026, 0.95)];
    builder.add_pair(frame, sweep(&rail, 0.0085, 4));
    for slat in depth_slats(chair.seat_bay(0.02).without(Side::Back, 0.05), 6, 0.014) {
        builder.cuboid(strap, slat.slab(Side::Above, if strap == Slot::Metal { 0.008 } else { 0.016 }));
    }
    for rise in [0.56, 0.74, 0.92] {
        let y = chair.rise(rise);
        let at = DVec3::new(0.0, y, chair.lean(y) + 0.006);
        builder
            .cuboid(strap, Bay::around(at, chair.half * 2.0 - 0.004, chair.rise(0.13) - chair.seat, 0.012));
    }
    for (end, y, forward) in [(outer, 0.09, 0.83), (inner, 0.09, 0.2)] {
        builder.add(frame, sweep(&[chair.at(-end, y, forward), chair.at(end, y, forward)], 0.007, 4));
    }
}

/// One piece of plastic: seat, staves.
fn moulded(chair: &Chair, builder: &mut Builder, form: usize) {
    let slot = [Slot::Plastic, Slot::Leaf, Slot::Plastic, Slot::PlasticDark][form];
    let (high, seat) = (chair.bay.high.y, chair.seat);
    let board = chair.seat_bay(0.028).inset(0.03, 0.0, 0.004);
    builder.add(slot, rounded_box(board, DVec3::new(0.03, 0.01, 0.03), 1));
    builder
        .cuboid(slot, board.inset(0.02, 0.0, 0.02).without(Side::Above, 0.027).without(Side::Below, -0.03));
    for (forward, up) in [(0.96, 0.88), (0.04, 0.14)] {
        let leg = [chair.at(0.93, 0.0, forward), chair.at(0.82, seat - 0.016, up)];
        builder.add_pair(slot, slanted_leg(leg, 0.026, &[(0.8, 0.0), (1.3, 1.0)], 4));
    }
    let across = |x: [f64; 2], wide: f64| {
        let station = |rise: f64, share: f64| {
            let y = chair.rise(rise) - 0.006;
            let at = DVec3::new((x[0] * (1.0 - rise) + x[1] * rise) * chair.half, y, chair.lean(y) + 0.006);
            Station { at, half_width: wide * share, sag: 0.0 }
        };
        sheet(&[station(-0.02, 1.0), station(0.4, 0.9), station(0.93, 1.0)], DVec3::NEG_X, 0.012, 1)
    };
    builder.add_pair(slot, across([0.8, 0.84], 0.03));
    if form.is_multiple_of(2) {
        for x in [-0.5, -0.17, 0.17, 0.5] {
            builder.add(slot, across([x, x * 1.06], 0.022));
        }
    } else {
        for rise in [0.2, 0.4, 0.6] {
            let y = chair.rise(rise);
            let bar = Bay::around(DVec3::new(0.0, y, chair.lean(y) + 0.004), chair.half * 1.6, 0.045, 0.011);
            builder.add(slot, cuboid(bar));
        }
    }
    let crest = DVec3::new(0.0, high - 0.045, chair.lean(high) + 0.014);
    builder.add(slot, bowed_board(crest, DVec3::new(chair.half * 1.86, 0.09, 0.02), -0.012));
}
