//! The file: JSON and buffer.

use std::collections::{BTreeMap, BTreeSet};

use glam::{DVec3, Vec3};
use serde_json::{Map, Value, json};

use super::Shown;
use super::buffer::{Arrays, Kind};
use super::feature::Feature;
use super::instances::Instances;
use super::lights;
use super::merged::{GLASS_OPACITY, Merged, Surface};
use super::options::{Coloring, CompactOptions};
use super::table::{STRUCTURAL_METADATA, Table};
use crate::gltf::{self, GltfError};
use crate::mesh::TextureUse;
use crate::scene::{GENERATOR, Scene, SceneMaterial};

const MESH_FEATURES: &str = "EXT_mesh_features";
const INSTANCE_FEATURES: &str = "EXT_instance_features";
const GPU_INSTANCING: &str = "EXT_mesh_gpu_instancing";
const QUANTIZATION: &str = "KHR_mesh_quantization";

/// Parts of a metre at which the middle of a level's grid is.
const GRID_PARTS: f64 = 1000.0;
/// Parts of a metre of which its steps are whole numbers.
const STEP_PARTS: f64 = 1e6;
/// Metres of the smallest model: a step is never zero.
const SMALLEST: f64 = 1e-3;
/// The highest number of a quantised position.
const HIGHEST: f64 = i16::MAX as f64;

/// What goes into a file.
pub(super) struct Parts<'s> {
    pub(super) shown: Shown<'s>,
    pub(super) options: &'s CompactOptions,
    pub(super) features: &'s [Feature],
    pub(super) merged: BTreeMap<Surface, Vec<Merged>>,
    pub(super) instances: Vec<Instances<'s>>,
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
    let table = (!parts.features.is_empty()).then(|| Table::new(parts.features, &mut text.arrays));
    let lit = if parts.options.keeps_nodes { lights::kept(parts.shown.scene) } else { BTreeSet::new() };
    let kept =
        if parts.options.keeps_nodes { gltf::bare_nodes(&parts.shown.scene.root, &lit) } else { Vec::new() };
    // All that is drawn is below one node, in the frame of the level.
    let top = kept.len();
    let mut children = Vec::new();
    if !parts.merged.is_empty() {
        children.push(text.merged(&parts.merged, parts.options.coarsest_step));
    }
    children.extend(parts.instances.iter().map(|instances| text.instances(instances, parts.shown.scene)));
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
    root.insert("asset".to_owned(), json!({"version": "2.0", "generator": GENERATOR}));
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
        let of_instances = parts.instances.iter().flat_map(|instances| instances.parts.keys());
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
        let primitives = self.primitives(merged, &grid, true);
        self.meshes.push(json!({"name": "merged", "primitives": primitives}));
        let mut node = json!({"name": "merged", "mesh": self.meshes.len() - 1});
        if grid.step > 0.0 {
            self.used.insert(QUANTIZATION);
            node["scale"] = json!([grid.step, grid.step, grid.step]);
            node["translation"] = json!(grid.origin.to_array());
        }
        self.node(node)
    }

    /// Primitives on a grid; corners have features where they are not instances, which have their own.
    fn primitives(
        &mut self,
        parts: &BTreeMap<Surface, Vec<Merged>>,
        grid: &Grid,
        has_features: bool,
    ) -> Vec<Value> {
        let listed = parts.iter().flat_map(|(surface, parts)| parts.iter().map(move |part| (*surface, part)));
        listed.map(|(surface, part)| self.primitive(surface, part, grid, has_features)).collect()
    }

    fn primitive(&mut self, surface: Surface, part: &Merged, grid: &Grid, has_features: bool) -> Value {
        let mut attributes = Map::new();
        attributes.insert("POSITION".to_owned(), json!(grid.positions(&part.positions, &mut self.arrays)));
        attributes
            .insert("NORMAL".to_owned(), json!(self.arrays.add(Kind::Normals, &normals(&part.normals))));
        for (set, coordinates) in part.coordinates.iter().enumerate() {
            attributes.insert(format!("TEXCOORD_{set}"), json!(self.coordinates(coordinates)));
        }
        if !part.colors.is_empty() {
            attributes
                .insert("COLOR_0".to_owned(), json!(self.arrays.add(Kind::Colors, &colors(&part.colors))));
        }
        let mut primitive = json!({
            "indices": self.indices(&part.indices, part.positions.len()),
            "material": self.materials[&surface],
        });
        if has_features {
            let features = numbers(part.features.iter().map(|&feature| feature as f32));
            attributes.insert("_FEATURE_ID_0".to_owned(), json!(self.arrays.add(Kind::Features, &features)));
            self.used.insert(MESH_FEATURES);
            primitive["extensions"] = json!({MESH_FEATURES: self.feature_ids()});
        }
        primitive["attributes"] = Value::Object(attributes);
        primitive
    }

    /// The node of a mesh with its instances.
    fn instances(&mut self, instances: &Instances<'_>, scene: &Scene) -> usize {
        let corners = || instances.parts.values().flatten().flat_map(|part| &part.positions);
        let grid = Grid::of_model(corners());
        let primitives = self.primitives(&instances.parts, &grid, false);
        let name = &scene.meshes[instances.mesh].name;
        self.meshes.push(json!({"name": name, "primitives": primitives}));
        self.used.extend([QUANTIZATION, GPU_INSTANCING, INSTANCE_FEATURES]);
        let drawn = &instances.drawn;
        let places = drawn.iter().flat_map(|drawn| drawn.frame.translation.as_vec3().to_array());
        let turns = drawn.iter().flat_map(|drawn| drawn.frame.rotation.as_quat().to_array());
        let scales = drawn.iter().flat_map(|_| [grid.step as f32; 3]);
        let features = drawn.iter().map(|drawn| drawn.feature as f32);
        let attributes = json!({
            "TRANSLATION": self.arrays.add(Kind::Vectors, &numbers(places)),
            "ROTATION": self.arrays.add(Kind::Rotations, &numbers(turns)),
            "SCALE": self.arrays.add(Kind::Vectors, &numbers(scales)),
            "_FEATURE_ID_0": self.arrays.add(Kind::InstanceFeatures, &numbers(features)),
        });
        let node = json!({
            "name": name,
            "mesh": self.meshes.len() - 1,
            "extensions": {
                GPU_INSTANCING: {"attributes": attributes},
                INSTANCE_FEATURES: self.feature_ids(),
            },
        });
        self.node(node)
    }

    fn node(&mut self, node: Value) -> usize {
        self.nodes.push(node);
        self.nodes.len() - 1
    }

    fn feature_ids(&self) -> Value {
        json!({"featureIds": [{"featureCount": self.feature_count, "attribute": 0, "propertyTable": 0}]})
    }

    /// Texture coordinates, in half as many bytes where none repeats its image.
    fn coordinates(&mut self, coordinates: &[[f32; 2]]) -> usize {
        let is_share = |number: &f32| (0.0..=1.0).contains(number);
        if coordinates.as_flattened().iter().all(is_share) {
            let share = |number: &f32| ((number * f32::from(u16::MAX)).round() as u16).to_le_bytes();
            let bytes: Vec<u8> = coordinates.as_flattened().iter().flat_map(share).collect();
            return self.arrays.add(Kind::Shares, &bytes);
        }
        self.arrays.add(Kind::Coordinates, &numbers(coordinates.as_flattened().iter().copied()))
    }

    fn indices(&mut self, indices: &[u32], corner_count: usize) -> usize {
        // The highest number is no corner but restarts a strip.
        if corner_count < usize::from(u16::MAX) {
            let bytes: Vec<u8> = indices.iter().flat_map(|&index| (index as u16).to_le_bytes()).collect();
            return self.arrays.add(Kind::ShortIndices, &bytes);
        }
        let bytes: Vec<u8> = indices.iter().flat_map(|index| index.to_le_bytes()).collect();
        self.arrays.add(Kind::LongIndices, &bytes)
    }
}

/// The grid of positions.
struct Grid {
    /// Metres of its middle in the frame of what is on it.
    origin: DVec3,
    /// Metres; zero where positions stay metres.
    step: f64,
}

impl Grid {
    /// The grid of a model, whose steps are as fine as 16 bits make them, around the model's own origin.
    fn of_model<'p>(corners: impl Iterator<Item = &'p DVec3>) -> Self {
        let farthest = corners.fold(SMALLEST, |most, corner| most.max(corner.abs().max_element()));
        // Instances are scaled by it in single precision.
        Self { origin: DVec3::ZERO, step: f64::from((farthest / HIGHEST) as f32) }
    }

    /// The grid of a level; none where it would be coarser than this.
    fn of_level<'p>(corners: impl Iterator<Item = &'p DVec3>, coarsest_step: f64) -> Self {
        let empty = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let (low, high) = corners.fold(empty, |(low, high), corner| (low.min(*corner), high.max(*corner)));
        let origin = ((low + high) / 2.0 * GRID_PARTS).round() / GRID_PARTS;
        let reach = (high - origin).max(origin - low).max_element();
        let step = (reach / HIGHEST * STEP_PARTS).ceil() / STEP_PARTS;
        if step <= coarsest_step { Self { origin, step } } else { Self { origin: DVec3::ZERO, step: 0.0 } }
    }

    fn positions(&self, corners: &[DVec3], arrays: &mut Arrays) -> usize {
        if self.step > 0.0 {
            let limit = |number: f64| number.round().clamp(-HIGHEST, HIGHEST) as i16;
            let step = |corner: &DVec3| ((*corner - self.origin) / self.step).to_array().map(limit);
            return add_steps(&corners.iter().map(step).collect::<Vec<_>>(), arrays);
        }
        let metres: Vec<[f32; 3]> = corners.iter().map(|corner| corner.as_vec3().to_array()).collect();
        let bounds = bounds(&metres.iter().map(|corner| corner.map(f64::from)).collect::<Vec<_>>());
        arrays.add_bounded(Kind::Metres, &numbers(metres.as_flattened().iter().copied()), Some(bounds))
    }
}

fn add_steps(steps: &[[i16; 3]], arrays: &mut Arrays) -> usize {
    let bounds = bounds(&steps.iter().map(|corner| corner.map(f64::from)).collect::<Vec<_>>());
    let bytes: Vec<u8> =
        steps.iter().flat_map(|&[x, y, z]| [x, y, z, 0].map(i16::to_le_bytes)).flatten().collect();
    arrays.add_bounded(Kind::Steps, &bytes, Some(bounds))
}

fn bounds(corners: &[[f64; 3]]) -> [[f64; 3]; 2] {
    let empty = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
    corners.iter().fold(empty, |[low, high], corner| {
        [
            [0, 1, 2].map(|axis| low[axis].min(corner[axis])),
            [0, 1, 2].map(|axis| high[axis].max(corner[axis])),
        ]
    })
}

fn normals(directions: &[Vec3]) -> Vec<u8> {
    let byte = |number: f32| ((number * f32::from(i8::MAX)).round() as i8) as u8;
    directions.iter().flat_map(|direction| [direction.x, direction.y, direction.z, 0.0].map(byte)).collect()
}

fn colors(colors: &[[f32; 4]]) -> Vec<u8> {
    let byte = |channel: f32| (channel.clamp(0.0, 1.0) * f32::from(u8::MAX)).round() as u8;
    colors.iter().flat_map(|color| color.map(byte)).collect()
}

fn numbers(numbers: impl Iterator<Item = f32>) -> Vec<u8> {
    // Without a negative zero.
    numbers.flat_map(|number| (number + 0.0).to_le_bytes()).collect()
}
