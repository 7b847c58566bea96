//! Tube: a hoop with bars at each end, bent guards, a ladder of tube.

use glam::DVec3;

use super::{Bunk, EDGE};
use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::kit::{Builder, SINK, rounded_path, sweep};

/// Metres of the radius of hoops, and of bars between them.
const TUBE: f64 = 0.02;
const BAR: f64 = 0.009;

pub(super) fn frame(bunk: &Bunk, builder: &mut Builder) {
    let (bay, bases) = (bunk.bay, bunk.bases);
    let metal = [Slot::Painted, Slot::Metal, Slot::MetalDark, Slot::PaintedAccent][bunk.look];
    for z in [bay.low.z + TUBE, bay.high.z - TUBE] {
        hoop(bunk, builder, metal, z);
    }
    for base in bases {
        let sides = bay.inset(TUBE * 0.5, 0.0, TUBE).with_y([base, base + 0.05]);
        for side in [Side::Left, Side::Right] {
            builder.cuboid(metal, sides.slab(side, 0.025));
        }
    }
    bunk.decks(builder, metal, [TUBE * 0.5 + 0.024, TUBE + 0.004]);
    let x = bay.high.x - TUBE;
    let top = bay.high.y - 0.03;
    for (side, to) in [(-1.0, bay.high.z - TUBE * 3.0), (1.0, bunk.way_in[0])] {
        // The guard is bent down to the rail at both ends.
        let from = bay.low.z + TUBE * 3.0;
        let at = |y: f64, z: f64| DVec3::new(side * x, y, z);
        let low = bases[1] + 0.02;
        let bow = [at(low, from), at(top, from), at(top, to), at(low, to)];
        builder.add(metal, sweep(&rounded_path(&bow, 0.07, 1), BAR * 1.3, 6));
        let middle = (bases[1] + 0.2 + top) / 2.0;
        builder.add(metal, sweep(&[at(middle, from), at(middle, to)], BAR, 4));
        builder.add(metal, sweep(&[at(low, (from + to) / 2.0), at(top, (from + to) / 2.0)], BAR * 0.9, 4));
    }
    let x = bay.high.x - BAR;
    for z in [bunk.way_in[0] + 0.03, bunk.way_in[1]] {
        let stile = [DVec3::new(x, 0.0, z), DVec3::new(x, bases[1] + 0.3, z)];
        builder.add(metal, sweep(&stile, BAR * 1.2, 6));
    }
    for step in 0..4 {
        let y = bases[0] + 0.12 + f64::from(step) * (bases[1] - bases[0]) / 4.0;
        let ends = [bunk.way_in[0] + 0.03, bunk.way_in[1]].map(|z| DVec3::new(x, y, z));
        builder.add(metal, sweep(&ends, BAR, 4));
    }
}

/// A tube up one side and down the other, with bars between two tubes over each bed.
fn hoop(bunk: &Bunk, builder: &mut Builder, metal: Slot, z: f64) {
    let bay = bunk.bay;
    let (x, top) = (bay.high.x - TUBE, bay.high.y - TUBE);
    let at = |x: f64, y: f64| DVec3::new(x, y, z);
    let path = [at(-x, 0.0), at(-x, top), at(x, top), at(x, 0.0)];
    builder.add(metal, sweep(&rounded_path(&path, 0.2, 2), TUBE, 6));
    for (index, base) in bunk.bases.into_iter().enumerate() {
        // Over the upper bed, the hoop itself is the upper tube.
        let tubes = if index == 0 { [base + 0.03, base + 0.42] } else { [base + 0.03, top] };
        let count = if index == 0 { 2 } else { 1 };
        for &y in &tubes[..count] {
            builder.add(metal, sweep(&[at(-x, y), at(x, y)], TUBE * 0.7, 4));
        }
        let inside = bay.inset(EDGE * 2.0, 0.0, 0.0).columns(3, (bay.width() - EDGE * 4.0) / 2.0 * 0.9);
        for column in inside {
            let x = column.center().x;
            builder.add(metal, sweep(&[at(x, tubes[0]), at(x, tubes[1] - SINK)], BAR, 4));
        }
    }
}
