//! Normals of a solid's corners.

use glam::DVec3;

use super::solid::{Shading, Solid};

/// One unit normal for each corner of each triangle.
///
/// Under [`Shading::Crease`], the triangles around a point that hang together over edges below the crease angle share one
/// normal: their mean, weighted by their angle at the point (G. Thürmer and C. Wüthrich, *Computing Vertex Normals from
/// Polygonal Facets*, 1998), so that it does not depend on how a face is cut into triangles. Where that mean is farther
/// than the crease angle from a triangle, as at the tip of a needle, it has the mean of those within the angle.
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
    let weighted =
        |[index, corner]: [usize; 2]| faces[index] * angle_at(solid, solid.triangles[index], corner);
    let mut meeting: Vec<Vec<[usize; 2]>> = vec![Vec::new(); solid.points.len()];
    for (index, triangle) in solid.triangles.iter().enumerate() {
        (0..3).for_each(|corner| meeting[triangle[corner]].push([index, corner]));
    }
    let mut normals: Vec<[DVec3; 3]> = faces.iter().map(|&face| [face; 3]).collect();
    let mut surfaces = Vec::new();
    for corners in &meeting {
        find_smooth_surfaces(&mut surfaces, solid, &faces, corners, limit);
        let sum_of = |surface: usize| -> DVec3 {
            let own = corners.iter().zip(&surfaces).filter(|(_, other)| **other == surface);
            own.map(|(&corner, _)| weighted(corner)).sum()
        };
        let mut mean = (usize::MAX, DVec3::ZERO);
        for (&[index, corner], &surface) in corners.iter().zip(&surfaces) {
            if mean.0 != surface {
                mean = (surface, sum_of(surface).normalize_or_zero());
            }
            let face = faces[index];
            normals[index][corner] = if mean.1.dot(face) >= limit {
                mean.1
            } else {
                let near = corners.iter().filter(|[other, _]| faces[*other].dot(face) >= limit);
                near.map(|&corner| weighted(corner)).sum::<DVec3>().try_normalize().unwrap_or(face)
            };
        }
    }
    normals
}

/// Finds which of the triangles around a point hang together over edges at it that are less sharp than the limit, the cosine
/// of the angle between faces: for each, the first of them. The list is the caller's, for there are many points.
fn find_smooth_surfaces(
    surfaces: &mut Vec<usize>,
    solid: &Solid,
    faces: &[DVec3],
    corners: &[[usize; 2]],
    limit: f64,
) {
    let ends = |[index, corner]: [usize; 2]| [1, 2].map(|step| solid.triangles[index][(corner + step) % 3]);
    surfaces.clear();
    for (second, &other) in corners.iter().enumerate() {
        surfaces.push(second);
        let [left, right] = ends(other);
        for (first, &one) in corners[..second].iter().enumerate() {
            let [a, b] = ends(one);
            let has_edge = a == left || a == right || b == left || b == right;
            let (here, there) = (surfaces[second], surfaces[first]);
            if has_edge && here != there && faces[one[0]].dot(faces[other[0]]) >= limit {
                let (kept, gone) = (here.min(there), here.max(there));
                surfaces.iter_mut().filter(|surface| **surface == gone).for_each(|surface| *surface = kept);
            }
        }
    }
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
    use super::super::{Bay, crowned, cuboid, cylinder};
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

    #[test]
    fn a_surface_without_sharp_edges_has_one_normal_at_each_point() {
        // Around the rim of a cushion faces turn by more than the crease angle, but over several edges.
        let solid = crowned(Bay::new([-0.4, 0.4], [0.0, 0.16], [-0.3, 0.3]), 0.03, 0.04);
        let mut first: Vec<Option<DVec3>> = vec![None; solid.points.len()];
        let underside = |normals: &[DVec3; 3]| normals.iter().all(|normal| normal.y < -0.999);
        for (triangle, normals) in solid.triangles.iter().zip(corner_normals(&solid)) {
            for (&point, normal) in triangle.iter().zip(normals).filter(|_| !underside(&normals)) {
                assert!(first[point].get_or_insert(normal).distance(normal) < 1e-9, "point {point}");
            }
        }
    }
}
