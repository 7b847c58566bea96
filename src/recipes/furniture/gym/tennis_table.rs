//! Table tennis tables: 2.74 by 1.525 m, 0.76 high; the net 0.1525 high stands out by as much at both sides (ITTF).

use glam::DVec3;

use crate::geometry::Side;
use crate::recipes::furniture::parts::{LegKind, across, legs_at_corners};
use crate::recipes::kit::{Bay, Builder, SINK, pipe, sweep};
use crate::recipes::{Recipe, Slot, Symbol};

/// Metres of the net's height.
const NET: f64 = 0.1525;

/// A table-tennis table with its net: on four legs; on turned ones under an apron; cast for parks; two halves that fold.
pub(in super::super) static TENNIS_TABLE: Recipe = Recipe::furniture("tennis_table", [2.74, 1.525, 0.91])
    .symbol(Symbol::Net)
    .plain(|_, builder| plain(builder))
    .traditional(|_, builder| turned(builder))
    .industrial(|_, builder| cast(builder))
    .budget(|_, builder| folding(builder));

/// The table under the net.
fn under_net(bay: Bay) -> Bay {
    bay.without(Side::Above, (bay.height() * 0.17).min(NET))
}

/// A net of cloth across the middle.
fn cloth_net(builder: &mut Builder) {
    let bay = builder.bay();
    let rise = bay.high.y - under_net(bay).high.y;
    let mesh = bay.slab(Side::Above, rise + SINK).with_x([-0.004, 0.004]).inset(0.0, 0.0, 0.003);
    builder.cuboid(Slot::Linen, mesh);
}

/// The white line along the middle of a top.
fn middle_line(builder: &mut Builder, top: Bay) {
    let line = top.slab(Side::Above, 0.001).moved(0.0, 0.0005, 0.0);
    builder.cuboid(Slot::Linen, line.with_z([-0.005, 0.005]).inset(0.02, 0.0, 0.0));
}

fn plain(builder: &mut Builder) {
    let bay = builder.bay();
    let top = under_net(bay);
    builder.cuboid(Slot::PaintedAccent, top.slab(Side::Above, 0.03));
    middle_line(builder, top);
    cloth_net(builder);
    let legs = top.without(Side::Above, 0.03 - SINK).inset(bay.width() * 0.12, 0.0, bay.depth() * 0.1);
    legs_at_corners(builder, Slot::MetalDark, legs, 0.05, LegKind::Square);
}

/// Turned legs under an apron of wood; posts of brass hold the net.
fn turned(builder: &mut Builder) {
    let bay = builder.bay();
    let top = under_net(bay);
    builder.block(Slot::Leaf, top.slab(Side::Above, 0.028), 0.004);
    middle_line(builder, top);
    cloth_net(builder);
    let apron = top.without(Side::Above, 0.028 - SINK).slab(Side::Above, 0.11).inset(0.1, 0.0, 0.08);
    for side in [Side::Front, Side::Back] {
        builder.cuboid(Slot::WoodDark, apron.slab(side, 0.03).inset(0.02, 0.001, 0.0));
    }
    for side in [Side::Left, Side::Right] {
        builder.cuboid(Slot::WoodDark, apron.slab(side, 0.03).inset(0.0, 0.002, 0.02));
    }
    let legs = apron.with_y([0.0, apron.high.y]).inset(-0.008, 0.0, -0.008);
    legs_at_corners(builder, Slot::WoodDark, legs, 0.1, LegKind::Baluster);
    legs_at_corners(builder, Slot::WoodDark, legs.with_x([-0.09, 0.09]), 0.07, LegKind::Turned);
    for z in [bay.low.z + 0.012, bay.high.z - 0.012] {
        let post = [DVec3::new(0.0, top.high.y - 0.06, z), DVec3::new(0.0, bay.high.y - 0.002, z)];
        builder.add(Slot::Brass, sweep(&post, 0.009, 8));
    }
}

/// A slab of stone on two walls, with a net of perforated sheet.
fn cast(builder: &mut Builder) {
    let bay = builder.bay();
    let top = under_net(bay);
    builder.block(Slot::Stone, top.slab(Side::Above, 0.07), 0.012);
    let line = top.slab(Side::Above, 0.001).moved(0.0, 0.0004, 0.0).inset(0.03, 0.0, 0.03);
    for side in [Side::Front, Side::Back] {
        builder.cuboid(Slot::Linen, line.slab(side, 0.02));
    }
    for side in [-1.0, 1.0] {
        let x = side * bay.width() * 0.27;
        let wall = Bay::new([x - 0.09, x + 0.09], [0.06, top.high.y - 0.07 + SINK], [-0.5, 0.5]);
        builder.block(Slot::Concrete, wall.with_z([bay.low.z * 0.7, bay.high.z * 0.7]), 0.02);
        let foot = Bay::new([x - 0.2, x + 0.2], [0.0, 0.07], [bay.low.z * 0.8, bay.high.z * 0.8]);
        builder.block(Slot::Concrete, foot, 0.02);
    }
    let net =
        bay.slab(Side::Above, bay.high.y - top.high.y + SINK).with_x([-0.006, 0.006]).inset(0.0, 0.0, 0.02);
    for side in [Side::Above, Side::Below] {
        builder.cuboid(Slot::Metal, net.slab(side, 0.03));
    }
    let bars = net.inset(0.0012, 0.028, 0.0);
    let count = (bay.depth() / 0.09).round().clamp(4.0, 24.0) as u32;
    let pitch = (bars.depth() - 0.024) / f64::from(count);
    for index in 0..=count {
        let z = bars.low.z + f64::from(index) * pitch;
        builder.cuboid(Slot::Metal, bars.with_z([z, z + 0.024]).inset(0.0, 0.0, 0.0002));
    }
}

/// Two halves on wheeled bows of tube that fold up in the middle.
fn folding(builder: &mut Builder) {
    let bay = builder.bay();
    let top = under_net(bay);
    let (tube, gap) = (0.016, 0.012);
    for side in [Side::Left, Side::Right] {
        let half = top.slab(side, bay.width() / 2.0 - gap);
        builder.cuboid(Slot::Leaf, half.slab(Side::Above, 0.016));
        let frame = half.without(Side::Above, 0.016 - SINK).slab(Side::Above, 0.04).inset(0.02, 0.0, 0.02);
        for edge in [Side::Front, Side::Back] {
            builder.cuboid(Slot::Metal, frame.slab(edge, 0.02).inset(0.001, 0.0, 0.0));
        }
        for edge in [Side::Left, Side::Right] {
            builder.cuboid(Slot::Metal, frame.slab(edge, 0.02).inset(0.0, 0.0012, 0.02 - SINK));
        }
        middle_line(builder, half);
        let sign = if side == Side::Left { -1.0 } else { 1.0 };
        for (share, spread) in [(0.82, 0.76), (0.14, 0.9)] {
            let at =
                |share: f64, y: f64, z: f64| DVec3::new(sign * bay.high.x * share, y, z * bay.high.z * 0.8);
            let high = top.high.y - 0.03;
            let low = if share < 0.5 { 0.09 } else { tube };
            let bow = [
                at(share, high, -1.0),
                at(share * spread, low, -1.0),
                at(share * spread, low, 1.0),
                at(share, high, 1.0),
            ];
            builder.add(Slot::Metal, pipe(&bow, tube, 0.08));
            if share < 0.5 {
                for z in [-0.66, 0.66] {
                    let x = sign * bay.high.x * share * spread;
                    let wheel = across(0.05, [x - 0.015, x + 0.015], 10);
                    builder.add(Slot::Rubber, wheel.moved(0.0, 0.05, z * bay.high.z));
                }
            }
        }
        let brace = [0.78, 0.2].map(|share| sign * bay.high.x * share);
        let path = [DVec3::new(brace[0], 0.3, 0.0), DVec3::new(brace[1], top.high.y - 0.05, 0.0)];
        builder.add(Slot::MetalDark, sweep(&path, tube * 0.7, 6));
        let bar = [-0.8, 0.8].map(|z| DVec3::new(brace[0], 0.3, z * bay.high.z));
        builder.add(Slot::Metal, sweep(&bar, tube * 0.8, 6));
    }
    cloth_net(builder);
    for z in [bay.low.z + 0.01, bay.high.z - 0.01] {
        let post = Bay::around(DVec3::new(0.0, bay.high.y - 0.09, z), 0.03, 0.178, 0.018);
        builder.cuboid(Slot::PlasticDark, post.with_y([top.high.y - 0.05, bay.high.y - 0.002]));
    }
}
