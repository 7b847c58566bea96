//! Bunk beds, for mattresses of 0.9 by 2 m. The guard of the upper bed ends 0.16 m over its mattress at least, and the way in
//! is 0.3 to 0.4 m wide (EN 747). The head is at the back, the ladder on the right near the foot.

mod budget;
mod industrial;
mod plain;
mod traditional;

use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, SINK, pillow};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// Shares of the height at which the frames of the two beds begin.
const BASES: [f64; 2] = [0.17, 0.66];
/// Metres of a side rail's height.
const RAIL: f64 = 0.13;
/// Metres between the sides of the box and the bedding.
const EDGE: f64 = 0.055;

/// Two beds over each other with a ladder: between boards; between turned posts; planks between angles of steel; of tube.
pub(in super::super) static BUNK_BED: Recipe =
    Recipe::furniture("bunk_bed", [1.0, 2.1, 1.7]).symbol(Symbol::Bed).every_set(bunk_bed);

fn bunk_bed(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let look = draft.form();
    let near = bay.high.z - bay.depth() * 0.06;
    let bunk = Bunk {
        bay,
        bases: BASES.map(|share| share * bay.height()),
        way_in: [near - (bay.depth() * 0.18).min(0.38), near],
        look,
    };
    match draft.set() {
        GeometrySet::Plain => plain::frame(&bunk, builder),
        GeometrySet::Traditional => traditional::frame(&bunk, builder),
        GeometrySet::Industrial => industrial::frame(&bunk, builder),
        GeometrySet::Budget => budget::frame(&bunk, builder),
    }
    let mut sampler = draft.sampler();
    for base in bunk.bases {
        bedding(builder, bay, base, sampler.pick(&[Slot::Fabric, Slot::FabricAccent, Slot::FabricLight]));
    }
}

/// The measures that all bunk beds share.
struct Bunk {
    bay: Bay,
    /// Metres over the floor at which the frames of the two beds begin.
    bases: [f64; 2],
    /// Where the ladder stands along the right side.
    way_in: [f64; 2],
    look: usize,
}

impl Bunk {
    /// The guard of the upper bed on the left or the right, where it leaves the way in free, between heights.
    fn guard(&self, side: Side, inset: f64, y: [f64; 2]) -> Bay {
        let far = self.bay.low.z + inset;
        let near = if side == Side::Right { self.way_in[0] } else { self.bay.high.z - inset };
        self.bay.with_y(y).with_z([far, near])
    }

    /// A thin board under each mattress, between rails so many metres inside the box.
    fn decks(&self, builder: &mut Builder, slot: Slot, inset: [f64; 2]) {
        for base in self.bases {
            builder.cuboid(slot, self.bay.inset(inset[0], 0.0, inset[1]).with_y([base + 0.02, base + 0.04]));
        }
    }
}

/// A mattress, a blanket over most of it and a pillow on a frame.
fn bedding(builder: &mut Builder, bay: Bay, base: f64, slot: Slot) {
    let mattress = bay.inset(EDGE, 0.0, EDGE).with_y([base + 0.04 - SINK, base + 0.18]);
    builder.block(Slot::Mattress, mattress, 0.025);
    let blanket = mattress.without(Side::Back, mattress.depth() * 0.32).inset(-0.004, 0.0, -0.004);
    builder.block(slot, blanket.with_y([base + 0.1, base + 0.21]), 0.035);
    let soft = pillow((mattress.width() - 0.16).min(0.7), 0.13, 0.36).turned_x(0.1);
    builder.add(Slot::Linen, soft.moved(0.0, base + 0.23, mattress.low.z + 0.22));
}
