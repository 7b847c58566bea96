//! Turned posts with knobs, boards with arches at head and foot, a guard of pales.

use glam::{DVec2, DVec3};

use super::{Bunk, RAIL};
use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::furniture::seating::depth_slats;
use crate::recipes::kit::{Axis, Bay, Builder, SINK, cuboid, extrude, lathe, sweep};

/// Metres of a post.
const POST: f64 = 0.062;
/// Radius of a post between the beds, and of what is over the upper one, as a share of half its thickness, at a share of
/// the height.
const SHAFT: [(f64, f64); 4] = [(0.7, 0.0), (0.95, 0.14), (0.62, 0.5), (0.9, 1.0)];
const FINIAL: [(f64, f64); 6] =
    [(0.7, 0.0), (0.85, 0.6), (0.45, 0.68), (0.95, 0.84), (0.75, 0.96), (0.25, 1.0)];

pub(super) fn frame(bunk: &Bunk, builder: &mut Builder) {
    let (bay, bases) = (bunk.bay, bunk.bases);
    let wood = [Slot::WoodDark, Slot::Wood, Slot::WoodDark, Slot::Wood][bunk.look];
    for z in [bay.low.z + POST / 2.0, bay.high.z - POST / 2.0] {
        post(bunk, builder, wood, DVec3::new(bay.high.x - POST / 2.0, 0.0, z));
    }
    let thick = 0.026;
    for base in bases {
        let ring = bay.inset(0.018, 0.0, 0.018).with_y([base, base + RAIL]);
        for side in [Side::Left, Side::Right] {
            builder.cuboid(wood, ring.slab(side, thick).inset(0.0, 0.0, POST - 0.018 - SINK));
        }
        for (end, tall) in [(Side::Back, 0.42), (Side::Front, 0.3)] {
            arch(builder, wood, ring.slab(end, thick).inset(POST - 0.018 - SINK, 0.0, 0.0), tall);
        }
    }
    bunk.decks(builder, wood, [0.018 + thick - SINK, 0.018 + thick - SINK]);
    let y = [bases[1] + RAIL, bay.high.y - 0.05];
    for side in [Side::Left, Side::Right] {
        let guard = bunk.guard(side, POST - SINK, y).inset(0.02, 0.0, 0.0).slab(side, 0.022);
        builder.cuboid(wood, guard.slab(Side::Above, 0.05));
        let pales = guard.without(Side::Above, 0.05 - SINK).inset(0.005, -SINK, 0.04);
        let count = (pales.depth() / 0.28).round().clamp(3.0, 9.0) as u32;
        let gap = pales.depth() / f64::from(count) * 0.76;
        for pale in depth_slats(pales, count, gap) {
            builder.cuboid(wood, pale);
        }
    }
    let ladder = bay.slab(Side::Right, 0.018 + SINK).with_z(bunk.way_in).with_y([0.0, bases[1] + 0.34]);
    for end in [Side::Front, Side::Back] {
        builder.cuboid(wood, ladder.slab(end, 0.04));
    }
    for rung in ladder.with_y([bases[0] + 0.05, bases[1]]).rows(4, 0.0) {
        let [x, y] = [rung.center().x, rung.center().y];
        let ends = [ladder.low.z + 0.02, ladder.high.z - 0.02].map(|z| DVec3::new(x, y, z));
        builder.add(wood, sweep(&ends, 0.0085, 6));
    }
}

/// Two posts left and right: a foot, blocks where rails meet it, turned between them and above.
fn post(bunk: &Bunk, builder: &mut Builder, wood: Slot, at: DVec3) {
    let ([low, high], top) = (bunk.bases, bunk.bay.high.y);
    let (under, over) = (0.02, RAIL + 0.03);
    let mut add = |profile: &[(f64, f64)], from: f64, to: f64| {
        let profile: Vec<(f64, f64)> =
            profile.iter().map(|&(share, rise)| (share * POST / 2.0, from + rise * (to - from))).collect();
        builder.add_pair(wood, lathe(&profile, 6).moved(at.x, 0.0, at.z));
    };
    add(&[(0.65, 0.0), (0.95, 1.0)], 0.0, low - under + SINK);
    add(&SHAFT, low + over - SINK, high - under + SINK);
    add(&FINIAL, high + over - SINK, top);
    for base in bunk.bases {
        let block = Bay::around(at, POST, 1.0, POST).with_y([base - under, base + over]);
        builder.add_pair(wood, cuboid(block));
    }
}

/// A board between posts from the underside of a rail up to an arch, so many metres over it in the middle.
fn arch(builder: &mut Builder, wood: Slot, rail: Bay, tall: f64) {
    let half = rail.high.x;
    let low = rail.low.y;
    let profile = [
        (-half, low),
        (half, low),
        (half, low + tall * 0.55),
        (half * 0.75, low + tall * 0.6),
        (half * 0.4, low + tall * 0.93),
        (0.0, low + tall),
        (-half * 0.4, low + tall * 0.93),
        (-half * 0.75, low + tall * 0.6),
        (-half, low + tall * 0.55),
    ]
    .map(DVec2::from);
    builder.add(wood, extrude(&profile, Axis::Z, rail.z()));
}
