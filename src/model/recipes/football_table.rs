//! Table football.

use glam::DVec3;

use super::input::{Draft, GeometrySet};
use super::parts::{LegKind, legs_at_corners, turned_forward};
use crate::catalog::Side;
use crate::model::kit::{Bay, Builder, Outline, SINK, Slice, cylinder, lathe, loft, sweep};

/// Table football: rods with figures and grips over a green field.
#[expect(clippy::too_many_lines, reason = "part after part of one piece")]
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
    let (field, low) = (bay.high.y - 0.16, bay.high.y - 0.3);
    let wall = 0.035;
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
    let floor = body.inset(wall, 0.0, wall - SINK * 2.0).with_y([low + 0.02, field]);
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
    legs_at_corners(
        builder,
        slot,
        body.with_y([0.0, low + SINK]).inset(0.03, 0.0, 0.012),
        0.07,
        if draft.is_traditional() { LegKind::Turned } else { LegKind::Square },
    );
    let rods = 8;
    for rod in 0..rods {
        let x = body.low.x + body.width() * (f64::from(rod) + 1.0) / f64::from(rods + 1);
        let y = field + 0.09;
        let is_near = rod % 2 == 0;
        let reach = [
            if is_near { bay.low.z + grips * 0.7 } else { bay.low.z + 0.02 },
            if is_near { bay.high.z - 0.02 } else { bay.high.z - grips * 0.7 },
        ];
        builder.add("chrome", sweep(&[DVec3::new(x, y, reach[0]), DVec3::new(x, y, reach[1])], 0.007, 4));
        let grip = turned_forward(cylinder(0.016, [0.0, grips * 0.8], 6));
        let at = if is_near { bay.high.z - grips * 0.8 } else { bay.low.z };
        builder.add("rubber", grip.moved(x, y, at));
        let figures = [1, 2, 3, 5, 5, 3, 2, 1][rod as usize];
        for figure in 0..figures {
            let z = floor.low.z + floor.depth() * (f64::from(figure) + 1.0) / (f64::from(figures) + 1.0);
            let team = if matches!(rod, 0 | 1 | 3 | 5) { "book" } else { "painted_accent" };
            let man = [
                Slice::new(y - 0.075, 0.01, 0.014),
                Slice::new(y - 0.06, 0.007, 0.012),
                Slice::new(y - 0.01, 0.012, 0.016),
                Slice::new(y + 0.028, 0.014, 0.022),
                Slice::new(y + 0.03, 0.008, 0.008),
                Slice::new(y + 0.052, 0.01, 0.01),
            ];
            builder.add(team, loft(&Outline::Square, &man).moved(x, 0.0, z));
        }
    }
}
