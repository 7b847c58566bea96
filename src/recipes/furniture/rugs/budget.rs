//! Thin rugs with round corners and a cord along the edge.

use super::{Form, layer};
use crate::recipes::Slot;
use crate::recipes::kit::{Bay, Builder, Outline, Slice, Solid, loft, loft_ring};

/// Share of the height that the thin field has, and figures on it.
const FIELD: f64 = 0.55;
const FIGURE: f64 = 0.68;
/// Metres of the cord.
const CORD: f64 = 0.018;
/// Metres between the cord and figures, which keeps their corners out of it.
const MARGIN: f64 = 0.05;

/// Two stripes, a chequer, a ring within the edge, or a long oval.
pub(super) fn rug(builder: &mut Builder, form: Form) {
    let bay = builder.bay();
    let [field, other] = [
        [Slot::FabricAccent, Slot::FabricLight],
        [Slot::FabricLight, Slot::FabricAccent],
        [Slot::Carpet, Slot::FabricLight],
        [Slot::Fabric, Slot::FabricLight],
    ][form.look];
    let radius = bay.depth() * [0.06, 0.05, 0.12, 0.46][form.look];
    let corner = Corner { radius, outline: Outline::Soft(if form.look == 3 { 7 } else { 3 }) };
    let inside = CORD / 2.0;
    builder.add(field, corner.plate(layer(bay, 0.0, FIELD), inside));
    builder
        .add(other, corner.ring(bay, CORD, &[(0.0, 0.25), (0.0, 0.7), (0.5, 1.0), (1.0, 0.7), (1.0, 0.25)]));
    let figures = layer(bay, FIELD / 2.0, FIGURE);
    let room = figures.inset(MARGIN + radius * 0.3, 0.0, MARGIN);
    match form.look {
        0 => stripes(builder, other, room, form.scale),
        1 => chequer(builder, other, figures.inset(MARGIN, 0.0, MARGIN)),
        2 => {
            let wide = form.band(bay, 0.09);
            let back = bay.depth() * 0.13;
            let ring = [(0.0, 0.0), (0.0, 1.0), (1.0, 1.0), (1.0, 0.0)];
            let corner = Corner { radius: (radius - back).max(radius * 0.6), ..corner };
            builder.add(other, corner.ring(figures.inset(back, 0.0, back), wide, &ring));
        }
        _ => builder.add(other, corner.plate(figures, form.band(bay, 0.25))),
    }
}

/// Two stripes across, a broad one and a narrow one.
fn stripes(builder: &mut Builder, slot: Slot, room: Bay, scale: f64) {
    for (from, wide) in [(0.62, 0.14), (0.84, 0.05)] {
        let left = room.low.x + room.width() * from;
        builder.cuboid(slot, room.with_x([left, left + room.width() * wide * scale]));
    }
}

/// Every other field of four by six or so, as square as they go.
fn chequer(builder: &mut Builder, slot: Slot, room: Bay) {
    let rows = 4_u32;
    let side = room.depth() / f64::from(rows);
    let columns = ((room.width() / side).round() as u32).clamp(2, 8);
    // A gap keeps corners that meet from being one.
    for (column, cell) in room.columns(columns, 0.001).into_iter().enumerate() {
        for row in (0..rows).filter(|row| (*row as usize + column).is_multiple_of(2)) {
            let back = room.low.z + f64::from(row) * side;
            builder.cuboid(slot, cell.with_z([back, back + side - 0.001]));
        }
    }
}

/// The round corners of a rug.
struct Corner {
    radius: f64,
    outline: Outline,
}

impl Corner {
    /// A cross-section so many metres inwards, with corners around the same middle.
    fn cut(&self, bay: Bay, y: f64, back: f64) -> Slice {
        super::cut(bay, y, back).softened(self.radius - back)
    }

    /// A plate that ends some metres inside a piece.
    fn plate(&self, bay: Bay, back: f64) -> Solid {
        loft(&self.outline, &bay.y().map(|y| self.cut(bay, y, back)))
    }

    /// A ring along the sides of a piece, inside it, through shares of its width and of the piece's height.
    fn ring(&self, bay: Bay, wide: f64, profile: &[(f64, f64)]) -> Solid {
        let slice = |&(back, up): &(f64, f64)| self.cut(bay, bay.low.y + up * bay.height(), back * wide);
        loft_ring(&self.outline, &profile.iter().map(slice).collect::<Vec<_>>())
    }
}
