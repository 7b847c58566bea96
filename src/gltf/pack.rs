//! Packs arrays into a buffer, equal ones once.

use std::collections::HashMap;
use std::sync::Arc;

use super::array::{Array, Bounds, Section};
use super::encode::EncodedPrimitive;

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
    pub bounds: Option<Bounds>,
}

/// The accessors of a primitive.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PackedPrimitive {
    /// Which of the model's primitives it is, or is a part of.
    pub source: usize,
    pub positions: Packed,
    pub normals: Option<Packed>,
    pub tangents: Option<Packed>,
    pub coordinates: Vec<Packed>,
    pub colors: Option<Packed>,
    pub indices: Packed,
}

/// A buffer under construction.
#[derive(Clone, Debug, Default)]
pub(crate) struct Packer {
    sections: [Filling; Section::ALL.len()],
}

/// The content of a section so far.
#[derive(Clone, Debug, Default)]
struct Filling {
    pieces: Vec<Piece>,
    byte_count: usize,
    /// Numbers of the pieces by fingerprint. Nothing is read from it in its own order.
    known: HashMap<u64, Vec<usize>>,
}

#[derive(Clone, Debug)]
struct Piece {
    offset: usize,
    bytes: Arc<[u8]>,
}

impl Packer {
    /// Adds the triangles of a model.
    pub(crate) fn model(&mut self, primitives: &[EncodedPrimitive]) -> Vec<PackedPrimitive> {
        primitives.iter().map(|primitive| self.primitive(primitive)).collect()
    }

    fn primitive(&mut self, primitive: &EncodedPrimitive) -> PackedPrimitive {
        let mut optional = |array: &Option<Arc<Array>>| array.as_ref().map(|array| self.array(array));
        let (normals, tangents) = (optional(&primitive.normals), optional(&primitive.tangents));
        let colors = optional(&primitive.colors);
        let coordinates = primitive.coordinates.iter().map(|array| self.array(array)).collect();
        let (positions, indices) = (self.array(&primitive.positions), self.array(&primitive.indices));
        PackedPrimitive {
            source: primitive.source,
            positions,
            normals,
            tangents,
            coordinates,
            colors,
            indices,
        }
    }

    /// Adds an array, unless one with the same bytes is there: boxes of all sizes have the same triangles and normals.
    fn array(&mut self, array: &Array) -> Packed {
        let offset = self.sections[array.section as usize].add(array);
        Packed { section: array.section, offset, count: array.count, bounds: array.bounds }
    }

    /// Adds an encoded image.
    pub(crate) fn image(&mut self, image: &[u8]) -> Packed {
        let mut bytes = image.to_vec();
        bytes.resize(bytes.len().next_multiple_of(ALIGNMENT), 0);
        let offset = self.sections[Section::Images as usize].push(bytes.into());
        Packed { section: Section::Images, offset, count: image.len(), bounds: None }
    }

    /// Start and length of a section in bytes.
    pub(crate) fn extent(&self, section: Section) -> (usize, usize) {
        let before = &self.sections[..section as usize];
        let start = before.iter().map(|filling| filling.byte_count.next_multiple_of(ALIGNMENT)).sum();
        (start, self.sections[section as usize].byte_count)
    }

    /// Length of the whole buffer.
    pub(crate) fn byte_count(&self) -> usize {
        self.sections.iter().map(|filling| filling.byte_count.next_multiple_of(ALIGNMENT)).sum()
    }

    /// Writes the buffer.
    pub(crate) fn append_to(&self, file: &mut Vec<u8>) {
        for filling in &self.sections {
            for piece in &filling.pieces {
                file.extend_from_slice(&piece.bytes);
            }
            let padding = filling.byte_count.next_multiple_of(ALIGNMENT) - filling.byte_count;
            file.extend_from_slice(&[0; ALIGNMENT][..padding]);
        }
    }
}

impl Filling {
    /// The offset of an array's bytes.
    fn add(&mut self, array: &Array) -> usize {
        let same = self.known.get(&array.fingerprint).map_or(&[][..], Vec::as_slice);
        let same = same.iter().map(|&number| &self.pieces[number]);
        if let Some(found) = same.into_iter().find(|piece| piece.bytes == array.bytes) {
            return found.offset;
        }
        self.known.entry(array.fingerprint).or_default().push(self.pieces.len());
        self.push(Arc::clone(&array.bytes))
    }

    fn push(&mut self, bytes: Arc<[u8]>) -> usize {
        let offset = self.byte_count;
        self.byte_count += bytes.len();
        self.pieces.push(Piece { offset, bytes });
        offset
    }
}
