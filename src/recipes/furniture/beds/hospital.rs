//! Hospital beds: 0.99 by 2.15 m over the guards, lying at 0.4 to 0.8 m (EN 60601-2-52).

use glam::DVec3;

use crate::geometry::Side;
use crate::recipes::furniture::parts::{LegKind, across, legs_at_corners};
use crate::recipes::kit::{Bay, Builder, SINK, pipe, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// Share of the height at which one lies.
const LYING: f64 = 0.58;

/// A bed on wheels with boards at its ends and guards at its sides: plain; of bent tube with bars; on two columns with guards
/// of panels; with ends and rails of wood, for care at home.
pub(in super::super) static HOSPITAL_BED: Recipe =
    Recipe::furniture("hospital_bed", [0.99, 2.15, 1.0]).symbol(Symbol::Bed).every_set(hospital_bed);

fn hospital_bed(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let lying = bay.height() * LYING;
    bedding(builder, lying);
    match draft.set() {
        GeometrySet::Plain => plain(builder, lying),
        GeometrySet::Traditional => tubes(builder, lying),
        GeometrySet::Industrial => columns(builder, lying),
        GeometrySet::Budget => home(builder, lying),
    }
}

/// A mattress, a pillow and a blanket.
fn bedding(builder: &mut Builder, lying: f64) {
    let bay = builder.bay();
    let mattress = bay.with_y([lying - 0.14, lying]).inset(0.06, 0.0, 0.06);
    builder.cushion(Slot::Linen, mattress, 0.04);
    let pillow = mattress.slab(Side::Back, 0.45).with_y([lying - 0.02, lying + 0.09]).inset(0.14, 0.0, 0.04);
    builder.cushion(Slot::Linen, pillow, 0.045);
    let blanket = mattress.without(Side::Back, bay.depth() * 0.36).with_y([lying - 0.1, lying + 0.015]);
    builder.cushion(Slot::FabricLight, blanket.inset(-0.01, 0.0, 0.01), 0.012);
}

/// Where guards stand: beside the upper half of the mattress.
fn guard_ends(bay: Bay) -> [f64; 2] {
    [bay.low.z + 0.25, bay.low.z + bay.depth() * 0.6]
}

fn plain(builder: &mut Builder, lying: f64) {
    let bay = builder.bay();
    builder.cuboid(Slot::Metal, bay.with_y([lying - 0.22, lying - 0.13]).inset(0.05, 0.0, 0.04));
    for (side, height) in [(Side::Back, bay.high.y), (Side::Front, bay.high.y * 0.85)] {
        let board = bay.slab(side, 0.05).with_y([lying - 0.25, height]).inset(0.03, 0.0, 0.0);
        builder.block(Slot::Plastic, board, 0.02);
    }
    for side in [Side::Left, Side::Right] {
        let guard = bay.slab(side, 0.03).with_z(guard_ends(bay));
        builder.block(Slot::Chrome, guard.with_y([lying + 0.13, lying + 0.17]), 0.01);
        let post = guard.with_y([lying - 0.2, lying + 0.14]).inset(0.004, 0.0, 0.02);
        builder.cuboid(Slot::Chrome, post.slab(Side::Front, 0.03));
        builder.cuboid(Slot::Chrome, post.slab(Side::Back, 0.03));
    }
    let legs = bay.with_y([0.0, lying - 0.2]).inset(0.12, 0.0, 0.25);
    legs_at_corners(builder, Slot::Rubber, legs.slab(Side::Below, 0.12), 0.06, LegKind::Square);
    let upper = legs.without(Side::Below, 0.12 - SINK).inset(0.01, 0.0, 0.01);
    legs_at_corners(builder, Slot::Metal, upper, 0.04, LegKind::Square);
}

/// Bows of tube with bars at both ends, side rails between them, a crank and a board for the chart.
fn tubes(builder: &mut Builder, lying: f64) {
    let bay = builder.bay();
    let tube = 0.022;
    let x = bay.high.x - tube;
    for (z, high) in [(bay.low.z + tube, bay.high.y), (bay.high.z - tube, bay.high.y * 0.85)] {
        let at = |x: f64, y: f64| DVec3::new(x, y, z);
        let top = high - tube;
        builder.add(Slot::Painted, pipe(&[at(-x, 0.04), at(-x, top), at(x, top), at(x, 0.04)], tube, 0.16));
        let low = lying - 0.1;
        builder.add(Slot::Painted, sweep(&[at(-x, low), at(x, low)], tube * 0.8, 6));
        for step in 1..6 {
            let x = x * (f64::from(step) / 3.0 - 1.0);
            builder.add(Slot::Painted, sweep(&[at(x, low), at(x, top)], 0.01, 6));
        }
        for x in [-x, x] {
            builder.add(Slot::Rubber, across(0.035, [x - 0.014, x + 0.014], 10).moved(0.0, 0.035, z));
        }
    }
    let rail = bay.with_y([lying - 0.2, lying - 0.13]).inset(0.03, 0.0, 0.04);
    for side in [Side::Left, Side::Right] {
        builder.cuboid(Slot::Painted, rail.slab(side, 0.02));
    }
    for slat in super::super::seating::depth_slats(rail.inset(0.018, 0.024, 0.04), 9, 0.14) {
        builder.cuboid(Slot::Metal, slat);
    }
    let chart = Bay::around(DVec3::new(0.1, lying + 0.04, bay.high.z - 0.006), 0.22, 0.3, 0.01);
    builder.cuboid(Slot::Paper, chart.with_y([lying - 0.02, bay.high.y * 0.85 - 0.06]));
    let crank = [
        DVec3::new(-0.2, lying - 0.22, bay.high.z - 0.3),
        DVec3::new(-0.2, lying - 0.22, bay.high.z - 0.05),
        DVec3::new(-0.2, lying - 0.32, bay.high.z - 0.045),
        DVec3::new(-0.2, lying - 0.32, bay.high.z - 0.01),
    ];
    builder.add(Slot::Metal, sweep(&crank, 0.01, 6));
    builder
        .cuboid(Slot::Metal, Bay::around(DVec3::new(-0.2, lying - 0.2, bay.high.z - 0.29), 0.06, 0.08, 0.06));
}

/// A box on two columns over a chassis with large wheels; guards and ends of panels with openings.
fn columns(builder: &mut Builder, lying: f64) {
    let bay = builder.bay();
    let deck = bay.with_y([lying - 0.21, lying - 0.13]).inset(0.06, 0.0, 0.05);
    builder.block(Slot::MetalDark, deck, 0.012);
    for z in [-0.28, 0.28].map(|share| share * bay.depth()) {
        let column = Bay::around(DVec3::new(0.0, 0.0, z), 0.26, 1.0, 0.2);
        builder.block(Slot::PlasticDark, column.with_y([0.12, lying - 0.2]), 0.02);
        builder.cuboid(Slot::Metal, column.inset(0.03, 0.0, 0.03).with_y([lying - 0.28, lying - 0.2]));
    }
    let chassis = bay.with_y([0.1, 0.17]).inset(0.16, 0.0, 0.2);
    builder.block(Slot::MetalDark, chassis, 0.02);
    let reach = bay.high.z - 0.24;
    for z in [-reach, reach] {
        let axle = Bay::around(DVec3::new(0.0, 0.15, z), bay.width() - 0.24, 0.05, 0.06);
        builder.block(Slot::MetalDark, axle, 0.01);
        let wheel = across(0.075, [bay.high.x - 0.13, bay.high.x - 0.085], 12);
        builder.add_pair(Slot::Rubber, wheel.moved(0.0, 0.075, z));
        let hub = across(0.045, [bay.high.x - 0.134, bay.high.x - 0.081], 10);
        builder.add_pair(Slot::PaintedAccent, hub.moved(0.0, 0.075, z));
    }
    for (side, high) in [(Side::Back, bay.high.y), (Side::Front, bay.high.y * 0.85)] {
        open_panel(
            builder,
            bay.slab(side, 0.045).with_y([lying - 0.2, high]).inset(0.04, 0.0, 0.0),
            Side::Above,
        );
    }
    let [low, high] = guard_ends(bay);
    let middle = (low + high) / 2.0;
    for side in [Side::Left, Side::Right] {
        for z in [[low, middle - 0.02], [middle + 0.02, high]] {
            let panel =
                bay.slab(side, 0.035).inset(0.003, 0.0, 0.0).with_z(z).with_y([lying - 0.12, lying + 0.2]);
            builder.rounded(Slot::Plastic, panel, DVec3::new(0.012, 0.08, 0.08), 2);
            let grip = panel.inset(-0.002, 0.0, panel.depth() * 0.25).with_y([lying + 0.1, lying + 0.14]);
            builder.cuboid(Slot::PaintedAccent, grip);
        }
    }
}

/// A panel with rounded edges and a slot to push by below its upper edge.
fn open_panel(builder: &mut Builder, bay: Bay, upper: Side) {
    let rim = 0.06;
    let top = bay.slab(upper, rim);
    builder.block(Slot::Plastic, top, 0.02);
    let below = bay.without(upper, rim * 2.0);
    builder.block(Slot::Plastic, below, 0.015);
    let gap = bay.without(upper, rim * 0.6).slab(upper, rim * 1.8).inset(0.0, 0.0, 0.006);
    for side in [Side::Left, Side::Right] {
        builder.block(Slot::Plastic, gap.slab(side, bay.width() * 0.24).inset(0.003, 0.0, 0.0), 0.008);
    }
    let stripe = below.inset(0.05, 0.05, -0.002);
    builder.cuboid(Slot::PaintedAccent, stripe.slab(upper, 0.04).inset(0.0, 0.0, 0.0));
}

/// Ends and rails of wood around a frame on crossed legs.
fn home(builder: &mut Builder, lying: f64) {
    let bay = builder.bay();
    for (side, high) in [(Side::Back, bay.high.y), (Side::Front, bay.high.y * 0.85)] {
        let end = bay.slab(side, 0.04);
        builder.block(Slot::WoodLight, end.with_y([high - 0.09, high]).inset(0.0, 0.0, 0.002), 0.012);
        builder.block(
            Slot::WoodLight,
            end.with_y([lying - 0.24, high - 0.14]).inset(0.03, 0.0, 0.008),
            0.004,
        );
        for post in [Side::Left, Side::Right] {
            builder.block(
                Slot::WoodLight,
                end.slab(post, 0.05).inset(0.004, 0.0, 0.0).with_y([lying - 0.26, high - 0.08]),
                0.008,
            );
        }
    }
    let frame = bay.with_y([lying - 0.2, lying - 0.13]).inset(0.07, 0.0, 0.03);
    for side in [Side::Left, Side::Right] {
        builder.cuboid(Slot::Metal, frame.slab(side, 0.03));
        let rail = bay.slab(side, 0.028).with_z(guard_ends(bay));
        for y in [lying - 0.02, lying + 0.13] {
            builder.block(Slot::WoodLight, rail.with_y([y, y + 0.06]), 0.01);
        }
        for z in [Side::Front, Side::Back] {
            let stile = rail.slab(z, 0.03).with_y([lying - 0.18, lying + 0.14]).inset(0.006, 0.0, 0.0);
            builder.cuboid(Slot::Metal, stile.moved(0.0, 0.0, if z == Side::Front { -0.06 } else { 0.06 }));
        }
    }
    for slat in super::super::seating::depth_slats(frame.inset(0.028, 0.02, 0.03), 12, 0.09) {
        builder.cuboid(Slot::Wood, slat);
    }
    // Scissors under each side.
    let (x, reach) = (bay.high.x - 0.13, bay.depth() * 0.3);
    for (shift, ends) in [(0.0, [-reach, reach]), (-0.035, [reach, -reach])] {
        let path = [DVec3::new(x + shift, 0.09, ends[0]), DVec3::new(x + shift, lying - 0.16, ends[1])];
        builder.add_pair(Slot::Metal, sweep(&path, 0.02, 4));
    }
    for z in [-reach, reach] {
        let bar = Bay::around(DVec3::new(0.0, 0.09, z), x * 2.0 + 0.04, 0.035, 0.035);
        builder.cuboid(Slot::Metal, bar);
        builder.add_pair(Slot::Rubber, across(0.045, [x - 0.012, x + 0.012], 10).moved(0.0, 0.045, z));
    }
}
