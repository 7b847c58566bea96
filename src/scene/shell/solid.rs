//! Builds closed bodies with flat faces.

use std::collections::BTreeMap;

use glam::{DVec3, Vec2, Vec3};

use super::ticks::Ticks;
use crate::model::{ModelMaterial, Primitive};
use crate::recipes::Slot;

/// Triangles of one material under construction, in the glTF frame of the node that will carry them.
#[derive(Clone, Debug)]
pub(crate) struct Solid {
    primitive: Primitive,
    grain: Grain,
    /// Corners by position and normal: faces that go on in one plane share them.
    known: BTreeMap<[u32; 6], u32>,
}

/// Which way the grain of a body's material runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Grain {
    /// Level on upright faces, along the frame's x on others.
    #[default]
    Level,
    /// Up on upright faces, as doors are made.
    Upright,
    /// Level on upright faces, on others along a horizontal unit vector: x and z.
    Along([Ticks; 2]),
}

/// Faces with less area (square metres) than this are dropped: they close nothing.
const LEAST_FACE: f64 = 1e-12;

impl Solid {
    /// Nothing yet.
    pub(crate) fn new(slot: Slot) -> Self {
        let primitive = Primitive { material: ModelMaterial::Slot(slot), ..Primitive::default() };
        Self { primitive, grain: Grain::Level, known: BTreeMap::new() }
    }

    /// With another grain, before the first face.
    pub(crate) fn with_grain(self, grain: Grain) -> Self {
        Self { grain, ..self }
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
        let (primitive, grain) = (&mut self.primitive, self.grain);
        *self.known.entry([x, y, z, a, b, c]).or_insert_with(|| {
            primitive.positions.push(corner.to_array());
            primitive.normals.push(normal.to_array());
            primitive.texture_coordinates.push(grain.coordinates(corner, normal).to_array());
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

impl Grain {
    /// Texture coordinates in metres, the grain along `u`. The image is mirrored nowhere; on walls it lies upright unless
    /// the grain does.
    fn coordinates(self, point: Vec3, normal: Vec3) -> Vec2 {
        let strength = normal.abs();
        let is_upright = strength.y < strength.x || strength.y < strength.z;
        let level = if !is_upright {
            Vec2::new(point.x, point.z * normal.y.signum())
        } else if strength.z >= strength.x {
            Vec2::new(point.x * normal.z.signum(), -point.y)
        } else {
            Vec2::new(-point.z * normal.x.signum(), -point.y)
        };
        match self {
            Self::Upright if is_upright => Vec2::new(-level.y, level.x),
            Self::Along([x, z]) if !is_upright => {
                let along = Vec2::new(x.narrow(), z.narrow() * normal.y.signum());
                Vec2::new(along.dot(level), along.perp_dot(level))
            }
            _ => level,
        }
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

#[cfg(test)]
mod tests {
    use super::*;

    /// How far the image moves along a step on a face that looks along `normal`.
    fn step(grain: Grain, normal: Vec3, by: Vec3) -> Vec2 {
        grain.coordinates(by, normal) - grain.coordinates(Vec3::ZERO, normal)
    }

    #[test]
    fn the_grain_of_upright_boards_runs_up() {
        for normal in [Vec3::Z, Vec3::NEG_Z, Vec3::X, Vec3::NEG_X] {
            assert_eq!(step(Grain::Upright, normal, Vec3::Y), Vec2::X, "{normal}");
            assert_eq!(step(Grain::Level, normal, Vec3::Y), Vec2::NEG_Y, "{normal}");
        }
        assert_eq!(step(Grain::Upright, Vec3::Y, Vec3::X), Vec2::X, "the head of a board stays as it was");
    }

    #[test]
    fn the_grain_of_floors_follows_a_direction() {
        let slope = Grain::Along([Ticks(60_000), Ticks(80_000)]);
        for normal in [Vec3::Y, Vec3::NEG_Y] {
            assert!(step(slope, normal, Vec3::new(0.6, 0.0, 0.8)).distance(Vec2::X) < 1e-6, "{normal}");
        }
        assert_eq!(step(slope, Vec3::Z, Vec3::X), Vec2::X, "upright faces stay as they were");
    }

    #[test]
    fn no_grain_mirrors_the_image() {
        let slope = Grain::Along([Ticks(60_000), Ticks(-80_000)]);
        for grain in [Grain::Level, Grain::Upright, slope] {
            for normal in [Vec3::X, Vec3::NEG_X, Vec3::Y, Vec3::NEG_Y, Vec3::Z, Vec3::NEG_Z] {
                let right = Vec3::AXES.map(|axis| step(grain, normal, axis).x);
                let down = Vec3::AXES.map(|axis| step(grain, normal, axis).y);
                let facing = Vec3::from_array(right).cross(-Vec3::from_array(down));
                assert!(facing.distance(normal) < 1e-6, "{grain:?} {normal}: {facing}");
            }
        }
    }
}
