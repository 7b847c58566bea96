//! Machines of stations, workshops and computer rooms.

use super::input::Draft;
use crate::catalog::Side;
use crate::model::kit::{Builder, SINK};

/// A cabinet with a screen, keys and a tray.
pub(super) fn ticket_machine(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let body = bay.without(Side::Front, 0.03);
    builder.block("metal_dark", body.slab(Side::Below, 0.1), 0.004);
    let slot = draft.sampler().pick(&["painted_accent", "appliance"]);
    builder.block(slot, body.without(Side::Below, 0.1 - SINK), 0.02);
    let face = bay.inset(bay.width() * 0.14, 0.0, 0.0).with_z([body.high.z - SINK, body.high.z + 0.006]);
    let at = |low: f64, high: f64| [bay.high.y * low, bay.high.y * high];
    builder.cuboid("screen", face.with_y(at(0.6, 0.82)));
    let keys = face.with_y(at(0.46, 0.56));
    builder.cuboid("metal", keys.slab(Side::Right, keys.width() * 0.4));
    builder.cuboid("screen", keys.slab(Side::Left, keys.width() * 0.3).inset(0.0, 0.03, 0.0));
    let tray = face.with_y(at(0.3, 0.36)).with_z([body.high.z - SINK, bay.high.z]);
    builder.block("metal", tray, 0.004);
    builder.cuboid("lamp", face.with_y(at(0.89, 0.96)));
}

/// A rubber belt on a metal body.
pub(super) fn luggage_belt(_draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let rim = (bay.depth() * 0.1).min(0.12);
    builder.cuboid("metal_dark", bay.slab(Side::Below, 0.08 + SINK).inset(0.05, 0.0, 0.05));
    let body = bay.without(Side::Below, 0.08);
    for side in [Side::Front, Side::Back] {
        builder.block("metal", body.slab(side, rim), 0.01);
    }
    for side in [Side::Left, Side::Right] {
        builder.block("metal", body.slab(side, rim).inset(0.0, 0.001, rim - 0.012), 0.005);
    }
    let belt = body.inset(rim - 0.01, 0.0, rim - 0.01).without(Side::Above, 0.02);
    let plates = (belt.width() / 0.4).round().clamp(1.0, 24.0) as u32;
    builder.cuboid("rubber", belt.without(Side::Above, 0.006));
    for plate in belt.slab(Side::Above, 0.01).columns(plates, 0.02) {
        builder.cuboid("rubber", plate);
    }
}

/// A dark cabinet with a door of mesh behind which lights glow.
pub(super) fn server_rack(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let body = bay.without(Side::Front, 0.02);
    builder.block("metal_dark", body, 0.006);
    let face = bay.inset(0.04, 0.06, 0.0).with_z([body.high.z - SINK, body.high.z + 0.01]);
    for unit in face.rows(14, 0.012) {
        builder.cuboid(sampler.pick(&["plastic_dark", "metal", "plastic_dark"]), unit);
        let light = unit.slab(Side::Right, 0.05).inset(0.015, unit.height() * 0.35, 0.0);
        if sampler.chance(0.7) {
            builder.cuboid("lamp", light.with_z([unit.high.z - SINK, unit.high.z + 0.002]));
        }
    }
    let frame = bay.slab(Side::Front, 0.02 + SINK);
    builder.cuboid("metal_dark", frame.slab(Side::Left, 0.02));
    builder.cuboid("metal_dark", frame.slab(Side::Right, 0.02));
}
