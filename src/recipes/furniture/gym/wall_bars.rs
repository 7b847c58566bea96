//! Wall bars of sports halls: rungs of wood between two cheeks, the upper two nearer to those who hang on them.

use glam::DVec3;

use crate::geometry::Side;
use crate::recipes::kit::{Builder, SINK, sweep};
use crate::recipes::{Recipe, Slot};

/// Metres from one rung to the next (EN 12346: 0.10 to 0.16).
const PITCH: f64 = 0.155;
/// Metres of the lowest rung above the floor.
const LOWEST: f64 = 0.12;
/// Metres of the thickness of a cheek, and of the half of a rung.
const CHEEK: (f64, f64) = (0.035, 0.017);

/// Cheeks of wood with rungs between them.
pub(in super::super) static WALL_BARS: Recipe =
    Recipe::furniture("wall_bars", [1.0, 0.14, 2.4]).plain(|_, builder| bars(builder));

fn bars(builder: &mut Builder) {
    let bay = builder.bay();
    let (thickness, radius) = CHEEK;
    for side in [Side::Left, Side::Right] {
        builder.block(Slot::WoodLight, bay.slab(side, thickness), 0.004);
    }
    let reach = bay.high.x - thickness + SINK;
    let rungs = ((bay.high.y - LOWEST - 0.06) / PITCH).floor().max(1.0) as usize;
    for rung in 0..=rungs {
        let is_upper = rung + 2 > rungs;
        let z = if is_upper { bay.high.z - radius - 0.004 } else { 0.25 * bay.high.z };
        let ends = [-reach, reach].map(|x| DVec3::new(x, LOWEST + PITCH * rung as f64, z));
        builder.add(Slot::Wood, sweep(&ends, radius, 8));
    }
}
