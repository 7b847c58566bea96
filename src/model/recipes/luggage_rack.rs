//! Luggage racks: 0.6 to 0.7 m wide, 0.45 to 0.5 high.

use std::f64::consts::FRAC_1_SQRT_2;

use glam::DVec3;

use super::input::Draft;
use crate::model::kit::{Bay, Builder, sweep};

/// A folding stand for suitcases: crossed legs and straps.
pub(super) fn luggage_rack(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let slot = draft.sampler().pick(&["wood_dark", "wood", "metal"]);
    let thick = 0.026;
    let half = thick * FRAC_1_SQRT_2;
    let top = bay.high.y - thick;
    let (near, far) = (bay.high.z - half, bay.low.z + half);
    for (index, (foot, head)) in [(near, far), (far, near)].into_iter().enumerate() {
        let x = bay.high.x - thick * (0.5 + 1.1 * index as f64);
        let bar = sweep(&[DVec3::new(x, 0.0, foot), DVec3::new(x, top, head)], half, 4);
        builder.add_pair(slot, bar);
        let rail = Bay::new(
            [-bay.high.x, bay.high.x],
            [top - thick * 0.5, bay.high.y - 0.004],
            [head - half, head + half],
        );
        builder.cuboid(slot, rail.inset(0.001, 0.0, 0.0));
        let stretcher = Bay::around(
            DVec3::new(0.0, top * 0.16, foot + (head - foot) * 0.16),
            (x - thick * 0.4) * 2.0,
            0.018,
            0.018,
        );
        builder.cuboid(slot, stretcher);
    }
    let straps = bay.inset(bay.width() * 0.1, 0.0, 0.0).with_y([bay.high.y - 0.006, bay.high.y]);
    for strap in straps.columns(4, bay.width() * 0.12) {
        builder.cuboid("leather", strap.inset(0.0, 0.0, 0.004));
    }
}
