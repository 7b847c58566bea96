//! The furnished level that two benchmarks use.

use std::path::Path;

use roomwright::internals::catalog::{Catalog, load_catalog};
use roomwright::internals::layout::{FurnishOptions, Furnished, furnish};
use roomwright::internals::model::ModelLibrary;
use roomwright::internals::plan::{Level, PlanOptions, SitePlacement, read_plans};
use roomwright::internals::scene::{SceneInput, SceneOptions};

/// A level with what its scene needs.
pub(crate) struct Floor {
    level: Level,
    furnished: Vec<Furnished>,
    catalog: Catalog,
    library: ModelLibrary,
}

/// Seed of the furniture.
const SEED: u64 = 1;

impl Floor {
    /// The second floor of the ready hotel tower.
    pub(crate) fn hotel() -> Self {
        let catalog = load_catalog(&[]).expect("the built-in catalogue is valid").value;
        let library = ModelLibrary::load(&catalog).expect("all recipes exist");
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("configs/plans/hotel-tower.yaml");
        let reading = read_plans(&[path], &PlanOptions::new(&catalog.room_words));
        let level = reading.plan.buildings[0].building.levels[1].clone();
        let options = FurnishOptions::new(SEED, "hotel");
        let rooms = 0..level.rooms.len();
        let furnished: Vec<Furnished> =
            rooms.map(|room| furnish(level.room(room), &catalog, &options)).collect();
        let objects: usize = furnished.iter().map(|room| room.placements.len()).sum();
        eprintln!("{} rooms, {objects} objects", furnished.len());
        Self { level, furnished, catalog, library }
    }

    /// Runs `use_it` with the scene's input.
    pub(crate) fn with_input<T>(&self, use_it: impl FnOnce(&SceneInput<'_>) -> T) -> T {
        let models = |of, geometry| self.library.model(of, geometry);
        use_it(&SceneInput {
            style: None,
            level: &self.level,
            building: "hotel",
            attribution: None,
            site: SitePlacement::default(),
            furnished: &self.furnished,
            verdicts: &[],
            catalog: &self.catalog,
            models: &models,
            textures: None,
            swatches: None,
            options: SceneOptions::default(),
            seed: SEED,
        })
    }
}
