//! Reads how a file looks apart from the places of objects: shell, models, materials, textures, lights.
//!
//! Each entry is a name and a short text that differs if the entry does. Triangles are known by their counts and bounds,
//! which the document has; buffers are not opened.

use std::collections::BTreeMap;
use std::fmt::Write;

use gltf::json::accessor::Accessor;
use gltf::json::mesh::Primitive;
use gltf::json::validation::Checked;
use gltf::json::{Index, Root};

use super::tree::Node;
use crate::contract::Extras;

/// Name to description.
pub type Described = BTreeMap<String, String>;

/// The descriptions of a file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Looks {
    /// Parts of rooms and openings, by the name of their node.
    pub shell: Described,
    /// Meshes of furniture, by name.
    pub models: Described,
    /// Materials, by name.
    pub materials: Described,
    /// Images, by their place or number.
    pub textures: Described,
    /// Lights, by name or number.
    pub lights: Described,
}

impl Looks {
    pub(super) fn read(document: &Root, nodes: &[Node]) -> Self {
        let mut looks = Self { materials: materials(document), ..Self::default() };
        for node in nodes {
            let shape = || node.mesh.map_or_else(String::new, |mesh| shape(document, mesh));
            match &node.extras {
                Some(Extras::Part(part)) => {
                    let description = format!(
                        "{} {:?} {:?} {}",
                        place(node),
                        part.tags,
                        material_names(document, node.mesh),
                        shape()
                    );
                    looks.shell.insert(node.name.clone(), description);
                }
                Some(Extras::Furniture(_)) => {
                    if let Some(name) = mesh_name(document, node.mesh) {
                        looks.models.entry(name.to_owned()).or_insert_with(shape);
                    }
                }
                _ => {}
            }
        }
        looks.textures = textures(document);
        looks.lights = lights(document);
        looks
    }
}

/// A node's transform to a tenth of a millimetre.
fn place(node: &Node) -> String {
    let mut text = String::new();
    for number in node.local.to_cols_array() {
        let _ = write!(text, "{} ", (number * 1e4).round() as i64);
    }
    text
}

pub(super) fn mesh_name(document: &Root, mesh: Option<usize>) -> Option<&str> {
    document.meshes.get(mesh?)?.name.as_deref()
}

/// The names of a mesh's materials, sorted, each once.
pub(super) fn material_names(document: &Root, mesh: Option<usize>) -> Vec<String> {
    let Some(mesh) = mesh.and_then(|mesh| document.meshes.get(mesh)) else { return Vec::new() };
    let used = mesh.primitives.iter().filter_map(|primitive| primitive.material);
    let named = used.filter_map(|index| document.materials.get(index.value())?.name.clone());
    let mut names: Vec<String> = named.collect();
    names.sort();
    names.dedup();
    names
}

/// Triangles and bounds of a mesh's primitives, to a tenth of a millimetre. Not how many corners they share: editors split
/// and join those, and order primitives as they like.
pub(super) fn shape(document: &Root, mesh: usize) -> String {
    let accessor = |index: Index<Accessor>| document.accessors.get(index.value());
    let primitives = document.meshes.get(mesh).map_or(&[][..], |mesh| &mesh.primitives);
    let describe = |primitive: &Primitive| {
        let corners = primitive.indices.and_then(accessor).map_or(0, |found| found.count.0);
        let positions = primitive.attributes.get(&Checked::Valid(gltf::Semantic::Positions));
        let positions = positions.and_then(|&index| accessor(index));
        let bounds = positions.map(|found| [&found.min, &found.max].map(|bound| bounds(bound.as_ref())));
        format!("{corners} {bounds:?}")
    };
    let mut described: Vec<String> = primitives.iter().map(describe).collect();
    described.sort();
    described.join(" ")
}

fn bounds(value: Option<&serde_json::Value>) -> Vec<i64> {
    let numbers = value.and_then(serde_json::Value::as_array).into_iter().flatten();
    numbers.filter_map(serde_json::Value::as_f64).map(|number| (number * 1e4).round() as i64).collect()
}

/// The box around a mesh; `None` where the file does not say.
pub(super) fn mesh_bounds(document: &Root, mesh: usize) -> Option<[[f64; 3]; 2]> {
    let mut around = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
    for primitive in &document.meshes.get(mesh)?.primitives {
        let positions = primitive.attributes.get(&Checked::Valid(gltf::Semantic::Positions))?;
        let accessor = document.accessors.get(positions.value())?;
        let corner = |bound: &Option<serde_json::Value>| -> Option<[f64; 3]> {
            serde_json::from_value(bound.clone()?).ok()
        };
        let (low, high) = (corner(&accessor.min)?, corner(&accessor.max)?);
        for axis in 0..3 {
            around[0][axis] = around[0][axis].min(low[axis]);
            around[1][axis] = around[1][axis].max(high[axis]);
        }
    }
    around[0][0].is_finite().then_some(around)
}

/// Each material by name; which of the images it shows is counted in that file, so left out.
fn materials(document: &Root) -> Described {
    let entries = document.materials.iter().filter_map(|material| {
        let name = material.name.clone()?;
        let factors = &material.pbr_metallic_roughness;
        let description = format!(
            "{:?} {:?} {:?} {:?} {:?} {} {} {}",
            factors.base_color_factor.0,
            factors.metallic_factor.0,
            factors.roughness_factor.0,
            material.emissive_factor.0,
            material.alpha_mode,
            material.double_sided,
            factors.base_color_texture.is_some(),
            material.normal_texture.is_some(),
        );
        Some((name, description))
    });
    entries.collect()
}

fn textures(document: &Root) -> Described {
    let entries = document.images.iter().enumerate().map(|(number, image)| {
        let length = image.buffer_view.and_then(|view| document.buffer_views.get(view.value()));
        let length = length.map(|view| view.byte_length.0);
        let name = image.name.clone().or_else(|| image.uri.clone()).unwrap_or_else(|| number.to_string());
        (name, format!("{:?} {length:?}", image.uri))
    });
    entries.collect()
}

fn lights(document: &Root) -> Described {
    let lights = document.extensions.as_ref().and_then(|extensions| extensions.khr_lights_punctual.as_ref());
    let lights = lights.map_or(&[][..], |found| &found.lights);
    let entries = lights.iter().enumerate().map(|(number, light)| {
        let name = light.name.as_deref().map_or_else(|| number.to_string(), |name| own_name(name).to_owned());
        (name, format!("{:.4?} {:.2}", light.color, light.intensity))
    });
    entries.collect()
}

/// A name without the number that Blender gives to the second object of a name: `.001`.
fn own_name(name: &str) -> &str {
    let is_number = |end: &&str| end.len() == 3 && end.bytes().all(|byte| byte.is_ascii_digit());
    name.rsplit_once('.').filter(|(_, end)| is_number(end)).map_or(name, |(own, _)| own)
}
