//! Bookcases: shelves 0.30 to 0.35 m over each other, 0.25 to 0.35 m deep.

use glam::DVec3;

use super::BOARD;
use crate::geometry::Side;
use crate::recipes::furniture::parts::{LegKind, cornice, fill_with_books, legs_at_corners, slab_top};
use crate::recipes::furniture::storage::fill_with_boxes;
use crate::recipes::kit::{Bay, Builder, SINK, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// Metres between the shelves of a bookcase.
const SHELF_SPACING: f64 = 0.34;
/// The most books in one bookcase, so that it stays within its triangles.
const MOST_BOOKS: u32 = 84;

/// A bookcase with `shelves` bays full of books.
pub(in super::super) static BOOKSHELF: Recipe = Recipe::furniture("bookshelf", [0.9, 0.3, 2.0])
    .with(&[("shelves", 0.0)])
    .symbol(Symbol::Shelf)
    .every_set(bookshelf);

fn bookshelf(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let form = draft.form();
    let open = match draft.set() {
        GeometrySet::Plain => plain_case(
            builder,
            bay,
            [Slot::Wood, Slot::Painted, Slot::WoodLight, Slot::WoodDark][form],
            form != 2,
        ),
        GeometrySet::Traditional => crowned_case(
            builder,
            bay,
            [Slot::Wood, Slot::WoodDark, Slot::Painted, Slot::Wood][form],
            form % 2 == 1,
        ),
        GeometrySet::Industrial => pipes(builder, bay, form),
        GeometrySet::Budget => thin_case(
            builder,
            bay,
            [Slot::Laminate, Slot::WoodLight, Slot::Painted, Slot::Laminate][form],
            form,
        ),
    };
    let slot = match draft.set() {
        GeometrySet::Plain => [Slot::Wood, Slot::Painted, Slot::WoodLight, Slot::WoodDark][form],
        GeometrySet::Traditional => [Slot::Wood, Slot::WoodDark, Slot::Painted, Slot::Wood][form],
        GeometrySet::Industrial => [Slot::Wood, Slot::Wood, Slot::MetalDark, Slot::WoodDark][form],
        GeometrySet::Budget => [Slot::Laminate, Slot::WoodLight, Slot::Painted, Slot::Laminate][form],
    };
    let board = match draft.set() {
        GeometrySet::Industrial => 0.032,
        GeometrySet::Budget => 0.014,
        _ => BOARD,
    };
    rows_of_books(draft, builder, open, slot, board);
}

/// Boards with books on them, from the floor of a bay to its top.
fn rows_of_books(draft: &Draft, builder: &mut Builder, open: Bay, slot: Slot, board: f64) {
    let mut sampler = draft.sampler();
    let count = draft.count_along("shelves", open.height(), SHELF_SPACING, 12);
    builder.cuboid(slot, open.slab(Side::Above, board));
    let most = (MOST_BOOKS / count).min((open.width() / 0.03) as u32).max(1);
    let form = draft.input.look % 4;
    for (index, row) in open.without(Side::Above, board).rows(count, 0.0).into_iter().enumerate() {
        builder.cuboid(slot, row.slab(Side::Below, board));
        let space = row.without(Side::Below, board - SINK).inset(SINK * 3.0, 0.0, 0.004);
        // The second look is half empty, the fourth keeps boxes below.
        let share = match form {
            1 => sampler.between(0.35, 0.75),
            _ if sampler.chance(0.25) => sampler.between(0.4, 0.7),
            _ => sampler.between(0.8, 0.97),
        };
        if form == 3 && index == 0 && count > 1 {
            fill_with_boxes(builder, &mut sampler, space.without(Side::Above, 0.03));
        } else {
            fill_with_books(builder, &mut sampler, space, share, most);
        }
    }
}

/// Sides, back and plinth of boards; gives the space for the shelves.
fn plain_case(builder: &mut Builder, bay: Bay, slot: Slot, has_back: bool) -> Bay {
    let board = BOARD.min(bay.width() * 0.1);
    for side in [Side::Left, Side::Right] {
        builder.block(slot, bay.slab(side, board), 0.003);
    }
    let inner = bay.inset(board - SINK, 0.0, 0.0);
    if has_back {
        builder.cuboid(slot, inner.slab(Side::Back, 0.008).inset(0.0, 0.004, 0.0).moved(0.0, 0.0, 0.002));
    }
    let open = inner.without(Side::Back, 0.01 - SINK).without(Side::Front, 0.003);
    let open = open.without(Side::Below, 0.05).without(Side::Above, 0.002);
    let base = open.slab(Side::Below, 0.05).moved(0.0, -0.05 + SINK, 0.0).without(Side::Front, 0.02);
    builder.cuboid(slot, base.inset(0.0, 0.001, 0.002));
    open
}

/// A cornice above, a moulded plinth below, stiles with ribs, and doors where asked for.
fn crowned_case(builder: &mut Builder, whole: Bay, slot: Slot, has_ribs: bool) -> Bay {
    let crown = 0.07_f64.min(whole.height() * 0.1);
    let overhang = 0.03_f64.min(whole.width() * 0.05).min(whole.depth() * 0.1);
    cornice(builder, slot, whole.slab(Side::Above, crown), overhang);
    let plinth = 0.08_f64.min(whole.height() * 0.12);
    let base = whole.slab(Side::Below, plinth).inset(overhang * 0.4, 0.0, 0.0).without(Side::Back, 0.001);
    slab_top(builder, slot, base.without(Side::Front, overhang * 0.4), true);
    let body = whole.inset(overhang, 0.0, 0.002).without(Side::Front, overhang);
    let body = body.without(Side::Above, crown - SINK).without(Side::Below, plinth - SINK);
    let stile = 0.045_f64.min(body.width() * 0.1);
    for side in [Side::Left, Side::Right] {
        builder.cuboid(slot, body.slab(side, BOARD));
        let front =
            body.slab(side, stile).slab(Side::Front, 0.018).moved(0.0, 0.0, 0.006).inset(-0.002, 0.001, 0.0);
        builder.block(slot, front, 0.004);
        if has_ribs {
            for rib in front.inset(0.006, body.height() * 0.06, 0.0).columns(3, 0.006) {
                builder.cuboid(slot, rib.slab(Side::Front, 0.003).moved(0.0, 0.0, 0.0025));
            }
        }
    }
    let inner = body.inset(BOARD - SINK, 0.0, 0.0);
    builder.cuboid(slot, inner.slab(Side::Back, 0.008).inset(0.0, 0.004, 0.0).moved(0.0, 0.0, 0.002));
    inner
        .without(Side::Back, 0.01 - SINK)
        .without(Side::Front, 0.014)
        .without(Side::Below, 0.002)
        .without(Side::Above, 0.006)
}

/// Posts of pipe with flanges, or of angles with a cross behind.
fn pipes(builder: &mut Builder, bay: Bay, form: usize) -> Bay {
    let post = 0.036_f64.min(bay.width() * 0.1).min(bay.depth() * 0.2);
    let kind = [LegKind::Pipe, LegKind::Angle, LegKind::Angle, LegKind::Square][form];
    legs_at_corners(builder, Slot::MetalDark, bay, post, kind);
    if form != 0 {
        let (z, x) = (bay.low.z + 0.012, bay.high.x - post * 0.6);
        let at = |x: f64, share: f64| DVec3::new(x, bay.low.y + share * bay.height(), z);
        builder.add(Slot::Metal, sweep(&[at(-x, 0.06), at(x, 0.94)], 0.005, 6));
        builder.add(Slot::Metal, sweep(&[at(x, 0.06), at(-x, 0.94)], 0.0048, 6).moved(0.0, 0.0, 0.008));
    }
    let inset = if form == 0 { post * 0.24 } else { post * 0.2 };
    bay.inset(inset + 0.0012, 0.0, inset + 0.0012)
        .without(Side::Back, 0.014)
        .without(Side::Below, 0.06)
        .without(Side::Above, 0.012)
}

/// Thin boards without a plinth, or standards with brackets on a wall.
fn thin_case(builder: &mut Builder, bay: Bay, slot: Slot, form: usize) -> Bay {
    let board = 0.015_f64.min(bay.width() * 0.08);
    if form == 1 {
        for x in [-0.3, 0.3] {
            let rail = bay
                .with_x([x * bay.width() - 0.012, x * bay.width() + 0.012])
                .slab(Side::Back, 0.012)
                .without(Side::Above, 0.002);
            builder.cuboid(Slot::Metal, rail);
            let count = 5;
            for row in bay.without(Side::Below, 0.04).rows(count, 0.0) {
                let arm = rail.inset(0.0068, 0.0, 0.0).with_z([rail.high.z - SINK, bay.high.z - 0.05]);
                builder.cuboid(Slot::Metal, arm.with_y([row.low.y - 0.025, row.low.y + 0.003]));
            }
        }
        return bay.without(Side::Back, 0.012 - SINK).without(Side::Below, 0.03);
    }
    for side in [Side::Left, Side::Right] {
        builder.cuboid(slot, bay.slab(side, board).without(Side::Front, 0.001));
        builder.cuboid(
            Slot::WoodLight,
            bay.slab(side, board).slab(Side::Front, 0.0015).inset(0.0006, 0.001, 0.0),
        );
    }
    let inner = bay.inset(board - SINK, 0.0, 0.002);
    if form != 3 {
        builder.cuboid(Slot::Paper, inner.slab(Side::Back, 0.004).inset(0.0, 0.004, 0.0));
    }
    inner
        .without(Side::Back, 0.004 - SINK)
        .without(Side::Front, 0.004)
        .without(Side::Below, 0.025)
        .without(Side::Above, 0.003)
}
