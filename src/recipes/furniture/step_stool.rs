//! Step stools: two treads, the upper one behind the lower one.

use glam::DVec2;

use crate::geometry::Side;
use crate::recipes::kit::{Axis, Bay, Builder, SINK, cuboid, extrude};
use crate::recipes::{Draft, Recipe, Slot};

/// Metres of a tread's thickness.
const TREAD: f64 = 0.024;

/// Two treads on cheeks of wood, or on frames of steel.
pub(super) static STEP_STOOL: Recipe =
    Recipe::furniture("step_stool", [0.42, 0.4, 0.45]).plain(on_cheeks).industrial(on_frames);

/// The lower and the upper tread of a box: each is half as deep.
fn treads(bay: Bay) -> [Bay; 2] {
    let lower = bay.with_y([0.0, bay.height() / 2.0]).with_z([0.0, bay.high.z]);
    let upper = bay.with_z([bay.low.z, 0.02]);
    [lower, upper].map(|under| under.slab(Side::Above, TREAD))
}

/// Boards between two cheeks that are cut like stairs; the look chooses the wood.
fn on_cheeks(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let wood = draft.sampler().pick(&[Slot::Wood, Slot::WoodLight, Slot::Painted]);
    let [lower, upper] = treads(bay).map(|tread| tread.low.y + SINK);
    let (back, front) = (bay.low.z + 0.01, bay.high.z - 0.02);
    let stairs = [(back, 0.0), (front, 0.0), (front, lower), (0.01, lower), (0.01, upper), (back, upper)];
    let cheek = extrude(&stairs.map(DVec2::from), Axis::X, [bay.high.x - 0.045, bay.high.x - 0.02]);
    builder.add_pair(wood, cheek);
    treads(bay).into_iter().for_each(|tread| builder.block(wood, tread, 0.004));
}

/// Plates on four square posts, with rubber feet.
fn on_frames(_: &Draft, builder: &mut Builder) {
    for tread in treads(builder.bay()) {
        builder.block(Slot::Metal, tread, 0.003);
        let under = tread.with_y([0.0, tread.low.y + SINK]).inset(0.015, 0.0, 0.014);
        for side in [Side::Front, Side::Back] {
            let post = under.slab(Side::Right, 0.025).slab(side, 0.025);
            builder.add_pair(Slot::MetalDark, cuboid(post.without(Side::Below, 0.015 - SINK)));
            let foot = post.inset(-0.002, 0.0, -0.002).slab(Side::Below, 0.015);
            builder.add_pair(Slot::Rubber, cuboid(foot));
        }
    }
}
