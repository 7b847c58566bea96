//! Clocks that stand on tables and shelves.

use glam::{DVec2, DVec3};

use super::Dial;
use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::furniture::parts::{across, turned_forward};
use crate::recipes::kit::{Axis, Bay, Builder, Outline, SINK, Slice, extrude, loft, loft_ring};

/// A block with a dark square face and a button along its top.
pub(super) fn cube(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let slot = [Slot::PlasticDark, Slot::Painted, Slot::WoodLight, Slot::Metal][look];
    let layer = bay.depth() * 0.03;
    let body = bay.without(Side::Above, bay.height() * 0.06).without(Side::Front, layer * 4.0);
    builder.block(slot, body, bay.height() * 0.06);
    let button = bay.inset(bay.width() * 0.3, 0.0, bay.depth() * 0.36).slab(Side::Above, bay.height() * 0.08);
    builder.cuboid(Slot::PaintedAccent, button);
    let side = body.width().min(body.height()) * 0.84;
    let front = body.high.z;
    let face = Bay::around(body.center(), side, side, 0.0).with_z([front - SINK, front + layer]);
    builder.cuboid(Slot::Rubber, face);
    let middle = face.center().with_z(front + layer);
    let dial = Dial { middle, radius: side * 0.48, layer };
    dial.hands(builder, Slot::Paper, 0.05);
    dial.marks(builder, Slot::Paper, 4, 0.03);
}

/// A case of wood that rises in a bow over a plinth, a face in a ring of brass before it.
pub(super) fn bow(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let slot = [Slot::WoodDark, Slot::Wood, Slot::WoodDark, Slot::Wood][look];
    let (half, height, depth) = (bay.width() / 2.0, bay.height(), bay.depth());
    builder.cuboid(slot, bay.slab(Side::Below, height * 0.12).without(Side::Front, depth * 0.06));
    let right = [(0.93, 0.11), (0.9, 0.26), (0.7, 0.38), (0.54, 0.62), (0.36, 0.88), (0.14, 1.0)];
    let left = right.into_iter().rev().map(|(x, y)| (-x, y));
    let outline: Vec<DVec2> =
        right.into_iter().chain(left).map(|(x, y)| DVec2::new(x * half, y * height)).collect();
    let front = bay.high.z - depth * 0.18;
    builder.add(slot, extrude(&outline, Axis::Z, [bay.low.z + depth * 0.1, front]));
    let radius = (height * 0.36).min(half * 0.6);
    let middle = DVec3::new(0.0, height * 0.56, front);
    let place = |solid: crate::recipes::kit::Solid| turned_forward(solid).moved(0.0, middle.y, middle.z);
    let ring = [(-SINK, 1.0), (depth * 0.12, 0.94), (depth * 0.02, 0.82)];
    let ring = ring.map(|(z, share)| Slice::round(z, radius * share));
    builder.add(Slot::Brass, place(loft_ring(&Outline::Round(12), &ring)));
    let face = [(-SINK, 0.8), (depth * 0.04, 0.88)].map(|(z, share)| Slice::round(z, radius * share));
    builder.add(Slot::Paper, place(loft(&Outline::Round(12), &face)));
    let layer = depth * 0.14 / 3.0;
    let dial = Dial { middle: middle + DVec3::Z * depth * 0.04, radius: radius * 0.8, layer };
    dial.hands(builder, Slot::PlasticDark, 0.06);
    dial.marks(builder, Slot::PlasticDark, 4, 0.05);
}

/// A one or a nought in a field, its front `lift` metres out of the field's.
fn digit(builder: &mut Builder, slot: Slot, field: Bay, is_nought: bool, lift: f64) {
    let bar = field.width() * 0.24;
    let front = field.high.z;
    if is_nought {
        let (half, middle) = (field.extent() / 2.0, field.center());
        let slice = |z: f64, back: f64| Slice::new(z, half.x - back, half.y - back);
        let ring = [slice(-SINK, 0.0), slice(lift, bar * 0.3), slice(-SINK, bar)];
        let ring = turned_forward(loft_ring(&Outline::Square, &ring));
        builder.add(slot, ring.moved(middle.x, middle.y, front));
    } else {
        let one = field.slab(Side::Right, field.width() * 0.5).slab(Side::Left, bar);
        builder.cuboid(slot, one.with_z([front - SINK, front + lift]));
    }
}

/// Ten past ten in a field: two digits each in its left and right half.
fn ten_past_ten(builder: &mut Builder, slot: Slot, halves: [Bay; 2], lift: f64) {
    for half in halves {
        for (place, is_nought) in half.columns(2, half.width() * 0.12).into_iter().zip([false, true]) {
            digit(builder, slot, place, is_nought, lift);
        }
    }
}

/// A bent case with a window before leaves that fall, hours and minutes (Cifra, 1965), and a knob at its side.
pub(super) fn leaves(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let slot = [Slot::Metal, Slot::MetalDark, Slot::PaintedAccent, Slot::Brass][look];
    let (height, depth) = (bay.height(), bay.depth());
    let body = bay.without(Side::Right, bay.width() * 0.05).without(Side::Front, depth * 0.05);
    let at = |(z, y): (f64, f64)| DVec2::new(body.low.z + z * body.depth(), y * height);
    let section = [
        (0.12, 0.08),
        (0.9, 0.08),
        (1.0, 0.18),
        (1.0, 0.84),
        (0.84, 1.0),
        (0.3, 1.0),
        (0.0, 0.8),
        (0.0, 0.2),
    ];
    builder.add(slot, extrude(&section.map(at), Axis::X, body.x()));
    let foot = body.inset(body.width() * 0.14, 0.0, body.depth() * 0.2).with_y([0.0, height * 0.09]);
    builder.cuboid(Slot::Rubber, foot);
    let front = body.high.z;
    let window = body.inset(body.width() * 0.05, 0.0, 0.0).with_y([0.22, 0.8].map(|share| share * height));
    let window = window.with_z([front - SINK, front + depth * 0.01]);
    builder.cuboid(Slot::Screen, window);
    let lift = depth * 0.02;
    let cards =
        window.inset(window.width() * 0.04, window.height() * 0.08, 0.0).columns(2, window.width() * 0.06);
    for card in &cards {
        for half in card.rows(2, height * 0.015) {
            builder.cuboid(Slot::PlasticDark, half.with_z([window.high.z - SINK, window.high.z + lift]));
        }
    }
    let halves = [cards[0], cards[1]].map(|card| {
        let face = card.inset(card.width() * 0.14, card.height() * 0.14, 0.0);
        face.with_z([window.high.z, window.high.z + lift])
    });
    ten_past_ten(builder, Slot::Paper, halves, lift);
    let knob = across(height * 0.12, [body.high.x - SINK, bay.high.x], 6);
    builder.add(Slot::PlasticDark, knob.moved(0.0, height * 0.5, body.center().z));
}

/// A wedge of plastic with digits behind a dark pane, and a long key on its top that gives five more minutes.
pub(super) fn digits(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let slot = [Slot::Plastic, Slot::PlasticDark, Slot::PaintedAccent, Slot::PlasticDark][look];
    let (height, depth) = (bay.height(), bay.depth());
    let body = bay.without(Side::Front, depth * 0.05);
    let at = |(z, y): (f64, f64)| DVec2::new(body.low.z + z * body.depth(), y * height);
    let section = [(0.0, 0.0), (1.0, 0.0), (1.0, 0.78), (0.72, 0.94), (0.3, 0.94), (0.0, 0.5)];
    builder.add(slot, extrude(&section.map(at), Axis::X, body.x()));
    let key = body.inset(body.width() * 0.24, 0.0, 0.0).with_y([height * 0.93, height]);
    builder.cuboid(Slot::MetalDark, key.with_z([0.36, 0.66].map(|share| body.low.z + share * body.depth())));
    let front = body.high.z;
    let pane = body.inset(body.width() * 0.04, 0.0, 0.0).with_y([0.12, 0.7].map(|share| share * height));
    let pane = pane.with_z([front - SINK, front + depth * 0.025]);
    builder.cuboid(Slot::Screen, pane);
    let field = pane.inset(pane.width() * 0.1, pane.height() * 0.2, 0.0);
    let halves = field.columns(2, field.width() * 0.14);
    let lift = depth * 0.025;
    ten_past_ten(builder, Slot::PaintedAccent, [halves[0], halves[1]], lift);
    for y in [0.3, 0.7] {
        let dot = DVec3::new(field.center().x, field.low.y + y * field.height(), pane.high.z);
        let size = field.width() * 0.045;
        let dot = Bay::around(dot, size, size, 0.0).with_z([pane.high.z - SINK, pane.high.z + lift]);
        builder.cuboid(Slot::PaintedAccent, dot);
    }
}
