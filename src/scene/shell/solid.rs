//! Flat-shaded closed bodies, face by face.

use glam::{DVec3, Vec2, Vec3};

use super::ticks::Ticks;
use crate::model::{ModelMaterial, Primitive};

/// Triangles of one material under construction, in the glTF frame of the node that will carry them.
#[derive(Clone, Debug)]
pub(crate) struct Solid {
    primitive: Primitive,
}

/// Faces with less area (square metres) than this are dropped: they close nothing.
const LEAST_FACE: f64 = 1e-12;

impl Solid {
    /// Nothing yet.
    pub(crate) fn new(slot: &'static str) -> Self {
        Self { primitive: Primitive { material: ModelMaterial::Slot(slot), ..Primitive::default() } }
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
        let first = self.push_corners(&kept, normal);
        for index in 1..kept.len() as u32 - 1 {
            self.primitive.indices.extend([first, first + index, first + index + 1]);
        }
    }

    /// Triangles of a flat face by index into `corners`.
    pub(crate) fn triangles(&mut self, corners: &[Vec3], normal: Vec3, indices: impl Iterator<Item = u32>) {
        let first = self.push_corners(corners, normal);
        self.primitive.indices.extend(indices.map(|index| first + index));
    }

    fn push_corners(&mut self, corners: &[Vec3], normal: Vec3) -> u32 {
        let first = u32::try_from(self.primitive.positions.len()).expect("a shell part has few corners");
        self.primitive.positions.extend(corners.iter().map(|corner| corner.to_array()));
        self.primitive.normals.extend(corners.iter().map(|_| normal.to_array()));
        let coordinates = corners.iter().map(|&corner| coordinates(corner, normal).to_array());
        self.primitive.texture_coordinates.extend(coordinates);
        first
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
