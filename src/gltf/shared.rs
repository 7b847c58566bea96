//! Models that the levels of a building share: one file for each model in use.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use super::encode::Painting;
use super::library::{SharedLibrary, SharedModel};
use super::options::FlatNormals;
use crate::catalog::Catalog;
use crate::disk::content_hash;
use crate::model::{Model, ModelMaterial, TextureUse};
use crate::output::{LevelOptions, SHARED_GEOMETRY};
use crate::recipes::Slot;
use crate::scene::{ModelKey, Scene};
use crate::texture::has_relief;

/// Digits of the content's hash in the name of a model's file.
const NAME_DIGITS: usize = 12;

/// The models of a run as floors share them, laid out when a level first shows them.
pub(crate) struct GeometryLibrary {
    paintings: Paintings,
    known: Mutex<SharedLibrary>,
}

impl GeometryLibrary {
    /// Nothing is laid out yet.
    pub(crate) fn new(catalog: &Catalog, options: &LevelOptions) -> Self {
        Self { paintings: Paintings::new(catalog, options), known: Mutex::default() }
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
        let painting = |material: &ModelMaterial| self.paintings.of(material);
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

/// The paintings of materials, over all palettes.
struct Paintings {
    slots: BTreeMap<Slot, Painting>,
    lacks_flat_normals: bool,
}

impl Paintings {
    fn new(catalog: &Catalog, options: &LevelOptions) -> Self {
        let has_textures = options.textures.size.is_some();
        let lacks_flat_normals = options.flat_normals == FlatNormals::Implied;
        let mut slots: BTreeMap<Slot, Painting> = BTreeMap::new();
        for (slot, material) in catalog.palettes.values().flat_map(|palette| &palette.materials) {
            let painting = slots.entry(*slot).or_default();
            painting.lacks_flat_normals = lacks_flat_normals;
            if let Some(surface) = material.texture.filter(|_| has_textures) {
                painting.has_coordinates = true;
                painting.has_tangents |= has_relief(surface);
            }
        }
        Self { slots, lacks_flat_normals }
    }

    fn of(&self, material: &ModelMaterial) -> Painting {
        let lacks_flat_normals = self.lacks_flat_normals;
        let plain = Painting { lacks_flat_normals, ..Painting::default() };
        match material {
            ModelMaterial::Slot(slot) => self.slots.get(slot).copied().unwrap_or(plain),
            ModelMaterial::Swatches(_) => Painting { has_coordinates: true, ..plain },
            ModelMaterial::Own(own) => {
                let normal = own.textures.iter().find(|(purpose, _)| *purpose == TextureUse::Normal);
                Painting {
                    has_coordinates: !own.textures.is_empty(),
                    has_tangents: normal.is_some(),
                    normal_set: normal.map_or(0, |(_, texture)| texture.coordinate_set),
                    ..plain
                }
            }
        }
    }
}
