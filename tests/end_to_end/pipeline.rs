//! Runs the stages one after the other, as the batch does, without files.

use std::path::PathBuf;

use roomwright::internals::audit::Verdict;
use roomwright::internals::best::{Judged, furnish_best};
use roomwright::internals::catalog::{Catalog, load_catalog};
use roomwright::internals::gltf::write_glb;
use roomwright::internals::layout::{FurnishOptions, Furnished};
use roomwright::internals::model::ModelLibrary;
use roomwright::internals::plan::{Level, Plan, PlanOptions, PlanReading, SitePlacement, read_plans};
use roomwright::internals::scene::{SceneInput, SceneOptions, build_scene};

/// Layouts per room at most: less than a bake's, for tests run without optimisation.
const EFFORT: u32 = 2;

/// What all levels of a run share.
pub struct Pipeline {
    /// The built-in catalogue.
    pub catalog: Catalog,
    /// The models of its classes.
    pub models: ModelLibrary,
    /// The seed of the run.
    pub seed: u64,
}

/// A level with everything that was made of it.
pub struct BakedLevel<'a> {
    /// Id of the building.
    pub building: &'a str,
    /// The level.
    pub level: &'a Level,
    /// By room.
    pub furnished: Vec<Furnished>,
    /// By room.
    pub verdicts: Vec<Verdict>,
    /// The file.
    pub glb: Vec<u8>,
}

impl Pipeline {
    /// The built-in catalogue with seed 1.
    pub fn new() -> Self {
        let catalog = load_catalog(&[]).unwrap().value;
        let models = ModelLibrary::load(&catalog).unwrap();
        Self { catalog, models, seed: 1 }
    }

    /// Reads plans of any format.
    pub fn read(&self, paths: &[PathBuf]) -> PlanReading {
        read_plans(paths, &PlanOptions::new(&self.catalog.room_words))
    }

    /// Furnishes, judges and writes one level.
    pub fn bake<'a>(&self, building: &'a str, level: &'a Level) -> BakedLevel<'a> {
        let options = FurnishOptions::new(self.seed, building);
        let rooms = 0..level.rooms.len();
        let best = |room| furnish_best(level.room(room), &self.catalog, &options, EFFORT);
        let judged = |judged: Judged| (judged.furnished, judged.verdict);
        let (furnished, verdicts): (Vec<_>, Vec<_>) = rooms.map(best).map(judged).unzip();
        let scene = build_scene(&SceneInput {
            style: None,
            level,
            building,
            attribution: None,
            site: SitePlacement::default(),
            furnished: &furnished,
            verdicts: &verdicts,
            catalog: &self.catalog,
            models: &|of, geometry| self.models.model(of, geometry),
            textures: None,
            swatches: None,
            options: SceneOptions::default(),
            seed: self.seed,
        });
        BakedLevel { building, level, furnished, verdicts, glb: write_glb(&scene).unwrap() }
    }
}

/// Calls `visit` with every level of a plan and the id of its building.
pub fn each_level(plan: &Plan, mut visit: impl FnMut(&str, &Level)) {
    for placed in &plan.buildings {
        for level in &placed.building.levels {
            visit(&placed.id, level);
        }
    }
}
