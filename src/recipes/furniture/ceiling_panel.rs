//! Flat lights in ceilings, 0.05 m high: 0.6 m square as a field of a ceiling, or 1.2 by 0.3 m.

use glam::DVec2;

use super::seating::depth_slats;
use crate::geometry::Side;
use crate::recipes::kit::{Axis, Bay, Builder, Outline, SINK, Slice, extrude, loft_ring};
use crate::recipes::{Recipe, Slot};

/// Share of the shorter side that a frame around tubes is wide, and of the frame that the tubes keep off it.
const FRAME: f64 = 0.04;
const OFF_FRAME: f64 = 0.6;
/// Metres of thin sheet.
const SHEET: f64 = 0.002;

/// A flat light in an office ceiling: a diffuser in a slim frame, tubes over a wooden grid, tubes in a trough over
/// blades, or bare tubes between their holders under a sheet.
pub(super) static CEILING_PANEL: Recipe = Recipe::accessory("ceiling_panel", [0.6, 0.6, 0.05])
    .plain(|draft, builder| diffuser(builder, draft.input.look % 2))
    .traditional(|draft, builder| grid(builder, draft.input.look % 2))
    .industrial(|draft, builder| trough(builder, draft.input.look % 2))
    .budget(|draft, builder| bare(builder, draft.input.look % 2));

fn short(bay: Bay) -> f64 {
    bay.width().min(bay.depth())
}

/// Bays side by side along the longer side.
fn along(bay: Bay, count: u32, gap: f64) -> Vec<Bay> {
    if bay.width() >= bay.depth() { depth_slats(bay, count, gap) } else { bay.columns(count, gap) }
}

/// A frame through (share of the height, share of its width inwards); gives what is within.
fn frame(builder: &mut Builder, slot: Slot, wide: f64, profile: &[(f64, f64)]) -> Bay {
    let bay = builder.bay();
    let slice = |&(rise, back): &(f64, f64)| {
        let back = back * wide;
        Slice::new(rise * bay.height(), bay.width() / 2.0 - back, bay.depth() / 2.0 - back)
    };
    let slices: Vec<Slice> = profile.iter().map(slice).collect();
    builder.add(slot, loft_ring(&Outline::Square, &slices));
    bay.inset(wide - SINK, 0.0, wide - SINK)
}

/// Tubes side by side, as light as those of the other sets.
fn tubes(builder: &mut Builder, count: u32) {
    let bay = builder.bay();
    let off = short(bay) * FRAME * (1.0 + OFF_FRAME) - SINK;
    for tube in along(bay.inset(off, 0.0, off), count, short(bay) * 0.08) {
        builder.cuboid(Slot::Lamp, tube.with_y([bay.height() * 0.35, bay.height() * 0.62]));
    }
}

/// A pane in a narrow frame, or strips in a sheet.
fn diffuser(builder: &mut Builder, look: u32) {
    let bay = builder.bay();
    let border = short(bay) * 0.025;
    let inner = frame(builder, Slot::Painted, border, &[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]);
    if look == 0 {
        builder.cuboid(Slot::Lamp, inner.inset(0.0, bay.height() * 0.2, 0.0));
        return;
    }
    builder.cuboid(Slot::Painted, inner.with_y([bay.height() * 0.3, bay.height() * 0.9]));
    for strip in along(inner.inset(border, 0.0, border), 3, short(bay) * 0.14) {
        builder.cuboid(Slot::Lamp, strip.with_y([bay.height() * 0.15, bay.height() * 0.4]));
    }
}

/// Tubes over bars that cross, in a frame with a step: the ceilings of old reading rooms.
fn grid(builder: &mut Builder, look: u32) {
    let bay = builder.bay();
    let slot = [Slot::Wood, Slot::Painted][look as usize];
    // From the ceiling down to an inner edge that lies lowest.
    let stepped = [(0.5, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.3)];
    let inner = frame(builder, slot, short(bay) * FRAME, &stepped);
    builder.cuboid(Slot::Painted, inner.with_y([bay.height() * 0.75, bay.height() * 0.95]));
    tubes(builder, 2 + look);
    let fields = |length: f64| (length / (short(bay) / 3.0)).round().clamp(2.0, 8.0) as u32;
    let half = (short(bay) * 0.02).min(0.01);
    // Bars across lie a little deeper than those along.
    for field in inner.columns(fields(inner.width()), 0.0).iter().skip(1) {
        let x = [field.low.x - half, field.low.x + half];
        builder.cuboid(slot, inner.with_x(x).with_y([bay.height() * 0.04, bay.height() * 0.3]));
    }
    for field in depth_slats(inner, fields(inner.depth()), 0.0).iter().skip(1) {
        let z = [field.low.z - half, field.low.z + half];
        builder.cuboid(slot, inner.with_z(z).with_y([bay.height() * 0.08, bay.height() * 0.28]));
    }
}

/// Tubes in a trough of bent sheet between two plates, over blades across them.
fn trough(builder: &mut Builder, look: u32) {
    let bay = builder.bay();
    let is_long_in_x = bay.width() >= bay.depth();
    let (half, height) = (short(bay) / 2.0, bay.height());
    let wall = half * FRAME * 0.6;
    // The section across the tubes: sides that lean in to a flat back, once outside and once inside.
    let (edge, back) = (half, half * 0.86);
    let section = [
        (edge, 0.0),
        (back, height),
        (-back, height),
        (-edge, 0.0),
        (wall - edge, 0.0),
        (wall - back, height - SHEET),
        (back - wall, height - SHEET),
        (edge - wall, 0.0),
    ]
    .map(DVec2::from);
    let end = if is_long_in_x { Side::Left } else { Side::Back };
    let other = if is_long_in_x { Side::Right } else { Side::Front };
    let between = bay.without(end, SHEET).without(other, SHEET);
    builder.add(
        Slot::Metal,
        if is_long_in_x {
            extrude(&section, Axis::X, between.x())
        } else {
            extrude(&section, Axis::Z, between.z())
        },
    );
    for side in [end, other] {
        builder.cuboid(Slot::MetalDark, bay.slab(side, SHEET + SINK).inset(0.0, SINK, 0.0));
    }
    tubes(builder, 2 + look);
    let blades = if is_long_in_x { between.columns(6, 0.0) } else { depth_slats(between, 6, 0.0) };
    for blade in blades.iter().skip(1) {
        let across = blade.low;
        let plate = if is_long_in_x {
            blade.with_x([across.x - SHEET, across.x + SHEET]).inset(0.0, 0.0, wall * 0.5)
        } else {
            blade.with_z([across.z - SHEET, across.z + SHEET]).inset(wall * 0.5, 0.0, 0.0)
        };
        builder.cuboid(Slot::Metal, plate.with_y([height * 0.04, height * 0.3]));
    }
}

/// Bare tubes under a flat sheet, held at both ends; with a box for what drives them along the middle.
fn bare(builder: &mut Builder, look: u32) {
    let bay = builder.bay();
    let (long, height) = (bay.width().max(bay.depth()), bay.height());
    builder.cuboid(Slot::Painted, bay.with_y([height * 0.72, height]));
    tubes(builder, 4);
    let ends = if bay.width() >= bay.depth() { [Side::Left, Side::Right] } else { [Side::Back, Side::Front] };
    for side in ends {
        let holder = bay.slab(side, (short(bay) * 0.1).min(long * 0.2)).without(side, short(bay) * 0.02);
        let holder = if matches!(side, Side::Left | Side::Right) {
            holder.inset(0.0, 0.0, short(bay) * 0.02)
        } else {
            holder.inset(short(bay) * 0.02, 0.0, 0.0)
        };
        builder.cuboid(Slot::Plastic, holder.with_y([0.0, height * 0.73]));
    }
    if look == 1 {
        let middle = along(bay.inset(short(bay) * 0.09, 0.0, short(bay) * 0.09), 3, short(bay) * 0.35)[1];
        builder.cuboid(Slot::Painted, middle.with_y([height * 0.4, height * 0.74]));
    }
}
