//! Sanitary ware.

use glam::{DVec2, DVec3};

use super::input::Draft;
use super::parts::{Fittings, REVEAL, slab_top, tap};
use crate::catalog::Side;
use crate::model::kit::{Bay, Builder, Outline, SINK, Slice, cylinder, lathe, loft, loft_ring, sweep};

/// Corners of a basin or bowl.
const ROUND: usize = 16;
/// Metres of a toilet's seat over the floor.
const TOILET_SEAT: f64 = 0.43;
/// Width, height and depth in metres of the toilet in a cubicle.
const CUBICLE_BOWL: DVec3 = DVec3::new(0.38, 0.8, 0.66);
/// Metres of the panels of a cubicle.
const CUBICLE_PANEL: f64 = 0.03;
/// Metres of the floor under the panels of a cubicle that stay open.
const CUBICLE_FOOT: f64 = 0.12;

/// An egg-shaped outline: narrower to the front.
fn egg(corners: usize) -> Outline {
    let point = |step: usize| {
        let (sine, cosine) = libm::sincos(std::f64::consts::TAU * step as f64 / corners as f64);
        // Blunt at the back, drawn out to the front.
        let narrow = if sine > 0.0 { 1.0 - 0.14 * sine } else { 1.0 };
        DVec2::new(cosine * narrow, sine)
    };
    Outline::Points((0..corners).rev().map(point).collect())
}

/// A toilet with bowl, seat, lid and cistern.
pub(super) fn toilet(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    toilet_in(bay, draft.sampler().count(0, 2) == 2, builder);
}

/// A toilet between partition walls on feet, with a door that is closed.
pub(super) fn toilet_cubicle(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let color = draft.sampler().pick(&["painted", "painted_accent"]);
    let bowl = CUBICLE_BOWL.min(bay.extent() * 0.8);
    let seat = bay.with_x([-bowl.x / 2.0, bowl.x / 2.0]).with_y([bay.low.y, bay.low.y + bowl.y]);
    toilet_in(seat.slab(Side::Back, bowl.z), false, builder);
    let panels = bay.without(Side::Below, CUBICLE_FOOT);
    for side in [Side::Left, Side::Right] {
        builder.cuboid(color, panels.slab(side, CUBICLE_PANEL));
        let post = bay.slab(side, CUBICLE_PANEL).inset(CUBICLE_PANEL * 0.2, 0.0, 0.0);
        let post = post.with_y([bay.low.y, panels.low.y + SINK]).slab(Side::Front, CUBICLE_PANEL);
        builder.cuboid("metal", post.moved(0.0, 0.0, -SINK));
    }
    let front = panels.slab(Side::Front, CUBICLE_PANEL).inset(CUBICLE_PANEL - SINK, SINK, SINK);
    let beside = (front.width() * 0.16).max(0.01);
    for side in [Side::Left, Side::Right] {
        builder.cuboid(color, front.slab(side, beside));
    }
    let leaf = front.inset(beside + REVEAL, REVEAL, 0.0).slab(Side::Back, CUBICLE_PANEL * 0.6);
    builder.cuboid("laminate", leaf);
    let lock = DVec3::new(leaf.high.x - 0.06, bay.low.y + bay.height() * 0.5, leaf.high.z);
    let knob = Bay::around(lock, 0.05, 0.05, 0.001);
    builder.cuboid("chrome", knob.with_z([leaf.high.z - SINK, bay.high.z]));
}

/// A toilet that fills a bay whose middle is that of the model.
fn toilet_in(bay: Bay, is_open: bool, builder: &mut Builder) {
    let seat = TOILET_SEAT.min(bay.height() * 0.58);
    let cistern_depth = (bay.depth() * 0.28).min(0.19);
    let bowl = bay.without(Side::Back, cistern_depth * 0.75);
    let (half, middle) = (bowl.extent() / 2.0, bowl.center());
    let slice = |y: f64, x: f64, z: f64, back: f64| {
        Slice::new(y, half.x * x, half.z * z).at(0.0, middle.z - half.z * back)
    };
    let body = [
        slice(0.0, 0.6, 0.7, 0.28),
        slice(seat * 0.12, 0.55, 0.66, 0.3),
        slice(seat * 0.5, 0.62, 0.72, 0.24),
        slice(seat * 0.82, 0.92, 0.97, 0.03),
        slice(seat - 0.035, 0.96, 1.0, 0.0),
        slice(seat - 0.035, 0.7, 0.72, 0.0),
        slice(seat * 0.6, 0.4, 0.45, 0.05),
    ];
    builder.add("ceramic", loft(&egg(ROUND), &body));
    let ring = [
        slice(seat - 0.035 - SINK, 0.97, 0.98, 0.0),
        slice(seat - 0.012, 0.98, 0.99, 0.0),
        slice(seat - 0.012, 0.62, 0.66, -0.02),
        slice(seat - 0.035 - SINK, 0.62, 0.66, -0.02),
    ];
    builder.add("plastic", loft_ring(&egg(ROUND), &ring));
    if !is_open {
        let lid = [slice(seat - 0.011, 0.97, 0.98, 0.0), slice(seat, 0.9, 0.92, 0.0)];
        builder.add("plastic", loft(&egg(ROUND), &lid));
    }
    let tank = bay.slab(Side::Back, cistern_depth).with_y([seat * 0.72, bay.high.y]);
    builder.block(
        "ceramic",
        tank.without(Side::Above, 0.035).inset(0.012, 0.0, 0.0).without(Side::Front, 0.012),
        0.012,
    );
    builder.block("ceramic", tank.slab(Side::Above, 0.035 + SINK).without(Side::Above, 0.006), 0.01);
    builder.add(
        "chrome",
        cylinder(0.022, [bay.high.y - 0.007, bay.high.y], 10).moved(0.0, 0.0, tank.center().z),
    );
    let neck = bay.without(Side::Back, 0.003).slab(Side::Back, cistern_depth * 1.4).inset(
        bay.width() * 0.3,
        0.0,
        0.0,
    );
    builder.cuboid("ceramic", neck.with_y([0.001, seat - 0.05]));
}

/// A basin on a wall with half a pedestal, or a whole one where the box reaches the floor.
pub(super) fn washbasin(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let tap_height = (bay.height() * 0.3).min(0.13);
    let rim = bay.high.y - tap_height;
    let depth = (rim * 0.5).min(0.17);
    basin(builder, bay.with_y([rim - depth, rim]), sampler.chance(0.5));
    let foot = DVec3::new(0.0, rim, bay.low.z + 0.05_f64.min(bay.depth() * 0.14));
    tap(builder, foot, tap_height, (bay.depth() * 0.3).min(0.15));
    let low = rim - depth;
    if low > 0.3 {
        let (x, z) = (bay.width() * 0.17, bay.depth() * 0.22);
        let slices = [
            Slice::new(0.0, x, z),
            Slice::new(low * 0.5, x * 0.8, z * 0.85),
            Slice::new(low + depth * 0.4, x * 1.2, z * 1.1),
        ];
        let slices = slices.map(|slice| slice.at(0.0, bay.low.z + z * 1.12));
        builder.add("ceramic", loft(&Outline::Round(12), &slices));
    } else if low > 0.01 {
        let trap = [
            DVec3::new(0.0, low + 0.01, 0.0),
            DVec3::new(0.0, 0.012, 0.0),
            DVec3::new(0.0, 0.012, bay.low.z),
        ];
        builder.add("chrome", sweep(&trap, 0.012, 6));
    }
}

/// A basin with a hollow and a ledge for the tap behind it, filling a bay.
fn basin(builder: &mut Builder, bay: Bay, is_round: bool) {
    let (half, middle) = (bay.extent() / 2.0, bay.center());
    let ledge = (bay.depth() * 0.2).min(0.1);
    let corner = if is_round { half.x.min(half.z) * 0.75 } else { 0.04 };
    let y = |share: f64| bay.low.y + share * bay.height();
    let slice = |share: f64, shrink: f64| {
        Slice::new(y(share), half.x * shrink, half.z * shrink)
            .at(0.0, middle.z - half.z * (1.0 - shrink))
            .softened(corner * shrink)
    };
    let border = (bay.width() * 0.08).min(0.05);
    let hollow = |share: f64, shrink: f64| {
        let (x, z) = ((half.x - border) * shrink, (half.z - ledge / 2.0 - border * 0.6) * shrink);
        Slice::new(y(share), x, z).at(0.0, middle.z + ledge / 2.0).softened(corner * 0.8 * shrink)
    };
    let slices = [
        slice(0.0, 0.55),
        slice(0.45, 0.88),
        slice(0.8, 1.0),
        slice(1.0, 1.0),
        hollow(1.0, 1.0),
        hollow(0.6, 0.94),
        hollow(0.2, 0.55),
    ];
    builder.add("ceramic", loft(&Outline::Soft(2), &slices));
    let drain = hollow(0.2, 0.55);
    let disc = cylinder(0.022_f64.min(half.x * 0.15), [drain.y - SINK, drain.y + 0.003], 8);
    builder.add("chrome", disc.moved(drain.center.x, 0.0, drain.center.y));
}

/// A basin let into a cabinet with doors or drawers.
pub(super) fn vanity(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let is_traditional = draft.is_traditional();
    let tap_height = (bay.height() * 0.18).min(0.14);
    let rim = bay.high.y - tap_height;
    let depth = 0.12_f64.min(rim * 0.25);
    basin(builder, bay.with_y([rim - depth, rim]), false);
    let foot = DVec3::new(0.0, rim, bay.low.z + 0.05_f64.min(bay.depth() * 0.14));
    tap(builder, foot, tap_height, (bay.depth() * 0.3).min(0.15));
    let fittings = Fittings { front: "painted", handle: "chrome", reach: 0.02, is_traditional };
    let toe = (rim * 0.15).min(0.12);
    let body = bay.with_y([toe, rim - depth * 0.55]).inset(0.012, 0.0, 0.004);
    let top = body.slab(Side::Above, 0.02).without(Side::Front, 0.002);
    slab_top(builder, "painted", top, false);
    let body = body.without(Side::Above, 0.02 - SINK);
    fittings.carcass(builder, "painted", body);
    let legs = body.with_y([0.0, toe + SINK]).inset(0.01, 0.0, 0.01).without(Side::Front, 0.04);
    super::parts::legs_at_corners(builder, "chrome", legs, 0.03, super::parts::LegKind::Square);
    let face = body.inset(REVEAL / 2.0, REVEAL / 2.0, 0.0);
    if draft.sampler().chance(0.5) {
        face.rows(2, REVEAL).into_iter().for_each(|row| fittings.drawer(builder, row));
        return;
    }
    let count = (body.width() / 0.45).round().clamp(1.0, 4.0) as u32;
    for (index, column) in face.columns(count, REVEAL).into_iter().enumerate() {
        fittings.door(builder, column, if index % 2 == 0 { Side::Left } else { Side::Right }, 0.75);
    }
}

/// A bathtub: built in, or standing free on feet in the traditional set; the tap is at its left end, and the long
/// side is whichever is longer.
pub(super) fn bathtub(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let is_free = draft.is_traditional();
    let tap_height = (bay.height() * 0.22).min(0.13);
    let rim = bay.high.y - tap_height;
    let half = bay.extent() / 2.0;
    let corner = half.x.min(half.z) * if is_free { 0.9 } else { 0.5 };
    let border = 0.055_f64.min(half.min_element() * 0.3);
    let slice = |share: f64, back: f64, radius: f64| {
        Slice::new(share * rim, half.x - back, half.z - back).softened(radius)
    };
    let inside = [
        slice(1.0, border, corner - border),
        slice(0.7, border * 1.3, corner - border),
        slice(0.3, border * 2.4, corner - border * 2.0),
    ];
    let outside = if is_free {
        vec![
            slice(0.22, border * 2.0, corner - border),
            slice(0.5, border * 0.9, corner),
            slice(0.93, border * 0.5, corner),
            slice(0.94, 0.0, corner),
            slice(1.0, 0.0, corner),
        ]
    } else {
        vec![
            slice(0.0, 0.02, 0.012),
            slice(0.93, 0.02, 0.012),
            slice(0.931, 0.0, 0.02),
            slice(1.0, 0.0, 0.02),
        ]
    };
    let slices: Vec<Slice> = outside.into_iter().chain(inside).collect();
    builder.add("ceramic", loft(&Outline::Soft(3), &slices));
    if is_free {
        for x in [-1.0, 1.0] {
            for z in [-1.0, 1.0] {
                let claw = lathe(&[(0.03, 0.0), (0.035, 0.03), (0.02, 0.07), (0.03, rim * 0.25)], 8);
                builder.add("brass", claw.moved(x * (half.x * 0.55), 0.0, z * (half.z * 0.55)));
            }
        }
    }
    let is_wide = bay.width() >= bay.depth();
    let foot = if is_wide {
        DVec3::new(-half.x + border * 0.5, 0.0, 0.0)
    } else {
        DVec3::new(0.0, 0.0, -half.z + border * 0.5)
    };
    let turn = if is_wide { std::f64::consts::FRAC_PI_2 } else { 0.0 };
    let mut spout = builder.empty();
    tap(&mut spout, DVec3::ZERO, tap_height, border * 2.4);
    for (slot, solid) in spout.into_parts() {
        builder.add(slot, solid.turned_y(turn).moved(foot.x, rim, foot.z));
    }
}

/// A shower tray between two walls (behind and on the left) with glass on the other sides.
pub(super) fn shower(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let tray = 0.06_f64.min(bay.height() * 0.1);
    let half = bay.extent() / 2.0;
    let slice = |y: f64, back: f64| Slice::new(y, half.x - back, half.z - back).softened(0.02 + back);
    let slices = [slice(0.0, 0.0), slice(tray, 0.0), slice(tray, 0.05), slice(tray * 0.55, 0.07)];
    builder.add("ceramic", loft(&Outline::Soft(2), &slices));
    builder.add("chrome", cylinder(0.04, [tray * 0.55 - SINK, tray * 0.55 + 0.004], 10));
    let pane = 0.008;
    let glass = bay.inset(0.006, 0.0, 0.006).with_y([tray - 0.002, bay.high.y]);
    builder.cuboid("glass", glass.slab(Side::Right, pane));
    let front = glass.slab(Side::Front, pane).without(Side::Right, pane + 0.001).without(Side::Above, 0.002);
    let door = if draft.sampler().chance(0.5) { 0.5 } else { 0.62 };
    builder.cuboid("glass", front.slab(Side::Right, front.width() * (1.0 - door) - 0.004));
    let leaf = front.slab(Side::Left, front.width() * door);
    builder.cuboid("glass", leaf.without(Side::Below, 0.012));
    let knob = DVec3::new(leaf.high.x - 0.06, (bay.height() * 0.5).min(1.05), leaf.low.z - 0.014);
    builder.cuboid("chrome", Bay::around(knob, 0.018, 0.18, 0.024));
    shower_head(builder, bay);
}

/// Riser, head and mixer on the back wall.
fn shower_head(builder: &mut Builder, bay: Bay) {
    let (z, reach) = (bay.low.z, (bay.depth() * 0.35).min(0.35));
    let (low, high) = (bay.height() * 0.5, bay.height() * 0.96);
    let x = -bay.width() * 0.12;
    let path =
        [DVec3::new(x, low, z + 0.04), DVec3::new(x, high, z + 0.04), DVec3::new(x, high, z + 0.04 + reach)];
    builder.add("chrome", sweep(&path, 0.011, 6));
    let head = lathe(&[(0.09, 0.0), (0.09, 0.012), (0.02, 0.03), (0.02, bay.height() * 0.04)], 12);
    builder.add("chrome", head.moved(x, high - bay.height() * 0.04 - 0.004, z + 0.035 + reach));
    let mixer = Bay::new([x - 0.13, x + 0.13], [low - 0.03, low + 0.02], [z + 0.015, z + 0.065]);
    builder.block("chrome", mixer, 0.012);
    for side in [Side::Left, Side::Right] {
        builder.cuboid(
            "chrome",
            mixer
                .slab(side, 0.05)
                .with_y([low - 0.015, low + 0.005])
                .inset(0.01, 0.0, 0.0)
                .with_z([z, z + 0.02]),
        );
    }
}
