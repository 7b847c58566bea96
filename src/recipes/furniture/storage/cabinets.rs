//! Cupboards with doors: wardrobes, cabinets, wall units.

use super::case::case;
use super::{CORNICE, CORNICE_OVERHANG, DOOR, body_slot, doors, drawers, fronts};
use crate::geometry::Side;
use crate::recipes::furniture::parts::cornice;
use crate::recipes::kit::{Builder, SINK};
use crate::recipes::{Draft, Recipe, Symbol};

/// A tall cupboard for clothes; `doors`, or one for each half metre.
pub(in super::super) static WARDROBE: Recipe = Recipe::furniture("wardrobe", [1.5, 0.6, 2.1])
    .with(&[("doors", 0.0)])
    .symbol(Symbol::Wardrobe)
    .every_set(wardrobe);

fn wardrobe(draft: &Draft, builder: &mut Builder) {
    let body = case(draft, builder, body_slot(draft));
    let fittings = fronts(draft);
    fittings.carcass(builder, body_slot(draft), body);
    let count = draft.count_along("doors", body.width(), DOOR, 6);
    let has_drawers = draft.sampler().count(0, 2) == 2 && body.height() > 1.5;
    let upper = if has_drawers { body.without(Side::Below, 0.42) } else { body };
    if has_drawers {
        let columns = body.slab(Side::Below, 0.42).columns((count / 2).max(1), 0.0);
        columns.into_iter().for_each(|column| drawers(builder, &fittings, column, 2));
    }
    doors(builder, &fittings, upper, count, if has_drawers { 0.35 } else { 0.48 });
}

/// A cupboard with `doors`.
pub(in super::super) static CABINET: Recipe = Recipe::furniture("cabinet", [0.8, 0.4, 1.2])
    .with(&[("doors", 0.0)])
    .symbol(Symbol::Doors)
    .every_set(cabinet);

fn cabinet(draft: &Draft, builder: &mut Builder) {
    let body = case(draft, builder, body_slot(draft));
    let fittings = fronts(draft);
    fittings.carcass(builder, body_slot(draft), body);
    let count = draft.count_along("doors", body.width(), DOOR, 6);
    let has_drawer_row = draft.sampler().count(0, 3) == 3 && body.height() > 0.6;
    let lower = if has_drawer_row { body.without(Side::Above, 0.16) } else { body };
    if has_drawer_row {
        for column in body.slab(Side::Above, 0.16).columns(count, 0.0) {
            drawers(builder, &fittings, column, 1);
        }
    }
    doors(builder, &fittings, lower, count, if body.height() < 1.1 { 0.75 } else { 0.5 });
}

/// A cupboard that hangs on a wall, with `doors`.
pub(in super::super) static WALL_CABINET: Recipe = Recipe::furniture("wall_cabinet", [0.8, 0.35, 0.7])
    .with(&[("doors", 0.0)])
    .symbol(Symbol::Doors)
    .every_set(wall_cabinet);

fn wall_cabinet(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let fittings = fronts(draft);
    let body = if draft.is_traditional() {
        let crown = CORNICE.min(bay.height() * 0.12);
        let overhang = CORNICE_OVERHANG.min(bay.width() * 0.05).min(bay.depth() * 0.1);
        cornice(builder, body_slot(draft), bay.slab(Side::Above, crown), overhang);
        bay.inset(overhang, 0.0, 0.002)
            .without(Side::Above, crown - SINK)
            .without(Side::Front, overhang * 0.6)
    } else {
        bay
    };
    fittings.carcass(builder, body_slot(draft), body);
    let count = draft.count_along("doors", bay.width(), DOOR, 6);
    doors(builder, &fittings, body, count, 0.2);
}
