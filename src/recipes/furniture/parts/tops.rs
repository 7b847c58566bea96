//! Table tops and other boards.

use std::f64::consts::FRAC_PI_2;

use crate::recipes::Slot;
use crate::recipes::kit::{Bay, Builder, Outline, Slice, Solid, loft};

/// Metres of a plain board's chamfer.
const EDGE: f64 = 0.003;
/// Metres by which a moulded board's underside steps back.
const MOULDING: f64 = 0.012;

/// A board: chamfered, or with a moulded edge in the traditional set.
pub(in super::super) fn slab_top(builder: &mut Builder, slot: Slot, bay: Bay, is_traditional: bool) {
    if !is_traditional {
        builder.block(slot, bay, EDGE.min(bay.height() / 4.0));
        return;
    }
    let (center, half) = (bay.center(), bay.extent() / 2.0);
    let step = MOULDING.min(half.x / 4.0).min(half.z / 4.0);
    let slice =
        |share: f64, back: f64| Slice::new(bay.low.y + share * bay.height(), half.x - back, half.z - back);
    let slices =
        [slice(0.0, step), slice(0.3, step), slice(0.5, 0.0), slice(0.85, 0.0), slice(1.0, step / 3.0)];
    builder.add(slot, loft(&Outline::Square, &slices).moved(center.x, 0.0, center.z));
}

/// A raised field with sloping borders on a panel, its front at the front of `bay`.
pub(in super::super) fn raised_panel(builder: &mut Builder, slot: Slot, bay: Bay) {
    let (center, half) = (bay.center(), bay.extent() / 2.0);
    let slope = 0.02_f64.min(half.x * 0.5).min(half.y * 0.5);
    let slices =
        [Slice::new(bay.low.z, half.x, half.y), Slice::new(bay.high.z, half.x - slope, half.y - slope)];
    builder.add(slot, turned_forward(loft(&Outline::Square, &slices)).moved(center.x, center.y, 0.0));
}

/// A body built upwards around the y axis, laid down so that its top looks to the front.
pub(in super::super) fn turned_forward(solid: Solid) -> Solid {
    solid.turned_x(FRAC_PI_2)
}
