//! Benchmark of the layout of the paper's two rooms (its section 5), with one thread, room by room over many seeds.
#![allow(clippy::print_stderr)] // the bench also says how many objects rest

use std::path::Path;

use criterion::{Criterion, criterion_group, criterion_main};
use roomwright::internals::catalog::{Catalog, load_catalog};
use roomwright::internals::layout::{FurnishOptions, furnish};
use roomwright::internals::plan::{Level, PlanOptions, read_plans};

/// Seeds that one measurement goes through, so that no lucky room stands for all.
const SEEDS: u64 = 64;

fn level(name: &str, catalog: &Catalog) -> Level {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("configs/paper").join(name);
    let reading = read_plans(&[path], &PlanOptions::new(&catalog.room_words));
    reading.plan.buildings[0].building.levels[0].clone()
}

fn placed(level: &Level, catalog: &Catalog, seed: u64) -> usize {
    furnish(level.room(0), catalog, &FurnishOptions::new(seed, "bench")).placements.len()
}

fn layout(criterion: &mut Criterion) {
    let catalog = load_catalog(&[]).expect("the built-in catalogue is valid").value;
    let mut group = criterion.benchmark_group("layout");
    for name in ["office.yaml", "restaurant.yaml", "library.yaml", "lobby.yaml"] {
        let level = level(name, &catalog);
        let total: usize = (0..SEEDS).map(|seed| placed(&level, &catalog, seed)).sum();
        eprintln!("{name}: {:.2} objects rest on average over {SEEDS} seeds", total as f64 / SEEDS as f64);
        let mut seed = 0;
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                seed = (seed + 1) % SEEDS;
                placed(&level, &catalog, seed)
            });
        });
    }
    group.finish();
}

criterion_group!(benches, layout);
criterion_main!(benches);
