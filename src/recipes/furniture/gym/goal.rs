//! Goals of sports halls: 3.00 × 2.00 m inside the posts (EN 749), of tube, with a net of cords.

use glam::DVec3;

use crate::geometry::Side;
use crate::recipes::kit::{Builder, SINK, sweep};
use crate::recipes::{Recipe, Slot};

/// Metres of the width of posts and bar.
const POST: f64 = 0.08;
/// Metres of the half of the tube that holds the net, and of a cord.
const TUBE: (f64, f64) = (0.02, 0.006);
/// Cords of the net that hang, and that run across.
const CORDS: (usize, usize) = (13, 8);
/// Share of the depth that the net has at the top.
const TOP_DEPTH: f64 = 0.28;

/// Square posts in front, a bow of tube behind them, and the net between.
pub(in super::super) static GOAL: Recipe =
    Recipe::furniture("goal", [3.16, 1.1, 2.08]).plain(|_, builder| goal(builder));

fn goal(builder: &mut Builder) {
    let bay = builder.bay();
    let front = bay.slab(Side::Front, POST);
    for side in [Side::Left, Side::Right] {
        builder.block(Slot::PaintedAccent, front.slab(side, POST).without(Side::Above, POST - SINK), 0.004);
    }
    builder.block(Slot::PaintedAccent, front.slab(Side::Above, POST), 0.004);
    let (tube, cord) = TUBE;
    let x = bay.high.x - POST / 2.0;
    let inside = bay.high.z - POST + SINK;
    let (low, high) = (tube, bay.high.y - POST / 2.0);
    let (bottom, top) = (bay.low.z + tube, inside - TOP_DEPTH * (inside - bay.low.z - tube));
    for x in [-x, x] {
        let side = [(high, inside), (high, top), (low, bottom), (low, inside)];
        builder.add(Slot::Metal, sweep(&side.map(|(y, z)| DVec3::new(x, y, z)), tube, 6));
    }
    // The back of the net slants from the upper bar to the lower one.
    let at = |x: f64, share: f64| DVec3::new(x, low + (high - low) * share, bottom + (top - bottom) * share);
    for share in [0.0, 1.0] {
        builder.add(Slot::Metal, sweep(&[-x, x].map(|x| at(x, share)), tube * 0.8, 6));
    }
    for number in 1..CORDS.0 {
        let x = x * (2.0 * number as f64 / CORDS.0 as f64 - 1.0);
        builder.add(Slot::FabricLight, sweep(&[0.0, 1.0].map(|share| at(x, share)), cord, 3));
    }
    for number in 1..CORDS.1 {
        let share = number as f64 / CORDS.1 as f64;
        builder.add(Slot::FabricLight, sweep(&[-x, x].map(|x| at(x, share)), cord, 3));
    }
}
