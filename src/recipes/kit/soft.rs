//! Cushions and pillows that bulge.

use glam::{DVec2, DVec3};

use super::solid::{Shading, Solid};
use super::{Bay, Outline, Slice, loft};

/// A cushion with round edges whose top bulges by `crown` metres over its sides, which stand upright: 140 triangles.
pub(crate) fn crowned(bay: Bay, radius: f64, crown: f64) -> Solid {
    let (half, height) = (bay.extent() / 2.0, bay.height());
    let crown = crown.min(height * 0.4);
    let side = height - crown;
    let radius = radius.min(half.x * 0.45).min(half.z * 0.45).min(side * 0.45);
    let slice = |y: f64, back: f64| Slice::new(y, half.x - back, half.z - back).softened(radius);
    let inner = |y: f64, share: f64| {
        Slice::new(y, half.x * share, half.z * share).softened(radius.min(half.min_element() * share * 0.5))
    };
    let slices = [
        slice(0.0, radius * 0.6),
        slice(radius * 0.5, 0.0),
        slice(side - radius * 0.5, 0.0),
        slice(side, radius * 0.4),
        inner(side + crown * 0.55, 0.78_f64.min(1.0 - radius * 0.6 / half.x.min(half.z))),
        inner(height, 0.34),
    ];
    let middle = bay.center();
    loft(&Outline::Soft(2), &slices).smooth(60.0).moved(middle.x, bay.low.y, middle.z)
}

/// Where the lines of a pillow's net lie between its edges at −1 and 1.
const NET: [f64; 6] = [-1.0, -0.82, -0.34, 0.34, 0.82, 1.0];
/// Share of the half width by which the sides of a pillow bow in between its corners.
const BOW: f64 = 0.07;

/// A pillow around the origin, flat: thick in the middle, thin at its seam, with pointed corners: 100 triangles.
pub(crate) fn pillow(width: f64, thickness: f64, depth: f64) -> Solid {
    let last = NET.len() - 1;
    let half = DVec2::new(width, depth) / 2.0;
    let is_rim = |i: usize, j: usize| i == 0 || j == 0 || i == last || j == last;
    let swell = |u: f64, v: f64| libm::sqrt((1.0 - u * u * u * u) * (1.0 - v * v * v * v));
    let most = swell(NET[last / 2], NET[last / 2]);
    let mut points = Vec::new();
    let mut index = [[[0; 2]; NET.len()]; NET.len()];
    for (i, j) in (0..=last).flat_map(|i| (0..=last).map(move |j| (i, j))) {
        let (u, v) = (NET[i], NET[j]);
        let x = u * half.x * (1.0 - BOW * (1.0 - v * v));
        let z = v * half.y * (1.0 - BOW * (1.0 - u * u));
        let swell = swell(u, v) / most;
        for side in [0, 1] {
            if side == 1 && is_rim(i, j) {
                index[i][j][1] = index[i][j][0];
                continue;
            }
            index[i][j][side] = points.len();
            points.push(DVec3::new(x, thickness / 2.0 * swell * if side == 0 { 1.0 } else { -1.0 }, z));
        }
    }
    let mut triangles = Vec::new();
    for (i, j) in (0..last).flat_map(|i| (0..last).map(move |j| (i, j))) {
        for side in [0, 1] {
            let [a, b, c, d] =
                [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| index[i][j][side]);
            // Cut from the corners to the middle: a triangle of three points of the seam would be flat.
            let is_falling = (i < last / 2) == (j < last / 2);
            let pair = if is_falling { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] };
            triangles.extend(if side == 0 { pair.map(|[a, b, c]| [a, c, b]) } else { pair });
        }
    }
    Solid::new(points, triangles, Shading::FLAT).smooth(75.0)
}

#[cfg(test)]
mod tests {
    use super::super::solid::checks::assert_sound;
    use super::*;

    #[test]
    fn pillows_are_closed_and_as_large_as_asked() {
        let solid = pillow(0.6, 0.14, 0.4);
        assert_sound(&solid);
        let (low, high) = solid.bounds();
        assert!((high - low).distance(DVec3::new(0.6, 0.14, 0.4)) < 1e-9);
        assert_eq!(solid.triangles.len(), 100);
    }

    #[test]
    fn cushions_fill_their_bay_and_bulge() {
        let bay = Bay::new([-0.4, 0.3], [0.2, 0.36], [-0.3, 0.3]);
        let solid = crowned(bay, 0.03, 0.04);
        assert_sound(&solid);
        let (low, high) = solid.bounds();
        assert!(low.distance(bay.low) < 1e-9 && high.distance(bay.high) < 1e-9);
        assert_eq!(solid.triangles.len(), 140);
        assert_sound(&crowned(Bay::new([0.0, 0.02], [0.0, 0.5], [0.0, 0.3]), 0.05, 0.3));
    }
}
