//! Laboratory benches: 0.90 m high for standing work, 0.75 deep, tops of stoneware, epoxy resin or steel 25 to 40 mm
//! thick (EN 13150, typical); cupboards 0.45 to 0.6 m wide hang or stand under them.

use glam::DVec3;

use super::{LEG, OVERHANG};
use crate::geometry::Side;
use crate::recipes::furniture::parts::{
    Fittings, HandleForm, HandleKind, LegKind, handle, legs_at_corners, raised_panel, slab_top,
};
use crate::recipes::kit::{Bay, Builder, SINK, cylinder, lathe};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// Metres of a working top over the floor.
const WORK: f64 = 0.9;
/// Height in metres from which a box has room for a shelf over the top.
const SHELF_FROM: f64 = 1.1;
/// Metres of a cupboard's width.
const CUPBOARD: f64 = 0.6;
/// Metres by which handles stand out.
const REACH: f64 = 0.02;

/// A bench: cupboards hung in a frame of steel, panelled wood, a welded frame with a steel top, or laminated boxes;
/// with a shelf for reagents where the box is high enough.
pub(in super::super) static LAB_BENCH: Recipe =
    Recipe::furniture("lab_bench", [1.8, 0.75, 0.9]).every_set(lab_bench);

fn lab_bench(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let has_shelf = bay.height() > SHELF_FROM;
    let work = if has_shelf { WORK } else { bay.height() };
    let bench = bay.with_y([0.0, work]);
    let form = draft.form();
    match draft.set() {
        GeometrySet::Plain => plain(builder, bench, form),
        GeometrySet::Traditional => traditional(builder, bench, form),
        GeometrySet::Industrial => industrial(builder, bench, form),
        GeometrySet::Budget => budget(builder, bench, form),
    }
    if has_shelf {
        reagent_shelf(builder, bay.with_y([work - SINK, bay.high.y]));
    }
}

/// How many cupboards a width has room for.
fn cupboard_count(width: f64) -> u32 {
    (width / CUPBOARD).round().clamp(2.0, 5.0) as u32
}

/// Cupboards with drawers and doors that hang between legs of steel; knee room where none hangs.
fn plain(builder: &mut Builder, bench: Bay, form: usize) {
    let top = [0.03, 0.03, 0.025, 0.04][form];
    let slot = [Slot::Stone, Slot::Ceramic, Slot::Laminate, Slot::Stone][form];
    builder.block(slot, bench.slab(Side::Above, top), 0.004);
    let under = bench.without(Side::Above, top - SINK).inset(OVERHANG, 0.0, OVERHANG);
    c_frames(builder, under, [Slot::Metal, Slot::Painted, Slot::Painted, Slot::MetalDark][form]);
    let front = [Slot::Laminate, Slot::Painted, Slot::WoodLight, Slot::PaintedAccent][form];
    let fittings = Fittings { front, handle: Slot::Metal, reach: REACH, is_traditional: false };
    let hung = under.inset(LEG + 0.01, 0.0, 0.0).without(Side::Front, 0.03).without(Side::Back, 0.05);
    let hung = hung.with_y([bench.height() * [0.11, 0.2, 0.11, 0.3][form], under.high.y - 0.02]);
    let columns = hung.columns(cupboard_count(bench.width()), 0.02);
    for (index, column) in columns.into_iter().enumerate() {
        if index % 2 == form % 2 {
            fittings.carcass(builder, Slot::Laminate, column);
            let rows = if index < 2 { 3 } else { 1 };
            for row in column.inset(0.004, 0.004, 0.0).rows(rows, 0.004) {
                fittings.drawer(builder, row);
            }
        }
    }
}

/// Legs with feet along the depth, and a rail behind.
fn c_frames(builder: &mut Builder, under: Bay, slot: Slot) {
    for side in [Side::Left, Side::Right] {
        let frame = under.slab(side, LEG);
        builder.cuboid(slot, frame.slab(Side::Back, LEG));
        builder.cuboid(
            slot,
            frame
                .slab(Side::Below, LEG)
                .without(Side::Back, LEG - SINK)
                .inset(0.001, 0.0, 0.0)
                .moved(0.0, 0.0008, 0.0),
        );
        builder.cuboid(
            slot,
            frame
                .slab(Side::Above, LEG * 0.8)
                .without(Side::Above, 0.001)
                .without(Side::Back, LEG - SINK)
                .inset(0.001, 0.0, 0.0),
        );
        builder.cuboid(slot, frame.slab(Side::Front, LEG).inset(0.002, LEG * 0.7, 0.001));
    }
    let rail = under.inset(LEG - SINK, 0.0, 0.0).slab(Side::Back, 0.03).moved(0.0, 0.0, 0.008);
    builder.cuboid(slot, rail.with_y([under.height() * 0.12, under.height() * 0.2]));
}

/// Doors with raised fields and brass between pilasters, on a plinth, under a thick moulded top.
fn traditional(builder: &mut Builder, bench: Bay, form: usize) {
    let slot = [Slot::Wood, Slot::WoodDark, Slot::Painted, Slot::Wood][form];
    slab_top(
        builder,
        [Slot::WoodDark, Slot::Stone, Slot::Wood, Slot::Stone][form],
        bench.slab(Side::Above, 0.04),
        true,
    );
    let under = bench
        .without(Side::Above, 0.04 - SINK)
        .inset(0.02, 0.0, 0.0)
        .without(Side::Front, REACH + 0.01)
        .without(Side::Back, 0.015);
    builder.cuboid(slot, under.slab(Side::Below, 0.09).without(Side::Front, 0.03).inset(0.012, 0.0, 0.002));
    let body = under.without(Side::Below, 0.09 - SINK);
    builder.cuboid(slot, body.without(Side::Front, 0.012));
    let count = cupboard_count(bench.width());
    for (index, column) in body.inset(0.02, 0.0, 0.0).columns(count, 0.05).into_iter().enumerate() {
        let is_chest = (index + form) % 3 == 1;
        let shares: &[[f64; 2]] = if is_chest {
            &[[0.0, 0.31], [0.33, 0.64], [0.66, 0.8], [0.82, 0.97]]
        } else {
            &[[0.0, 0.78], [0.81, 0.97]]
        };
        for (row, &[low, high]) in shares.iter().enumerate() {
            let y = [low, high].map(|share| column.low.y + 0.015 + share * (column.height() - 0.03));
            let front = column.with_y(y).slab(Side::Front, 0.014);
            builder.cuboid(slot, front);
            if row == 0 && !is_chest {
                let field = front.inset(0.05, 0.05, 0.0);
                raised_panel(builder, slot, field.with_z([front.high.z - SINK, front.high.z + 0.008]));
            }
            let at = DVec3::new(
                if row == 0 && !is_chest { front.high.x - 0.03 } else { front.center().x },
                front.center().y,
                front.high.z,
            );
            handle(builder, Slot::Brass, HandleForm { kind: HandleKind::Knob, length: 0.0 }, at, REACH);
        }
    }
    for x in [body.low.x, body.high.x - 0.03] {
        let pilaster = body.with_x([x, x + 0.03]).slab(Side::Front, 0.016).moved(0.0, 0.0, 0.006);
        builder.block(slot, pilaster.inset(0.002, 0.004, 0.0), 0.006);
    }
}

/// Steel: a folded top on a welded frame with a shelf below, crates and gas bottles on it, or a bank of drawers.
fn industrial(builder: &mut Builder, bench: Bay, form: usize) {
    let fold = 0.05;
    builder.block(
        [Slot::Metal, Slot::Metal, Slot::Wood, Slot::Metal][form],
        bench.slab(Side::Above, fold),
        0.005,
    );
    let under = bench.without(Side::Above, fold - SINK).inset(OVERHANG, 0.0, OVERHANG);
    let kind = [LegKind::Square, LegKind::Pipe, LegKind::Angle, LegKind::Square][form];
    let frame = [Slot::Metal, Slot::Metal, Slot::MetalDark, Slot::MetalDark][form];
    legs_at_corners(builder, frame, under, LEG, kind);
    let shelf =
        under.inset(LEG * 0.3, 0.0, LEG * 0.3).with_y([bench.height() * 0.2, bench.height() * 0.2 + 0.025]);
    builder.cuboid(frame, shelf);
    let brace = under.inset(LEG - SINK, 0.0, 0.0).slab(Side::Back, 0.02).moved(0.0, 0.0, 0.012);
    builder.cuboid(frame, brace.with_y([under.high.y - 0.12, under.high.y - 0.05]));
    let above = under.inset(LEG + 0.02, 0.0, 0.06).with_y([shelf.high.y - SINK, under.high.y - 0.06]);
    let (left, right) =
        (above.slab(Side::Left, above.width() * 0.34), above.slab(Side::Right, above.width() * 0.56));
    if form.is_multiple_of(2) {
        for (index, crate_bay) in left.slab(Side::Below, 0.24).columns(2, 0.03).into_iter().enumerate() {
            builder.cuboid([Slot::Plastic, Slot::PaintedAccent][index], crate_bay);
        }
        bottles(builder, right.slab(Side::Below, 0.3));
    } else {
        let fittings =
            Fittings { front: Slot::Metal, handle: Slot::MetalDark, reach: REACH, is_traditional: false };
        let unit = right.without(Side::Front, -0.03).with_y([shelf.high.y - SINK, under.high.y - 0.002]);
        fittings.carcass(builder, Slot::MetalDark, unit);
        for column in unit.inset(0.006, 0.0, 0.0).columns(2, 0.006) {
            for row in column.inset(0.0, 0.006, 0.0).rows(3, 0.006) {
                fittings.drawer(builder, row);
            }
        }
        bottles(builder, left.slab(Side::Below, 0.3));
    }
}

/// Bottles of gas or of solvent in a row.
fn bottles(builder: &mut Builder, bay: Bay) {
    for (index, cell) in bay.columns(4, 0.03).into_iter().enumerate() {
        let radius = (cell.width().min(cell.depth()) * 0.45).min(0.06);
        let (middle, low) = (cell.center(), cell.low.y);
        let tall = cell.height() * [0.9, 0.7, 1.0, 0.8][index];
        let shape = [
            (radius, low),
            (radius, low + tall * 0.7),
            (radius * 0.3, low + tall * 0.85),
            (radius * 0.3, low + tall),
        ];
        let slot = [Slot::Glass, Slot::Plastic, Slot::Leather, Slot::PaintedAccent][index];
        builder.add(slot, lathe(&shape, 8).moved(middle.x, 0.0, middle.z));
    }
}

/// Boxes of laminated board side by side under a thin top, on a plinth, with a place for knees between them.
fn budget(builder: &mut Builder, bench: Bay, form: usize) {
    builder.cuboid(Slot::Laminate, bench.slab(Side::Above, 0.006));
    let core = bench.slab(Side::Above, 0.034).without(Side::Above, 0.006 - SINK).inset(0.001, 0.0, 0.001);
    builder.cuboid([Slot::WoodLight, Slot::PlasticDark, Slot::WoodLight, Slot::PaintedAccent][form], core);
    let under = bench.without(Side::Above, 0.034 - SINK).inset(OVERHANG, 0.0, OVERHANG);
    let count = cupboard_count(bench.width()) + 1;
    let open = [1, count, 2, 1][form].min(count);
    let reach = 0.016;
    for (index, column) in (0..).zip(under.columns(count, 0.002)) {
        if index == open {
            builder.cuboid(
                Slot::Laminate,
                column.slab(Side::Back, 0.018).inset(-0.003, 0.1, 0.0).moved(0.0, 0.0, 0.03),
            );
            continue;
        }
        builder.cuboid(
            Slot::PlasticDark,
            column
                .slab(Side::Below, 0.1)
                .inset(0.001, 0.0, 0.0)
                .without(Side::Front, 0.07)
                .without(Side::Back, 0.02),
        );
        let body = column.without(Side::Below, 0.1 - SINK);
        builder.cuboid(
            Slot::Laminate,
            body.without(Side::Front, reach + 0.018 - SINK).without(Side::Above, SINK / 2.0),
        );
        let fronts = body.without(Side::Front, reach).slab(Side::Front, 0.018).inset(0.002, 0.003, 0.0);
        let split = fronts.height() * 0.76;
        let parts = [fronts.slab(Side::Below, split), fronts.without(Side::Below, split + 0.004)];
        for part in parts {
            builder.cuboid([Slot::Laminate, Slot::Painted, Slot::Laminate, Slot::Plastic][form], part);
            let at = DVec3::new(part.center().x, part.high.y - 0.04, part.high.z);
            handle(
                builder,
                Slot::PlasticDark,
                HandleForm { kind: HandleKind::Level, length: 0.12 },
                at,
                reach,
            );
        }
    }
}

fn reagent_shelf(builder: &mut Builder, bay: Bay) {
    let rack = bay.slab(Side::Back, bay.depth() * 0.3).inset(0.03, 0.0, 0.01);
    for side in [Side::Left, Side::Right] {
        builder.cuboid(Slot::Metal, rack.slab(side, 0.03));
    }
    for y in [bay.low.y + bay.height() * 0.5, bay.high.y - 0.02] {
        builder.cuboid(Slot::Glass, rack.with_y([y, y + 0.018]).inset(0.03 - SINK, 0.0, 0.004));
    }
    for (index, column) in rack.inset(0.08, 0.0, 0.0).columns(5, 0.08).into_iter().enumerate() {
        let middle = column.center();
        let y = bay.low.y + bay.height() * 0.5 + 0.018 - SINK;
        let tall = bay.height() * (0.2 + 0.04 * (index % 3) as f64);
        let flask = cylinder(column.width().min(0.07) * 0.5, [y, y + tall], 8);
        builder.add(
            if index.is_multiple_of(2) { Slot::Glass } else { Slot::Plastic },
            flask.moved(middle.x, 0.0, middle.z),
        );
    }
}
