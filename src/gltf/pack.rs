//! Vertices and indices as the bytes of a buffer.

use super::tangent::tangents;
use crate::model::{Model, Primitive};

/// A part of a buffer with one kind of element; each becomes one buffer view.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Section {
    /// Three floats: positions and normals.
    Vectors,
    /// Four floats: tangents.
    Tangents,
    /// Two floats: texture coordinates.
    Coordinates,
    /// Four floats: colours.
    Colors,
    /// Indices of meshes with few corners.
    ShortIndices,
    /// Indices of meshes with more corners than 16 bits can name.
    LongIndices,
    /// Encoded images; each has a view of its own.
    Images,
}

impl Section {
    /// All sections in the order of the buffer.
    pub(crate) const ALL: [Self; 7] = [
        Self::Vectors,
        Self::Tangents,
        Self::Coordinates,
        Self::Colors,
        Self::ShortIndices,
        Self::LongIndices,
        Self::Images,
    ];
}

/// Sections and images begin at multiples of this.
const ALIGNMENT: usize = 4;

/// Where the elements of an accessor lie in their section.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Packed {
    /// The section.
    pub section: Section,
    /// Bytes from the section's start.
    pub offset: usize,
    /// How many elements.
    pub count: usize,
    /// Lowest and highest values, where the format asks for them.
    pub bounds: Option<([f32; 3], [f32; 3])>,
}

/// The accessors of a primitive.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PackedPrimitive {
    pub positions: Packed,
    pub normals: Packed,
    pub tangents: Option<Packed>,
    pub coordinates: Option<Packed>,
    pub colors: Option<Packed>,
    pub indices: Packed,
}

/// What textures ask of a primitive beyond positions and normals.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Painting {
    /// Texture coordinates: something is painted on it.
    pub has_coordinates: bool,
    /// Tangents: normals are.
    pub has_tangents: bool,
}

/// A buffer under construction.
#[derive(Clone, Debug, Default)]
pub(crate) struct Packer {
    sections: [Vec<u8>; Section::ALL.len()],
}

impl Packer {
    /// Adds the triangles of a model, with what the painting of each primitive, by index, asks for.
    pub(crate) fn model(
        &mut self,
        model: &Model,
        painting: impl Fn(usize) -> Painting,
    ) -> Vec<PackedPrimitive> {
        let primitives = model.primitives.iter().enumerate();
        primitives.map(|(index, primitive)| self.primitive(primitive, painting(index))).collect()
    }

    fn primitive(&mut self, primitive: &Primitive, painting: Painting) -> PackedPrimitive {
        let is_mapped = primitive.texture_coordinates.len() == primitive.positions.len();
        let has_coordinates = painting.has_coordinates && is_mapped;
        let has_tangents = painting.has_tangents && is_mapped;
        let mut positions = self.floats(Section::Vectors, primitive.positions.as_flattened(), 3);
        positions.bounds = Some(bounds(&primitive.positions));
        PackedPrimitive {
            positions,
            normals: self.floats(Section::Vectors, primitive.normals.as_flattened(), 3),
            tangents: has_tangents
                .then(|| self.floats(Section::Tangents, tangents(primitive).as_flattened(), 4)),
            coordinates: has_coordinates
                .then(|| self.floats(Section::Coordinates, primitive.texture_coordinates.as_flattened(), 2)),
            colors: has_colors(primitive)
                .then(|| self.floats(Section::Colors, primitive.colors.as_flattened(), 4)),
            indices: self.indices(primitive),
        }
    }

    fn floats(&mut self, section: Section, values: &[f32], per_element: usize) -> Packed {
        let bytes = &mut self.sections[section as usize];
        let offset = bytes.len();
        bytes.resize(offset + size_of_val(values), 0);
        for (place, value) in bytes[offset..].as_chunks_mut::<4>().0.iter_mut().zip(values) {
            *place = value.to_le_bytes();
        }
        Packed { section, offset, count: values.len() / per_element, bounds: None }
    }

    fn indices(&mut self, primitive: &Primitive) -> Packed {
        // The highest 16-bit index is no corner but restarts a strip.
        let is_short = primitive.positions.len() < usize::from(u16::MAX);
        let section = if is_short { Section::ShortIndices } else { Section::LongIndices };
        let bytes = &mut self.sections[section as usize];
        let offset = bytes.len();
        if is_short {
            bytes.extend(primitive.indices.iter().flat_map(|&index| (index as u16).to_le_bytes()));
        } else {
            bytes.extend(primitive.indices.iter().flat_map(|&index| index.to_le_bytes()));
        }
        Packed { section, offset, count: primitive.indices.len(), bounds: None }
    }

    /// Adds an encoded image.
    pub(crate) fn image(&mut self, image: &[u8]) -> Packed {
        let bytes = &mut self.sections[Section::Images as usize];
        let offset = bytes.len();
        bytes.extend_from_slice(image);
        bytes.resize(bytes.len().next_multiple_of(ALIGNMENT), 0);
        Packed { section: Section::Images, offset, count: image.len(), bounds: None }
    }

    /// Start and length of a section in bytes.
    pub(crate) fn extent(&self, section: Section) -> (usize, usize) {
        let before = &self.sections[..section as usize];
        let start = before.iter().map(|bytes| bytes.len().next_multiple_of(ALIGNMENT)).sum();
        (start, self.sections[section as usize].len())
    }

    /// Length of the whole buffer.
    pub(crate) fn byte_count(&self) -> usize {
        self.sections.iter().map(|bytes| bytes.len().next_multiple_of(ALIGNMENT)).sum()
    }

    /// Writes the buffer.
    pub(crate) fn append_to(&self, file: &mut Vec<u8>) {
        for section in &self.sections {
            file.extend_from_slice(section);
            let padding = section.len().next_multiple_of(ALIGNMENT) - section.len();
            file.extend_from_slice(&[0; ALIGNMENT][..padding]);
        }
    }
}

fn has_colors(primitive: &Primitive) -> bool {
    !primitive.colors.is_empty() && primitive.colors.len() == primitive.positions.len()
}

fn bounds(positions: &[[f32; 3]]) -> ([f32; 3], [f32; 3]) {
    let first = positions.first().copied().unwrap_or_default();
    positions.iter().fold((first, first), |(low, high), position| {
        let pick = |axis: usize| (low[axis].min(position[axis]), high[axis].max(position[axis]));
        let [x, y, z] = [pick(0), pick(1), pick(2)];
        ([x.0, y.0, z.0], [x.1, y.1, z.1])
    })
}
