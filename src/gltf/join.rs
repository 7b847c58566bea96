//! Joins corners of a primitive that faces can share.

use hashbrown::HashMap;

use crate::model::Primitive;

/// Whether corners have colours.
pub(super) fn has_colors(primitive: &Primitive) -> bool {
    !primitive.colors.is_empty() && primitive.colors.len() == primitive.positions.len()
}

/// The same triangles without texture coordinates, where corners that agree in all that is left are one: in position and
/// colour, and in normals if there are to be any. They keep their order; those of no triangle are left out.
pub(super) fn joined(primitive: &Primitive, has_normals: bool) -> Primitive {
    joined_by(primitive, has_normals, false)
}

/// The same triangles with their first texture coordinates, where corners that agree in everything are one.
pub(super) fn joined_with_coordinates(primitive: &Primitive) -> Primitive {
    joined_by(primitive, true, true)
}

fn joined_by(primitive: &Primitive, has_normals: bool, has_coordinates: bool) -> Primitive {
    let has_colors = has_colors(primitive);
    let mut is_used = vec![false; primitive.positions.len()];
    primitive.indices.iter().for_each(|&index| is_used[index as usize] = true);
    let mut known: HashMap<[u32; 12], u32> = HashMap::with_capacity(primitive.positions.len());
    let mut made = Primitive { material: primitive.material.clone(), ..Primitive::default() };
    let mut new = vec![0; primitive.positions.len()];
    for corner in (0..new.len()).filter(|&corner| is_used[corner]) {
        let position = primitive.positions[corner];
        let normal = if has_normals { primitive.normals[corner] } else { [0.0; 3] };
        let color = if has_colors { primitive.colors[corner] } else { [0.0; 4] };
        let place = if has_coordinates { primitive.texture_coordinates[corner] } else { [0.0; 2] };
        new[corner] = *known.entry(key(position, normal, color, place)).or_insert_with(|| {
            made.positions.push(position);
            if has_normals {
                made.normals.push(normal);
            }
            if has_colors {
                made.colors.push(color);
            }
            if has_coordinates {
                made.texture_coordinates.push(place);
            }
            u32::try_from(made.positions.len() - 1).expect("not more corners than there were")
        });
    }
    made.indices = primitive.indices.iter().map(|&index| new[index as usize]).collect();
    made
}

/// Numbers that are equal bit by bit, so that nothing changes.
fn key(position: [f32; 3], normal: [f32; 3], color: [f32; 4], place: [f32; 2]) -> [u32; 12] {
    let mut key = [0; 12];
    let numbers = position.into_iter().chain(normal).chain(color).chain(place);
    key.iter_mut().zip(numbers).for_each(|(place, number)| *place = number.to_bits());
    key
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::model::Model;
    use crate::recipes::{GeometrySet, RecipeInput, find};

    /// The parts of a recipe's first look.
    pub(in crate::gltf) fn recipe(name: &str) -> Vec<Primitive> {
        let recipe = find(name).unwrap();
        let input =
            RecipeInput { size: recipe.usual_size(), look: 0, geometry: GeometrySet::Plain, parameters: &[] };
        Model::from(recipe.build(&input)).primitives
    }

    /// Two faces at a right angle along x.
    fn corner() -> Primitive {
        Primitive {
            positions: vec![
                [0.0, 0.0, 0.0],
                [1.0, 0.0, 0.0],
                [0.0, 1.0, 0.0],
                [1.0, 0.0, 0.0],
                [0.0, 0.0, 0.0],
                [0.0, 0.0, 1.0],
            ],
            normals: [[[0.0, 0.0, 1.0]; 3], [[0.0, 1.0, 0.0]; 3]].concat(),
            indices: (0..6).collect(),
            ..Primitive::default()
        }
    }

    #[test]
    fn faces_share_equal_corners() {
        assert_eq!(joined(&corner(), true).positions.len(), 6, "normals do");
        let flat = joined(&corner(), false);
        assert_eq!((flat.positions.len(), flat.normals.len()), (4, 0));
        assert_eq!(flat.indices, [0, 1, 2, 1, 0, 3]);
        let mut colored = corner();
        colored.colors = (0..6).map(|corner| [corner as f32, 0.0, 0.0, 1.0]).collect();
        assert_eq!(joined(&colored, false).colors, colored.colors);
    }

    #[test]
    fn models_keep_their_triangles() {
        for primitive in ["sofa", "bookshelf", "curtain"].into_iter().flat_map(recipe) {
            let joined = joined(&primitive, true);
            assert!(joined.positions.len() <= primitive.positions.len());
            let corners = |of: &Primitive| -> Vec<([f32; 3], [f32; 3])> {
                let corner = |&index: &u32| (of.positions[index as usize], of.normals[index as usize]);
                of.indices.iter().map(corner).collect()
            };
            assert_eq!(corners(&joined), corners(&primitive));
        }
    }
}
