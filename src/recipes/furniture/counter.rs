//! Counters of receptions, bars and shops.

use super::parts::{LegKind, across, legs_at_corners, slab_top};
use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, SINK};
use crate::recipes::{Recipe, Slot};

/// Metres of a counter's top.
const TOP: f64 = 0.04;
/// Metres of the boards before the body.
const BOARD: f64 = 0.016;

/// A solid counter, its front for guests at the back of the box: one whose top runs down its ends, one with panels on a
/// plinth, planks in a frame of steel, or boards on feet.
pub(super) static COUNTER: Recipe = Recipe::furniture("counter", [2.4, 0.7, 1.1])
    .plain(|draft, builder| folded(builder, draft.form()))
    .traditional(|draft, builder| panelled(builder, draft.form()))
    .industrial(|draft, builder| framed(builder, draft.form()))
    .budget(|draft, builder| boarded(builder, draft.form()));

/// Boards about as wide as usual, in metres, with gaps between them.
struct Boards {
    usual: f64,
    gap: f64,
}

/// Boards side by side over a face of the body.
fn boards(builder: &mut Builder, slot: Slot, face: Bay, form: Boards) -> Vec<Bay> {
    let Boards { usual, gap } = form;
    let count = (face.width() / usual).round().clamp(1.0, 40.0) as u32;
    let columns = face.inset(0.004, 0.004, 0.0).columns(count, gap);
    columns.iter().for_each(|&column| builder.cuboid(slot, column));
    columns
}

/// The faces of a body to guests and staff, `BOARD` thick.
fn faces(body: Bay) -> [Bay; 2] {
    [Side::Front, Side::Back].map(|side| body.slab(side, BOARD + SINK))
}

/// A thick top that runs down both ends, the fronts set back under it, on a plinth that steps back far.
fn folded(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let [slot, wood] = [
        [Slot::Stone, Slot::Wood],
        [Slot::WoodDark, Slot::Painted],
        [Slot::Stone, Slot::PaintedAccent],
        [Slot::Wood, Slot::Laminate],
    ][look];
    let thick = 0.06_f64.min(bay.height() * 0.1).min(bay.width() * 0.1);
    builder.block(slot, bay.slab(Side::Above, thick), 0.003);
    for side in [Side::Left, Side::Right] {
        let end = bay.without(Side::Above, thick - SINK).slab(side, thick);
        builder.cuboid(slot, end.inset(0.001, 0.0, 0.001));
    }
    let deep = 0.05_f64.min(bay.depth() * 0.1);
    let body = bay.without(Side::Above, thick - SINK).inset(thick - 0.003, 0.0, deep);
    let kick = 0.08_f64.min(bay.height() * 0.15);
    builder.cuboid(
        Slot::MetalDark,
        body.slab(Side::Below, kick + SINK).without(Side::Below, 0.001).inset(0.004, 0.0, 0.06),
    );
    let upper = body.without(Side::Below, kick);
    builder.cuboid(wood, upper.inset(0.0, 0.0, BOARD));
    let (usual, gap) = if look % 2 == 1 { (0.09, 0.016) } else { (0.6, 0.008) };
    for face in faces(upper) {
        boards(builder, wood, face, Boards { usual, gap });
    }
}

/// Raised panels between a plinth and a moulded top, a rail of brass for the feet.
fn panelled(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let [slot, wood] = [
        [Slot::WoodDark, Slot::WoodDark],
        [Slot::Stone, Slot::Wood],
        [Slot::Wood, Slot::Painted],
        [Slot::Stone, Slot::WoodDark],
    ][look];
    let top = TOP.min(bay.height() * 0.2);
    slab_top(builder, slot, bay.slab(Side::Above, top), true);
    let body = bay.without(Side::Above, top - SINK).inset(0.05, 0.0, 0.05);
    // A moulding under the top, and a plinth as wide.
    let band = body.slab(Side::Above, 0.06).inset(-0.024, 0.0, -0.024);
    builder.block(wood, band, 0.016);
    let kick = 0.16_f64.min(bay.height() * 0.2);
    let plinth = body.slab(Side::Below, kick).inset(-0.024, 0.0, -0.024);
    builder.block(wood, plinth, 0.014);
    let upper = body.without(Side::Below, kick - SINK).without(Side::Above, 0.06 - SINK * 2.0);
    builder.cuboid(wood, upper.inset(0.0, 0.0, BOARD));
    for (index, face) in faces(upper).into_iter().enumerate() {
        let out = if index == 0 { 0.007 } else { -0.007 };
        for column in boards(builder, wood, face, Boards { usual: 0.6, gap: 0.008 }) {
            let field = column.inset(column.width() * 0.16, column.height() * 0.14, 0.0);
            builder.block(wood, field.moved(0.0, 0.0, out), 0.004);
        }
    }
    foot_rail(builder, Slot::Brass, body, [kick * 1.3, 0.016]);
}

/// Planks in a frame of square steel under a thick top, a pipe for the feet.
fn framed(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let [slot, wood] = [
        [Slot::Wood, Slot::MetalDark],
        [Slot::Metal, Slot::Wood],
        [Slot::Concrete, Slot::WoodDark],
        [Slot::WoodDark, Slot::Metal],
    ][look];
    let top = (TOP * 1.6).min(bay.height() * 0.2);
    builder.block(slot, bay.slab(Side::Above, top), 0.005);
    let frame = bay.without(Side::Above, top - SINK).inset(0.016, 0.0, 0.016);
    let thick = 0.05_f64.min(frame.depth() * 0.15);
    let metal = if wood == Slot::Metal { Slot::MetalDark } else { Slot::Metal };
    legs_at_corners(builder, metal, frame, thick, LegKind::Square);
    let foot = 0.13_f64.min(bay.height() * 0.15);
    for y in [foot, frame.high.y - thick - 0.01] {
        for side in [Side::Front, Side::Back] {
            let bar = frame.slab(side, thick).inset(thick - SINK, 0.0, 0.001).with_y([y, y + thick]);
            builder.cuboid(metal, bar);
        }
    }
    let body = frame.inset(thick * 0.5, 0.0, thick * 0.3).with_y([foot + 0.01, frame.high.y]);
    builder.cuboid(wood, body.inset(0.0, 0.0, BOARD));
    for face in faces(body) {
        // Planks between the rails only, which cover their ends.
        let face = face.with_y([foot + thick - SINK, frame.high.y - thick - 0.01 + SINK]);
        boards(builder, wood, face.inset(thick * 0.5, -0.004, 0.0), Boards { usual: 0.2, gap: 0.008 });
    }
    foot_rail(builder, metal, frame, [foot * 1.9, 0.0]);
}

/// Thin boards on feet, the staff's side open under a deep shelf.
fn boarded(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let [slot, wood] = [
        [Slot::Laminate, Slot::Laminate],
        [Slot::WoodLight, Slot::Painted],
        [Slot::Laminate, Slot::PaintedAccent],
        [Slot::Plastic, Slot::Laminate],
    ][look];
    let top = 0.028_f64.min(bay.height() * 0.2);
    builder.cuboid(slot, bay.slab(Side::Above, top).inset(0.0, 0.0, 0.002));
    for side in [Side::Front, Side::Back] {
        let edge = bay.slab(Side::Above, top).slab(side, 0.002 + SINK).inset(0.0004, 0.0004, 0.0);
        builder.cuboid(Slot::PlasticDark, edge);
    }
    let foot = 0.06_f64.min(bay.height() * 0.1);
    let body = bay.without(Side::Above, top - SINK).inset(0.02, 0.0, 0.02);
    let feet = body.slab(Side::Below, foot + SINK).inset(0.01, 0.0, 0.01);
    legs_at_corners(builder, Slot::PlasticDark, feet, 0.05, LegKind::Round);
    let upper = body.without(Side::Below, foot);
    // Open on the staff's side: ends, a front for guests, a bottom, a shelf.
    let thin = 0.022;
    for side in [Side::Left, Side::Right] {
        builder.cuboid(wood, upper.slab(side, thin));
    }
    let inner = upper.inset(thin - SINK, 0.0, 0.001);
    builder.cuboid(wood, inner.slab(Side::Back, thin).without(Side::Below, 0.001));
    let fronts = inner.slab(Side::Back, thin).inset(0.004, 0.0, 0.0).moved(0.0, 0.0, -0.008);
    boards(builder, wood, fronts, Boards { usual: 0.8, gap: 0.006 });
    let room = inner.without(Side::Back, thin - SINK).without(Side::Front, 0.004);
    for rise in [0.006, 0.55] {
        let low = room.low.y + rise * room.height();
        builder.cuboid(wood, room.with_y([low, low + thin]));
    }
    let middle = room.inset(room.width() / 2.0 - thin / 2.0, 0.0, 0.0).without(Side::Front, 0.01);
    builder.cuboid(wood, middle.with_y([room.low.y + thin, room.high.y]));
}

/// A rail before the guests' side at a height, on stays; its body ends `out` metres behind the body's face at most.
fn foot_rail(builder: &mut Builder, metal: Slot, body: Bay, [y, out]: [f64; 2]) {
    let bay = builder.bay();
    let radius = 0.015;
    let z = bay.low.z + radius + 0.0002;
    let rail = across(radius, [body.low.x + 0.02, body.high.x - 0.02], 8);
    builder.add(metal, rail.moved(0.0, y, z));
    for x in [-0.4, 0.0, 0.4] {
        let stay = Bay::new(
            [x * bay.width() - 0.006, x * bay.width() + 0.006],
            [y - 0.006, y + 0.006],
            [z, body.low.z + BOARD + out + 0.01],
        );
        builder.cuboid(metal, stay);
    }
}
