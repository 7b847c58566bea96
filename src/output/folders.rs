//! Folders of files that several levels refer to.

/// The first of the files over all levels, at the top of the output folder.
pub(crate) const INDEX_NAME: &str = "tileset.json";
/// How the paths of the others begin.
pub(crate) const INDEX_FOLDER: &str = "tileset/";
/// The folder of geometry that levels share, beside them.
pub(crate) const SHARED_GEOMETRY: &str = "shared-geometry";
/// The folder of textures that levels share, beside them.
pub(crate) const SHARED_TEXTURES: &str = "shared-textures";
