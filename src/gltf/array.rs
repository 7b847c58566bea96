//! The elements of one accessor, as bytes.

use std::sync::Arc;

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
    /// Indices of meshes with very few corners.
    TinyIndices,
    /// Indices of meshes with few corners.
    ShortIndices,
    /// Indices of meshes with more corners than 16 bits can name.
    LongIndices,
    /// Encoded images; each has a view of its own.
    Images,
}

impl Section {
    /// All sections in the order of the buffer.
    pub(crate) const ALL: [Self; 8] = [
        Self::Vectors,
        Self::Tangents,
        Self::Coordinates,
        Self::Colors,
        Self::TinyIndices,
        Self::ShortIndices,
        Self::LongIndices,
        Self::Images,
    ];
}

/// Lowest and highest values.
pub(crate) type Bounds = ([f64; 3], [f64; 3]);

/// Elements of one kind as bytes.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Array {
    /// Where they belong.
    pub section: Section,
    /// How many.
    pub count: usize,
    /// Lowest and highest values, where the format asks for them.
    pub bounds: Option<Bounds>,
    /// Little-endian.
    pub bytes: Arc<[u8]>,
    /// Equal bytes have equal ones. It finds what may be equal and stands in no file.
    pub fingerprint: u64,
}

impl Array {
    /// Positions, with their bounds.
    pub(crate) fn positions(positions: &[[f32; 3]]) -> Self {
        let mut array = Self::floats(Section::Vectors, positions);
        array.bounds = Some(bounds(positions));
        array
    }

    /// Vectors of floats.
    pub(crate) fn floats<const N: usize>(section: Section, values: &[[f32; N]]) -> Self {
        let numbers = values.as_flattened();
        let mut bytes = vec![0; size_of_val(numbers)];
        for (place, number) in bytes.as_chunks_mut::<4>().0.iter_mut().zip(numbers) {
            *place = number.to_le_bytes();
        }
        Self::new(section, values.len(), bytes)
    }

    /// Indices into so many corners, as short as they can be.
    pub(crate) fn indices(indices: &[u32], corner_count: usize) -> Self {
        // The highest index of a kind is no corner but restarts a strip.
        let (section, bytes) = if corner_count < usize::from(u8::MAX) {
            (Section::TinyIndices, indices.iter().map(|&index| index as u8).collect())
        } else if corner_count < usize::from(u16::MAX) {
            let short = indices.iter().flat_map(|&index| (index as u16).to_le_bytes());
            (Section::ShortIndices, short.collect())
        } else {
            (Section::LongIndices, indices.iter().flat_map(|&index| index.to_le_bytes()).collect())
        };
        Self::new(section, indices.len(), bytes)
    }

    fn new(section: Section, count: usize, bytes: Vec<u8>) -> Self {
        let fingerprint = fingerprint(&bytes);
        Self { section, count, bounds: None, bytes: bytes.into(), fingerprint }
    }
}

/// A number that differs for nearly all bytes that differ, eight of them at a time: those that it does not distinguish are compared
/// byte by byte. The multiplier is that of D. Knuth's linear congruential generator MMIX.
pub(crate) fn fingerprint(bytes: &[u8]) -> u64 {
    let (words, rest) = bytes.as_chunks::<8>();
    let mut last = [0; 8];
    last[..rest.len()].copy_from_slice(rest);
    words.iter().chain([&last]).fold(bytes.len() as u64, |found, word| {
        (found ^ u64::from_le_bytes(*word)).wrapping_mul(6_364_136_223_846_793_005).rotate_left(29)
    })
}

fn bounds(positions: &[[f32; 3]]) -> Bounds {
    let first = positions.first().copied().unwrap_or_default();
    let (low, high) = positions.iter().fold((first, first), |(low, high), position| {
        let pick = |axis: usize| (low[axis].min(position[axis]), high[axis].max(position[axis]));
        let [x, y, z] = [pick(0), pick(1), pick(2)];
        ([x.0, y.0, z.0], [x.1, y.1, z.1])
    });
    (low.map(short), high.map(short))
}

/// The number whose shortest spelling names a single one: JSON would spell the same number as a double with nine more
/// digits, which say nothing and are a tenth of a level's text.
fn short(value: f32) -> f64 {
    value.to_string().parse().expect("numbers are spelled as they are read")
}
