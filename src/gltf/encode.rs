//! Primitives as arrays.

use std::borrow::Cow;
use std::sync::Arc;

use super::array::{Array, Section};
use super::join::{has_colors, is_flat, joined};
use super::tangent::tangents;
use crate::model::{Model, Primitive};

/// What is written of a primitive beyond positions and triangles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Painting {
    /// Texture coordinates: something is painted on it.
    pub has_coordinates: bool,
    /// Tangents: normals are.
    pub has_tangents: bool,
    /// The set of texture coordinates that normals are laid on by.
    pub normal_set: usize,
    /// No normals where every face is flat and nothing is painted: viewers compute those (glTF 2.0, section 3.7.2.1),
    /// and faces can share corners.
    pub lacks_flat_normals: bool,
}

/// The arrays of a primitive; those of a model that many levels show are made once and shared.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct EncodedPrimitive {
    pub positions: Arc<Array>,
    pub normals: Option<Arc<Array>>,
    pub tangents: Option<Arc<Array>>,
    pub coordinates: Vec<Arc<Array>>,
    pub colors: Option<Arc<Array>>,
    pub indices: Arc<Array>,
}

/// The triangles of a model, with what the painting of each primitive, by index, asks for.
pub(crate) fn encode(model: &Model, painting: impl Fn(usize) -> Painting) -> Vec<EncodedPrimitive> {
    let primitives = model.primitives.iter().enumerate();
    primitives.map(|(index, primitive)| encode_primitive(primitive, painting(index))).collect()
}

fn encode_primitive(primitive: &Primitive, painting: Painting) -> EncodedPrimitive {
    let is_mapped = primitive.texture_coordinates.len() == primitive.positions.len();
    let has_coordinates = painting.has_coordinates && is_mapped;
    let has_tangents = painting.has_tangents && is_mapped;
    let has_normals = !painting.lacks_flat_normals || has_coordinates || !is_flat(primitive);
    // With coordinates, no corner of recipes and shell is double.
    let primitive = match has_coordinates {
        true => Cow::Borrowed(primitive),
        false => Cow::Owned(joined(primitive, has_normals)),
    };
    EncodedPrimitive {
        positions: Arc::new(Array::positions(&primitive.positions)),
        normals: has_normals.then(|| floats(Section::Vectors, &primitive.normals)),
        tangents: has_tangents.then(|| floats(Section::Tangents, &tangents(&primitive, painting.normal_set))),
        coordinates: match has_coordinates {
            true => primitive.coordinate_sets().map(|set| floats(Section::Coordinates, set)).collect(),
            false => Vec::new(),
        },
        colors: has_colors(&primitive).then(|| floats(Section::Colors, &primitive.colors)),
        indices: Arc::new(Array::indices(&primitive.indices, primitive.positions.len())),
    }
}

fn floats<const N: usize>(section: Section, values: &[[f32; N]]) -> Arc<Array> {
    Arc::new(Array::floats(section, values))
}
