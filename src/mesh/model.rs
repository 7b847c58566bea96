//! Meshes of furniture in the glTF frame.

use std::sync::Arc;

use glam::Vec3;
use gltf_json::texture::{MagFilter, MinFilter, WrappingMode};
use serde::{Deserialize, Serialize};

use super::material::Material;
use crate::recipes::{Mesh, MeshPart, Slot};

/// The look of one variant of a class.
///
/// Frame: glTF's, metres, Y up; origin in the middle of the underside of the class's box, the front faces
/// +Z, width along X. Every corner lies in the box to 1 mm.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Model {
    /// Parts by material; at least one.
    pub primitives: Vec<Primitive>,
}

/// Triangles of one material; counter-clockwise seen from outside.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Primitive {
    /// Its material.
    pub material: ModelMaterial,
    /// Corners.
    pub positions: Vec<[f32; 3]>,
    /// Unit normals, one per position.
    pub normals: Vec<[f32; 3]>,
    /// Texture coordinates, one per position, or none.
    pub texture_coordinates: Vec<[f32; 2]>,
    /// Further sets of them, each with one per position: images of users' models may be laid on in several ways.
    pub further_coordinates: Vec<Vec<[f32; 2]>>,
    /// Linear red, green, blue and opacity that multiply the base colour, one per position, or none.
    pub colors: Vec<[f32; 4]>,
    /// Three per triangle.
    pub indices: Vec<u32>,
}

impl Primitive {
    /// Its material and corners with other triangles, three of its corners each; corners of none are left out.
    pub(crate) fn with_triangles(&self, triangles: impl Iterator<Item = u32>) -> Self {
        let mut new = vec![None; self.positions.len()];
        let mut kept = Vec::new();
        let indices = triangles.map(|corner| {
            *new[corner as usize].get_or_insert_with(|| {
                kept.push(corner as usize);
                u32::try_from(kept.len() - 1).expect("not more corners than there were")
            })
        });
        let indices = indices.collect();
        Self {
            material: self.material.clone(),
            positions: picked(&self.positions, &kept),
            normals: picked(&self.normals, &kept),
            texture_coordinates: picked(&self.texture_coordinates, &kept),
            further_coordinates: self.further_coordinates.iter().map(|set| picked(set, &kept)).collect(),
            colors: picked(&self.colors, &kept),
            indices,
        }
    }

    /// All sets of texture coordinates, in their order.
    pub fn coordinate_sets(&self) -> impl Iterator<Item = &[[f32; 2]]> {
        std::iter::once(&self.texture_coordinates).chain(&self.further_coordinates).map(Vec::as_slice)
    }
}

impl Model {
    /// The lowest and the highest corner of its box; infinite where it has no corners.
    pub(crate) fn bounds(&self) -> [Vec3; 2] {
        let corners = self.primitives.iter().flat_map(|part| &part.positions).copied().map(Vec3::from_array);
        let empty = [Vec3::INFINITY, Vec3::NEG_INFINITY];
        corners.fold(empty, |[low, high], corner| [low.min(corner), high.max(corner)])
    }
}

impl From<Mesh> for Model {
    fn from(mesh: Mesh) -> Self {
        Self { primitives: mesh.parts.into_iter().map(Primitive::from).collect() }
    }
}

impl From<MeshPart> for Primitive {
    fn from(part: MeshPart) -> Self {
        Self {
            material: ModelMaterial::Slot(part.slot),
            positions: part.positions,
            normals: part.normals,
            texture_coordinates: part.texture_coordinates,
            further_coordinates: Vec::new(),
            colors: Vec::new(),
            indices: part.indices,
        }
    }
}

/// The material of a primitive.
#[derive(Clone, Debug, PartialEq)]
pub enum ModelMaterial {
    /// A slot of the style's palette.
    Slot(Slot),
    /// Several slots of the style's palette, sorted: texture coordinates are the places of their swatches.
    Swatches(Arc<[Slot]>),
    /// A material of a user's file, shared by all its primitives.
    Own(Arc<OwnMaterial>),
}

impl Default for ModelMaterial {
    fn default() -> Self {
        Self::Slot(Slot::Wood)
    }
}

/// A material that came with a user's model.
#[derive(Clone, Debug, PartialEq)]
pub struct OwnMaterial {
    /// Its name in the file, or one made from the file's name.
    pub name: String,
    /// The factors.
    pub material: Material,
    /// Seen from both sides.
    pub is_double_sided: bool,
    /// The meaning of its opacity.
    pub transparency: Transparency,
    /// Textures by use.
    pub textures: Vec<(TextureUse, Texture)>,
}

impl OwnMaterial {
    /// How many sets of texture coordinates its images need.
    #[must_use]
    pub fn coordinate_set_count(&self) -> usize {
        coordinate_set_count(&self.textures)
    }
}

/// The values of some corners, or none if corners have none.
fn picked<T: Copy>(values: &[T], corners: &[usize]) -> Vec<T> {
    corners.iter().filter_map(|&corner| values.get(corner).copied()).collect()
}

/// How many sets of texture coordinates some textures need.
pub(crate) fn coordinate_set_count(textures: &[(TextureUse, Texture)]) -> usize {
    textures.iter().map(|(_, texture)| texture.coordinate_set + 1).max().unwrap_or(0)
}

/// The meaning of the opacity of an [`OwnMaterial`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Transparency {
    /// Nothing (`OPAQUE`).
    #[default]
    Opaque,
    /// Below this opacity nothing is drawn (`MASK`).
    CutOut(f32),
    /// What is behind shines through (`BLEND`).
    Blended,
}

/// An image and how it is laid on.
#[derive(Clone, Debug, PartialEq)]
pub struct Texture {
    /// The image.
    pub image: Arc<Image>,
    /// How it is repeated and filtered.
    pub sampler: TextureSampler,
    /// The set of texture coordinates that it is laid on by: 0 is [`Primitive::texture_coordinates`], those of
    /// [`Primitive::further_coordinates`] follow.
    pub coordinate_set: usize,
    /// How much normals or occlusion count; without meaning for other uses.
    pub strength: f32,
}

impl Texture {
    /// An image that is laid on by the first set and counts as it is.
    #[must_use]
    pub fn plain(image: Arc<Image>, sampler: TextureSampler) -> Self {
        Self { image, sampler, coordinate_set: 0, strength: 1.0 }
    }
}

/// How an image is repeated and filtered, in the format's own words. The usual one repeats both ways and leaves
/// the filters to the viewer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TextureSampler {
    /// What lies beyond the image's sides, and above and below it.
    pub wrapping: [WrappingMode; 2],
    /// Seen from near.
    pub magnification: Option<MagFilter>,
    /// Seen from afar.
    pub minification: Option<MinFilter>,
}

/// The use of an image of an [`OwnMaterial`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum TextureUse {
    /// Base colour and opacity.
    BaseColor,
    /// Metallic (blue) and roughness (green).
    MetallicRoughness,
    /// Tangent-space normals.
    Normal,
    /// Ambient occlusion (red).
    Occlusion,
    /// Light given off.
    Emissive,
}

/// An encoded image.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// A name for people; users' images keep that of their file.
    pub name: Option<String>,
    /// `image/png` or `image/jpeg`.
    pub mime_type: String,
    /// The file's bytes.
    pub bytes: Vec<u8>,
    /// Path of the image's own file, relative to the files that show it, with `/` between folders; none for an image
    /// that goes into these files.
    pub uri: Option<String>,
}
