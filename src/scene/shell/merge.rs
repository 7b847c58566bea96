//! Merges parts of the shell that never move separately into one mesh.

use std::sync::Arc;

use glam::{DVec3, Vec3};

use super::{MergedKey, Shape};
use crate::catalog::PaletteRef;
use crate::model::{Model, ModelMaterial, Primitive};
use crate::scene::axes::Pose;
use crate::scene::meshes::MeshTable;

/// Shapes that become one mesh, in the frame of one node.
pub(crate) struct Merged {
    origin: Pose,
    key: MergedKey,
    parts: Vec<MergedPart>,
}

/// A shape at its place in the merged mesh.
struct MergedPart {
    model: Arc<Model>,
    pose: Pose,
}

impl Merged {
    /// Nothing yet; `origin` is the place of the node that will show the mesh.
    pub(crate) fn at(origin: Pose) -> Self {
        Self { origin, key: MergedKey::new(), parts: Vec::new() }
    }

    /// Adds a shape at its place in the level; whether it has triangles.
    pub(crate) fn add(&mut self, shape: Shape, pose: &Pose, meshes: &mut MeshTable<'_>) -> bool {
        let (number, model) = meshes.shape(shape);
        if model.primitives.is_empty() {
            return false;
        }
        let pose = pose.relative_to(&self.origin);
        let mut bits = [0; 7];
        let numbers = pose.translation().to_array().into_iter().chain(pose.rotation().to_array());
        bits.iter_mut().zip(numbers).for_each(|(place, number)| *place = number.to_bits());
        self.key.push((number, bits));
        self.parts.push(MergedPart { model, pose });
        true
    }

    /// The mesh, named after the first node that shows it; none if nothing was added.
    pub(crate) fn finish<'a>(
        self,
        palette: PaletteRef,
        node: &str,
        meshes: &mut MeshTable<'a>,
    ) -> Option<usize> {
        let Self { key, parts, .. } = self;
        (!key.is_empty()).then(|| meshes.merged((key, palette), node, || build(&parts)))
    }
}

/// One primitive for each material.
fn build(parts: &[MergedPart]) -> Model {
    let mut primitives: Vec<Primitive> = Vec::new();
    for part in parts {
        for primitive in &part.model.primitives {
            let known = primitives.iter().position(|other| other.material == primitive.material);
            let index = known.unwrap_or_else(|| {
                primitives.push(empty(&primitive.material, parts));
                primitives.len() - 1
            });
            append(&mut primitives[index], primitive, &part.pose);
        }
    }
    Model { primitives }
}

/// A primitive with room for all parts of a material.
fn empty(material: &ModelMaterial, parts: &[MergedPart]) -> Primitive {
    debug_assert!(!matches!(material, ModelMaterial::Own(_)), "the shell is made of slots");
    let primitives = parts.iter().flat_map(|part| &part.model.primitives);
    let (corners, indices) = primitives
        .filter(|primitive| primitive.material == *material)
        .fold((0, 0), |(corners, indices), one| (corners + one.positions.len(), indices + one.indices.len()));
    Primitive {
        material: material.clone(),
        positions: Vec::with_capacity(corners),
        normals: Vec::with_capacity(corners),
        texture_coordinates: Vec::with_capacity(corners),
        indices: Vec::with_capacity(indices),
        ..Primitive::default()
    }
}

fn append(to: &mut Primitive, primitive: &Primitive, pose: &Pose) {
    // In double precision, whose turns are the same on every machine: single ones are rounded as its vector unit does.
    let (translation, rotation) = (pose.translation().as_dvec3(), pose.rotation().as_dquat());
    let first = u32::try_from(to.positions.len()).expect("a room has fewer corners");
    let turned = |vector: &[f32; 3]| -> DVec3 { rotation * Vec3::from_array(*vector).as_dvec3() };
    let moved = |corner: &[f32; 3]| (translation + turned(corner)).as_vec3().to_array();
    to.positions.extend(primitive.positions.iter().map(moved));
    to.normals.extend(primitive.normals.iter().map(|normal| turned(normal).as_vec3().to_array()));
    to.texture_coordinates.extend_from_slice(&primitive.texture_coordinates);
    to.indices.extend(primitive.indices.iter().map(|index| first + index));
}
