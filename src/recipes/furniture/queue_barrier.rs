//! Barriers of queues: posts 0.95 to 1.00 m high and 0.06 thick on feet of 0.32 to 0.36, a belt 0.05 wide or a rope between them.

use glam::DVec3;

use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, SINK, cuboid, cylinder, lathe, sweep};
use crate::recipes::{Recipe, Slot};

/// A barrier between two posts: a belt from posts of steel; a rope that hangs between posts of brass with knobs; two rails
/// between square posts; two tapes between posts of plastic on square feet.
pub(super) static QUEUE_BARRIER: Recipe = Recipe::furniture("queue_barrier", [1.8, 0.34, 1.0])
    .plain(|_, builder| belt(builder))
    .traditional(|_, builder| rope(builder))
    .industrial(|_, builder| rails(builder))
    .budget(|_, builder| tapes(builder));

/// Sideways from the middle to the axis of a post.
fn post_at(bay: Bay) -> f64 {
    bay.high.x - bay.depth() / 2.0
}

/// Posts on flat round feet, with a belt that leaves a cassette below the top.
fn belt(builder: &mut Builder) {
    let bay = builder.bay();
    let (x, radius, height) = (post_at(bay), bay.depth() / 2.0, bay.height());
    let disc = [(radius, 0.0), (radius, 0.012), (radius * 0.3, 0.03)];
    builder.add_pair(Slot::MetalDark, lathe(&disc, 16).moved(x, 0.0, 0.0));
    let post = cylinder(0.03, [0.03 - SINK, height - 0.1 + SINK], 16);
    builder.add_pair(Slot::Metal, post.moved(x, 0.0, 0.0));
    builder.add_pair(Slot::PlasticDark, cylinder(0.036, [height - 0.1, height], 16).moved(x, 0.0, 0.0));
    let belt = Bay::new([-x, x], [height - 0.08, height - 0.03], [-0.002, 0.002]);
    builder.cuboid(Slot::PaintedAccent, belt);
}

/// Thin posts on square feet of rubber, with a tape at the top and another at half the height.
fn tapes(builder: &mut Builder) {
    let bay = builder.bay();
    let (x, height) = (post_at(bay), bay.height());
    let foot = bay.with_x([bay.high.x - bay.depth(), bay.high.x]).with_y([0.0, 0.06]);
    builder.add_pair(Slot::Rubber, cuboid(foot));
    builder.add_pair(Slot::Plastic, cylinder(0.022, [0.06 - SINK, height], 8).moved(x, 0.0, 0.0));
    for top in [height - 0.02, height * 0.55] {
        let tape = Bay::new([-x, x], [top - 0.06, top], [-0.002, 0.002]);
        builder.cuboid(Slot::PaintedAccent, tape);
    }
}

/// Turned posts with knobs, and a rope in a curve.
fn rope(builder: &mut Builder) {
    let bay = builder.bay();
    let (x, radius, height) = (post_at(bay), bay.depth() / 2.0, bay.height());
    let turned = [
        (radius, 0.0),
        (radius, 0.015),
        (radius * 0.55, 0.05),
        (0.026, 0.07),
        (0.024, height - 0.13),
        (0.04, height - 0.12),
        (0.04, height - 0.09),
        (0.02, height - 0.08),
        (0.036, height - 0.04),
        (0.012, height),
    ];
    builder.add_pair(Slot::Brass, lathe(&turned, 12).moved(x, 0.0, 0.0));
    let hang = |share: f64| DVec3::new(x * share, height - 0.105 - 0.22 * (1.0 - share * share), 0.0);
    let curve: Vec<DVec3> = (-4..=4).map(|step| hang(f64::from(step) / 4.0)).collect();
    builder.add(Slot::Fabric, sweep(&curve, 0.018, 8));
}

/// Square posts on cross feet, and two rails.
fn rails(builder: &mut Builder) {
    let bay = builder.bay();
    let (x, height) = (post_at(bay), bay.height());
    let post = bay.with_x([x - 0.02, x + 0.02]).with_z([-0.02, 0.02]);
    builder.add_pair(Slot::MetalDark, cuboid(post.without(Side::Below, 0.03 - SINK)));
    let foot = bay.with_x([x - 0.03, bay.high.x]).with_y([0.0, 0.03]);
    builder.add_pair(Slot::MetalDark, cuboid(foot));
    for top in [height - 0.03, height * 0.55] {
        let rail = Bay::new([-x, x], [top - 0.035, top], [-0.015, 0.015]);
        builder.cuboid(Slot::PaintedAccent, rail);
    }
}
