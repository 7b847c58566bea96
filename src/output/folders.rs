//! Folders of files that several levels refer to.

/// The folder of geometry that levels share, beside them.
pub(crate) const SHARED_GEOMETRY: &str = "shared-geometry";
/// The folder of textures that levels share, beside them.
pub(crate) const SHARED_TEXTURES: &str = "shared-textures";
