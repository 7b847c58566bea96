//! What hangs on walls and divides rooms.

use std::f64::consts::FRAC_1_SQRT_2;

use glam::DVec3;

use super::input::Draft;
use super::parts::{LegKind, leg, turned_forward};
use crate::catalog::Side;
use crate::model::kit::{Bay, Builder, Outline, SINK, Slice, Solid, lathe, loft, loft_ring, sweep};

/// A frame around a bay that hangs on a wall, `border` wide; deeper than what it holds.
fn frame(bay: Bay, border: f64) -> Solid {
    let half = bay.extent() / 2.0;
    let slice = |z: f64, back: f64| Slice::new(z, half.x - back, half.y - back);
    let slices =
        [slice(bay.low.z, 0.0), slice(bay.high.z, 0.0), slice(bay.high.z, border), slice(bay.low.z, border)];
    turned_forward(loft_ring(&Outline::Square, &slices)).moved(0.0, bay.center().y, 0.0)
}

/// The inside of a frame: between shares of its depth.
fn inside(bay: Bay, border: f64, [low, high]: [f64; 2]) -> Bay {
    let z = |share: f64| bay.low.z + share * bay.depth();
    bay.inset(border - SINK, border - SINK, 0.0).with_z([z(low), z(high)])
}

/// A board to write on, with a tray and pens.
pub(super) fn whiteboard(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let board = bay.without(Side::Below, 0.02).slab(Side::Back, bay.depth() * 0.35);
    let border = 0.02_f64.min(bay.width() * 0.05);
    builder.add("metal", frame(board, border));
    builder.cuboid("ceramic", inside(board, border, [0.1, 0.7]));
    let tray = bay.slab(Side::Below, 0.022).inset(bay.width() * 0.2, 0.0, 0.0);
    builder.cuboid("metal", tray.slab(Side::Below, 0.008));
    builder.cuboid(
        "metal",
        tray.slab(Side::Front, 0.006).without(Side::Below, 0.008 - SINK).inset(0.001, 0.0, 0.001),
    );
    let mut sampler = draft.sampler();
    for (index, slot) in ["book", "painted_accent", "plastic_dark"].into_iter().enumerate() {
        let x = bay.width() * (0.03 + 0.07 * index as f64) * if sampler.chance(0.5) { 1.0 } else { -1.0 };
        let z = bay.high.z - bay.depth() * 0.3;
        builder
            .add(slot, sweep(&[DVec3::new(x, 0.0155, z), DVec3::new(x + 0.1, 0.0155, z + 0.004)], 0.008, 6));
    }
}

/// A board with notes pinned to it.
pub(super) fn notice_board(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let border = (bay.width().min(bay.height()) * 0.05).min(0.03);
    builder.add("wood", frame(bay, border));
    let cork = inside(bay, border, [0.1, 0.6]);
    builder.cuboid("terracotta", cork);
    let columns = (bay.width() / 0.28).round().clamp(1.0, 6.0) as u32;
    let rows = (bay.height() / 0.36).round().clamp(1.0, 3.0) as u32;
    for row in cork.inset(0.03, 0.03, 0.0).rows(rows, 0.03) {
        for column in row.columns(columns, 0.03) {
            if sampler.chance(0.75) {
                let note = column.inset(
                    column.width() * sampler.between(0.02, 0.2),
                    column.height() * sampler.between(0.02, 0.2),
                    0.0,
                );
                let slot = sampler.pick(&["paper", "paper", "fabric_light", "painted_accent"]);
                builder.cuboid(slot, note.with_z([cork.high.z - SINK, cork.high.z + 0.002]));
            }
        }
    }
}

/// A screen between desks: fabric in a frame on two feet.
pub(super) fn partition(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let lift = (bay.height() * 0.06).min(0.1);
    let thick = (bay.depth() * 0.6).min(0.04);
    let panel = bay.without(Side::Below, lift).with_z([-thick / 2.0, thick / 2.0]);
    let border = 0.03_f64.min(bay.width() * 0.05);
    builder.add("metal", frame(panel, border));
    let count = (bay.width() / 0.8).round().clamp(1.0, 4.0) as u32;
    let cloth = inside(panel, border, [0.15, 0.85]);
    let slot = draft.sampler().pick(&["fabric", "fabric_accent", "fabric_light"]);
    for column in cloth.columns(count, 0.006) {
        builder.cuboid(slot, column);
    }
    for side in [Side::Left, Side::Right] {
        let foot = bay.inset(bay.width() * 0.08, 0.0, 0.0).slab(side, 0.05);
        builder.block("metal_dark", foot.with_y([0.0, 0.02]), 0.004);
        let post = foot
            .inset(0.012, 0.0, 0.0)
            .with_y([0.02 - SINK, lift + 0.012])
            .with_z([-thick * 0.3, thick * 0.3]);
        leg(builder, "metal_dark", post, LegKind::Square);
    }
}

/// A fire extinguisher on its bracket.
pub(super) fn fire_extinguisher(_draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let height = bay.height();
    let radius = bay.width().min(bay.depth()) * 0.42;
    let z = bay.high.z - radius;
    let body = [
        (radius * 0.92, 0.0),
        (radius, height * 0.04),
        (radius, height * 0.66),
        (radius * 0.75, height * 0.76),
        (radius * 0.25, height * 0.82),
        (radius * 0.25, height * 0.86),
    ];
    builder.add("book", lathe(&body, 12).moved(0.0, 0.0, z));
    let label = Slice::round(height * 0.3, radius * 1.004);
    builder.add(
        "paper",
        loft(&Outline::Round(12), &[label, Slice { y: height * 0.5, ..label }])
            .moved(0.0, 0.0, z)
            .stretched(DVec3::new(1.0, 1.0, 1.0)),
    );
    let head = Bay::around(DVec3::new(0.0, height * 0.88, z), radius * 0.5, height * 0.06, radius * 0.5);
    builder.cuboid("metal", head);
    for (low, high) in [(0.9, 0.93), (0.96, 1.0)] {
        let grip = Bay::new(
            [-radius * 0.2, radius * 0.9],
            [height * low, height * high],
            [z - radius * 0.15, z + radius * 0.15],
        );
        builder.cuboid("plastic_dark", grip);
    }
    builder.cuboid(
        "plastic_dark",
        Bay::new(
            [-radius * 0.19, radius * 0.05],
            [height * 0.9 + SINK, height * 0.99],
            [z - radius * 0.1, z + radius * 0.1],
        ),
    );
    let at = |x: f64, y: f64| DVec3::new(x, height * y, z);
    let left = bay.low.x + radius * 0.1;
    let hose = [at(-radius * 0.1, 0.88), at(left, 0.84), at(left, 0.4), at(left + radius * 0.02, 0.22)];
    builder.add("rubber", sweep(&hose, radius * 0.1, 6));
    let bracket =
        Bay::new([-radius * 0.5, radius * 0.5], [height * 0.45, height * 0.6], [bay.low.z, z - radius * 0.5]);
    builder.cuboid("metal_dark", bracket);
    // The nozzle hangs on the left; the box is as wide on the right.
    builder.cuboid(
        "metal",
        Bay::new([radius * 0.2, bay.high.x], [height * 0.868, height * 0.89], [z - 0.006, z + 0.006]),
    );
}

/// A stand with umbrellas.
pub(super) fn umbrella_stand(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let radius = bay.width() / 2.0;
    let rim = bay.height() * 0.72;
    let wall = radius * 0.06;
    let pot = [
        (radius * 0.85, 0.0),
        (radius * 0.9, rim * 0.9),
        (radius, rim * 0.92),
        (radius, rim),
        (radius - wall * 2.0, rim),
        (radius * 0.8, 0.02),
    ];
    builder.add(sampler.pick(&["metal_dark", "ceramic", "brass"]), lathe(&pot, 12));
    for (index, slot) in ["fabric", "fabric_accent"].into_iter().enumerate() {
        let turn = sampler.between(0.0, 6.0);
        let (sine, cosine) = libm::sincos(turn);
        let lean = radius * 0.5;
        let foot = DVec3::new(-cosine * lean, 0.03, -sine * lean) * 0.6;
        let top = DVec3::new(cosine * lean, bay.high.y - if index == 0 { 0.01 } else { 0.05 }, sine * lean);
        let along = |share: f64| foot.lerp(top, share);
        builder.add(slot, sweep(&[along(0.05), along(0.86)], radius * 0.16, 6));
        let hook = along(0.99) + DVec3::new(sine, 0.0, -cosine) * radius * 0.3;
        builder.add(
            "wood_dark",
            sweep(&[along(0.85), along(0.99), hook, hook - DVec3::Y * radius * 0.25], 0.009, 6),
        );
    }
}

/// A folding stand for suitcases: crossed legs and straps.
pub(super) fn luggage_rack(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let slot = draft.sampler().pick(&["wood_dark", "wood", "metal"]);
    let thick = 0.026;
    let half = thick * FRAC_1_SQRT_2;
    let top = bay.high.y - thick;
    let (near, far) = (bay.high.z - half, bay.low.z + half);
    for (index, (foot, head)) in [(near, far), (far, near)].into_iter().enumerate() {
        let x = bay.high.x - thick * (0.5 + 1.1 * index as f64);
        let bar = sweep(&[DVec3::new(x, 0.0, foot), DVec3::new(x, top, head)], half, 4);
        builder.add_pair(slot, bar);
        let rail = Bay::new(
            [-bay.high.x, bay.high.x],
            [top - thick * 0.5, bay.high.y - 0.004],
            [head - half, head + half],
        );
        builder.cuboid(slot, rail.inset(0.001, 0.0, 0.0));
        let stretcher = Bay::around(
            DVec3::new(0.0, top * 0.16, foot + (head - foot) * 0.16),
            (x - thick * 0.4) * 2.0,
            0.018,
            0.018,
        );
        builder.cuboid(slot, stretcher);
    }
    let straps = bay.inset(bay.width() * 0.1, 0.0, 0.0).with_y([bay.high.y - 0.006, bay.high.y]);
    for strap in straps.columns(4, bay.width() * 0.12) {
        builder.cuboid("leather", strap.inset(0.0, 0.0, 0.004));
    }
}
