//! The file: JSON and buffer.

use std::collections::{BTreeMap, BTreeSet};

use glam::{DQuat, Vec3};
use serde_json::{Map, Value, json};

use super::Shown;
use super::buffer::{Arrays, Kind};
use super::encode::{EncodedPart, Grid, encode, instance_features, numbers, rotations};
use super::feature::Feature;
use super::instances::Instances;
use super::lights;
use super::merged::{GLASS_OPACITY, Merged, Surface};
use super::options::{Coloring, CompactOptions};
use super::table::{STRUCTURAL_METADATA, Table};
use crate::gltf::{self, GltfError};
use crate::mesh::TextureUse;
use crate::scene::{GENERATOR, SceneMaterial};

const MESH_FEATURES: &str = "EXT_mesh_features";
const INSTANCE_FEATURES: &str = "EXT_instance_features";
const GPU_INSTANCING: &str = "EXT_mesh_gpu_instancing";
const QUANTIZATION: &str = "KHR_mesh_quantization";

/// The attribute of the numbers of features.
const FEATURE_ID: &str = "_FEATURE_ID_0";

/// What goes into a file.
pub(super) struct Parts<'s> {
    pub(super) shown: Shown<'s>,
    pub(super) options: &'s CompactOptions,
    pub(super) features: &'s [Feature],
    pub(super) merged: BTreeMap<Surface, Vec<Merged>>,
    pub(super) instances: Vec<Instances>,
}

/// Writes the file.
pub(super) fn write(parts: &Parts<'_>) -> Result<Vec<u8>, GltfError> {
    let materials = Materials::new(parts);
    let mut text = Text {
        nodes: Vec::new(),
        meshes: Vec::new(),
        arrays: Arrays::default(),
        used: BTreeSet::new(),
        materials: &materials.of_surface,
        feature_count: parts.features.len(),
    };
    let table = Table::new(parts.features, &mut text.arrays);
    let lit = if parts.options.keeps_nodes { lights::kept(parts.shown.scene) } else { BTreeSet::new() };
    let kept =
        if parts.options.keeps_nodes { gltf::bare_nodes(&parts.shown.scene.root, &lit) } else { Vec::new() };
    // All that is drawn is below one node, in the frame of the level.
    let top = kept.len();
    let mut children = Vec::new();
    if !parts.merged.is_empty() {
        children.push(text.merged(&parts.merged, parts.options.coarsest_step));
    }
    children.extend(parts.instances.iter().map(|instances| text.instances(instances)));
    let Text { nodes: drawn, meshes, arrays, mut used, .. } = text;
    let mut root = materials.root;
    let laid = arrays.lay(materials.images, count_of(&root, "bufferViews"));
    append(&mut root, "bufferViews", laid.views);
    append(&mut root, "accessors", laid.accessors);
    append(&mut root, "meshes", meshes);
    let shift = |index: usize| top + 1 + index;
    let mut drawing = json!({"name": format!("{} drawn", parts.shown.scene.root.name)});
    if !children.is_empty() {
        drawing["children"] = json!(children.into_iter().map(shift).collect::<Vec<_>>());
    }
    let roots: Vec<usize> = if top > 0 { vec![0, top] } else { vec![top] };
    append(&mut root, "nodes", kept.into_iter().chain([drawing]).chain(drawn).collect());
    if !laid.bytes.is_empty() {
        root.insert("buffers".to_owned(), json!([{"byteLength": laid.bytes.len()}]));
    }
    if let Some(table) = table {
        used.insert(STRUCTURAL_METADATA);
        extend(&mut root, STRUCTURAL_METADATA, table.extension(&laid.tables));
    }
    if !lit.is_empty() {
        used.insert(gltf::LIGHTS);
        extend(&mut root, gltf::LIGHTS, gltf::light_list(&parts.shown.scene.lights));
    }
    name_extensions(&mut root, &used);
    root.insert("scene".to_owned(), json!(0));
    root.insert("scenes".to_owned(), json!([{"nodes": roots}]));
    let mut asset = json!({"version": "2.0", "generator": GENERATOR});
    if let Some(copyright) = &parts.shown.scene.copyright {
        asset["copyright"] = json!(copyright);
    }
    root.insert("asset".to_owned(), asset);
    let json = serde_json::to_vec(&root).expect("names are strings and numbers are finite");
    gltf::write_container(&json, &laid.bytes)
}

/// Adds an extension of the document.
fn extend(root: &mut Map<String, Value>, name: &str, extension: Value) {
    root.entry("extensions").or_insert_with(|| json!({}))[name] = extension;
}

/// Adds to a list of the document.
fn append(root: &mut Map<String, Value>, key: &str, values: Vec<Value>) {
    if values.is_empty() {
        return;
    }
    let list = root.entry(key).or_insert_with(|| json!([]));
    list.as_array_mut().expect("the document has lists of these names").extend(values);
}

fn count_of(root: &Map<String, Value>, key: &str) -> usize {
    root.get(key).and_then(Value::as_array).map_or(0, Vec::len)
}

/// The extensions that a client has to know to draw what is there, and the others.
fn name_extensions(root: &mut Map<String, Value>, used: &BTreeSet<&'static str>) {
    let required: Vec<&str> =
        used.iter().copied().filter(|name| [GPU_INSTANCING, QUANTIZATION].contains(name)).collect();
    append(root, "extensionsUsed", used.iter().map(|name| json!(name)).collect());
    append(root, "extensionsRequired", required.into_iter().map(|name| json!(name)).collect());
}

/// The materials of a file.
struct Materials {
    /// The document with materials, textures and images.
    root: Map<String, Value>,
    /// The bytes of images inside the file, with which its buffer begins.
    images: Vec<u8>,
    of_surface: BTreeMap<Surface, usize>,
}

impl Materials {
    /// Those that are shown, in the order of the scene.
    fn new(parts: &Parts<'_>) -> Self {
        let of_instances = parts.instances.iter().flat_map(|instances| &instances.surfaces);
        let surfaces: BTreeSet<Surface> = parts.merged.keys().chain(of_instances).copied().collect();
        let of_surface = surfaces.iter().copied().zip(0..).collect();
        if parts.options.coloring == Coloring::Corners {
            let materials: Vec<Value> = surfaces.iter().map(|surface| corner_material(*surface)).collect();
            let mut root = Map::new();
            append(&mut root, "materials", materials);
            return Self { root, images: Vec::new(), of_surface };
        }
        let shown = surfaces.iter().filter_map(|surface| match surface {
            Surface::Material(index) => Some(simplified(&parts.shown.materials[*index], parts.options)),
            _ => None,
        });
        let (root, images) = gltf::looks(shown);
        Self { root, images, of_surface }
    }
}

/// The material of corners that have their own colours.
fn corner_material(surface: Surface) -> Value {
    let mut material = json!({"pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0.8}});
    if surface == Surface::Clear {
        material["alphaMode"] = json!("BLEND");
    }
    material
}

/// A material without what clients of cities do not draw, or not at once: glass is drawn by its opacity.
fn simplified(source: &SceneMaterial, options: &CompactOptions) -> SceneMaterial {
    let keeps = |purpose: TextureUse| options.has_normal_maps || purpose != TextureUse::Normal;
    let mut made = source.clone();
    let factors = match &mut made {
        SceneMaterial::Slot { material, textures, .. } => {
            textures.retain(|(purpose, _)| keeps(*purpose));
            material
        }
        SceneMaterial::Own(own) => {
            let own = std::sync::Arc::make_mut(own);
            own.textures.retain(|(purpose, _)| keeps(*purpose));
            &mut own.material
        }
    };
    if factors.transmission > 0.0 {
        factors.transmission = 0.0;
        factors.base_color[3] = GLASS_OPACITY;
    }
    made
}

/// The text under construction.
struct Text<'m> {
    /// Nodes below that of all that is drawn.
    nodes: Vec<Value>,
    meshes: Vec<Value>,
    arrays: Arrays,
    used: BTreeSet<&'static str>,
    materials: &'m BTreeMap<Surface, usize>,
    feature_count: usize,
}

impl Text<'_> {
    /// The node of all that is merged.
    fn merged(&mut self, merged: &BTreeMap<Surface, Vec<Merged>>, coarsest_step: f64) -> usize {
        let corners = merged.values().flatten().flat_map(|part| &part.positions);
        let grid = Grid::of_level(corners, coarsest_step);
        let listed =
            merged.iter().flat_map(|(surface, parts)| parts.iter().map(move |part| (*surface, part)));
        let primitives: Vec<Value> = listed
            .map(|(surface, part)| {
                let mut primitive = self.primitive(surface, &encode(part, &grid));
                let features = numbers(part.features.iter().map(|&feature| feature as f32));
                primitive["attributes"][FEATURE_ID] = json!(self.arrays.add(Kind::Features, &features));
                primitive["extensions"] = json!({MESH_FEATURES: self.feature_ids()});
                primitive
            })
            .collect();
        self.used.insert(MESH_FEATURES);
        self.meshes.push(json!({"name": "merged", "primitives": primitives}));
        let mut node = json!({"name": "merged", "mesh": self.meshes.len() - 1});
        if grid.step > 0.0 {
            self.used.insert(QUANTIZATION);
            node["scale"] = json!([grid.step, grid.step, grid.step]);
            node["translation"] = json!(grid.origin.to_array());
        }
        self.node(node)
    }

    /// A primitive with all but its features.
    fn primitive(&mut self, surface: Surface, part: &EncodedPart) -> Value {
        let mut attributes = Map::new();
        let (kind, bytes) = &part.positions;
        attributes
            .insert("POSITION".to_owned(), json!(self.arrays.add_bounded(*kind, bytes, Some(part.bounds))));
        attributes.insert("NORMAL".to_owned(), json!(self.arrays.add(Kind::Normals, &part.normals)));
        for (set, (kind, bytes)) in part.coordinates.iter().enumerate() {
            attributes.insert(format!("TEXCOORD_{set}"), json!(self.arrays.add(*kind, bytes)));
        }
        if !part.colors.is_empty() {
            attributes.insert("COLOR_0".to_owned(), json!(self.arrays.add(Kind::Colors, &part.colors)));
        }
        let (kind, bytes) = &part.indices;
        json!({
            "attributes": attributes,
            "indices": self.arrays.add(*kind, bytes),
            "material": self.materials[&surface],
        })
    }

    /// The node of a mesh with its instances.
    fn instances(&mut self, instances: &Instances) -> usize {
        let Instances { name, surfaces, model, places } = instances;
        let parts = model.parts.iter();
        let primitives: Vec<Value> =
            parts.map(|(look, part)| self.primitive(surfaces[*look], part)).collect();
        self.meshes.push(json!({"name": name, "primitives": primitives}));
        self.used.extend([QUANTIZATION, GPU_INSTANCING, INSTANCE_FEATURES]);
        // Places in steps of the model, so that the node alone has to say how large a step is.
        let step = f64::from(model.step);
        let translations =
            places.iter().flat_map(|place| (place.frame.translation / step).as_vec3().to_array());
        let (kind, features) = instance_features(places.iter().map(|place| place.feature));
        let mut attributes = json!({
            "TRANSLATION": self.arrays.add(Kind::Vectors, &numbers(translations)),
            FEATURE_ID: self.arrays.add(kind, &features),
        });
        if places.iter().any(|place| place.scale != Vec3::ONE) {
            let scales = places.iter().flat_map(|place| place.scale.to_array());
            attributes["SCALE"] = json!(self.arrays.add(Kind::Vectors, &numbers(scales)));
        }
        if places.iter().any(|place| place.frame.rotation != DQuat::IDENTITY) {
            let turns = rotations(places.iter().map(|place| place.frame.rotation));
            attributes["ROTATION"] = json!(self.arrays.add(Kind::Rotations, &turns));
        }
        let mut node = json!({
            "name": name,
            "mesh": self.meshes.len() - 1,
            "extensions": {
                GPU_INSTANCING: {"attributes": attributes},
                INSTANCE_FEATURES: self.feature_ids(),
            },
        });
        if model.step != 1.0 {
            node["scale"] = json!([model.step, model.step, model.step]);
        }
        self.node(node)
    }

    fn node(&mut self, node: Value) -> usize {
        self.nodes.push(node);
        self.nodes.len() - 1
    }

    fn feature_ids(&self) -> Value {
        json!({"featureIds": [{"featureCount": self.feature_count, "attribute": 0, "propertyTable": 0}]})
    }
}
