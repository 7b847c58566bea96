//! Meshes of furniture in the glTF frame.

use std::sync::Arc;

use crate::catalog::{Material, Size};

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
    /// What it is made of.
    pub material: ModelMaterial,
    /// Corners.
    pub positions: Vec<[f32; 3]>,
    /// Unit normals, one per position.
    pub normals: Vec<[f32; 3]>,
    /// Texture coordinates, one per position, or none.
    pub texture_coordinates: Vec<[f32; 2]>,
    /// Three per triangle.
    pub indices: Vec<u32>,
}

/// The material of a primitive.
#[derive(Clone, Debug, PartialEq)]
pub enum ModelMaterial {
    /// A slot of the style's palette, one of [`crate::catalog::MATERIAL_SLOTS`].
    Slot(&'static str),
    /// A material of a user's file, shared by all its primitives.
    Own(Arc<OwnMaterial>),
}

impl Default for ModelMaterial {
    fn default() -> Self {
        Self::Slot("wood")
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
    /// Opacity below which nothing is drawn (`MASK`), if any.
    pub alpha_cutoff: Option<f32>,
    /// Images by use.
    pub textures: Vec<(TextureUse, Arc<Image>)>,
}

/// What an image of an [`OwnMaterial`] is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
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

/// An encoded image as found in a user's file.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// `image/png` or `image/jpeg`.
    pub mime_type: String,
    /// The file's bytes.
    pub bytes: Vec<u8>,
}

/// Which model to build.
#[derive(Clone, Copy, Debug)]
pub struct ModelRequest<'a> {
    /// Size of the box to fill.
    pub size: Size,
    /// The look, 0 up to the class's number of looks.
    pub look: u32,
    /// Geometry set of the style.
    pub geometry: &'a str,
}
