//! Benchmark of the scene of a hotel level: 40 rooms and a corridor, about 25 objects a room, one thread.
#![allow(clippy::print_stderr, reason = "what was measured is said beside the result")]

mod floor;

use criterion::{Criterion, criterion_group, criterion_main};
use roomwright::internals::scene::build_scene;

fn scene(criterion: &mut Criterion) {
    let floor = floor::Floor::hotel();
    floor.with_input(|input| {
        criterion.bench_function("scene/hotel floor", |bencher| bencher.iter(|| build_scene(input)));
    });
}

criterion_group!(benches, scene);
criterion_main!(benches);
