//! The textures that floors share instead of each carrying a copy.

use std::collections::BTreeSet;
use std::sync::{Mutex, PoisonError};

use crate::cache::Cache;
use crate::model::Image;
use crate::scene::{Scene, SceneMaterial};
use crate::texture::{TextureLibrary, TextureLocation};

use super::TEXTURE_FOLDER;
use super::fault::OutputFault;
use super::files::with_record;
use super::folder::OutputFolder;
use super::job::TextureOptions;

/// The textures of a run, painted when a level first shows them.
pub(crate) struct Textures {
    /// What materials look them up in.
    pub(crate) library: TextureLibrary,
    /// Paths in the output folder of the images that are in place.
    placed: Mutex<BTreeSet<String>>,
}

impl Textures {
    /// Nothing is painted yet; `None` where materials stay plain.
    pub(crate) fn new(options: TextureOptions, cache: Option<Cache>) -> Option<Self> {
        let location = match options.are_embedded {
            true => TextureLocation::Embedded,
            false => TextureLocation::Beside(format!("../{TEXTURE_FOLDER}")),
        };
        let library = TextureLibrary::new(options.size?, location).with_cache(cache);
        Some(Self { library, placed: Mutex::default() })
    }

    /// Puts the shared images that a scene shows into place, unless they are, and gives their paths in the output folder,
    /// sorted. Their content depends on surface and size only, so that processes and shards agree on it.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub(crate) fn put_in_place(
        &self,
        scene: &Scene,
        folder: &OutputFolder,
    ) -> Result<Vec<String>, OutputFault> {
        let textures = scene.materials.iter().flat_map(SceneMaterial::textures);
        let mut paths = BTreeSet::new();
        for image in textures.map(|(_, texture)| &texture.image) {
            let Some(uri) = &image.uri else { continue };
            let path = uri.trim_start_matches("../");
            if paths.insert(path.to_owned()) {
                self.place(path, image, folder)?;
            }
        }
        Ok(paths.into_iter().collect())
    }

    fn place(&self, path: &str, image: &Image, folder: &OutputFolder) -> Result<(), OutputFault> {
        // Held while writing, so that no level is recorded before its images are there.
        let mut placed = self.placed.lock().unwrap_or_else(PoisonError::into_inner);
        if placed.contains(path) {
            return Ok(());
        }
        let (file, bytes) = with_record(path.to_owned(), image.bytes.clone());
        folder.announce(std::slice::from_ref(&file))?;
        folder.place(&file, &bytes)?;
        folder.record_library_file(&file)?;
        placed.insert(path.to_owned());
        Ok(())
    }
}
