//! Leaves out what is too small or too thin to be seen of a mesh and what nobody sees from outside, and makes boxes of the rest.

use std::collections::HashMap;
use std::sync::Arc;

use glam::Vec3;

use crate::geometry::DisjointSets;
use crate::mesh::{Model, Primitive};

/// What a mesh is, as far as it decides how it is simplified.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Kind {
    /// A piece of furniture that stands or hangs on a wall.
    Furniture,
    /// A piece of furniture below a ceiling.
    Hung,
    /// A leaf of a door.
    Leaf,
    /// Along an edge of a wall or an opening, or on a wall: seen from near only.
    Trim,
    /// The floor of a room.
    Floor,
    /// The ceiling of a room.
    Ceiling,
    /// The rest of the shell.
    Shell,
}

impl Kind {
    /// Whether nobody sees a face from outside the building, by the height of its normal and by whether it is at the lowest and at
    /// the highest end of its model: it lies on the floor, on a piece, below the ceiling or inside a slab.
    fn hides(self, normal: f32, [is_lowest, is_highest]: [bool; 2]) -> bool {
        let (is_down, is_up) = (normal < -FACING, normal > FACING);
        match self {
            Self::Floor => !is_up,
            Self::Ceiling => !is_up && !is_down,
            Self::Hung => is_up && is_highest,
            Self::Furniture | Self::Leaf | Self::Trim | Self::Shell => is_down && is_lowest,
        }
    }
}

/// A box along the axes: its lowest and highest corner.
#[derive(Clone, Copy)]
pub(super) struct Extent(pub(super) [Vec3; 2]);

impl Extent {
    const EMPTY: Self = Self([Vec3::INFINITY, Vec3::NEG_INFINITY]);

    fn with(self, corner: &[f32; 3]) -> Self {
        let (Self([low, high]), corner) = (self, Vec3::from_array(*corner));
        Self([low.min(corner), high.max(corner)])
    }

    /// Metres, the longest first.
    pub(super) fn sides(self) -> [f64; 3] {
        let mut sides = (self.0[1] - self.0[0]).as_dvec3().to_array();
        sides.sort_by(|one, other| other.total_cmp(one));
        sides
    }
}

/// Simplifies the primitives of a mesh.
#[derive(Clone, Copy)]
pub(super) struct Simplifier {
    pub(super) kind: Kind,
    /// Metres: loose parts with no longer side are left out.
    pub(super) least_size: f64,
    /// Metres: thinner loose parts are left out.
    pub(super) least_width: f64,
    /// Metres: loose parts with no longer side are boxes.
    pub(super) boxed: f64,
}

/// What becomes of a loose part.
#[derive(Clone, Copy, PartialEq)]
enum Fate {
    Dropped,
    Kept,
    Boxed,
}

impl Simplifier {
    /// A model without what is not seen; `None` if nothing is left.
    pub(super) fn model(&self, model: &Model) -> Option<Arc<Model>> {
        let [low, high] = model.bounds();
        let ends = [low.y, high.y];
        let primitives: Vec<Primitive> =
            model.primitives.iter().map(|primitive| self.simplified(primitive, ends)).collect();
        primitives.iter().any(|part| !part.indices.is_empty()).then(|| Arc::new(Model { primitives }))
    }

    /// A primitive without its loose parts and faces that are not seen, of a model between two heights; it may be left without
    /// triangles.
    fn simplified(&self, primitive: &Primitive, ends: [f32; 2]) -> Primitive {
        let parts = parts(primitive);
        let count = parts.iter().max().map_or(0, |most| most + 1);
        let mut extents = vec![Extent::EMPTY; count];
        for (part, position) in parts.iter().zip(&primitive.positions) {
            extents[*part] = extents[*part].with(position);
        }
        let fates: Vec<Fate> = extents.iter().map(|extent| self.fate(*extent)).collect();
        let kept = primitive.indices.as_chunks::<3>().0.iter().filter(|triangle| {
            fates[parts[triangle[0] as usize]] == Fate::Kept && !self.hides(primitive, triangle, ends)
        });
        let mut made = primitive.with_triangles(kept.flatten().copied());
        let boxed = extents.iter().zip(&fates).filter(|(_, fate)| **fate == Fate::Boxed);
        boxed.for_each(|(extent, _)| self.add_box(&mut made, *extent, ends));
        made
    }

    /// Whether all corners of a triangle are of a face that nobody sees.
    fn hides(&self, primitive: &Primitive, triangle: &[u32; 3], ends: [f32; 2]) -> bool {
        triangle.iter().all(|&corner| {
            let (position, normal) =
                (primitive.positions[corner as usize], primitive.normals[corner as usize]);
            self.kind.hides(normal[1], is_at(ends, position[1]))
        })
    }

    fn fate(&self, extent: Extent) -> Fate {
        let [longest, middle, _] = extent.sides();
        if longest < self.least_size || middle < self.least_width {
            Fate::Dropped
        } else if longest <= self.boxed {
            Fate::Boxed
        } else {
            Fate::Kept
        }
    }

    /// Adds a box, without the face that nobody sees.
    fn add_box(&self, primitive: &mut Primitive, Extent([low, high]): Extent, ends: [f32; 2]) {
        let has_sets = !primitive.texture_coordinates.is_empty();
        for (axis, is_high) in FACES {
            let (end, sign) = if is_high { (high, 1.0) } else { (low, -1.0) };
            let normal = Vec3::AXES[axis] * sign;
            if self.kind.hides(normal.y, is_at(ends, end.y)) {
                continue;
            }
            let first = primitive.positions.len() as u32;
            let (across, up) = ((axis + 1) % 3, (axis + 2) % 3);
            // Counter-clockwise from outside: at the low end the other way around.
            let around = [(false, false), (true, false), (true, true), (false, true)];
            let pick = |axis: usize, is_high: bool| if is_high { high[axis] } else { low[axis] };
            for (one, other) in around {
                let mut corner = [0.0; 3];
                corner[axis] = pick(axis, is_high);
                corner[across] = pick(across, one);
                corner[up] = pick(up, other);
                primitive.positions.push(corner);
                primitive.normals.push(normal.to_array());
            }
            let order = if is_high { [0, 1, 2, 0, 2, 3] } else { [0, 2, 1, 0, 3, 2] };
            primitive.indices.extend(order.map(|corner| first + corner));
        }
        let count = primitive.positions.len();
        if has_sets {
            primitive.texture_coordinates.resize(count, [0.0; 2]);
            primitive.further_coordinates.iter_mut().for_each(|set| set.resize(count, [0.0; 2]));
        }
        if !primitive.colors.is_empty() {
            let last = primitive.colors.last().copied().unwrap_or([1.0; 4]);
            primitive.colors.resize(count, last);
        }
    }
}

/// Whether a height is that of each end.
fn is_at(ends: [f32; 2], height: f32) -> [bool; 2] {
    ends.map(|end| (height - end).abs() < END_GAP)
}

/// The faces of a box, each by its axis and whether it is at the high end.
const FACES: [(usize, bool); 6] = [(0, false), (0, true), (1, false), (1, true), (2, false), (2, true)];

/// Metres from the end of a model up to which a face lies on what the model stands on or hangs from.
const END_GAP: f32 = 0.01;
/// The height of the normal of a face that looks up.
const FACING: f32 = 0.99;

/// The number of the loose part of each corner: corners in one place, and those of one triangle, are of one part.
fn parts(primitive: &Primitive) -> Vec<usize> {
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

    /// The heights of the normals of what is left of a box that is kept as it is, and of one that becomes a box.
    fn left(kind: Kind) -> [Vec<i32>; 2] {
        let mut primitive = Primitive::default();
        let all = Simplifier { kind: Kind::Trim, least_size: 0.0, least_width: 0.0, boxed: 0.0 };
        let whole = [Vec3::ZERO, Vec3::ONE];
        // No face is at an end that is far away.
        all.add_box(&mut primitive, Extent(whole), [-9.0, 9.0]);
        assert_eq!(primitive.indices.len(), 36);
        let model = Model { primitives: vec![primitive] };
        [0.0, 2.0].map(|boxed| {
            let simplifier = Simplifier { kind, boxed, ..all };
            let left = simplifier.model(&model).unwrap();
            let triangles = left.primitives[0].indices.as_chunks::<3>().0;
            let mut heights: Vec<i32> = triangles
                .iter()
                .map(|triangle| left.primitives[0].normals[triangle[0] as usize][1] as i32)
                .collect();
            heights.sort_unstable();
            heights
        })
    }

    #[test]
    fn faces_that_are_seen_from_outside_are_left() {
        let (sides, up, down) = (vec![0; 8], vec![1, 1], vec![-1, -1]);
        for (kind, expected) in [
            (Kind::Floor, up.clone()),
            (Kind::Ceiling, [down.clone(), up.clone()].concat()),
            (Kind::Hung, [down, sides.clone()].concat()),
            (Kind::Furniture, [sides.clone(), up.clone()].concat()),
            (Kind::Shell, [sides, up].concat()),
        ] {
            assert_eq!(left(kind), [expected.clone(), expected], "{kind:?}");
        }
    }
}
