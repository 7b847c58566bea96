//! The loose parts of a primitive, and whether they are boxes.

use glam::Vec3;
use hashbrown::HashMap;

use super::coarse::Extent;
use crate::geometry::DisjointSets;
use crate::mesh::{ModelMaterial, Primitive};

/// Loose parts: corners in one place, and those of one triangle, are of one part.
pub(super) struct LooseParts {
    /// The number of the part of each corner.
    pub(super) of_corner: Vec<usize>,
    pub(super) list: Vec<LoosePart>,
}

/// A loose part of a primitive.
pub(super) struct LoosePart {
    pub(super) extent: Extent,
    /// The first of its corners.
    pub(super) first: usize,
    corners: Vec<usize>,
    triangles: Vec<[u32; 3]>,
}

/// Triangles of a part beyond which it is not looked at whether it is a box: rounded boxes have a few hundred.
const MOST_TRIANGLES: usize = 600;
/// Metres between the places at which it is looked at, and the most of them along a side.
const GAP: f32 = 0.1;
const MOST_PLACES: f32 = 24.0;

impl LooseParts {
    pub(super) fn of(primitive: &Primitive) -> Self {
        let of_corner = numbers(primitive);
        let count = of_corner.iter().max().map_or(0, |most| most + 1);
        let mut list: Vec<LoosePart> = (0..count)
            .map(|_| LoosePart {
                extent: Extent::EMPTY,
                first: 0,
                corners: Vec::new(),
                triangles: Vec::new(),
            })
            .collect();
        for (corner, (&part, position)) in of_corner.iter().zip(&primitive.positions).enumerate() {
            let part = &mut list[part];
            part.extent = part.extent.with(position);
            part.corners.push(corner);
        }
        for triangle in primitive.indices.as_chunks::<3>().0 {
            list[of_corner[triangle[0] as usize]].triangles.push(*triangle);
        }
        list.iter_mut().for_each(|part| part.first = part.corners[0]);
        Self { of_corner, list }
    }
}

impl LoosePart {
    /// Whether all corners have the colour of the first.
    pub(super) fn is_of_one_color(&self, primitive: &Primitive) -> bool {
        let is_alike = |values: &[[f32; 4]]| {
            self.corners.iter().all(|&corner| values.get(corner) == values.get(self.first))
        };
        let is_in_place =
            |set: &[[f32; 2]]| self.corners.iter().all(|&corner| set.get(corner) == set.get(self.first));
        let has_image = !matches!(primitive.material, ModelMaterial::Slot(_));
        is_alike(&primitive.colors) && (!has_image || primitive.coordinate_sets().all(is_in_place))
    }

    /// Whether the part is nowhere farther below the faces of its box than so many metres; within as many from the edges of a face, it
    /// may be rounded. No part is so for a depth below zero.
    pub(super) fn fills_box(&self, primitive: &Primitive, depth: f64) -> bool {
        let depth = depth as f32;
        if depth < 0.0 || self.triangles.len() > MOST_TRIANGLES {
            return false;
        }
        let at = |corner: u32| Vec3::from_array(primitive.positions[corner as usize]);
        let triangles: Vec<[Vec3; 3]> = self.triangles.iter().map(|triangle| triangle.map(at)).collect();
        (0..3).all(|axis| {
            let [across, up] = [(axis + 1) % 3, (axis + 2) % 3];
            let Extent([low, high]) = self.extent;
            let turned = triangles.iter().map(|triangle| triangle.map(|at| [at[across], at[up], at[axis]]));
            let turned: Vec<[[f32; 3]; 3]> = turned.collect();
            let is_near = |place: [f32; 2]| {
                let [least, most] = heights_at(&turned, place);
                least - low[axis] <= depth && high[axis] - most <= depth
            };
            places(low[across], high[across], depth)
                .all(|one| places(low[up], high[up], depth).all(|other| is_near([one, other])))
        })
    }
}

/// Places along a side of a face, but for its ends.
fn places(low: f32, high: f32, margin: f32) -> impl Iterator<Item = f32> {
    let (low, high) = if high - low > 2.0 * margin {
        (low + margin, high - margin)
    } else {
        (low.midpoint(high), low.midpoint(high))
    };
    // Limited before it is a count: a side may be as long as its numbers go.
    let count = ((high - low) / GAP).min(MOST_PLACES - 2.0) as usize + 2;
    (0..count).map(move |number| low + (high - low) * number as f32 / (count - 1) as f32)
}

/// The least and the highest of the third coordinates of triangles at a place of the first two.
fn heights_at(triangles: &[[[f32; 3]; 3]], place: [f32; 2]) -> [f32; 2] {
    let hits = triangles.iter().filter_map(|triangle| height_at(*triangle, place));
    let empty = [f32::INFINITY, f32::NEG_INFINITY];
    hits.fold(empty, |[least, most], height| [least.min(height), most.max(height)])
}

/// The third coordinate of a triangle at a place of the first two, if it is there.
fn height_at([a, b, c]: [[f32; 3]; 3], [x, y]: [f32; 2]) -> Option<f32> {
    let cross = |[ax, ay, _]: [f32; 3], [bx, by, _]: [f32; 3]| (bx - ax) * (y - ay) - (by - ay) * (x - ax);
    let shares = [cross(b, c), cross(c, a), cross(a, b)];
    let sum: f32 = shares.iter().sum();
    let is_inside = shares.iter().all(|share| share * sum.signum() >= -EDGE);
    (sum.abs() > EDGE && is_inside).then(|| (shares[0] * a[2] + shares[1] * b[2] + shares[2] * c[2]) / sum)
}

/// Square metres within which a place is on the edge of a triangle.
const EDGE: f32 = 1e-7;

/// The number of the loose part of each corner.
fn numbers(primitive: &Primitive) -> Vec<usize> {
    let mut first_at: HashMap<[u32; 3], usize> = HashMap::with_capacity(primitive.positions.len());
    let mut joined = DisjointSets::new(primitive.positions.len());
    for (corner, position) in primitive.positions.iter().enumerate() {
        let place = position.map(|number| (number + 0.0).to_bits());
        joined.join(corner, *first_at.entry(place).or_insert(corner));
    }
    for triangle in primitive.indices.as_chunks::<3>().0 {
        let [a, b, c] = triangle.map(|corner| corner as usize);
        joined.join(a, b);
        joined.join(b, c);
    }
    let mut numbers: HashMap<usize, usize> = HashMap::new();
    (0..primitive.positions.len())
        .map(|corner| {
            let next = numbers.len();
            *numbers.entry(joined.find(corner)).or_insert(next)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The faces of a prism that stands along Z, a metre high, over an outline that turns counter-clockwise.
    fn prism(outline: &[[f32; 2]]) -> Primitive {
        let mut made = Primitive::default();
        let mut quad = |corners: [[f32; 3]; 4]| {
            let first = made.positions.len() as u32;
            made.positions.extend(corners);
            made.indices.extend([0, 1, 2, 0, 2, 3].map(|corner| first + corner));
        };
        for (number, &[x, y]) in outline.iter().enumerate() {
            let [next_x, next_y] = outline[(number + 1) % outline.len()];
            quad([[x, y, 0.0], [next_x, next_y, 0.0], [next_x, next_y, 1.0], [x, y, 1.0]]);
            // Thin wedges to the middle of both ends.
            quad([[x, y, 1.0], [next_x, next_y, 1.0], [0.5, 0.5, 1.0], [0.5, 0.5, 1.0]]);
            quad([[x, y, 0.0], [0.5, 0.5, 0.0], [0.5, 0.5, 0.0], [next_x, next_y, 0.0]]);
        }
        made
    }

    fn fills(primitive: &Primitive, depth: f64) -> bool {
        let parts = LooseParts::of(primitive);
        assert_eq!(parts.list.len(), 1);
        parts.list[0].fills_box(primitive, depth)
    }

    #[test]
    fn parts_that_are_rounded_less_than_a_depth_are_boxes() {
        let beveled = [
            [0.02, 0.0],
            [0.98, 0.0],
            [1.0, 0.02],
            [1.0, 0.98],
            [0.98, 1.0],
            [0.02, 1.0],
            [0.0, 0.98],
            [0.0, 0.02],
        ];
        assert!(fills(&prism(&beveled), 0.03));
        assert!(!fills(&prism(&beveled), 0.005));
        assert!(fills(&prism(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]), 0.001));
    }

    #[test]
    fn parts_with_a_notch_or_an_open_end_are_no_boxes() {
        let notched = [[0.0, 0.0], [1.0, 0.0], [1.0, 0.7], [0.7, 0.7], [0.7, 1.0], [0.0, 1.0]];
        assert!(!fills(&prism(&notched), 0.03));
        let closed = prism(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
        let is_end =
            |triangle: &&[u32; 3]| triangle.iter().all(|&corner| closed.positions[corner as usize][2] == 1.0);
        let sides = closed.indices.as_chunks::<3>().0.iter().filter(|triangle| !is_end(triangle));
        let open = closed.with_triangles(sides.flatten().copied());
        assert!(!fills(&open, 0.03));
    }
}
