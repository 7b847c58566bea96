//! Writes a scene as a binary glTF file of few draw calls, for clients that draw whole cities or run in browsers.
//!
//! A level as `gltf/` writes it has a node for every part, and viewers draw each primitive of each by itself. Here, what is the same
//! model is drawn as instances (`EXT_mesh_gpu_instancing`), and all else is merged, one primitive a material. Every corner or instance
//! has the number of its *feature*, the piece or part that it belongs to (`EXT_mesh_features`, `EXT_instance_features`), and a table
//! names the features (`EXT_structural_metadata`), so that a click on a triangle still names the chair. Numbers are quantised
//! (`KHR_mesh_quantization`).
//!
//! - `sieve`: what is large enough to be seen;
//! - `coarse` and `loose`: what is left of a shape, and which of its loose parts are boxes;
//! - `listing`: what is drawn, where, and which feature it is;
//! - `image_colors`: the colours of images, for files without;
//! - `grouping`: which meshes, and boxes of which colours, become instances;
//! - `cuboids`: boxes as instances of one cube;
//! - `lights`: which lamps give light;
//! - `merged` and `instances`: the triangles of both;
//! - `encode`: arrays of both;
//! - `buffer`, `table`, `document`: the file;
//! - `output`: the format of the table for browsers.
//!
//! What is drawn is where the scene has it, to half of [`CompactOptions::coarsest_step`].

mod buffer;
mod coarse;
mod cuboids;
mod document;
mod encode;
mod feature;
mod grouping;
mod image_colors;
mod instances;
mod lights;
mod listing;
mod loose;
mod merged;
mod options;
mod output;
mod sieve;
mod table;
#[cfg(test)]
mod tests;

pub use options::Instancing;
pub(crate) use options::{Coarse, Coloring, CompactOptions, Shapes};
pub(crate) use output::WEB;

use coarse::Seen;
use image_colors::KnownImages;
use instances::KnownModels;
use listing::Drawn;
use sieve::KnownSimplified;

use crate::gltf::GltfError;
use crate::scene::{Scene, SceneMaterial};

/// What is kept from file to file of a run. No byte depends on it.
#[derive(Debug, Default)]
pub(crate) struct Known {
    images: KnownImages,
    models: KnownModels,
    simplified: KnownSimplified,
}

/// What is shown of a scene.
#[derive(Clone, Copy)]
struct Shown<'s> {
    scene: &'s Scene,
    /// Its materials, or others in their place.
    materials: &'s [SceneMaterial],
    /// The models of its meshes as far as they are seen.
    models: &'s [Option<Seen>],
    coloring: Coloring,
    images: &'s KnownImages,
    models_known: &'s KnownModels,
}

/// A scene as one binary file. `materials` are those of the scene, or others in their place; `known` is kept from file to file.
///
/// # Errors
/// [`GltfError::TooLarge`] for files of 4 GiB and more.
pub(crate) fn write_compact(
    scene: &Scene,
    materials: &[SceneMaterial],
    known: &Known,
    options: &CompactOptions,
) -> Result<Vec<u8>, GltfError> {
    let Known { images, models: models_known, simplified } = known;
    let models = sieve::seen(scene, options, simplified);
    let coloring = options.coloring;
    let shown = Shown { scene, materials, models: &models, coloring, images, models_known };
    let listing = listing::Listing::new(&shown);
    let grouping = grouping::choose(&shown, &listing.drawn, options);
    let mut alike = Vec::new();
    let mut single = Vec::new();
    for drawn in &listing.drawn {
        match grouping.meshes.get(&drawn.mesh) {
            Some(&mesh) => alike.push(Drawn { mesh, ..*drawn }),
            None => single.push(drawn),
        }
    }
    let (cubes, rest) = cuboids::take(&shown, &single, &grouping.looks);
    let merged = merged::merge(&Shown { models: &rest, ..shown }, &single);
    let mut instances = instances::gather(&shown, &alike);
    instances.extend(cubes);
    document::write(&document::Parts { shown, options, features: &listing.features, merged, instances })
}
