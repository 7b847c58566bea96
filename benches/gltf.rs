//! Benchmark of writing a hotel level with one thread, compared with copying the same bytes once.
#![allow(clippy::print_stderr, reason = "what was measured is said beside the result")]

mod floor;

use std::sync::Arc;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use roomwright::internals::gltf::{
    EncodedModels, Painting, SharedLibrary, SharedModel, WriteOptions, write_glb, write_glb_with, write_gltf,
};
use roomwright::internals::scene::build_scene;

fn gltf(criterion: &mut Criterion) {
    let floor = floor::Floor::hotel();
    let scene = floor.with_input(build_scene);
    let bytes = write_glb(&scene).expect("a floor is small");
    let shared = scene.meshes.iter().filter_map(|mesh| Some((mesh.key.clone()?, mesh.model.as_ref())));
    let file = |number: usize| format!("shared/{number}.bin");
    let made = |(number, (key, model))| {
        (key, Arc::new(SharedModel::new(model, |_| Painting::default(), |_| file(number))))
    };
    let library: SharedLibrary = shared.enumerate().map(made).collect();
    let options = WriteOptions { library: Some(&library), ..WriteOptions::default() };
    let sharing = write_glb_with(&scene, options).expect("a floor is small");
    let beside: usize = library.values().map(|model| model.bytes().len()).sum();
    eprintln!("{} bytes, {} with {beside} in shared files", bytes.len(), sharing.len());
    let mut group = criterion.benchmark_group("gltf");
    group.throughput(Throughput::Bytes(bytes.len() as u64));
    group.bench_function("hotel floor/glb", |bencher| bencher.iter(|| write_glb(&scene)));
    let models = EncodedModels::default();
    let known = WriteOptions { models: Some(&models), ..WriteOptions::default() };
    group.bench_function("hotel floor/glb of models that are known", |bencher| {
        bencher.iter(|| write_glb_with(&scene, known));
    });
    group.bench_function("hotel floor/gltf", |bencher| bencher.iter(|| write_gltf(&scene, "floor.bin")));
    group.bench_function("hotel floor/copy", |bencher| bencher.iter(|| bytes.clone()));
    group.throughput(Throughput::Bytes(sharing.len() as u64));
    group.bench_function("hotel floor/glb with library", |bencher| {
        bencher.iter(|| write_glb_with(&scene, options));
    });
    group.finish();
}

criterion_group!(benches, gltf);
criterion_main!(benches);
