//! Parts of the shell that never move apart as one mesh.

use glam::{DQuat, DVec3, Vec3};

use super::Shape;
use crate::model::{Model, ModelMaterial, Primitive};
use crate::scene::axes::Pose;
use crate::scene::meshes::MeshTable;

/// Shapes that become one mesh, in the frame of one node.
pub(crate) struct Merged {
    origin: Pose,
    primitives: Vec<Primitive>,
}

impl Merged {
    /// Nothing yet; `origin` is the place of the node that will show the mesh.
    pub(crate) fn at(origin: Pose) -> Self {
        Self { origin, primitives: Vec::new() }
    }

    /// Adds a shape at its place in the level; whether it has triangles.
    pub(crate) fn add(&mut self, shape: Shape, pose: &Pose, meshes: &mut MeshTable<'_>) -> bool {
        let model = meshes.shape(shape);
        let seen = pose.relative_to(&self.origin);
        // In double precision, whose turns are the same on every machine: single ones are rounded as its vector unit does.
        let (translation, rotation) = (seen.translation().as_dvec3(), seen.rotation().as_dquat());
        for primitive in &model.primitives {
            let known = self.primitives.iter().position(|other| other.material == primitive.material);
            let index = known.unwrap_or_else(|| {
                let material = primitive.material.clone();
                self.primitives.push(Primitive { material, ..Primitive::default() });
                self.primitives.len() - 1
            });
            append(&mut self.primitives[index], primitive, translation, rotation);
        }
        !model.primitives.is_empty()
    }

    /// The mesh, named after the node that shows it; none if nothing was added.
    pub(crate) fn finish<'a>(
        self,
        palette: &'a str,
        node: &str,
        meshes: &mut MeshTable<'a>,
    ) -> Option<usize> {
        (!self.primitives.is_empty())
            .then(|| meshes.merged(Model { primitives: self.primitives }, palette, node))
    }
}

fn append(to: &mut Primitive, primitive: &Primitive, translation: DVec3, rotation: DQuat) {
    debug_assert!(!matches!(primitive.material, ModelMaterial::Own(_)), "the shell is made of slots");
    let first = u32::try_from(to.positions.len()).expect("a room has fewer corners");
    let turned = |vector: &[f32; 3]| rotation * Vec3::from_array(*vector).as_dvec3();
    let moved = |corner: &[f32; 3]| (translation + turned(corner)).as_vec3().to_array();
    to.positions.extend(primitive.positions.iter().map(moved));
    to.normals.extend(primitive.normals.iter().map(|normal| turned(normal).as_vec3().to_array()));
    to.texture_coordinates.extend_from_slice(&primitive.texture_coordinates);
    to.indices.extend(primitive.indices.iter().map(|index| first + index));
}
