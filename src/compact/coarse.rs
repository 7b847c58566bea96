//! Leaves out what is too small or too thin to be seen of a mesh and what nobody sees from outside, and makes boxes of the rest.

use std::sync::Arc;

use glam::Vec3;

use super::loose::{LoosePart, LooseParts};
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
    pub(super) const EMPTY: Self = Self([Vec3::INFINITY, Vec3::NEG_INFINITY]);

    pub(super) fn with(self, corner: &[f32; 3]) -> Self {
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

/// A loose part that is a box along the axes of its model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Cuboid {
    /// Index into the primitives of its model.
    pub(super) primitive: usize,
    /// The first of its corners in the primitive; all corners from there to those of the next box, or to the end, are its own.
    pub(super) first: usize,
    pub(super) low: Vec3,
    pub(super) high: Vec3,
}

/// What is left of a model.
#[derive(Clone, Debug)]
pub(super) struct Seen {
    /// All of it.
    pub(super) model: Arc<Model>,
    /// The boxes in it, with which its primitives end.
    pub(super) cuboids: Arc<[Cuboid]>,
}

/// Simplifies the primitives of a mesh.
#[derive(Clone, Copy)]
pub(super) struct Simplifier {
    pub(super) kind: Kind,
    pub(super) limits: Limits,
}

/// What is seen of a mesh.
#[derive(Clone, Copy)]
pub(super) struct Limits {
    /// Metres: loose parts with no longer side are left out.
    pub(super) least_size: f64,
    /// Metres: thinner loose parts are left out.
    pub(super) least_width: f64,
    /// Metres: loose parts with no longer side are boxes.
    pub(super) boxed: f64,
    /// Metres: loose parts that are nowhere farther below the faces of their box are boxes.
    pub(super) rounding: f64,
    /// Metres: boxes that are no thicker have no narrow faces.
    pub(super) sheet: f64,
}

impl Limits {
    pub(super) fn bits(&self) -> [u64; 5] {
        let Self { least_size, least_width, boxed, rounding, sheet } = *self;
        [least_size, least_width, boxed, rounding, sheet].map(f64::to_bits)
    }
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
    pub(super) fn model(&self, model: &Model) -> Option<Seen> {
        let [low, high] = model.bounds();
        let ends = [low.y, high.y];
        let mut cuboids = Vec::new();
        let simplified = model.primitives.iter().enumerate().map(|(number, primitive)| {
            let (made, boxes) = self.simplified(primitive, ends);
            let boxes = boxes.into_iter().map(|(first, Extent([low, high]))| Cuboid {
                primitive: number,
                first,
                low,
                high,
            });
            cuboids.extend(boxes);
            made
        });
        let primitives: Vec<Primitive> = simplified.collect();
        let is_left = primitives.iter().any(|part| !part.indices.is_empty());
        is_left.then(|| Seen { model: Arc::new(Model { primitives }), cuboids: cuboids.into() })
    }

    /// A primitive without its loose parts and faces that are not seen, of a model between two heights; it may be left without
    /// triangles. Its boxes come last, each with the number of its first corner.
    fn simplified(&self, primitive: &Primitive, ends: [f32; 2]) -> (Primitive, Vec<(usize, Extent)>) {
        let parts = LooseParts::of(primitive);
        let fates: Vec<Fate> = parts.list.iter().map(|part| self.fate(primitive, part)).collect();
        let kept = primitive.indices.as_chunks::<3>().0.iter().filter(|triangle| {
            let is_kept = fates[parts.of_corner[triangle[0] as usize]] == Fate::Kept;
            is_kept && !self.hides(primitive, triangle, ends)
        });
        let mut made = primitive.with_triangles(kept.flatten().copied());
        let boxed = parts.list.iter().zip(&fates).filter(|(_, fate)| **fate == Fate::Boxed);
        let boxes = boxed.map(|(part, _)| {
            let first = made.positions.len();
            add_box(&mut made, part.extent, |axis, is_high| self.shows(part.extent, (axis, is_high), ends));
            paint(&mut made, primitive, part.first);
            (first, part.extent)
        });
        let boxes = boxes.collect();
        (made, boxes)
    }

    /// Whether all corners of a triangle are of a face that nobody sees.
    fn hides(&self, primitive: &Primitive, triangle: &[u32; 3], ends: [f32; 2]) -> bool {
        triangle.iter().all(|&corner| {
            let (position, normal) =
                (primitive.positions[corner as usize], primitive.normals[corner as usize]);
            self.kind.hides(normal[1], is_at(ends, position[1]))
        })
    }

    fn fate(&self, primitive: &Primitive, part: &LoosePart) -> Fate {
        let [longest, middle, _] = part.extent.sides();
        let Limits { least_size, least_width, boxed, rounding, .. } = self.limits;
        if longest < least_size || middle < least_width {
            Fate::Dropped
        } else if longest <= boxed || (part.is_of_one_color(primitive) && part.fills_box(primitive, rounding))
        {
            Fate::Boxed
        } else {
            Fate::Kept
        }
    }

    /// Whether a face of a box is seen.
    fn shows(&self, extent: Extent, (axis, is_high): (usize, bool), ends: [f32; 2]) -> bool {
        let Extent([low, high]) = extent;
        let end = if is_high { high } else { low };
        let height = if axis == 1 { if is_high { 1.0 } else { -1.0 } } else { 0.0 };
        let sides = (high - low).as_dvec3();
        let is_narrow = sides.min_element() <= self.limits.sheet && axis != sides.min_position();
        !is_narrow && !self.kind.hides(height, is_at(ends, end.y))
    }
}

/// Adds those faces of a box that are seen, each given by its axis and whether it is at the high end.
pub(super) fn add_box(
    primitive: &mut Primitive,
    Extent([low, high]): Extent,
    shows: impl Fn(usize, bool) -> bool,
) {
    for (axis, is_high) in FACES.into_iter().filter(|&(axis, is_high)| shows(axis, is_high)) {
        let normal = Vec3::AXES[axis] * if is_high { 1.0 } else { -1.0 };
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
}

/// Gives what was added last to a primitive the colours and texture coordinates of a corner of another.
fn paint(made: &mut Primitive, source: &Primitive, corner: usize) {
    let count = made.positions.len();
    if let Some(&place) = source.texture_coordinates.get(corner) {
        made.texture_coordinates.resize(count, place);
        let further = made.further_coordinates.iter_mut().zip(&source.further_coordinates);
        further.for_each(|(set, of_source)| {
            set.resize(count, of_source.get(corner).copied().unwrap_or_default())
        });
    }
    if let Some(&color) = source.colors.get(corner) {
        made.colors.resize(count, color);
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

#[cfg(test)]
mod tests {
    use super::*;

    const LIMITS: Limits =
        Limits { least_size: 0.0, least_width: 0.0, boxed: 0.0, rounding: f64::NEG_INFINITY, sheet: 0.0 };

    /// A cube of a metre.
    fn cube() -> Primitive {
        let mut primitive = Primitive::default();
        add_box(&mut primitive, Extent([Vec3::ZERO, Vec3::ONE]), |_, _| true);
        assert_eq!(primitive.indices.len(), 36);
        primitive
    }

    /// The heights of the normals of what is left of a box that is kept as it is, and of one that becomes a box.
    fn left(kind: Kind) -> [Vec<i32>; 2] {
        let model = Model { primitives: vec![cube()] };
        [0.0, 2.0].map(|boxed| {
            let simplifier = Simplifier { kind, limits: Limits { boxed, ..LIMITS } };
            let left = simplifier.model(&model).unwrap().model;
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

    #[test]
    fn sheets_have_no_narrow_faces() {
        let mut primitive = Primitive::default();
        add_box(&mut primitive, Extent([Vec3::ZERO, Vec3::new(1.0, 1.0, 0.04)]), |_, _| true);
        let model = Model { primitives: vec![primitive] };
        let faces = |sheet: f64| {
            let limits = Limits { boxed: 2.0, sheet, ..LIMITS };
            let seen = Simplifier { kind: Kind::Furniture, limits }.model(&model).unwrap();
            assert_eq!(seen.cuboids.len(), 1);
            seen.model.primitives[0].indices.len() / 6
        };
        // Nobody sees what it stands on.
        assert_eq!([faces(0.0), faces(0.03), faces(0.05)], [5, 5, 2]);
    }

    #[test]
    fn boxes_have_the_color_of_the_part_that_they_are() {
        let mut primitive = cube();
        primitive.colors = vec![[0.5, 0.5, 0.5, 1.0]; primitive.positions.len()];
        let limits = Limits { rounding: 0.01, ..LIMITS };
        let simplifier = Simplifier { kind: Kind::Furniture, limits };
        let boxes = |primitive: &Primitive| {
            let seen = simplifier.model(&Model { primitives: vec![primitive.clone()] }).unwrap();
            (seen.cuboids.len(), seen.model.primitives[0].colors.last().copied())
        };
        assert_eq!(boxes(&primitive), (1, Some([0.5, 0.5, 0.5, 1.0])));
        // One of two colours stays as it is.
        primitive.colors[0] = [1.0; 4];
        assert_eq!(boxes(&primitive).0, 0);
    }
}
