//! Low pieces on feet: chests of drawers, bedside cabinets, sideboards, what televisions and shoes go into.

use super::{OVERHANG, body_slot, doors, drawers, fronts, open_box};
use crate::geometry::Side;
use crate::recipes::furniture::parts::{LegKind, legs_at_corners, slab_top};
use crate::recipes::kit::{Bay, Builder, SINK};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// A chest of drawers; `drawers` rows, two columns where it is wide.
pub(in super::super) static DRESSER: Recipe = Recipe::furniture("dresser", [1.0, 0.45, 0.85])
    .with(&[("drawers", 0.0)])
    .symbol(Symbol::Doors)
    .every_set(dresser);

fn dresser(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let body = chest_on_feet(draft, builder, body_slot(draft));
    let fittings = fronts(draft);
    fittings.carcass(builder, body_slot(draft), body);
    let rows = draft.count_along("drawers", bay.height(), 0.24, 6);
    let form = draft.input.look % 4;
    let columns = if bay.width() > 0.95 && form != 1 { 2 } else { 1 };
    // Some looks have shallow drawers for small things on top.
    let small = if form >= 2 { body.height() / f64::from(rows) * 0.7 } else { 0.0 };
    if small > 0.0 {
        for column in body.slab(Side::Above, small).columns(2, 0.0) {
            drawers(builder, &fittings, column, 1);
        }
    }
    for column in body.without(Side::Above, small).columns(columns, 0.0) {
        drawers(builder, &fittings, column, rows);
    }
}

/// Four short legs and a top; gives the bay of the body between them.
fn chest_on_feet(draft: &Draft, builder: &mut Builder, slot: Slot) -> Bay {
    let bay = builder.bay();
    let is_traditional = draft.is_traditional();
    let top = 0.022_f64.min(bay.height() * 0.1);
    let top_slot = if draft.set() == GeometrySet::Industrial { Slot::Wood } else { slot };
    slab_top(builder, top_slot, bay.slab(Side::Above, top), is_traditional);
    let foot = (bay.height() * 0.22).min([0.06, 0.12, 0.17, 0.09][draft.form()]);
    let overhang = if is_traditional { 0.016 } else { OVERHANG };
    let body = bay.without(Side::Above, top - SINK).inset(overhang, 0.0, 0.0).without(Side::Back, overhang);
    let body = body.without(Side::Front, overhang);
    let form = draft.form();
    let (feet, kind) = match draft.set() {
        GeometrySet::Plain => (
            [Slot::Wood, Slot::MetalDark, Slot::Wood, Slot::WoodLight][form],
            [LegKind::Square, LegKind::Round, LegKind::Tapered, LegKind::Tapered][form],
        ),
        GeometrySet::Traditional => {
            (slot, [LegKind::Turned, LegKind::Spade, LegKind::Tapered, LegKind::Spade][form])
        }
        GeometrySet::Industrial => {
            (Slot::MetalDark, [LegKind::Pipe, LegKind::Angle, LegKind::Hairpin, LegKind::Square][form])
        }
        GeometrySet::Budget => (
            [Slot::PlasticDark, Slot::Chrome, Slot::WoodLight, Slot::PlasticDark][form],
            [LegKind::Square, LegKind::Round, LegKind::Tapered, LegKind::Round][form],
        ),
    };
    let legs = body.with_y([0.0, foot + SINK]).inset(0.012, 0.0, 0.012).without(Side::Front, 0.034);
    legs_at_corners(builder, feet, legs, 0.042, kind);
    body.without(Side::Below, foot)
}

/// A bedside cabinet: a drawer over an open bay or more drawers.
pub(in super::super) static NIGHTSTAND: Recipe =
    Recipe::furniture("nightstand", [0.45, 0.4, 0.5]).symbol(Symbol::Doors).every_set(nightstand);

fn nightstand(draft: &Draft, builder: &mut Builder) {
    let body = chest_on_feet(draft, builder, body_slot(draft));
    let fittings = fronts(draft);
    if draft.sampler().chance(0.5) {
        fittings.carcass(builder, body_slot(draft), body);
        drawers(builder, &fittings, body, 2);
        return;
    }
    let upper = body.slab(Side::Above, body.height() * 0.45);
    fittings.carcass(builder, body_slot(draft), upper.inset(0.0, 0.0, 0.001));
    drawers(builder, &fittings, upper, 1);
    let lower = body.without(Side::Above, body.height() * 0.45 - SINK).without(Side::Front, fittings.depth());
    open_box(builder, body_slot(draft), lower.inset(0.001, 0.0, 0.002), 0.016);
}

/// A long low cupboard on legs with doors and drawers.
pub(in super::super) static SIDEBOARD: Recipe =
    Recipe::furniture("sideboard", [1.6, 0.42, 0.8]).symbol(Symbol::Doors).every_set(sideboard);

fn sideboard(draft: &Draft, builder: &mut Builder) {
    let body = chest_on_feet(draft, builder, body_slot(draft));
    let fittings = fronts(draft);
    fittings.carcass(builder, body_slot(draft), body);
    let count = (body.width() / 0.5).round().clamp(1.0, 6.0) as u32;
    let drawer_column = draft.sampler().count(0, count - 1);
    for (index, column) in (0..).zip(body.columns(count, 0.0)) {
        if index == drawer_column {
            drawers(builder, &fittings, column, 3);
        } else {
            doors(builder, &fittings, column, 1, 0.6);
        }
    }
}

/// A low cupboard for a television: an open bay between doors.
pub(in super::super) static TV_STAND: Recipe =
    Recipe::furniture("tv_stand", [1.5, 0.4, 0.5]).symbol(Symbol::Doors).every_set(tv_stand);

fn tv_stand(draft: &Draft, builder: &mut Builder) {
    let body = chest_on_feet(draft, builder, body_slot(draft));
    let fittings = fronts(draft);
    let count = if body.width() > 0.9 { 3 } else { 2 };
    let open = draft.sampler().count(0, count - 1);
    for (index, column) in (0..).zip(body.columns(count, -SINK)) {
        if index == open {
            let niche = column.without(Side::Front, fittings.depth()).inset(0.0, 0.002, 0.002);
            open_box(builder, body_slot(draft), niche.inset(SINK * 2.0, 0.0, 0.0), 0.016);
            let player =
                niche.inset(0.05, 0.0, 0.03).with_y([niche.low.y + 0.016 + SINK, niche.low.y + 0.07]);
            builder.block(Slot::PlasticDark, player, 0.004);
        } else {
            let column = column.inset(SINK * 3.0, 0.0, 0.0);
            fittings.carcass(builder, body_slot(draft), column);
            doors(builder, &fittings, column, 1, 0.6);
        }
    }
}

/// A narrow cabinet with tilting flaps for shoes.
pub(in super::super) static SHOE_CABINET: Recipe =
    Recipe::furniture("shoe_cabinet", [0.8, 0.25, 1.1]).symbol(Symbol::Doors).every_set(shoe_cabinet);

fn shoe_cabinet(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let top = 0.018;
    slab_top(builder, body_slot(draft), bay.slab(Side::Above, top), draft.is_traditional());
    let step = if draft.is_traditional() { 0.016 } else { OVERHANG };
    let body = bay.without(Side::Above, top - SINK).inset(step, 0.0, step);
    let fittings = fronts(draft);
    fittings.carcass(builder, body_slot(draft), body);
    let count = (bay.height() / 0.4).round().clamp(1.0, 4.0) as u32;
    drawers(builder, &fittings, body.without(Side::Below, 0.03), count);
}
