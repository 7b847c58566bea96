//! Tangents for normal maps.

use glam::{Vec2, Vec3, Vec4};

use crate::model::Primitive;

/// One tangent per corner for a set of texture coordinates, with its handedness, as glTF 2.0 (3.7.2.1) defines it: the
/// direction in which `u` grows, at right angles to the normal.
///
/// Corners are not split: a corner's tangent is the mean of its triangles, which for the projections of recipes and shell
/// all say the same.
pub(crate) fn tangents(primitive: &Primitive, set: usize) -> Vec<[f32; 4]> {
    let coordinates = primitive.coordinate_sets().nth(set).unwrap_or(&primitive.texture_coordinates);
    let position = |index: u32| Vec3::from_array(primitive.positions[index as usize]);
    let coordinate = |index: u32| Vec2::from_array(coordinates[index as usize]);
    let mut along = vec![Vec3::ZERO; primitive.positions.len()];
    let mut handedness = vec![0.0_f32; along.len()];
    for &[a, b, c] in primitive.indices.as_chunks::<3>().0 {
        let (first, second) = (position(b) - position(a), position(c) - position(a));
        let (u, v) = (coordinate(b) - coordinate(a), coordinate(c) - coordinate(a));
        let area = u.perp_dot(v);
        // Weighted by area in the image; without one, a triangle gives no direction.
        let direction = (first * v.y - second * u.y) * area.signum();
        for corner in [a, b, c] {
            along[corner as usize] += direction;
            // Rows of an image go down, so an image that is not mirrored has a negative area.
            handedness[corner as usize] -= area;
        }
    }
    let normals = primitive.normals.iter().map(|&normal| Vec3::from_array(normal));
    let corners = normals.zip(along).zip(handedness);
    corners.map(|((normal, along), handedness)| tangent(normal, along, handedness).to_array()).collect()
}

fn tangent(normal: Vec3, along: Vec3, handedness: f32) -> Vec4 {
    let flat = along - normal * normal.dot(along);
    let unit = flat.try_normalize().unwrap_or_else(|| normal.any_orthonormal_vector());
    unit.extend(if handedness < 0.0 { -1.0 } else { 1.0 })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gltf::join::tests::recipe;

    /// A square that looks at +Z, its image upright (`v` goes down) or mirrored left to right.
    fn square(is_mirrored: bool) -> Primitive {
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let u = |x: f32| if is_mirrored { -x } else { x };
        Primitive {
            positions: corners.map(|[x, y]| [x, y, 0.0]).to_vec(),
            normals: vec![[0.0, 0.0, 1.0]; 4],
            texture_coordinates: corners.map(|[x, y]| [u(x), -y]).to_vec(),
            indices: vec![0, 1, 2, 0, 2, 3],
            ..Primitive::default()
        }
    }

    #[test]
    fn tangents_follow_the_image_to_the_right() {
        assert!(tangents(&square(false), 0).iter().all(|&tangent| tangent == [1.0, 0.0, 0.0, 1.0]));
        assert!(tangents(&square(true), 0).iter().all(|&tangent| tangent == [-1.0, 0.0, 0.0, -1.0]));
    }

    #[test]
    fn tangents_of_a_model_are_unit_vectors_along_its_surface_and_right_handed() {
        for primitive in recipe("sofa") {
            for (tangent, normal) in tangents(&primitive, 0).into_iter().zip(&primitive.normals) {
                let along = Vec4::from_array(tangent).truncate();
                assert!(
                    (along.length() - 1.0).abs() < 1e-4 && along.dot(Vec3::from_array(*normal)).abs() < 1e-4
                );
                assert_eq!(tangent[3], 1.0);
            }
        }
    }

    #[test]
    fn an_image_without_extent_gives_some_tangent() {
        let mut square = square(false);
        square.texture_coordinates = vec![[0.5, 0.5]; 4];
        assert!(tangents(&square, 0).iter().all(|tangent| tangent.iter().all(|value| value.is_finite())));
    }
}
