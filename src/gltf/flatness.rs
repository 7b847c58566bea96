//! Finds surfaces that look the same without normals.

use glam::Vec3;
use hashbrown::HashMap;

use crate::geometry::DisjointSets;
use crate::model::Primitive;

/// The cosine of how far normals may be off their face for it to be flat: a degree, which is invisible; round surfaces are
/// made of steps many times as large.
const FLAT: f32 = 0.99985;

/// Metres: on faces that are less wide, bevels and thin rods, a round surface looks like a flat one.
const NARROW: f32 = 0.01;

/// Triangles of a closed surface that no normals make round, as those of a leaf: no more than a prism of six sides has.
const FEW: usize = 20;

/// Whether a triangle is narrow.
fn is_narrow([a, b, c]: [Vec3; 3]) -> bool {
    let longest = [(a, b), (b, c), (c, a)].map(|(from, to)| from.distance(to));
    (b - a).cross(c - a).length() < NARROW * longest.into_iter().fold(0.0, f32::max)
}

/// Whether all triangles look as they do where viewers compute the normals.
pub(super) fn is_flat(primitive: &Primitive) -> bool {
    primitive.indices.as_chunks::<3>().0.iter().all(|triangle| is_flat_triangle(primitive, triangle))
}

/// Whether a triangle is narrow, or all its corners have the normal of the face.
fn is_flat_triangle(primitive: &Primitive, triangle: &[u32; 3]) -> bool {
    let vector = |list: &[[f32; 3]], index: u32| Vec3::from_array(list[index as usize]);
    let corners = triangle.map(|index| vector(&primitive.positions, index));
    let [a, b, c] = corners;
    let face = (b - a).cross(c - a).normalize_or_zero();
    is_narrow(corners) || triangle.iter().all(|&index| vector(&primitive.normals, index).dot(face) >= FLAT)
}

/// The closed surfaces that need no normals, for all of their triangles are flat or they are few, and the others. Surfaces
/// hang together where corners lie at one place. Both keep their order, and each has all corners.
pub(super) fn split(primitive: &Primitive) -> [Primitive; 2] {
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
    let mut count = vec![0; places.len()];
    surface_of.iter().for_each(|&surface| count[surface] += 1);
    let mut is_plain = vec![true; places.len()];
    for (&surface, triangle) in surface_of.iter().zip(triangles) {
        is_plain[surface] &= count[surface] <= FEW || is_flat_triangle(primitive, triangle);
    }
    [true, false].map(|wanted| {
        let kept = triangles.iter().zip(&surface_of).filter(|&(_, &surface)| is_plain[surface] == wanted);
        let indices = kept.flat_map(|(triangle, _)| triangle).copied().collect();
        Primitive { indices, ..primitive.clone() }
    })
}

#[cfg(test)]
mod tests {
    use super::super::join::tests::recipe;
    use super::*;

    /// Fans of triangles about a corner at `x`, each as wide as the step of the rim, with normals that lean or not.
    fn fan(x: f32, count: u32, leaning: bool) -> Primitive {
        let rim = (0..=count).map(|step| [x, 1.0, 0.1 * step as f32]);
        let positions: Vec<[f32; 3]> = [[x, 0.0, 0.0]].into_iter().chain(rim).collect();
        let normal = if leaning { [-0.8, 0.6, 0.0] } else { [-1.0, 0.0, 0.0] };
        Primitive {
            normals: vec![normal; positions.len()],
            indices: (1..=count).flat_map(|step| [0, step + 1, step]).collect(),
            positions,
            ..Primitive::default()
        }
    }

    fn together(mut one: Primitive, other: &Primitive) -> Primitive {
        let shift = one.positions.len() as u32;
        one.positions.extend(&other.positions);
        one.normals.extend(&other.normals);
        one.indices.extend(other.indices.iter().map(|index| index + shift));
        one
    }

    #[test]
    fn faces_are_flat_or_round() {
        assert!(is_flat(&fan(0.0, 3, false)));
        let mut round = fan(0.0, 3, true);
        assert!(!is_flat(&round));
        round.positions.iter_mut().for_each(|position| position[2] *= 0.05);
        assert!(is_flat(&round), "nobody sees it on a narrow face");
    }

    #[test]
    fn surfaces_are_split_off_whole() {
        let many = FEW as u32 + 1;
        let halves = together(fan(0.0, many, false), &fan(0.0, many, true));
        let [flat, round] = split(&together(halves, &fan(5.0, many, false)));
        let length = many as usize * 3;
        assert_eq!((flat.indices.len(), round.indices.len()), (length, 2 * length), "two hang together");
        let leaf = fan(5.0, FEW as u32, true);
        let [few, round] = split(&together(fan(0.0, many, true), &leaf));
        assert_eq!((few.indices.len(), round.indices.len()), (leaf.indices.len(), length));
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
            let parts = split(&primitive);
            let count: usize = parts.iter().map(|part| part.indices.len()).sum();
            assert_eq!(count, primitive.indices.len());
            split_count += usize::from(parts.iter().all(|part| !part.indices.is_empty()));
            for part in &parts {
                assert!(is_closed(part), "{:?} has an edge", part.material);
            }
        }
        assert!(split_count > 0);
    }
}
