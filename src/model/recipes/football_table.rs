//! Table football.

use glam::DVec3;

use super::input::{Draft, GeometrySet};
use super::parts::{LegKind, legs_at_corners, turned_forward};
use crate::catalog::Side;
use crate::model::kit::{Bay, Builder, Outline, SINK, Slice, Solid, cylinder, lathe, loft, sweep};

/// Metres of the side boards.
const WALL: f64 = 0.035;
/// Metres of the field under the rim.
const SUNK: f64 = 0.16;
/// Metres of the body's height.
const BODY: f64 = 0.3;
/// Figures on each rod, from one goal to the other; each team has four rods.
const FIGURES: [u32; 8] = [1, 2, 3, 5, 5, 3, 2, 1];

/// Table football: rods with figures and grips over a green field.
pub(super) fn football_table(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let look = draft.input.look as usize % 4;
    let slot = match draft.set() {
        GeometrySet::Industrial => ["metal_dark", "wood_dark", "metal", "wood"],
        GeometrySet::Budget => ["laminate", "wood_light", "plastic_dark", "painted_accent"],
        _ => ["wood_dark", "wood", "painted", "wood_light"],
    }[look];
    // The rods stick out to the players, along z.
    let grips = (bay.depth() * 0.16).min(0.12);
    let body = bay.inset(0.0, 0.0, grips);
    let (field, low) = (bay.high.y - SUNK, bay.high.y - BODY);
    boards(builder, slot, body, [low, field]);
    let floor = body.inset(WALL, 0.0, WALL - SINK * 2.0).with_y([low + 0.02, field]);
    markings(builder, floor);
    legs_at_corners(
        builder,
        slot,
        body.with_y([0.0, low + SINK]).inset(0.03, 0.0, 0.012),
        0.07,
        if draft.is_traditional() { LegKind::Turned } else { LegKind::Square },
    );
    for rod in 0..FIGURES.len() {
        let x = body.low.x + body.width() * (rod as f64 + 1.0) / (FIGURES.len() as f64 + 1.0);
        self::rod(builder, floor, (rod, x, grips));
    }
}

/// Boards around the field, with goals in the short ones.
fn boards(builder: &mut Builder, slot: &'static str, body: Bay, [low, field]: [f64; 2]) {
    let (bay, wall) = (builder.bay(), WALL);
    for side in [Side::Front, Side::Back] {
        builder.block(slot, body.slab(side, wall).with_y([low, bay.high.y]), 0.004);
    }
    for side in [Side::Left, Side::Right] {
        let end = body
            .slab(side, wall * 1.6)
            .inset(0.0, 0.0, wall - SINK)
            .with_y([low + 0.001, bay.high.y - 0.001]);
        builder.cuboid(slot, end);
        let goal = end.inset(0.0, 0.0, end.depth() * 0.34).with_y([field - 0.002, field + 0.07]);
        let inner = if side == Side::Left {
            goal.slab(Side::Right, 0.002).moved(0.0012, 0.0, 0.0)
        } else {
            goal.slab(Side::Left, 0.002).moved(-0.0012, 0.0, 0.0)
        };
        builder.cuboid("plastic_dark", inner);
    }
}

/// The green field, its middle line and circle.
fn markings(builder: &mut Builder, floor: Bay) {
    let field = floor.high.y;
    builder.cuboid("leaf", floor);
    builder.cuboid(
        "linen",
        Bay::new([-0.004, 0.004], [field - SINK, field + 0.0008], floor.inset(0.0, 0.0, 0.01).z()),
    );
    let ring = lathe(
        &[(0.09, field - SINK), (0.09, field + 0.0012), (0.082, field + 0.0012), (0.08, field - SINK * 0.4)],
        12,
    );
    builder.add("linen", ring);
}

/// A rod with its grip and its figures: the number of the rod, its place along the table, the length that sticks out.
fn rod(builder: &mut Builder, floor: Bay, (rod, x, grips): (usize, f64, f64)) {
    let bay = builder.bay();
    let y = floor.high.y + 0.09;
    let is_near = rod.is_multiple_of(2);
    let reach = [
        if is_near { bay.low.z + grips * 0.7 } else { bay.low.z + 0.02 },
        if is_near { bay.high.z - 0.02 } else { bay.high.z - grips * 0.7 },
    ];
    builder.add("chrome", sweep(&[DVec3::new(x, y, reach[0]), DVec3::new(x, y, reach[1])], 0.007, 4));
    let grip = turned_forward(cylinder(0.016, [0.0, grips * 0.8], 6));
    let at = if is_near { bay.high.z - grips * 0.8 } else { bay.low.z };
    builder.add("rubber", grip.moved(x, y, at));
    let team = if matches!(rod, 0 | 1 | 3 | 5) { "book" } else { "painted_accent" };
    for figure in 0..FIGURES[rod] {
        let z = floor.low.z + floor.depth() * (f64::from(figure) + 1.0) / (f64::from(FIGURES[rod]) + 1.0);
        builder.add(team, figure_at(y).moved(x, 0.0, z));
    }
}

/// A figure on a rod at a height: feet, body, shoulders, head.
fn figure_at(y: f64) -> Solid {
    let man = [
        Slice::new(y - 0.075, 0.01, 0.014),
        Slice::new(y - 0.06, 0.007, 0.012),
        Slice::new(y - 0.01, 0.012, 0.016),
        Slice::new(y + 0.028, 0.014, 0.022),
        Slice::new(y + 0.03, 0.008, 0.008),
        Slice::new(y + 0.052, 0.01, 0.01),
    ];
    loft(&Outline::Square, &man)
}
