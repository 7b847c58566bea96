//! Belts for luggage: 1.0 to 1.2 m wide, 0.35 to 0.50 high, plates or rollers 0.10 to 0.15 apart.

use std::f64::consts::PI;

use glam::{DVec2, DVec3};

use super::parts::{LegKind, leg, turned_forward};
use crate::geometry::Side;
use crate::recipes::kit::{
    Axis, Bay, Builder, Outline, SINK, Slice, cylinder, extrude, loft, loft_ring, sweep,
};
use crate::recipes::{Recipe, Slot};

/// A belt for luggage: a loop of plates around an island; a belt between panelled sides with a rail of brass; rollers
/// between beams of steel; a plain belt over drums on legs.
pub(super) static LUGGAGE_BELT: Recipe = Recipe::furniture("luggage_belt", [6.0, 1.2, 0.45])
    .plain(|_, builder| carousel(builder))
    .traditional(|_, builder| panelled(builder))
    .industrial(|_, builder| rollers(builder))
    .budget(|_, builder| on_drums(builder));

/// An oval of overlapping plates around an island of metal, over a skirt; a bumper runs around.
fn carousel(builder: &mut Builder) {
    let bay = builder.bay();
    let (half, height) = (bay.extent() / 2.0, bay.height());
    let rounded =
        |y: f64, back: f64| Slice::new(y, half.x - back, half.z - back).softened((half.z - back) * 0.96);
    let skirt = [
        rounded(0.0, 0.08),
        rounded(height * 0.16, 0.08),
        rounded(height * 0.2, 0.03),
        rounded(height * 0.72, 0.02),
    ];
    builder.add(Slot::Metal, loft(&Outline::Soft(8), &skirt));
    let (low, high) = (height * 0.7, height * 0.84);
    let bumper = [rounded(low, 0.0), rounded(high, 0.0), rounded(high, 0.035), rounded(low, 0.035)];
    builder.add(Slot::Rubber, loft_ring(&Outline::Soft(8), &bumper));
    let inner = half.z * 0.3;
    let track = half.z - 0.045 - inner;
    let island = |y: f64, back: f64| {
        Slice::new(y, half.x - half.z + inner - back, inner - back).softened((inner - back) * 0.96)
    };
    let rise = [island(height * 0.5, 0.0), island(height * 0.93, 0.0), island(height, 0.03)];
    builder.add(Slot::Metal, loft(&Outline::Soft(6), &rise));
    builder.add(
        Slot::PaintedAccent,
        loft(&Outline::Soft(6), &[island(height * 0.85, -0.004), island(height * 0.9, -0.004)]),
    );
    let straight = half.x - half.z;
    let top = height * 0.86;
    let count = (straight * 2.0 / 0.3).round().clamp(1.0, 40.0) as u32;
    for side in [-1.0, 1.0] {
        let z = side * (inner + track / 2.0);
        let row = Bay::new([-straight, straight], [top - 0.05, top], [z - track / 2.0, z + track / 2.0]);
        for (index, plate) in row.columns(count, -0.004).into_iter().enumerate() {
            let lift = if index % 2 == 0 { 0.0 } else { -0.006 };
            builder.cuboid(
                Slot::Rubber,
                plate.inset(0.0, 0.0, 0.001 + 0.0005 * (index % 2) as f64).moved(0.0, lift, 0.0),
            );
        }
        fan(builder, side, straight, [inner, inner + track], [top - 0.05, top]);
    }
}

/// Plates like slices of a cake around the end of a loop.
fn fan(builder: &mut Builder, side: f64, straight: f64, radii: [f64; 2], y: [f64; 2]) {
    let count = 6;
    for index in 0..count {
        let angle = |step: f64| PI * (step / f64::from(count) - 0.5);
        let (from, to) = (angle(f64::from(index) - 0.02), angle(f64::from(index) + 1.02));
        let at = |angle: f64, radius: f64| {
            let (sine, cosine) = libm::sincos(angle);
            DVec2::new(side * (straight + cosine * radius), sine * radius)
        };
        let inward = 0.0006 * f64::from(index % 2 + 1);
        let (inner, outer) = (radii[0] + inward, radii[1] - inward);
        let middle = (from + to) / 2.0;
        let plate = [at(from, inner), at(from, outer), at(middle, outer), at(to, outer), at(to, inner)];
        let lift = if index % 2 == 0 { -0.003 } else { -0.009 };
        builder.add(Slot::Rubber, extrude(&plate, Axis::Y, y.map(|y| y + lift)));
    }
}

/// Crosswise lines on a belt that runs along x.
fn belt(builder: &mut Builder, bay: Bay) {
    builder.cuboid(Slot::Rubber, bay);
    let count = (bay.width() / 0.5).round().clamp(2.0, 30.0) as u32;
    for joint in bay.columns(count, 0.0).iter().skip(1) {
        let seam = Bay::around(
            DVec3::new(joint.low.x, bay.high.y, bay.center().z),
            0.012,
            0.004,
            bay.depth() - 0.004,
        );
        builder.cuboid(Slot::PlasticDark, seam);
    }
}

/// A belt between boards with raised panels on a plinth; rails of brass on posts along both sides.
fn panelled(builder: &mut Builder) {
    let bay = builder.bay();
    let (height, thick) = (bay.height(), 0.05);
    let top = height * 0.86;
    builder.cuboid(Slot::MetalDark, bay.inset(0.07, 0.0, 0.07).with_y([0.0, height * 0.15]));
    for side in [Side::Front, Side::Back] {
        let board = bay.slab(side, thick).without(side, 0.02).with_y([height * 0.1, top]);
        builder.cuboid(Slot::WoodDark, board.inset(0.02, 0.0, 0.0));
        let face = board
            .inset(0.06, height * 0.12, 0.0)
            .columns((bay.width() / 0.75).round().clamp(1.0, 12.0) as u32, 0.08);
        for panel in face {
            let z = if side == Side::Front {
                [board.high.z - SINK, board.high.z + 0.012]
            } else {
                [board.low.z - 0.012, board.low.z + SINK]
            };
            builder.block(Slot::WoodDark, panel.with_z(z), 0.008);
        }
        let cap = bay.slab(side, 0.1).with_y([top - SINK, top + 0.03]);
        builder.block(Slot::Wood, cap.without(side, 0.004).inset(0.012, 0.0, 0.0), 0.008);
        guard_rail(builder, Slot::Brass, side, top + 0.02);
        builder.cuboid(
            Slot::Brass,
            bay.slab(side, 0.016).inset(0.03, 0.0, 0.0).with_y([height * 0.04, height * 0.1]),
        );
    }
    for side in [Side::Left, Side::Right] {
        let board = bay.slab(side, thick).without(side, 0.014).with_y([height * 0.1 + 0.001, top + 0.02]);
        builder.block(Slot::Wood, board.inset(0.0, 0.0, 0.03), 0.004);
    }
    belt(builder, bay.inset(0.048, 0.0, 0.066).with_y([height * 0.4, top - 0.006]));
}

/// A rail along a side at the height of the box, on posts from another height: luggage stays on the belt.
fn guard_rail(builder: &mut Builder, slot: Slot, side: Side, foot: f64) {
    let bay = builder.bay();
    let (height, z) = (bay.height(), bay.slab(side, 0.05).center().z);
    let rail = [DVec3::new(bay.low.x, height - 0.013, z), DVec3::new(bay.high.x, height - 0.013, z)];
    builder.add(slot, sweep(&rail, 0.0135, 8));
    let count = (bay.width() / 1.0).round().clamp(2.0, 10.0) as u32;
    for post in bay.inset(0.1, 0.0, 0.0).columns(count, 0.0) {
        builder.add(slot, cylinder(0.008, [foot, height - 0.012], 6).moved(post.center().x, 0.0, z));
    }
}

/// Rollers between two beams on legs with braces, a motor below and stops at the ends.
fn rollers(builder: &mut Builder) {
    let bay = builder.bay();
    let height = bay.height() * 0.86;
    let radius = 0.038;
    let axis = height - radius;
    for side in [Side::Front, Side::Back] {
        guard_rail(builder, Slot::MetalDark, side, axis + 0.006);
        let beam = bay.slab(side, 0.012).with_y([axis - 0.09, axis + 0.02]);
        builder.cuboid(Slot::PaintedAccent, beam);
        for y in [axis - 0.09, axis + 0.008] {
            let flange = bay.slab(side, 0.046).without(side, 0.011).with_y([y + 0.0006, y + 0.008]);
            builder.cuboid(Slot::PaintedAccent, flange.inset(0.0008, 0.0, 0.0));
        }
    }
    let count = (bay.width() / 0.14).floor().clamp(2.0, 48.0) as u32;
    let z = [bay.low.z + 0.011, bay.high.z - 0.011];
    for place in bay.inset(0.02, 0.0, 0.0).columns(count, 0.0) {
        let roller = turned_forward(cylinder(radius, z, 8));
        builder.add(Slot::Metal, roller.moved(place.center().x, axis, 0.0));
    }
    let pairs = (bay.width() / 1.5).round().clamp(1.0, 6.0) as u32 + 1;
    for index in 0..pairs {
        let x = bay.low.x + 0.1 + (bay.width() - 0.2) * f64::from(index) / f64::from(pairs - 1);
        for side in [Side::Front, Side::Back] {
            let post = bay.slab(side, 0.05).without(side, 0.012 - SINK).with_x([x - 0.025, x + 0.025]);
            builder.cuboid(Slot::MetalDark, post.with_y([0.008, axis - 0.03]));
            builder.cuboid(Slot::MetalDark, post.with_y([0.0, 0.0085]).inset(-0.03, 0.0, -0.011));
        }
        let tie = Bay::around(DVec3::new(x, height * 0.24, 0.0), 0.03, 0.03, bay.depth() - 0.098);
        builder.cuboid(Slot::MetalDark, tie);
    }
    let motor = Bay::around(DVec3::new(0.3, axis - 0.16, 0.0), 0.4, 0.14, 0.3);
    builder.block(Slot::Metal, motor, 0.01);
    let drum = turned_forward(cylinder(0.06, [-0.3, 0.0], 10));
    builder.add(Slot::MetalDark, drum.moved(0.22, axis - 0.17, -0.1));
    for end in [Side::Left, Side::Right] {
        let stop = bay.slab(end, 0.02).inset(0.0, 0.0, 0.014).with_y([axis - 0.05, axis - 0.01]);
        builder.cuboid(Slot::MetalDark, stop);
    }
}

/// A belt that turns around two drums in a shallow body of folded sheet on square legs.
fn on_drums(builder: &mut Builder) {
    let bay = builder.bay();
    let height = bay.height() * 0.86;
    let radius = 0.07;
    let middle = height - radius;
    let rim = 0.06;
    for side in [Side::Front, Side::Back] {
        guard_rail(builder, Slot::Metal, side, middle + radius * 0.6);
    }
    for end in [bay.low.x + radius, bay.high.x - radius] {
        let drum = turned_forward(cylinder(radius, [bay.low.z + rim + 0.004, bay.high.z - rim - 0.004], 16));
        builder.add(Slot::Rubber, drum.moved(end, middle, 0.0));
    }
    let run = bay.inset(radius, 0.0, rim + 0.006).with_y([middle - radius * 0.96, height - 0.002]);
    belt(builder, run);
    for side in [Side::Front, Side::Back] {
        let wall = bay
            .slab(side, rim)
            .without(side, 0.004)
            .inset(radius * 0.4, 0.0, 0.0)
            .with_y([middle - radius * 1.4, middle + radius * 0.7]);
        builder.block(Slot::Metal, wall, 0.012);
        let count = (bay.width() / 1.6).round().clamp(1.0, 6.0) as u32;
        for place in bay.inset(0.2, 0.0, 0.0).columns(count, 0.0) {
            let x = place.center().x;
            let post = bay.slab(side, rim).inset(0.0, 0.0, 0.006).with_x([x - 0.024, x + 0.024]);
            leg(builder, Slot::MetalDark, post.with_y([0.0, middle - radius * 1.4 + SINK]), LegKind::Square);
        }
    }
    let stop = bay.slab(Side::Front, 0.002).center();
    let button = turned_forward(cylinder(0.03, [-SINK - 0.02, 0.0], 10));
    builder.add(Slot::Book, button.moved(bay.high.x - 0.4, middle - radius * 0.3, stop.z + 0.001));
}
