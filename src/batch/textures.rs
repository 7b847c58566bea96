//! The textures of a run, inside each floor or beside it.

use std::collections::BTreeSet;

use crate::cache::Cache;
use crate::scene::{Scene, SceneMaterial};
use crate::texture::{TextureLibrary, TextureLocation};

use super::TEXTURE_FOLDER;
use super::fault::OutputFault;
use super::folder::OutputFolder;
use super::options::TextureOptions;
use super::shared::SharedFiles;

/// The textures of a run, painted when a level first shows them.
pub(crate) struct Textures {
    /// What materials look them up in.
    pub(crate) library: TextureLibrary,
}

impl Textures {
    /// Nothing is painted yet; `None` where materials stay plain.
    pub(crate) fn new(options: TextureOptions, cache: Option<Cache>) -> Option<Self> {
        let location = match options.are_shared {
            true => TextureLocation::Beside(TEXTURE_FOLDER.to_owned()),
            false => TextureLocation::Embedded,
        };
        let library = TextureLibrary::new(options.size?, location).with_cache(cache);
        Some(Self { library })
    }
}

/// Puts the shared images that a scene shows into place in its building's folder, and gives their paths in the output
/// folder, sorted.
///
/// # Errors
/// If a file cannot be written.
pub(crate) fn put_images(
    scene: &Scene,
    building: &str,
    (shared, folder): (&SharedFiles, &OutputFolder),
) -> Result<Vec<String>, OutputFault> {
    let textures = scene.materials.iter().flat_map(SceneMaterial::textures);
    let mut paths = BTreeSet::new();
    for image in textures.map(|(_, texture)| &texture.image) {
        let Some(uri) = &image.uri else { continue };
        let path = format!("{building}/{uri}");
        if !paths.contains(&path) {
            shared.put(&path, || image.bytes.clone(), folder)?;
            paths.insert(path);
        }
    }
    Ok(paths.into_iter().collect())
}
