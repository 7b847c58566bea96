//! Platforms with a bow to push by.

use glam::DVec3;

use super::castors;
use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::furniture::parts::across;
use crate::recipes::kit::{Bay, Builder, Outline, SINK, Slice, loft, rounded_path, sweep};

/// The barrow of porters and warehouses: planks in a rim of steel on four large wheels, a bow with rungs behind and a low
/// one before; gives the height of the deck.
pub(super) fn barrow(builder: &mut Builder, look: usize) -> f64 {
    let bay = builder.bay();
    let wood = [Slot::Wood, Slot::WoodDark, Slot::WoodLight, Slot::Wood][look];
    let wheel = (bay.height() * 0.11).min(bay.depth() * 0.14);
    let (tube, deck) = (0.018, wheel * 2.0 + 0.06);
    let rim = bay.with_y([deck - 0.05, deck]);
    for side in [Side::Left, Side::Right] {
        builder.cuboid(Slot::MetalDark, rim.slab(side, 0.008).inset(0.0, 0.0, 0.001));
    }
    for end in [Side::Front, Side::Back] {
        builder.cuboid(Slot::MetalDark, rim.slab(end, 0.008).inset(0.008 - SINK, 0.001, 0.0));
    }
    let planks = rim.inset(0.008 - SINK, 0.004, 0.008 - SINK).without(Side::Below, 0.008);
    for plank in planks.columns(4, 0.008) {
        builder.cuboid(wood, plank);
    }
    for z in [bay.low.z + wheel + 0.03, bay.high.z - wheel - 0.03] {
        let half = bay.high.x - 0.05;
        for x in [-half - 0.045, half] {
            builder.add(Slot::Rubber, across(wheel, [x, x + 0.045], 10).moved(0.0, wheel, z));
            builder.add(Slot::Metal, across(wheel * 0.5, [x - 0.004, x + 0.049], 8).moved(0.0, wheel, z));
        }
        builder.add(Slot::MetalDark, across(0.014, [-half, half], 6).moved(0.0, wheel, z));
        for x in [-half * 0.6, half * 0.6] {
            let block = Bay::new([x - 0.02, x + 0.02], [wheel, rim.low.y + 0.02], [z - 0.03, z + 0.03]);
            builder.cuboid(Slot::MetalDark, block);
        }
    }
    let (x, z) = (bay.high.x - tube - 0.008, bay.high.z - tube - 0.008);
    for (z, top) in [(-z, bay.high.y - tube), (z, deck + (bay.high.y - deck) * 0.3)] {
        let path =
            [(-x, deck - 0.03), (-x, top), (x, top), (x, deck - 0.03)].map(|(x, y)| DVec3::new(x, y, z));
        builder.add(Slot::MetalDark, sweep(&rounded_path(&path, 0.09, 2), tube, 6));
    }
    for share in [0.3, 0.62] {
        let y = deck + (bay.high.y - deck) * share;
        let rung = [DVec3::new(-x, y, -z), DVec3::new(x, y, -z)];
        builder.add(Slot::MetalDark, sweep(&rung, tube * 0.8, 6));
    }
    deck
}

/// A deck of plastic with round corners on small castors, and a bow of tube that folds down on it; gives the height of the
/// deck.
pub(super) fn folding(builder: &mut Builder, look: usize) -> f64 {
    let bay = builder.bay();
    let (metal, plastic) = [
        (Slot::Chrome, Slot::PlasticDark),
        (Slot::Metal, Slot::PaintedAccent),
        (Slot::MetalDark, Slot::Plastic),
        (Slot::Chrome, Slot::Book),
    ][look];
    let (lift, tube) = (0.11_f64.min(bay.height() * 0.15), 0.013);
    let deck = lift + 0.05;
    castors(builder, bay.inset(0.05, 0.0, 0.06), lift);
    let slice = |y: f64, back: f64| Slice::new(y, bay.high.x - back, bay.high.z - back).softened(0.09 - back);
    let plate =
        [slice(lift - SINK, 0.012), slice(lift + 0.012, 0.0), slice(deck - 0.008, 0.0), slice(deck, 0.01)];
    builder.add(plastic, loft(&Outline::Soft(2), &plate));
    let mat = bay.inset(0.07, 0.0, 0.07).without(Side::Back, 0.05).with_y([deck - SINK, deck + 0.005]);
    for strip in mat.columns(4, 0.03) {
        builder.cuboid(Slot::Rubber, strip);
    }
    let (x, z, top) = (bay.high.x - 0.075, bay.low.z + 0.06, bay.high.y - tube);
    for side in [-1.0, 1.0] {
        let hinge = DVec3::new(side * x, deck + 0.02, z);
        builder.cuboid(plastic, Bay::around(hinge, 0.05, 0.04 + 2.0 * SINK, 0.06));
    }
    // The upper half leans to whoever pushes.
    let bend = deck + (top - deck) * 0.6;
    let back = bay.low.z + tube;
    let path = [(-x, deck, z), (-x, bend, z), (-x, top, back), (x, top, back), (x, bend, z), (x, deck, z)]
        .map(DVec3::from);
    builder.add(metal, sweep(&rounded_path(&path, 0.08, 2), tube, 6));
    let bar = [DVec3::new(-x, bend * 0.7, z), DVec3::new(x, bend * 0.7, z)];
    builder.add(metal, sweep(&bar, tube * 0.7, 6));
    let grip = [DVec3::new(-x * 0.6, top, back), DVec3::new(x * 0.6, top, back)];
    builder.add(Slot::Rubber, sweep(&grip, tube - 0.0005, 8));
    deck + 0.005
}
