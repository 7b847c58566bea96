//! Meshes and their accessors.

use std::collections::BTreeMap;

use gltf_json::accessor::{Accessor, ComponentType, GenericComponentType, Type};
use gltf_json::mesh::{Mesh, Mode, Primitive, Semantic};
use gltf_json::validation::{Checked, USize64};
use gltf_json::{Index, Root, Value};

use super::array::Section;
use super::library::SharedModel;
use super::number::short_number;
use super::pack::{Packed, PackedPrimitive};
use super::variant::mappings;
use super::view::Views;
use crate::scene::{SceneMesh, SceneVariant};

/// The accessors of a primitive.
pub(crate) struct PrimitiveAccessors {
    /// Which of the model's primitives it is, or is a part of.
    source: usize,
    attributes: BTreeMap<Checked<Semantic>, Index<Accessor>>,
    indices: Index<Accessor>,
}

/// The path of the file if it is not the level's own, place, number of elements, and whether bounds are written.
type AccessorKey = (Option<String>, Section, usize, usize, bool);

/// Accessors of a level, each once: what lies in one place, in as many elements, is one.
#[derive(Default)]
pub(crate) struct Accessors {
    known: BTreeMap<AccessorKey, Index<Accessor>>,
}

impl Accessors {
    /// Describes packed primitives.
    pub(crate) fn describe<'l>(
        &mut self,
        root: &mut Root,
        views: &mut Views<'l>,
        file: Option<&'l SharedModel>,
        primitives: &[PackedPrimitive],
    ) -> Vec<PrimitiveAccessors> {
        let mut add = |packed: &Packed| {
            let path = file.map(|file| file.path.clone());
            let key = (path, packed.section, packed.offset, packed.count, packed.bounds.is_some());
            *self.known.entry(key).or_insert_with(|| {
                let view = views.section(root, file, packed.section);
                root.push(accessor(packed, view))
            })
        };
        let accessors = primitives.iter().map(|primitive| {
            let mut attributes =
                BTreeMap::from([(Checked::Valid(Semantic::Positions), add(&primitive.positions))]);
            let optional = [
                (Semantic::Normals, &primitive.normals),
                (Semantic::Tangents, &primitive.tangents),
                (Semantic::Colors(0), &primitive.colors),
            ];
            for (semantic, packed) in optional {
                if let Some(packed) = packed {
                    attributes.insert(Checked::Valid(semantic), add(packed));
                }
            }
            for (set, packed) in (0..).zip(&primitive.coordinates) {
                attributes.insert(Checked::Valid(Semantic::TexCoords(set)), add(packed));
            }
            PrimitiveAccessors { source: primitive.source, attributes, indices: add(&primitive.indices) }
        });
        accessors.collect()
    }
}

/// A mesh over accessors that other meshes may use too.
pub(crate) fn mesh(source: &SceneMesh, accessors: &[PrimitiveAccessors], variants: &[SceneVariant]) -> Mesh {
    let primitive = |accessors: &PrimitiveAccessors| {
        let material = source.materials[accessors.source];
        Primitive {
            attributes: accessors.attributes.clone(),
            indices: Some(accessors.indices),
            material: Some(Index::new(u32::try_from(material).expect("a level has few materials"))),
            mode: Checked::Valid(Mode::Triangles),
            targets: None,
            extensions: mappings(material, variants),
            extras: None,
        }
    };
    Mesh {
        name: Some(source.name.clone()),
        primitives: accessors.iter().map(primitive).collect(),
        weights: None,
        extensions: None,
        extras: None,
    }
}

fn accessor(packed: &Packed, view: Index<gltf_json::buffer::View>) -> Accessor {
    let (component, kind) = match packed.section {
        Section::Vectors => (ComponentType::F32, Type::Vec3),
        Section::Coordinates => (ComponentType::F32, Type::Vec2),
        Section::Colors | Section::Tangents => (ComponentType::F32, Type::Vec4),
        Section::TinyIndices => (ComponentType::U8, Type::Scalar),
        Section::ShortIndices => (ComponentType::U16, Type::Scalar),
        Section::LongIndices | Section::Images => (ComponentType::U32, Type::Scalar),
    };
    let value = |vector: [f64; 3]| Value::from(vector.map(short_number).to_vec());
    Accessor {
        buffer_view: Some(view),
        byte_offset: (packed.offset > 0).then(|| USize64::from(packed.offset)),
        count: USize64::from(packed.count),
        component_type: Checked::Valid(GenericComponentType(component)),
        type_: Checked::Valid(kind),
        min: packed.bounds.map(|(low, _)| value(low)),
        max: packed.bounds.map(|(_, high)| value(high)),
        name: None,
        normalized: false,
        sparse: None,
        extensions: None,
        extras: None,
    }
}
