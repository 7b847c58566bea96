//! Normals of a solid's corners.

use glam::DVec3;

use super::solid::{Shading, Solid};

/// One unit normal for each corner of each triangle.
///
/// Under [`Shading::Crease`], a corner's normal is the mean of the triangles that meet there within the crease
/// angle, weighted by their angle at the corner (G. Thürmer and C. Wüthrich, *Computing Vertex Normals from
/// Polygonal Facets*, 1998), so that it does not depend on how a face is cut into triangles.
pub(super) fn corner_normals(solid: &Solid) -> Vec<[DVec3; 3]> {
    match &solid.shading {
        Shading::Given(normals) => {
            solid.triangles.iter().map(|triangle| triangle.map(|point| normals[point])).collect()
        }
        Shading::Crease(angle) => creased(solid, libm::cos(*angle)),
    }
}

fn creased(solid: &Solid, limit: f64) -> Vec<[DVec3; 3]> {
    let faces: Vec<DVec3> = solid.triangles.iter().map(|&triangle| face_normal(solid, triangle)).collect();
    let mut meeting: Vec<Vec<(usize, f64)>> = vec![Vec::new(); solid.points.len()];
    for (index, triangle) in solid.triangles.iter().enumerate() {
        for corner in 0..3 {
            meeting[triangle[corner]].push((index, angle_at(solid, *triangle, corner)));
        }
    }
    let normal = |face: DVec3, point: usize| {
        let near = meeting[point].iter().filter(|&&(other, _)| faces[other].dot(face) >= limit);
        let sum: DVec3 = near.map(|&(other, angle)| faces[other] * angle).sum();
        sum.try_normalize().unwrap_or(face)
    };
    let triangles = solid.triangles.iter().zip(&faces);
    triangles.map(|(triangle, &face)| triangle.map(|point| normal(face, point))).collect()
}

/// Unit normal of a triangle; straight up for one without area, which no solid of the kit has.
fn face_normal(solid: &Solid, [a, b, c]: [usize; 3]) -> DVec3 {
    let (a, b, c) = (solid.points[a], solid.points[b], solid.points[c]);
    (b - a).cross(c - a).try_normalize().unwrap_or(DVec3::Y)
}

fn angle_at(solid: &Solid, triangle: [usize; 3], corner: usize) -> f64 {
    let [here, next, last] = [0, 1, 2].map(|step| solid.points[triangle[(corner + step) % 3]]);
    let cosine = (next - here).normalize_or_zero().dot((last - here).normalize_or_zero());
    libm::acos(cosine.clamp(-1.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::super::{Bay, cuboid, cylinder};
    use super::*;

    #[test]
    fn a_box_has_flat_faces() {
        let solid = cuboid(Bay::new([0.0, 1.0], [0.0, 1.0], [0.0, 1.0]));
        for (triangle, normals) in solid.triangles.iter().zip(corner_normals(&solid)) {
            let face = face_normal(&solid, *triangle);
            assert!(normals.iter().all(|normal| normal.distance(face) < 1e-9));
        }
    }

    #[test]
    fn a_cylinder_is_smooth_around_and_sharp_at_the_rims() {
        let solid = cylinder(0.5, [0.0, 1.0], 12);
        let mut cap_count = 0;
        for (triangle, normals) in solid.triangles.iter().zip(corner_normals(&solid)) {
            for (point, normal) in triangle.iter().zip(normals) {
                let outward = DVec3::new(solid.points[*point].x, 0.0, solid.points[*point].z).normalize();
                let is_cap = normal.y.abs() > 0.999;
                cap_count += usize::from(is_cap);
                assert!(is_cap || normal.dot(outward) > 0.999, "{normal}");
            }
        }
        assert_eq!(cap_count, 2 * 10 * 3);
    }
}
