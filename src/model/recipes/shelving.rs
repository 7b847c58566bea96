//! Open shelves and racks.

use glam::{DVec2, DVec3};

use super::input::{Draft, GeometrySet};
use super::parts::{cornice, fill_with_books};
use super::storage::fill_with_boxes;
use crate::catalog::Side;
use crate::model::kit::{Axis, Bay, Builder, SINK, Sampler, cylinder, extrude, lathe, sweep};

/// Metres of a board.
const BOARD: f64 = 0.02;
/// Metres between the shelves of a bookcase.
const SHELF_SPACING: f64 = 0.34;
/// The most books in one bookcase, so that it stays within its triangles.
const MOST_BOOKS: u32 = 84;

/// A bookcase with `shelves` bays full of books.
pub(super) fn bookshelf(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let form = draft.input.look as usize % 4;
    let open = match draft.set() {
        GeometrySet::Plain => {
            plain_case(builder, bay, ["wood", "painted", "wood_light", "wood_dark"][form], form != 2)
        }
        GeometrySet::Traditional => {
            crowned_case(builder, bay, ["wood", "wood_dark", "painted", "wood"][form], form % 2 == 1)
        }
        GeometrySet::Industrial => pipes(builder, bay, form),
        GeometrySet::Budget => {
            thin_case(builder, bay, ["laminate", "wood_light", "painted", "laminate"][form], form)
        }
    };
    let slot = match draft.set() {
        GeometrySet::Plain => ["wood", "painted", "wood_light", "wood_dark"][form],
        GeometrySet::Traditional => ["wood", "wood_dark", "painted", "wood"][form],
        GeometrySet::Industrial => ["wood", "wood", "metal_dark", "wood_dark"][form],
        GeometrySet::Budget => ["laminate", "wood_light", "painted", "laminate"][form],
    };
    let board = match draft.set() {
        GeometrySet::Industrial => 0.032,
        GeometrySet::Budget => 0.014,
        _ => BOARD,
    };
    rows_of_books(draft, builder, open, (slot, board));
}

/// Boards with books on them, from the floor of a bay to its top.
fn rows_of_books(draft: &Draft, builder: &mut Builder, open: Bay, (slot, board): (&'static str, f64)) {
    let mut sampler = draft.sampler();
    let count = draft.count("shelves", (open.height() / SHELF_SPACING).round().clamp(1.0, 12.0) as u32);
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
fn plain_case(builder: &mut Builder, bay: Bay, slot: &'static str, has_back: bool) -> Bay {
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
fn crowned_case(builder: &mut Builder, whole: Bay, slot: &'static str, has_ribs: bool) -> Bay {
    let crown = 0.07_f64.min(whole.height() * 0.1);
    let overhang = 0.03_f64.min(whole.width() * 0.05).min(whole.depth() * 0.1);
    cornice(builder, slot, whole.slab(Side::Above, crown), overhang);
    let plinth = 0.08_f64.min(whole.height() * 0.12);
    let base = whole.slab(Side::Below, plinth).inset(overhang * 0.4, 0.0, 0.0).without(Side::Back, 0.001);
    super::parts::slab_top(builder, slot, base.without(Side::Front, overhang * 0.4), true);
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
    let kind = [
        super::parts::LegKind::Pipe,
        super::parts::LegKind::Angle,
        super::parts::LegKind::Angle,
        super::parts::LegKind::Square,
    ][form];
    super::parts::legs_at_corners(builder, "metal_dark", bay, post, kind);
    if form != 0 {
        let (z, x) = (bay.low.z + 0.012, bay.high.x - post * 0.6);
        let at = |x: f64, share: f64| DVec3::new(x, bay.low.y + share * bay.height(), z);
        builder.add("metal", sweep(&[at(-x, 0.06), at(x, 0.94)], 0.005, 6));
        builder.add("metal", sweep(&[at(x, 0.06), at(-x, 0.94)], 0.0048, 6).moved(0.0, 0.0, 0.008));
    }
    let inset = if form == 0 { post * 0.24 } else { post * 0.2 };
    bay.inset(inset + 0.0012, 0.0, inset + 0.0012)
        .without(Side::Back, 0.014)
        .without(Side::Below, 0.06)
        .without(Side::Above, 0.012)
}

/// Thin boards without a plinth, or standards with brackets on a wall.
fn thin_case(builder: &mut Builder, bay: Bay, slot: &'static str, form: usize) -> Bay {
    let board = 0.015_f64.min(bay.width() * 0.08);
    if form == 1 {
        for x in [-0.3, 0.3] {
            let rail = bay
                .with_x([x * bay.width() - 0.012, x * bay.width() + 0.012])
                .slab(Side::Back, 0.012)
                .without(Side::Above, 0.002);
            builder.cuboid("metal", rail);
            let count = 5;
            for row in bay.without(Side::Below, 0.04).rows(count, 0.0) {
                let arm = rail.inset(0.0068, 0.0, 0.0).with_z([rail.high.z - SINK, bay.high.z - 0.05]);
                builder.cuboid("metal", arm.with_y([row.low.y - 0.025, row.low.y + 0.003]));
            }
        }
        return bay.without(Side::Back, 0.012 - SINK).without(Side::Below, 0.03);
    }
    for side in [Side::Left, Side::Right] {
        builder.cuboid(slot, bay.slab(side, board).without(Side::Front, 0.001));
        builder
            .cuboid("wood_light", bay.slab(side, board).slab(Side::Front, 0.0015).inset(0.0006, 0.001, 0.0));
    }
    let inner = bay.inset(board - SINK, 0.0, 0.002);
    if form != 3 {
        builder.cuboid("paper", inner.slab(Side::Back, 0.004).inset(0.0, 0.004, 0.0));
    }
    inner
        .without(Side::Back, 0.004 - SINK)
        .without(Side::Front, 0.004)
        .without(Side::Below, 0.025)
        .without(Side::Above, 0.003)
}

/// A shop's shelf: a foot with a kick plate, a back of perforated sheet, shelves with price strips, full of goods.
pub(super) fn gondola(draft: &Draft, builder: &mut Builder) {
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

/// An open rack with boxes: of slim steel, of wood with a rail, of angles with a cross, or of plastic tubes.
pub(super) fn shelf(draft: &Draft, builder: &mut Builder) {
    use super::parts::{LegKind, legs_at_corners};
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

/// A glazed case on a base.
pub(super) fn display_case(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let base = (bay.height() * 0.3).min(0.5);
    builder.block("wood", bay.slab(Side::Below, base), 0.004);
    builder.block("wood", bay.slab(Side::Above, 0.04), 0.004);
    let glazed = bay.with_y([base - SINK, bay.high.y - 0.04 + SINK]).inset(0.006, 0.0, 0.006);
    let frame = 0.02;
    super::parts::legs_at_corners(builder, "metal", glazed, frame, super::parts::LegKind::Square);
    let pane = 0.006;
    for side in [Side::Front, Side::Back] {
        builder.cuboid("glass", glazed.slab(side, frame).inset(frame - SINK, 0.0, (frame - pane) / 2.0));
    }
    for side in [Side::Left, Side::Right] {
        builder.cuboid("glass", glazed.slab(side, frame).inset((frame - pane) / 2.0, 0.0, frame - SINK));
    }
    let inner = glazed.inset(frame + 0.002, 0.0, frame + 0.002);
    let mut sampler = draft.sampler();
    let count = (inner.height() / 0.4).round().clamp(1.0, 4.0) as u32;
    for (index, row) in inner.rows(count, 0.0).into_iter().enumerate() {
        if index > 0 {
            builder.cuboid("glass", row.slab(Side::Below, 0.008).inset(0.0, 0.0, 0.001));
        }
        for column in row.inset(0.05, 0.0, 0.04).columns(2, 0.08) {
            let tall = (row.height() * sampler.between(0.3, 0.6)).min(0.3);
            let slot = sampler.pick(&["ceramic", "brass", "terracotta"]);
            let y = if index > 0 { row.low.y + 0.008 } else { row.low.y + SINK };
            let middle = column.center();
            let radius = (column.width().min(column.depth()) / 2.0).min(tall * 0.4);
            let profile = [
                (radius * 0.5, y - SINK),
                (radius, y + tall * 0.4),
                (radius * 0.3, y + tall * 0.8),
                (radius * 0.5, y + tall),
            ];
            builder.add(slot, crate::model::kit::lathe(&profile, 8).moved(middle.x, 0.0, middle.z));
        }
    }
}

/// Sloping shelves with magazines, covers to the front.
pub(super) fn magazine_rack(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let board = BOARD.min(bay.width() * 0.1);
    for side in [Side::Left, Side::Right] {
        builder.cuboid("wood", bay.slab(side, board));
    }
    let inner = bay.inset(board - SINK, 0.0, 0.003);
    builder.cuboid("wood", inner.slab(Side::Back, 0.012).inset(0.0, 0.003, 0.0));
    let count = (bay.height() / 0.32).round().clamp(1.0, 6.0) as u32;
    let slope = inner.without(Side::Back, 0.012 - SINK).without(Side::Below, 0.04);
    for row in slope.rows(count, 0.0) {
        let (back, front, low, high) = (row.low.z, row.high.z, row.low.y, row.high.y - 0.03);
        let rest = [(front - 0.012, low), (front, low), (front, low + 0.03), (front - 0.012, low + 0.03)];
        builder.cuboid("wood", Bay::new(row.x(), [low, low + 0.03], [rest[0].0, front]));
        let plate =
            [(front - 0.018, low + 0.002), (front - 0.0115, low + 0.002), (back + 0.008, high), (back, high)];
        builder.add("wood", extrude(&plate.map(DVec2::from), Axis::X, row.x()));
        let columns = (row.width() / 0.24).round().clamp(1.0, 6.0) as u32;
        for column in row.inset(0.015, 0.0, 0.0).columns(columns, 0.02) {
            let tall = sampler.between(0.75, 0.92);
            let along = |share: f64| {
                (
                    front - 0.012 + (back + 0.0085 - front + 0.012) * share,
                    low + 0.03 + (high - low - 0.03) * share,
                )
            };
            let (foot, head) = (along(0.02), along(tall));
            let cover = [foot, (foot.0 + 0.012, foot.1), (head.0 + 0.012, head.1), head].map(DVec2::from);
            builder.add(
                sampler.pick(&["paper", "book", "painted_accent"]),
                extrude(&cover, Axis::X, column.x()),
            );
        }
    }
}

/// A stand or a wall board with hooks for coats: a stand where it is deep and tall.
pub(super) fn coat_rack(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    if bay.depth() < bay.width() * 0.45 || bay.height() < 1.0 {
        hook_board(draft, builder, bay);
    } else {
        coat_stand(draft, builder, bay);
    }
}

fn hook_board(draft: &Draft, builder: &mut Builder, bay: Bay) {
    let board = bay.slab(Side::Back, 0.02);
    builder.block("wood", board, 0.004);
    let slot = if draft.is_traditional() { "brass" } else { "metal_dark" };
    let count = (bay.width() / 0.15).round().clamp(2.0, 10.0) as u32;
    for column in bay.inset(bay.width() * 0.04, 0.0, 0.0).columns(count, 0.0) {
        let x = column.center().x;
        let hook = |y: f64, z: f64| DVec3::new(x, bay.low.y + bay.height() * y, z);
        let tip = bay.high.z - 0.006;
        let path = [
            hook(0.65, board.high.z - SINK),
            hook(0.4, board.high.z + 0.3 * (tip - board.high.z)),
            hook(0.4, tip),
            hook(0.62, tip),
        ];
        builder.add(slot, sweep(&path, 0.006, 6));
    }
}

fn coat_stand(draft: &Draft, builder: &mut Builder, bay: Bay) {
    // Drawn round and stretched where the box is not square.
    let stretch = DVec3::new(1.0, 1.0, bay.depth() / bay.width());
    let slot =
        if draft.is_traditional() { "wood_dark" } else { draft.sampler().pick(&["wood", "metal_dark"]) };
    let radius = bay.width() / 2.0;
    builder.add(slot, cylinder(0.02, [0.06, bay.high.y], 10));
    let turn = |step: u32| std::f64::consts::FRAC_PI_2 * f64::from(step);
    for step in 0..4 {
        let foot =
            [DVec3::new(0.0, 0.1, 0.015), DVec3::new(0.0, 0.075, radius * 0.7), DVec3::new(0.0, 0.0, radius)];
        builder.add(slot, sweep(&foot, 0.012, 4).turned_y(turn(step)).stretched(stretch));
        let y = bay.high.y - if step % 2 == 0 { 0.14 } else { 0.3 };
        let reach = radius * 0.85;
        let hook =
            [DVec3::new(0.0, y, 0.012), DVec3::new(0.0, y, reach * 0.6), DVec3::new(0.0, y + 0.09, reach)];
        builder.add(slot, sweep(&hook, 0.009, 6).turned_y(turn(step)).stretched(stretch));
    }
}
