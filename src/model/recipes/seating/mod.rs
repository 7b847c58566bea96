//! Chairs and stools.

mod chair;
mod rows;

use glam::DVec3;

pub(super) use chair::chair;
pub(super) use rows::{beam_seats, lounger};

use super::input::Draft;
use super::parts::{LegKind, legs_at_corners};
use crate::catalog::Side;
use crate::model::kit::{Bay, Builder, SINK, cylinder, lathe, sweep};

/// Metres of a comfortable seat over the floor.
pub(super) const SEAT_HEIGHT: f64 = 0.45;
/// Share of the height at most taken by the seat, where the chair is low.
const SEAT_SHARE: f64 = 0.55;
/// Height of a seat in a box of this height.
pub(super) fn seat_height(height: f64) -> f64 {
    SEAT_HEIGHT.min(height * SEAT_SHARE)
}

/// A backless seat: round for square boxes, on four legs with a ring where it is as high as a bar's.
pub(super) fn stool(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let radius = bay.width().min(bay.depth()) / 2.0;
    let thickness = 0.05_f64.min(bay.height() * 0.2);
    let seat = lathe(
        &[
            (radius * 0.94, -thickness),
            (radius, -thickness * 0.7),
            (radius, -thickness * 0.3),
            (radius * 0.9, 0.0),
        ],
        16,
    );
    let slot = if sampler.chance(0.5) { "fabric_accent" } else { "wood" };
    builder.add(
        slot,
        seat.stretched(DVec3::new(bay.width(), radius * 2.0, bay.depth()) / (radius * 2.0))
            .moved(0.0, bay.high.y, 0.0),
    );
    let under = bay.with_y([0.0, bay.high.y - thickness + SINK]);
    let kind = if draft.is_traditional() { LegKind::Turned } else { LegKind::Tapered };
    let legs = under.inset(bay.width() * 0.16, 0.0, bay.depth() * 0.16);
    let thin = (radius * 0.2).min(0.035);
    legs_at_corners(builder, "wood", legs, thin, kind);
    if bay.height() > 0.6 {
        let y = bay.height() * 0.3;
        let ring = legs.with_y([y, y + 0.02]).inset(thin * 0.4, 0.0, thin * 0.4);
        for side in [Side::Left, Side::Right] {
            builder.cuboid("metal", ring.slab(side, thin * 0.4).inset(0.0, 0.0, thin * 0.4));
        }
        let across = ring.moved(0.0, 0.03, 0.0);
        for side in [Side::Front, Side::Back] {
            builder.cuboid("metal", across.slab(side, thin * 0.4).inset(thin * 0.4, 0.0, 0.0));
        }
    }
}

/// A bench of boards on two trestles, with a back where the box is high enough.
pub(super) fn bench(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let has_back = bay.height() > 0.65;
    let seat_top = if has_back { seat_height(bay.height()) } else { bay.height() };
    let board = 0.03_f64.min(seat_top * 0.2);
    let seat =
        bay.with_y([seat_top - board, seat_top]).without(Side::Back, if has_back { 0.04 } else { 0.0 });
    for slat in depth_slats(seat, sampler.count(2, 4), 0.012) {
        builder.cuboid("wood", slat);
    }
    let inset = (bay.width() * 0.12).min(0.2);
    let frame = seat.with_y([0.0, seat.low.y + SINK]).inset(inset, 0.0, 0.02);
    for side in [Side::Left, Side::Right] {
        let trestle = frame.slab(side, 0.05);
        builder.cuboid("metal_dark", trestle.slab(Side::Above, 0.04).inset(0.001, 0.0, 0.001));
        for end in [Side::Front, Side::Back] {
            builder.cuboid("metal_dark", trestle.slab(end, 0.04).without(Side::Above, 0.04 - SINK));
        }
    }
    if has_back {
        for side in [Side::Left, Side::Right] {
            let post = bay.inset(inset, 0.0, 0.0).slab(side, 0.05).slab(Side::Back, 0.025);
            builder.cuboid("metal_dark", post.with_y([seat_top - board - 0.05, bay.high.y - 0.02]));
        }
        let back = bay
            .slab(Side::Back, 0.045)
            .without(Side::Back, 0.025 - SINK)
            .with_y([seat_top + 0.1, bay.high.y]);
        for row in back.rows(2, 0.03) {
            builder.cuboid("wood", row);
        }
    }
}

/// Boards side by side from front to back.
pub(super) fn depth_slats(bay: Bay, count: u32, gap: f64) -> Vec<Bay> {
    let depth = (bay.depth() - gap * f64::from(count - 1)) / f64::from(count);
    let back = |index: u32| bay.low.z + f64::from(index) * (depth + gap);
    (0..count).map(|index| bay.with_z([back(index), back(index) + depth])).collect()
}

/// A swivel chair: five castors on a star, a gas spring, seat, back and arm rests.
pub(super) fn office_chair(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let seat_top = SEAT_HEIGHT.min(bay.height() * 0.5);
    star(builder, bay);
    builder.add("metal", cylinder(0.026, [0.09, seat_top - 0.078], 8));
    builder.cuboid("plastic_dark", Bay::around(DVec3::new(0.0, seat_top - 0.085, 0.0), 0.16, 0.04, 0.22));
    let seat_slot = sampler.pick(&["fabric", "fabric_accent", "leather"]);
    let seat = bay.inset(bay.width() * 0.12, 0.0, bay.depth() * 0.1).with_y([seat_top - 0.07, seat_top]);
    builder.cushion(seat_slot, seat, 0.03);
    let low = seat_top + sampler.between(0.08, 0.14);
    let back = bay.with_y([low, bay.high.y]).inset(bay.width() * 0.14, 0.0, 0.0).slab(Side::Back, 0.055);
    builder.cushion(seat_slot, back, 0.025);
    let spine = bay.low.z + 0.075;
    let path = [
        DVec3::new(0.0, seat_top - 0.085, -0.08),
        DVec3::new(0.0, seat_top - 0.085, spine),
        DVec3::new(0.0, low + 0.12, bay.low.z + 0.05),
    ];
    builder.add("plastic_dark", sweep(&path, 0.022, 4));
    let (x, rest) = (bay.high.x - 0.025, seat_top + 0.2);
    let bow = [
        DVec3::new(bay.high.x * 0.4, seat_top - 0.085, 0.0),
        DVec3::new(x, seat_top - 0.085, 0.0),
        DVec3::new(x, rest - 0.02, 0.0),
    ];
    builder.add_pair("plastic_dark", sweep(&bow, 0.014, 6));
    let pad = Bay::around(DVec3::new(x, rest - 0.01, 0.0), 0.05, 0.03, bay.depth() * 0.42);
    builder.add_pair("plastic_dark", crate::model::kit::rounded_box(pad, DVec3::splat(0.01), 1));
}

/// The foot of an office chair: the foremost castor touches the front of the box.
fn star(builder: &mut Builder, bay: Bay) {
    let castor = 0.026;
    let radius = bay.depth().min(bay.width()) / 2.0 - castor;
    builder.add("metal_dark", lathe(&[(0.05, 0.065), (0.05, 0.105), (0.03, 0.125)], 10));
    for arm in 0..5 {
        let angle = std::f64::consts::TAU * f64::from(arm) / 5.0;
        let bar = Bay::new([-0.018, 0.018], [0.07, 0.1], [0.042, radius + 0.012]);
        builder.add("metal_dark", crate::model::kit::cuboid(bar).turned_y(angle));
        let wheel = cylinder(castor, [-0.02, 0.02], 8).turned_z(std::f64::consts::FRAC_PI_2);
        builder.add("rubber", wheel.moved(0.0, castor, radius).turned_y(angle));
        let stem = Bay::new([-0.006, 0.006], [castor * 1.6, 0.0705], [radius - 0.006, radius + 0.006]);
        builder.add("metal_dark", crate::model::kit::cuboid(stem).turned_y(angle));
    }
}

/// A fixed seat in a row: folded-up arm rests on both sides, seat and high back on a pedestal.
pub(super) fn auditorium_seat(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let seat_top = seat_height(bay.height());
    let slot = draft.sampler().pick(&["fabric_accent", "fabric"]);
    for side in [Side::Left, Side::Right] {
        let cheek = bay.slab(side, 0.045).without(Side::Front, bay.depth() * 0.12);
        let panel = cheek.with_y([0.01, seat_top + 0.13]).inset(0.008, 0.0, 0.0).without(Side::Front, 0.06);
        builder.cuboid("painted", panel);
        builder.block("wood_dark", cheek.with_y([seat_top + 0.1295, seat_top + 0.16]), 0.006);
        builder.cuboid("metal_dark", panel.with_y([0.0, 0.015]).inset(-0.006, 0.0, -0.01));
    }
    let inner = bay.inset(0.05, 0.0, 0.0);
    let seat = inner.with_y([seat_top - 0.09, seat_top]).without(Side::Back, 0.13);
    builder.cushion(slot, seat, 0.03);
    let back = inner.with_y([seat_top - 0.03, bay.high.y]);
    builder.cushion(slot, back.slab(Side::Back, 0.12).without(Side::Back, 0.02 - SINK), 0.03);
    builder.block("wood", back.slab(Side::Back, 0.02).inset(0.01, 0.01, 0.0), 0.004);
    let bar = inner.inset(-0.02, 0.0, 0.0).with_y([seat_top - 0.16, seat_top - 0.12]).slab(Side::Back, 0.16);
    builder.cuboid("metal_dark", bar.slab(Side::Front, 0.04));
}
