//! Flat-woven strips of different lengths, and a hide.

use glam::{DVec2, DVec3};

use super::{Form, ROOT, add_panel, layer, strips};
use crate::recipes::Slot;
use crate::recipes::kit::{Axis, Bay, Builder, Outline, extrude, loft};

/// Share of the height that strips of the first colour, and the hide, have.
const GROUND: f64 = 0.9;
/// Share of the height at which every other strip begins, so that the undersides of neighbours share no plane.
const LIFTED: f64 = 0.06;

/// Which colour a strip has, its width as a share of their sum, and by which share of the rug's depth it is shorter at
/// both ends.
type Strip = (usize, f64, f64);

const EVEN: &[Strip] = &[
    (0, 1.0, 0.0),
    (1, 1.0, 0.03),
    (0, 1.0, 0.0),
    (1, 1.0, 0.03),
    (0, 1.0, 0.0),
    (1, 1.0, 0.03),
    (0, 1.0, 0.0),
];
const ENDS: &[Strip] = &[
    (1, 0.7, 0.1),
    (0, 0.35, 0.07),
    (2, 0.7, 0.035),
    (0, 6.0, 0.0),
    (2, 0.7, 0.035),
    (0, 0.35, 0.07),
    (1, 0.7, 0.1),
];
const GRADED: &[Strip] = &[
    (0, 3.0, 0.03),
    (1, 0.3, 0.055),
    (0, 2.4, 0.0),
    (1, 0.6, 0.045),
    (0, 1.8, 0.03),
    (1, 0.9, 0.0),
    (0, 1.2, 0.04),
    (1, 1.2, 0.02),
    (0, 0.6, 0.05),
    (1, 1.5, 0.025),
];

/// Even strips sewn together with their ends apart, strips at the ends that step back, ever broader ones, or the hide of a
/// cow (2.0 to 2.4 m long, 1.7 to 2.0 wide).
pub(super) fn rug(builder: &mut Builder, form: Form) {
    match form.look {
        0 => sewn(builder, form, [Slot::Fabric, Slot::FabricLight, Slot::FabricAccent], EVEN),
        1 => sewn(builder, form, [Slot::FabricLight, Slot::Fabric, Slot::FabricAccent], ENDS),
        2 => sewn(builder, form, [Slot::Carpet, Slot::FabricAccent, Slot::FabricLight], GRADED),
        _ => hide(builder),
    }
}

fn sewn(builder: &mut Builder, form: Form, slots: [Slot; 3], sewn: &[Strip]) {
    let bay = builder.bay();
    // Strips of the first colour are the ground, which others vary in width against.
    let widths: Vec<f64> =
        sewn.iter().map(|&(color, wide, _)| if color == 0 { wide } else { wide * form.scale }).collect();
    for (index, (strip, &(color, _, back))) in strips(bay, &widths).into_iter().zip(sewn).enumerate() {
        let strip = strip.inset(0.0, 0.0, back * bay.depth());
        let low = if index.is_multiple_of(2) { 0.0 } else { LIFTED };
        let top = if color == 0 { GROUND } else { 1.0 };
        add_panel(builder, slots[color], layer(strip, low, top));
    }
}

/// One side of a hide from the tail to the neck, as shares of half its length and width.
const FLANK: [(f64, f64); 14] = [
    (-1.0, 0.05),
    (-0.84, 0.16),
    (-0.86, 0.55),
    (-0.97, 0.86),
    (-0.78, 1.0),
    (-0.56, 0.72),
    (-0.1, 0.66),
    (0.34, 0.7),
    (0.5, 0.98),
    (0.7, 0.92),
    (0.68, 0.5),
    (0.8, 0.3),
    (0.97, 0.26),
    (1.0, 0.08),
];
/// Middles and half sizes of spots, as shares of the same.
const SPOTS: [[f64; 4]; 5] = [
    [-0.46, 0.3, 0.22, 0.22],
    [-0.14, -0.26, 0.24, 0.28],
    [0.28, 0.26, 0.18, 0.24],
    [0.52, -0.34, 0.11, 0.24],
    [-0.64, -0.4, 0.13, 0.2],
];
const SPOT: [(f64, f64); 7] =
    [(1.0, 0.1), (0.7, -0.6), (-0.1, -1.0), (-0.8, -0.7), (-1.0, 0.2), (-0.5, 0.9), (0.5, 1.0)];

fn hide(builder: &mut Builder) {
    let bay = builder.bay();
    let half = DVec2::new(bay.width(), bay.depth()) / 2.0;
    let near = FLANK.iter().map(|&corner| DVec2::from(corner));
    let far = near.clone().rev().map(|corner| DVec2::new(corner.x, -corner.y));
    let outline: Vec<DVec2> = near.chain(far).map(|corner| corner * half).collect();
    builder.add(Slot::FabricLight, extrude(&outline, Axis::Y, layer(bay, 0.0, GROUND).y()));
    let shape = Outline::Points(SPOT.iter().map(|&corner| DVec2::from(corner)).collect());
    for [x, z, wide, deep] in SPOTS {
        let middle = DVec3::new(x * half.x, bay.center().y, z * half.y);
        let spot = Bay::around(middle, wide * bay.width(), bay.height(), deep * bay.depth());
        let slices = layer(spot, ROOT, 1.0).y().map(|y| super::cut(spot, y, 0.0));
        builder.add(Slot::Leather, loft(&shape, &slices));
    }
}
