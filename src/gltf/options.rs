//! Options for writing levels.

use serde::Serialize;

use super::library::SharedLibrary;
use super::models::EncodedModels;

/// Options for writing levels; the default writes a level that stands alone, with all normals.
#[derive(Clone, Copy, Debug, Default)]
pub struct WriteOptions<'a> {
    /// The models whose triangles are in files of their own; those of all others are in the level itself.
    pub library: Option<&'a SharedLibrary>,
    /// Models that other levels of the run have encoded. Does not change the output; saves time.
    pub models: Option<&'a EncodedModels>,
    /// Whether flat faces have normals.
    pub flat_normals: FlatNormals,
}

/// Whether primitives of flat faces without textures have normals.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub enum FlatNormals {
    /// They have.
    #[default]
    Written,
    /// They have none: viewers compute them (glTF 2.0, section 3.7.2.1), and faces share corners.
    Implied,
}
