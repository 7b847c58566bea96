//! Triangles of catalogue models in a file that many levels share.

use std::collections::BTreeMap;

use super::encode::{Painting, encode};
use super::pack::{PackedPrimitive, Packer};
use crate::model::{Model, ModelMaterial};
use crate::scene::ModelKey;

/// The triangles of all models that a run may use.
#[derive(Clone, Debug, Default)]
pub struct SharedLibrary {
    pub(crate) packer: Packer,
    pub(crate) models: BTreeMap<ModelKey, Vec<PackedPrimitive>>,
}

/// A library as a level refers to it.
#[derive(Clone, Copy, Debug)]
pub struct LibraryReference<'a> {
    /// The triangles.
    pub library: &'a SharedLibrary,
    /// Path of its file relative to the level's file, with `/` between folders.
    pub path: &'a str,
}

impl SharedLibrary {
    /// Lays the models out in the order of their keys, whatever the order in which they come; of equal keys
    /// the first counts. Keys that share one model share its bytes. Of each primitive it holds
    /// what the painting of its material asks for in any level.
    pub fn new<'m>(
        models: impl IntoIterator<Item = (ModelKey, &'m Model)>,
        painting: impl Fn(&ModelMaterial) -> Painting,
    ) -> Self {
        let mut sorted: BTreeMap<ModelKey, &Model> = BTreeMap::new();
        for (key, model) in models {
            sorted.entry(key).or_insert(model);
        }
        let mut packer = Packer::default();
        let mut known: BTreeMap<*const Model, Vec<PackedPrimitive>> = BTreeMap::new();
        let mut packed = BTreeMap::new();
        for (key, model) in sorted {
            let primitives = known.entry(std::ptr::from_ref(model)).or_insert_with(|| {
                packer.model(&encode(model, |index| painting(&model.primitives[index].material)))
            });
            packed.insert(key, primitives.clone());
        }
        Self { packer, models: packed }
    }

    /// The bytes of the library's file.
    #[must_use]
    pub fn bytes(&self) -> Vec<u8> {
        let mut bytes = Vec::with_capacity(self.packer.byte_count());
        self.packer.append_to(&mut bytes);
        bytes
    }
}
