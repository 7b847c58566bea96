//! Upholstered seats.

use super::input::Draft;
use super::parts::{LegKind, legs_at_corners};
use super::seating::seat_height;
use crate::catalog::Side;
use crate::model::kit::{Bay, Builder, SINK, Sampler, cylinder, rounded_box};
use glam::DVec3;

/// Metres that one person takes on a sofa.
const PERSON: f64 = 0.65;
/// Metres of air between neighbouring cushions.
const SEAM: f64 = 0.004;

/// A sofa; `seats` cushions, or as many as its width holds.
pub(super) fn sofa(draft: &Draft, builder: &mut Builder) {
    let arm = arm_width(builder.bay());
    let width = builder.bay().width() - 2.0 * arm;
    let choice = (width / PERSON).round().clamp(1.0, 6.0) as u32;
    upholstered(draft, builder, draft.count("seats", choice));
}

/// A sofa for one.
pub(super) fn armchair(draft: &Draft, builder: &mut Builder) {
    upholstered(draft, builder, 1);
}

fn arm_width(bay: Bay) -> f64 {
    (bay.width() * 0.16).min(0.18)
}

fn upholstered(draft: &Draft, builder: &mut Builder, seats: u32) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let slot = sampler.pick(&["fabric", "fabric", "leather"]);
    let seat_top = seat_height(bay.height());
    let foot = (seat_top * 0.25).min(sampler.between(0.06, 0.12));
    let arm = arm_width(bay);
    let kind = if draft.is_traditional() { LegKind::Turned } else { LegKind::Tapered };
    let thin = 0.05_f64.min(arm * 0.6);
    legs_at_corners(builder, "wood_dark", bay.with_y([0.0, foot + SINK]).inset(0.02, 0.0, 0.02), thin, kind);
    let back_depth = (bay.depth() * 0.24).min(0.22);
    let base = bay.with_y([foot, seat_top * 0.62]).inset(arm * 0.5, 0.0, 0.006);
    builder.block(slot, base, 0.01);
    arms(draft, builder, slot, bay.with_y([foot + 0.006, seat_top + bay.height() * 0.2]));
    let inner = bay.inset(arm + SEAM, 0.0, 0.0);
    let back = inner.slab(Side::Back, back_depth);
    builder.block(
        slot,
        back.slab(Side::Back, back_depth * 0.45).with_y([base.high.y - SINK, bay.high.y * 0.96]),
        0.02,
    );
    let seat = inner.without(Side::Back, back_depth * 0.9).with_y([base.high.y - SINK, seat_top]);
    for column in seat.columns(seats, SEAM) {
        builder.cushion(slot, column, 0.03);
    }
    let lean = back.without(Side::Back, back_depth * 0.45 - SINK).with_y([seat_top - 0.02, bay.high.y]);
    for column in lean.without(Side::Front, back_depth * 0.1 + SEAM).columns(seats, SEAM) {
        builder.cushion(slot, column, 0.045);
    }
    if seats > 1 && !draft.is_traditional() {
        throw_pillows(builder, &mut sampler, inner, [seat_top, back.high.z]);
    }
}

/// Both arms; rolled in the traditional set.
fn arms(draft: &Draft, builder: &mut Builder, slot: &'static str, bay: Bay) {
    let arm = arm_width(bay);
    for side in [Side::Left, Side::Right] {
        let body = bay.slab(side, arm);
        if draft.is_traditional() {
            let radius = arm / 2.0;
            let roll =
                cylinder(radius, [bay.low.z + 0.002, bay.high.z], 12).turned_x(std::f64::consts::FRAC_PI_2);
            builder.add(slot, roll.moved(body.center().x, bay.high.y - radius, 0.0));
            builder.block(slot, body.inset(arm * 0.14, 0.0, 0.004).without(Side::Above, radius), 0.01);
        } else {
            builder.cushion(slot, body, 0.03);
        }
    }
}

/// A loose pillow or two against the back.
fn throw_pillows(builder: &mut Builder, sampler: &mut Sampler, inner: Bay, [seat, back]: [f64; 2]) {
    let side = 0.38_f64.min(inner.width() * 0.3);
    let pillow = rounded_box(
        Bay::new([-side / 2.0, side / 2.0], [0.0, side], [-0.06, 0.06]),
        DVec3::new(0.06, 0.06, 0.055),
        2,
    );
    let leaning = pillow.turned_x(-0.35).moved(0.0, seat + 0.02, back + 0.14);
    let x = inner.high.x - side * 0.6;
    builder.add("fabric_accent", leaning.clone().turned_y(0.0).moved(x, 0.0, 0.0));
    if sampler.chance(0.6) {
        builder.add("fabric_light", leaning.moved(-x, 0.0, 0.0));
    }
}
