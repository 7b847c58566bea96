//! Apparatus of laboratories and shops.

use glam::{DVec2, DVec3};

use super::input::Draft;
use super::parts::{Fittings, HandleKind, handle, turned_forward};
use crate::catalog::Side;
use crate::model::kit::{Axis, Bay, Builder, SINK, cylinder, extrude, lathe};

/// A fume cupboard: a bench under a chamber with a sliding pane, a duct and service valves.
#[expect(clippy::too_many_lines, reason = "part after part of one piece")]
pub(super) fn fume_cupboard(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let look = draft.input.look as usize % 4;
    let slot = ["painted", "metal", "laminate", "painted"][look];
    let bench = bay.height() * 0.4;
    let fittings = Fittings {
        front: ["painted_accent", "laminate", "painted", "metal"][look],
        handle: "metal",
        reach: 0.025,
        is_traditional: false,
    };
    let base = bay.with_y([0.08, bench - 0.03]).inset(0.002, 0.0, 0.002);
    builder.cuboid(
        "plastic_dark",
        base.with_y([0.0, 0.08 + SINK]).inset(0.01, 0.0, 0.01).without(Side::Front, 0.05),
    );
    fittings.carcass(builder, slot, base);
    let count = (bay.width() / 0.5).round().clamp(1.0, 5.0) as u32;
    for (index, column) in base.inset(0.003, 0.003, 0.0).columns(count, 0.004).into_iter().enumerate() {
        fittings.door(builder, column, if index % 2 == 0 { Side::Left } else { Side::Right }, 0.85);
    }
    builder.block("stone", bay.with_y([bench - 0.03 - SINK, bench]), 0.004);
    let upper = bay.with_y([bench - SINK, bay.high.y]).inset(0.001, 0.0, 0.001).without(Side::Front, 0.05);
    let side_wall = 0.09;
    for side in [Side::Left, Side::Right] {
        builder.cuboid(slot, upper.slab(side, side_wall).without(Side::Above, 0.12));
    }
    builder.cuboid(
        "tile_wall",
        upper.slab(Side::Back, 0.03).inset(side_wall - SINK, 0.001, 0.0006).without(Side::Above, 0.12),
    );
    let hood = upper.with_y([bay.high.y - 0.44, bay.high.y - 0.12]).inset(side_wall - SINK, 0.0, 0.001);
    builder.cuboid(slot, hood.without(Side::Back, 0.03 - SINK).without(Side::Front, 0.002));
    let head = upper.slab(Side::Above, 0.12 + SINK);
    builder.block("metal", head, 0.006);
    builder.cuboid("lamp", hood.with_y([hood.low.y - 0.006, hood.low.y + SINK]).inset(0.08, 0.0, 0.2));
    // The pane stands half open in its frame.
    let pane = upper.slab(Side::Front, 0.02).inset(side_wall * 0.7, 0.0, 0.0).moved(0.0, 0.0, 0.012);
    let pane = pane.with_y([bench + (hood.low.y - bench) * (0.25 + 0.12 * look as f64), hood.high.y - 0.06]);
    builder.cuboid("glass", pane.inset(0.004, 0.004, 0.006));
    for edge in [Side::Below, Side::Above] {
        builder.cuboid("metal", pane.slab(edge, 0.025));
    }
    handle(
        builder,
        "metal_dark",
        (HandleKind::Level, pane.width() * 0.3),
        DVec3::new(0.0, pane.low.y + 0.0125, pane.high.z),
        0.016,
    );
    for (index, x) in [-0.47, -0.455, 0.455, 0.47].into_iter().enumerate() {
        let at = DVec3::new(x * bay.width() * 0.985, bench + 0.14 + 0.12 * (index % 2) as f64, upper.high.z);
        let valve = turned_forward(lathe(&[(0.01, -SINK), (0.01, 0.02), (0.02, 0.022), (0.018, 0.045)], 8));
        builder.add(["book", "leaf", "painted_accent", "brass"][index], valve.moved(at.x, at.y, at.z));
    }
    for (x, tall, slot) in [(-0.2, 0.16, "glass"), (-0.1, 0.22, "glass"), (0.18, 0.12, "glass")] {
        let flask = lathe(
            &[
                (0.05, bench - SINK),
                (0.055, bench + 0.02),
                (0.016, bench + tall * 0.6),
                (0.016, bench + tall),
            ],
            10,
        );
        builder.add(slot, flask.moved(x * bay.width(), 0.0, 0.0));
    }
}

/// An open refrigerator of a shop: shelves of goods under a lit canopy, between glass ends.
#[expect(clippy::too_many_lines, reason = "part after part of one piece")]
pub(super) fn chilled_shelf(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let look = draft.input.look as usize % 4;
    let slot = ["plastic_dark", "painted", "metal", "painted_accent"][look];
    let end = 0.03;
    // Seen from the right: a deep foot, a thin back, a canopy.
    let (back, front) = (bay.low.z, bay.high.z);
    let (foot, head) = (bay.height() * 0.24, bay.height() * 0.9);
    let profile = [
        (front, 0.0),
        (front, foot * 0.86),
        (front - 0.05, foot),
        (back + 0.1, foot * 0.92),
        (back + 0.08, head),
        (front - bay.depth() * 0.3, head),
        (front - bay.depth() * 0.26, head + 0.05),
        (front - bay.depth() * 0.3, bay.high.y),
        (back, bay.high.y),
        (back, 0.0),
    ]
    .map(DVec2::from);
    let body = bay.inset(end, 0.0, 0.0);
    builder.add(slot, extrude(&profile, Axis::X, body.x()));
    for side in [Side::Left, Side::Right] {
        builder.cuboid(
            if look.is_multiple_of(2) { "glass" } else { slot },
            bay.slab(side, end + SINK)
                .inset(0.0, 0.002, 0.002)
                .with_z([back + 0.002, front - bay.depth() * 0.12]),
        );
        builder.cuboid(
            "metal",
            bay.slab(side, end + SINK * 4.0).with_y([0.0005, foot * 0.6]).inset(0.0006, 0.0, 0.001),
        );
    }
    builder.cuboid(
        "lamp",
        body.inset(0.04, 0.0, 0.0)
            .with_y([head - 0.012, head + SINK])
            .with_z([front - bay.depth() * 0.4, front - bay.depth() * 0.34]),
    );
    builder.cuboid(
        "screen",
        body.inset(body.width() * 0.3, 0.0, 0.0)
            .with_y([foot * 0.3, foot * 0.5])
            .with_z([front - 0.0005, front + 0.0008]),
    );
    let shelves = 4;
    for shelf in 0..=shelves {
        let low = foot * 0.95 + (head - foot) * f64::from(shelf) / f64::from(shelves + 1);
        let deep = bay.depth() * (0.66 - 0.05 * f64::from(shelf));
        let board = body
            .inset(0.012, 0.0, 0.0)
            .with_y([low, low + 0.014])
            .with_z([back + 0.085, back + 0.085 + deep]);
        if shelf > 0 {
            builder.cuboid("metal", board);
            builder.cuboid(
                "paper",
                board
                    .slab(Side::Front, 0.004)
                    .inset(0.001, 0.0, 0.0)
                    .moved(0.0, 0.003, 0.0035)
                    .with_y([low - 0.012, low + 0.026]),
            );
        }
        let goods = board
            .with_y([low + 0.014 - SINK, low + (head - foot) / f64::from(shelves + 1) - 0.03])
            .inset(0.02, 0.0, 0.02);
        let columns = (goods.width() / 0.13).round().clamp(2.0, 9.0) as u32;
        for column in goods.columns(columns, 0.012) {
            let tall = goods.height() * sampler.between(0.5, 0.85);
            let slot = sampler.pick(&["book", "paper", "fabric_accent", "leaf", "linen", "painted_accent"]);
            if sampler.chance(0.35) {
                let radius = column.width() * 0.42;
                let y = column.low.y;
                let bottle = [
                    (radius, y),
                    (radius, y + tall * 0.6),
                    (radius * 0.4, y + tall * 0.8),
                    (radius * 0.4, y + tall),
                ];
                for z in [0.24, -0.2] {
                    builder.add(
                        slot,
                        lathe(&bottle, 6).moved(
                            column.center().x,
                            0.0,
                            column.center().z + z * column.depth(),
                        ),
                    );
                }
            } else {
                builder.cuboid(slot, column.slab(Side::Below, tall));
            }
        }
    }
}

/// A till place: a belt, a scanner, a bay to pack in and a screen on a post.
#[expect(clippy::too_many_lines, reason = "part after part of one piece")]
pub(super) fn checkout(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let look = draft.input.look as usize % 4;
    let slot = ["laminate", "painted_accent", "metal", "wood"][look];
    let work = bay.height() * 0.84;
    let kick = 0.08;
    builder.cuboid("plastic_dark", bay.with_y([0.0, kick + SINK]).inset(0.04, 0.0, 0.04));
    let body = bay.with_y([kick, work]);
    // Customers stand behind; the cashier sits before a recess.
    let seat = body.width() * 0.26;
    let recess = [bay.width() * 0.02, bay.width() * 0.02 + seat];
    builder.block(slot, body.without(Side::Front, bay.depth() * 0.42).inset(0.0, 0.0, 0.001), 0.006);
    for ends in [[body.low.x, recess[0]], [recess[1], body.high.x]] {
        builder.block(
            slot,
            body.slab(Side::Front, bay.depth() * 0.42 + 0.02).with_x(ends).inset(0.002, 0.001, 0.0),
            0.006,
        );
    }
    builder.cuboid(
        "metal",
        bay.slab(Side::Back, 0.012).with_y([work * 0.3, work * 0.36]).inset(0.001, 0.0, 0.0),
    );
    let belt = Bay::new(
        [body.low.x + 0.03, recess[0] - 0.06],
        [work - SINK, work + 0.012],
        [bay.low.z + 0.08, bay.low.z + bay.depth() * 0.56],
    );
    builder.block("rubber", belt, 0.004);
    for side in [Side::Front, Side::Back] {
        builder.cuboid(
            "metal",
            belt.slab(side, 0.02).with_y([work - SINK * 0.6, work + 0.03]).inset(-0.01, 0.0, -0.012),
        );
    }
    builder.cuboid(
        "metal",
        Bay::new([recess[0] - 0.04, recess[1] * 0.8], [work - SINK, work + 0.006], belt.z()),
    );
    builder.cuboid(
        "screen",
        Bay::new([recess[0], recess[1] * 0.62], [work + 0.005, work + 0.009], belt.inset(0.0, 0.0, 0.06).z()),
    );
    for (index, slot) in ["paper", "book", "leaf", "fabric_accent"].into_iter().enumerate() {
        let item = Bay::around(
            DVec3::new(
                belt.low.x + 0.15 + 0.17 * index as f64,
                0.0,
                belt.center().z + 0.06 * (index % 2) as f64,
            ),
            0.1,
            0.1,
            0.07,
        );
        if item.high.x < belt.high.x {
            builder.cuboid(slot, item.with_y([work + 0.012 - SINK, work + 0.07 + 0.03 * (index % 3) as f64]));
        }
    }
    // The packing bay slopes to its end.
    let chute = [
        (recess[1] + 0.04, work + 0.05),
        (body.high.x - 0.03, work + 0.004),
        (body.high.x - 0.03, work - 0.01),
        (recess[1] + 0.04, work - 0.01),
    ]
    .map(DVec2::from);
    builder.add("metal", extrude(&chute, Axis::Z, [bay.low.z + 0.07, bay.high.z - 0.07]));
    let post = DVec3::new(recess[1] * 0.7, 0.0, bay.low.z + bay.depth() * 0.66);
    builder
        .add("metal_dark", cylinder(0.016, [work - SINK, bay.high.y - 0.03], 8).moved(post.x, 0.0, post.z));
    let screen = Bay::around(DVec3::new(post.x, bay.high.y - 0.1, post.z + 0.02), 0.28, 0.2, 0.025)
        .with_y([bay.high.y - 0.19, bay.high.y]);
    builder.block("plastic_dark", screen, 0.005);
    builder.cuboid(
        "screen",
        screen.inset(0.012, 0.012, 0.0).with_z([screen.high.z - SINK, screen.high.z + 0.002]),
    );
}
