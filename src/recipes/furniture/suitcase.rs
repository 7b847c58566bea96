//! Suitcases: 0.45 to 0.52 m wide, 0.24 to 0.32 deep, 0.65 to 0.78 high with wheels.

use glam::DVec3;

use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, SINK, cuboid, rounded_path, sweep};
use crate::recipes::{Draft, Recipe, Slot};

/// A suitcase: a shell with ribs on wheels; leather with straps and corners; aluminium with ribs; a soft bag with a pocket.
/// The look chooses its colour.
pub(super) static SUITCASE: Recipe = Recipe::accessory("suitcase", [0.48, 0.28, 0.72])
    .plain(shell)
    .traditional(|_, builder| leather(builder))
    .industrial(|_, builder| aluminium(builder))
    .budget(soft);

/// Metres of the wheels' height.
const WHEELS: f64 = 0.05;
/// Metres of the handle over the case.
const HANDLE: f64 = 0.03;

/// The case between wheels and handle.
fn case(bay: Bay) -> Bay {
    bay.with_y([WHEELS - SINK, bay.high.y - HANDLE])
}

fn wheels(builder: &mut Builder) {
    let bay = builder.bay();
    for side in [Side::Front, Side::Back] {
        let wheel = bay.inset(0.05, 0.0, 0.04).slab(side, 0.04).slab(Side::Right, 0.03).with_y([0.0, WHEELS]);
        builder.add_pair(Slot::Rubber, cuboid(wheel));
    }
}

/// A handle over the top, across the case.
fn handle(builder: &mut Builder, slot: Slot) {
    let bay = builder.bay();
    let (top, reach, radius) = (bay.high.y, bay.width() * 0.16, 0.009);
    let low = top - HANDLE - SINK;
    let corners = [(-reach, low), (-reach, top - radius), (reach, top - radius), (reach, low)];
    let path = corners.map(|(x, y)| DVec3::new(x, y, 0.0));
    builder.add(slot, sweep(&rounded_path(&path, 0.02, 2), radius, 6));
}

fn shell(draft: &Draft, builder: &mut Builder) {
    let case = case(builder.bay());
    let slot = draft.sampler().pick(&[Slot::Painted, Slot::PaintedAccent, Slot::PlasticDark]);
    builder.cushion(slot, case.inset(0.0, 0.0, 0.006), 0.05);
    for rib in case.inset(0.07, 0.06, 0.0).columns(4, 0.045) {
        builder.cuboid(slot, rib);
    }
    wheels(builder);
    handle(builder, Slot::PlasticDark);
}

fn leather(builder: &mut Builder) {
    let bay = builder.bay();
    let case = bay.with_y([0.0, bay.high.y - HANDLE]);
    builder.rounded(Slot::Leather, case.inset(0.005, 0.005, 0.005), DVec3::splat(0.02), 2);
    for share in [-0.28, 0.28] {
        let x = share * bay.width();
        builder.block(Slot::WoodDark, case.with_x([x - 0.02, x + 0.02]), 0.003);
    }
    handle(builder, Slot::Leather);
}

fn aluminium(builder: &mut Builder) {
    let case = case(builder.bay());
    builder.rounded(Slot::Metal, case.inset(0.004, 0.0, 0.004), DVec3::splat(0.03), 2);
    for rib in case.inset(0.04, 0.04, 0.0).columns(3, 0.06) {
        builder.cuboid(Slot::Metal, rib);
    }
    for edge in case.inset(0.0, 0.1, 0.05).rows(2, 0.3) {
        builder.cuboid(Slot::MetalDark, edge.slab(Side::Above, 0.03));
    }
    wheels(builder);
    handle(builder, Slot::MetalDark);
}

fn soft(draft: &Draft, builder: &mut Builder) {
    let case = case(builder.bay());
    let slot = draft.sampler().pick(&[Slot::Fabric, Slot::PlasticDark]);
    builder.cushion(slot, case.without(Side::Front, 0.05), 0.04);
    builder.block(slot, case.inset(0.05, 0.06, 0.0).slab(Side::Front, 0.08), 0.02);
    wheels(builder);
    handle(builder, Slot::PlasticDark);
}
