//! Open racks.

use glam::DVec3;

use crate::catalog::Side;
use crate::model::kit::{Builder, SINK, sweep};
use crate::model::recipes::input::{Draft, GeometrySet};
use crate::model::recipes::parts::{LegKind, fill_with_books, legs_at_corners};
use crate::model::recipes::storage::fill_with_boxes;

/// An open rack with boxes: of slim steel, of wood with a rail, of angles with a cross, or of plastic tubes.
pub(in super::super) fn shelf(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let form = draft.input.look as usize % 4;
    let post = 0.035_f64.min(bay.width() * 0.1).min(bay.depth() * 0.2);
    let (slot, kind, board) = match draft.set() {
        GeometrySet::Plain => (
            ["metal", "painted", "wood", "metal_dark"][form],
            LegKind::Square,
            ["metal", "painted", "wood", "wood"][form],
        ),
        GeometrySet::Traditional => (
            ["wood", "wood_dark"][form % 2],
            [LegKind::Round, LegKind::Square][form / 2],
            ["wood", "wood_dark"][form % 2],
        ),
        GeometrySet::Industrial => (
            "metal_dark",
            [LegKind::Angle, LegKind::Pipe, LegKind::Angle, LegKind::Square][form],
            ["wood", "wood", "metal", "metal_dark"][form],
        ),
        GeometrySet::Budget => (
            ["plastic", "metal", "wood_light", "plastic_dark"][form],
            [LegKind::Round, LegKind::Round, LegKind::Square, LegKind::Round][form],
            ["plastic", "laminate", "wood_light", "plastic_dark"][form],
        ),
    };
    legs_at_corners(builder, slot, bay, post, kind);
    let count = (bay.height() / [0.42, 0.36, 0.48, 0.4][form]).round().clamp(2.0, 7.0) as u32;
    let thick = if draft.set() == GeometrySet::Budget { 0.016 } else { 0.025 };
    let inner =
        bay.inset(post * 0.22, 0.0, post * 0.22).without(Side::Above, 0.02).without(Side::Below, 0.06);
    for (index, row) in inner.rows(count, 0.0).into_iter().enumerate() {
        builder.block(board, row.slab(Side::Below, thick), 0.003);
        let space = row.without(Side::Below, thick - SINK).inset(post, 0.0, 0.02);
        if row.height() < 0.12 {
            continue;
        }
        if (index + form).is_multiple_of(3) && draft.set() != GeometrySet::Industrial {
            fill_with_books(builder, &mut sampler, space.without(Side::Back, 0.02), 0.6, 9);
        } else {
            fill_with_boxes(builder, &mut sampler, space.without(Side::Above, 0.03));
        }
    }
    if draft.set() == GeometrySet::Industrial {
        let (z, x) = (bay.low.z + 0.007, bay.high.x - post * 0.5);
        let at = |x: f64, share: f64| DVec3::new(x, share * bay.height(), z);
        builder.add("metal", sweep(&[at(-x, 0.1), at(x, 0.9)], 0.005, 6));
    }
}
