//! Turns primitives into arrays.

use std::sync::Arc;

use super::array::{Array, Section};
use super::flatness::{is_flat, split};
use super::join::{has_colors, joined, joined_with_coordinates};
use super::tangent::tangents;
use crate::model::{Model, ModelMaterial, Primitive};

/// The attributes of a primitive beyond positions and triangles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Painting {
    /// Texture coordinates, for primitives with a texture.
    pub has_coordinates: bool,
    /// Tangents: normals are.
    pub has_tangents: bool,
    /// The set of texture coordinates that normals are laid on by.
    pub normal_set: usize,
    /// No normals on surfaces without textures of which every face is flat or narrow, or that have few faces:
    /// viewers compute those (glTF 2.0, section 3.7.2.1), and faces can share corners.
    pub lacks_flat_normals: bool,
}

/// The arrays of a primitive; those of a model that many levels show are made once and shared.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct EncodedPrimitive {
    /// Which of the model's primitives it is, or is a part of.
    pub source: usize,
    pub positions: Arc<Array>,
    pub normals: Option<Arc<Array>>,
    pub tangents: Option<Arc<Array>>,
    pub coordinates: Vec<Arc<Array>>,
    pub colors: Option<Arc<Array>>,
    pub indices: Arc<Array>,
}

impl EncodedPrimitive {
    /// Bytes of all arrays.
    fn byte_count(&self) -> usize {
        let optional = [&self.normals, &self.tangents, &self.colors].into_iter().flatten();
        let arrays = optional.chain(&self.coordinates).chain([&self.positions, &self.indices]);
        arrays.map(|array| array.bytes.len()).sum()
    }
}

/// About as many bytes as JSON takes to describe one more primitive.
const BYTES_OF_PRIMITIVE: usize = 350;

/// The treatment of corners whose attributes are all equal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Corners {
    /// They become one: a twelfth of those of furniture, which is encoded once a run.
    Joined,
    /// They are left where they keep normals: one in two hundred of a shell, which is encoded for each level.
    Kept,
}

/// The triangles of a model, with what the painting of each primitive, by index, asks for.
pub(crate) fn encode(
    model: &Model,
    corners: Corners,
    painting: impl Fn(usize) -> Painting,
) -> Vec<EncodedPrimitive> {
    let primitives = model.primitives.iter().enumerate();
    let encoded = primitives
        .flat_map(|(source, primitive)| encode_primitive(source, primitive, corners, painting(source)));
    encoded.collect()
}

/// One, or one with and one without normals where this is shorter.
fn encode_primitive(
    source: usize,
    primitive: &Primitive,
    corners: Corners,
    painting: Painting,
) -> Vec<EncodedPrimitive> {
    let is_mapped = primitive.texture_coordinates.len() == primitive.positions.len();
    let is_joined = corners == Corners::Joined;
    if painting.has_coordinates && is_mapped {
        // No corner that shows a texture is double, but those of plain parts were to be joined.
        let is_plain = matches!(primitive.material, ModelMaterial::Swatches(_));
        let joined = (is_joined && is_plain).then(|| joined_with_coordinates(primitive));
        return vec![arrays(source, joined.as_ref().unwrap_or(primitive), painting)];
    }
    let plain = Painting { has_coordinates: false, has_tangents: false, ..painting };
    if !painting.lacks_flat_normals {
        let joined = is_joined.then(|| joined(primitive, true));
        return vec![arrays(source, joined.as_ref().unwrap_or(primitive), plain)];
    }
    let without = |part: &Primitive| arrays(source, &joined(part, false), plain);
    let with = |part: &Primitive| {
        let painting = Painting { lacks_flat_normals: false, ..plain };
        arrays(source, &joined(part, true), painting)
    };
    if is_flat(primitive) {
        return vec![without(primitive)];
    }
    let [flat, round] = split(primitive);
    if round.indices.is_empty() {
        return vec![without(primitive)];
    }
    let whole = vec![with(primitive)];
    if flat.indices.is_empty() {
        return whole;
    }
    let parts = vec![without(&flat), with(&round)];
    let byte_count =
        |parts: &[EncodedPrimitive]| parts.iter().map(EncodedPrimitive::byte_count).sum::<usize>();
    if byte_count(&parts) + BYTES_OF_PRIMITIVE < byte_count(&whole) { parts } else { whole }
}

/// A primitive as it is.
fn arrays(source: usize, primitive: &Primitive, painting: Painting) -> EncodedPrimitive {
    let has_normals = painting.has_coordinates || !painting.lacks_flat_normals;
    EncodedPrimitive {
        source,
        positions: Arc::new(Array::positions(&primitive.positions)),
        normals: has_normals.then(|| floats(Section::Vectors, &primitive.normals)),
        tangents: painting
            .has_tangents
            .then(|| floats(Section::Tangents, &tangents(primitive, painting.normal_set))),
        coordinates: match painting.has_coordinates {
            true => primitive.coordinate_sets().map(|set| floats(Section::Coordinates, set)).collect(),
            false => Vec::new(),
        },
        colors: has_colors(primitive).then(|| floats(Section::Colors, &primitive.colors)),
        indices: Arc::new(Array::indices(&primitive.indices, primitive.positions.len())),
    }
}

fn floats<const N: usize>(section: Section, values: &[[f32; N]]) -> Arc<Array> {
    Arc::new(Array::floats(section, values))
}
