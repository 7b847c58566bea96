//! How long models take to build: all recipes, and the largest.

use criterion::{Criterion, criterion_group, criterion_main};
use roomwright::model::{PLAIN, RecipeInput, TRADITIONAL, build_recipe, recipe_names, recipe_size};
use std::hint::black_box;

fn build_all(geometry: &str) -> usize {
    let build = |name: &&str| {
        let size = recipe_size(name)?;
        build_recipe(name, &RecipeInput { size, look: 0, geometry, parameters: &[] })
    };
    recipe_names().iter().filter_map(build).map(|model| model.primitives.len()).sum()
}

fn models(criterion: &mut Criterion) {
    criterion.bench_function("all recipes, plain", |bencher| bencher.iter(|| black_box(build_all(PLAIN))));
    criterion.bench_function("all recipes, traditional", |bencher| {
        bencher.iter(|| black_box(build_all(TRADITIONAL)))
    });
}

criterion_group!(benches, models);
criterion_main!(benches);
