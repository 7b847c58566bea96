//! Tool trolleys: 0.70 to 0.77 m wide, 0.46 deep, 0.95 high, five to seven drawers.

use glam::DVec3;

use super::{castors, tool_carts};
use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, SINK, sweep};
use crate::recipes::{Recipe, Slot};

/// Metres by which the lips of drawers stand out.
const REACH: f64 = 0.018;

/// A chest of drawers of steel; a machinist's chest of wood; an open cart with three trays; boxes of plastic on wheels.
pub(in super::super) static TOOL_TROLLEY: Recipe = Recipe::furniture("tool_trolley", [0.7, 0.46, 0.95])
    .plain(|draft, builder| steel_chest(builder, draft.form()))
    .traditional(|draft, builder| tool_carts::wooden_chest(builder, draft.form()))
    .industrial(|draft, builder| tool_carts::open_cart(builder, draft.form()))
    .budget(|draft, builder| tool_carts::stacked_boxes(builder, draft.form()));

/// A chest of drawers on castors, with a push bar.
fn steel_chest(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let slot = [Slot::Book, Slot::PaintedAccent, Slot::MetalDark, Slot::PlasticDark][look];
    let lift = 0.14_f64.min(bay.height() * 0.2);
    let bar = 0.05;
    let body = bay.with_y([lift - SINK, bay.high.y - 0.03]).without(Side::Right, bar);
    castors(builder, body.inset(0.015, 0.0, 0.02).without(Side::Front, 0.02), lift);
    builder.block(slot, body.without(Side::Front, REACH + 0.01), 0.006);
    let face = body.inset(0.02, 0.02, 0.0).without(Side::Front, REACH).slab(Side::Front, 0.014);
    drawers(builder, slot, face, if look.is_multiple_of(2) { 5 } else { 7 });
    builder.block(
        Slot::Rubber,
        body.inset(0.004, 0.0, 0.004)
            .with_y([body.high.y - SINK, body.high.y + 0.012])
            .without(Side::Front, REACH),
        0.003,
    );
    rim_with_wrench(builder, slot, body);
    let x = bay.high.x - 0.014;
    let path = [
        DVec3::new(body.high.x - 0.01, bay.high.y * 0.86, body.low.z + 0.06),
        DVec3::new(x, bay.high.y * 0.86, body.low.z + 0.06),
        DVec3::new(x, bay.high.y * 0.86, body.high.z - 0.1),
        DVec3::new(body.high.x - 0.01, bay.high.y * 0.86, body.high.z - 0.1),
    ];
    builder.add(Slot::Chrome, sweep(&path, 0.0145, 8));
    builder.cuboid(
        Slot::Metal,
        bay.slab(Side::Front, REACH * 0.3)
            .with_x([-0.02, 0.02])
            .with_y([body.high.y - 0.05, body.high.y - 0.03]),
    );
    builder.cuboid(
        Slot::Metal,
        Bay::new(
            [-0.015, 0.015],
            [body.high.y - 0.046, body.high.y - 0.037],
            [bay.high.z - REACH - 0.012, bay.high.z - 0.001],
        ),
    );
}

/// Drawers over each other with a lip along each; the lowest is as high as two.
fn drawers(builder: &mut Builder, slot: Slot, face: Bay, count: u32) {
    let rows = face.rows(count, 0.008);
    for (index, row) in rows.iter().enumerate() {
        // The two lowest are one deep drawer.
        let row = match index {
            0 => row.with_y([row.low.y, rows[1].high.y]),
            1 => continue,
            _ => *row,
        };
        builder.cuboid(slot, row);
        let grip = row.slab(Side::Above, 0.014).inset(0.02, 0.0, 0.0);
        builder.cuboid(
            Slot::Metal,
            grip.with_z([row.high.z - SINK, row.high.z + REACH * 0.9]).moved(0.0, -0.001, 0.0),
        );
    }
}

/// A rim around the top, and a wrench on it.
fn rim_with_wrench(builder: &mut Builder, slot: Slot, body: Bay) {
    let bay = builder.bay();
    let rim = body.with_y([body.high.y - SINK, bay.high.y]).without(Side::Front, REACH * 0.5);
    for side in [Side::Left, Side::Right] {
        builder.cuboid(slot, rim.slab(side, 0.008));
    }
    let behind = rim.slab(Side::Back, 0.008).inset(0.006, 0.0, 0.0).without(Side::Above, 0.001);
    builder.cuboid(slot, behind.without(Side::Below, 0.0002).moved(0.0, 0.0, 0.0008));
    builder.cuboid(Slot::Chrome, Bay::around(DVec3::new(-0.08, body.high.y + 0.015, 0.06), 0.2, 0.008, 0.02));
}
