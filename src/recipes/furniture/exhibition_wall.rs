//! Free-standing walls of exhibitions, with pictures on both faces.

use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, SINK, Sampler};
use crate::recipes::{Draft, Recipe, Slot};

/// Metres by which pictures stand out from a face, and of the width of their frames.
const FRAME: (f64, f64) = (0.028, 0.03);
/// Metres of the middle of a picture above the floor, as museums hang them.
const EYE: f64 = 1.5;
/// Metres between layers, which lie in the wall by less than [`SINK`].
const LAYER: f64 = 0.000_15;
/// What pictures are made of.
const CANVASES: [Slot; 5] = [Slot::Paper, Slot::FabricAccent, Slot::FabricLight, Slot::Linen, Slot::Book];

/// A plastered wall with two or three pictures on each face; the look chooses them.
pub(super) static EXHIBITION_WALL: Recipe =
    Recipe::furniture("exhibition_wall", [2.6, 0.16, 2.3]).plain(exhibition_wall);

fn exhibition_wall(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let (out, _) = FRAME;
    let wall = bay.inset(0.0, 0.0, out.min(bay.depth() / 4.0));
    builder.block(Slot::Plaster, wall, 0.004);
    let mut sampler = draft.sampler();
    for side in [Side::Front, Side::Back] {
        let face = match side {
            Side::Front => bay.with_z([wall.high.z - SINK, bay.high.z]),
            _ => bay.with_z([bay.low.z, wall.low.z + SINK]),
        };
        let count = sampler.count(2, 3).min((bay.width() / 0.6).max(1.0) as u32);
        for column in face.inset(0.14, 0.0, 0.0).columns(count, 0.3) {
            picture(builder, &mut sampler, column, side);
        }
    }
}

/// A frame around a canvas that lies a little behind it, of some height around eye level.
fn picture(builder: &mut Builder, sampler: &mut Sampler, column: Bay, side: Side) {
    let (_, border) = FRAME;
    let half = (0.5 * column.width() * sampler.between(0.7, 1.3)).min(0.3 * column.height());
    let eye = EYE.min(0.65 * column.high.y);
    let frame = column.with_y([eye - half, eye + half]);
    let border = border.min(0.2 * frame.width().min(frame.height()));
    let slot = sampler.pick(&[Slot::WoodDark, Slot::WoodLight, Slot::Brass, Slot::MetalDark]);
    for edge in [Side::Above, Side::Below] {
        builder.cuboid(slot, frame.slab(edge, border));
    }
    // Each layer begins a little farther out of the wall than the one before: no two of them share a plane.
    let into_wall = if side == Side::Front { Side::Back } else { Side::Front };
    let between = frame.inset(0.001, border - SINK, 0.0).without(into_wall, LAYER).without(side, 0.002);
    for edge in [Side::Left, Side::Right] {
        builder.cuboid(slot, between.slab(edge, border));
    }
    let canvas = frame.inset(border - SINK, border - 2.0 * SINK, 0.0).without(into_wall, 2.0 * LAYER);
    builder.cuboid(sampler.pick(&CANVASES), canvas.without(side, 0.4 * frame.depth()));
}
