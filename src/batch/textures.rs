//! The textures of a run, inside each floor or beside it.

use crate::cache::Cache;
use crate::output::{SHARED_TEXTURES, TextureOptions};
use crate::texture::{TextureLibrary, TextureLocation};

/// The textures of a run, painted when a level first shows them.
pub(crate) struct Textures {
    /// What materials look them up in.
    pub(crate) library: TextureLibrary,
}

impl Textures {
    /// Nothing is painted yet; `None` where materials stay plain.
    pub(crate) fn new(options: TextureOptions, cache: Option<Cache>) -> Option<Self> {
        let location = match options.are_shared {
            true => TextureLocation::Beside(SHARED_TEXTURES.to_owned()),
            false => TextureLocation::Embedded,
        };
        let library = TextureLibrary::new(options.size?, location).with_cache(cache);
        Some(Self { library })
    }
}
