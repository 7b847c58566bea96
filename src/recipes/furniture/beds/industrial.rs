//! Industrial beds: bent pipe, planks in angles, pallets, pipe fittings.

use glam::DVec3;

use super::Bed;
use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::furniture::parts::{LegKind, legs_at_corners};
use crate::recipes::furniture::seating::depth_slats;
use crate::recipes::kit::{Builder, SINK, cylinder, pipe, sweep};

/// Frame and headboard.
pub(super) fn frame(bed: &Bed, builder: &mut Builder) {
    let body = bed.body();
    let legs = body.with_y([0.0, bed.frame - 0.004]).inset(0.016, 0.0, 0.02);
    match bed.form {
        2 => pallets(bed, builder),
        form => {
            let kind = [LegKind::Round, LegKind::Angle, LegKind::Square, LegKind::Pipe][form as usize];
            legs_at_corners(builder, Slot::MetalDark, legs, 0.045, kind);
            bed.rails(builder, Slot::MetalDark, [0.045, 0.07, 0.0, 0.05][form as usize], 0.045);
        }
    }
    match bed.form {
        0 => hoop(bed, builder),
        1 | 2 => planks(bed, builder),
        _ => fittings(bed, builder),
    }
}

fn hoop(bed: &Bed, builder: &mut Builder) {
    let (head, radius) = (bed.head, 0.017);
    let (x, z) = (head.high.x - radius, head.center().z);
    let at = |x: f64, y: f64| DVec3::new(x, y, z);
    let high = head.high.y - radius;
    builder.add(Slot::MetalDark, pipe(&[at(x, 0.0), at(x, high), at(-x, high), at(-x, 0.0)], radius, 0.16));
    let low = bed.frame;
    builder.add(Slot::MetalDark, sweep(&[at(-x, low), at(x, low)], radius * 0.8, 6));
    let middle = (low + high) / 2.0 + 0.08;
    builder.add(Slot::MetalDark, sweep(&[at(-x, middle), at(x, middle)], radius * 0.6, 6));
    for column in
        head.inset(0.06, 0.0, 0.0).columns((head.width() / 0.16).round().clamp(4.0, 12.0) as u32, 0.05)
    {
        let x = column.center().x;
        builder.add(Slot::MetalDark, sweep(&[at(x, low), at(x, high)], 0.0075, 6));
    }
    for z in [head.low.z + 0.012, head.high.z - 0.012] {
        let ends = [DVec3::new(0.0, 0.0, z - 0.012), DVec3::new(0.0, 0.0, z + 0.012)];
        for x in [-x, x] {
            builder.add(Slot::Metal, sweep(&ends.map(|end| end + DVec3::new(x, low, 0.0)), 0.012, 6));
        }
    }
}

fn planks(bed: &Bed, builder: &mut Builder) {
    let head = bed.head;
    let slot = if bed.form == 2 { Slot::WoodLight } else { Slot::Wood };
    let boards =
        head.without(Side::Below, bed.frame * 0.5).without(Side::Back, 0.026).without(Side::Front, 0.005);
    for (index, row) in boards.rows(4, 0.006).into_iter().enumerate() {
        builder.block(slot, row.inset(if index % 2 == 0 { 0.0 } else { 0.006 }, 0.0, 0.0), 0.005);
    }
    for side in [Side::Left, Side::Right] {
        let iron = head.slab(side, 0.05).inset(0.006, 0.0, 0.0).without(Side::Above, 0.01);
        builder.cuboid(Slot::MetalDark, iron.slab(Side::Back, 0.0265).inset(0.0, 0.001, 0.0));
        for y in [0.72, 0.86] {
            let bolt = cylinder(0.011, [-0.004, 0.0095], 6).turned_x(std::f64::consts::FRAC_PI_2);
            let center = iron.center();
            builder.add(Slot::Metal, bolt.moved(center.x, head.high.y * y, head.high.z - 0.0095));
        }
    }
}

/// Two layers of pallets under the mattress.
fn pallets(bed: &Bed, builder: &mut Builder) {
    let stack = bed.body().with_y([0.0, bed.frame]).inset(0.014, 0.0, 0.0).without(Side::Front, 0.016);
    for pallet in stack.rows(2, 0.003) {
        let board = pallet.height() * 0.16;
        for slat in depth_slats(pallet.slab(Side::Above, board), 6, 0.08) {
            builder.cuboid(Slot::WoodLight, slat);
        }
        for block in pallet.without(Side::Above, board - SINK).columns(3, pallet.width() * 0.3) {
            let block = block.inset(0.001, 0.0, 0.004);
            for part in depth_slats(block, 4, block.depth() * 0.22) {
                builder.cuboid(Slot::WoodLight, part.without(Side::Below, 0.002));
            }
        }
        for slat in depth_slats(pallet.slab(Side::Below, board), 3, pallet.depth() * 0.3) {
            builder.cuboid(Slot::WoodLight, slat.inset(0.002, 0.0, 0.006));
        }
    }
}

/// Pipe with flanges and a plank as shelf and head.
fn fittings(bed: &Bed, builder: &mut Builder) {
    let (head, radius) = (bed.head, 0.016);
    let z = head.low.z + 0.024;
    let x = head.high.x - 0.06;
    let tall = |x: f64| [DVec3::new(x, 0.004, z), DVec3::new(x, head.high.y - 0.02, z)];
    builder.add_pair(Slot::MetalDark, sweep(&tall(x), radius, 8));
    for y in [bed.lying * 0.9, head.high.y - 0.1] {
        builder.add(Slot::MetalDark, sweep(&[DVec3::new(-x, y, z), DVec3::new(x, y, z)], radius * 0.9, 8));
        builder.add_pair(Slot::Metal, cylinder(radius * 1.4, [y - 0.02, y + 0.02], 8).moved(x, 0.0, z));
    }
    builder.block(Slot::Wood, head.slab(Side::Above, 0.035), 0.006);
    let board = head
        .inset(0.1, 0.0, 0.0)
        .with_y([bed.lying, head.high.y - 0.12])
        .without(Side::Back, 0.028)
        .without(Side::Front, 0.008);
    for row in board.rows(2, 0.008) {
        builder.block(Slot::Wood, row, 0.005);
    }
    builder.add_pair(Slot::Metal, cylinder(radius * 1.7, [0.0, 0.012], 8).moved(x, 0.0, z));
}
