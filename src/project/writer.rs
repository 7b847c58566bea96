//! Furnishes one room of a project, and writes it without the other rooms of its level.

use super::read::Project;
use crate::audit::Verdict;
use crate::cache::Cache;
use crate::catalog::Catalog;
use crate::dwelling::Occupancy;
use crate::edits::{Finished, furnish_edited};
use crate::gltf::{EncodedModels, GeometryLibrary, GltfError, SharedLibrary, WriteOptions, write_glb_with};
use crate::layout::{FurnishOptions, Furnished};
use crate::model::SwatchedModels;
use crate::output::{LevelOptions, TextureOptions};
use crate::plan::{Level, PlacedBuilding, RoomRef};
use crate::scene::{Scene, SceneInput, build_scene};
use crate::texture::TextureLibrary;

impl Project {
    /// A building with people in it.
    pub(crate) fn occupied(&self, index: usize, seed: u64) -> PlacedBuilding {
        let placed = &self.plan.buildings[index];
        let people = Occupancy::new(&placed.building, &placed.id, &self.catalog.households, seed);
        PlacedBuilding { building: people.apply(&placed.building), ..placed.clone() }
    }

    /// Furnishes a room of an occupied building, applies its edits and judges it, as a bake does.
    pub(crate) fn furnish_room(&self, options: &LevelOptions, building: &str, at: RoomRef<'_>) -> Finished {
        let run = FurnishOptions::new(options.seed, building).with_style(options.style.as_deref());
        let edits = self.edits.level(building, &at.level.id);
        furnish_edited(at, &self.catalog, &run, options.effort, edits)
    }
}

/// Furnished rooms of a level, as they are written.
#[derive(Clone, Copy)]
pub(crate) struct RoomView<'a> {
    /// Their building, occupied.
    pub(crate) building: &'a PlacedBuilding,
    /// Their level in that building.
    pub(crate) level: &'a Level,
    /// Their furniture, in the order of the level; says which rooms they are.
    pub(crate) furnished: &'a [Furnished],
    /// The findings of the audit, in the same order.
    pub(crate) verdicts: &'a [Verdict],
}

/// Writes rooms, and keeps what they share: textures, models, encoded models.
pub(crate) struct RoomWriter {
    textures: Option<TextureLibrary>,
    swatches: Option<SwatchedModels>,
    encoded: EncodedModels,
    library: Option<GeometryLibrary>,
}

/// A room as a file, and the files that it refers to.
pub(crate) struct WrittenRoom {
    /// The binary glTF file.
    pub(crate) glb: Vec<u8>,
    /// The scene in it, with the images that lie beside it.
    pub(crate) scene: Scene,
    /// The models that lie beside it.
    pub(crate) models: SharedLibrary,
}

impl RoomWriter {
    /// For rooms that are one file each, with all images and models in it.
    pub(crate) fn alone(catalog: &Catalog, options: &LevelOptions) -> Self {
        let textures = TextureOptions { are_shared: false, ..options.textures };
        Self::new(catalog, &LevelOptions { textures, has_shared_library: false, ..options.clone() }, None)
    }

    /// For rooms that refer to shared images and models where the options say so. Textures are kept between runs in the cache.
    pub(crate) fn new(catalog: &Catalog, options: &LevelOptions, cache: Option<Cache>) -> Self {
        Self {
            textures: options.texture_library(cache),
            swatches: options.swatches(catalog),
            encoded: EncodedModels::default(),
            library: options.has_shared_library.then(|| GeometryLibrary::new(catalog, options)),
        }
    }

    /// The tree of nodes of rooms: their level, their openings, their shells and furniture, with the names that they have in the
    /// file of the level.
    pub(crate) fn scene(&self, project: &Project, options: &LevelOptions, room: &RoomView<'_>) -> Scene {
        let Project { catalog, models, .. } = project;
        let LevelOptions { detail, scene, seed, ref style, .. } = *options;
        build_scene(&SceneInput {
            level: room.level,
            building: &room.building.id,
            attribution: room.building.building.attribution.as_deref(),
            site: room.building.site,
            furnished: room.furnished,
            verdicts: room.verdicts,
            catalog,
            models: &|of, geometry| models.model_in_detail(of, geometry, detail),
            textures: self.textures.as_ref(),
            swatches: self.swatches.as_ref(),
            options: scene,
            seed,
            style: style.as_deref(),
        })
    }

    /// The room as one binary glTF file.
    ///
    /// # Errors
    /// If the file would have 4 GiB or more.
    pub(crate) fn glb(
        &self,
        project: &Project,
        options: &LevelOptions,
        room: &RoomView<'_>,
    ) -> Result<Vec<u8>, GltfError> {
        self.write(project, options, room).map(|written| written.glb)
    }

    /// The room as one binary glTF file, with what it refers to.
    ///
    /// # Errors
    /// If the file would have 4 GiB or more.
    pub(crate) fn write(
        &self,
        project: &Project,
        options: &LevelOptions,
        room: &RoomView<'_>,
    ) -> Result<WrittenRoom, GltfError> {
        let scene = self.scene(project, options, room);
        let models = self.library.as_ref().map(|library| library.of_scene(&scene));
        let written = WriteOptions {
            library: models.as_ref(),
            models: Some(&self.encoded),
            flat_normals: options.flat_normals,
        };
        let glb = write_glb_with(&scene, written)?;
        Ok(WrittenRoom { glb, scene, models: models.unwrap_or_default() })
    }
}
