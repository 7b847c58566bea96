//! What levels are written with.

use super::library::SharedLibrary;
use super::models::EncodedModels;

/// What levels are written with; the default writes a level that stands alone, with all normals.
#[derive(Clone, Copy, Debug, Default)]
pub struct WriteOptions<'a> {
    /// The models whose triangles are in files of their own; those of all others are in the level itself.
    pub library: Option<&'a SharedLibrary>,
    /// What other levels of the run made of catalogue models. Changes no byte; saves making it again.
    pub models: Option<&'a EncodedModels>,
    /// Whether flat faces have normals.
    pub flat_normals: FlatNormals,
}

/// Whether primitives of flat faces without textures have normals.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FlatNormals {
    /// They have.
    #[default]
    Written,
    /// They have none: viewers compute them (glTF 2.0, section 3.7.2.1), and faces share corners.
    Implied,
}
