//! Lamps.

use glam::DVec3;

use super::input::Draft;
use super::parts::turned_forward;
use crate::model::kit::{Bay, Builder, Outline, SINK, Slice, Solid, cylinder, lathe, loft, loft_ring, sweep};

/// Corners of shades and feet.
const SIDES: usize = 12;

/// A lamp shade, open above and below, by radii and heights.
fn shade(radii: [f64; 2], y: [f64; 2]) -> Solid {
    let wall = 0.004_f64.min(radii[0].min(radii[1]) * 0.1);
    let slices = [
        Slice::round(y[0], radii[0]),
        Slice::round(y[1], radii[1]),
        Slice::round(y[1], radii[1] - wall),
        Slice::round(y[0], radii[0] - wall),
    ];
    loft_ring(&Outline::Round(SIDES), &slices)
}

/// A bulb with its socket above (+1) or below (−1) it.
fn bulb(builder: &mut Builder, middle: DVec3, radius: f64, socket: f64) {
    let half = [(0.0, -1.0), (0.8, -0.55), (0.95, 0.1), (0.5, 0.85), (0.32, 1.2)];
    let profile = half.map(|(share, rise)| (share * radius, rise * radius * socket));
    builder.add("lamp", lathe(&profile, 6).moved(middle.x, middle.y, middle.z));
    let ends = [1.15 * radius * socket, 2.2 * radius * socket];
    let ends = [ends[0].min(ends[1]), ends[0].max(ends[1])];
    builder.add("metal_dark", cylinder(radius * 0.45, ends, 6).moved(middle.x, middle.y, middle.z));
}

/// A lamp flat under the ceiling: a glass bowl on a metal rim.
pub(super) fn ceiling_lamp(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let (half, height) = (bay.extent() / 2.0, bay.height());
    let slice = |share: f64, shrink: f64| Slice::new(share * height, half.x * shrink, half.z * shrink);
    let slot = if draft.is_traditional() { "brass" } else { draft.sampler().pick(&["metal", "painted"]) };
    let rim = [slice(0.72, 1.0), slice(0.82, 1.0), slice(1.0, 0.9)];
    builder.add(slot, loft(&Outline::Round(SIDES), &rim));
    let bowl = [
        slice(if draft.is_traditional() { 0.06 } else { 0.0 }, 0.45),
        slice(0.16, 0.72),
        slice(0.42, 0.9),
        slice(0.76, 0.94),
    ];
    builder.add("lamp", loft(&Outline::Round(SIDES), &bowl));
    if draft.is_traditional() {
        let finial = lathe(&[(0.004, 0.0), (0.014, height * 0.03), (0.006, height * 0.08)], 8);
        builder.add("brass", finial);
    }
}

/// A flat square light in an office ceiling.
pub(super) fn ceiling_panel(_draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let half = bay.extent() / 2.0;
    let border = half.x.min(half.z) * 0.06;
    let slice = |share: f64, back: f64| Slice::new(share * bay.height(), half.x - back, half.z - back);
    let frame = [slice(0.0, 0.0), slice(1.0, 0.0), slice(1.0, border), slice(0.0, border)];
    builder.add("painted", loft_ring(&Outline::Square, &frame));
    builder.cuboid("lamp", bay.inset(border - SINK, bay.height() * 0.2, border - SINK));
}

/// A shade on a cord.
pub(super) fn pendant(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let radius = bay.width().min(bay.depth()) / 2.0;
    let shade_height = (radius * sampler.between(0.8, 1.3)).min(bay.height() * 0.5);
    let narrow = sampler.between(0.25, 0.7);
    let slot = if draft.is_traditional() {
        "shade"
    } else {
        sampler.pick(&["shade", "metal_dark", "painted_accent"])
    };
    builder.add(slot, shade([radius, radius * narrow], [0.0, shade_height]));
    let spider = shade_height * 0.9;
    let across = radius * (1.0 - (1.0 - narrow) * 0.9) - 0.001;
    builder
        .cuboid("metal_dark", Bay::new([-across, across], [spider - 0.003, spider + 0.003], [-0.003, 0.003]));
    let bulb_radius = (radius * 0.28).min(0.035);
    bulb(builder, DVec3::new(0.0, spider - bulb_radius * 2.0, 0.0), bulb_radius, 1.0);
    builder.add("metal_dark", cylinder(0.004, [spider, bay.high.y - 0.01], 6));
    let canopy = [(radius * 0.35, bay.high.y), (radius * 0.3, bay.high.y - 0.02), (0.008, bay.high.y - 0.03)];
    builder.add("metal_dark", lathe(&canopy.map(|(radius, y)| (radius.min(0.06), y)), 12));
}

/// A lamp that stands on the floor.
pub(super) fn floor_lamp(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let radius = bay.width().min(bay.depth()) / 2.0;
    let shade_height = (radius * 1.3).min(bay.height() * 0.3);
    let top = bay.high.y;
    let slot = if draft.is_traditional() { "brass" } else { sampler.pick(&["metal_dark", "brass", "wood"]) };
    builder.add("shade", shade([radius, radius * sampler.between(0.65, 0.9)], [top - shade_height, top]));
    let foot = radius * 0.75;
    builder.add(slot, lathe(&[(foot, 0.0), (foot, 0.012), (foot * 0.3, 0.026), (0.012, 0.05)], 10));
    let bulb_at = top - shade_height * 0.5;
    builder.add(slot, cylinder(0.011, [0.04, bulb_at - 0.06], 6));
    if draft.is_traditional() {
        let y = bulb_at * 0.5;
        builder.add(slot, lathe(&[(0.012, y), (0.028, y + 0.03), (0.012, y + 0.06)], 6));
    }
    bulb(builder, DVec3::new(0.0, bulb_at, 0.0), 0.03, -1.0);
}

/// A lamp for a desk or bedside table: jointed arms, or a shade on a foot.
pub(super) fn desk_lamp(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let is_jointed =
        !draft.is_traditional() && bay.height() > bay.width() && draft.sampler().count(0, 1) == 0;
    if is_jointed { jointed_lamp(draft, builder, bay) } else { table_lamp(draft, builder, bay) }
}

fn jointed_lamp(draft: &Draft, builder: &mut Builder, bay: Bay) {
    let slot = draft.sampler().pick(&["metal_dark", "painted_accent", "metal"]);
    let (width, height, depth) = (bay.width(), bay.height(), bay.depth());
    let foot = width.min(depth) / 2.0;
    let base = bay.low.z + foot;
    builder.add(
        slot,
        lathe(&[(foot, 0.0), (foot, height * 0.03), (foot * 0.85, height * 0.05)], SIDES)
            .moved(0.0, 0.0, base),
    );
    let head = bay.high.z - foot * 0.34;
    let elbow = DVec3::new(0.0, height * 0.55, bay.low.z + 0.02);
    let neck = DVec3::new(0.0, height - foot * 0.2, head - foot * 0.3);
    builder.add(slot, sweep(&[DVec3::new(0.0, height * 0.04, base), elbow, neck], 0.008, 6));
    let cone = [(foot * 0.8, -foot * 0.9), (foot * 0.3, 0.0), (foot * 0.2, foot * 0.35), (0.0, foot * 0.4)];
    let inside = [(foot * 0.25, -foot * 0.15), (foot * 0.76, -foot * 0.9)];
    let profile: Vec<(f64, f64)> = inside.iter().chain(&cone).copied().collect();
    let tilted = |solid: Solid| solid.turned_x(0.35).moved(0.0, neck.y - foot * 0.2, head - foot * 0.1);
    builder.add(slot, tilted(lathe(&profile, 12)));
    builder
        .add("lamp", tilted(lathe(&[(0.0, -foot * 0.75), (foot * 0.3, -foot * 0.5), (0.0, -foot * 0.2)], 8)));
}

fn table_lamp(draft: &Draft, builder: &mut Builder, bay: Bay) {
    let mut sampler = draft.sampler();
    let (radius, height) = (bay.width() / 2.0, bay.height());
    // Drawn round and stretched where the box is not square.
    let stretch = DVec3::new(1.0, 1.0, bay.depth() / bay.width());
    let mut round = builder.empty();
    let slot = if draft.is_traditional() { "brass" } else { sampler.pick(&["ceramic", "wood", "brass"]) };
    round.add("shade", shade([radius, radius * 0.68], [height * 0.55, height]));
    let body = radius * sampler.between(0.4, 0.62);
    let profile = [
        (body * 0.9, 0.0),
        (body * 0.9, height * 0.03),
        (body * 0.5, height * 0.06),
        (body, height * 0.22),
        (body * 0.8, height * 0.38),
        (body * 0.2, height * 0.5),
        (body * 0.2, height * 0.62),
    ];
    round.add(slot, lathe(&profile, 10));
    bulb(&mut round, DVec3::new(0.0, height * 0.76, 0.0), radius * 0.2, -1.0);
    round.into_parts().for_each(|(slot, solid)| builder.add(slot, solid.stretched(stretch)));
}

/// A lamp on a wall: a shade on an arm.
pub(super) fn wall_lamp(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let slot = if draft.is_traditional() {
        "brass"
    } else {
        draft.sampler().pick(&["metal", "metal_dark", "brass"])
    };
    let (half_width, height) = (bay.width() / 2.0, bay.height());
    let radius = half_width.min(bay.depth() * 0.42);
    let z = bay.high.z - radius;
    let plate = (height * 0.18).min(half_width * 0.9);
    let disc = turned_forward(cylinder(plate, [0.0, 0.015_f64.min(bay.depth() * 0.1)], 12));
    builder.add(slot, disc.moved(0.0, height * 0.35, bay.low.z));
    let arm = [
        DVec3::new(0.0, height * 0.35, bay.low.z + 0.005),
        DVec3::new(0.0, height * 0.18, (bay.low.z + z) / 2.0),
        DVec3::new(0.0, height * 0.18, z),
        DVec3::new(0.0, height * 0.45, z),
    ];
    builder.add(slot, sweep(&arm, radius * 0.07, 6));
    builder.add(
        "shade",
        shade([radius, radius * 0.6], [height * 0.4, height])
            .stretched(DVec3::new(half_width / radius, 1.0, 1.0))
            .moved(0.0, 0.0, z),
    );
    bulb(builder, DVec3::new(0.0, height * 0.66, z), radius * 0.26, -1.0);
    builder.add(
        slot,
        lathe(&[(radius * 0.2, 0.0), (radius * 0.12, height * 0.14), (radius * 0.2, height * 0.2)], 8)
            .moved(0.0, 0.0, z),
    );
}
