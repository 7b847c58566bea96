//! Pool tables: 8 feet are 2.54 by 1.42 m outside, 0.8 high, six pockets 0.11 to 0.13 m wide (WPA).

use glam::DVec3;

use crate::geometry::Side;
use crate::recipes::furniture::parts::{LegKind, leg, legs_at_corners, slab_top};
use crate::recipes::kit::{Bay, Builder, Outline, SINK, Slice, cylinder, lathe, loft, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// Metres of a ball's diameter.
const BALL: f64 = 0.057;

/// A table with cloth between cushions and six pockets: on broad legs; on turned ones under a moulded frame; on steel
/// trestles; on panels that take off.
pub(in super::super) static POOL_TABLE: Recipe =
    Recipe::furniture("pool_table", [2.54, 1.42, 0.8]).symbol(Symbol::Frame).every_set(pool_table);

fn pool_table(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let wood = draft.sampler().pick(&[Slot::WoodDark, Slot::Wood]);
    let rim = bay.slab(Side::Above, bay.height() * 0.18);
    let edge = bay.width().min(bay.depth()) * 0.1;
    let slot = match draft.set() {
        GeometrySet::Industrial => Slot::MetalDark,
        GeometrySet::Budget => Slot::Laminate,
        _ => wood,
    };
    let bed = table_top(builder, slot, rim, edge);
    pockets(builder, rim, edge, draft.set());
    balls(builder, bed, bed.high.y);
    let below = bay.without(Side::Above, rim.height() - SINK);
    match draft.set() {
        GeometrySet::Plain => broad_legs(builder, wood, below, edge),
        GeometrySet::Traditional => turned_legs(builder, wood, below, edge),
        GeometrySet::Industrial => trestles(builder, below, edge),
        GeometrySet::Budget => panels(builder, below, edge),
    }
}

/// Cushions around the cloth; gives the bed.
fn table_top(builder: &mut Builder, slot: Slot, rim: Bay, edge: f64) -> Bay {
    for side in [Side::Front, Side::Back] {
        builder.block(slot, rim.slab(side, edge), 0.01);
    }
    for side in [Side::Left, Side::Right] {
        builder.block(slot, rim.slab(side, edge).inset(0.0, 0.002, edge - 0.015), 0.01);
    }
    let bed = rim.inset(edge - 0.01, 0.0, edge - 0.01).without(Side::Above, rim.height() * 0.3);
    builder.cuboid(Slot::FabricAccent, bed);
    bed
}

/// Dark openings in the corners and in the middle of the long sides; nets of leather hang below the traditional ones.
fn pockets(builder: &mut Builder, rim: Bay, edge: f64, set: GeometrySet) {
    let radius = edge * 0.4;
    for x in [-1.0, 0.0, 1.0] {
        for z in [-1.0, 1.0] {
            let reach = if x == 0.0 { edge * 0.45 } else { edge * 0.62 };
            let at = DVec3::new(x * (rim.high.x - reach), rim.high.y, z * (rim.high.z - reach));
            builder.add(Slot::PlasticDark, cylinder(radius, [-0.02, 0.0012], 12).moved(at.x, at.y, at.z));
            if set == GeometrySet::Traditional {
                let net = [(radius * 0.5, -0.19), (radius, -0.14), (radius, -rim.height() + 0.01)];
                builder.add(Slot::Leather, lathe(&net, 8).moved(at.x, at.y, at.z));
            }
        }
    }
}

/// Balls on the cloth.
fn balls(builder: &mut Builder, bed: Bay, floor: f64) {
    for (place, slot) in
        [(-0.25, Slot::Linen), (0.2, Slot::PaintedAccent), (0.24, Slot::Book), (0.28, Slot::Brass)]
    {
        let at = DVec3::new(bed.width() * place, floor + BALL / 2.0 - SINK, bed.center().z);
        builder.cushion(slot, Bay::around(at, BALL, BALL, BALL), BALL * 0.45);
    }
}

fn broad_legs(builder: &mut Builder, wood: Slot, below: Bay, edge: f64) {
    let apron = below.slab(Side::Above, builder.bay().height() * 0.15);
    builder.cuboid(wood, apron.inset(edge * 0.6, 0.0, edge * 0.6));
    let legs = below.with_y([0.0, apron.low.y + SINK]).inset(edge * 0.7, 0.0, edge * 0.7);
    legs_at_corners(builder, wood, legs, edge * 0.9, LegKind::Square);
}

/// Six turned legs under a frame with a moulded edge.
fn turned_legs(builder: &mut Builder, wood: Slot, below: Bay, edge: f64) {
    let apron = below.slab(Side::Above, builder.bay().height() * 0.24).inset(edge * 0.5, 0.0, edge * 0.5);
    builder.cuboid(wood, apron);
    slab_top(
        builder,
        wood,
        apron.slab(Side::Below, 0.035).inset(-0.02, 0.0, -0.02).moved(0.0, -0.01, 0.0),
        true,
    );
    let thick = edge * 1.15;
    let legs = below.with_y([0.0, apron.low.y + SINK]).inset(edge * 0.62, 0.0, edge * 0.62);
    legs_at_corners(builder, wood, legs, thick, LegKind::Baluster);
    for z in [[legs.low.z, legs.low.z + thick], [legs.high.z - thick, legs.high.z]] {
        leg(builder, wood, Bay::new([-thick / 2.0, thick / 2.0], legs.y(), z), LegKind::Baluster);
    }
}

/// Two trestles of square tube, held by a beam and crossed rods.
fn trestles(builder: &mut Builder, below: Bay, edge: f64) {
    let frame = below.slab(Side::Above, 0.1).inset(edge * 0.5, 0.0, edge * 0.5);
    builder.cuboid(Slot::MetalDark, frame);
    let (tube, top) = (0.05, frame.low.y + 0.02);
    let z = below.high.z - edge;
    for x in [-0.32, 0.32].map(|share| share * below.width()) {
        for side in [-1.0, 1.0] {
            let path = [DVec3::new(x, 0.02, side * z), DVec3::new(x, top, side * z * 0.35)];
            builder.add(Slot::MetalDark, sweep(&path, tube, 4));
        }
        builder.cuboid(Slot::MetalDark, Bay::new([x - 0.05, x + 0.05], [0.0, 0.03], [-z - 0.06, z + 0.06]));
        builder.cuboid(
            Slot::MetalDark,
            Bay::new([x - 0.03, x + 0.03], [top * 0.45, top * 0.45 + 0.06], [-z * 0.6, z * 0.6]),
        );
    }
    let x = below.width() * 0.32;
    for ends in [[0.1, top], [top, 0.1]] {
        let rod = [DVec3::new(-x, ends[0], 0.0), DVec3::new(x, ends[1], 0.0)];
        let shift = if ends[0] > ends[1] { 0.03 } else { 0.0 };
        builder.add(Slot::Metal, sweep(&rod, 0.012, 6).moved(0.0, 0.0, shift));
    }
}

/// A tray with rounded ends on two legs of panels, each on two levelling feet.
fn panels(builder: &mut Builder, below: Bay, edge: f64) {
    let tray = below.slab(Side::Above, builder.bay().height() * 0.2).inset(edge * 0.4, 0.0, edge * 0.4);
    builder.block(Slot::PlasticDark, tray, 0.02);
    let depth = below.high.z - edge * 1.2;
    for x in [-0.34, 0.34].map(|share| share * below.width()) {
        let slices = [
            Slice::new(0.03, 0.05, depth).softened(0.03).at(x, 0.0),
            Slice::new(tray.low.y * 0.5, 0.05, depth * 0.45).softened(0.03).at(x, 0.0),
            Slice::new(tray.low.y + SINK, 0.05, depth * 0.8).softened(0.03).at(x, 0.0),
        ];
        builder.add(Slot::Laminate, loft(&Outline::Soft(2), &slices));
        for z in [-depth * 0.85, depth * 0.85] {
            builder.add(Slot::Rubber, cylinder(0.03, [0.0, 0.03 + SINK], 8).moved(x, 0.0, z));
        }
    }
    let ball_box = Bay::around(DVec3::new(tray.high.x, tray.center().y, 0.0), 0.04, tray.height() * 0.5, 0.3);
    builder.cuboid(Slot::Metal, ball_box.moved(-0.015, 0.0, 0.0));
}
