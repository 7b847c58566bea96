//! Bent tube with a sling of cloth, on three bows that fold under it.

use glam::DVec3;

use super::Lounger;
use crate::recipes::Slot;
use crate::recipes::kit::{Builder, Station, rounded_box, rounded_path, sheet, sweep};

/// Metres of the tube's radius and of the bends.
const TUBE: f64 = 0.0125;
const BEND: f64 = 0.09;

pub(super) fn build(lounger: &Lounger, builder: &mut Builder, look: usize) {
    let bay = lounger.bay;
    let (metal, cloth) = [
        (Slot::Chrome, Slot::FabricAccent),
        (Slot::Painted, Slot::Plastic),
        (Slot::Metal, Slot::Book),
        (Slot::MetalDark, Slot::FabricLight),
    ][look];
    let (knee, right, z) = (lounger.knee, bay.high.x - TUBE, bay.high.z - TUBE);
    let y = lounger.lying - TUBE;
    let flat =
        [(knee - 0.01, -z), (right, -z), (right, z), (knee - 0.01, z)].map(|(x, z)| DVec3::new(x, y, z));
    builder.add(metal, sweep(&rounded_path(&flat, BEND, 2), TUBE, 6));
    let left = -lounger.length + TUBE;
    // The raised frame lies within the other, with edges of its own.
    let inner = z - 0.002;
    let head = [(0.0, -inner), (left, -inner), (left, inner), (0.0, inner)]
        .map(|(x, z)| DVec3::new(x, -TUBE - 0.002, z));
    builder.add(metal, lounger.raised(sweep(&rounded_path(&head, BEND, 2), TUBE, 6)));
    let legs = [
        (bay.low.x + bay.width() * 0.15, 0.03),
        (knee + bay.width() * 0.03, 0.02),
        (bay.high.x - bay.width() * 0.13, -0.05),
    ];
    for (x, lean) in legs {
        let top = if x < knee { lounger.height_at(x) - TUBE } else { y };
        let z = z - TUBE;
        let bow = [(x, top, -z), (x + lean, TUBE, -z), (x + lean, TUBE, z), (x, top, z)].map(DVec3::from);
        builder.add(metal, sweep(&rounded_path(&bow, 0.05, 1), TUBE, 6));
    }
    let wide = z + TUBE * 0.4;
    let station = |x: f64, y: f64, sag: f64| Station { at: DVec3::new(x, y, 0.0), half_width: wide, sag };
    let lying = [
        station(knee + 0.02, y, 0.004),
        station((knee + right) / 2.0, y - 0.02, 0.025),
        station(right - BEND, y, 0.004),
    ];
    builder.add(cloth, sheet(&lying, DVec3::Z, 0.007, 4));
    let station = |x: f64, y: f64, sag: f64| Station { half_width: wide - 0.001, ..station(x, y, sag) };
    let raised = [
        station(left + BEND, -TUBE, 0.004),
        station(left * 0.45, -0.035, 0.025),
        station(-0.02, -TUBE, 0.004),
    ];
    builder.add(cloth, lounger.raised(sheet(&raised, DVec3::Z, 0.007, 4)));
    let pillow = lounger.head(0.05).inset(0.0, 0.0, bay.depth() * 0.12).with_x([left + 0.05, left + 0.27]);
    let soft = rounded_box(pillow.moved(0.0, 0.022, 0.0), DVec3::splat(0.022), 2);
    builder.add(cloth, lounger.raised(soft));
}
