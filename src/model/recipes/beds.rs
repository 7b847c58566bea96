//! Beds.

use glam::DVec3;

use super::input::Draft;
use super::parts::{LegKind, legs_at_corners, turned_forward};
use crate::catalog::Side;
use crate::model::kit::{Bay, Builder, Outline, SINK, Sampler, Slice, cylinder, loft, rounded_box};

/// Metres of a bed's headboard; the shapes in the catalogue are cut for it.
const HEADBOARD: f64 = 0.06;
/// Metres of the top of the bedding over the floor.
const LYING_HEIGHT: f64 = 0.55;
/// The same as a share of the height, where the bed is low.
const LYING_SHARE: f64 = 0.6;
/// Width in metres from which a bed has two pillows.
const DOUBLE_FROM: f64 = 1.3;

/// A bed with headboard, mattress, blanket and pillows; `double` asks for two pillows.
pub(super) fn bed(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let lying = LYING_HEIGHT.min(bay.height() * LYING_SHARE);
    let body = bay.with_y([0.0, lying]).without(Side::Back, HEADBOARD - SINK);
    headboard(draft, builder, bay.slab(Side::Back, HEADBOARD));
    let foot = (lying * 0.22).min(0.12);
    let frame_top = lying * 0.52;
    let kind = if draft.is_traditional() { LegKind::Turned } else { LegKind::Tapered };
    legs_at_corners(builder, "wood", body.with_y([0.0, foot + SINK]).inset(0.03, 0.0, 0.03), 0.06, kind);
    builder.block(
        "wood",
        body.with_y([foot, frame_top]).inset(0.004, 0.0, 0.0).without(Side::Front, 0.002),
        0.008,
    );
    let bedding = body.with_y([frame_top - SINK, lying]);
    builder.cushion("mattress", bedding.inset(0.012, 0.0, 0.012).without(Side::Above, 0.02), 0.03);
    let blanket =
        bedding.without(Side::Back, body.depth() * sampler.between(0.26, 0.34)).without(Side::Below, 0.03);
    builder.cushion(sampler.pick(&["fabric", "fabric_accent", "linen"]), blanket, 0.035);
    let fold = blanket.slab(Side::Back, 0.28).with_y([lying - 0.04, lying + 0.006]).moved(0.0, 0.0, -0.02);
    builder.cushion("linen", fold.inset(0.003, 0.0, 0.0), 0.02);
    let is_double = draft.is_set("double") || bay.width() >= DOUBLE_FROM;
    pillows(builder, &mut sampler, bedding, if is_double { 2 } else { 1 });
}

/// Pillows at the head of a mattress, leaning a little on the headboard.
fn pillows(builder: &mut Builder, sampler: &mut Sampler, bedding: Bay, count: u32) {
    let depth = (bedding.depth() * 0.22).min(0.42);
    let top = bedding.high.y;
    let row = bedding.slab(Side::Back, depth).inset(0.06, 0.0, 0.0).moved(0.0, 0.0, 0.03);
    for column in row.columns(count, 0.06) {
        let width = column.width().min(0.75);
        let height = (depth * 0.35).min(0.13);
        let middle = column.center();
        let flat = Bay::around(DVec3::ZERO, width, height, depth);
        let pillow = rounded_box(flat, DVec3::new(depth * 0.25, height, depth * 0.25), 2);
        let tilt = 0.12 + sampler.between(0.0, 0.08);
        builder.add("linen", pillow.turned_x(tilt).moved(middle.x, top + height * 0.36, middle.z));
    }
}

fn headboard(draft: &Draft, builder: &mut Builder, bay: Bay) {
    let mut sampler = draft.sampler();
    if draft.is_traditional() {
        let post = 0.06_f64.min(bay.width() * 0.1);
        for side in [Side::Left, Side::Right] {
            builder.cuboid("wood", bay.slab(side, post).without(Side::Above, 0.05));
        }
        let board = bay.inset(post - SINK, 0.0, 0.012).without(Side::Above, 0.07).without(Side::Below, 0.2);
        builder.block("wood", board, 0.006);
        let middle = bay.center();
        let half = bay.extent() / 2.0;
        let cap = [(0.0, -0.006), (0.4, -0.004), (1.0, 0.0)].map(|(share, back)| {
            Slice::new(bay.high.y - 0.075 * (1.0 - share), half.x + back, half.z + back)
        });
        builder.add("wood", loft(&Outline::Square, &cap).moved(middle.x, 0.0, middle.z));
        return;
    }
    match sampler.count(0, 2) {
        0 => builder.block("wood", bay, 0.01),
        1 => {
            builder.cuboid("wood", bay.slab(Side::Back, 0.02).without(Side::Above, 0.03));
            let pads = bay.without(Side::Back, 0.02 - SINK).without(Side::Below, 0.15);
            for column in pads.columns((bay.width() / 0.4).round().clamp(2.0, 6.0) as u32, 0.004) {
                builder.block("fabric", column, 0.014);
            }
        }
        _ => {
            for side in [Side::Left, Side::Right] {
                builder.cuboid("wood", bay.slab(side, 0.05));
            }
            let boards =
                bay.inset(0.05 - SINK, 0.0, 0.016).without(Side::Below, 0.2).without(Side::Above, 0.01);
            for row in boards.rows(3, 0.03) {
                builder.cuboid("wood", row);
            }
        }
    }
}

/// A child's bed behind bars.
pub(super) fn crib(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let post = 0.04;
    let kind = if draft.is_traditional() { LegKind::Turned } else { LegKind::Square };
    legs_at_corners(builder, "wood_light", bay, post, kind);
    let inner = bay.inset(post * 0.3, 0.0, post * 0.3).without(Side::Above, 0.004);
    let bed = bay.height() * 0.4;
    for side in [Side::Left, Side::Right] {
        let end = inner.slab(side, post * 0.4).inset(0.0, 0.0, post * 0.7 - SINK);
        builder.cuboid("wood_light", end.with_y([bed - 0.1, bay.high.y - 0.02]));
    }
    for side in [Side::Front, Side::Back] {
        let fence = inner.slab(side, post * 0.4).inset(post * 0.7 - SINK, 0.0, 0.0);
        builder.cuboid("wood_light", fence.slab(Side::Above, 0.03));
        builder.cuboid("wood_light", fence.with_y([bed - 0.12, bed - 0.08]));
        let bars = fence.with_y([bed - 0.08 - SINK, fence.high.y - 0.03 + SINK]).inset(0.05, 0.0, 0.002);
        for bar in bars.columns((bay.width() / 0.11).round().clamp(4.0, 12.0) as u32, 0.09) {
            builder.cuboid("wood_light", Bay::around(bar.center(), 0.012, bar.height(), 0.012));
        }
    }
    let mattress = bay.inset(post + 0.003, 0.0, post + 0.003).with_y([bed - 0.09, bed + 0.02]);
    builder.cushion("mattress", mattress, 0.03);
    let blanket = mattress
        .slab(Side::Left, mattress.width() * 0.6)
        .inset(-0.002, 0.0, -0.002)
        .with_y([bed - 0.01, bed + 0.035]);
    builder.cushion(sampler.pick(&["fabric_light", "fabric_accent"]), blanket, 0.02);
}

/// Two beds over each other with a ladder.
pub(super) fn bunk_bed(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let post = 0.06;
    legs_at_corners(builder, "wood", bay, post, LegKind::Square);
    let rail_depth = 0.025;
    for (base, is_upper) in [(bay.height() * 0.17, false), (bay.height() * 0.66, true)] {
        let ring = bay.inset(0.012, 0.0, 0.012).with_y([base, base + 0.12]);
        for side in [Side::Left, Side::Right] {
            builder.cuboid("wood", ring.slab(side, rail_depth).inset(0.0, 0.0, post - 0.012 - SINK));
        }
        for side in [Side::Front, Side::Back] {
            builder.cuboid("wood", ring.slab(side, rail_depth).inset(post - 0.012 - SINK, 0.0, 0.0));
        }
        let mattress = bay.inset(0.04, 0.0, 0.04).with_y([base + 0.03, base + 0.2]);
        builder.cushion("mattress", mattress, 0.03);
        let blanket = mattress.without(Side::Back, mattress.depth() * 0.32).inset(-0.002, 0.0, -0.002);
        builder.cushion(
            sampler.pick(&["fabric", "fabric_accent"]),
            blanket.with_y([base + 0.13, base + 0.22]),
            0.03,
        );
        let pillow =
            mattress.slab(Side::Back, 0.34).inset(0.08, 0.0, 0.03).with_y([base + 0.195, base + 0.3]);
        builder.cushion("linen", pillow, 0.045);
        if is_upper {
            let guard = bay.inset(0.012, 0.0, 0.012).with_y([bay.high.y - 0.12, bay.high.y - 0.03]);
            builder.cuboid("wood", guard.slab(Side::Left, rail_depth).inset(0.0, 0.0, post - 0.012 - SINK));
            let right = guard.slab(Side::Right, rail_depth).without(Side::Front, bay.depth() * 0.3);
            builder.cuboid("wood", right.without(Side::Back, post - 0.012 - SINK));
        }
    }
    let ladder = bay
        .slab(Side::Right, 0.012 + SINK)
        .with_z([bay.high.z - bay.depth() * 0.28, bay.high.z - post - 0.03]);
    let ladder = ladder.with_y([0.0, bay.high.y - 0.02]);
    for side in [Side::Front, Side::Back] {
        builder.cuboid("wood", ladder.slab(side, 0.035));
    }
    for rung in ladder.inset(0.002, 0.1, 0.034).rows(5, 0.22) {
        builder.cuboid("wood", Bay::around(rung.center(), rung.width(), 0.03, rung.depth()));
    }
}

/// An examination couch on steel legs, its head end raised, with a roll of paper.
pub(super) fn treatment_bed(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let slot = draft.sampler().pick(&["leather", "plastic"]);
    let lying = bay.height() * 0.82;
    let pad = (bay.height() * 0.12).min(0.1);
    let head = bay.depth() * 0.3;
    let couch = bay.with_y([lying - pad, lying]);
    builder.cushion(slot, couch.without(Side::Back, head), 0.03);
    let slope = libm::asin(((bay.height() - lying) / head).clamp(0.0, 0.9));
    let rest = rounded_box(Bay::new(bay.x(), [-pad, 0.0], [-head, -0.012]), DVec3::splat(0.03), 2);
    builder.add(slot, rest.turned_x(slope).moved(0.0, lying, bay.low.z + head));
    let frame = bay.with_y([lying - pad - 0.04, lying - pad + SINK]).inset(0.05, 0.0, 0.06);
    builder.cuboid("metal", frame);
    let legs = frame.with_y([0.0, frame.low.y + SINK]).inset(0.002, 0.0, 0.002);
    legs_at_corners(builder, "chrome", legs, 0.04, LegKind::Round);
    let roll =
        turned_forward(cylinder(0.04, [0.0, bay.width() * 0.7], 10)).turned_y(std::f64::consts::FRAC_PI_2);
    let z = bay.low.z + 0.045;
    builder.add("paper", roll.moved(-bay.width() * 0.35, frame.low.y - 0.035, z));
}
