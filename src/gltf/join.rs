//! Corners that faces can share.

use std::collections::HashMap;

use glam::Vec3;

use crate::geometry::DisjointSets;
use crate::model::Primitive;

/// The cosine of how far normals may be off their face for it to be flat: a degree, which nobody sees; round surfaces are
/// made of steps many times as large.
const FLAT: f32 = 0.99985;

/// Metres: on faces that are less wide, bevels and thin rods, nobody tells a round surface from a flat one.
const NARROW: f32 = 0.01;

/// Which triangles look as they do where viewers compute the normals: all corners have the normal of the face, or the face is
/// narrow.
pub(super) fn flat_triangles(primitive: &Primitive) -> Vec<bool> {
    let vector = |list: &[[f32; 3]], index: u32| Vec3::from_array(list[index as usize]);
    let is_flat = |triangle: &[u32; 3]| {
        let [a, b, c] = triangle.map(|index| vector(&primitive.positions, index));
        let normal = (b - a).cross(c - a);
        let longest = [(a, b), (b, c), (c, a)].map(|(from, to)| from.distance(to));
        let face = normal.normalize_or_zero();
        normal.length() < NARROW * longest.into_iter().fold(0.0, f32::max)
            || triangle.iter().all(|&index| vector(&primitive.normals, index).dot(face) >= FLAT)
    };
    primitive.indices.as_chunks::<3>().0.iter().map(is_flat).collect()
}

/// The closed surfaces of which all triangles are chosen, and the others: surfaces hang together where corners lie at one
/// place. Both keep their order, and each has all corners.
pub(super) fn split(primitive: &Primitive, is_chosen: &[bool]) -> [Primitive; 2] {
    let mut places: HashMap<[u32; 3], usize> = HashMap::with_capacity(primitive.positions.len());
    let places: Vec<usize> = primitive
        .positions
        .iter()
        .map(|position| {
            let next = places.len();
            *places.entry(position.map(f32::to_bits)).or_insert(next)
        })
        .collect();
    let triangles = primitive.indices.as_chunks::<3>().0;
    let mut surfaces = DisjointSets::new(places.len());
    for triangle in triangles {
        let [a, b, c] = triangle.map(|index| places[index as usize]);
        surfaces.join(a, b);
        surfaces.join(b, c);
    }
    let surface_of = triangles.iter().map(|triangle| surfaces.find(places[triangle[0] as usize]));
    let surface_of: Vec<usize> = surface_of.collect();
    let mut is_whole = vec![true; places.len()];
    for (&surface, _) in surface_of.iter().zip(is_chosen).filter(|(_, is_chosen)| !**is_chosen) {
        is_whole[surface] = false;
    }
    [true, false].map(|wanted| {
        let kept = triangles.iter().zip(&surface_of).filter(|&(_, &surface)| is_whole[surface] == wanted);
        let indices = kept.flat_map(|(triangle, _)| triangle).copied().collect();
        Primitive { indices, ..primitive.clone() }
    })
}

/// Whether corners have colours.
pub(super) fn has_colors(primitive: &Primitive) -> bool {
    !primitive.colors.is_empty() && primitive.colors.len() == primitive.positions.len()
}

/// The same triangles without texture coordinates, where corners that agree in all that is left are one: in position and
/// colour, and in normals if there are to be any. They keep their order; those of no triangle are left out.
pub(super) fn joined(primitive: &Primitive, has_normals: bool) -> Primitive {
    let has_colors = has_colors(primitive);
    let mut is_used = vec![false; primitive.positions.len()];
    primitive.indices.iter().for_each(|&index| is_used[index as usize] = true);
    let mut known: HashMap<[u32; 10], u32> = HashMap::with_capacity(primitive.positions.len());
    let mut made = Primitive { material: primitive.material.clone(), ..Primitive::default() };
    let mut new = vec![0; primitive.positions.len()];
    for corner in (0..new.len()).filter(|&corner| is_used[corner]) {
        let position = primitive.positions[corner];
        let normal = if has_normals { primitive.normals[corner] } else { [0.0; 3] };
        let color = if has_colors { primitive.colors[corner] } else { [0.0; 4] };
        new[corner] = *known.entry(key(position, normal, color)).or_insert_with(|| {
            made.positions.push(position);
            if has_normals {
                made.normals.push(normal);
            }
            if has_colors {
                made.colors.push(color);
            }
            u32::try_from(made.positions.len() - 1).expect("not more corners than there were")
        });
    }
    made.indices = primitive.indices.iter().map(|&index| new[index as usize]).collect();
    made
}

/// Numbers that are equal bit by bit, so that nothing changes.
fn key(position: [f32; 3], normal: [f32; 3], color: [f32; 4]) -> [u32; 10] {
    let mut key = [0; 10];
    let numbers = position.into_iter().chain(normal).chain(color);
    key.iter_mut().zip(numbers).for_each(|(place, number)| *place = number.to_bits());
    key
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{PLAIN, RecipeInput, build_recipe, recipe_size};

    fn recipe(name: &str) -> Vec<Primitive> {
        let size = recipe_size(name).unwrap();
        build_recipe(name, &RecipeInput { size, look: 0, geometry: PLAIN, parameters: &[] })
            .unwrap()
            .primitives
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
    fn faces_share_corners_where_nothing_tells_them_apart() {
        assert_eq!(joined(&corner(), true).positions.len(), 6, "normals do");
        let flat = joined(&corner(), false);
        assert_eq!((flat.positions.len(), flat.normals.len()), (4, 0));
        assert_eq!(flat.indices, [0, 1, 2, 1, 0, 3]);
        let mut colored = corner();
        colored.colors = (0..6).map(|corner| [corner as f32, 0.0, 0.0, 1.0]).collect();
        assert_eq!(joined(&colored, false).colors, colored.colors);
    }

    #[test]
    fn faces_are_flat_or_round() {
        assert_eq!(flat_triangles(&corner()), [true, true]);
        let mut round = corner();
        round.normals[1] = [0.0, 0.70710677, 0.70710677];
        assert_eq!(flat_triangles(&round), [false, true]);
        round.positions.iter_mut().for_each(|position| position[1] *= 0.005);
        assert_eq!(flat_triangles(&round), [true, true], "nobody sees it on a narrow face");
    }

    #[test]
    fn surfaces_are_split_off_whole() {
        // A corner of two faces, of which one is round, and a face that is far from both.
        let mut apart = corner();
        apart.positions.extend([[5.0, 0.0, 0.0], [6.0, 0.0, 0.0], [5.0, 1.0, 0.0]]);
        apart.normals.extend([[0.0, 0.0, 1.0]; 3]);
        apart.indices.extend(6..9);
        let [flat, round] = split(&apart, &[true, false, true]);
        assert_eq!((flat.indices, round.indices), ((6..9).collect(), (0..6).collect()));
        let [flat, round] = split(&apart, &[true; 3]);
        assert_eq!((flat.indices.len(), round.indices.len()), (9, 0));
    }

    /// Whether each edge is walked along as often one way as the other.
    fn is_closed(part: &Primitive) -> bool {
        let place = |index: u32| part.positions[index as usize].map(f32::to_bits);
        let triangles = part.indices.as_chunks::<3>().0.iter();
        let edges = triangles.flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
        let mut balance: HashMap<_, i32> = HashMap::new();
        for (from, to) in edges.map(|(from, to)| (place(from), place(to))) {
            *balance.entry((from.min(to), from.max(to))).or_default() += if from < to { 1 } else { -1 };
        }
        balance.values().all(|&count| count == 0)
    }

    #[test]
    fn models_are_split_into_closed_surfaces() {
        let mut split_count = 0;
        for primitive in ["washbasin", "office_chair", "bookshelf"].into_iter().flat_map(recipe) {
            let parts = split(&primitive, &flat_triangles(&primitive));
            let count: usize = parts.iter().map(|part| part.indices.len()).sum();
            assert_eq!(count, primitive.indices.len());
            split_count += usize::from(parts.iter().all(|part| !part.indices.is_empty()));
            for part in &parts {
                assert!(is_closed(part), "{:?} has an edge", part.material);
            }
        }
        assert!(split_count > 0);
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
