//! Textures and shared materials of levels, as far as their format shows them.

use super::folders::SHARED_TEXTURES;
use super::options::{LevelOptions, TextureOptions};
use super::table::output_format;
use crate::cache::Cache;
use crate::catalog::Catalog;
use crate::model::SwatchedModels;
use crate::scene::Parts;
use crate::texture::{TextureLibrary, TextureLocation};

impl LevelOptions {
    /// The textures, generated when a level first shows them; none where materials stay plain.
    pub(crate) fn texture_library(&self, cache: Option<Cache>) -> Option<TextureLibrary> {
        let TextureOptions { size, are_shared } = self.textures;
        let format = output_format(self.format);
        let location = match (format.shares_all_images, are_shared) {
            (true, _) => TextureLocation::Beside(format!("../{SHARED_TEXTURES}")),
            (false, true) => TextureLocation::Beside(SHARED_TEXTURES.to_owned()),
            (false, false) => TextureLocation::Embedded,
        };
        let size = size.filter(|_| format.shows_textures)?;
        Some(TextureLibrary::new(size, location).with_cache(cache))
    }

    /// The models whose plain parts share a material with a small image of all their colours; none where every slot keeps its
    /// own material, as it must without textures.
    pub(crate) fn swatches(&self, catalog: &Catalog) -> Option<SwatchedModels> {
        let has_textures = self.textures.size.is_some() && output_format(self.format).shows_textures;
        (self.scene.parts == Parts::Merged && has_textures).then(|| SwatchedModels::new(catalog))
    }
}
