//! Soap: a cake of 0.08 by 0.05 m in a dish, or a pump bottle of 0.06 by 0.16 m where the box is high.

use glam::DVec3;

use super::seating::depth_slats;
use crate::recipes::kit::{Bay, Builder, Outline, Slice, Solid, loft, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// Share of the width from which a box is high enough for a bottle.
const BOTTLE_FROM: f64 = 0.8;

/// A cake of soap in a dish, or a bottle with a pump; of materials that show on white basins.
pub(super) static SOAP: Recipe = Recipe::accessory("soap", [0.12, 0.08, 0.04]).every_set(soap);

fn soap(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let form = draft.form();
    if bay.height() > bay.width() * BOTTLE_FROM {
        bottle(draft.set(), builder, form);
    } else {
        dish(draft.set(), builder, form);
    }
}

/// A body through (share of the height, share of the half width), rounded in `sides` corners.
fn turned(bay: Bay, profile: &[(f64, f64)], sides: usize) -> Solid {
    let half = bay.extent() / 2.0;
    let slice = |&(rise, share): &(f64, f64)| Slice::new(rise * bay.height(), half.x * share, half.z * share);
    let slices: Vec<Slice> = profile.iter().map(slice).collect();
    if sides == 4 {
        let radius = half.min_element() * 0.2;
        let slices: Vec<Slice> = slices.into_iter().map(|slice| slice.softened(radius)).collect();
        return loft(&Outline::Soft(1), &slices);
    }
    loft(&Outline::Round(sides), &slices)
}

/// The same with half circles for its narrow sides, in eight corners.
fn oval(bay: Bay, profile: &[(f64, f64)]) -> Solid {
    let half = bay.extent() / 2.0;
    let slice = |&(rise, share): &(f64, f64)| {
        let [x, z] = [half.x, half.z].map(|half| half * share);
        Slice::new(rise * bay.height(), x, z).softened(x.min(z) * 0.6)
    };
    loft(&Outline::Soft(1), &profile.iter().map(slice).collect::<Vec<_>>()).smooth(50.0)
}

/// A bottle and its pump: tall and square, round with a shoulder, of amber glass, or of coloured plastic.
fn bottle(set: GeometrySet, builder: &mut Builder, form: usize) {
    let bay = builder.bay();
    let (slot, pump, sides): (_, _, usize) = match set {
        GeometrySet::Plain => (
            [Slot::Wood, Slot::Stone, Slot::MetalDark, Slot::PaintedAccent][form],
            Slot::MetalDark,
            [4, 12, 12, 4][form],
        ),
        GeometrySet::Traditional => {
            ([Slot::Brass, Slot::Terracotta, Slot::WoodDark, Slot::Leaf][form], Slot::Brass, 12)
        }
        GeometrySet::Industrial => {
            ([Slot::Leather, Slot::Concrete, Slot::Metal, Slot::Leather][form], Slot::PlasticDark, 10)
        }
        GeometrySet::Budget => {
            ([Slot::PaintedAccent, Slot::Leaf, Slot::Book, Slot::Brass][form], Slot::PlasticDark, 8)
        }
    };
    let body: &[(f64, f64)] = match set {
        GeometrySet::Plain => &[(0.0, 0.96), (0.03, 1.0), (0.66, 1.0), (0.7, 0.92)],
        GeometrySet::Traditional => {
            &[(0.0, 0.6), (0.05, 0.62), (0.1, 0.5), (0.34, 1.0), (0.56, 0.94), (0.7, 0.36)]
        }
        GeometrySet::Industrial => &[(0.0, 0.98), (0.04, 1.0), (0.54, 1.0), (0.64, 0.62), (0.7, 0.42)],
        GeometrySet::Budget => &[(0.0, 0.86), (0.04, 0.98), (0.4, 1.0), (0.62, 0.7), (0.7, 0.5)],
    };
    builder.add(slot, turned(bay, body, sides));
    builder.add(pump, turned(bay, &[(0.69, 0.4), (0.76, 0.38), (0.77, 0.14), (0.9, 0.14)], 8));
    let (high, radius) = (bay.high.y, bay.width() * 0.09);
    let spout = [DVec3::new(0.0, high - radius, -radius), DVec3::new(0.0, high - radius, bay.high.z * 0.8)];
    builder.add(pump, sweep(&spout, radius, 6));
    if set == GeometrySet::Budget || set == GeometrySet::Industrial {
        let label = Bay::new(
            [-bay.width() * 0.28, bay.width() * 0.28],
            [high * 0.16, high * 0.44],
            [bay.high.z * 0.7, bay.high.z],
        );
        builder.cuboid(Slot::Paper, label);
    }
}

/// A square dish, one on a foot, slats that drain or a shallow oval dish, and a cake that differs from it.
fn dish(set: GeometrySet, builder: &mut Builder, form: usize) {
    let bay = builder.bay();
    let (slot, cake) = match set {
        GeometrySet::Plain => (
            [Slot::Stone, Slot::Wood, Slot::MetalDark, Slot::Glass][form],
            [Slot::Paper, Slot::Linen, Slot::Leaf, Slot::PaintedAccent][form],
        ),
        GeometrySet::Traditional => (
            [Slot::Brass, Slot::Ceramic, Slot::Terracotta, Slot::WoodDark][form],
            [Slot::Linen, Slot::Leaf, Slot::Paper, Slot::PaintedAccent][form],
        ),
        GeometrySet::Industrial => (
            [Slot::MetalDark, Slot::WoodDark, Slot::Wood, Slot::Metal][form],
            [Slot::Leather, Slot::Linen, Slot::Paper, Slot::Terracotta][form],
        ),
        GeometrySet::Budget => (
            [Slot::PlasticDark, Slot::PaintedAccent, Slot::Plastic, Slot::Leaf][form],
            [Slot::PaintedAccent, Slot::Paper, Slot::Leaf, Slot::Linen][form],
        ),
    };
    match set {
        GeometrySet::Plain => {
            builder.add(slot, turned(bay, &[(0.0, 0.8), (0.5, 1.0), (0.6, 0.97), (0.25, 0.76)], 4));
            bar(builder, cake);
        }
        GeometrySet::Traditional => {
            let on_foot = [(0.0, 0.5), (0.15, 0.42), (0.3, 0.8), (0.56, 1.0), (0.6, 0.96), (0.32, 0.7)];
            builder.add(slot, turned(bay, &on_foot, 12));
            bar(builder, cake);
        }
        GeometrySet::Industrial => slats(builder, slot, cake),
        GeometrySet::Budget => {
            builder.add(slot, oval(bay, &[(0.0, 0.86), (0.34, 1.0), (0.16, 0.84)]));
            builder.add(cake, oval(bay, &[(0.14, 0.42), (0.5, 0.66), (0.8, 0.58), (1.0, 0.34)]));
        }
    }
}

/// A cake with round edges.
fn bar(builder: &mut Builder, cake: Slot) {
    let bay = builder.bay();
    let half = bay.extent() / 2.0;
    let bar = bay.inset(half.x * 0.36, 0.0, half.z * 0.36).with_y([bay.height() * 0.24, bay.height()]);
    builder.rounded(cake, bar, bar.extent() * DVec3::new(0.3, 0.36, 0.3), 1);
}

/// Slats over two runners, so that water drains, and a block as it is cut (Marseille soap).
fn slats(builder: &mut Builder, slot: Slot, cake: Slot) {
    let bay = builder.bay();
    let (width, height, depth) = (bay.width(), bay.height(), bay.depth());
    let low = bay.with_y([0.0, height * 0.16]);
    for runner in depth_slats(low.inset(width * 0.08, 0.0, depth * 0.12), 2, depth * 0.5) {
        builder.cuboid(slot, runner);
    }
    for slat in bay.with_y([height * 0.15, height * 0.3]).columns(4, width * 0.06) {
        builder.cuboid(slot, slat);
    }
    let block = bay.inset(width * 0.24, 0.0, depth * 0.16).with_y([height * 0.29, height]);
    builder.cuboid(cake, block);
}
