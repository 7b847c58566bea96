//! Models that the levels of a building share: one file for each model in use.

use std::sync::{Arc, Mutex, PoisonError};

use super::encode::Painting;
use super::library::{SharedLibrary, SharedModel};
use super::options::FlatNormals;
use crate::catalog::Catalog;
use crate::disk::content_hash;
use crate::model::{Model, ModelMaterial, TextureUse};
use crate::output::{LevelOptions, SHARED_GEOMETRY};
use crate::scene::{ModelKey, Scene};
use crate::texture::has_relief;

/// Digits of the content's hash in the name of a model's file.
const NAME_DIGITS: usize = 12;

/// The models of a run as floors share them, laid out when a level first shows them.
pub(crate) struct GeometryLibrary<'a> {
    catalog: &'a Catalog,
    options: &'a LevelOptions,
    known: Mutex<SharedLibrary>,
}

impl<'a> GeometryLibrary<'a> {
    /// Nothing is laid out yet.
    pub(crate) fn new(catalog: &'a Catalog, options: &'a LevelOptions) -> Self {
        Self { catalog, options, known: Mutex::default() }
    }

    /// The models that a scene shows. A file's bytes and its name depend on the model and the catalogue alone, so that
    /// processes and shards agree on it, and runs with other catalogues do not disturb each other.
    pub(crate) fn of_scene(&self, scene: &Scene) -> SharedLibrary {
        let keyed = scene.meshes.iter().filter_map(|mesh| Some((mesh.key.as_ref()?, &mesh.model)));
        keyed.map(|(key, model)| (key.clone(), self.shared(key, model))).collect()
    }

    fn shared(&self, key: &ModelKey, model: &Model) -> Arc<SharedModel> {
        let known = || self.known.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(found) = known().get(key) {
            return Arc::clone(found);
        }
        // Two threads may come here at once: both make the same.
        let painting = |material: &ModelMaterial| painting(self.catalog, material, self.options);
        let made = Arc::new(SharedModel::new(model, painting, |bytes| file_name(key, bytes)));
        known().insert(key.clone(), Arc::clone(&made));
        made
    }
}

/// The name tells class, variant and content, which sets of geometry may share.
fn file_name(key: &ModelKey, bytes: &[u8]) -> String {
    let hash = content_hash(bytes);
    format!("{SHARED_GEOMETRY}/{}.{}.bin", key.variant, &hash[..NAME_DIGITS])
}

/// The painting of a material, over all palettes.
fn painting(catalog: &Catalog, material: &ModelMaterial, options: &LevelOptions) -> Painting {
    let has_textures = options.textures.size.is_some();
    let lacks_flat_normals = options.flat_normals == FlatNormals::Implied;
    match material {
        ModelMaterial::Slot(slot) => {
            let materials = catalog.palettes.values().filter_map(|palette| palette.materials.get(slot));
            let surfaces: Vec<&str> = materials.filter_map(|material| material.texture).collect();
            Painting {
                has_coordinates: has_textures && !surfaces.is_empty(),
                has_tangents: has_textures && surfaces.into_iter().any(has_relief),
                normal_set: 0,
                lacks_flat_normals,
            }
        }
        ModelMaterial::Swatches(_) => {
            Painting { has_coordinates: true, lacks_flat_normals, ..Painting::default() }
        }
        ModelMaterial::Own(own) => {
            let normal = own.textures.iter().find(|(purpose, _)| *purpose == TextureUse::Normal);
            Painting {
                has_coordinates: !own.textures.is_empty(),
                has_tangents: normal.is_some(),
                normal_set: normal.map_or(0, |(_, texture)| texture.coordinate_set),
                lacks_flat_normals,
            }
        }
    }
}
