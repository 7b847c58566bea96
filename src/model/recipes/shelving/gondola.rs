//! Shelves of shops, 1.4 to 1.8 m high.

use crate::catalog::Side;
use crate::model::kit::{Bay, Builder, SINK, Sampler, lathe};
use crate::model::recipes::input::{Draft, GeometrySet};

/// A shop's shelf: a foot with a kick plate, a back of perforated sheet, shelves with price strips, full of goods.
pub(in super::super) fn gondola(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let form = draft.input.look as usize % 4;
    let slot = match draft.set() {
        GeometrySet::Plain => "painted",
        GeometrySet::Traditional => "wood",
        GeometrySet::Industrial => "metal_dark",
        GeometrySet::Budget => "laminate",
    };
    let base = (bay.height() * 0.1).min(0.16);
    builder.block(slot, bay.slab(Side::Below, base).without(Side::Front, 0.01), 0.004);
    builder.cuboid(
        "plastic_dark",
        bay.slab(Side::Below, base * 0.6).inset(0.004, 0.001, 0.0).slab(Side::Front, 0.0105),
    );
    builder.block(
        slot,
        bay.slab(Side::Below, base)
            .inset(0.001, 0.001, 0.0)
            .slab(Side::Front, 0.03)
            .slab(Side::Above, base * 0.35),
        0.003,
    );
    let back = bay.slab(Side::Back, 0.03).without(Side::Below, base - SINK);
    builder.cuboid(slot, back.inset(0.002, 0.0, 0.0));
    let crown = if form.is_multiple_of(2) { 0.12_f64.min(bay.height() * 0.08) } else { 0.0 };
    if crown > 0.0 {
        let sign = bay.slab(Side::Above, crown).inset(0.004, 0.002, 0.0).slab(Side::Back, 0.05);
        builder.cuboid("painted_accent", sign.without(Side::Back, 0.02));
    }
    for side in [Side::Left, Side::Right] {
        builder.cuboid(
            "metal",
            back.inset(0.001, 0.0, 0.0).slab(side, 0.03).without(Side::Above, 0.003).moved(0.0, 0.0, 0.006),
        );
    }
    let space =
        bay.without(Side::Below, base - 0.012).without(Side::Above, crown).without(Side::Back, 0.03 - SINK);
    let count = (space.height() / [0.34, 0.42, 0.3, 0.38][form]).round().clamp(2.0, 6.0) as u32;
    for (index, row) in space.rows(count, 0.0).into_iter().enumerate() {
        let deep = if index == 0 { row.depth() - 0.012 } else { row.depth() * 0.86 };
        let row = row.slab(Side::Back, deep);
        if index > 0 {
            builder.cuboid(slot, row.slab(Side::Below, 0.02));
            let strip = row.slab(Side::Below, 0.034).slab(Side::Front, 0.006).moved(0.0, -0.004, 0.003);
            builder.cuboid("paper", strip.inset(0.006, 0.0, 0.0));
        }
        let floor = if index > 0 { 0.02 - SINK } else { 0.012 - SINK };
        goods(
            builder,
            &mut sampler,
            row.without(Side::Below, floor).without(Side::Above, 0.04).inset(0.012, 0.0, 0.008),
        );
    }
}

/// Goods in blocks of one kind: cartons, bottles, jars.
fn goods(builder: &mut Builder, sampler: &mut Sampler, shelf: Bay) {
    for cell in shelf.columns((shelf.width() / 0.28).round().clamp(2.0, 5.0) as u32, 0.012) {
        let tall = shelf.height() * sampler.between(0.5, 0.92);
        let block = cell.slab(Side::Below, tall).without(Side::Back, sampler.between(0.0, 0.06));
        let slot =
            sampler.pick(&["painted_accent", "paper", "book", "plastic", "leaf", "glass", "terracotta"]);
        let count = sampler.count(2, 4);
        if sampler.chance(0.5) {
            for carton in block.columns(count, 0.004) {
                builder.cuboid(slot, carton.slab(Side::Front, carton.depth() * 0.6));
            }
            continue;
        }
        for jar in block.columns(count, 0.006) {
            let middle = jar.center();
            let radius = (jar.width() / 2.0).min(jar.depth() / 2.0).min(0.045);
            let at = |share: f64, rise: f64| (radius * share, jar.low.y + rise * jar.height());
            let body = lathe(&[at(1.0, 0.0), at(1.0, 0.62), at(0.42, 0.8), at(0.42, 1.0)], 6);
            builder.add(slot, body.moved(middle.x, 0.0, jar.high.z - radius - 0.01));
        }
    }
}
