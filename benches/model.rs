//! Benchmark of building models: all recipes in each geometry set; every class, variant and set of the catalogue.

use criterion::{Criterion, criterion_group, criterion_main};
use roomwright::internals::catalog::{Catalog, Class, VariantRef, load_catalog};
use roomwright::internals::model::ModelLibrary;
use roomwright::internals::recipes::{GeometrySet, Recipe, RecipeInput, recipes};
use std::hint::black_box;

fn build_all(geometry: GeometrySet) -> usize {
    let build = |recipe: &&Recipe| {
        recipe.build(&RecipeInput { size: recipe.usual_size(), look: 0, geometry, parameters: &[] })
    };
    recipes().iter().map(build).map(|mesh| mesh.parts.len()).sum()
}

fn build_library(catalog: &Catalog) -> usize {
    let library = ModelLibrary::load(catalog).expect("the built-in models are sound");
    let variants = |(class, entry): (usize, &Class)| {
        (0..entry.variant_count()).map(move |variant| VariantRef::new(class, variant)).collect::<Vec<_>>()
    };
    let all = catalog.classes.iter().enumerate().flat_map(variants);
    let build = |of| GeometrySet::ALL.map(|set| (of, set));
    all.flat_map(build).map(|(of, set)| library.model(of, set).primitives.len()).sum()
}

fn models(criterion: &mut Criterion) {
    for set in GeometrySet::ALL {
        criterion.bench_function(&format!("all recipes, {set}"), |bencher| {
            bencher.iter(|| black_box(build_all(set)))
        });
    }
    let catalog = load_catalog(&[]).expect("the built-in configuration is sound").value;
    let mut group = criterion.benchmark_group("library");
    group.sample_size(10);
    group.bench_function("every class, variant and set", |bencher| {
        bencher.iter(|| black_box(build_library(&catalog)))
    });
    group.finish();
}

criterion_group!(benches, models);
criterion_main!(benches);
