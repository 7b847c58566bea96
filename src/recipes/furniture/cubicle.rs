//! Toilet cubicles.

use glam::DVec3;

use super::parts::{ball, turned_forward, wall_panel};
use super::toilets::toilet_in;
use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, SINK, cylinder, lathe, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// Width, height and depth in metres of the toilet in a cubicle.
const BOWL: DVec3 = DVec3::new(0.38, 0.8, 0.66);
/// Radians by which the door stands open.
const AJAR: f64 = 0.5;

/// Measures of the partition walls of a set, in metres.
struct Walls {
    set: GeometrySet,
    color: Slot,
    thickness: f64,
    /// The floor under them that stays open.
    foot: f64,
    /// From their upper edge to the top of the box.
    head: f64,
}

impl Walls {
    fn new(draft: &Draft, height: f64) -> Self {
        let set = draft.set();
        let (colors, [thickness, foot, head]) = match set {
            GeometrySet::Plain => {
                ([Slot::Laminate, Slot::Painted, Slot::PaintedAccent, Slot::WoodLight], [0.035, 0.03, 0.0])
            }
            GeometrySet::Traditional => {
                ([Slot::WoodDark, Slot::Painted, Slot::Wood, Slot::PaintedAccent], [0.04, 0.1, 0.1])
            }
            GeometrySet::Industrial => {
                ([Slot::MetalDark, Slot::Metal, Slot::PaintedAccent, Slot::Painted], [0.02, 0.24, 0.14])
            }
            GeometrySet::Budget => {
                ([Slot::Laminate, Slot::PaintedAccent, Slot::Plastic, Slot::Painted], [0.025, 0.15, 0.03])
            }
        };
        // Usual cubicles are two metres high.
        let [foot, head] = [foot, head].map(|length| length * (height / 2.0).min(1.0));
        Self { set, color: colors[draft.form()], thickness, foot, head }
    }
}

/// A toilet between partition walls with a door that stands ajar: walls down to a plinth, panelled ones with knobs on
/// their posts, sheets between pipes, or boards on feet under a rail.
pub(super) static TOILET_CUBICLE: Recipe =
    Recipe::furniture("toilet_cubicle", [0.95, 1.5, 2.0]).symbol(Symbol::Toilet).every_set(toilet_cubicle);

fn toilet_cubicle(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let walls = Walls::new(draft, bay.height());
    let bowl = BOWL.min(bay.extent() * 0.8);
    let seat = bay.with_x([-bowl.x / 2.0, bowl.x / 2.0]).with_y([bay.low.y, bay.low.y + bowl.y]);
    toilet_in(seat.slab(Side::Back, bowl.z), GeometrySet::Budget, draft.input.look, builder);
    let panels = bay.without(Side::Below, walls.foot).without(Side::Above, walls.head);
    for side in [Side::Left, Side::Right] {
        side_wall(builder, &walls, panels, side);
    }
    rail(builder, &walls, panels);
    front(builder, &walls, panels);
    let roll = turned_forward(cylinder(0.055, [-0.05, 0.05], 10));
    let x = bay.low.x + walls.thickness + 0.056;
    let at = DVec3::new(x, 0.72_f64.min(bay.height() * 0.4), bay.low.z + bowl.z);
    builder.add(Slot::Paper, roll.moved(at.x, at.y, at.z));
    builder.cuboid(Slot::Chrome, Bay::around(at + DVec3::new(-0.028, 0.056, 0.0), 0.057, 0.006, 0.09));
}

/// A wall and what it stands on.
fn side_wall(builder: &mut Builder, walls: &Walls, panels: Bay, side: Side) {
    let bay = builder.bay();
    let thickness = walls.thickness;
    let wall = panels.slab(side, thickness);
    let strip = bay.slab(side, thickness);
    match walls.set {
        GeometrySet::Plain => {
            builder.cuboid(walls.color, wall);
            let plinth = strip.inset(thickness * 0.2, 0.0, 0.01).with_y([bay.low.y, panels.low.y + SINK]);
            builder.cuboid(Slot::MetalDark, plinth);
        }
        GeometrySet::Traditional => {
            builder.cuboid(walls.color, wall.inset(thickness * 0.25, 0.004, thickness * 0.5));
            for end in [Side::Front, Side::Back] {
                let post = strip.slab(end, thickness * 1.6).with_y([bay.low.y, panels.high.y + 0.02]);
                builder.cuboid(walls.color, post);
                let knob = ball(thickness * 0.5, 8).stretched(DVec3::new(1.0, walls.head / thickness, 1.0));
                let at = post.center();
                let lift = bay.high.y - walls.head * 0.5;
                builder.add(walls.color, knob.moved(at.x, lift, at.z));
            }
            for y in [panels.low.y, (panels.low.y + panels.high.y) / 2.0, panels.high.y - 0.1] {
                let cross = strip.inset(0.001, 0.0, thickness * 1.6 - SINK).with_y([y, y + 0.1]);
                builder.cuboid(walls.color, cross);
            }
        }
        GeometrySet::Industrial => {
            builder.cuboid(walls.color, wall.inset(thickness * 0.3, 0.0, thickness * 0.4));
            let radius = thickness * 0.5;
            for end in [Side::Front, Side::Back] {
                let post = strip.slab(end, thickness).center();
                builder.add(Slot::Metal, cylinder(radius, bay.y(), 8).moved(post.x, 0.0, post.z));
            }
        }
        GeometrySet::Budget => {
            builder.cuboid(walls.color, wall);
            for end in [Side::Front, Side::Back] {
                let post = strip.inset(thickness * 0.2, 0.0, 0.0).with_y([bay.low.y, panels.low.y + SINK]);
                builder.cuboid(Slot::Metal, post.slab(end, thickness).inset(0.0, 0.0, SINK));
            }
        }
    }
}

/// What holds the walls together over the door.
fn rail(builder: &mut Builder, walls: &Walls, panels: Bay) {
    let bay = builder.bay();
    let thickness = walls.thickness;
    match walls.set {
        GeometrySet::Plain => {}
        GeometrySet::Traditional => {
            let rail = bay.slab(Side::Front, thickness * 1.4).inset(thickness - SINK, 0.0, 0.0);
            let rail = rail.with_y([panels.high.y - 0.06, panels.high.y + 0.012]);
            builder.block(walls.color, rail.without(Side::Front, 0.002), 0.01);
        }
        GeometrySet::Industrial => {
            let z = bay.high.z - thickness * 0.5;
            let y = bay.high.y - walls.head * 0.5;
            let pipe = [DVec3::new(bay.low.x + 0.004, y, z), DVec3::new(bay.high.x - 0.004, y, z)];
            builder.add(Slot::Metal, sweep(&pipe, thickness * 0.4, 8));
        }
        GeometrySet::Budget => {
            let rail = bay.slab(Side::Above, walls.head + SINK).slab(Side::Front, thickness);
            builder.cuboid(Slot::Metal, rail.inset(0.001, 0.0, 0.001));
        }
    }
}

/// The strips beside the door, and the door, which opens inwards.
fn front(builder: &mut Builder, walls: &Walls, panels: Bay) {
    let thickness = walls.thickness;
    let low = if walls.set == GeometrySet::Traditional { 0.06 } else { 0.001 };
    let front = panels.slab(Side::Front, thickness).inset(thickness - SINK, 0.001, 0.001);
    let front = front.without(Side::Above, low);
    let beside = (front.width() * 0.13).max(0.01);
    for side in [Side::Left, Side::Right] {
        builder.cuboid(walls.color, front.slab(side, beside).inset(0.0, 0.0, thickness * 0.1));
    }
    let opening = front.inset(beside + 0.004, 0.004, 0.0);
    let mut door = builder.empty();
    let leaf = Bay::new([0.0, opening.width()], opening.y(), [-thickness * 0.6, 0.0]);
    wall_panel(&mut door, walls.set, walls.color, leaf);
    let lock = DVec3::new(leaf.high.x - 0.06, panels.center().y, 0.0);
    door.cuboid(Slot::Chrome, Bay::around(lock, 0.05, 0.05, 0.024));
    for y in [0.12, 0.85] {
        let hinge = lathe(&[(0.009, 0.0), (0.009, 0.07)], 6);
        door.add(Slot::Metal, hinge.moved(0.004, leaf.low.y + leaf.height() * y, 0.006));
    }
    for (slot, solid) in door.into_parts() {
        builder.add(slot, solid.turned_y(AJAR).moved(opening.low.x, 0.0, opening.high.z - 0.012));
    }
}
