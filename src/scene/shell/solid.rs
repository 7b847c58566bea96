//! Flat-shaded closed bodies, face by face.

use std::collections::BTreeMap;

use glam::{DVec3, Vec2, Vec3};

use super::ticks::Ticks;
use crate::model::{ModelMaterial, Primitive};

/// Triangles of one material under construction, in the glTF frame of the node that will carry them.
#[derive(Clone, Debug)]
pub(crate) struct Solid {
    primitive: Primitive,
    /// Corners by position and normal: faces that go on in one plane share them.
    known: BTreeMap<[u32; 6], u32>,
}

/// Faces with less area (square metres) than this are dropped: they close nothing.
const LEAST_FACE: f64 = 1e-12;

impl Solid {
    /// Nothing yet.
    pub(crate) fn new(slot: &'static str) -> Self {
        let primitive = Primitive { material: ModelMaterial::Slot(slot), ..Primitive::default() };
        Self { primitive, known: BTreeMap::new() }
    }

    /// Whether there is any face.
    pub(crate) fn is_empty(&self) -> bool {
        self.primitive.indices.is_empty()
    }

    /// The triangles.
    pub(crate) fn finish(self) -> Primitive {
        self.primitive
    }

    /// A flat convex face, counter-clockwise seen from outside. Repeated corners are one corner; a face
    /// without area is left out.
    pub(crate) fn face(&mut self, corners: &[Vec3]) {
        let mut kept: Vec<Vec3> = Vec::with_capacity(corners.len());
        for &corner in corners {
            if kept.last() != Some(&corner) {
                kept.push(corner);
            }
        }
        if kept.len() > 1 && kept.first() == kept.last() {
            kept.pop();
        }
        let Some(normal) = unit_normal(&kept) else { return };
        let indices = self.corners(&kept, normal);
        for next in indices[1..].windows(2) {
            self.primitive.indices.extend([indices[0], next[0], next[1]]);
        }
    }

    /// Triangles of a flat face by index into `corners`.
    pub(crate) fn triangles(&mut self, corners: &[Vec3], normal: Vec3, indices: impl Iterator<Item = u32>) {
        let known = self.corners(corners, normal);
        self.primitive.indices.extend(indices.map(|index| known[index as usize]));
    }

    /// The index of each corner of a flat face.
    fn corners(&mut self, corners: &[Vec3], normal: Vec3) -> Vec<u32> {
        corners.iter().map(|&corner| self.corner(corner, normal)).collect()
    }

    fn corner(&mut self, corner: Vec3, normal: Vec3) -> u32 {
        // Adding zero makes minus zero plain zero, so that equal numbers have equal bits.
        let bits = |vector: Vec3| (vector + Vec3::ZERO).to_array().map(f32::to_bits);
        let ([x, y, z], [a, b, c]) = (bits(corner), bits(normal));
        let primitive = &mut self.primitive;
        *self.known.entry([x, y, z, a, b, c]).or_insert_with(|| {
            primitive.positions.push(corner.to_array());
            primitive.normals.push(normal.to_array());
            primitive.texture_coordinates.push(coordinates(corner, normal).to_array());
            u32::try_from(primitive.positions.len() - 1).expect("a shell part has few corners")
        })
    }

    /// An axis-parallel box; nothing where it has no volume.
    pub(crate) fn cuboid(&mut self, low: [Ticks; 3], high: [Ticks; 3]) {
        if (0..3).any(|axis| low[axis] >= high[axis]) {
            return;
        }
        let (low, high) = (low.map(Ticks::narrow), high.map(Ticks::narrow));
        let corner = |x: usize, y: usize, z: usize| {
            let pick = |axis: usize, side: usize| if side == 0 { low[axis] } else { high[axis] };
            Vec3::new(pick(0, x), pick(1, y), pick(2, z))
        };
        self.face(&[corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1)]);
        self.face(&[corner(1, 0, 0), corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0)]);
        self.face(&[corner(1, 0, 1), corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1)]);
        self.face(&[corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), corner(0, 1, 0)]);
        self.face(&[corner(0, 1, 1), corner(1, 1, 1), corner(1, 1, 0), corner(0, 1, 0)]);
        self.face(&[corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1)]);
    }
}

/// Texture coordinates in metres: the image lies upright on walls, with the room's first direction to the right on
/// floors, and is mirrored nowhere.
fn coordinates(point: Vec3, normal: Vec3) -> Vec2 {
    let strength = normal.abs();
    if strength.y >= strength.x && strength.y >= strength.z {
        Vec2::new(point.x, point.z * normal.y.signum())
    } else if strength.z >= strength.x {
        Vec2::new(point.x * normal.z.signum(), -point.y)
    } else {
        Vec2::new(-point.z * normal.x.signum(), -point.y)
    }
}

/// The normal of a flat polygon after Newell (Sutherland, Sproull, Schumacker, 1974), which takes corners
/// on a line with others; `None` without area.
fn unit_normal(corners: &[Vec3]) -> Option<Vec3> {
    let count = corners.len();
    let base = corners.first()?.as_dvec3();
    let doubled: DVec3 = (0..count)
        .map(|i| (corners[i].as_dvec3() - base).cross(corners[(i + 1) % count].as_dvec3() - base))
        .sum();
    let length = doubled.length();
    (length > 2.0 * LEAST_FACE).then(|| (doubled / length).as_vec3())
}
