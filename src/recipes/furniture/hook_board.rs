//! Boards with hooks for coats on a wall: hooks 0.12 to 0.20 m apart, 0.06 to 0.12 m deep.

use glam::{DVec2, DVec3};

use super::parts::{slab_top, turned_forward};
use crate::geometry::Side;
use crate::recipes::kit::{Axis, Bay, Builder, SINK, cuboid, extrude, lathe, pipe, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// Metres from hook to hook.
const SPACING: f64 = 0.15;
/// Metres of a board.
const BOARD: f64 = 0.02;

/// Hooks in a row: pegs on a board, brass under a shelf, a pipe on a plank, or plastic on a strip.
pub(super) static HOOK_BOARD: Recipe =
    Recipe::furniture("hook_board", [0.9, 0.14, 0.3]).every_set(hook_board);

fn hook_board(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let form = draft.form();
    let count = (bay.width() / SPACING).round().clamp(2.0, 10.0) as u32;
    let columns = bay.inset(bay.width() * 0.04, 0.0, 0.0).columns(count, 0.0);
    let hooks: Vec<f64> = columns.iter().map(|column| column.center().x).collect();
    match draft.set() {
        GeometrySet::Plain => plain(builder, bay, &hooks, form),
        GeometrySet::Traditional => traditional(builder, bay, &hooks, form),
        GeometrySet::Industrial => industrial(builder, bay, &hooks, form),
        GeometrySet::Budget => budget(builder, bay, &hooks, form),
    }
}

/// A point at shares of a box's height and depth.
fn at(bay: Bay, x: f64, rise: f64, forward: f64) -> DVec3 {
    DVec3::new(x, bay.low.y + bay.height() * rise, bay.low.z + bay.depth() * forward)
}

/// Slanted pegs in two rows, flat tongues that fold out, or slats with knobs.
fn plain(builder: &mut Builder, bay: Bay, hooks: &[f64], form: usize) {
    let slot = [Slot::Wood, Slot::Painted, Slot::WoodLight, Slot::WoodDark][form];
    match form {
        2 => {
            for slat in bay.slab(Side::Back, BOARD).rows(4, bay.height() * 0.06) {
                builder.cuboid(slot, slat);
            }
        }
        _ => builder.block(slot, bay.slab(Side::Back, BOARD), 0.004),
    }
    for (index, &x) in hooks.iter().enumerate() {
        let rise = if index.is_multiple_of(2) { 0.28 } else { 0.62 };
        if form == 1 || form == 3 {
            let tongue = Bay::around(at(bay, x, 0.4, 0.0), 0.022, bay.height() * 0.5, 0.008);
            let tongue = tongue.moved(0.0, 0.0, BOARD + 0.003);
            builder.cuboid(Slot::MetalDark, tongue);
            let lip =
                Bay::new(tongue.x(), [tongue.low.y, tongue.low.y + 0.01], [tongue.high.z - SINK, bay.high.z]);
            builder.cuboid(Slot::MetalDark, lip.inset(0.0006, 0.0, 0.0).moved(0.0, 0.0006, -0.001));
            let end = Bay::new(lip.x(), [lip.low.y, lip.low.y + 0.035], [bay.high.z - 0.008, bay.high.z]);
            builder.cuboid(Slot::MetalDark, end);
        } else {
            let path = [at(bay, x, rise, 0.1), at(bay, x, rise + 0.12, 1.0) - DVec3::Z * 0.006];
            builder.add(Slot::Wood, sweep(&path, 0.012, 8));
        }
    }
}

/// Double hooks of brass on a moulded board, under a shelf on brackets in some.
fn traditional(builder: &mut Builder, bay: Bay, hooks: &[f64], form: usize) {
    let slot = [Slot::Wood, Slot::WoodDark, Slot::Painted, Slot::Wood][form];
    let has_shelf = form % 2 == 1;
    let shelf = 0.02_f64.min(bay.height() * 0.1);
    let wall = if has_shelf { bay.without(Side::Above, shelf - SINK) } else { bay };
    let board = wall.inset(if has_shelf { 0.02 } else { 0.0 }, 0.0, 0.0).slab(Side::Back, BOARD);
    builder.block(
        slot,
        board.without(Side::Above, wall.height() * if has_shelf { 0.0 } else { 0.12 }),
        0.006,
    );
    if has_shelf {
        slab_top(builder, slot, bay.slab(Side::Above, shelf), true);
        let (back, y) = (board.high.z - SINK, wall.high.y - SINK * 0.4);
        let deep = bay.depth() * 0.72;
        let bracket = [
            (back, y),
            (back, y - wall.height() * 0.6),
            (back + deep * 0.3, y - wall.height() * 0.3),
            (back + deep, y),
        ];
        let x = board.high.x - 0.03;
        builder.add_pair(slot, extrude(&bracket.map(DVec2::from), Axis::X, [x - 0.018, x]));
    } else {
        slab_top(
            builder,
            slot,
            bay.slab(Side::Above, wall.height() * 0.125).slab(Side::Back, BOARD * 2.0),
            true,
        );
    }
    let tip = if has_shelf { 0.86 } else { 1.0 };
    for &x in hooks {
        let plate = Bay::around(at(bay, x, 0.42, 0.0), 0.022, bay.height() * 0.4, 0.006);
        builder.cuboid(Slot::Brass, plate.moved(0.0, 0.0, BOARD + 0.002));
        let lower =
            [at(bay, x, 0.34, 0.14), at(bay, x, 0.16, 0.3), at(bay, x, 0.2, 0.55), at(bay, x, 0.36, 0.6)];
        builder.add(Slot::Brass, sweep(&lower, 0.006, 5));
        let upper = [at(bay, x, 0.52, 0.14), at(bay, x, 0.56, 0.5), at(bay, x, 0.72, tip) - DVec3::Z * 0.014];
        builder.add(Slot::Brass, sweep(&upper, 0.007, 5));
        let ball = lathe(&[(0.006, -0.012), (0.014, 0.0), (0.006, 0.012)], 6);
        let end = upper[2];
        builder.add(Slot::Ceramic, ball.moved(end.x, end.y, end.z));
    }
}

/// A pipe between flanges on a plank with bent hooks, or nails of rail in a beam.
fn industrial(builder: &mut Builder, bay: Bay, hooks: &[f64], form: usize) {
    let plank = bay.slab(Side::Back, BOARD * 1.6);
    for board in plank.rows(if form.is_multiple_of(2) { 1 } else { 2 }, 0.006) {
        builder.block(if form == 2 { Slot::MetalDark } else { Slot::Wood }, board, 0.005);
    }
    let tube = 0.0125;
    if form.is_multiple_of(2) {
        let (y, out) = (0.68, 1.0);
        let x = bay.high.x - 0.05;
        let front = DVec3::Z * tube;
        let path = [
            at(bay, -x, y, 0.1),
            at(bay, -x, y, out) - front,
            at(bay, x, y, out) - front,
            at(bay, x, y, 0.1),
        ];
        builder.add(Slot::MetalDark, pipe(&path, tube, 0.03));
        for x in [-x, x] {
            let flange = turned_forward(lathe(&[(0.032, 0.0), (0.032, 0.006), (0.02, 0.012)], 8));
            let foot = at(bay, x, y, 0.0);
            builder.add(Slot::MetalDark, flange.moved(foot.x, foot.y, plank.high.z - SINK));
        }
        for &x in hooks.iter().skip(usize::from(hooks.len() > 2)).take(hooks.len().saturating_sub(2).max(2)) {
            let top = at(bay, x, y, out) - front;
            let hook = [
                top + DVec3::new(0.0, tube + 0.003, -0.012),
                top + DVec3::new(0.0, tube + 0.003, 0.0),
                top + DVec3::new(0.0, -bay.height() * 0.4, -0.004),
                top + DVec3::new(0.0, -bay.height() * 0.44, -0.03),
                top + DVec3::new(0.0, -bay.height() * 0.3, -0.042),
            ];
            builder.add(Slot::Metal, sweep(&hook, 0.004, 5));
        }
        return;
    }
    for &x in hooks {
        let spike = [at(bay, x, 0.38, 0.2), at(bay, x, 0.34, 0.85), at(bay, x, 0.52, 1.0) - DVec3::Z * 0.009];
        builder.add(if form == 1 { Slot::MetalDark } else { Slot::Metal }, sweep(&spike, 0.009, 4));
        let plate = Bay::around(at(bay, x, 0.4, 0.0) + DVec3::Z * (BOARD * 1.6 + 0.002), 0.04, 0.05, 0.006);
        builder.cuboid(Slot::MetalDark, plate);
    }
}

/// Small hooks on a thin strip, or bent from one wire.
fn budget(builder: &mut Builder, bay: Bay, hooks: &[f64], form: usize) {
    let strip = bay.slab(Side::Back, 0.012);
    let (slot, tip) = [
        (Slot::Laminate, Slot::PlasticDark),
        (Slot::Metal, Slot::Plastic),
        (Slot::WoodLight, Slot::PaintedAccent),
        (Slot::Plastic, Slot::PlasticDark),
    ][form];
    if form == 1 {
        for side in [Side::Below, Side::Above] {
            builder.cuboid(slot, strip.slab(side, 0.009));
        }
        for &x in hooks {
            builder.cuboid(
                slot,
                Bay::new(
                    [x - 0.004, x + 0.004],
                    [0.008, bay.high.y - 0.008],
                    strip.inset(0.0, 0.0, 0.001).z(),
                ),
            );
        }
    } else {
        builder.cuboid(slot, strip);
    }
    for &x in hooks {
        let foot = at(bay, x, 0.3, 0.0) + DVec3::Z * 0.008;
        let path = [foot, at(bay, x, 0.22, 0.6), at(bay, x, 0.5, 1.0) - DVec3::Z * 0.011];
        builder.add(if form == 1 { Slot::Metal } else { tip }, sweep(&path, 0.006, 5));
        let end = path[2];
        let ball = Bay::around(end, 0.02, 0.02, 0.02);
        builder.add(tip, cuboid(ball));
    }
}
