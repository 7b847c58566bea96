//! Copiers with something at their right side that sorts or staples.

use glam::DVec3;

use super::{Slots, Stretch, keys, slope};
use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::furniture::parts::Fittings;
use crate::recipes::kit::{Bay, Builder, SINK, cylinder, sweep};

/// Share of the width that the sorter takes.
const SORTER: f64 = 0.27;
/// Share of the width that the tower takes.
const TOWER: f64 = 0.36;

/// A machine with a lid over its glass on a cupboard with two doors, and a sorter with many bins.
pub(super) fn with_sorter(builder: &mut Builder, (shell, dark): Slots) {
    let bay = builder.bay();
    let height = bay.height();
    let body = bay.without(Side::Right, bay.width() * SORTER);
    let stand = body.with_y([0.05, height * 0.5]);
    for x in [body.low.x + 0.06, body.high.x - 0.06] {
        for z in [body.low.z + 0.07, body.high.z - 0.1] {
            builder.add(Slot::Rubber, cylinder(0.026, [0.0, 0.052], 10).moved(x, 0.0, z));
        }
    }
    let fittings = Fittings { front: Slot::Wood, handle: Slot::Brass, reach: 0.022, is_traditional: true };
    fittings.carcass(builder, Slot::Wood, stand);
    for (index, column) in stand.inset(0.006, 0.006, 0.0).columns(2, 0.005).into_iter().enumerate() {
        fittings.door(builder, column, if index == 0 { Side::Left } else { Side::Right }, 0.8);
    }
    let machine =
        body.with_y([height * 0.5 - SINK, height * 0.86]).inset(0.004, 0.0, 0.0).without(Side::Front, 0.03);
    builder.block(shell, machine, 0.02);
    let band =
        machine.inset(-0.003, 0.0, -0.003).with_y([height * 0.56, height * 0.6]).without(Side::Back, 0.006);
    builder.block(dark, band, 0.004);
    let panel = body.inset(0.02, 0.0, 0.0).slab(Side::Front, 0.11).with_y([height * 0.82, height * 0.87]);
    keys(builder, (shell, dark), panel);
    let cassette = machine.inset(0.08, 0.0, 0.0).with_y([height * 0.63, height * 0.72]);
    builder.block(dark, cassette.with_z([machine.high.z - SINK, machine.high.z + 0.012]), 0.004);
    let lid = machine
        .inset(0.02, 0.0, 0.02)
        .with_y([height * 0.86 - SINK, height * 0.93])
        .without(Side::Front, 0.07);
    builder.block(dark, lid, 0.014);
    let grip = lid.slab(Side::Front, 0.02).inset(lid.width() * 0.36, 0.012, 0.0).moved(0.0, 0.0, 0.015);
    builder.block(shell, grip, 0.004);
    let originals = lid.inset(0.08, 0.0, 0.08).with_y([lid.high.y - SINK, lid.high.y + 0.012]);
    builder.cuboid(Slot::Paper, originals);
    sorter(builder, (shell, dark), bay.with_x([body.high.x - 0.006, bay.high.x]));
}

/// Many narrow bins that lean outwards between two cheeks, some with sheets in them.
fn sorter(builder: &mut Builder, (shell, dark): Slots, bay: Bay) {
    let height = bay.height();
    let stack = bay.with_y([height * 0.42, height]).inset(0.0, 0.0, 0.05);
    builder.block(shell, stack.slab(Side::Left, 0.05).inset(0.0, 0.001, 0.002), 0.006);
    for side in [Side::Front, Side::Back] {
        builder.block(
            shell,
            stack.slab(side, 0.018).without(Side::Right, 0.05).without(Side::Left, 0.02),
            0.005,
        );
    }
    let count = 10;
    let pitch = (stack.height() - 0.07) / f64::from(count);
    let z = [stack.low.z + 0.024, stack.high.z - 0.024];
    for bin in 0..count {
        let low = stack.low.y + 0.012 + pitch * f64::from(bin);
        let ends = [(stack.low.x + 0.04, low), (bay.high.x, low + 0.035)];
        slope(builder, dark, ends, Stretch { thickness: 0.004, z });
        if bin % 3 != 1 {
            let sheet = [(ends[0].0 + 0.02, ends[0].1 + 0.009), (ends[1].0 - 0.012, ends[1].1 + 0.003)];
            slope(builder, Slot::Paper, sheet, Stretch { thickness: 0.006, z: [z[0] + 0.03, z[1] - 0.03] });
        }
    }
}

/// A tall body with paper drawers, a feeder and a screen on an arm; beside it a tower with a slot, two trays and a
/// door.
pub(super) fn with_tower(builder: &mut Builder, (shell, dark): Slots) {
    let bay = builder.bay();
    let height = bay.height();
    let body = bay.without(Side::Right, bay.width() * TOWER);
    builder.cuboid(Slot::Rubber, body.with_y([0.0, 0.03]).inset(0.03, 0.0, 0.05));
    let lower = body.with_y([0.03 - SINK, height * 0.52]).without(Side::Front, 0.02);
    builder.block(shell, lower, 0.008);
    let rows = lower.inset(0.014, 0.02, 0.0).rows(3, 0.012);
    for (index, row) in rows.into_iter().enumerate() {
        let drawer = row.with_z([lower.high.z - SINK, lower.high.z + 0.01]);
        builder.block(if index == 2 { dark } else { shell }, drawer, 0.004);
        let grip = drawer.slab(Side::Above, 0.024).inset(drawer.width() * 0.2, 0.004, 0.0);
        builder.cuboid(Slot::Metal, grip.with_z([drawer.high.z - SINK, bay.high.z - 0.001]));
    }
    let upper =
        body.with_y([height * 0.52 - SINK, height * 0.84]).without(Side::Front, 0.012).inset(0.0, 0.0, 0.002);
    builder.block(shell, upper, 0.016);
    builder.cuboid(dark, upper.inset(0.03, 0.1, 0.0).with_z([upper.high.z - SINK, upper.high.z + 0.006]));
    let feeder = upper.inset(0.02, 0.0, 0.03).with_y([height * 0.84 - SINK, height * 0.9]);
    builder.block(dark, feeder, 0.012);
    let ends = [(feeder.low.x + 0.13, height * 0.89), (feeder.high.x, height * 0.95)];
    slope(builder, shell, ends, Stretch { thickness: 0.01, z: [feeder.low.z + 0.06, feeder.high.z - 0.1] });
    slope(
        builder,
        Slot::Paper,
        ends.map(|(x, y)| (x - 0.012, y + 0.008)),
        Stretch { thickness: 0.008, z: [feeder.low.z + 0.1, feeder.high.z - 0.14] },
    );
    builder.block(
        shell,
        feeder.slab(Side::Left, 0.15).with_y([height * 0.9 - SINK, height * 0.955]).inset(0.0, 0.0, 0.03),
        0.012,
    );
    screen_on_arm(builder, dark, body);
    tower(builder, (shell, dark), bay.with_x([body.high.x - 0.004, bay.high.x]));
}

/// A screen on a bent arm over the left front corner.
fn screen_on_arm(builder: &mut Builder, dark: Slot, body: Bay) {
    let height = builder.bay().height();
    let foot = DVec3::new(body.low.x + 0.06, height * 0.83, body.high.z - 0.06);
    let head = DVec3::new(foot.x, height - 0.09, body.high.z - 0.025);
    builder.add(Slot::MetalDark, sweep(&[foot, head], 0.012, 6));
    let screen = Bay::around(head + DVec3::new(0.06, 0.03, 0.008), 0.24, 0.12, 0.02);
    builder.block(dark, screen, 0.005);
    builder.cuboid(
        Slot::Lamp,
        screen.inset(0.014, 0.014, 0.0).with_z([screen.high.z - SINK, screen.high.z + 0.001]),
    );
    builder.cuboid(
        dark,
        Bay::new(
            [foot.x - 0.01, foot.x + 0.01],
            [screen.high.y - 0.01, height - 0.001],
            [head.z - 0.004, head.z + 0.01],
        ),
    );
}

/// A tower that takes sheets from the left, staples them and lays them on trays at its right.
fn tower(builder: &mut Builder, (shell, dark): Slots, bay: Bay) {
    let height = bay.height();
    let case =
        bay.with_y([0.02, height * 0.8]).without(Side::Right, bay.width() * 0.42).inset(0.0, 0.0, 0.03);
    builder.block(shell, case, 0.012);
    builder.cuboid(Slot::Rubber, case.with_y([0.0, 0.03]).inset(0.012, 0.0, 0.04));
    let door = case.inset(0.014, 0.03, 0.0).with_z([case.high.z - SINK, case.high.z + 0.006]);
    builder.cuboid(shell, door.slab(Side::Below, case.height() * 0.46));
    builder.cuboid(dark, door.slab(Side::Above, case.height() * 0.3));
    for (index, rise) in [0.3, 0.52, 0.68].into_iter().enumerate() {
        let y = height * rise;
        let ends = [(case.high.x - 0.006, y), (bay.high.x - 0.004 * index as f64, y + 0.05)];
        slope(builder, dark, ends, Stretch { thickness: 0.012, z: [case.low.z + 0.04, case.high.z - 0.04] });
        let sheet = [(ends[0].0 + 0.01, ends[0].1 + 0.012), (ends[1].0 - 0.02, ends[1].1 + 0.008)];
        slope(
            builder,
            Slot::Paper,
            sheet,
            Stretch { thickness: 0.012 + 0.006 * index as f64, z: [case.low.z + 0.08, case.high.z - 0.08] },
        );
    }
}
