//! Models in files that many levels share, one file for each model.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::encode::{Corners, Painting, encode};
use super::pack::{PackedPrimitive, Packer};
use crate::model::{Model, ModelMaterial};
use crate::scene::ModelKey;

/// The triangles of one model in a file of their own.
#[derive(Clone, Debug)]
pub struct SharedModel {
    pub(crate) packer: Packer,
    pub(crate) primitives: Vec<PackedPrimitive>,
    /// Path of the file relative to the level's file, with `/` between folders.
    pub(crate) path: String,
}

/// The shared models that a level refers to.
pub type SharedLibrary = BTreeMap<ModelKey, Arc<SharedModel>>;

impl SharedModel {
    /// Lays out a model with what the painting of its materials asks for in any level; `path` says where the file lies,
    /// seen from a level's file, once its bytes are known.
    pub fn new(
        model: &Model,
        painting: impl Fn(&ModelMaterial) -> Painting,
        path: impl FnOnce(&[u8]) -> String,
    ) -> Self {
        let mut packer = Packer::default();
        let painting = |index: usize| painting(&model.primitives[index].material);
        let primitives = packer.model(&encode(model, Corners::Joined, painting));
        let mut made = Self { packer, primitives, path: String::new() };
        made.path = path(&made.bytes());
        made
    }

    /// The bytes of the file.
    #[must_use]
    pub fn bytes(&self) -> Vec<u8> {
        let mut bytes = Vec::with_capacity(self.packer.byte_count());
        self.packer.append_to(&mut bytes);
        bytes
    }

    /// Where the file lies, seen from a level's file.
    #[must_use]
    pub fn path(&self) -> &str {
        &self.path
    }
}
