//! Benchmark of rooms on demand: opens a city of 102,500 rooms, looks around in it, furnishes single rooms, and walks.
#![allow(clippy::print_stderr)] // the bench also says how the walk was

use std::path::Path;
use std::sync::Arc;

use criterion::{Criterion, criterion_group, criterion_main};
use roomwright::building::Point;
use roomwright::internals::world::{Pace, WalkPath, walk};
use roomwright::options::DEFAULT_REACH;
use roomwright::{Budget, Eye, LevelOptions, Project, World};

fn project(name: &str) -> Arc<Project> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("configs").join(name);
    Arc::new(Project::read(&[path].into_iter().collect()).expect("the configuration comes with the project"))
}

fn pace(speed: f64) -> Pace {
    Pace { speed, field_of_view: 1.57, reach: DEFAULT_REACH, threads: 1, budget: Budget::default() }
}

fn bench(criterion: &mut Criterion) {
    let city = project("city.yaml");
    let options = LevelOptions::default();
    let mut group = criterion.benchmark_group("world");
    group.sample_size(20);
    group.bench_function("open a city of 102,500 rooms", |bencher| {
        bencher.iter(|| World::open(Arc::clone(&city), options.clone()));
    });
    let mut world = World::open(Arc::clone(&city), options.clone());
    let mut x = 0.0;
    group.bench_function("look around while walking along a corridor", |bencher| {
        bencher.iter(|| {
            x = (x + 0.0233) % 79.0;
            let velocity = Point::new(1.4, 0.0);
            let eye = Eye { velocity, ..Eye::new("tower-050", "13", Point::new(x + 0.5, 7.6), Point::X) };
            world.update(&eye, Budget::default()).expect("the level is there")
        });
    });
    let mut building = 0;
    group.bench_function("furnish a hotel room, with its first look into a building", |bencher| {
        bencher.iter(|| {
            building = building % 100 + 1;
            let mut world = World::open(Arc::clone(&city), options.clone());
            let id = format!("tower-{building:03}");
            let eye = Eye::new(&id, "7", Point::new(3.0, 12.0), Point::X);
            world.update(&eye, Budget::default()).expect("the level is there");
            assert!(world.step());
        });
    });
    group.finish();
    for (name, metres) in [("city.yaml", 500.0), ("plans/hotel.yaml", 500.0)] {
        let project = project(name);
        let path = WalkPath::random(&project.plan, &project.catalog, 1, metres).expect("rooms have doors");
        let mut world = World::open(project, options.clone());
        let report = walk(&mut world, &path, &pace(1.4)).expect("the path is one of the plan");
        let (needed, latency) = (report.needed, report.latency_ms);
        eprintln!(
            "{name}: {:.0} m, {needed} rooms needed, there after {:.2} ms (p99), {:.2} ms at most; {} popped up",
            path.metres(),
            latency.p99,
            latency.max,
            report.popped,
        );
    }
}

criterion_group!(benches, bench);
criterion_main!(benches);
