//! Open shelves and racks.

use glam::{DVec2, DVec3};

use super::input::Draft;
use super::parts::{cornice, fill_with_books};
use super::storage::fill_with_boxes;
use crate::catalog::Side;
use crate::model::kit::{Axis, Bay, Builder, SINK, cylinder, extrude, sweep};

/// Metres of a board.
const BOARD: f64 = 0.02;
/// Metres between the shelves of a bookcase.
const SHELF_SPACING: f64 = 0.34;
/// The most books in one bookcase, so that it stays within its triangles.
const MOST_BOOKS: u32 = 84;

/// A bookcase with `shelves` bays full of books.
pub(super) fn bookshelf(draft: &Draft, builder: &mut Builder) {
    let whole = builder.bay();
    let mut sampler = draft.sampler();
    let bay = if draft.is_traditional() {
        let crown = 0.06_f64.min(whole.height() * 0.1);
        let overhang = 0.03_f64.min(whole.width() * 0.05).min(whole.depth() * 0.1);
        cornice(builder, "wood", whole.slab(Side::Above, crown), overhang);
        let body = whole.inset(overhang, 0.0, 0.002).without(Side::Front, overhang);
        body.without(Side::Above, crown - SINK)
    } else {
        whole
    };
    let board = BOARD.min(bay.width() * 0.1);
    for side in [Side::Left, Side::Right] {
        builder.cuboid("wood", bay.slab(side, board));
    }
    let inner = bay.inset(board - SINK, 0.0, 0.0);
    builder.cuboid("wood", inner.slab(Side::Back, 0.008).inset(0.0, 0.004, 0.0).moved(0.0, 0.0, 0.002));
    let open = inner
        .without(Side::Back, 0.01 - SINK)
        .without(Side::Front, 0.003)
        .without(Side::Below, 0.05)
        .without(Side::Above, 0.002);
    let count = draft.count("shelves", (open.height() / SHELF_SPACING).round().clamp(1.0, 12.0) as u32);
    builder.cuboid("wood", open.slab(Side::Above, board));
    let most = (MOST_BOOKS / count).min((open.width() / 0.03) as u32).max(1);
    for row in open.without(Side::Above, board).rows(count, 0.0) {
        builder.cuboid("wood", row.slab(Side::Below, board));
        let space = row.without(Side::Below, board - SINK).inset(SINK * 3.0, 0.0, 0.004);
        let share = if sampler.chance(0.25) { sampler.between(0.4, 0.7) } else { sampler.between(0.8, 0.97) };
        fill_with_books(builder, &mut sampler, space, share, most);
    }
    let base = open.slab(Side::Below, 0.05).moved(0.0, -0.05 + SINK, 0.0).without(Side::Front, 0.02);
    builder.cuboid("wood", base.inset(0.0, 0.001, 0.002));
}

/// An open steel rack with boxes.
pub(super) fn shelf(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let post = 0.035_f64.min(bay.width() * 0.1).min(bay.depth() * 0.2);
    super::parts::legs_at_corners(builder, "metal", bay, post, super::parts::LegKind::Square);
    let count = (bay.height() / 0.42).round().clamp(2.0, 7.0) as u32;
    let inner =
        bay.inset(post * 0.15, 0.0, post * 0.15).without(Side::Above, 0.02).without(Side::Below, 0.06);
    for row in inner.rows(count, 0.0) {
        builder.cuboid("metal", row.slab(Side::Below, 0.025));
        let space = row.without(Side::Below, 0.025 - SINK).inset(post, 0.0, 0.02);
        if row.height() > 0.12 && row.high.y < inner.high.y + SINK {
            fill_with_boxes(builder, &mut sampler, space.without(Side::Above, 0.03));
        }
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
