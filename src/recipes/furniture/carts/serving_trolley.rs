//! Serving trolleys: 0.7 to 0.9 m long, 0.45 to 0.5 wide, 0.80 to 0.95 high, two or three trays 0.25 to 0.4 m apart. What
//! is served stands on the upper one, which ends with the box; nothing rises over it.

use std::f64::consts::PI;

use glam::DVec3;

use super::castors;
use crate::geometry::Side;
use crate::recipes::furniture::parts::{LegKind, legs_at_corners, slab_top, turned_forward};
use crate::recipes::furniture::seating::depth_slats;
use crate::recipes::kit::{
    Bay, Builder, Outline, SINK, Slice, Solid, cuboid, cylinder, lathe, loft, loft_ring, sweep,
};
use crate::recipes::{Recipe, Slot};

/// Radius of a turned post as a share of its thickest, at a share of its height.
const TURNED: [(f64, f64); 7] =
    [(0.6, 0.0), (0.95, 0.12), (0.55, 0.22), (1.0, 0.45), (0.55, 0.72), (0.95, 0.84), (0.7, 1.0)];

/// A trolley with two or three trays: in two bows of tube; on turned legs and two wheels with spokes; of steel pans in
/// angles; of plastic tubs on thick columns.
pub(in super::super) static SERVING_TROLLEY: Recipe = Recipe::furniture("serving_trolley", [0.8, 0.5, 0.85])
    .plain(|draft, builder| bar_trolley(builder, draft.form()))
    .traditional(|draft, builder| tea_trolley(builder, draft.form()))
    .industrial(|draft, builder| pan_trolley(builder, draft.form()))
    .budget(|draft, builder| tub_trolley(builder, draft.form()));

/// Thin boards between two bows of tube, which are the handles.
fn bar_trolley(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let (board, metal) = [
        (Slot::Wood, Slot::MetalDark),
        (Slot::Glass, Slot::Brass),
        (Slot::Painted, Slot::Metal),
        (Slot::WoodLight, Slot::Chrome),
    ][look];
    let (lift, tube) = (0.07_f64.min(bay.height() * 0.1), 0.012);
    castors(builder, bay.inset(0.03, 0.0, 0.0), lift);
    let (x, z) = (bay.high.x - tube, bay.high.z - lift * 0.5);
    // The bows lean outwards and reach the sides of the box above.
    let foot = x - 0.03 - lift * 0.5;
    let path = [
        (foot, lift - SINK, z),
        (x, bay.high.y - tube, z),
        (x, bay.high.y - tube, -z),
        (foot, lift - SINK, -z),
    ]
    .map(DVec3::from);
    builder.add_pair(metal, sweep(&path, tube, 4));
    let trays: &[f64] = if look.is_multiple_of(2) { &[0.24, 1.0] } else { &[0.2, 0.58, 1.0] };
    for (index, &rise) in trays.iter().enumerate() {
        let half = foot + (x - foot) * rise;
        let tray = bay.with_x([-half, half]).with_y([bay.high.y * rise - 0.022, bay.high.y * rise]);
        builder.block(board, tray.inset(0.0, 0.0, if index == 0 { 0.0 } else { 0.001 }), 0.004);
        if rise < 1.0 {
            rail(builder, metal, tray.inset(0.002, 0.0, lift * 0.5 - 0.003), 0.05);
            goods(builder, tray, index + look);
        }
    }
}

/// A tray with moulded edges and a handle over another, between turned legs: two stand on castors, two on an axle with
/// wheels.
fn tea_trolley(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let wood = [Slot::WoodDark, Slot::Wood, Slot::Wood, Slot::WoodDark][look];
    let wheel = bay.height().min(bay.width()) * 0.14;
    let top = bay.slab(Side::Above, 0.03).without(Side::Left, 0.045).without(Side::Right, 0.01);
    slab_top(builder, wood, top, true);
    let shelf_top = bay.height() * 0.4;
    // The wheels end with the box.
    let legs = top.inset(0.03, 0.0, 0.045).without(Side::Right, wheel - 0.05);
    let shelf = legs.with_y([shelf_top - 0.022, shelf_top]).inset(-0.012, 0.0, -0.012);
    slab_top(builder, wood, shelf, true);
    rail(
        builder,
        if look.is_multiple_of(2) { Slot::Brass } else { wood },
        shelf.inset(0.012, 0.0, 0.012),
        0.05,
    );
    goods(builder, shelf, look);
    let caster = wheel * 0.4;
    for z in [legs.low.z + 0.02, legs.high.z - 0.02] {
        for (x, low) in [(legs.low.x + 0.02, caster), (bay.high.x - wheel, wheel * 0.8)] {
            let span = top.low.y + SINK - low;
            let profile = TURNED.map(|(share, rise)| (0.022 * share, low + rise * span));
            builder.add(wood, lathe(&profile, 6).moved(x, 0.0, z));
        }
        super::castor(builder, DVec3::new(legs.low.x + 0.02, 0.0, z), caster + 0.01);
    }
    spoked_wheels(builder, wood, DVec3::new(bay.high.x - wheel, wheel, bay.high.z), wheel);
    let y = top.center().y - 0.004;
    let grip = [(0.009, -0.5), (0.014, -0.3), (0.01, 0.0), (0.014, 0.3), (0.009, 0.5)]
        .map(|(radius, share)| (radius, share * bay.depth() * 0.8));
    builder.add(wood, turned_forward(lathe(&grip, 6)).moved(bay.low.x + 0.014, y, 0.0));
    for z in [-0.3, 0.3].map(|share| share * bay.depth()) {
        let arm =
            Bay::new([bay.low.x + 0.012, top.low.x + 0.04], [y - 0.008, y + 0.008], [z - 0.01, z + 0.01]);
        builder.cuboid(wood, arm);
    }
}

/// Two wheels with six spokes on an axle, whose middle on the right is given with the outer end.
fn spoked_wheels(builder: &mut Builder, wood: Slot, at: DVec3, radius: f64) {
    let thick = 0.018;
    let place = |solid: Solid, z: f64| turned_forward(solid).moved(at.x, at.y, z);
    for z in [at.z - thick / 2.0, thick / 2.0 - at.z] {
        let slice = |share: f64, y: f64| Slice::round(y, radius * share);
        let rim = loft_ring(
            &Outline::Round(12),
            &[
                slice(1.0, -thick / 2.0),
                slice(1.0, thick / 2.0),
                slice(0.84, thick / 2.0),
                slice(0.84, -thick / 2.0),
            ],
        );
        builder.add(wood, place(rim, z));
        builder.add(Slot::Brass, place(cylinder(radius * 0.2, [-thick * 0.45, thick * 0.45], 6), z));
        for turn in 0..3 {
            let bar = Bay::around(DVec3::ZERO, radius * 1.76, 0.009 - 0.001 * f64::from(turn), 0.012);
            let spoke = cuboid(bar).turned_y(PI / 3.0 * f64::from(turn));
            builder.add(wood, place(spoke, z));
        }
    }
    let axle = cylinder(0.008, [-at.z + thick, at.z - thick], 6);
    builder.add(Slot::MetalDark, place(axle, 0.0));
}

/// Steel pans with high sides between angles, a plank on top, a bow of pipe to push by.
fn pan_trolley(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let metal = [Slot::Metal, Slot::MetalDark, Slot::Metal, Slot::MetalDark][look];
    let (lift, sheet) = (0.13_f64.min(bay.height() * 0.16), 0.004);
    let body = bay.without(Side::Left, 0.045);
    castors(builder, body, lift);
    legs_at_corners(builder, metal, body.with_y([lift - SINK, bay.high.y - 0.003]), 0.035, LegKind::Angle);
    let inner = body.inset(sheet - SINK, 0.0, sheet - SINK);
    let rises: &[f64] = if look < 2 { &[0.2, 0.62] } else { &[0.2, 0.45, 0.7] };
    for (index, &rise) in rises.iter().enumerate() {
        let floor = bay.height() * rise;
        pan(builder, metal, inner.with_y([floor - sheet, floor + 0.06]));
        if index == 0 || look < 2 {
            goods(builder, inner.with_y([floor - sheet, floor]), index + look);
        }
    }
    let plank = body.inset(sheet, 0.0, sheet).slab(Side::Above, 0.035);
    for board in depth_slats(plank, 3, 0.004) {
        builder.cuboid(if look == 2 { Slot::Metal } else { Slot::Wood }, board);
    }
    let (z, tube) = (bay.high.z - 0.06, 0.013);
    let y = bay.high.y - tube - 0.04;
    let bow = [
        (body.low.x + 0.002, y - 0.06),
        (bay.low.x + tube, y),
        (bay.low.x + tube, y),
        (body.low.x + 0.002, y - 0.06),
    ];
    let path: Vec<DVec3> = bow.iter().zip([z, z, -z, -z]).map(|(&(x, y), z)| DVec3::new(x, y, z)).collect();
    builder.add(Slot::MetalDark, sweep(&path, tube, 6));
}

/// A pan of sheet: a floor and four sides.
fn pan(builder: &mut Builder, slot: Slot, bay: Bay) {
    let sheet = 0.004;
    builder.cuboid(slot, bay.slab(Side::Below, sheet).inset(0.001, 0.0, 0.001));
    let sides = bay.without(Side::Below, sheet - SINK);
    for end in [Side::Front, Side::Back] {
        builder.cuboid(slot, sides.slab(end, sheet).inset(0.0006, 0.0, 0.0));
    }
    for side in [Side::Left, Side::Right] {
        builder.cuboid(slot, sides.slab(side, sheet).inset(0.0, 0.001, sheet - SINK));
    }
}

/// Moulded tubs with round corners on thick columns, the upper one under a lid with a grip at its end.
fn tub_trolley(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let (tub, column) = [
        (Slot::PlasticDark, Slot::Plastic),
        (Slot::Plastic, Slot::PlasticDark),
        (Slot::PlasticDark, Slot::Metal),
        (Slot::PaintedAccent, Slot::PlasticDark),
    ][look];
    let lift = 0.11_f64.min(bay.height() * 0.15);
    let body = bay.without(Side::Right, 0.05);
    castors(builder, body.inset(0.02, 0.0, 0.02), lift);
    let (x, z) = (body.width() / 2.0 - 0.055, bay.high.z - 0.055);
    let middle = body.center().x;
    let post = |radius: f64| cylinder(radius, [lift - SINK, bay.high.y - 0.02], 8);
    for (x, z) in [(-x, -z), (-x, z), (x, -z), (x, z)] {
        builder.add(column, post(0.03).moved(middle + x, 0.0, z));
    }
    for (index, rise) in [0.24, 0.56].into_iter().enumerate() {
        let high = bay.height() * rise;
        let deep = 0.09;
        let slice = |y: f64, back: f64| {
            Slice::new(y, body.width() / 2.0 - back, bay.high.z - back).softened(0.07 - back).at(middle, 0.0)
        };
        let slices = [
            slice(high - deep, 0.012),
            slice(high, if index == 0 { 0.0 } else { 0.001 }),
            slice(high, 0.008),
            slice(high - deep + 0.012, 0.02),
        ];
        builder.add(tub, loft(&Outline::Soft(2), &slices));
        let floor = body.inset(0.1, 0.0, 0.1).with_y([high - deep, high - deep + 0.0115]);
        goods(builder, floor, index + look);
    }
    let half = body.width() / 2.0;
    let lid = |y: f64, back: f64| {
        Slice::new(y, half - back, bay.high.z - back - 0.0005).softened(0.07 - back).at(middle, 0.0)
    };
    let top = bay.high.y;
    let lid = [lid(top - 0.09, 0.012), lid(top - 0.02, 0.0), lid(top, 0.004)];
    builder.add(tub, loft(&Outline::Soft(2), &lid));
    let grip = [
        (body.high.x - 0.01, z * 0.8),
        (bay.high.x - 0.02, z * 0.66),
        (bay.high.x - 0.02, -z * 0.66),
        (body.high.x - 0.01, -z * 0.8),
    ]
    .map(|(x, z)| DVec3::new(x, top - 0.05, z));
    builder.add(tub, sweep(&grip, 0.02, 6));
}

/// A rail around a tray, some metres over it, on posts in the corners.
fn rail(builder: &mut Builder, slot: Slot, tray: Bay, up: f64) {
    let (bar, y) = (0.006, tray.high.y + up);
    let around = tray.with_y([y - bar, y]);
    for side in [Side::Front, Side::Back] {
        builder.cuboid(slot, around.slab(side, bar).inset(0.0006, 0.0, 0.0));
    }
    for side in [Side::Left, Side::Right] {
        builder.cuboid(slot, around.slab(side, bar).inset(0.0, 0.0004, bar - SINK));
    }
}

/// A bottle, a cup and a bowl on a tray.
fn goods(builder: &mut Builder, tray: Bay, seed: usize) {
    let (y, tall) = (tray.high.y - SINK, 0.2);
    for index in 0..3 {
        let x = tray.center().x + tray.width() * [-0.28, -0.02, 0.26][index];
        let z = tray.depth() * [0.1, -0.14, 0.05][index];
        let (slot, profile): (Slot, &[(f64, f64)]) = match (index + seed) % 3 {
            0 => (Slot::Glass, &[(0.034, 0.0), (0.035, 0.55), (0.013, 0.75), (0.012, 1.0)]),
            1 => (Slot::Ceramic, &[(0.03, 0.0), (0.055, 0.5), (0.05, 0.5), (0.028, 0.1)]),
            _ => (Slot::Ceramic, &[(0.06, 0.0), (0.1, 0.2), (0.095, 0.22), (0.055, 0.06)]),
        };
        let profile: Vec<(f64, f64)> =
            profile.iter().map(|&(radius, rise)| (radius, y + rise * tall)).collect();
        builder.add(slot, lathe(&profile, 8).moved(x, 0.0, z));
    }
}
