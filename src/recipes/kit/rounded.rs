//! Boxes: sharp, chamfered, soft.

use glam::DVec3;

use super::Bay;
use super::solid::{Shading, Solid};

/// The largest share of an extent that one rounding may take: two that met would leave edges without length.
const LARGEST_ROUNDING: f64 = 0.46;

/// A box with sharp edges: 12 triangles.
pub(crate) fn cuboid(bay: Bay) -> Solid {
    let corner = |bits: usize| {
        let pick = |axis: usize| if bits >> axis & 1 == 1 { bay.high[axis] } else { bay.low[axis] };
        DVec3::new(pick(0), pick(1), pick(2))
    };
    let quads = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];
    let triangles = quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    Solid::new((0..8).map(corner).collect(), triangles, Shading::FLAT)
}

/// A box whose edges and corners are rounded by radii along each axis, in segments: 44 triangles for one
/// segment (a chamfer), 92 for two, 156 for three. The flat faces keep their normals, so that even a chamfer
/// is shaded round.
pub(crate) fn rounded_box(bay: Bay, radii: DVec3, segments: usize) -> Solid {
    let segments = segments.max(1);
    let radii = radii.min(bay.extent() * LARGEST_ROUNDING);
    let lattice = Lattice { segments };
    let mut points = Vec::with_capacity(8 * lattice.points_per_corner());
    let mut normals = Vec::with_capacity(points.capacity());
    for corner in 0..8 {
        let sign = DVec3::from_array([0, 1, 2].map(|axis| if corner >> axis & 1 == 1 { 1.0 } else { -1.0 }));
        let middle = bay.center() + sign * (bay.extent() / 2.0 - radii);
        for [i, j, k] in lattice.steps() {
            let direction = sign * DVec3::new(lattice.sine(i), lattice.sine(j), lattice.sine(k)).normalize();
            points.push(middle + direction * radii);
            normals.push((direction / radii).normalize());
        }
    }
    let mut triangles = corner_triangles(&lattice);
    triangles.extend(edge_triangles(&lattice));
    triangles.extend(face_triangles(&lattice));
    let center = bay.center();
    for triangle in &mut triangles {
        let [a, b, c] = triangle.map(|point| points[point]);
        // The body is convex: outwards is away from its middle.
        if (b - a).cross(c - a).dot((a + b + c) / 3.0 - center) < 0.0 {
            triangle.swap(1, 2);
        }
    }
    Solid { points, triangles, shading: Shading::Given(normals) }
}

/// The points of one rounded corner: an eighth of a sphere, cut into `segments` along each border. A point is
/// named by three steps that add up to `segments`; `[segments, 0, 0]` belongs to the flat face across x.
struct Lattice {
    segments: usize,
}

impl Lattice {
    fn points_per_corner(&self) -> usize {
        (self.segments + 1) * (self.segments + 2) / 2
    }

    fn steps(&self) -> impl Iterator<Item = [usize; 3]> {
        let n = self.segments;
        (0..=n).flat_map(move |i| (0..=n - i).map(move |j| [i, j, n - i - j]))
    }

    fn index(&self, corner: usize, [i, j, _]: [usize; 3]) -> usize {
        let before: usize = (0..i).map(|row| self.segments + 1 - row).sum();
        corner * self.points_per_corner() + before + j
    }

    fn sine(&self, step: usize) -> f64 {
        libm::sin(std::f64::consts::FRAC_PI_2 * step as f64 / self.segments as f64)
    }
}

fn corner_triangles(lattice: &Lattice) -> Vec<[usize; 3]> {
    let n = lattice.segments;
    let mut triangles = Vec::new();
    for corner in 0..8 {
        let at = |i, j, k| lattice.index(corner, [i, j, k]);
        for (i, j) in (0..n).flat_map(|i| (0..n - i).map(move |j| (i, j))) {
            let k = n - 1 - i - j;
            triangles.push([at(i + 1, j, k), at(i, j + 1, k), at(i, j, k + 1)]);
            if k > 0 {
                triangles.push([at(i, j + 1, k), at(i + 1, j, k), at(i + 1, j + 1, k - 1)]);
            }
        }
    }
    triangles
}

fn edge_triangles(lattice: &Lattice) -> Vec<[usize; 3]> {
    let n = lattice.segments;
    let mut triangles = Vec::new();
    for axis in 0..3 {
        let (across, other) = ((axis + 1) % 3, (axis + 2) % 3);
        for corner in (0..8).filter(|corner| corner >> axis & 1 == 0) {
            let at = |end: usize, step: usize| {
                let mut steps = [0; 3];
                (steps[across], steps[other]) = (n - step, step);
                lattice.index(corner | end << axis, steps)
            };
            for step in 0..n {
                triangles.push([at(0, step), at(1, step), at(1, step + 1)]);
                triangles.push([at(0, step), at(1, step + 1), at(0, step + 1)]);
            }
        }
    }
    triangles
}

fn face_triangles(lattice: &Lattice) -> Vec<[usize; 3]> {
    let mut triangles = Vec::new();
    for axis in 0..3 {
        let mut steps = [0; 3];
        steps[axis] = lattice.segments;
        let (across, other) = (1 << ((axis + 1) % 3), 1 << ((axis + 2) % 3));
        for side in [0, 1 << axis] {
            let [a, b, c, d] = [side, side | across, side | across | other, side | other]
                .map(|corner| lattice.index(corner, steps));
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    triangles
}

#[cfg(test)]
mod tests {
    use super::super::solid::checks::assert_sound;
    use super::*;

    fn brick() -> Bay {
        Bay::new([-1.0, 1.0], [0.0, 0.5], [-0.3, 0.2])
    }

    #[test]
    fn boxes_are_closed_and_fill_their_bay() {
        let solids = [
            cuboid(brick()),
            rounded_box(brick(), DVec3::splat(0.01), 1),
            rounded_box(brick(), DVec3::new(0.2, 0.1, 0.05), 2),
            rounded_box(brick(), DVec3::splat(5.0), 4),
        ];
        for solid in solids {
            assert_sound(&solid);
            let (low, high) = solid.bounds();
            assert!(low.distance(brick().low) < 1e-12 && high.distance(brick().high) < 1e-12);
        }
    }

    #[test]
    fn triangle_counts_are_as_documented() {
        let count = |segments| rounded_box(brick(), DVec3::splat(0.01), segments).triangles.len();
        assert_eq!([cuboid(brick()).triangles.len(), count(1), count(2), count(3)], [12, 44, 92, 156]);
    }

    #[test]
    fn a_chamfer_keeps_the_normals_of_the_flat_faces() {
        let solid = rounded_box(brick(), DVec3::splat(0.01), 1);
        let Shading::Given(normals) = &solid.shading else { panic!("rounded boxes give normals") };
        assert!(normals.iter().all(|normal| normal.abs().max_element() > 0.999_999));
    }
}
