//! The JSON document of a level and the buffer that it describes.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::sync::Arc;

use gltf_json::texture::Sampler;
use gltf_json::validation::Checked;
use gltf_json::{Asset, Image, Index, Root, Scene as JsonScene, Texture, image};
use serde::Serialize;
use serde_json::{Map, Value};

use super::encode::{Corners, Painting, encode};
use super::library::SharedModel;
use super::light::{LIGHTS, add_lights};
use super::material::{EMISSIVE_STRENGTH, Images, TRANSMISSION, material};
use super::mesh::{Accessors, mesh};
use super::node::{Node, list_nodes};
use super::options::{FlatNormals, WriteOptions};
use super::pack::{PackedPrimitive, Packer};
use super::variant::{VARIANTS, add_variants};
use super::view::{Views, percent_encoded};
use crate::model::{Model, TextureSampler, TextureUse};
use crate::scene::{GENERATOR, Scene, SceneMaterial, SceneMesh};

/// A level ready to be written.
pub(crate) struct Document<'s> {
    text: Text<'s>,
    /// The level's own buffer.
    pub packer: Packer,
}

/// The JSON document.
#[derive(Serialize)]
struct Text<'s> {
    /// All but the nodes, which are most of it and are written as the scene has them.
    #[serde(flatten)]
    root: Root,
    nodes: Vec<Node<'s>>,
}

/// About as many bytes as a node has with what it shows.
const BYTES_OF_NODE: usize = 400;

impl Document<'_> {
    /// The JSON, without line breaks.
    pub(crate) fn json(&self) -> Vec<u8> {
        let mut json = Vec::with_capacity(self.text.nodes.len() * BYTES_OF_NODE);
        serde_json::to_writer(&mut json, &self.text).expect("names are strings and numbers are finite");
        json
    }
}

/// Triangles that one or several meshes show: meshes that differ only in material share accessors.
struct Source<'l> {
    /// The file that holds them, if not the level's own.
    file: Option<&'l SharedModel>,
    primitives: Cow<'l, [PackedPrimitive]>,
}

/// Lays out the buffer, then describes it. `uri` is the path of the buffer's file; `None` inside a container.
pub(crate) fn build<'s>(scene: &'s Scene, uri: Option<&str>, options: WriteOptions<'_>) -> Document<'s> {
    let mut packer = Packer::default();
    let mut images = Images::default();
    let (sources, source_of_mesh) = pack(scene, options, &mut packer);
    let materials = scene.materials.iter().map(|source| material(source, &mut images, &mut packer));
    let mut root = Root { asset: asset(scene), materials: materials.collect(), ..Root::default() };
    let mut views = Views::new(&mut root, &packer, uri);
    let mut accessors = Accessors::default();
    let accessors: Vec<_> = sources
        .iter()
        .map(|source| accessors.describe(&mut root, &mut views, source.file, &source.primitives))
        .collect();
    for (scene_mesh, &source) in scene.meshes.iter().zip(&source_of_mesh) {
        root.meshes.push(mesh(scene_mesh, &accessors[source], &scene.variants));
    }
    add_images(&mut root, &mut views, &images);
    add_lights(&mut root, &scene.lights);
    add_variants(&mut root, &scene.variants);
    // The level is the first of its nodes.
    let level_scene = JsonScene { extensions: None, extras: None, name: None, nodes: vec![Index::new(0)] };
    root.scene = Some(root.push(level_scene));
    root.extensions_used = extensions_used(&root);
    Document { text: Text { root, nodes: list_nodes(&scene.root) }, packer }
}

/// The document of some materials alone, with their textures and images, and the buffer of images that have no file of their own.
pub(crate) fn looks(materials: impl Iterator<Item = SceneMaterial>) -> (Map<String, Value>, Vec<u8>) {
    let (mut packer, mut images) = (Packer::default(), Images::default());
    let materials = materials.map(|source| material(&source, &mut images, &mut packer)).collect();
    let mut root = Root { materials, ..Root::default() };
    let mut views = Views::new(&mut root, &packer, None);
    add_images(&mut root, &mut views, &images);
    root.extensions_used = extensions_used(&root);
    let mut bytes = Vec::with_capacity(packer.byte_count());
    packer.append_to(&mut bytes);
    match serde_json::to_value(root) {
        Ok(Value::Object(root)) => (root, bytes),
        _ => unreachable!("a document is an object of names and finite numbers"),
    }
}

fn asset(scene: &Scene) -> Asset {
    Asset { generator: Some(GENERATOR.to_owned()), copyright: scene.copyright.clone(), ..Asset::default() }
}

/// Packs each model once and says which source each mesh shows.
fn pack<'l>(scene: &Scene, options: WriteOptions<'l>, packer: &mut Packer) -> (Vec<Source<'l>>, Vec<usize>) {
    let mut sources: Vec<Source<'l>> = Vec::new();
    let mut known: BTreeMap<*const Model, usize> = BTreeMap::new();
    let mut source_of_mesh = Vec::with_capacity(scene.meshes.len());
    let mut paintings = paintings(scene, options.flat_normals);
    for mesh in &scene.meshes {
        let model = Arc::as_ptr(&mesh.model);
        let source = *known.entry(model).or_insert_with(|| {
            let shared = mesh.key.as_ref().zip(options.library).and_then(|(key, library)| library.get(key));
            sources.push(match shared {
                Some(file) => Source { file: Some(file), primitives: Cow::Borrowed(&file.primitives) },
                None => {
                    let paintings = paintings.remove(&model).unwrap_or_default();
                    let primitives = Cow::Owned(pack_model(mesh, paintings, options, packer));
                    Source { file: None, primitives }
                }
            });
            sources.len() - 1
        });
        source_of_mesh.push(source);
    }
    (sources, source_of_mesh)
}

/// Packs what is known from other levels, or else encodes it now; the shell is the level's own.
fn pack_model(
    mesh: &SceneMesh,
    paintings: Vec<Painting>,
    options: WriteOptions<'_>,
    packer: &mut Packer,
) -> Vec<PackedPrimitive> {
    match options.models.filter(|_| mesh.is_shared()) {
        Some(models) => packer.model(&models.get(&mesh.model, paintings)),
        None => {
            let corners = if mesh.is_shared() { Corners::Joined } else { Corners::Kept };
            packer.model(&encode(&mesh.model, corners, |index| paintings[index]))
        }
    }
}

/// The textures of each primitive of each model, in any of its meshes and variants.
fn paintings(scene: &Scene, flat_normals: FlatNormals) -> BTreeMap<*const Model, Vec<Painting>> {
    let mut paintings: BTreeMap<*const Model, Vec<Painting>> = BTreeMap::new();
    let plain = Painting { lacks_flat_normals: flat_normals == FlatNormals::Implied, ..Painting::default() };
    for mesh in &scene.meshes {
        let of_model = paintings
            .entry(Arc::as_ptr(&mesh.model))
            .or_insert_with(|| vec![plain; mesh.model.primitives.len()]);
        for (painting, &material) in of_model.iter_mut().zip(&mesh.materials) {
            let others = scene.variants.iter().filter_map(|variant| variant.materials.get(&material));
            for &shown in others.chain([&material]) {
                let textures = scene.materials[shown].textures();
                painting.has_coordinates |= !textures.is_empty();
                let normal = textures.iter().find(|(purpose, _)| *purpose == TextureUse::Normal);
                painting.has_tangents |= normal.is_some();
                painting.normal_set =
                    normal.map_or(painting.normal_set, |(_, texture)| texture.coordinate_set);
            }
        }
    }
    paintings
}

fn add_images(root: &mut Root, views: &mut Views, images: &Images) {
    for (source, packed) in images.all() {
        let buffer_view = packed.map(|packed| views.image(root, packed));
        root.images.push(Image {
            buffer_view,
            mime_type: Some(image::MimeType(source.mime_type.clone())),
            name: source.name.clone(),
            uri: source.uri.as_deref().map(percent_encoded),
            extensions: None,
            extras: None,
        });
    }
    let mut samplers = Vec::new();
    for &(image, sampler) in images.textures() {
        let texture = Texture {
            name: None,
            sampler: add_sampler(root, &mut samplers, sampler),
            source: Index::new(u32::try_from(image).expect("a level has few images")),
            extensions: None,
            extras: None,
        };
        root.textures.push(texture);
    }
}

/// Adds a sampler unless it is known or the format's own default.
fn add_sampler(
    root: &mut Root,
    known: &mut Vec<TextureSampler>,
    source: TextureSampler,
) -> Option<Index<Sampler>> {
    if source == TextureSampler::default() {
        return None;
    }
    let index = known.iter().position(|other| *other == source).unwrap_or_else(|| {
        let [wrap_s, wrap_t] = source.wrapping.map(Checked::Valid);
        root.samplers.push(Sampler {
            mag_filter: source.magnification.map(Checked::Valid),
            min_filter: source.minification.map(Checked::Valid),
            wrap_s,
            wrap_t,
            ..Sampler::default()
        });
        known.push(source);
        known.len() - 1
    });
    Some(Index::new(u32::try_from(index).expect("a level has few samplers")))
}

fn extensions_used(root: &Root) -> Vec<String> {
    type OfMaterial = gltf_json::extensions::material::Material;
    let on_materials = |is_used: fn(&OfMaterial) -> bool| {
        root.materials.iter().any(|material| material.extensions.as_ref().is_some_and(is_used))
    };
    let on_root =
        |is_used: fn(&gltf_json::extensions::Root) -> bool| root.extensions.as_ref().is_some_and(is_used);
    let extensions = [
        (on_root(|root| root.khr_lights_punctual.is_some()), LIGHTS),
        (on_materials(|material| material.emissive_strength.is_some()), EMISSIVE_STRENGTH),
        (on_materials(|material| material.transmission.is_some()), TRANSMISSION),
        (on_root(|root| root.khr_materials_variants.is_some()), VARIANTS),
    ];
    extensions.into_iter().filter(|(is_used, _)| *is_used).map(|(_, name)| name.to_owned()).collect()
}
