//! The input of a scene: level, furniture, catalogue, models and textures.

use std::sync::Arc;

use super::options::SceneOptions;
use crate::audit::Verdict;
use crate::catalog::{Catalog, StyleRef, VariantRef};
use crate::layout::{FurnishOptions, Furnished, room_style};
use crate::model::{Model, SwatchedModels};
use crate::plan::{Level, Opening, SitePlacement};
use crate::recipes::GeometrySet;
use crate::texture::TextureLibrary;

/// Builds and looks up models.
pub type ModelSourceFunction<'a> = dyn Fn(VariantRef, GeometrySet) -> Arc<Model> + Sync + 'a;

/// The input of a scene.
#[derive(Clone, Copy)]
pub struct SceneInput<'a> {
    /// The level.
    pub level: &'a Level,
    /// Id of its building.
    pub building: &'a str,
    /// The text by which the source of its plan asks to be named.
    pub attribution: Option<&'a str>,
    /// Where the building stands; recorded, not applied.
    pub site: SitePlacement,
    /// The rooms to show, in the order of the level's rooms; all of a level's, or some.
    pub furnished: &'a [Furnished],
    /// The verdicts of the audit, in the same order; rooms past the end count as empty.
    pub verdicts: &'a [Verdict],
    /// Classes, room types, styles and palettes.
    pub catalog: &'a Catalog,
    /// The model of a variant in a geometry set; the same one for the same arguments.
    pub models: &'a ModelSourceFunction<'a>,
    /// The textures of the materials; none for plain colours.
    pub textures: Option<&'a TextureLibrary>,
    /// Models whose plain parts share a material; none where every slot keeps its own material, as it must without textures.
    pub swatches: Option<&'a SwatchedModels>,
    /// Options.
    pub options: SceneOptions,
    /// Seed of the run.
    pub seed: u64,
    /// Style of the run: a door looks like the first room that it joins, also where that one is not shown.
    pub style: Option<&'a str>,
}

impl<'a> SceneInput<'a> {
    /// Whether an opening is one of the rooms to show; all are where all rooms are shown.
    pub(crate) fn shows(&self, opening: &Opening) -> bool {
        let is_shown = |room: usize| self.furnished_room(room).is_some();
        self.furnished.len() == self.level.rooms.len() || opening.sides.iter().any(|side| is_shown(side.room))
    }

    /// The style of a room, furnished or not.
    pub(crate) fn style_of(&self, room: usize) -> StyleRef {
        let undrawn = || {
            let options = FurnishOptions::new(self.seed, self.building).with_style(self.style);
            room_style(self.level.room(room), self.catalog, &options)
        };
        self.furnished_room(room).map_or_else(undrawn, |furnished| furnished.style)
    }

    fn furnished_room(&self, room: usize) -> Option<&'a Furnished> {
        let index = self.furnished.binary_search_by_key(&room, |furnished| furnished.room);
        index.ok().map(|index| &self.furnished[index])
    }
}
