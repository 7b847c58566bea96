//! Tables and desks.

use super::input::Draft;
use super::parts::{Fittings, LegKind, leg, legs_at_corners, slab_top};
use crate::catalog::Side;
use crate::model::kit::{Bay, Builder, Outline, SINK, Slice, cylinder, lathe, loft};

/// Metres of a table top.
const TOP: f64 = 0.035;
/// Metres of a table leg; the shapes in the catalogue are cut for it.
const LEG: f64 = 0.05;
/// Metres by which a top stands over what carries it, so that they share no plane.
const OVERHANG: f64 = 0.004;
/// Metres of a desk's side panels.
const PANEL: f64 = 0.03;

/// Thickness of a top in a box of this height.
fn top_of(bay: Bay) -> f64 {
    TOP.min(bay.height() * 0.25)
}

/// Four legs at the corners under a top, with an apron.
pub(super) fn table(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let top = top_of(bay);
    slab_top(builder, "wood", bay.slab(Side::Above, top), draft.is_traditional());
    let overhang = if draft.is_traditional() { 0.014 } else { OVERHANG };
    let under = bay.without(Side::Above, top - SINK).inset(overhang, 0.0, overhang);
    let kind = match draft.is_traditional() {
        true => LegKind::Turned,
        false => sampler.pick(&[LegKind::Square, LegKind::Tapered]),
    };
    legs_at_corners(builder, "wood", under, LEG, kind);
    apron(builder, "wood", under, LEG, (bay.height() * 0.12).min(0.08));
}

/// Four boards under a top, between legs of a thickness.
fn apron(builder: &mut Builder, slot: &'static str, under: Bay, leg: f64, height: f64) {
    let board = 0.018;
    let band =
        under.without(Side::Above, SINK * 2.0).slab(Side::Above, height).inset(leg * 0.25, 0.0, leg * 0.25);
    let reach = leg * 0.75 - SINK;
    for side in [Side::Front, Side::Back] {
        builder.cuboid(slot, band.slab(side, board).inset(reach, 0.0, 0.0));
    }
    for side in [Side::Left, Side::Right] {
        builder.cuboid(slot, band.slab(side, board).inset(0.0, 0.0, reach));
    }
}

/// A round top on a pedestal with a disc foot.
pub(super) fn round_table(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let (half, height) = (bay.extent() / 2.0, bay.height());
    let top = top_of(bay);
    let slice = |y: f64, back: f64| Slice::new(y, half.x - back, half.z - back);
    let slices = if draft.is_traditional() {
        vec![
            slice(height - top, 0.015),
            slice(height - top * 0.5, 0.0),
            slice(height - top * 0.2, 0.0),
            slice(height, 0.006),
        ]
    } else {
        vec![slice(height - top, 0.004), slice(height - top * 0.7, 0.0), slice(height, 0.0)]
    };
    builder.add("wood", loft(&Outline::Round(24), &slices));
    let foot = half.x.min(half.z) * 0.5;
    let (slot, sides) = if draft.is_traditional() { ("wood", 12) } else { ("metal_dark", 12) };
    let neck = foot * 0.18;
    let end = height - top + SINK;
    let profile: Vec<(f64, f64)> = if draft.is_traditional() {
        let turned =
            [(1.0, 0.0), (0.95, 0.04), (0.35, 0.12), (0.22, 0.3), (0.42, 0.55), (0.24, 0.8), (0.6, 0.97)];
        let mut points: Vec<_> = turned.iter().map(|&(share, rise)| (share * foot, rise * end)).collect();
        points.push((foot * 0.6, end));
        points
    } else {
        vec![
            (foot, 0.0),
            (foot, 0.012),
            (neck * 1.4, 0.03),
            (neck, 0.06),
            (neck, end - 0.02),
            (foot * 0.5, end - 0.008),
            (foot * 0.5, end),
        ]
    };
    builder.add(slot, lathe(&profile, sides));
}

/// A top on two side panels with a modesty panel behind; `drawers` hang under the top on the right.
pub(super) fn desk(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let is_traditional = draft.is_traditional();
    let top = 0.03_f64.min(bay.height() * 0.2);
    slab_top(builder, "wood", bay.slab(Side::Above, top), is_traditional);
    let overhang = if is_traditional { 0.014 } else { OVERHANG };
    let under = bay.without(Side::Above, top - SINK).inset(overhang, 0.0, overhang);
    let slot = if is_traditional { "wood" } else { draft.sampler().pick(&["wood", "painted", "metal_dark"]) };
    for side in [Side::Left, Side::Right] {
        builder.cuboid(slot, under.slab(side, PANEL));
    }
    let between = under.inset(PANEL - SINK, 0.0, 0.0);
    let back = between.slab(Side::Back, 0.04).slab(Side::Front, 0.02).slab(Side::Above, bay.height() * 0.45);
    builder.cuboid(slot, back.without(Side::Above, SINK * 2.0));
    if draft.is_set("drawers") {
        desk_drawers(draft, builder, between.without(Side::Back, 0.06));
    }
}

fn desk_drawers(draft: &Draft, builder: &mut Builder, between: Bay) {
    let count = draft.count("drawers", 1);
    let width = (between.width() * 0.35).min(0.42);
    let height = (f64::from(count) * 0.13).min(between.height() * 0.85);
    let fittings =
        Fittings { front: "wood", handle: "metal", reach: 0.02, is_traditional: draft.is_traditional() };
    let box_bay = between.slab(Side::Right, width).slab(Side::Above, height).without(Side::Above, SINK * 2.0);
    let box_bay = box_bay.without(Side::Front, 0.01);
    fittings.carcass(builder, "wood", box_bay);
    for row in box_bay.inset(0.006, 0.004, 0.0).rows(count, 0.004) {
        fittings.drawer(builder, row);
    }
}

/// A low table with a shelf, or a glass top.
pub(super) fn coffee_table(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let top = top_of(bay);
    let is_traditional = draft.is_traditional();
    slab_top(builder, "wood", bay.slab(Side::Above, top), is_traditional);
    let overhang = if is_traditional { 0.014 } else { OVERHANG };
    let under = bay.without(Side::Above, top - SINK).inset(overhang, 0.0, overhang);
    let kind = if is_traditional {
        LegKind::Turned
    } else {
        sampler.pick(&[LegKind::Square, LegKind::Tapered, LegKind::Round])
    };
    legs_at_corners(builder, "wood", under, LEG, kind);
    if sampler.chance(0.7) {
        let y = bay.height() * 0.35;
        builder.block("wood", under.with_y([y, y + 0.02]).inset(LEG * 0.4, 0.0, LEG * 0.4), 0.003);
    } else {
        apron(builder, "wood", under, LEG, bay.height() * 0.12);
    }
}

/// A narrow table against a wall, with a drawer.
pub(super) fn console_table(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let is_traditional = draft.is_traditional();
    let top = top_of(bay);
    slab_top(builder, "wood", bay.slab(Side::Above, top), is_traditional);
    let overhang = if is_traditional { 0.014 } else { OVERHANG };
    let under = bay.without(Side::Above, top - SINK).inset(overhang, 0.0, overhang);
    let kind = if is_traditional { LegKind::Turned } else { LegKind::Tapered };
    legs_at_corners(builder, "wood", under, 0.04, kind);
    let fittings = Fittings { front: "wood", handle: "brass", reach: 0.02, is_traditional };
    let chest = under
        .slab(Side::Above, bay.height() * 0.18)
        .without(Side::Above, SINK * 2.0)
        .inset(0.006, 0.0, 0.002);
    fittings.carcass(builder, "wood", chest);
    let count = if bay.width() > 0.9 { 2 } else { 1 };
    for drawer in chest.inset(0.05, 0.008, 0.0).columns(count, 0.02) {
        fittings.drawer(builder, drawer);
    }
}

/// A laboratory bench: stone top on a steel frame, with a shelf for reagents where the box is high enough.
pub(super) fn lab_bench(_draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let has_shelf = bay.height() > 1.1;
    let work = if has_shelf { 0.9 } else { bay.height() };
    builder.block("stone", bay.with_y([work - 0.03, work]), 0.004);
    let under = bay.with_y([0.0, work - 0.03 + SINK]).inset(OVERHANG, 0.0, OVERHANG);
    for side in [Side::Left, Side::Right] {
        for end in [Side::Front, Side::Back] {
            leg(builder, "metal", under.slab(side, LEG).slab(end, LEG), LegKind::Square);
        }
    }
    let fittings = Fittings { front: "laminate", handle: "metal", reach: 0.02, is_traditional: false };
    let columns = under.inset(LEG + 0.01, 0.0, 0.0).without(Side::Front, 0.03).without(Side::Back, 0.05);
    let columns =
        columns.with_y([0.1, work - 0.05]).columns((bay.width() / 0.6).round().clamp(2.0, 5.0) as u32, 0.12);
    for (index, column) in columns.into_iter().enumerate().step_by(2) {
        fittings.carcass(builder, "laminate", column);
        let rows = column.inset(0.004, 0.004, 0.0).rows(if index == 0 { 3 } else { 1 }, 0.004);
        for row in rows {
            fittings.drawer(builder, row);
        }
    }
    builder.cuboid(
        "metal",
        under
            .with_y([work - 0.09, work - 0.05])
            .inset(LEG - SINK, 0.0, 0.0)
            .slab(Side::Back, 0.03)
            .moved(0.0, 0.0, 0.01),
    );
    if has_shelf {
        reagent_shelf(builder, bay.with_y([work - SINK, bay.high.y]));
    }
}

fn reagent_shelf(builder: &mut Builder, bay: Bay) {
    let rack = bay.slab(Side::Back, bay.depth() * 0.3).inset(0.03, 0.0, 0.01);
    for side in [Side::Left, Side::Right] {
        builder.cuboid("metal", rack.slab(side, 0.03));
    }
    for y in [bay.low.y + bay.height() * 0.5, bay.high.y - 0.02] {
        builder.cuboid("glass", rack.with_y([y, y + 0.018]).inset(0.03 - SINK, 0.0, 0.004));
    }
    for (index, column) in rack.inset(0.08, 0.0, 0.0).columns(5, 0.08).into_iter().enumerate() {
        let middle = column.center();
        let y = bay.low.y + bay.height() * 0.5 + 0.018 - SINK;
        let tall = bay.height() * (0.2 + 0.04 * (index % 3) as f64);
        let flask = cylinder(column.width().min(0.07) * 0.5, [y, y + tall], 8);
        builder.add(if index % 2 == 0 { "glass" } else { "plastic" }, flask.moved(middle.x, 0.0, middle.z));
    }
}

/// A speaker's desk with a sloping top.
pub(super) fn lectern(draft: &Draft, builder: &mut Builder) {
    use crate::model::kit::{Axis, extrude};
    use glam::DVec2;
    let bay = builder.bay();
    let is_traditional = draft.is_traditional();
    let (low, high) = (bay.low.z, bay.high.z);
    let rise = (bay.height() * 0.16).min(bay.depth() * 0.5);
    let front = bay.high.y - rise;
    // The reader stands before the front and looks down at the slope.
    let top =
        [(high, front - 0.03), (high, front), (low, bay.high.y), (low, bay.high.y - 0.03)].map(DVec2::from);
    builder.add("wood", extrude(&top, Axis::X, bay.x()));
    builder.block("wood", bay.with_y([0.0, 0.05]).inset(0.02, 0.0, 0.02), 0.006);
    let column = bay.inset(bay.width() * 0.2, 0.0, bay.depth() * 0.22).with_y([0.05 - SINK, front - 0.005]);
    if is_traditional {
        builder.cuboid("wood", column.inset(0.012, 0.0, 0.012).without(Side::Below, 0.002));
        for (y, tall) in [(0.05, 0.05), (front - 0.1, 0.05)] {
            builder.block("wood", column.with_y([y - SINK, y + tall]), 0.01);
        }
    } else {
        builder.cuboid("wood", column);
    }
    let ledge = Bay::new(bay.x(), [front - 0.002, front + 0.02], [high - 0.012, high - 0.001]);
    builder.cuboid("wood_dark", ledge.inset(0.02, 0.0, 0.0));
}
