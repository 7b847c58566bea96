//! Desks: 0.72 to 0.74 m high (EN 527-1), supported at both ends so that knees and drawer units find room.

use glam::DVec3;

use super::{OVERHANG, top_board};
use crate::geometry::Side;
use crate::recipes::furniture::parts::{
    Fronts, HandleForm, HandleKind, LegKind, handle, leg, raised_panel, slanted_leg,
};
use crate::recipes::kit::{Bay, Builder, SINK, cuboid, pipe, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// Metres of a desk's side panels.
const PANEL: f64 = 0.03;

/// A desk; `drawers` hang under the top on the right.
pub(in super::super) static DESK: Recipe =
    Recipe::furniture("desk", [1.6, 0.8, 0.74]).with(&[("drawers", 0.0)]).every_set(desk);

fn desk(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let form = draft.form();
    let top = 0.03_f64.min(bay.height() * 0.2);
    top_board(draft, builder, bay.slab(Side::Above, top));
    let overhang = if draft.is_traditional() { 0.014 } else { OVERHANG };
    let under = bay.without(Side::Above, top - SINK).inset(overhang, 0.0, overhang);
    match draft.set() {
        GeometrySet::Plain => plain(builder, under, form),
        GeometrySet::Traditional => traditional(builder, under, form),
        GeometrySet::Industrial => industrial(builder, under, form),
        GeometrySet::Budget => budget(builder, under, form),
    }
    if draft.is_set("drawers") {
        desk_drawers(draft, builder, under.inset(PANEL * 1.8, 0.0, 0.0).without(Side::Back, 0.06));
    }
}

fn desk_drawers(draft: &Draft, builder: &mut Builder, between: Bay) {
    let count = draft.count("drawers", 1).min(8);
    let width = (between.width() * 0.35).min(0.42);
    let height = (f64::from(count) * 0.13).min(between.height() * 0.85);
    let fittings = Fronts::new(draft, Slot::Wood, Slot::Metal, 0.02);
    let box_bay = between.slab(Side::Right, width).slab(Side::Above, height).without(Side::Above, SINK * 5.0);
    let box_bay = box_bay.without(Side::Front, 0.014);
    fittings.carcass(builder, Slot::Wood, box_bay);
    for row in box_bay.inset(0.006, 0.004, 0.0).rows(count, 0.004) {
        fittings.drawer(builder, row);
    }
}

/// A panel behind the knees, in the upper half.
fn modesty(builder: &mut Builder, slot: Slot, under: Bay, share: f64) -> Bay {
    let between = under.inset(PANEL - SINK, 0.0, 0.0).without(Side::Above, SINK * 2.0);
    let panel =
        between.slab(Side::Back, 0.034).slab(Side::Front, 0.016).slab(Side::Above, under.height() * share);
    builder.cuboid(slot, panel);
    panel
}

/// Shallow drawers in a rail under the top.
fn pencil_drawers(builder: &mut Builder, slot: Slot, under: Bay, count: u32, kind: HandleKind) {
    let rail = under.inset(0.0485, 0.0, 0.012).without(Side::Above, SINK * 3.5).slab(Side::Above, 0.038);
    builder.cuboid(slot, rail.without(Side::Front, 0.012));
    for front in rail.columns(count, 0.006) {
        builder.block(slot, front.slab(Side::Front, 0.014).inset(0.0, 0.001, 0.0), 0.003);
        let at = DVec3::new(front.center().x, front.center().y, front.high.z);
        handle(builder, Slot::Brass, HandleForm { kind, length: 0.1 }, at, 0.011);
    }
}

/// Legs that lean along the depth at both ends.
fn slanted_ends(builder: &mut Builder, slot: Slot, under: Bay, radius: f64) {
    let x = under.high.x - radius * 1.2;
    for (z, inwards) in [(under.low.z, 1.0), (under.high.z, -1.0)] {
        let at = |y: f64, off: f64| DVec3::new(x, y, z + inwards * off);
        let ends = [at(0.0, radius), at(under.high.y, radius + 0.11)];
        builder.add_pair(slot, slanted_leg(ends, radius, &[(0.6, 0.0), (1.0, 0.9), (1.0, 1.0)], 10));
    }
}

/// A closed frame of bar at either end.
fn loops(builder: &mut Builder, slot: Slot, under: Bay, width: f64, bar: f64) {
    for side in [Side::Left, Side::Right] {
        let frame = under.slab(side, width);
        for end in [Side::Front, Side::Back] {
            builder.block(slot, frame.slab(end, bar), 0.003);
        }
        for edge in [Side::Below, Side::Above] {
            let run = frame.slab(edge, bar).inset(0.0015, 0.0, bar - SINK);
            builder.cuboid(
                slot,
                if edge == Side::Below { run.moved(0.0, 0.0015, 0.0) } else { run.moved(0.0, -0.0015, 0.0) },
            );
        }
    }
}

fn plain(builder: &mut Builder, under: Bay, form: usize) {
    match form {
        0 => {
            for side in [Side::Left, Side::Right] {
                builder.block(Slot::Wood, under.slab(side, PANEL), 0.004);
            }
            modesty(builder, Slot::Painted, under, 0.42);
        }
        1 => {
            slanted_ends(builder, Slot::Wood, under, 0.026);
            pencil_drawers(builder, Slot::Wood, under, 2, HandleKind::Knob);
        }
        2 => {
            loops(builder, Slot::MetalDark, under, 0.04, 0.03);
            modesty(builder, Slot::Painted, under, 0.3);
        }
        _ => {
            for side in [Side::Left, Side::Right] {
                let column = under.slab(side, 0.06).without(Side::Above, 0.02);
                let foot = column.slab(Side::Below, 0.03);
                builder.block(Slot::Painted, foot, 0.008);
                let post =
                    column.inset(0.008, 0.0, column.depth() / 2.0 - 0.05).without(Side::Below, 0.03 - SINK);
                builder.block(Slot::Painted, post, 0.006);
                let arm = under.slab(side, 0.05).slab(Side::Above, 0.03).without(Side::Above, SINK * 2.0);
                builder.cuboid(Slot::Painted, arm.inset(0.004, 0.0, under.depth() * 0.08));
            }
            let beam = under.inset(0.03, 0.0, under.depth() / 2.0 - 0.03).slab(Side::Above, 0.035);
            builder.cuboid(Slot::Painted, beam.without(Side::Above, SINK * 4.0));
        }
    }
}

fn traditional(builder: &mut Builder, under: Bay, form: usize) {
    let slot = if form.is_multiple_of(2) { Slot::Wood } else { Slot::WoodDark };
    let kind = [LegKind::Turned, LegKind::Spade, LegKind::Baluster, LegKind::Square][form];
    for side in [Side::Left, Side::Right] {
        for end in [Side::Front, Side::Back] {
            leg(builder, slot, under.slab(side, 0.05).slab(end, 0.05), kind);
        }
        let share = if form == 3 { 0.88 } else { 0.2 };
        let board =
            under.slab(side, 0.04).slab(Side::Above, under.height() * share).without(Side::Above, SINK * 2.0);
        let board = board.inset(0.008, 0.0, 0.05 - SINK);
        builder.cuboid(slot, board);
        if form == 3 {
            side_fields(builder, slot, board, side);
        }
    }
    let back = modesty(builder, slot, under, if form == 3 { 0.45 } else { 0.2 });
    if form == 3 {
        for field in back.inset(0.05, 0.03, 0.0).columns(3, 0.06) {
            raised_panel(builder, slot, field.slab(Side::Front, 0.008).moved(0.0, 0.0, 0.0075));
        }
    }
    let kind = if form == 1 { HandleKind::Level } else { HandleKind::Knob };
    pencil_drawers(builder, slot, under, if form == 2 { 2 } else { 3 }, kind);
}

/// Two raised fields over each other on the outside of an end.
fn side_fields(builder: &mut Builder, slot: Slot, board: Bay, side: Side) {
    let face = board.inset(0.0, 0.03, 0.05).slab(side, 0.0);
    let x = if side == Side::Left { board.low.x } else { board.high.x };
    for row in face.rows(2, 0.05) {
        let field = row.with_x([x - 0.005, x + 0.005]);
        builder.block(slot, field, 0.012_f64.min(field.height() * 0.2));
    }
}

fn industrial(builder: &mut Builder, under: Bay, form: usize) {
    let slot = Slot::MetalDark;
    match form {
        0 => pipe_frames(builder, under),
        1 => crossed_loops(builder, under),
        2 => {
            trestles(builder, slot, under, 0.016, 4);
            builder.cuboid(
                slot,
                under
                    .inset(0.03, 0.0, 0.032)
                    .slab(Side::Above, 0.03)
                    .slab(Side::Back, 0.03)
                    .without(Side::Above, SINK * 3.0),
            );
        }
        _ => angles_with_planks(builder, under),
    }
}

/// Posts of angle with planks between them.
fn angles_with_planks(builder: &mut Builder, under: Bay) {
    let slot = Slot::MetalDark;
    for side in [Side::Left, Side::Right] {
        for end in [Side::Front, Side::Back] {
            leg(builder, slot, under.slab(side, 0.05).slab(end, 0.05), LegKind::Angle);
        }
        let panel = under.slab(side, 0.012).inset(0.0, 0.0, 0.03).with_y([0.12, under.high.y - 0.002]);
        for row in panel.moved(if side == Side::Left { 0.006 } else { -0.006 }, 0.0, 0.0).rows(4, 0.008) {
            builder.block(Slot::Wood, row, 0.003);
        }
    }
    modesty(builder, slot, under, 0.3);
    pencil_drawers(builder, slot, under, 2, HandleKind::Level);
}

/// Loops of steel with a cross of wire behind.
fn crossed_loops(builder: &mut Builder, under: Bay) {
    let slot = Slot::MetalDark;
    loops(builder, slot, under, 0.045, 0.045);
    let (x, z) = (under.high.x - 0.03, under.low.z + 0.022);
    let cross = |from: f64, to: f64| {
        [DVec3::new(from, under.high.y * 0.56, z), DVec3::new(to, under.high.y - 0.03, z)]
    };
    builder.add(Slot::Metal, sweep(&cross(-x, x), 0.006, 6));
    builder.add(Slot::Metal, sweep(&cross(x, -x), 0.0055, 6).moved(0.0, 0.0, 0.009));
}

/// Bent water pipe on flanges.
fn pipe_frames(builder: &mut Builder, under: Bay) {
    let slot = Slot::MetalDark;
    let x = under.high.x - 0.025;
    let (z, y) = (under.z(), under.high.y - 0.006);
    let path = [(0.014, 0), (y - 0.01, 0), (y - 0.01, 1), (0.014, 1)]
        .map(|(y, end)| DVec3::new(x, y, z[end] + [0.03, -0.03][end]));
    builder.add_pair(slot, pipe(&path, 0.017, 0.06));
    for z in [z[0] + 0.03, z[1] - 0.03] {
        let flange = crate::recipes::kit::cylinder(0.032, [0.0, 0.016], 10);
        builder.add_pair(Slot::Metal, flange.moved(x, 0.0, z));
    }
    for y in [y - 0.12, 0.16] {
        builder
            .add_pair(slot, sweep(&[DVec3::new(x, y, z[0] + 0.03), DVec3::new(x, y, z[1] - 0.03)], 0.012, 6));
    }
    let back = z[0] + 0.03;
    let y = under.high.y * 0.66;
    builder.add(slot, sweep(&[DVec3::new(-x, y, back), DVec3::new(x, y, back)], 0.012, 6));
}

/// Two leaning bars with a cross bar at either end, as an A seen from the side.
fn trestles(builder: &mut Builder, slot: Slot, under: Bay, radius: f64, sides: usize) {
    let x = under.high.x - 0.03;
    let middle = under.center().z;
    let spread = under.depth() / 2.0 - radius;
    for end in [-1.0, 1.0] {
        let foot = DVec3::new(x, 0.004, middle + end * spread);
        let head = DVec3::new(x, under.high.y - 0.02, middle + end * spread * 0.35);
        builder.add_pair(slot, sweep(&[foot, head], radius, sides));
    }
    let beam = Bay::new(
        [x - 0.026, x + 0.026],
        [under.high.y - 0.036, under.high.y - 0.002],
        [middle - spread * 0.6, middle + spread * 0.6],
    );
    builder.add_pair(slot, cuboid(beam));
    for (rise, share) in [(0.3, 0.8), (0.62, 0.6)] {
        let y = under.high.y * rise;
        let at = |end: f64| DVec3::new(x, y, middle + end * spread * share);
        builder.add_pair(slot, sweep(&[at(-1.0), at(1.0)], radius * 0.8, sides));
    }
    let pads = Bay::around(DVec3::new(x, 0.006, middle + spread - 0.004), 0.04, 0.012, radius * 2.0);
    for pad in [pads, pads.moved(0.0, 0.0, -2.0 * spread + 0.008)] {
        builder.add_pair(Slot::Rubber, cuboid(pad));
    }
}

fn budget(builder: &mut Builder, under: Bay, form: usize) {
    match form {
        0 => trestles(builder, Slot::WoodLight, under, 0.017, 4),
        1 => {
            for side in [Side::Left, Side::Right] {
                builder.cuboid(Slot::Laminate, under.slab(side, 0.018).without(Side::Below, 0.004));
                builder.cuboid(
                    Slot::PlasticDark,
                    under.slab(side, 0.016).inset(0.001, 0.0, 0.02).slab(Side::Below, 0.005),
                );
            }
            modesty(builder, Slot::Laminate, under, 0.4);
        }
        2 => {
            for side in [Side::Left, Side::Right] {
                let foot = under.slab(side, 0.05).slab(Side::Below, 0.03).inset(0.002, 0.0, 0.0);
                builder.block(Slot::Metal, foot, 0.008);
                let post = under.slab(side, 0.04).without(Side::Below, 0.03 - SINK).inset(0.004, 0.0, 0.0);
                let post = post.slab(Side::Back, under.depth() * 0.42).slab(Side::Front, 0.07);
                builder.cuboid(Slot::Metal, post);
                let arm = under.slab(side, 0.03).slab(Side::Above, 0.03).without(Side::Above, SINK * 2.0);
                builder.cuboid(Slot::Metal, arm.inset(0.001, 0.0, 0.06));
            }
            modesty(builder, Slot::Metal, under, 0.26);
        }
        _ => {
            for side in [Side::Left, Side::Right] {
                for end in [Side::Front, Side::Back] {
                    leg(builder, Slot::Painted, under.slab(side, 0.045).slab(end, 0.045), LegKind::Pipe);
                }
            }
            let rail = under.inset(0.02, 0.0, 0.02).slab(Side::Above, 0.02).without(Side::Above, SINK * 2.0);
            builder.cuboid(Slot::Painted, rail.slab(Side::Back, 0.02));
        }
    }
}
