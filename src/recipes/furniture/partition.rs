//! Partitions: 1.2 to 1.6 m wide, 1.4 to 1.6 high, panels 0.03 to 0.05 thick, feet up to 0.4 deep where there is room.

use glam::DVec3;

use super::boards::{frame, inside};
use super::parts::{LegKind, ball, leg};
use crate::geometry::Side;
use crate::recipes::kit::{Axis, Bay, Builder, SINK, cylinder, extrude, pipe};
use crate::recipes::{Draft, Recipe, Slot};

/// A screen between desks: cloth in a frame; a folding screen with arched leaves; panes between bars of steel; cloth
/// laced into a bow of pipe.
pub(super) static PARTITION: Recipe = Recipe::furniture("partition", [1.6, 0.05, 1.6])
    .plain(padded)
    .traditional(folding)
    .industrial(|_, builder| glazed(builder))
    .budget(pipe_and_cloth);

/// Metres under a panel.
fn lift(bay: Bay) -> f64 {
    (bay.height() * 0.06).min(0.1)
}

/// Feet across the lower edge of a panel, at shares of the width, as deep as the box, with short posts.
fn feet(builder: &mut Builder, slot: Slot, thick: f64) {
    let (bay, lift) = (builder.bay(), lift(builder.bay()));
    for side in [Side::Left, Side::Right] {
        let foot = bay.inset(bay.width() * 0.08, 0.0, 0.0).slab(side, 0.05);
        builder.block(slot, foot.with_y([0.0, 0.02]), 0.004);
        let post = foot.inset(0.012, 0.0, 0.0).with_y([0.02 - SINK, lift + 0.012]);
        leg(builder, slot, post.with_z([-thick * 0.3, thick * 0.3]), LegKind::Square);
    }
}

/// Panels of cloth in a frame of aluminium, with a rail for shelves between upper and lower ones.
fn padded(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let thick = (bay.depth() * 0.6).min(0.04);
    let panel = bay.without(Side::Below, lift(bay)).with_z([-thick / 2.0, thick / 2.0]);
    let border = 0.03_f64.min(bay.width() * 0.05);
    builder.add(Slot::Metal, frame(panel, border));
    let count = (bay.width() / 0.8).round().clamp(1.0, 4.0) as u32;
    let cloth = inside(panel, border, [0.12, 0.88]);
    let slot = draft.sampler().pick(&[Slot::Fabric, Slot::FabricAccent, Slot::FabricLight]);
    let middle = cloth.low.y + cloth.height() * 0.52;
    let halves = [[cloth.low.y, middle - 0.012], [middle + 0.012, cloth.high.y]];
    for (index, y) in halves.into_iter().enumerate() {
        let slot = if index == 0 { slot } else { Slot::FabricLight };
        for column in cloth.with_y(y).columns(count, 0.008) {
            builder.block(slot, column, 0.004);
        }
    }
    builder.cuboid(Slot::Metal, cloth.with_y([middle - 0.011, middle + 0.011]).inset(0.0, 0.0, thick * 0.1));
    feet(builder, Slot::MetalDark, thick);
}

/// Three or four leaves in a shallow zigzag, each with an arched head, a turned knob on it, and cloth over a panel.
fn folding(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let count = (bay.width() / 0.42).round().clamp(2.0, 5.0) as u32;
    let slot = [Slot::WoodDark, Slot::Wood, Slot::WoodDark, Slot::WoodLight][draft.form()];
    let cloth = draft.sampler().pick(&[Slot::FabricAccent, Slot::FabricLight, Slot::Fabric]);
    let thick = (bay.depth() * 0.32).min(0.024);
    let pitch = bay.width() / f64::from(count);
    let angle = libm::asin(((bay.depth() - thick) / pitch).clamp(0.0, 0.9));
    let width = (pitch - thick * libm::sin(angle)) / libm::cos(angle) - 0.004;
    for index in 0..count {
        let turn = if index % 2 == 0 { angle } else { -angle };
        let x = bay.low.x + pitch * (f64::from(index) + 0.5);
        let mut leaf = builder.empty();
        leaf_of_screen(&mut leaf, [slot, cloth], width, thick);
        for (slot, solid) in leaf.into_parts() {
            builder.add(slot, solid.turned_y(turn).moved(x, 0.0, 0.0));
        }
    }
}

/// One leaf around the origin, as high as the box.
fn leaf_of_screen(builder: &mut Builder, [wood, cloth]: [Slot; 2], width: f64, thick: f64) {
    let high = builder.bay().high.y;
    let (half, z) = (width / 2.0, [-thick / 2.0, thick / 2.0]);
    let stile = (width * 0.12).min(0.045);
    let shoulder = high * 0.88;
    for side in [-1.0, 1.0] {
        let x = [side * half, side * (half - stile)];
        let post = Bay::new([x[0].min(x[1]), x[0].max(x[1])], [0.0, shoulder], z);
        builder.cuboid(wood, post);
    }
    // The head: an arch with a level underside.
    let mut arch: Vec<glam::DVec2> = (0..=8)
        .map(|step| {
            let share = f64::from(step) / 4.0 - 1.0;
            let rise = libm::sqrt((1.0 - share * share * 0.86).max(0.0));
            glam::DVec2::new(
                -share * (half - 0.001),
                shoulder - 0.05 + (high - 0.035 - shoulder + 0.05) * rise,
            )
        })
        .collect();
    arch.push(glam::DVec2::new(-half + 0.001, shoulder - 0.06));
    arch.push(glam::DVec2::new(half - 0.001, shoulder - 0.06));
    builder.add(wood, extrude(&arch, Axis::Z, z.map(|z| z * 0.9)));
    let knob = ball(0.022, 8).stretched(DVec3::new(0.8, 1.0, 0.5));
    builder.add(wood, knob.moved(0.0, high - 0.022, 0.0));
    let between = Bay::new([-half + stile - SINK, half - stile + SINK], [0.0, 0.0], z.map(|z| z * 0.8));
    for (low, tall) in [(0.09, 0.06), (0.36, 0.05)] {
        builder.cuboid(wood, between.with_y([high * low, high * low + tall]));
    }
    let panel = between.with_y([high * 0.09 + 0.05, high * 0.36 + 0.01]).inset(0.0, 0.0, thick * 0.2);
    builder.cuboid(wood, panel);
    let raised = panel.inset(width * 0.1, panel.height() * 0.16, -thick * 0.14);
    builder.cuboid(wood, raised);
    let field = between.with_y([high * 0.36 + 0.04, shoulder - 0.055]).inset(0.0, 0.0, thick * 0.15);
    builder.cuboid(cloth, field);
    for foot in [-1.0, 1.0] {
        let rod = cylinder(thick * 0.62, [0.004, 0.03], 6);
        builder.add(Slot::Brass, rod.moved(foot * (half - stile * 0.5), 0.0, 0.0));
    }
}

/// Panes between bars of steel over a sheet with a dent, on plates that are bolted down.
fn glazed(builder: &mut Builder) {
    let bay = builder.bay();
    let thick = (bay.depth() * 0.5).min(0.04);
    let panel = bay.without(Side::Below, 0.012).with_z([-thick / 2.0, thick / 2.0]);
    let border = 0.032;
    builder.add(Slot::MetalDark, frame(panel, border));
    let inner = inside(panel, border, [0.3, 0.7]);
    let sill = inner.low.y + inner.height() * 0.34;
    builder.cuboid(Slot::Metal, inner.with_y([inner.low.y, sill]));
    for brace in inner.with_y([inner.low.y, sill]).rows(4, 0.0).iter().skip(1) {
        let rib = brace.slab(Side::Below, 0.014).moved(0.0, -0.007, 0.0);
        builder.cuboid(Slot::Metal, rib.inset(0.02, 0.0, -0.006));
    }
    let glass = inner.with_y([sill, inner.high.y]);
    builder.cuboid(Slot::Glass, glass.inset(0.0, 0.0, thick * 0.12));
    let bar = 0.018;
    let columns = (bay.width() / 0.42).round().clamp(2.0, 6.0) as u32;
    for column in glass.columns(columns, 0.0).iter().skip(1) {
        let bar = column.slab(Side::Left, bar).moved(-bar / 2.0, 0.0, 0.0);
        builder.cuboid(Slot::MetalDark, bar.inset(0.0, -SINK, -0.004));
    }
    for row in glass.rows(3, 0.0) {
        let bar = row.slab(Side::Below, bar).moved(0.0, -0.002, 0.0);
        builder.cuboid(Slot::MetalDark, bar.inset(-SINK, 0.0, -0.003));
    }
    for side in [Side::Left, Side::Right] {
        let plate = bay.inset(bay.width() * 0.03, 0.0, 0.0).slab(side, 0.12);
        builder.cuboid(Slot::MetalDark, plate.with_y([0.0, 0.012 + SINK]));
        for z in [-1.0, 1.0] {
            let at = DVec3::new(plate.center().x, 0.0, z * (bay.high.z + thick / 2.0) / 2.0);
            let radius = (bay.high.z - thick / 2.0) * 0.4;
            builder.add(Slot::Metal, cylinder(radius, [0.012, 0.022], 6).moved(at.x, 0.0, at.z));
        }
        let gusset = plate.inset(0.05, 0.0, 0.0).with_y([0.012, 0.09]);
        builder.cuboid(Slot::MetalDark, gusset.with_z([-bay.high.z * 0.8, bay.high.z * 0.8]));
    }
}

/// A bow of pipe with round corners on two feet, and a cloth in it that is held by straps.
fn pipe_and_cloth(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let radius = 0.014;
    let (x, y) = (bay.high.x - radius, bay.high.y - radius);
    let at = |x: f64, y: f64| DVec3::new(x, y, 0.0);
    let bow = [at(-x, 0.016), at(-x, y), at(x, y), at(x, 0.016)];
    builder.add(Slot::Metal, pipe(&bow, radius, 0.12));
    let low = lift(bay) + 0.08;
    builder.add(Slot::Metal, pipe(&[at(-x, low), at(x, low)], radius * 0.8, 0.0));
    for side in [-1.0, 1.0] {
        let thick = radius * 0.96;
        let foot = [bay.low.z, bay.high.z].map(|z| DVec3::new(side * x, thick, z));
        builder.add(Slot::PlasticDark, pipe(&foot, thick, 0.0));
    }
    let cloth = Bay::new([-x + 0.05, x - 0.05], [low + 0.05, y - 0.05], [-0.004, 0.004]);
    let slot = draft.sampler().pick(&[Slot::FabricLight, Slot::Fabric, Slot::FabricAccent]);
    builder.cuboid(slot, cloth);
    let hem = |bay: Bay| bay.inset(0.0, 0.0, -0.002);
    for side in [Side::Above, Side::Below] {
        builder.cuboid(slot, hem(cloth.slab(side, 0.03).inset(0.002, 0.002, 0.0)));
    }
    let count = (bay.width() / 0.2).round().clamp(2.0, 12.0) as u32;
    for column in cloth.columns(count, 0.0) {
        for (end, pole) in [(cloth.high.y, y + radius * 1.1), (cloth.low.y, low - radius * 0.9)] {
            let ends = [end.min(pole) - 0.01, end.max(pole)];
            let ends = if pole > end { ends } else { [ends[0] + 0.01, ends[1] + 0.01] };
            let strap = Bay::around(column.center(), 0.024, 1.0, radius * 2.2);
            builder.cuboid(Slot::FabricLight, strap.with_y(ends));
        }
    }
}
