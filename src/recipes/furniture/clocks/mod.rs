//! Clocks on walls, 0.25 to 0.35 m wide and 0.05 deep, and clocks that stand, 0.1 m high.

mod standing;
mod wall;

use std::f64::consts::TAU;

use glam::DVec3;

use crate::geometry::Size;
use crate::recipes::kit::{Bay, Builder, SINK, Solid, cuboid};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// Share of the height from which a clock is deep enough to stand.
const STANDING_FROM: f64 = 0.4;

/// A clock on a wall, or one that stands, by its depth. On walls: slim; framed; a wheel of iron bars, or a drum; moulded.
/// Standing: a cube; a bow on a plinth; leaves that fall; digits that shine.
pub(super) static CLOCK: Recipe = Recipe::accessory("clock", [0.3, 0.05, 0.3]).every_set(clock);

fn clock(draft: &Draft, builder: &mut Builder) {
    let size = draft.input.size;
    let extent = DVec3::new(size.width, size.height, size.depth);
    let stretch = builder.bay().extent() / extent;
    // As wide to its height as it will be, so that what is round stays round.
    let scale = stretch.max_element();
    let mut drawing = Builder::new(Size {
        width: size.width * scale,
        depth: size.depth * scale,
        height: size.height * scale,
    });
    draw(&mut drawing, draft.set(), draft.form());
    for (slot, solid) in drawing.into_parts() {
        builder.add(slot, solid.stretched(stretch / scale));
    }
}

fn draw(builder: &mut Builder, set: GeometrySet, look: usize) {
    let bay = builder.bay();
    match (bay.depth() > bay.height() * STANDING_FROM, set) {
        (false, GeometrySet::Plain) => wall::slim(builder, look),
        (false, GeometrySet::Traditional) => wall::framed_in_wood(builder, look),
        (false, GeometrySet::Industrial) if look.is_multiple_of(2) => wall::wheel(builder, look),
        (false, GeometrySet::Industrial) => wall::drum(builder, look),
        (false, GeometrySet::Budget) => wall::moulded(builder, look),
        (true, GeometrySet::Plain) => standing::cube(builder, look),
        (true, GeometrySet::Traditional) => standing::bow(builder, look),
        (true, GeometrySet::Industrial) => standing::leaves(builder, look),
        (true, GeometrySet::Budget) => standing::digits(builder, look),
    }
}

/// A face that looks to the front: its middle on its surface, the radius of what is on it, and how far its layers are
/// apart.
struct Dial {
    middle: DVec3,
    radius: f64,
    layer: f64,
}

impl Dial {
    /// A bar from the middle outwards at a turn from upright to the left, its ends and half its width in shares of the
    /// radius, its front `lift` layers over the face.
    fn bar(&self, ends: [f64; 2], half: f64, lift: f64, turn: f64) -> Solid {
        let [inner, outer] = ends.map(|end| end * self.radius);
        let half = half * self.radius;
        let bar = Bay::new([-half, half], [inner, outer], [-SINK, lift * self.layer]);
        cuboid(bar).turned_z(turn).moved(self.middle.x, self.middle.y, self.middle.z)
    }

    /// Two hands at ten past ten, as in every shop window, and what holds them. `wide` is half a width.
    fn hands(&self, builder: &mut Builder, slot: Slot, wide: f64) {
        builder.add(slot, self.bar([-0.12, 0.54], wide, 1.0, TAU / 6.0));
        builder.add(slot, self.bar([-0.15, 0.84], wide * 0.7, 2.0, -TAU / 6.0));
        builder.add(slot, self.bar([-wide * 1.5, wide * 1.5], wide * 1.5, 3.0, 0.0));
    }

    /// A hand of seconds over the others.
    fn seconds(&self, builder: &mut Builder) {
        builder.add(Slot::PaintedAccent, self.bar([-0.2, 0.86], 0.014, 2.6, TAU * 0.45));
    }

    /// Marks all around, from twelve on.
    fn marks(&self, builder: &mut Builder, slot: Slot, count: u32, half: f64) {
        for mark in 0..count {
            let turn = TAU * f64::from(mark) / f64::from(count);
            builder.add(slot, self.bar([0.76, 0.94], half, 0.5, turn));
        }
    }
}
