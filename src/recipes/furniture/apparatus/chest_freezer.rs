//! Chest freezers of shops: 1.5 to 2.5 m long, 0.8 to 0.9 deep and high.

use glam::{DVec2, DVec3};

use crate::geometry::Side;
use crate::recipes::furniture::parts::{HandleForm, HandleKind, across, handle};
use crate::recipes::kit::{
    Axis, Bay, Builder, Outline, SINK, Sampler, Slice, cylinder, extrude, lathe, loft,
};
use crate::recipes::{Recipe, Slot, Symbol};

/// A chest: under two flat panes; with round lids, for ice cream; of sheet under hinged lids; under a bowed pane, full of goods.
pub(in super::super) static CHEST_FREEZER: Recipe = Recipe::furniture("chest_freezer", [1.85, 0.9, 0.88])
    .symbol(Symbol::Fridge)
    .plain(|_, builder| flat_panes(builder))
    .traditional(|draft, builder| round_lids(builder, draft.form()))
    .industrial(|_, builder| hinged_lids(builder))
    .budget(|draft, builder| bowed_pane(builder, &mut draft.sampler()));

fn flat_panes(builder: &mut Builder) {
    let bay = builder.bay();
    builder.cuboid(Slot::PlasticDark, bay.slab(Side::Below, 0.08 + SINK).inset(0.03, 0.0, 0.03));
    let rim = bay.slab(Side::Above, 0.05);
    let body = bay.without(Side::Below, 0.08).without(Side::Above, 0.05 - SINK);
    builder.block(Slot::Appliance, body.inset(0.004, 0.0, 0.004), 0.02);
    builder.block(Slot::Metal, rim.without(Side::Above, 0.012), 0.006);
    for lid in rim.inset(0.03, 0.0, 0.05).slab(Side::Above, 0.014).columns(2, 0.02) {
        builder.cuboid(Slot::Glass, lid);
    }
    let band = bay.with_y([bay.high.y * 0.55, bay.high.y * 0.7]).inset(0.1, 0.0, 0.0);
    builder.cuboid(Slot::PaintedAccent, band.slab(Side::Front, 0.008));
}

/// A body with round corners and mouldings, flaps over two rows of tubs.
fn round_lids(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let half = bay.extent() / 2.0;
    let high = bay.height();
    let slice =
        |y: f64, back: f64| Slice::new(y, half.x - back, half.z - back).softened(0.16 - back.min(0.1));
    let foot = [slice(0.0, 0.04), slice(0.12, 0.04)];
    builder.add(Slot::MetalDark, loft(&Outline::Soft(3), &foot));
    let body = [
        slice(0.12 - SINK, 0.015),
        slice(high * 0.3, 0.015),
        slice(high * 0.32, 0.0),
        slice(high * 0.36, 0.0),
        slice(high * 0.38, 0.015),
        slice(high * 0.86, 0.015),
        slice(high * 0.9, 0.0),
        slice(high - 0.06, 0.0),
    ];
    let slot = [Slot::Painted, Slot::PaintedAccent, Slot::Ceramic, Slot::Leaf][look];
    builder.add(slot, loft(&Outline::Soft(3), &body));
    let top = [slice(high - 0.06 - SINK, 0.02), slice(high - 0.04, 0.03)];
    builder.add(Slot::Chrome, loft(&Outline::Soft(3), &top));
    let count = (bay.width() / 0.42).round().clamp(2.0, 6.0) as u32;
    for (row, z) in [-0.21, 0.21].into_iter().enumerate() {
        for (index, cell) in bay.inset(0.1, 0.0, 0.0).columns(count, 0.04).into_iter().enumerate() {
            let radius = (cell.width() / 2.0).min(bay.depth() * 0.19);
            let at = DVec3::new(cell.center().x, high - 0.04, z * bay.depth());
            let is_first = row == 0 && index == 0;
            let lid = [(1.0, -SINK), (1.0, 0.012), (0.6, if is_first { 0.02 } else { 0.019 }), (0.0, 0.021)];
            let lid = lathe(&lid.map(|(share, y)| (share * radius, y)), 12);
            builder.add(Slot::Chrome, lid.moved(at.x, at.y, at.z));
            builder.add(Slot::PlasticDark, cylinder(0.018, [0.015, 0.04], 8).moved(at.x, at.y, at.z));
        }
    }
    let sign = bay.slab(Side::Front, 0.02).with_y([high * 0.46, high * 0.78]).inset(half.x * 0.4, 0.0, 0.0);
    builder.block(Slot::Linen, sign.moved(0.0, 0.0, -0.004), 0.006);
    let mark = sign.inset(0.06, 0.06, 0.0).slab(Side::Front, 0.004).moved(0.0, 0.0, -0.001);
    for (index, stripe) in mark.rows(3, 0.03).into_iter().enumerate() {
        builder.cuboid([Slot::Book, Slot::PaintedAccent, Slot::Book][index], stripe);
    }
}

/// A body of sheet on castors, with two lids that stand over its edge, and a grille for the motor.
fn hinged_lids(builder: &mut Builder) {
    let bay = builder.bay();
    let (lid, foot) = (0.09, 0.1);
    let body = bay.with_y([foot, bay.high.y - lid - 0.008]).inset(0.012, 0.0, 0.012);
    builder.block(Slot::Metal, body, 0.008);
    builder.cuboid(Slot::Rubber, body.slab(Side::Above, 0.01).inset(0.02, 0.0, 0.02).moved(0.0, 0.009, 0.0));
    for piece in bay.slab(Side::Above, lid).without(Side::Front, 0.02).columns(2, 0.014) {
        builder.block(Slot::Metal, piece, 0.012);
        let at = DVec3::new(piece.center().x, piece.center().y, piece.high.z);
        handle(builder, Slot::PlasticDark, HandleForm { kind: HandleKind::Level, length: 0.26 }, at, 0.02);
        for share in [-0.32, 0.32] {
            let at =
                DVec3::new(piece.center().x + share * piece.width(), piece.low.y - 0.01, bay.low.z + 0.0095);
            builder.cuboid(Slot::MetalDark, Bay::around(at, 0.08, 0.13, 0.016));
        }
    }
    let grille = body.slab(Side::Right, 0.42).slab(Side::Below, 0.3).inset(0.05, 0.06, 0.0);
    for slot in grille.rows(6, 0.016) {
        builder.cuboid(Slot::MetalDark, slot.with_z([body.high.z - SINK, body.high.z + 0.004]));
    }
    let dial = Bay::around(DVec3::new(grille.center().x, body.center().y, body.high.z), 0.14, 0.06, 0.008);
    builder.cuboid(Slot::Screen, dial);
    for x in [bay.low.x + 0.12, bay.high.x - 0.12] {
        for z in [bay.low.z + 0.1, bay.high.z - 0.1] {
            builder.add(Slot::Rubber, across(0.05, [x - 0.018, x + 0.018], 10).moved(0.0, 0.05, z));
            builder.cuboid(
                Slot::MetalDark,
                Bay::new([x - 0.03, x + 0.03], [0.06, foot + SINK], [z - 0.02, z + 0.02]),
            );
        }
    }
}

/// Goods in wire baskets under a bowed pane, in a bumper of plastic.
fn bowed_pane(builder: &mut Builder, sampler: &mut Sampler) {
    let bay = builder.bay();
    let high = bay.height();
    let rim = high * 0.76;
    builder.cuboid(Slot::PlasticDark, bay.slab(Side::Below, 0.06 + SINK).inset(0.04, 0.0, 0.04));
    builder.block(Slot::Plastic, bay.with_y([0.06, rim - 0.12]).inset(0.012, 0.0, 0.012), 0.03);
    builder.block(Slot::PaintedAccent, bay.with_y([rim - 0.12 - SINK, rim - 0.04]), 0.02);
    builder.cuboid(Slot::Plastic, bay.with_y([rim - 0.045, rim]).inset(0.02, 0.0, 0.02));
    let arc = |inset: f64, rise: f64| {
        let half = bay.high.z - inset;
        [1.0, 0.8, 0.45, 0.0, -0.45, -0.8, -1.0]
            .map(|share: f64| DVec2::new(share * half, rim - SINK + (rise - rim) * (1.0 - share * share)))
    };
    let (outer, inner) = (arc(0.03, high), arc(0.036, high - 0.008));
    let mut pane: Vec<DVec2> = outer.to_vec();
    pane.extend(inner.iter().rev().map(|point| *point - DVec2::Y * 0.004));
    builder.add(Slot::Glass, extrude(&pane, Axis::X, bay.inset(0.035, 0.0, 0.0).x()));
    for x in [[bay.low.x + 0.015, bay.low.x + 0.04], [-0.012, 0.012], [bay.high.x - 0.04, bay.high.x - 0.015]]
    {
        let mut end: Vec<DVec2> = arc(0.024, high + 0.001).to_vec();
        end.extend(arc(0.05, high - 0.03).iter().rev().map(|point| *point - DVec2::Y * 0.006));
        builder.add(Slot::Plastic, extrude(&end, Axis::X, x));
    }
    let space = bay.with_y([rim - 0.02, rim + (high - rim) * 0.4]).inset(0.08, 0.0, 0.14);
    let count = (space.width() / 0.3).round().clamp(3.0, 7.0) as u32;
    for column in space.columns(count, 0.03) {
        let slot = sampler.pick(&[
            Slot::Paper,
            Slot::Book,
            Slot::Leaf,
            Slot::FabricAccent,
            Slot::Linen,
            Slot::Brass,
        ]);
        let tall = sampler.between(0.4, 1.0) * column.height();
        for pack in super::super::seating::depth_slats(column.slab(Side::Below, tall), 3, 0.012) {
            builder.cuboid(slot, pack);
        }
    }
}
