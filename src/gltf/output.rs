//! glTF as a format of the table: one binary file, or JSON with a binary file beside it.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::library::{SharedLibrary, SharedModel};
use super::models::EncodedModels;
use super::options::WriteOptions;
use super::shared::GeometryLibrary;
use super::{GltfError, write_glb_with, write_gltf_with};
use crate::catalog::Catalog;
use crate::output::{
    LevelOptions, LevelToWrite, Output, OutputFormat, SharedFile, TooLarge, WrittenLevel, shared_images,
};

/// One binary file per level.
pub(crate) const GLB: OutputFormat = OutputFormat {
    name: "glb",
    about: "One binary file per level",
    extensions: &["glb"],
    shows_textures: true,
    shares_all_images: false,
    has_index: false,
    is_read_back: true,
    begin: |catalog, options| Box::new(GltfOutput::new(catalog, options, Container::Binary)),
};

/// A `.gltf` in JSON and a `.bin` beside it.
pub(crate) const GLTF: OutputFormat = OutputFormat {
    name: "gltf",
    about: "A JSON file and a binary one beside it",
    extensions: &["gltf", "bin"],
    shows_textures: true,
    shares_all_images: false,
    has_index: false,
    is_read_back: true,
    begin: |catalog, options| Box::new(GltfOutput::new(catalog, options, Container::Json)),
};

/// The container of the arrays.
#[derive(Clone, Copy)]
enum Container {
    Binary,
    Json,
}

/// glTF in a run.
struct GltfOutput<'a> {
    options: &'a LevelOptions,
    container: Container,
    /// Catalogue models that other levels have encoded.
    encoded: EncodedModels,
    /// None where each level carries its models.
    library: Option<GeometryLibrary>,
}

impl<'a> GltfOutput<'a> {
    fn new(catalog: &'a Catalog, options: &'a LevelOptions, container: Container) -> Self {
        let library = options.has_shared_library.then(|| GeometryLibrary::new(catalog, options));
        Self { options, container, encoded: EncodedModels::default(), library }
    }
}

impl Output for GltfOutput<'_> {
    fn level<'s>(&'s self, level: &LevelToWrite<'s>) -> Result<WrittenLevel<'s>, TooLarge> {
        let library = self.library.as_ref().map(|library| library.of_scene(level.scene));
        let options = WriteOptions {
            library: library.as_ref(),
            models: Some(&self.encoded),
            flat_normals: self.options.flat_normals,
        };
        let files = match self.container {
            Container::Binary => {
                let bytes = write_glb_with(level.scene, options).map_err(|error| too_large(&error))?;
                vec![("glb", bytes)]
            }
            Container::Json => {
                let name = level.path.rsplit('/').next().unwrap_or(level.path);
                let (json, bytes) = write_gltf_with(level.scene, &format!("{name}.bin"), options);
                let bin = (!bytes.is_empty()).then_some(("bin", bytes));
                [("gltf", json)].into_iter().chain(bin).collect()
            }
        };
        let mut shared = shared_models(library.unwrap_or_default(), level.folder());
        shared.extend(shared_images(level.scene.textures(), level.folder()));
        Ok(WrittenLevel { files, shared })
    }
}

fn too_large(error: &GltfError) -> TooLarge {
    TooLarge { message: error.to_string(), hint: "use --format gltf, or split the level" }
}

/// The models that a level refers to, sorted by path.
fn shared_models<'a>(library: SharedLibrary, folder: &str) -> Vec<SharedFile<'a>> {
    let files = library.into_values().map(|model| (format!("{folder}/{}", model.path()), model));
    let by_path: BTreeMap<String, Arc<SharedModel>> = files.collect();
    let file = |(path, model): (String, Arc<SharedModel>)| SharedFile {
        path,
        content: Box::new(move || model.bytes()),
    };
    by_path.into_iter().map(file).collect()
}
