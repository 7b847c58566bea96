//! Chairs and stools.

mod chair;
mod rows;

use glam::DVec3;

pub(super) use chair::chair;
pub(super) use rows::{beam_seats, lounger};

use super::input::{Draft, GeometrySet};
use super::parts::{CONE, LegKind, SPINDLE, leg, slanted_leg};
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

/// A backless seat: round for square boxes, on legs of the set, with a foot ring where it is as high as a bar's.
pub(super) fn stool(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let form = draft.input.look as usize % 4;
    let radius = bay.width().min(bay.depth()) / 2.0;
    let thickness = [0.05_f64, 0.035, 0.06, 0.03][form].min(bay.height() * 0.2);
    let profile =
        [(0.94, -1.0), (1.0, -0.7), (1.0, -0.3), (0.9, -0.02), (0.4, if form == 3 { -0.3 } else { 0.0 })];
    let slot = match draft.set() {
        GeometrySet::Plain => ["fabric_accent", "wood", "leather", "wood_light"][form],
        GeometrySet::Traditional => ["wood", "fabric_light", "leather", "wood_dark"][form],
        GeometrySet::Industrial => ["wood", "metal_dark", "leather", "wood"][form],
        GeometrySet::Budget => ["plastic", "painted_accent", "plastic_dark", "plastic"][form],
    };
    let seat = lathe(&profile.map(|(share, rise)| (share * radius, rise * thickness)), 16);
    let stretch = DVec3::new(bay.width(), radius * 2.0, bay.depth()) / (radius * 2.0);
    builder.add(slot, seat.stretched(stretch).moved(0.0, bay.high.y, 0.0));
    let under = bay.with_y([0.0, bay.high.y - thickness + SINK]);
    if form == 2 && draft.set() != GeometrySet::Traditional {
        stool_column(draft, builder, under, radius);
    } else {
        stool_legs(draft, builder, under, form);
    }
}

/// A column on a disc, with a ring for the feet on high ones.
fn stool_column(draft: &Draft, builder: &mut Builder, under: Bay, radius: f64) {
    let slot = if draft.set() == GeometrySet::Plain { "chrome" } else { "metal_dark" };
    let high = under.high.y;
    let foot = [
        (radius * 0.98, 0.0),
        (radius * 0.96, 0.012),
        (radius * 0.25, 0.03),
        (0.022, 0.05),
        (0.022, high * 0.55),
        (0.016, high * 0.56),
        (0.016, high - 0.02),
        (radius * 0.4, high),
    ];
    builder.add(slot, lathe(&foot, 12));
    if high > 0.55 {
        let y = high * 0.35;
        builder.add(
            slot,
            lathe(&[(radius * 0.6, y - 0.008), (radius * 0.66, y), (radius * 0.6, y + 0.008)], 12),
        );
    }
}

/// Four slanted legs with stretchers.
fn stool_legs(draft: &Draft, builder: &mut Builder, under: Bay, form: usize) {
    let (slot, profile, thick): (_, &[(f64, f64)], _) = match draft.set() {
        GeometrySet::Plain => (["wood", "wood", "wood", "metal_dark"][form], &CONE, 0.019),
        GeometrySet::Traditional => (["wood", "wood", "wood_dark", "wood_dark"][form], &SPINDLE, 0.021),
        GeometrySet::Industrial => ("metal_dark", &[(1.0, 0.0), (1.0, 1.0)], 0.014),
        GeometrySet::Budget => (
            ["chrome", "metal", "plastic_dark", "plastic"][form],
            &[(1.0, 0.0), (1.0, 1.0)],
            [0.01, 0.01, 0.01, 0.02][form],
        ),
    };
    let spread = [0.95, 0.8, 0.9, 0.86][form] * std::f64::consts::FRAC_1_SQRT_2;
    let (x, z) = (under.high.x, under.high.z);
    let at = |share: f64, y: f64, end: f64| DVec3::new(x * share, y, end * z * share);
    for end in [-1.0, 1.0] {
        let ends = [at(spread, 0.0, end), at(spread * 0.66, under.high.y, end)];
        builder.add_pair(slot, slanted_leg(ends, thick, profile, 8));
    }
    let rise = if under.high.y > 0.55 { 0.34 } else { 0.45 };
    let share = spread * (1.0 - 0.34 * rise);
    let y = under.high.y * rise;
    let bar = thick * 0.55;
    for end in [-1.0, 1.0] {
        builder.add(slot, sweep(&[at(-share, y, end), at(share, y, end)], bar, 6));
        let side = y + thick * 1.5;
        builder.add(
            slot,
            sweep(
                &[
                    DVec3::new(end * x * share, side, -z * share),
                    DVec3::new(end * x * share, side, z * share),
                ],
                bar,
                6,
            ),
        );
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
    let form = draft.input.look as usize % 4;
    let frame = seat.with_y([0.0, seat.low.y + SINK]).inset(inset, 0.0, 0.02);
    let (slot, kind) = match draft.set() {
        GeometrySet::Plain => (["metal_dark", "wood", "painted", "wood"][form], LegKind::Tapered),
        GeometrySet::Traditional => {
            ("wood_dark", [LegKind::Turned, LegKind::Baluster, LegKind::Spade, LegKind::Turned][form])
        }
        GeometrySet::Industrial => {
            ("metal_dark", [LegKind::Angle, LegKind::Pipe, LegKind::Hairpin, LegKind::Square][form])
        }
        GeometrySet::Budget => (["metal", "plastic", "painted", "wood_light"][form], LegKind::Square),
    };
    for side in [Side::Left, Side::Right] {
        let trestle = frame.slab(side, 0.05);
        builder.cuboid(
            slot,
            trestle.slab(Side::Above, 0.04).without(Side::Above, 0.001).inset(0.0015, 0.0, 0.0015),
        );
        for end in [Side::Front, Side::Back] {
            leg(builder, slot, trestle.slab(end, 0.05), kind);
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
