//! The trolley of airports: narrower to the front, so that one goes into the other, with a basket and a bar to push by.

use glam::{DVec2, DVec3};

use super::castor;
use crate::recipes::Slot;
use crate::recipes::furniture::parts::across;
use crate::recipes::kit::{Axis, Bay, Builder, extrude, rounded_path, sweep};

/// Metres of the tube's radius.
const TUBE: f64 = 0.015;

/// Gives the height of the deck.
pub(super) fn trolley(builder: &mut Builder, look: usize) -> f64 {
    let bay = builder.bay();
    let metal = [Slot::Metal, Slot::Chrome, Slot::Metal, Slot::MetalDark][look];
    let accent = [Slot::PaintedAccent, Slot::PlasticDark, Slot::Book, Slot::PaintedAccent][look];
    let wheel = (bay.height() * 0.09).min(bay.depth() * 0.1);
    let deck = wheel * 2.0;
    let (back, front) = (bay.low.z + wheel + 0.06, bay.high.z - TUBE);
    // What stands behind is between the wheels.
    let (wide, narrow) = (bay.high.x - 0.045, bay.width() * 0.2);
    for x in [bay.low.x, bay.high.x - 0.035] {
        builder.add(Slot::Rubber, across(wheel, [x, x + 0.035], 10).moved(0.0, wheel, back));
    }
    let axle = across(0.012, [bay.low.x + 0.03, bay.high.x - 0.03], 6);
    builder.add(metal, axle.moved(0.0, wheel, back));
    castor(builder, DVec3::new(0.0, 0.0, front - 0.08), deck - 0.002);
    let plate =
        [(-wide, back - 0.053), (wide, back - 0.053), (narrow, front), (-narrow, front)].map(DVec2::from);
    builder.add(metal, extrude(&plate, Axis::Y, [deck - 0.012, deck]));
    let rim = [
        (wide, back - 0.05),
        (wide, back),
        (narrow, front),
        (-narrow, front),
        (-wide, back),
        (-wide, back - 0.05),
    ]
    .map(|(x, z)| DVec3::new(x, deck + 0.004, z));
    builder.add(metal, sweep(&rim, TUBE, 6));
    posts(builder, metal, accent, DVec3::new(wide - TUBE, wheel, back));
    deck
}

/// The bow behind with its bars, the basket and the board for advertisements.
fn posts(builder: &mut Builder, metal: Slot, accent: Slot, foot: DVec3) {
    let DVec3 { x, y: low, z: foot } = foot;
    let bay = builder.bay();
    let (top, head) = (bay.high.y - TUBE - 0.003, bay.low.z + TUBE + 0.003);
    let at = |x: f64, rise: f64| DVec3::new(x, low + rise * (top - low), foot + rise * (head - foot));
    let path = [at(-x, 0.0), at(-x, 1.0), at(x, 1.0), at(x, 0.0)];
    builder.add(metal, sweep(&rounded_path(&path, 0.07, 2), TUBE, 6));
    builder.add(Slot::Rubber, sweep(&[at(-x * 0.75, 1.0), at(x * 0.75, 1.0)], TUBE + 0.003, 6));
    builder.add(accent, sweep(&[at(-x, 0.9), at(x, 0.9)], 0.01, 4));
    let board = |rise: f64, out: f64| {
        let at = at(0.0, rise);
        DVec2::new(at.z + out, at.y)
    };
    let sheet = [board(0.2, 0.006), board(0.56, 0.006), board(0.56, 0.016), board(0.2, 0.016)];
    builder.add(accent, extrude(&sheet, Axis::X, [-x, x]));
    let [low, high] = [0.66, 0.8].map(|rise| at(0.0, rise));
    let basket = Bay::new([-x + 0.004, x - 0.004], [low.y, high.y], [high.z, high.z + 0.2]);
    let wall = 0.006;
    let trough = [
        (basket.high.z, basket.high.y),
        (basket.high.z - 0.03, basket.low.y),
        (low.z, basket.low.y),
        (low.z, basket.low.y + wall),
        (basket.high.z - 0.03 - wall, basket.low.y + wall),
        (basket.high.z - wall, basket.high.y),
    ]
    .map(DVec2::from);
    builder.add(metal, extrude(&trough, Axis::X, basket.x()));
    for side in [-1.0, 1.0] {
        let x = side * (basket.high.x - wall);
        let bar = [DVec3::new(x, high.y - wall, high.z), DVec3::new(x, high.y - wall, basket.high.z - wall)];
        builder.add(metal, sweep(&bar, wall, 4));
    }
}
