//! Two pallets over each other with a mattress and a back of boards.

use glam::DVec3;

use super::Lounger;
use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::furniture::seating::depth_slats;
use crate::recipes::kit::{Bay, Builder, SINK, cuboid, rounded_box, sweep};

/// Metres of the mattress.
const MATTRESS: f64 = 0.08;

pub(super) fn build(lounger: &Lounger, builder: &mut Builder, look: usize) {
    let bay = lounger.bay;
    let (wood, cover) = [
        (Slot::WoodLight, Slot::Fabric),
        (Slot::Wood, Slot::Leather),
        (Slot::WoodLight, Slot::Leather),
        (Slot::WoodDark, Slot::FabricLight),
    ][look];
    let stack = bay.with_y([0.0, lounger.lying - MATTRESS]);
    for layer in stack.rows(2, 0.002) {
        pallet(builder, wood, layer);
    }
    let flat = lounger.flat(MATTRESS + SINK).without(Side::Left, 0.02).inset(0.02, 0.0, 0.03);
    builder.cushion(cover, flat, 0.03);
    let head = lounger.head(MATTRESS * 0.8).inset(0.0, 0.0, 0.03).without(Side::Left, 0.02);
    let soft = rounded_box(head, DVec3::splat(0.025), 2);
    builder.add(cover, lounger.raised(soft));
    let boards = lounger.head(0.02).moved(0.0, -MATTRESS * 0.8 + SINK, 0.0).inset(0.0, 0.0, 0.002);
    for board in boards.columns(4, 0.03) {
        builder.add(wood, lounger.raised(cuboid(board)));
    }
    let x = lounger.knee - lounger.length * 0.7;
    for z in [-bay.depth() * 0.36, bay.depth() * 0.36] {
        let stile = boards.inset(0.03, 0.0, 0.0).moved(0.0, -0.018, 0.0).with_z([z - 0.03, z + 0.03]);
        builder.add(wood, lounger.raised(cuboid(stile)));
        let prop = [
            DVec3::new(x - 0.05, stack.high.y - 0.004, z),
            DVec3::new(x, lounger.height_at(x) - MATTRESS, z),
        ];
        builder.add(Slot::MetalDark, sweep(&prop, 0.012, 4));
    }
    for share in [0.3, 0.7] {
        let x = flat.low.x + flat.width() * share;
        let strap = flat.inset(0.0, -0.002, -0.002).with_x([x - 0.02, x + 0.02]);
        builder.cuboid(Slot::MetalDark, strap.without(Side::Below, 0.003));
    }
}

/// Boards along the length over blocks at the edges and the boards below them.
fn pallet(builder: &mut Builder, wood: Slot, bay: Bay) {
    let board = bay.height() * 0.18;
    for slat in depth_slats(bay.slab(Side::Above, board), 4, 0.035) {
        builder.cuboid(wood, slat);
    }
    let blocks = bay.inset(0.001, 0.0, 0.001).without(Side::Above, board - SINK);
    for column in blocks.without(Side::Below, board - SINK).columns(3, bay.width() * 0.38) {
        for end in [Side::Front, Side::Back] {
            builder.cuboid(wood, column.slab(end, 0.1));
        }
    }
    for end in [Side::Front, Side::Back] {
        builder.cuboid(wood, bay.slab(Side::Below, board).slab(end, 0.11).inset(0.002, 0.0, 0.0));
    }
}
