//! Checkouts of shops: belts 0.4 to 0.5 m wide, 0.8 to 0.9 m over the floor; the cashier sits before a recess.

use glam::{DVec2, DVec3};

use crate::catalog::Side;
use crate::model::kit::{Axis, Bay, Builder, SINK, cylinder, extrude};
use crate::model::recipes::input::Draft;

/// Share of the height at which belt and scanner lie.
const WORK: f64 = 0.84;
/// Metres of the kick plate.
const KICK: f64 = 0.08;

/// A till place: a belt, a scanner, a bay to pack in and a screen on a post.
pub(in super::super) fn checkout(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let slot = ["laminate", "painted_accent", "metal", "wood"][draft.input.look as usize % 4];
    let work = bay.height() * WORK;
    builder.cuboid("plastic_dark", bay.with_y([0.0, KICK + SINK]).inset(0.04, 0.0, 0.04));
    let body = bay.with_y([KICK, work]);
    let recess = [bay.width() * 0.02, bay.width() * 0.02 + body.width() * 0.26];
    counter(builder, slot, body, recess);
    let belt = Bay::new(
        [body.low.x + 0.03, recess[0] - 0.06],
        [work - SINK, work + 0.012],
        [bay.low.z + 0.08, bay.low.z + bay.depth() * 0.56],
    );
    conveyor(builder, belt, work);
    builder.cuboid(
        "metal",
        Bay::new([recess[0] - 0.04, recess[1] * 0.8], [work - SINK, work + 0.006], belt.z()),
    );
    builder.cuboid(
        "screen",
        Bay::new([recess[0], recess[1] * 0.62], [work + 0.005, work + 0.009], belt.inset(0.0, 0.0, 0.06).z()),
    );
    shopping(builder, belt, work);
    // The packing bay slopes to its end.
    let chute = [
        (recess[1] + 0.04, work + 0.05),
        (body.high.x - 0.03, work + 0.004),
        (body.high.x - 0.03, work - 0.01),
        (recess[1] + 0.04, work - 0.01),
    ]
    .map(DVec2::from);
    builder.add("metal", extrude(&chute, Axis::Z, [bay.low.z + 0.07, bay.high.z - 0.07]));
    let post = DVec3::new(recess[1] * 0.7, work, bay.low.z + bay.depth() * 0.66);
    screen_on_post(builder, post, bay.high.y);
}

/// The body: closed towards the customers, who stand behind, with a recess for the cashier before it.
fn counter(builder: &mut Builder, slot: &'static str, body: Bay, recess: [f64; 2]) {
    let bay = builder.bay();
    builder.block(slot, body.without(Side::Front, bay.depth() * 0.42).inset(0.0, 0.0, 0.001), 0.006);
    for ends in [[body.low.x, recess[0]], [recess[1], body.high.x]] {
        let part = body.slab(Side::Front, bay.depth() * 0.42 + 0.02).with_x(ends);
        builder.block(slot, part.inset(0.002, 0.001, 0.0), 0.006);
    }
    let work = body.high.y;
    builder.cuboid(
        "metal",
        bay.slab(Side::Back, 0.012).with_y([work * 0.3, work * 0.36]).inset(0.001, 0.0, 0.0),
    );
}

/// A belt between two rails.
fn conveyor(builder: &mut Builder, belt: Bay, work: f64) {
    builder.block("rubber", belt, 0.004);
    for side in [Side::Front, Side::Back] {
        let rail = belt.slab(side, 0.02).with_y([work - SINK * 0.6, work + 0.03]);
        builder.cuboid("metal", rail.inset(-0.01, 0.0, -0.012));
    }
}

/// What lies on the belt.
fn shopping(builder: &mut Builder, belt: Bay, work: f64) {
    for (index, slot) in ["paper", "book", "leaf", "fabric_accent"].into_iter().enumerate() {
        let x = belt.low.x + 0.15 + 0.17 * index as f64;
        let z = belt.center().z + 0.06 * (index % 2) as f64;
        let item = Bay::around(DVec3::new(x, 0.0, z), 0.1, 0.1, 0.07);
        if item.high.x < belt.high.x {
            builder.cuboid(slot, item.with_y([work + 0.012 - SINK, work + 0.07 + 0.03 * (index % 3) as f64]));
        }
    }
}

/// A screen whose upper edge is at `high`, on a post from a point of the counter.
fn screen_on_post(builder: &mut Builder, post: DVec3, high: f64) {
    let pole = cylinder(0.016, [post.y - SINK, high - 0.03], 8);
    builder.add("metal_dark", pole.moved(post.x, 0.0, post.z));
    let screen = Bay::around(DVec3::new(post.x, high - 0.1, post.z + 0.02), 0.28, 0.2, 0.025);
    let screen = screen.with_y([high - 0.19, high]);
    builder.block("plastic_dark", screen, 0.005);
    builder.cuboid(
        "screen",
        screen.inset(0.012, 0.012, 0.0).with_z([screen.high.z - SINK, screen.high.z + 0.002]),
    );
}
