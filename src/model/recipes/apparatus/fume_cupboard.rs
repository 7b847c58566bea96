//! Fume cupboards: 1.2 to 1.5 m wide, 0.8 deep, benches 0.9 high, 2.2 to 2.7 m over all (EN 14175).

use glam::DVec3;

use crate::catalog::Side;
use crate::model::kit::{Bay, Builder, SINK, lathe};
use crate::model::recipes::input::Draft;
use crate::model::recipes::parts::{Fittings, HandleKind, handle, turned_forward};

/// Share of the height at which one works.
const BENCH: f64 = 0.4;
/// Metres of the stone top.
const TOP: f64 = 0.03;
/// Metres of the plinth under the cupboards.
const PLINTH: f64 = 0.08;
/// Metres of a hollow wall beside the chamber.
const SIDE_WALL: f64 = 0.09;
/// Metres of the chamber's back.
const BACK_WALL: f64 = 0.03;
/// Metres of the duct over the chamber.
const HEAD: f64 = 0.12;
/// Metres of the hood that hangs from the duct.
const HOOD: f64 = 0.32;

/// A fume cupboard: a bench under a chamber with a sliding pane, a duct and service valves.
pub(in super::super) fn fume_cupboard(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let look = draft.input.look as usize % 4;
    let slot = ["painted", "metal", "laminate", "painted"][look];
    let bench = bay.height() * BENCH;
    cupboards(builder, (slot, ["painted_accent", "laminate", "painted", "metal"][look]), bench);
    builder.block("stone", bay.with_y([bench - TOP - SINK, bench]), 0.004);
    let upper = bay.with_y([bench - SINK, bay.high.y]).inset(0.001, 0.0, 0.001).without(Side::Front, 0.05);
    let hood = chamber(builder, slot, upper);
    // The pane stands half open in its frame.
    let open = (hood.low.y - bench) * (0.25 + 0.12 * look as f64);
    pane(builder, upper, [bench + open, hood.high.y - 0.06]);
    valves(builder, bay.width(), bench, upper.high.z);
    for (x, tall) in [(-0.2, 0.16), (-0.1, 0.22), (0.18, 0.12)] {
        let glass =
            [(0.05, bench - SINK), (0.055, bench + 0.02), (0.016, bench + tall * 0.6), (0.016, bench + tall)];
        builder.add("glass", lathe(&glass, 10).moved(x * bay.width(), 0.0, 0.0));
    }
}

/// Cupboards with doors on a plinth, up to the bench.
fn cupboards(builder: &mut Builder, (slot, front): (&'static str, &'static str), bench: f64) {
    let bay = builder.bay();
    let fittings = Fittings { front, handle: "metal", reach: 0.025, is_traditional: false };
    let base = bay.with_y([PLINTH, bench - TOP]).inset(0.002, 0.0, 0.002);
    builder.cuboid(
        "plastic_dark",
        base.with_y([0.0, PLINTH + SINK]).inset(0.01, 0.0, 0.01).without(Side::Front, 0.05),
    );
    fittings.carcass(builder, slot, base);
    let count = (bay.width() / 0.5).round().clamp(1.0, 5.0) as u32;
    for (index, column) in base.inset(0.003, 0.003, 0.0).columns(count, 0.004).into_iter().enumerate() {
        fittings.door(builder, column, if index % 2 == 0 { Side::Left } else { Side::Right }, 0.85);
    }
}

/// Walls, a tiled back, the hood with its lamp, and the duct; gives the hood.
fn chamber(builder: &mut Builder, slot: &'static str, upper: Bay) -> Bay {
    for side in [Side::Left, Side::Right] {
        builder.cuboid(slot, upper.slab(side, SIDE_WALL).without(Side::Above, HEAD));
    }
    let back = upper.slab(Side::Back, BACK_WALL).inset(SIDE_WALL - SINK, 0.001, 0.0006);
    builder.cuboid("tile_wall", back.without(Side::Above, HEAD));
    let top = upper.high.y;
    let hood = upper.with_y([top - HEAD - HOOD, top - HEAD]).inset(SIDE_WALL - SINK, 0.0, 0.001);
    builder.cuboid(slot, hood.without(Side::Back, BACK_WALL - SINK).without(Side::Front, 0.002));
    builder.block("metal", upper.slab(Side::Above, HEAD + SINK), 0.006);
    builder.cuboid("lamp", hood.with_y([hood.low.y - 0.006, hood.low.y + SINK]).inset(0.08, 0.0, 0.2));
    hood
}

/// A pane between two rails with a handle to lift it.
fn pane(builder: &mut Builder, upper: Bay, y: [f64; 2]) {
    let pane = upper.slab(Side::Front, 0.02).inset(SIDE_WALL * 0.7, 0.0, 0.0).moved(0.0, 0.0, 0.012);
    let pane = pane.with_y(y);
    builder.cuboid("glass", pane.inset(0.004, 0.004, 0.006));
    for edge in [Side::Below, Side::Above] {
        builder.cuboid("metal", pane.slab(edge, 0.025));
    }
    let at = DVec3::new(0.0, pane.low.y + 0.0125, pane.high.z);
    handle(builder, "metal_dark", (HandleKind::Level, pane.width() * 0.3), at, 0.016);
}

/// Taps for gas, water, air and vacuum on both walls, each of its colour.
fn valves(builder: &mut Builder, width: f64, bench: f64, front: f64) {
    for (index, x) in [-0.47, -0.455, 0.455, 0.47].into_iter().enumerate() {
        let at = DVec3::new(x * width * 0.985, bench + 0.14 + 0.12 * (index % 2) as f64, front);
        let valve = turned_forward(lathe(&[(0.01, -SINK), (0.01, 0.02), (0.02, 0.022), (0.018, 0.045)], 8));
        builder.add(["book", "leaf", "painted_accent", "brass"][index], valve.moved(at.x, at.y, at.z));
    }
}
