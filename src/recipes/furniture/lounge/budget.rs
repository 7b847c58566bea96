//! Cheap sofas: futons, foam blocks, thin cushions on tube.

use std::f64::consts::FRAC_PI_2;

use glam::DVec3;

use super::Sofa;
use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::furniture::parts::{LegKind, legs_at_corners};
use crate::recipes::kit::{Bay, Builder, SINK, crowned, pipe, rounded_box, sweep};

/// Foam blocks, a futon on a slatted frame, a thin shell on tubes, or a boxy sofa with one long cushion.
pub(super) fn budget(sofa: &Sofa, builder: &mut Builder) {
    let (bay, seat, high) = (sofa.bay, sofa.seat, sofa.bay.high.y);
    match sofa.form {
        0 => futon(sofa, builder),
        1 => {
            builder.cushion(sofa.slot, bay.with_y([0.0, seat * 0.5]), 0.035);
            let folded = bay
                .with_y([seat * 0.5 - 0.004, seat])
                .without(Side::Back, 0.02)
                .inset(0.006, 0.0, 0.0)
                .without(Side::Front, 0.012);
            builder.cushion(sofa.slot, folded, 0.045);
            let back = bay.with_y([seat - 0.02, high]).slab(Side::Back, 0.2).inset(0.01, 0.0, 0.004);
            builder.cushion(sofa.slot, back, 0.06);
        }
        2 => tube_frame(sofa, builder),
        _ => {
            let foot = 0.09;
            legs_at_corners(
                builder,
                Slot::PlasticDark,
                bay.with_y([0.0, foot + SINK]).inset(0.03, 0.0, 0.03),
                0.045,
                LegKind::Tapered,
            );
            let arm = sofa.arm * 0.62;
            let inner = sofa.between(arm);
            sofa.carcass(builder, foot, seat * 0.6, arm);
            for side in [Side::Left, Side::Right] {
                builder.block(
                    sofa.slot,
                    bay.slab(side, arm).with_y([foot + 0.004, sofa.arm_top() * 0.96]),
                    0.012,
                );
            }
            builder.block(
                sofa.slot,
                inner.inset(-0.01, 0.0, 0.0).slab(Side::Back, sofa.back * 0.8).with_y([foot + 0.01, high]),
                0.02,
            );
            let one = inner.with_y([seat * 0.6 - SINK, seat]).without(Side::Back, sofa.back * 0.78);
            builder.add(sofa.slot, crowned(one, 0.025, 0.015));
        }
    }
}

/// A mattress folded on a frame of slats.
fn futon(sofa: &Sofa, builder: &mut Builder) {
    let (bay, seat, high) = (sofa.bay, sofa.seat, sofa.bay.high.y);
    let deck = seat * 0.55;
    for side in [Side::Left, Side::Right] {
        let end = bay.slab(side, 0.045).with_y([0.0, sofa.arm_top()]);
        for post in [Side::Front, Side::Back] {
            builder.cuboid(Slot::WoodLight, end.slab(post, 0.05).without(Side::Above, 0.028 - SINK));
        }
        builder.block(Slot::WoodLight, end.slab(Side::Above, 0.028), 0.005);
        builder.cuboid(Slot::WoodLight, end.with_y([deck - 0.07, deck]).inset(0.006, 0.0, 0.05 - SINK));
    }
    let inner = bay.inset(0.045 - SINK, 0.0, 0.0);
    let seat_slats = inner.with_y([deck - 0.02, deck]).without(Side::Back, 0.08).without(Side::Front, 0.01);
    for slat in super::super::seating::depth_slats(seat_slats, 5, 0.05) {
        builder.cuboid(Slot::WoodLight, slat);
    }
    let back = inner.slab(Side::Back, 0.03).with_y([deck, high - 0.02]);
    for row in back.rows(4, 0.05) {
        builder.cuboid(Slot::WoodLight, row.moved(0.0, 0.0, 0.004));
    }
    let soft = bay.inset(0.05, 0.0, 0.0);
    builder.add(sofa.slot, crowned(soft.with_y([deck - SINK, seat]).without(Side::Back, 0.05), 0.06, 0.03));
    let flat = Bay::new(soft.x(), [0.0, sofa.back - 0.03], [0.0, high - seat + 0.05]);
    builder.add(sofa.slot, crowned(flat, 0.06, 0.03).turned_x(FRAC_PI_2).moved(0.0, high, bay.low.z + 0.031));
}

/// Thin cushions in two hoops of tube.
fn tube_frame(sofa: &Sofa, builder: &mut Builder) {
    let (bay, seat, high) = (sofa.bay, sofa.seat, sofa.bay.high.y);
    let radius = 0.014;
    let x = bay.high.x - radius;
    let top = sofa.arm_top() - radius;
    let side = [
        DVec3::new(x, radius, bay.low.z + 0.14),
        DVec3::new(x, radius, bay.high.z - radius),
        DVec3::new(x, top, bay.high.z - radius),
        DVec3::new(x, top, bay.low.z + 0.12),
        DVec3::new(x, high - 0.05, bay.low.z + radius),
    ];
    builder.add_pair(Slot::Chrome, pipe(&side, radius, 0.08));
    builder.add_pair(
        Slot::PlasticDark,
        rounded_box(
            Bay::new([x - 0.025, bay.high.x], [top, top + 0.03], [bay.low.z + 0.22, bay.high.z - 0.1]),
            DVec3::splat(0.01),
            1,
        ),
    );
    for (y, z) in [
        (seat * 0.72, bay.high.z - 0.12),
        (seat * 0.72, bay.low.z + 0.2),
        (high - 0.1, bay.low.z + 0.03),
        (radius * 1.2, bay.low.z + 0.15),
    ] {
        builder.add(Slot::Chrome, sweep(&[DVec3::new(-x, y, z), DVec3::new(x, y, z)], radius * 0.9, 6));
    }
    for z in [bay.high.z - radius * 1.4, bay.low.z + 0.2] {
        builder.add_pair(
            Slot::Chrome,
            sweep(
                &[DVec3::new(x, seat * 0.72, z), DVec3::new(x - 0.04, seat * 0.72, bay.center().z)],
                radius * 0.7,
                6,
            ),
        );
    }
    let inner = sofa.between(0.03);
    sofa.seat_cushions(builder, inner, seat * 0.72, 0.008);
    sofa.back_cushions(builder, inner, high, 0.05);
}
