//! The arrays of a compact file: one buffer view for each kind of element, accessors into them.

use std::collections::HashMap;
use std::ops::Range;

use serde_json::{Value, json};

use crate::gltf::fingerprint;

/// A kind of element; each kind has a buffer view.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum Kind {
    /// Positions as whole numbers of a step.
    Steps,
    /// Positions in metres.
    Metres,
    /// Unit vectors.
    Normals,
    /// Linear colours.
    Colors,
    /// Texture coordinates beyond 0 to 1.
    Coordinates,
    /// Texture coordinates between 0 and 1.
    Shares,
    /// Numbers of features of corners.
    Features,
    /// Translations and scales of instances.
    Vectors,
    /// Rotations of instances: shares of the highest number of 16 bits, which is a fifth of a millimetre at a reach of six metres.
    Rotations,
    /// Numbers of features of instances, which are no corners: they need not fill four bytes.
    InstanceFeatures,
    /// The same where there are more than 16 bits count.
    ManyInstanceFeatures,
    /// Indices of fewer corners than 16 bits count.
    ShortIndices,
    /// Indices of more.
    LongIndices,
}

/// The component types of glTF (table in section 3.6.2.2).
const BYTE: u32 = 5120;
const UNSIGNED_BYTE: u32 = 5121;
const SHORT: u32 = 5122;
const UNSIGNED_SHORT: u32 = 5123;
const UNSIGNED_INT: u32 = 5125;
const FLOAT: u32 = 5126;
/// What a view is for (`bufferView.target`).
const ARRAY_BUFFER: u32 = 34_962;
const ELEMENT_ARRAY_BUFFER: u32 = 34_963;

impl Kind {
    const ALL: [Self; 13] = [
        Self::Steps,
        Self::Metres,
        Self::Normals,
        Self::Colors,
        Self::Coordinates,
        Self::Shares,
        Self::Features,
        Self::Vectors,
        Self::Rotations,
        Self::InstanceFeatures,
        Self::ManyInstanceFeatures,
        Self::ShortIndices,
        Self::LongIndices,
    ];

    /// Component type, type, whether numbers are shares of their highest, and bytes of an element with what fills it up to four.
    const fn layout(self) -> (u32, &'static str, bool, usize) {
        match self {
            Self::Steps => (SHORT, "VEC3", false, 8),
            Self::Metres | Self::Vectors => (FLOAT, "VEC3", false, 12),
            Self::Normals => (BYTE, "VEC3", true, 4),
            Self::Colors => (UNSIGNED_BYTE, "VEC4", true, 4),
            Self::Coordinates => (FLOAT, "VEC2", false, 8),
            Self::Shares => (UNSIGNED_SHORT, "VEC2", true, 4),
            Self::Features | Self::ManyInstanceFeatures => (FLOAT, "SCALAR", false, 4),
            Self::Rotations => (SHORT, "VEC4", true, 8),
            Self::InstanceFeatures | Self::ShortIndices => (UNSIGNED_SHORT, "SCALAR", false, 2),
            Self::LongIndices => (UNSIGNED_INT, "SCALAR", false, 4),
        }
    }

    /// What its view is for; views of instances are for nothing that has a number.
    const fn target(self) -> Option<u32> {
        match self {
            Self::ShortIndices | Self::LongIndices => Some(ELEMENT_ARRAY_BUFFER),
            Self::Vectors | Self::Rotations | Self::InstanceFeatures | Self::ManyInstanceFeatures => None,
            _ => Some(ARRAY_BUFFER),
        }
    }
}

/// Where property tables begin in a buffer (`EXT_structural_metadata`).
const TABLE_ALIGNMENT: usize = 8;

/// The buffer under construction.
#[derive(Debug, Default)]
pub(super) struct Arrays {
    kinds: [Vec<u8>; Kind::ALL.len()],
    accessors: Vec<(Kind, Value)>,
    /// The accessor of each array that is there, by its kind and fingerprint. Nothing is read from it in its own order.
    known: HashMap<(Kind, u64), Vec<usize>>,
    /// Where the array of each accessor is among those of its kind.
    places: Vec<Range<usize>>,
    tables: Vec<Vec<u8>>,
}

/// The finished buffer, and the JSON that describes it.
pub(super) struct Laid {
    pub(super) bytes: Vec<u8>,
    pub(super) views: Vec<Value>,
    pub(super) accessors: Vec<Value>,
    /// The view of each table.
    pub(super) tables: Vec<usize>,
}

impl Arrays {
    /// Adds elements, each as long as its kind says, and gives their accessor; equal ones share one.
    pub(super) fn add(&mut self, kind: Kind, bytes: &[u8]) -> usize {
        self.add_bounded(kind, bytes, None)
    }

    /// Adds elements with their lowest and highest values.
    pub(super) fn add_bounded(&mut self, kind: Kind, bytes: &[u8], bounds: Option<[[f64; 3]; 2]>) -> usize {
        let (component, shape, is_normalized, stride) = kind.layout();
        let held = &mut self.kinds[kind as usize];
        let alike = self.known.entry((kind, fingerprint(bytes))).or_default();
        if let Some(&accessor) = alike.iter().find(|&&accessor| held[self.places[accessor].clone()] == *bytes)
        {
            return accessor;
        }
        alike.push(self.accessors.len());
        self.places.push(held.len()..held.len() + bytes.len());
        let mut accessor = json!({
            "byteOffset": held.len(), "componentType": component, "type": shape, "count": bytes.len() / stride,
        });
        if is_normalized {
            accessor["normalized"] = json!(true);
        }
        if let Some([low, high]) = bounds {
            accessor["min"] = json!(low);
            accessor["max"] = json!(high);
        }
        held.extend_from_slice(bytes);
        self.accessors.push((kind, accessor));
        self.accessors.len() - 1
    }

    /// Adds the bytes of a column of a table, and gives its number among them.
    pub(super) fn add_table(&mut self, bytes: Vec<u8>) -> usize {
        self.tables.push(bytes);
        self.tables.len() - 1
    }

    /// Lays everything out behind bytes that are there already and have so many views.
    pub(super) fn lay(self, mut bytes: Vec<u8>, first_view: usize) -> Laid {
        let mut views = Vec::new();
        let mut view_of_kind = [0; Kind::ALL.len()];
        for kind in Kind::ALL {
            let held = &self.kinds[kind as usize];
            if held.is_empty() {
                continue;
            }
            bytes.resize(bytes.len().next_multiple_of(4), 0);
            let mut view = json!({"buffer": 0, "byteOffset": bytes.len(), "byteLength": held.len()});
            if let Some(target) = kind.target() {
                view["target"] = json!(target);
                if target == ARRAY_BUFFER {
                    view["byteStride"] = json!(kind.layout().3);
                }
            }
            view_of_kind[kind as usize] = first_view + views.len();
            views.push(view);
            bytes.extend_from_slice(held);
        }
        let mut tables = Vec::new();
        for table in self.tables {
            bytes.resize(bytes.len().next_multiple_of(TABLE_ALIGNMENT), 0);
            tables.push(first_view + views.len());
            views.push(json!({"buffer": 0, "byteOffset": bytes.len(), "byteLength": table.len()}));
            bytes.extend_from_slice(&table);
        }
        bytes.resize(bytes.len().next_multiple_of(4), 0);
        let accessors = self.accessors.into_iter().map(|(kind, mut accessor)| {
            accessor["bufferView"] = json!(view_of_kind[kind as usize]);
            accessor
        });
        Laid { bytes, views, accessors: accessors.collect(), tables }
    }
}
