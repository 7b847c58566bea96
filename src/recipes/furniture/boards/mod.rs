//! Boards on walls: 0.9 to 2.4 m wide, 0.9 to 1.2 high, 0.02 to 0.04 thick without the tray.

mod notice_board;
mod whiteboard;

pub(super) use notice_board::NOTICE_BOARD;
pub(super) use whiteboard::WHITEBOARD;

use super::parts::turned_forward;
use crate::recipes::kit::{Bay, Outline, SINK, Slice, Solid, loft_ring};

/// A frame around a bay that stands or hangs upright, `border` wide; deeper than what it holds.
pub(super) fn frame(bay: Bay, border: f64) -> Solid {
    moulded_frame(bay, border, 0.0)
}

/// The same with an outer edge that slopes back by `bevel` metres.
fn moulded_frame(bay: Bay, border: f64, bevel: f64) -> Solid {
    let (half, middle) = (bay.extent() / 2.0, bay.center());
    let slice = |z: f64, back: f64| Slice::new(z, half.x - back, half.y - back);
    let mut slices = vec![slice(bay.low.z, 0.0)];
    if bevel > 0.0 {
        slices.push(slice(bay.low.z + bay.depth() * 0.4, 0.0));
    }
    slices.extend([slice(bay.high.z, bevel), slice(bay.high.z, border), slice(bay.low.z, border)]);
    turned_forward(loft_ring(&Outline::Square, &slices)).moved(middle.x, middle.y, 0.0)
}

/// The inside of a frame: between shares of its depth.
pub(super) fn inside(bay: Bay, border: f64, [low, high]: [f64; 2]) -> Bay {
    let z = |share: f64| bay.low.z + share * bay.depth();
    bay.inset(border - SINK, border - SINK, 0.0).with_z([z(low), z(high)])
}
