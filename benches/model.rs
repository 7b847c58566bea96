//! How long models take to build: all recipes, in each geometry set.

use criterion::{Criterion, criterion_group, criterion_main};
use roomwright::model::{RecipeInput, build_recipe, geometry_sets, recipe_names, recipe_size};
use std::hint::black_box;

fn build_all(geometry: &str) -> usize {
    let build = |name: &&str| {
        let size = recipe_size(name)?;
        build_recipe(name, &RecipeInput { size, look: 0, geometry, parameters: &[] })
    };
    recipe_names().iter().filter_map(build).map(|model| model.primitives.len()).sum()
}

fn models(criterion: &mut Criterion) {
    for &set in geometry_sets() {
        criterion.bench_function(&format!("all recipes, {set}"), |bencher| {
            bencher.iter(|| black_box(build_all(set)))
        });
    }
}

criterion_group!(benches, models);
criterion_main!(benches);
