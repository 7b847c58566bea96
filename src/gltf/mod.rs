//! Scene to bytes; never moves, rounds or drops a node.
//!
//! - [`write_glb`]: one file that holds everything;
//! - [`write_gltf`]: the same as text with a `.bin` beside it;
//! - either with a [`LibraryReference`]: the triangles of catalogue models stay in a [`SharedLibrary`] file
//!   that all levels of a run refer to by relative path. Its bytes are fixed before the first level is
//!   written, from the models alone, so that levels can be written in any order and in parallel.
//!
//! A buffer is laid out in sections, one buffer view each: vectors (positions and normals), tangents, texture
//! coordinates, short indices, long indices; then images.

mod container;
mod document;
mod library;
mod light;
mod material;
mod mesh;
mod pack;
mod tangent;
mod variant;
mod view;

use std::fmt;

pub use library::{LibraryReference, SharedLibrary};
pub use pack::Painting;

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
    glb(scene, None)
}

/// A level as one binary file, whose catalogue models stand in a shared library.
///
/// # Errors
/// [`GltfError::TooLarge`] for files of 4 GiB and more.
pub fn write_glb_with_library(scene: &Scene, library: LibraryReference<'_>) -> Result<Vec<u8>, GltfError> {
    glb(scene, Some(library))
}

/// A level as JSON and the bytes of the file beside it. `bin_name` is its path relative to the JSON; the
/// second part is empty, and not referred to, if the level has no triangles.
#[must_use]
pub fn write_gltf(scene: &Scene, bin_name: &str) -> (Vec<u8>, Vec<u8>) {
    gltf(scene, bin_name, None)
}

/// [`write_gltf`] with the catalogue models in a shared library.
#[must_use]
pub fn write_gltf_with_library(
    scene: &Scene,
    bin_name: &str,
    library: LibraryReference<'_>,
) -> (Vec<u8>, Vec<u8>) {
    gltf(scene, bin_name, Some(library))
}

fn glb(scene: &Scene, library: Option<LibraryReference<'_>>) -> Result<Vec<u8>, GltfError> {
    let document = document::build(scene, None, library);
    container::write(&document.json(), &document.packer)
}

fn gltf(scene: &Scene, bin_name: &str, library: Option<LibraryReference<'_>>) -> (Vec<u8>, Vec<u8>) {
    let document = document::build(scene, Some(bin_name), library);
    let mut bin = Vec::with_capacity(document.packer.byte_count());
    document.packer.append_to(&mut bin);
    (document.json(), bin)
}
