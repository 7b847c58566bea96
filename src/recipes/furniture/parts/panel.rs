//! Upright boards: doors, screens.

use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, SINK};
use crate::recipes::{GeometrySet, Slot};

/// A board that stands upright, as doors and screens do: plain, framed, or with ribs, by the geometry set. Its front
/// looks to +Z.
pub(in super::super) fn wall_panel(builder: &mut Builder, set: GeometrySet, slot: Slot, bay: Bay) {
    let border = (bay.width() * 0.14).min(bay.height() * 0.14).min(0.09);
    match set {
        GeometrySet::Traditional => {
            builder.cuboid(slot, bay.inset(SINK, SINK, bay.depth() * 0.25));
            let rows = if bay.height() > bay.width() * 1.4 { 2 } else { 1 };
            for side in [Side::Left, Side::Right] {
                builder.cuboid(slot, bay.slab(side, border));
            }
            let inner = bay.inset(border - SINK, 0.0, 0.0002);
            for row in 0..=rows {
                let share = f64::from(row) / f64::from(rows);
                let low = bay.low.y + share * (bay.height() - border);
                builder.cuboid(slot, inner.with_y([low + 0.0003, low + border - 0.0003]));
            }
        }
        GeometrySet::Industrial => {
            builder.cuboid(slot, bay.inset(0.0, 0.0, bay.depth() * 0.2));
            for strip in bay.inset(border * 0.3, border * 0.3, 0.0).rows(3, border) {
                builder.cuboid(slot, strip.slab(Side::Above, 0.02));
            }
        }
        _ => builder.cuboid(slot, bay),
    }
}
