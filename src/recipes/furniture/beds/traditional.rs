//! Traditional beds: panels between posts, spindles, an arch, a sleigh.

use glam::{DVec2, DVec3};

use super::Bed;
use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::furniture::parts::{LegKind, leg, legs_at_corners, raised_panel, slab_top, slanted_leg};
use crate::recipes::kit::{Axis, Bay, Builder, SINK, Station, extrude, lathe, sheet};

/// Metres of a post.
const POST: f64 = 0.058;

/// Frame, headboard and a low board at the foot.
pub(super) fn frame(bed: &Bed, builder: &mut Builder) {
    let slot = if bed.form.is_multiple_of(2) { Slot::WoodDark } else { Slot::Wood };
    bed.rails(builder, slot, 0.14, 0.032);
    let body = bed.body();
    let end = body.slab(Side::Front, POST).inset(0.002, 0.0, 0.0).with_y([0.0, bed.frame + 0.012]);
    if bed.form == 3 {
        sleigh(bed, builder, slot);
    } else {
        for side in [Side::Left, Side::Right] {
            leg(builder, slot, end.without(Side::Front, 0.003).slab(side, POST), LegKind::Baluster);
        }
        posts_with_knobs(bed, builder, slot);
    }
    match bed.form {
        0 => panels(bed, builder, slot),
        1 => spindles(bed, builder, slot),
        2 => arch(bed, builder, slot),
        _ => {}
    }
}

fn posts_with_knobs(bed: &Bed, builder: &mut Builder, slot: Slot) {
    let head = bed.head;
    let high = if bed.form == 2 { head.high.y * 0.88 } else { head.high.y };
    let x = head.high.x - POST / 2.0;
    let block =
        Bay::around(DVec3::new(x, high * 0.44, head.center().z), POST - 0.004, high * 0.88, POST - 0.004);
    for side in [-1.0, 1.0] {
        builder.block(slot, block.moved(if side < 0.0 { -2.0 * x } else { 0.0 }, 0.0, 0.0), 0.005);
    }
    let radius = POST / 2.0;
    let knob =
        [(0.7, 0.87), (0.95, 0.885), (0.5, 0.9), (0.45, 0.915), (0.95, 0.945), (0.9, 0.97), (0.3, 1.0)];
    let profile: Vec<(f64, f64)> = knob.iter().map(|&(share, rise)| (share * radius, rise * high)).collect();
    builder.add_pair(slot, lathe(&profile, 6).moved(x, 0.0, head.center().z));
}

fn panels(bed: &Bed, builder: &mut Builder, slot: Slot) {
    let field = bed.head.inset(POST - SINK, 0.0, 0.012).with_y([bed.frame * 0.7, bed.head.high.y * 0.9]);
    builder.cuboid(slot, field.inset(0.0, 0.0, 0.006));
    let count = (field.width() / 0.42).round().clamp(2.0, 4.0) as u32;
    let upper = field.inset(0.03, 0.0, 0.0).with_y([bed.lying * 0.9, field.high.y - 0.03]);
    for column in upper.columns(count, 0.05) {
        raised_panel(builder, slot, column.slab(Side::Front, 0.014));
    }
    let cap = bed.head.inset(POST * 0.4, 0.0, 0.002).with_y([field.high.y - SINK, field.high.y + 0.035]);
    slab_top(builder, slot, cap, true);
}

fn spindles(bed: &Bed, builder: &mut Builder, slot: Slot) {
    let inner = bed.head.inset(POST - SINK, 0.0, 0.014);
    let (low, high) = (bed.lying * 0.78, bed.head.high.y * 0.84);
    for [from, to] in [[low - 0.05, low], [high - 0.05, high]] {
        builder.block(slot, inner.with_y([from, to]), 0.006);
    }
    let count = (inner.width() / 0.15).round().clamp(4.0, 8.0) as u32;
    for column in inner.columns(count, 0.04) {
        let at = |y: f64| DVec3::new(column.center().x, y, column.center().z);
        builder.add(
            slot,
            slanted_leg(
                [at(low - SINK), at(high - 0.05 + SINK)],
                0.014,
                &[(0.6, 0.0), (1.0, 0.35), (0.55, 0.45), (0.9, 0.6), (0.5, 1.0)],
                6,
            ),
        );
    }
}

fn arch(bed: &Bed, builder: &mut Builder, slot: Slot) {
    let (half, high) = (bed.head.width() / 2.0 - POST * 0.7, bed.head.high.y);
    let low = bed.lying * 0.5;
    let spring = high * 0.8;
    let outline = |inset: f64, base: f64| {
        let mut points = vec![DVec2::new(half - inset, base), DVec2::new(half - inset, spring - inset)];
        points.extend((1..10).map(|step| {
            let angle = std::f64::consts::PI * f64::from(step) / 10.0;
            let (sine, cosine) = libm::sincos(angle);
            DVec2::new((half - inset) * cosine, spring - inset + (high - spring) * sine)
        }));
        points.extend([DVec2::new(inset - half, spring - inset), DVec2::new(inset - half, base)]);
        points
    };
    let z = bed.head.z();
    builder.add(slot, extrude(&outline(0.0, low), Axis::Z, [z[0], z[1] - 0.018]));
    builder.add(slot, extrude(&outline(0.09, bed.lying * 0.9), Axis::Z, [z[1] - 0.02, z[1] - 0.002]));
}

/// Head and foot that roll outwards.
fn sleigh(bed: &Bed, builder: &mut Builder, slot: Slot) {
    let (head, half) = (bed.head, bed.head.width() / 2.0);
    let middle = head.low.z + 0.034;
    let high = head.high.y;
    let station = |y: f64, z: f64| Station { at: DVec3::new(0.0, y, z), half_width: half - 0.002, sag: 0.0 };
    let profile = [
        station(0.02, middle + 0.005),
        station(bed.frame, middle + 0.012),
        station(bed.lying, middle + 0.012),
        station(high * 0.8, middle + 0.002),
        station(high - 0.05, middle - 0.014),
    ];
    builder.add(slot, sheet(&profile, DVec3::X, 0.03, 1));
    let radius = 0.03;
    let roll = lathe(
        &[(radius * 0.8, -half), (radius, -half + 0.01), (radius, half - 0.01), (radius * 0.8, half)],
        12,
    );
    builder
        .add(slot, roll.turned_z(std::f64::consts::FRAC_PI_2).moved(0.0, high - radius, head.low.z + radius));
    let body = bed.body();
    let foot = body
        .without(Side::Front, 0.004)
        .slab(Side::Front, 0.015)
        .with_y([0.02, bed.frame + 0.01])
        .inset(0.001, 0.0, 0.0);
    builder.block(slot, foot, 0.006);
    let legs = body.with_y([0.0, bed.frame * 0.4]).inset(0.02, 0.0, 0.02);
    legs_at_corners(builder, slot, legs, 0.07, LegKind::Spade);
}
