//! The deep basin of a laundry.

use glam::DVec3;

use super::parts::{Fittings, LegKind, Tap, legs_at_corners, tap};
use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, Outline, SINK, Slice, lathe, loft, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// A deep basin for laundry on legs or a cabinet, with a rub board and a high tap.
pub(super) static UTILITY_SINK: Recipe =
    Recipe::furniture("utility_sink", [0.6, 0.5, 1.0]).every_set(utility_sink);

fn utility_sink(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let look = draft.form();
    let rim = bay.high.y - (bay.height() * 0.16).min(0.16);
    let deep = (rim * 0.4).min(0.3);
    let (slot, under) = match draft.set() {
        GeometrySet::Traditional => ([Slot::Ceramic, Slot::Stone][look % 2], Slot::Wood),
        GeometrySet::Industrial => (Slot::Metal, Slot::MetalDark),
        GeometrySet::Budget => (Slot::Plastic, Slot::Metal),
        GeometrySet::Plain => ([Slot::Ceramic, Slot::Metal][look % 2], Slot::Painted),
    };
    let half = bay.extent() / 2.0;
    let slice = |y: f64, back: f64| Slice::new(y, half.x - back, half.z - back).softened(0.04);
    let hollow =
        |y: f64, back: f64| Slice::new(y, half.x - back, half.z - back - 0.03).at(0.0, 0.03).softened(0.05);
    let tub = [
        slice(rim - deep, 0.05),
        slice(rim - 0.05, 0.012),
        slice(rim - 0.049, 0.0),
        slice(rim, 0.0),
        hollow(rim, 0.03),
        hollow(rim - deep + 0.02, 0.08),
    ];
    builder.add(slot, loft(&Outline::Soft(2), &tub));
    builder.add(
        Slot::Chrome,
        lathe(
            &[(0.03, rim - deep + 0.02 - SINK), (0.03, rim - deep + 0.023), (0.015, rim - deep + 0.025)],
            10,
        )
        .moved(0.0, 0.0, 0.03),
    );
    // Ribs to rub on, at the front of the hollow.
    for rib in 0..5 {
        let y = rim - 0.06 - 0.03 * f64::from(rib);
        let bar =
            Bay::around(DVec3::new(0.0, y, half.z - 0.062 - 0.006 * f64::from(rib)), half.x, 0.01, 0.024);
        builder.cuboid(slot, bar);
    }
    let is_cabinet = draft.set() == GeometrySet::Plain || (draft.is_traditional() && look < 2);
    if is_cabinet {
        cupboard(draft, builder, under, rim - deep);
    } else {
        frame(draft, builder, under, rim - deep + 0.02);
    }
    let foot = DVec3::new(0.0, rim, bay.low.z + 0.035);
    tap(builder, draft.set(), Tap { foot, height: bay.high.y - rim, reach: bay.depth() * 0.3 });
}

/// A cupboard with two doors under a basin whose underside is at a height.
fn cupboard(draft: &Draft, builder: &mut Builder, under: Slot, high: f64) {
    let bay = builder.bay();
    let fittings =
        Fittings { front: under, handle: Slot::Metal, reach: 0.022, is_traditional: draft.is_traditional() };
    let body = bay.inset(0.055, 0.0, 0.052).with_y([0.08, high + 0.002]);
    builder.cuboid(
        Slot::PlasticDark,
        body.with_y([0.0, 0.08 + SINK]).inset(0.006, 0.0, 0.006).without(Side::Front, 0.05),
    );
    fittings.carcass(builder, under, body);
    for (column, hinge) in
        body.inset(0.002, 0.003, 0.0).columns(2, 0.004).into_iter().zip([Side::Left, Side::Right])
    {
        fittings.door(builder, column, hinge, 0.85);
    }
}

/// Four legs with a shelf, and the waste pipe behind it; the hollow of the basin ends at a height.
fn frame(draft: &Draft, builder: &mut Builder, under: Slot, low: f64) {
    let bay = builder.bay();
    let legs = bay.inset(0.05, 0.0, 0.05).with_y([0.0, low + 0.02]);
    legs_at_corners(
        builder,
        under,
        legs,
        0.035,
        if draft.is_traditional() { LegKind::Turned } else { LegKind::Square },
    );
    let y = low * 0.3;
    builder.cuboid(under, legs.inset(0.01, 0.0, 0.01).with_y([y, y + 0.02]));
    let waste = [
        DVec3::new(0.0, low, 0.03),
        DVec3::new(0.0, low * 0.62, 0.03),
        DVec3::new(0.0, low * 0.56, -0.03),
        DVec3::new(0.0, low * 0.62, bay.low.z + 0.02),
        DVec3::new(0.0, low * 0.62, bay.low.z + 0.001),
    ];
    builder.add(Slot::Plastic, sweep(&waste, 0.02, 8));
}
