//! Benchmarks of whole bakes: a house in memory, into a folder, and again without changes.

use std::path::Path;

use criterion::{Criterion, criterion_group, criterion_main};
use roomwright::internals::batch::{BakeInput, BakeOptions, OutputFolder, bake};
use roomwright::internals::catalog::{Catalog, load_catalog};
use roomwright::internals::edits::EditBook;
use roomwright::internals::gltf::write_glb;
use roomwright::internals::layout::{FurnishOptions, furnish};
use roomwright::internals::model::ModelLibrary;
use roomwright::internals::output::LevelOptions;
use roomwright::internals::plan::{Level, PlacedBuilding, Plan, PlanOptions, read_plans};
use roomwright::internals::scene::{SceneInput, SceneOptions, build_scene};
use roomwright::internals::solve::judge_room;

/// Seed of all rooms.
const SEED: u64 = 1;

fn house(catalog: &Catalog) -> Plan {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("configs/plans/house.yaml");
    read_plans(&[path], &PlanOptions::new(&catalog.room_words)).plan
}

/// The stages of one level, without batch: rooms, judgement, scene, bytes.
fn level_bytes(placed: &PlacedBuilding, level: &Level, catalog: &Catalog, models: &ModelLibrary) -> usize {
    let options = FurnishOptions::new(SEED, &placed.id);
    let furnished: Vec<_> =
        (0..level.rooms.len()).map(|room| furnish(level.room(room), catalog, &options)).collect();
    let verdicts: Vec<_> =
        furnished.iter().map(|room| judge_room(level.room(room.room), room, catalog)).collect();
    let scene = build_scene(&SceneInput {
        style: None,
        level,
        building: &placed.id,
        attribution: None,
        site: placed.site,
        furnished: &furnished,
        verdicts: &verdicts,
        catalog,
        models: &|of, geometry| models.model(of, geometry),
        textures: None,
        swatches: None,
        options: SceneOptions::default(),
        seed: SEED,
    });
    write_glb(&scene).expect("a house fits into a file").len()
}

fn in_memory(criterion: &mut Criterion) {
    let catalog = load_catalog(&[]).expect("the built-in catalogue is valid").value;
    let models = ModelLibrary::load(&catalog).expect("the built-in models are valid");
    let plan = house(&catalog);
    criterion.bench_function("bake/house in memory", |bencher| {
        bencher.iter(|| {
            let levels = plan
                .buildings
                .iter()
                .flat_map(|placed| placed.building.levels.iter().map(move |level| (placed, level)));
            levels.map(|(placed, level)| level_bytes(placed, level, &catalog, &models)).sum::<usize>()
        });
    });
}

fn to_a_folder(criterion: &mut Criterion) {
    let catalog = load_catalog(&[]).expect("the built-in catalogue is valid").value;
    let models = ModelLibrary::load(&catalog).expect("the built-in models are valid");
    let plan = house(&catalog);
    let options = BakeOptions {
        level: LevelOptions { seed: SEED, ..LevelOptions::default() },
        ..BakeOptions::default()
    };
    let input = BakeInput {
        plan: &plan,
        edits: &EditBook::default(),
        catalog: &catalog,
        models: &models,
        options: &options,
    };
    let run = |folder: &Path| {
        let folder = OutputFolder::open(folder, false).expect("a temporary folder can be written");
        bake(&input, &folder, &|_| {}).expect("threads can be started").in_place.placed
    };
    let folder = || tempfile::tempdir().expect("a temporary folder can be created");
    criterion.bench_function("bake/house to a new folder", |bencher| {
        bencher.iter_with_large_drop(|| {
            let folder = folder();
            run(folder.path());
            folder
        });
    });
    let kept = folder();
    run(kept.path());
    criterion.bench_function("bake/house with nothing changed", |bencher| bencher.iter(|| run(kept.path())));
}

criterion_group!(benches, in_memory, to_a_folder);
criterion_main!(benches);
