//! Luggage trolleys: birdcages of hotels are 1.1 m long, 0.6 wide and 1.8 high; those of stations 1.0 m high.

use glam::DVec3;

use super::castors;
use crate::catalog::Side;
use crate::model::kit::{Bay, Builder, SINK, sweep};
use crate::model::recipes::input::{Draft, GeometrySet};
use crate::model::recipes::parts::{HandleKind, handle};

/// Metres of a push bar's radius.
const TUBE: f64 = 0.016;

/// A luggage trolley: a birdcage of brass over a carpet, or a bent frame with a low deck and a push bar.
pub(in super::super) fn luggage_trolley(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let lift = 0.13_f64.min(bay.height() * 0.2);
    let inner = bay.inset(0.02, 0.0, 0.02);
    castors(builder, inner, lift);
    let is_cage = draft.is_traditional() || (draft.set() == GeometrySet::Plain && draft.input.look % 2 == 1);
    let deck = bay.with_y([lift - SINK, lift + 0.035]);
    if is_cage {
        birdcage(builder, inner, (lift, deck));
    } else {
        let metal = if draft.set() == GeometrySet::Industrial { "metal_dark" } else { "metal" };
        slatted_deck(builder, metal, deck);
        push_bar(builder, metal, (inner.high.x, lift));
    }
    if draft.input.look.is_multiple_of(2) {
        suitcases(builder, bay, deck.high.y + if is_cage { 0.006 } else { -0.006 });
    }
}

/// A carpeted deck of brass under two bows and the rails between them.
fn birdcage(builder: &mut Builder, inner: Bay, (lift, deck): (f64, Bay)) {
    let bay = builder.bay();
    builder.block("brass", deck, 0.008);
    builder.cuboid("carpet", deck.inset(0.02, 0.0, 0.02).with_y([lift + 0.034, lift + 0.042]));
    let radius = 0.014;
    let top = bay.high.y - radius;
    for x in [inner.low.x + 0.01, inner.high.x - 0.01] {
        let at = |y: f64, z: f64| DVec3::new(x, y, z);
        let (near, far) = (inner.high.z - 0.01, inner.low.z + 0.01);
        let rise = bay.height() * 0.2;
        let path = [
            at(lift + 0.02, far),
            at(top - rise, far),
            at(top - rise * 0.3, far * 0.7),
            at(top, far * 0.3),
            at(top, near * 0.3),
            at(top - rise * 0.3, near * 0.7),
            at(top - rise, near),
            at(lift + 0.02, near),
        ];
        builder.add("brass", sweep(&path, radius, 8));
    }
    for z in [-0.28, 0.28] {
        let bar = [
            DVec3::new(inner.low.x + 0.01, top, z * inner.depth()),
            DVec3::new(inner.high.x - 0.01, top, z * inner.depth()),
        ];
        builder.add("brass", sweep(&bar, radius * 0.9, 8));
    }
}

/// Slats between two bars, on three bars across.
fn slatted_deck(builder: &mut Builder, metal: &'static str, deck: Bay) {
    for side in [Side::Left, Side::Right] {
        builder.block(metal, deck.slab(side, 0.035), 0.006);
    }
    for slat in deck.inset(0.03, 0.005, 0.01).rows(1, 0.0).into_iter().flat_map(|row| row.columns(5, 0.02)) {
        builder.cuboid(metal, slat);
    }
    for z in [-0.45, 0.0, 0.45] {
        let cross = Bay::around(
            DVec3::new(0.0, deck.low.y + 0.012, z * deck.depth()),
            deck.width() - 0.04,
            0.012,
            0.04,
        );
        builder.cuboid(metal, cross);
    }
}

/// A bent tube at the back to push by, with a basket before it and rungs below.
fn push_bar(builder: &mut Builder, metal: &'static str, (right, lift): (f64, f64)) {
    let (bay, tube) = (builder.bay(), TUBE);
    let (x, z, top) = (right - tube, bay.low.z + tube, bay.high.y - tube);
    let path = [
        DVec3::new(-x, lift, z + 0.1),
        DVec3::new(-x, top - 0.12, z + 0.02),
        DVec3::new(-x, top, z),
        DVec3::new(x, top, z),
        DVec3::new(x, top - 0.12, z + 0.02),
        DVec3::new(x, lift, z + 0.1),
    ];
    builder.add(metal, sweep(&path, tube, 8));
    builder.add(
        "rubber",
        sweep(&[DVec3::new(-x * 0.8, top, z), DVec3::new(x * 0.8, top, z)], tube * 0.99 + 0.002, 8),
    );
    let basket = Bay::new([-x * 0.9, x * 0.9], [bay.high.y * 0.62, bay.high.y * 0.8], [z + 0.03, z + 0.22]);
    wire_basket(builder, metal, basket);
    for y in [0.3, 0.45] {
        let rung = [DVec3::new(-x, bay.high.y * y, z + 0.08), DVec3::new(x, bay.high.y * y, z + 0.08)];
        builder.add(metal, sweep(&rung, tube * 0.6, 6));
    }
}

/// A basket of wire.
fn wire_basket(builder: &mut Builder, slot: &'static str, bay: Bay) {
    let wire = 0.006;
    builder.cuboid(slot, bay.slab(Side::Below, wire));
    for side in [Side::Front, Side::Back] {
        builder.cuboid(slot, bay.slab(Side::Above, wire).slab(side, wire));
        for post in bay
            .slab(side, wire)
            .inset(0.0005, wire * 0.5, 0.0004)
            .columns(6, (bay.width() - wire * 6.0) / 5.0)
        {
            builder.cuboid(slot, post);
        }
    }
    for side in [Side::Left, Side::Right] {
        builder.cuboid(
            slot,
            bay.inset(0.0007, 0.0, 0.0)
                .slab(Side::Above, wire)
                .slab(side, wire * 0.9)
                .inset(0.0, 0.0004, 0.002),
        );
    }
}

/// Two suitcases, one on the other.
fn suitcases(builder: &mut Builder, bay: Bay, floor: f64) {
    let room = bay.height() * 0.55;
    let mut low = floor;
    for (share, slot, wide, deep) in [(0.46, "leather", 0.8, 0.52), (0.32, "fabric_accent", 0.66, 0.42)] {
        let tall = room * share;
        let case = Bay::around(
            DVec3::new(0.0, low + tall / 2.0, bay.depth() * 0.1),
            bay.width() * wide,
            tall,
            bay.depth() * deep,
        );
        builder.block(slot, case, 0.02);
        let grip = DVec3::new(0.0, case.center().y, case.high.z);
        handle(builder, "plastic_dark", (HandleKind::Level, 0.14), grip, 0.02);
        for x in [-0.3, 0.3] {
            let band = Bay::around(
                case.center() + DVec3::X * x * case.width(),
                0.02,
                tall + 0.004,
                case.depth() + 0.004,
            );
            builder.cuboid("rubber", band);
        }
        low += tall - SINK;
    }
}
