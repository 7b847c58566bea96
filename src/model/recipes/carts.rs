//! What stands on castors: trolleys, drip stands.

use glam::DVec3;

use super::input::{Draft, GeometrySet};
use super::parts::{HandleKind, handle, turned_forward};
use crate::catalog::Side;
use crate::model::kit::{Bay, Builder, SINK, cylinder, lathe, sweep};

/// A castor under a point at a height over the floor.
fn castor(builder: &mut Builder, at: DVec3, height: f64) {
    let radius = height * 0.42;
    let wheel = turned_forward(cylinder(radius, [-radius * 0.35, radius * 0.35], 10));
    builder.add("rubber", wheel.turned_y(std::f64::consts::FRAC_PI_2).moved(at.x, radius, at.z));
    let fork = Bay::around(DVec3::new(at.x, 0.0, at.z), radius * 1.05, 1.0, radius * 0.9);
    builder.cuboid("metal", fork.with_y([radius * 0.9, height]));
}

/// Castors near the corners of a bay's floor.
fn castors(builder: &mut Builder, bay: Bay, height: f64) {
    let inset = height * 0.5;
    for x in [bay.low.x + inset, bay.high.x - inset] {
        for z in [bay.low.z + inset, bay.high.z - inset] {
            castor(builder, DVec3::new(x, 0.0, z), height);
        }
    }
}

/// A stand with bags that hang from hooks over five castors.
pub(super) fn drip_stand(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let look = draft.input.look as usize % 4;
    let (half, height) = (bay.extent() / 2.0, bay.height());
    let metal = if draft.set() == GeometrySet::Traditional { "painted" } else { "chrome" };
    let hub = 0.12_f64.min(height * 0.1);
    for leg in 0..5 {
        let (sine, cosine) = libm::sincos(std::f64::consts::TAU * (f64::from(leg) / 5.0 + 0.25));
        let end = DVec3::new(cosine * (half.x - 0.028), hub * 0.6, sine * (half.z - 0.028));
        builder.add(metal, sweep(&[DVec3::new(0.0, hub, 0.0), end], 0.014, 6));
        castor(builder, DVec3::new(end.x, 0.0, end.z), hub * 0.55);
    }
    // The bounds of a star of five: a foot bar across closes the box.
    builder.cuboid(metal, Bay::around(DVec3::Y * hub * 0.9, bay.width(), 0.014, 0.02));
    builder.cuboid(metal, Bay::around(DVec3::Y * hub * 0.9, 0.0198, 0.0136, bay.depth()));
    builder.add(metal, cylinder(0.022, [hub * 0.7, hub * 1.5], 10));
    builder.add(metal, cylinder(0.015, [hub, height * 0.62], 8));
    builder.add(metal, cylinder(0.01, [height * 0.6, height - 0.03], 8));
    builder.add("plastic_dark", cylinder(0.026, [height * 0.59, height * 0.63], 8));
    for side in [-1.0, 1.0] {
        let hook = |x: f64, y: f64| DVec3::new(side * x, height + y, 0.0);
        let path = [hook(0.004, -0.05), hook(0.1, -0.05), hook(0.13, -0.02), hook(0.13, -0.007)];
        builder.add(metal, sweep(&path, 0.007, 6));
    }
    let bags = 1 + look as u32 % 2;
    for bag in 0..bags {
        let x = if bag == 0 { 0.1 } else { -0.1 };
        let hung = Bay::around(DVec3::new(x, height - 0.2, 0.0), 0.12, 0.26, 0.035);
        builder.rounded(if look < 2 { "glass" } else { "plastic" }, hung, DVec3::new(0.03, 0.03, 0.016), 2);
        builder.cuboid("paper", hung.inset(0.02, 0.07, 0.0).slab(Side::Front, 0.003).moved(0.0, 0.0, 0.0012));
        let hose = [
            DVec3::new(x, height - 0.32, 0.0),
            DVec3::new(x, height * 0.66, 0.01),
            DVec3::new(x * 0.4, height * 0.5, 0.03),
            DVec3::new(x * 0.5, height * 0.38, 0.03),
        ];
        builder.add("plastic", sweep(&hose, 0.004, 4));
    }
    let pump = Bay::around(DVec3::new(0.0, height * 0.54, 0.055), 0.14, 0.17, 0.1);
    builder.block("plastic", pump, 0.01);
    let front = pump.with_z([pump.high.z - SINK, pump.high.z + 0.003]);
    builder
        .cuboid("screen", front.inset(0.02, 0.0, 0.0).with_y([pump.center().y + 0.01, pump.high.y - 0.02]));
    for key in front.inset(0.02, 0.0, 0.0).with_y([pump.low.y + 0.02, pump.low.y + 0.05]).columns(3, 0.012) {
        builder.cuboid("painted_accent", key);
    }
}

/// A luggage trolley: a birdcage of brass over a carpet, or a bent frame with a low deck and a push bar.
#[expect(clippy::too_many_lines, reason = "part after part of one piece")]
pub(super) fn luggage_trolley(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let lift = 0.13_f64.min(bay.height() * 0.2);
    let inner = bay.inset(0.02, 0.0, 0.02);
    castors(builder, inner, lift);
    let is_cage = draft.is_traditional() || (draft.set() == GeometrySet::Plain && draft.input.look % 2 == 1);
    let deck = bay.with_y([lift - SINK, lift + 0.035]);
    if is_cage {
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
    } else {
        let metal = if draft.set() == GeometrySet::Industrial { "metal_dark" } else { "metal" };
        let tube = 0.016;
        for side in [Side::Left, Side::Right] {
            builder.block(metal, deck.slab(side, 0.035), 0.006);
        }
        for slat in
            deck.inset(0.03, 0.005, 0.01).rows(1, 0.0).into_iter().flat_map(|row| row.columns(5, 0.02))
        {
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
        // The push bar at the back, and a basket before it.
        let (x, z, top) = (inner.high.x - tube, bay.low.z + tube, bay.high.y - tube);
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
        let basket =
            Bay::new([-x * 0.9, x * 0.9], [bay.high.y * 0.62, bay.high.y * 0.8], [z + 0.03, z + 0.22]);
        wire_basket(builder, metal, basket);
        for y in [0.3, 0.45] {
            let rung = [DVec3::new(-x, bay.high.y * y, z + 0.08), DVec3::new(x, bay.high.y * y, z + 0.08)];
            builder.add(metal, sweep(&rung, tube * 0.6, 6));
        }
    }
    if draft.input.look.is_multiple_of(2) {
        suitcases(builder, bay, deck.high.y + if is_cage { 0.006 } else { -0.006 });
    }
}

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

/// A chest of drawers for tools on castors, with a push bar.
#[expect(clippy::too_many_lines, reason = "part after part of one piece")]
pub(super) fn tool_trolley(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let look = draft.input.look as usize % 4;
    let slot = match draft.set() {
        GeometrySet::Industrial => ["painted_accent", "metal_dark", "metal", "book"],
        GeometrySet::Traditional => ["book", "painted_accent", "metal_dark", "leaf"],
        _ => ["book", "painted_accent", "metal_dark", "plastic_dark"],
    }[look];
    let lift = 0.14_f64.min(bay.height() * 0.2);
    let bar = 0.05;
    let body = bay.with_y([lift - SINK, bay.high.y - 0.03]).without(Side::Right, bar);
    castors(builder, body.inset(0.015, 0.0, 0.02).without(Side::Front, 0.02), lift);
    let reach = 0.018;
    builder.block(slot, body.without(Side::Front, reach + 0.01), 0.006);
    let face = body.inset(0.02, 0.02, 0.0).without(Side::Front, reach).slab(Side::Front, 0.014);
    let drawers = if look.is_multiple_of(2) { 5 } else { 7 };
    let rows = face.rows(drawers, 0.008);
    for (index, row) in rows.iter().enumerate() {
        // The two lowest are one deep drawer.
        let row = match index {
            0 => row.with_y([row.low.y, rows[1].high.y]),
            1 => continue,
            _ => *row,
        };
        builder.cuboid(slot, row);
        let grip = row.slab(Side::Above, 0.014).inset(0.02, 0.0, 0.0);
        builder.cuboid(
            "metal",
            grip.with_z([row.high.z - SINK, row.high.z + reach * 0.9]).moved(0.0, -0.001, 0.0),
        );
    }
    builder.block(
        "rubber",
        body.inset(0.004, 0.0, 0.004)
            .with_y([body.high.y - SINK, body.high.y + 0.012])
            .without(Side::Front, reach),
        0.003,
    );
    // A rim around the top, a wrench and a box on it.
    let rim = body.with_y([body.high.y - SINK, bay.high.y]).without(Side::Front, reach * 0.5);
    for side in [Side::Left, Side::Right] {
        builder.cuboid(slot, rim.slab(side, 0.008));
    }
    let behind = rim.slab(Side::Back, 0.008).inset(0.006, 0.0, 0.0).without(Side::Above, 0.001);
    builder.cuboid(slot, behind.without(Side::Below, 0.0002).moved(0.0, 0.0, 0.0008));
    builder.cuboid("chrome", Bay::around(DVec3::new(-0.08, body.high.y + 0.015, 0.06), 0.2, 0.008, 0.02));
    let x = bay.high.x - 0.014;
    let path = [
        DVec3::new(body.high.x - 0.01, bay.high.y * 0.86, body.low.z + 0.06),
        DVec3::new(x, bay.high.y * 0.86, body.low.z + 0.06),
        DVec3::new(x, bay.high.y * 0.86, body.high.z - 0.1),
        DVec3::new(body.high.x - 0.01, bay.high.y * 0.86, body.high.z - 0.1),
    ];
    builder.add("chrome", sweep(&path, 0.0145, 8));
    builder.cuboid(
        "metal",
        bay.slab(Side::Front, reach * 0.3)
            .with_x([-0.02, 0.02])
            .with_y([body.high.y - 0.05, body.high.y - 0.03]),
    );
    builder.cuboid(
        "metal",
        Bay::new(
            [-0.015, 0.015],
            [body.high.y - 0.046, body.high.y - 0.037],
            [bay.high.z - reach - 0.012, bay.high.z - 0.001],
        ),
    );
}

/// A trolley with two or three trays between posts.
pub(super) fn serving_trolley(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let look = draft.input.look as usize % 4;
    let (board, post) = match draft.set() {
        GeometrySet::Plain => (
            ["wood", "glass", "painted", "wood_light"][look],
            ["metal_dark", "brass", "metal", "chrome"][look],
        ),
        GeometrySet::Traditional => {
            (["wood_dark", "glass", "wood", "wood_dark"][look], ["wood_dark", "brass", "wood", "brass"][look])
        }
        GeometrySet::Industrial => ("metal", ["metal", "metal_dark", "metal", "chrome"][look]),
        GeometrySet::Budget => ("plastic_dark", ["metal", "plastic", "chrome", "metal_dark"][look]),
    };
    let lift = 0.1_f64.min(bay.height() * 0.15);
    let frame = bay.inset(0.012, 0.0, 0.012);
    castors(builder, frame.inset(-0.002, 0.0, -0.002), lift);
    let radius = 0.012;
    let inset = lift * 0.5 - 0.002;
    for x in [frame.low.x + inset, frame.high.x - inset] {
        for z in [frame.low.z + inset, frame.high.z - inset] {
            if draft.is_traditional() {
                let profile = [
                    (radius, lift - SINK),
                    (radius * 1.6, lift + 0.05),
                    (radius * 0.8, bay.height() * 0.4),
                    (radius * 1.6, bay.height() * 0.52),
                    (radius * 0.8, bay.height() * 0.6),
                    (radius, bay.high.y - 0.02),
                    (radius * 1.5, bay.high.y - 0.008),
                    (radius * 0.5, bay.high.y),
                ];
                builder.add(post, lathe(&profile, 8).moved(x, 0.0, z));
            } else {
                builder.add(post, cylinder(radius, [lift - SINK, bay.high.y], 8).moved(x, 0.0, z));
            }
        }
    }
    let shelves: &[f64] = if look.is_multiple_of(2) { &[0.2, 0.9] } else { &[0.2, 0.55, 0.9] };
    for (index, &rise) in shelves.iter().enumerate() {
        let y = bay.high.y * rise;
        // One tray reaches the sides of the box.
        let tray = if index == 0 { bay } else { bay.inset(0.0008, 0.0, 0.0008) };
        builder.block(board, tray.with_y([y - 0.02, y]), 0.004);
        let rail = tray.inset(0.004, 0.0, 0.004).with_y([y + 0.03, y + 0.036]);
        for side in [Side::Front, Side::Back] {
            builder.cuboid(post, rail.slab(side, 0.006).inset(0.0006, 0.0, 0.0));
        }
        for side in [Side::Left, Side::Right] {
            builder.cuboid(post, rail.slab(side, 0.006).inset(0.0, 0.0004, 0.003));
        }
        goods(builder, tray.with_y([y - SINK, (y + 0.12).min(bay.high.y)]), index + look);
    }
}

/// Bottles, cups and a bowl on a tray.
fn goods(builder: &mut Builder, tray: Bay, seed: usize) {
    let y = tray.low.y;
    let tall = tray.height().min(0.22);
    for index in 0..3 {
        let x = tray.width() * [-0.3, -0.05, 0.24][index];
        let z = tray.depth() * [0.1, -0.14, 0.05][index];
        let (slot, profile): (&'static str, Vec<(f64, f64)>) = match (index + seed) % 3 {
            0 => (
                "glass",
                vec![(0.034, y), (0.035, y + tall * 0.55), (0.013, y + tall * 0.75), (0.012, y + tall)],
            ),
            1 => (
                "ceramic",
                vec![(0.03, y), (0.055, y + tall * 0.5), (0.05, y + tall * 0.5), (0.028, y + tall * 0.1)],
            ),
            _ => (
                "ceramic",
                vec![(0.06, y), (0.1, y + tall * 0.2), (0.095, y + tall * 0.22), (0.055, y + tall * 0.06)],
            ),
        };
        builder.add(slot, lathe(&profile, 10).moved(x, 0.0, z));
    }
}
