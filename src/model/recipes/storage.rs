//! Cupboards, chests and what else has doors or drawers.

use super::input::{Draft, GeometrySet};
use super::parts::{Fronts, LegKind, REVEAL, cornice, legs_at_corners, slab_top};
use crate::catalog::Side;
use crate::model::kit::{Bay, Builder, SINK, Sampler};

/// Metres by which handles stand out.
const REACH: f64 = 0.022;
/// Metres of a plinth's height.
const PLINTH: f64 = 0.07;
/// Metres of a moulded top or cornice.
const CORNICE: f64 = 0.07;
/// Metres by which a cornice stands over the body.
const CORNICE_OVERHANG: f64 = 0.035;
/// Metres by which a plain top stands over the body.
const OVERHANG: f64 = 0.003;
/// The usual width of a door in metres.
const DOOR: f64 = 0.5;

/// Material of the body of a piece.
fn body_slot(draft: &Draft) -> &'static str {
    let form = draft.input.look as usize % 4;
    match draft.set() {
        GeometrySet::Plain => ["painted", "wood", "wood", "wood_light"][form],
        GeometrySet::Traditional => ["wood", "wood_dark", "painted", "wood"][form],
        GeometrySet::Industrial => ["metal", "metal_dark", "metal_dark", "painted_accent"][form],
        GeometrySet::Budget => ["laminate", "painted", "wood_light", "laminate"][form],
    }
}

fn fronts(draft: &Draft) -> Fronts {
    let form = draft.input.look as usize % 4;
    let (front, handle) = match draft.set() {
        GeometrySet::Plain => (
            ["painted", "wood", "painted", "wood_light"][form],
            ["metal", "metal_dark", "leather", "metal"][form],
        ),
        GeometrySet::Traditional => (body_slot(draft), ["brass", "brass", "wood_dark", "metal_dark"][form]),
        GeometrySet::Industrial => {
            (["metal", "metal_dark", "metal_dark", "painted_accent"][form], "metal_dark")
        }
        GeometrySet::Budget => (
            ["laminate", "painted", "laminate", "painted_accent"][form],
            ["plastic_dark", "metal", "metal", "wood_light"][form],
        ),
    };
    Fronts::new(draft, front, handle, REACH)
}

/// Doors side by side, hinged in pairs so that handles meet in the middle.
fn doors(builder: &mut Builder, fittings: &Fronts, bay: Bay, count: u32, rise: f64) {
    let face = bay.inset(REVEAL / 2.0, REVEAL / 2.0, 0.0);
    for (index, column) in face.columns(count, REVEAL).into_iter().enumerate() {
        let hinge = if index % 2 == 0 { Side::Left } else { Side::Right };
        let hinge = if count == 1 { Side::Right } else { hinge };
        fittings.door(builder, column, hinge, rise);
    }
}

fn drawers(builder: &mut Builder, fittings: &Fronts, bay: Bay, count: u32) {
    for row in bay.inset(REVEAL / 2.0, REVEAL / 2.0, 0.0).rows(count, REVEAL) {
        fittings.drawer(builder, row);
    }
}

/// The box of a tall or wide piece: what it stands on and what crowns it, by set. Gives the bay of the body from back
/// wall to handle tips.
fn case(draft: &Draft, builder: &mut Builder, slot: &'static str) -> Bay {
    let bay = builder.bay();
    let plinth = PLINTH.min(bay.height() * 0.15);
    let form = draft.input.look % 4;
    match (draft.set(), form) {
        (GeometrySet::Traditional, _) => return crowned_case(draft, builder, slot, plinth),
        (GeometrySet::Industrial, 1 | 2) => return framed_case(builder, bay, plinth),
        (GeometrySet::Plain, 2) | (GeometrySet::Industrial, _) | (GeometrySet::Budget, 1) => {
            let (legs, kind) = match draft.set() {
                GeometrySet::Plain => ("wood", LegKind::Tapered),
                GeometrySet::Industrial => ("metal_dark", LegKind::Square),
                _ => ("plastic_dark", LegKind::Round),
            };
            let feet = bay.slab(Side::Below, plinth + SINK).inset(0.03, 0.0, 0.0);
            let feet = feet.without(Side::Front, 0.06).without(Side::Back, 0.01);
            legs_at_corners(builder, legs, feet, 0.04, kind);
        }
        _ => {
            let kick = bay.slab(Side::Below, plinth + SINK).inset(0.004, 0.0, 0.0);
            builder.cuboid(slot, kick.without(Side::Front, 0.06).without(Side::Back, 0.002));
        }
    }
    let body = bay.without(Side::Below, plinth);
    if draft.set() == GeometrySet::Industrial || form.is_multiple_of(2) {
        return body;
    }
    // Sides and top stand as boards around the fronts.
    let board = 0.018;
    for side in [Side::Left, Side::Right] {
        let end = body.slab(side, board).without(Side::Front, REACH * 0.5).without(Side::Back, 0.001);
        builder.block(slot, end.without(Side::Above, board - SINK), 0.003);
    }
    builder.block(slot, body.slab(Side::Above, board).without(Side::Front, REACH * 0.4), 0.003);
    body.inset(board - SINK, 0.0, 0.0).without(Side::Above, board - SINK).without(Side::Back, 0.003)
}

/// A cornice above and a plinth, or feet, below.
fn crowned_case(draft: &Draft, builder: &mut Builder, slot: &'static str, plinth: f64) -> Bay {
    let bay = builder.bay();
    let crown = CORNICE.min(bay.height() * 0.12);
    let overhang = CORNICE_OVERHANG.min(bay.width() * 0.05).min(bay.depth() * 0.1);
    cornice(builder, slot, bay.slab(Side::Above, crown), overhang);
    let body = bay.inset(overhang, 0.0, 0.0).without(Side::Front, overhang * 0.6).without(Side::Back, 0.002);
    let base =
        bay.slab(Side::Below, plinth).inset(overhang * 0.4, 0.0, 0.0).without(Side::Front, overhang * 0.3);
    if draft.input.look.is_multiple_of(2) {
        slab_top(builder, slot, base, true);
    } else {
        slab_top(builder, slot, base.slab(Side::Above, plinth * 0.35), true);
        legs_at_corners(
            builder,
            slot,
            base.inset(0.01, 0.0, 0.01).without(Side::Above, plinth * 0.3),
            0.07,
            LegKind::Spade,
        );
    }
    body.without(Side::Above, crown - SINK).without(Side::Below, plinth - SINK)
}

/// Angles of steel at the corners, under and over the body.
fn framed_case(builder: &mut Builder, bay: Bay, plinth: f64) -> Bay {
    let iron = 0.032_f64.min(bay.width() * 0.08);
    let frame = bay.without(Side::Front, REACH * 0.6);
    legs_at_corners(builder, "metal_dark", frame, iron, LegKind::Angle);
    let board = 0.025;
    builder.block(
        "wood",
        frame.inset(0.006, 0.0, 0.006).slab(Side::Above, board).moved(0.0, -0.003, 0.0),
        0.004,
    );
    let body = bay.inset(iron * 0.25, 0.0, 0.0).without(Side::Back, iron * 0.25);
    body.without(Side::Below, plinth).without(Side::Above, board + 0.002)
}

/// A tall cupboard for clothes; `doors`, or one for each half metre.
pub(super) fn wardrobe(draft: &Draft, builder: &mut Builder) {
    let body = case(draft, builder, body_slot(draft));
    let fittings = fronts(draft);
    fittings.carcass(builder, body_slot(draft), body);
    let count = draft.count("doors", (body.width() / DOOR).round().clamp(1.0, 6.0) as u32);
    let has_drawers = draft.sampler().count(0, 2) == 2 && body.height() > 1.5;
    let upper = if has_drawers { body.without(Side::Below, 0.42) } else { body };
    if has_drawers {
        let columns = body.slab(Side::Below, 0.42).columns((count / 2).max(1), 0.0);
        columns.into_iter().for_each(|column| drawers(builder, &fittings, column, 2));
    }
    doors(builder, &fittings, upper, count, if has_drawers { 0.35 } else { 0.48 });
}

/// A chest of drawers; `drawers` rows, two columns where it is wide.
pub(super) fn dresser(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let body = chest_on_feet(draft, builder, body_slot(draft));
    let fittings = fronts(draft);
    fittings.carcass(builder, body_slot(draft), body);
    let rows = draft.count("drawers", (bay.height() / 0.24).round().clamp(1.0, 6.0) as u32);
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
fn chest_on_feet(draft: &Draft, builder: &mut Builder, slot: &'static str) -> Bay {
    let bay = builder.bay();
    let is_traditional = draft.is_traditional();
    let top = 0.022_f64.min(bay.height() * 0.1);
    let top_slot = if draft.set() == GeometrySet::Industrial { "wood" } else { slot };
    slab_top(builder, top_slot, bay.slab(Side::Above, top), is_traditional);
    let foot = (bay.height() * 0.22).min([0.06, 0.12, 0.17, 0.09][draft.input.look as usize % 4]);
    let overhang = if is_traditional { 0.016 } else { OVERHANG };
    let body = bay.without(Side::Above, top - SINK).inset(overhang, 0.0, 0.0).without(Side::Back, overhang);
    let body = body.without(Side::Front, overhang);
    let form = draft.input.look as usize % 4;
    let (feet, kind) = match draft.set() {
        GeometrySet::Plain => (
            ["wood", "metal_dark", "wood", "wood_light"][form],
            [LegKind::Square, LegKind::Round, LegKind::Tapered, LegKind::Tapered][form],
        ),
        GeometrySet::Traditional => {
            (slot, [LegKind::Turned, LegKind::Spade, LegKind::Tapered, LegKind::Spade][form])
        }
        GeometrySet::Industrial => {
            ("metal_dark", [LegKind::Pipe, LegKind::Angle, LegKind::Hairpin, LegKind::Square][form])
        }
        GeometrySet::Budget => (
            ["plastic_dark", "chrome", "wood_light", "plastic_dark"][form],
            [LegKind::Square, LegKind::Round, LegKind::Tapered, LegKind::Round][form],
        ),
    };
    let legs = body.with_y([0.0, foot + SINK]).inset(0.012, 0.0, 0.012).without(Side::Front, 0.034);
    legs_at_corners(builder, feet, legs, 0.042, kind);
    body.without(Side::Below, foot)
}

/// A bedside cabinet: a drawer over an open bay or more drawers.
pub(super) fn nightstand(draft: &Draft, builder: &mut Builder) {
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

/// Two cheeks, a back and a bottom; open to the front, closed above by what stands on it.
fn open_box(builder: &mut Builder, slot: &'static str, bay: Bay, board: f64) {
    for side in [Side::Left, Side::Right] {
        builder.cuboid(slot, bay.slab(side, board));
    }
    let inner = bay.inset(board - SINK, 0.0, 0.002);
    builder.cuboid(slot, inner.slab(Side::Below, board).moved(0.0, SINK * 2.0, 0.0));
    builder.cuboid(
        slot,
        inner
            .slab(Side::Back, board * 0.5)
            .without(Side::Below, board)
            .moved(0.0, 0.0, SINK * 2.0)
            .without(Side::Above, SINK * 2.0),
    );
}

/// A cupboard with `doors`.
pub(super) fn cabinet(draft: &Draft, builder: &mut Builder) {
    let body = case(draft, builder, body_slot(draft));
    let fittings = fronts(draft);
    fittings.carcass(builder, body_slot(draft), body);
    let count = draft.count("doors", (body.width() / DOOR).round().clamp(1.0, 6.0) as u32);
    let has_drawer_row = draft.sampler().count(0, 3) == 3 && body.height() > 0.6;
    let lower = if has_drawer_row { body.without(Side::Above, 0.16) } else { body };
    if has_drawer_row {
        for column in body.slab(Side::Above, 0.16).columns(count, 0.0) {
            drawers(builder, &fittings, column, 1);
        }
    }
    doors(builder, &fittings, lower, count, if body.height() < 1.1 { 0.75 } else { 0.5 });
}

/// A long low cupboard on legs with doors and drawers.
pub(super) fn sideboard(draft: &Draft, builder: &mut Builder) {
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

/// A steel cabinet with `drawers` for hanging files.
pub(super) fn filing_cabinet(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let fittings =
        super::parts::Fittings { front: "metal", handle: "metal_dark", reach: REACH, is_traditional: false };
    fittings.carcass(builder, "metal", bay);
    let body = bay.without(Side::Below, 0.04_f64.min(bay.height() * 0.1));
    let count = draft.count("drawers", (bay.height() / 0.33).round().clamp(1.0, 5.0) as u32);
    for row in body.inset(REVEAL, REVEAL / 2.0, 0.0).rows(count, REVEAL) {
        fittings.drawer(builder, row);
        let plate = row.without(Side::Front, REACH - 0.001).slab(Side::Front, 0.0015);
        let middle = plate.center();
        let label = Bay::around(middle, row.width() * 0.2, 0.035_f64.min(row.height() * 0.2), plate.depth());
        builder.cuboid("paper", label.moved(0.0, row.height() * 0.28, 0.0));
    }
}

/// Steel lockers; `doors` side by side, in one or two rows by look.
pub(super) fn locker(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let fittings = super::parts::Fittings {
        front: "painted_accent",
        handle: "metal_dark",
        reach: REACH * 0.6,
        is_traditional: false,
    };
    let plinth = PLINTH.min(bay.height() * 0.1);
    builder.cuboid(
        "metal_dark",
        bay.slab(Side::Below, plinth + SINK).inset(0.004, 0.0, 0.004).without(Side::Front, 0.02),
    );
    let body = bay.without(Side::Below, plinth);
    fittings.carcass(builder, "metal", body);
    let count = draft.count("doors", (bay.width() / 0.35).round().clamp(1.0, 6.0) as u32);
    let rows = sampler.count(1, 2);
    for row in body.inset(REVEAL, REVEAL, 0.0).rows(rows, REVEAL) {
        for column in row.columns(count, REVEAL) {
            fittings.door(builder, column, Side::Left, 0.5);
            vents(builder, column.without(Side::Front, fittings.reach));
        }
    }
}

/// Slots near the top of a steel door, as dark strips on it.
fn vents(builder: &mut Builder, door: Bay) {
    let field = door.inset(door.width() * 0.25, 0.0, 0.0).slab(Side::Above, door.height() * 0.14);
    let field = field.without(Side::Above, door.height() * 0.05);
    for strip in field.rows(3, field.height() * 0.22) {
        builder.cuboid("metal_dark", strip.with_z([door.high.z - 0.003, door.high.z + 0.001]));
    }
}

/// A low cupboard for a television: an open bay between doors.
pub(super) fn tv_stand(draft: &Draft, builder: &mut Builder) {
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
            builder.block("plastic_dark", player, 0.004);
        } else {
            let column = column.inset(SINK * 3.0, 0.0, 0.0);
            fittings.carcass(builder, body_slot(draft), column);
            doors(builder, &fittings, column, 1, 0.6);
        }
    }
}

/// A cupboard that hangs on a wall, with `doors`.
pub(super) fn wall_cabinet(draft: &Draft, builder: &mut Builder) {
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
    let count = draft.count("doors", (bay.width() / DOOR).round().clamp(1.0, 6.0) as u32);
    doors(builder, &fittings, body, count, 0.2);
}

/// A narrow cabinet with tilting flaps for shoes.
pub(super) fn shoe_cabinet(draft: &Draft, builder: &mut Builder) {
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

/// Boxes of goods, as seen on racks and in lockers, from the left along the floor of a bay.
pub(super) fn fill_with_boxes(builder: &mut Builder, sampler: &mut Sampler, bay: Bay) {
    let mut left = bay.low.x + 0.01;
    for _ in 0..6 {
        let width = sampler.between(0.16, 0.36).min(bay.width() * 0.6);
        if left + width > bay.high.x {
            return;
        }
        let height = bay.height() * sampler.between(0.4, 0.85);
        let depth = bay.depth() * sampler.between(0.7, 0.95);
        let carton = bay.with_x([left, left + width]).slab(Side::Below, height).slab(Side::Front, depth);
        builder.cuboid(sampler.pick(&["paper", "plastic", "painted_accent"]), carton);
        left += width + sampler.between(0.01, 0.12);
    }
}
