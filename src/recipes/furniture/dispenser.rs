//! Dispensers of towels on walls: folded paper in cases 0.28 to 0.3 m wide, 0.1 to 0.14 deep and 0.35 to 0.4 high,
//! cloth on rolls, paper from the middle of a roll.

use glam::DVec2;

use crate::geometry::Side;
use crate::recipes::kit::{Axis, Bay, Builder, Outline, SINK, Slice, extrude, loft};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// A dispenser on a wall: a flat case for folded paper; a cabinet from which a loop of cloth hangs; a case of steel with a
/// sloping top; a round one of plastic with a tail of paper.
pub(super) static DISPENSER: Recipe = Recipe::accessory("dispenser", [0.3, 0.14, 0.35]).every_set(dispenser);

fn dispenser(draft: &Draft, builder: &mut Builder) {
    let mut sampler = draft.sampler();
    match draft.set() {
        GeometrySet::Plain => flat(builder, sampler.pick(&[Slot::Plastic, Slot::Metal])),
        GeometrySet::Traditional => cabinet(builder, sampler.pick(&[Slot::Painted, Slot::Metal])),
        GeometrySet::Industrial => sloping(builder, sampler.pick(&[Slot::Metal, Slot::MetalDark])),
        GeometrySet::Budget => round(builder, sampler.pick(&[Slot::Plastic, Slot::PaintedAccent])),
    }
}

/// A section from the wall to the front through (share of the depth, share of the height).
fn section(bay: Bay, shares: &[(f64, f64)]) -> Vec<DVec2> {
    let corner = |&(z, y): &(f64, f64)| DVec2::new(bay.low.z + z * bay.depth(), bay.low.y + y * bay.height());
    shares.iter().map(corner).collect()
}

/// Paper that shows below a case of which `share` of the height is left free.
fn mouth(builder: &mut Builder, share: f64) {
    let bay = builder.bay();
    let mouth = bay.slab(Side::Below, bay.height() * share + SINK);
    builder.cuboid(Slot::Paper, mouth.inset(bay.width() * 0.25, 0.0, bay.depth() * 0.3));
}

/// A flat case with soft edges and a slit to see what is left.
fn flat(builder: &mut Builder, slot: Slot) {
    let bay = builder.bay();
    let body = bay.without(Side::Below, bay.height() * 0.1).without(Side::Front, bay.depth() * 0.06);
    builder.block(slot, body, bay.depth() * 0.15);
    mouth(builder, 0.1);
    let window = bay.inset(bay.width() * 0.42, bay.height() * 0.25, 0.0);
    builder.cuboid(Slot::PlasticDark, window.slab(Side::Front, bay.depth() * 0.08));
}

/// A cabinet with a round shoulder and a lock; the cloth comes out at the front and goes in again behind.
fn cabinet(builder: &mut Builder, slot: Slot) {
    let bay = builder.bay();
    let (width, height) = (bay.width(), bay.height());
    let case = [(0.0, 0.42), (0.94, 0.42), (0.94, 0.8), (0.84, 0.93), (0.62, 1.0), (0.0, 1.0)];
    builder.add(slot, extrude(&section(bay, &case), Axis::X, bay.x()));
    let loop_of_cloth = [
        (0.28, 0.43),
        (0.28, 0.1),
        (0.38, 0.0),
        (0.6, 0.0),
        (0.72, 0.1),
        (0.72, 0.43),
        (0.68, 0.43),
        (0.68, 0.12),
        (0.58, 0.03),
        (0.4, 0.03),
        (0.32, 0.12),
        (0.32, 0.43),
    ];
    let cloth = bay.inset(width * 0.12, 0.0, 0.0).x();
    builder.add(Slot::Linen, extrude(&section(bay, &loop_of_cloth), Axis::X, cloth));
    let front = |bay: Bay, out: f64| bay.slab(Side::Front, bay.depth() * 0.1).without(Side::Front, out);
    let rail = bay.inset(width * 0.08, 0.0, 0.0).with_y([height * 0.425, height * 0.47]);
    builder.cuboid(Slot::MetalDark, front(rail, 0.0));
    let lock = bay.inset(width * 0.46, 0.0, 0.0).with_y([height * 0.66, height * 0.66 + width * 0.1]);
    builder.cuboid(Slot::Brass, front(lock, bay.depth() * 0.03));
}

/// A case of folded steel: its top slopes so that nothing is laid down on it; sheets come out of a slit in front.
fn sloping(builder: &mut Builder, slot: Slot) {
    let bay = builder.bay();
    let (width, height, depth) = (bay.width(), bay.height(), bay.depth());
    let case = [(0.0, 0.0), (0.9, 0.0), (0.9, 0.66), (0.26, 1.0), (0.0, 1.0)];
    builder.add(slot, extrude(&section(bay, &case), Axis::X, bay.inset(0.002, 0.0, 0.0).x()));
    // The lid reaches over the sides.
    let lid = [(0.84, 0.62), (0.94, 0.62), (0.94, 0.68), (0.28, 1.0), (0.22, 0.98)];
    builder.add(slot, extrude(&section(bay, &lid), Axis::X, bay.x()));
    let front = bay.low.z + depth * 0.9;
    let out = |bay: Bay, from: f64, to: f64| bay.with_z([front - from, front + to]);
    let slit = bay.inset(width * 0.16, 0.0, 0.0).with_y([height * 0.1, height * 0.3]);
    builder.cuboid(Slot::PlasticDark, out(slit, SINK, 0.001));
    let sheet =
        [(0.89, 0.24), (0.93, 0.24), (1.0, 0.2), (1.0, 0.04), (0.97, 0.04), (0.97, 0.18), (0.89, 0.22)];
    builder.add(Slot::Paper, extrude(&section(bay, &sheet), Axis::X, bay.inset(width * 0.24, 0.0, 0.0).x()));
    let lock = bay.inset(width * 0.465, 0.0, 0.0).with_y([height * 0.5, height * 0.5 + width * 0.07]);
    builder.cuboid(Slot::MetalDark, out(lock, SINK, 0.004));
}

/// A case that is round in front and narrower above and below, with a window and a tail from the middle of the roll.
fn round(builder: &mut Builder, slot: Slot) {
    let bay = builder.bay();
    let (width, height, depth) = (bay.width(), bay.height(), bay.depth());
    // Half a circle before a flat back, clockwise from the right.
    let outline = [
        (1.0, -1.0),
        (-1.0, -1.0),
        (-1.0, -0.1),
        (-0.74, 0.62),
        (-0.28, 1.0),
        (0.28, 1.0),
        (0.74, 0.62),
        (1.0, -0.1),
    ];
    let slice = |(rise, share): (f64, f64)| {
        let half = depth / 2.0 * share;
        Slice::new(rise * height, width / 2.0 * share, half).at(0.0, bay.low.z + half)
    };
    let body = [(0.14, 0.7), (0.2, 0.92), (0.4, 1.0), (0.86, 0.96), (1.0, 0.72)].map(slice);
    builder.add(slot, loft(&Outline::Points(outline.map(DVec2::from).to_vec()), &body));
    let collar = [(0.08, 0.34), (0.16, 0.44)].map(|(rise, share)| {
        Slice::new(rise * height, width / 2.0 * share, depth / 2.0 * share).at(0.0, bay.low.z + depth * 0.4)
    });
    builder.add(Slot::PlasticDark, loft(&Outline::Round(6), &collar));
    let tail = Bay::new([-0.07, 0.05].map(|x| x * width), [0.0, height * 0.1], [-0.13, -0.04]);
    builder.cuboid(Slot::Paper, tail.with_z([-0.16, -0.05].map(|z| z * depth)));
    let window = bay.inset(width * 0.44, 0.0, 0.0).with_y([height * 0.42, height * 0.84]);
    builder.cuboid(
        Slot::PlasticDark,
        window.slab(Side::Front, depth * 0.14).without(Side::Front, depth * 0.005),
    );
}
