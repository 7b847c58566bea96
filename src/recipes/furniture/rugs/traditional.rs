//! A field with figures, borders around it, and fringes at the short ends.

use glam::{DVec2, DVec3};

use super::{BACKING, Form, ROOT, add_band, add_panel, layer};
use crate::recipes::Slot;
use crate::recipes::kit::{Axis, Bay, Builder, Outline, SINK, Shading, Solid, extrude, loft};

/// Metres of the fringes.
const FRINGE: f64 = 0.06;
/// Metres from one tassel of a fringe to the next, and share of them that a tassel is wide at its end.
const PITCH: f64 = 0.1;
const STRAND: f64 = 0.34;
/// Metres of backing that show around the borders.
const SELVAGE: f64 = 0.012;
/// Shares of the height that the field, figures on it and guard bands have; hearts of figures and borders have all of it.
const FIELD: f64 = 0.85;
const FIGURE: f64 = 0.93;

/// A medallion in a broad border, a small one in three bands, corners and a broad border with a guard, or a row of
/// lozenges.
pub(super) fn rug(builder: &mut Builder, form: Form) {
    let bay = builder.bay();
    let [field, border, guard] = [
        [Slot::FabricAccent, Slot::Fabric, Slot::FabricLight],
        [Slot::FabricLight, Slot::FabricAccent, Slot::Fabric],
        [Slot::Carpet, Slot::FabricLight, Slot::FabricAccent],
        [Slot::Fabric, Slot::FabricAccent, Slot::FabricLight],
    ][form.look];
    let woven = bay.inset(FRINGE, 0.0, 0.0);
    add_panel(builder, border, layer(woven, 0.0, BACKING));
    fringes(builder, bay);
    let mut inside = woven.inset(SELVAGE, 0.0, SELVAGE);
    let bands: &[(bool, f64)] = match form.look {
        0 => &[(false, 0.22), (true, 0.03)],
        1 => &[(true, 0.05), (false, 0.13), (true, 0.05)],
        2 => &[(true, 0.07), (false, 0.16)],
        _ => &[(false, 0.1)],
    };
    for &(is_guard, wide) in bands {
        let (slot, top) = if is_guard { (guard, FIGURE) } else { (border, 1.0) };
        inside = add_band(builder, slot, layer_of(inside, bay, top), form.band(bay, wide));
    }
    add_panel(builder, field, layer_of(inside, bay, FIELD));
    figures(builder, [border, guard], inside.with_y(bay.y()), form.look);
}

/// A piece seen from above, from inside the backing to a share of the rug's height.
fn layer_of(piece: Bay, rug: Bay, to: f64) -> Bay {
    layer(piece.with_y(rug.y()), ROOT, to)
}

/// Tassels at both short ends: strands knotted together, which spread from the backing.
fn fringes(builder: &mut Builder, bay: Bay) {
    let count = ((bay.depth() / PITCH).round() as u32).clamp(8, 24);
    let pitch = bay.depth() / f64::from(count);
    for index in 0..count {
        let z = bay.low.z + (f64::from(index) + 0.5) * pitch;
        builder.add_pair(Slot::Linen, strand(bay, z, pitch * STRAND));
    }
}

/// A strand at the right end: a knot inside the backing that runs out into a flat end, 6 triangles.
fn strand(bay: Bay, z: f64, wide: f64) -> Solid {
    let (from, to) = (bay.high.x - FRINGE * 1.2, bay.high.x);
    let at = |x: f64, up: f64, side: f64| DVec3::new(x, bay.low.y + bay.height() * up, z + side * wide / 2.0);
    let points = vec![
        at(from, 0.12, -0.6),
        at(from, 0.12, 0.6),
        at(from, 0.6, 0.0),
        at(to, 0.05, -1.0),
        at(to, 0.05, 1.0),
    ];
    let triangles = vec![[0, 1, 2], [1, 0, 3], [1, 3, 4], [2, 1, 4], [0, 2, 3], [2, 4, 3]];
    Solid::new(points, triangles, Shading::FLAT)
}

fn figures(builder: &mut Builder, [border, guard]: [Slot; 2], field: Bay, look: usize) {
    let half = DVec2::new(field.width(), field.depth()) / 2.0;
    let middle = DVec2::new(field.center().x, field.center().z);
    match look {
        0 => lozenge(
            builder,
            [guard, border],
            &OCTAGON,
            field,
            Figure { middle, half: half * DVec2::new(0.5, 0.72) },
        ),
        1 => lozenge(
            builder,
            [border, guard],
            &OCTAGON,
            field,
            Figure { middle, half: half * DVec2::new(0.24, 0.36) },
        ),
        2 => corners(builder, border, field),
        _ => {
            let count = ((field.width() / field.depth() * 2.2).round() as u32).clamp(2, 6);
            for cell in field.inset(half.x * 0.06, 0.0, 0.0).columns(count, 0.0) {
                let at = DVec2::new(cell.center().x, middle.y);
                let size = DVec2::new(cell.width() * 0.44, half.y * 0.6);
                lozenge(builder, [guard, border], &LOZENGE, field, Figure { middle: at, half: size });
            }
        }
    }
}

const LOZENGE: [(f64, f64); 4] = [(1.0, 0.0), (0.0, -1.0), (-1.0, 0.0), (0.0, 1.0)];
const OCTAGON: [(f64, f64); 8] = [
    (1.0, 0.0),
    (0.62, -0.62),
    (0.0, -1.0),
    (-0.62, -0.62),
    (-1.0, 0.0),
    (-0.62, 0.62),
    (0.0, 1.0),
    (0.62, 0.62),
];

/// Where a figure lies.
struct Figure {
    middle: DVec2,
    /// Half of its size.
    half: DVec2,
}

/// A figure on the field, with a heart of another slot.
fn lozenge(builder: &mut Builder, slots: [Slot; 2], corners: &[(f64, f64)], field: Bay, figure: Figure) {
    let Figure { middle, half } = figure;
    let outline = Outline::Points(corners.iter().map(|&corner| DVec2::from(corner)).collect());
    let heights = [(ROOT, FIGURE, 1.0), (FIELD, 1.0, 0.55)];
    for (slot, (from, to, share)) in slots.into_iter().zip(heights) {
        let piece = Bay::around(
            DVec3::new(middle.x, field.center().y, middle.y),
            half.x * 2.0 * share,
            field.height(),
            half.y * 2.0 * share,
        );
        let slices = layer(piece, from, to).y().map(|y| super::cut(piece, y, 0.0));
        builder.add(slot, loft(&outline, &slices));
    }
}

/// Triangles in the four corners of the field.
fn corners(builder: &mut Builder, slot: Slot, field: Bay) {
    let around = field.inset(-SINK, 0.0, -SINK);
    let side = DVec2::new(field.width() * 0.24, field.depth() * 0.36);
    let ends = layer(field, ROOT + 0.1, FIGURE).y();
    for (x, z) in [(1.0, 1.0), (1.0, -1.0), (-1.0, -1.0), (-1.0, 1.0)] {
        let sign = DVec2::new(x, z);
        let middle = DVec2::new(around.center().x, around.center().z);
        let corner = middle + sign * DVec2::new(around.width(), around.depth()) / 2.0;
        let profile = [corner, corner - DVec2::X * (side.x * x), corner - DVec2::Y * (side.y * z)];
        builder.add(slot, extrude(&profile, Axis::Y, ends));
    }
}
