//! The input of a scene: level, furniture, catalogue, models and textures.

use std::sync::Arc;

use super::options::SceneOptions;
use crate::audit::Verdict;
use crate::catalog::{Catalog, ClassIndex};
use crate::layout::Furnished;
use crate::model::{Model, SwatchedModels};
use crate::plan::{Level, SitePlacement};
use crate::recipes::GeometrySet;
use crate::texture::TextureLibrary;

/// Builds and looks up models: class, variant, geometry set.
pub type ModelSourceFunction<'a> = dyn Fn(ClassIndex, u32, GeometrySet) -> Arc<Model> + Sync + 'a;

/// The input of a scene.
#[derive(Clone, Copy)]
pub struct SceneInput<'a> {
    /// The level.
    pub level: &'a Level,
    /// Id of its building.
    pub building: &'a str,
    /// Where the building stands; recorded, not applied.
    pub site: SitePlacement,
    /// One per room, in the order of the level's rooms.
    pub furnished: &'a [Furnished],
    /// The verdicts of the audit, in the same order; rooms past the end count as empty.
    pub verdicts: &'a [Verdict],
    /// Classes, room types, styles and palettes.
    pub catalog: &'a Catalog,
    /// The model of a class, variant and geometry set; the same one for the same arguments.
    pub models: &'a ModelSourceFunction<'a>,
    /// The textures of the materials; none for plain colours.
    pub textures: Option<&'a TextureLibrary>,
    /// Models whose plain parts share a material; none where every slot keeps its own material, as it must without textures.
    pub swatches: Option<&'a SwatchedModels>,
    /// Options.
    pub options: SceneOptions,
    /// Seed of the run.
    pub seed: u64,
}
