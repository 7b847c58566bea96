//! Writes a scene as glTF bytes; never moves, rounds or drops a node.
//!
//! - [`write_glb`]: one file that holds everything;
//! - [`write_gltf`]: the same as text with a `.bin` beside it;
//! - both take [`WriteOptions`]. With a [`SharedLibrary`] among them, the triangles of catalogue models are in files of
//!   their own, one for each model, which all levels of a building refer to by relative paths. Their bytes depend on the
//!   model alone, so that levels can be written in any order and in parallel.
//!
//! A buffer is laid out in sections, one buffer view each: vectors (positions and normals), tangents, texture
//! coordinates, indices of one, two and four bytes; then images. Equal arrays are written once, with one accessor.
//! Corners of primitives without textures are joined where they agree.

mod array;
mod container;
mod document;
mod encode;
mod flatness;
mod join;
mod library;
mod light;
mod material;
mod mesh;
mod models;
mod node;
mod number;
mod options;
mod output;
mod pack;
mod shared;
mod tangent;
mod variant;
mod view;

use std::fmt;

pub(crate) use array::fingerprint;
pub(crate) use document::looks;
pub use encode::Painting;
pub use library::{SharedLibrary, SharedModel};
pub(crate) use light::{LIGHTS, light_list};
pub use models::EncodedModels;
pub(crate) use node::bare_nodes;
pub use options::{FlatNormals, WriteOptions};
pub(crate) use output::{GLB, GLTF};
pub(crate) use shared::GeometryLibrary;

use crate::scene::Scene;

/// Why a scene cannot be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum GltfError {
    /// The container counts its bytes in 32 bits.
    TooLarge(u64),
}

impl fmt::Display for GltfError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooLarge(bytes) => {
                write!(f, "the level needs {bytes} bytes, a .glb file holds 4294967295; write .gltf instead")
            }
        }
    }
}

impl std::error::Error for GltfError {}

/// A level as one binary file.
///
/// # Errors
/// [`GltfError::TooLarge`] for files of 4 GiB and more.
pub fn write_glb(scene: &Scene) -> Result<Vec<u8>, GltfError> {
    write_glb_with(scene, WriteOptions::default())
}

/// [`write_glb`] with options.
///
/// # Errors
/// [`GltfError::TooLarge`] for files of 4 GiB and more.
pub fn write_glb_with(scene: &Scene, options: WriteOptions<'_>) -> Result<Vec<u8>, GltfError> {
    let document = document::build(scene, None, options);
    let packer = &document.packer;
    container::write(&document.json(), packer.byte_count(), |file| packer.append_to(file))
}

/// A level as JSON and the bytes of the file beside it. `bin_name` is its path relative to the JSON; the
/// second part is empty, and not referred to, if the level has no triangles.
#[must_use]
pub fn write_gltf(scene: &Scene, bin_name: &str) -> (Vec<u8>, Vec<u8>) {
    write_gltf_with(scene, bin_name, WriteOptions::default())
}

/// [`write_gltf`] with options.
#[must_use]
pub fn write_gltf_with(scene: &Scene, bin_name: &str, options: WriteOptions<'_>) -> (Vec<u8>, Vec<u8>) {
    let document = document::build(scene, Some(bin_name), options);
    let mut bin = Vec::with_capacity(document.packer.byte_count());
    document.packer.append_to(&mut bin);
    (document.json(), bin)
}

/// A binary file of a document and a buffer, a multiple of four bytes long, for documents of other makers.
///
/// # Errors
/// [`GltfError::TooLarge`] for files of 4 GiB and more.
pub(crate) fn write_container(json: &[u8], buffer: &[u8]) -> Result<Vec<u8>, GltfError> {
    container::write(json, buffer.len(), |file| file.extend_from_slice(buffer))
}
