//! Planks bolted to angles of steel, crossed bars at the head, a ladder of pipe.

use glam::DVec3;

use super::Bunk;
use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::furniture::parts::{LegKind, legs_at_corners};
use crate::recipes::kit::{Bay, Builder, SINK, cuboid, sweep};

/// Metres of the angles, of a plank's thickness and height, and of the bolts' heads.
const ANGLE: f64 = 0.065;
const PLANK: f64 = 0.032;
const TALL: f64 = 0.15;
const BOLT: f64 = 0.006;

pub(super) fn frame(bunk: &Bunk, builder: &mut Builder) {
    let (bay, bases) = (bunk.bay, bunk.bases);
    let (wood, steel) = [
        (Slot::Wood, Slot::MetalDark),
        (Slot::WoodLight, Slot::MetalDark),
        (Slot::WoodDark, Slot::Metal),
        (Slot::WoodLight, Slot::PaintedAccent),
    ][bunk.look];
    let posts = bay.inset(BOLT, 0.0, 0.0);
    legs_at_corners(builder, steel, posts, ANGLE, LegKind::Angle);
    // Planks lie within the angles.
    let inner = posts.inset(0.0115, 0.0, 0.0115);
    for base in bases {
        let sides = inner.with_y([base, base + TALL]);
        for side in [Side::Left, Side::Right] {
            builder.cuboid(wood, sides.slab(side, PLANK));
        }
        let ends = inner.inset(PLANK - SINK, 0.0, 0.001);
        for (end, count) in [(Side::Back, 2), (Side::Front, 1)] {
            let high = base + (TALL + 0.03) * f64::from(count) - 0.03;
            for plank in ends.slab(end, PLANK).with_y([base, high]).rows(count, 0.03) {
                builder.cuboid(wood, plank.inset(0.0, 0.001, 0.0));
            }
        }
    }
    bunk.decks(builder, wood, [0.0175 + PLANK - 2.0 * SINK, 0.0125 + PLANK - SINK]);
    let y = [bay.high.y - TALL - 0.02, bay.high.y - 0.02];
    for side in [Side::Left, Side::Right] {
        let guard = bunk.guard(side, 0.0117, y).inset(0.0175, 0.0, 0.0).slab(side, PLANK);
        builder.cuboid(wood, guard);
        if side == Side::Right {
            // The end of the plank is held by a flat bar.
            let bar =
                guard.slab(Side::Front, 0.08).moved(0.0, 0.0, -0.03).with_y([bases[1] + 0.02, y[1] - 0.02]);
            builder.cuboid(steel, bar.moved(0.0055, 0.0, 0.0).slab(Side::Right, 0.008));
        }
    }
    bolts(bunk, builder, [bases[0] + TALL / 2.0, bases[1] + TALL / 2.0, y[0] + TALL / 2.0]);
    braces(bunk, builder, steel);
    ladder(bunk, builder, steel);
}

/// Heads of bolts outside of the angles, where planks meet them.
fn bolts(bunk: &Bunk, builder: &mut Builder, heights: [f64; 3]) {
    let bay = bunk.bay;
    let head = Bay::around(DVec3::new(bay.high.x - BOLT / 2.0, 0.0, 0.0), BOLT + SINK, 0.024, 0.024);
    // The outer faces end with the box.
    let head = head.moved(-SINK / 2.0, 0.0, 0.0);
    for y in heights {
        for z in [bay.low.z + ANGLE * 0.55, bay.high.z - ANGLE * 0.55] {
            if y < heights[2] || z < 0.0 {
                builder.add_pair(Slot::Metal, cuboid(head.moved(0.0, y, z)));
            }
        }
    }
}

/// Two bars that cross between the beds at the head.
fn braces(bunk: &Bunk, builder: &mut Builder, steel: Slot) {
    let bay = bunk.bay;
    let x = bay.high.x - ANGLE;
    let y = [bunk.bases[0] + 2.0 * TALL + 0.06, bunk.bases[1] - 0.04];
    for (index, x) in [-x, x].into_iter().enumerate() {
        let z = bay.low.z + 0.02 + 0.012 * index as f64;
        builder.add(steel, sweep(&[DVec3::new(x, y[0], z), DVec3::new(-x, y[1], z)], 0.012, 4));
    }
}

/// Rungs of pipe between two flat bars.
fn ladder(bunk: &Bunk, builder: &mut Builder, steel: Slot) {
    let bay = bunk.bay;
    let bars = bay.slab(Side::Right, 0.016).with_z(bunk.way_in).with_y([0.0, bunk.bases[1] + 0.3]);
    for end in [Side::Front, Side::Back] {
        builder.cuboid(steel, bars.slab(end, 0.04));
    }
    for rung in bars.with_y([bunk.bases[0], bunk.bases[1] + 0.05]).rows(5, 0.0) {
        let at = rung.center();
        let ends = [bars.low.z + 0.01, bars.high.z - 0.01].map(|z| DVec3::new(at.x, at.y, z));
        builder.add(steel, sweep(&ends, 0.009, 4));
    }
    let hooks = Bay::new(
        [bars.low.x - 0.03, bars.low.x + SINK],
        [bunk.bases[1] + 0.27, bunk.bases[1] + 0.285],
        bunk.way_in,
    );
    for end in [Side::Front, Side::Back] {
        builder.cuboid(
            steel,
            hooks.slab(end, 0.03).moved(0.0, 0.0, if end == Side::Front { -0.005 } else { 0.005 }),
        );
    }
}
