//! The data that all levels of a run share.

use super::event::Stopwatch;
use super::folder::OutputFolder;
use super::options::BakeOptions;
use super::shared::SharedFiles;
use crate::catalog::Catalog;
use crate::model::{ModelLibrary, SwatchedModels};
use crate::output::Output;
use crate::texture::TextureLibrary;

/// The data that all levels of a run share.
pub(crate) struct Context<'a> {
    pub(crate) catalog: &'a Catalog,
    pub(crate) options: &'a BakeOptions,
    pub(crate) folder: &'a OutputFolder,
    pub(crate) models: &'a ModelLibrary,
    /// Models whose plain parts share a material; none where every slot keeps its material.
    pub(crate) swatched: Option<SwatchedModels>,
    /// The output format in this run.
    pub(crate) output: Box<dyn Output + 'a>,
    pub(crate) textures: Option<TextureLibrary>,
    pub(crate) shared: SharedFiles,
    pub(crate) watch: Stopwatch,
}
