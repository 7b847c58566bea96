//! Benchmark of plans: reads a map of outlines and plans the storeys of its buildings, or reads a home of Sweet Home 3D, with one
//! thread. All times are those of one building.
#![allow(clippy::print_stderr)] // the bench also says what is planned

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use criterion::{Criterion, criterion_group, criterion_main};
use rayon::ThreadPoolBuilder;
use roomwright::internals::catalog::{Catalog, load_catalog};
use roomwright::internals::plan::{Plan, PlanOptions, read_plans};
use roomwright::internals::storey::Choices;

/// Seeds that one measurement goes through, so that no lucky plan stands for all.
const SEEDS: u64 = 16;

/// A town of outlines as GeoJSON in metres.
#[derive(Default)]
struct Town(String);

impl Town {
    /// Adds a building: its use, its storeys, and its outline and courts, metres from the south-west corner of the town.
    fn add(&mut self, building: &str, storeys: u32, rings: &[Vec<(f64, f64)>]) {
        let comma = if self.0.is_empty() { "" } else { ",\n" };
        let rings: Vec<Vec<[f64; 2]>> = rings
            .iter()
            .map(|ring| {
                ring.iter().chain(ring.first()).map(|(x, y)| [120_000.0 + x, 487_000.0 + y]).collect()
            })
            .collect();
        let tags = format!(r#"{{"building": "{building}", "building:levels": {storeys}}}"#);
        let geometry = format!(r#"{{"type": "Polygon", "coordinates": {rings:?}}}"#);
        write!(self.0, r#"{comma}{{"type": "Feature", "properties": {tags}, "geometry": {geometry}}}"#)
            .expect("a text takes all");
    }

    fn text(&self) -> String {
        let crs = r#"{"type": "name", "properties": {"name": "EPSG:28992"}}"#;
        format!(r#"{{"type": "FeatureCollection", "crs": {crs}, "features": [{}]}}"#, self.0)
    }
}

fn rectangle((x, y): (f64, f64), (width, depth): (f64, f64)) -> Vec<(f64, f64)> {
    vec![(x, y), (x + width, y), (x + width, y + depth), (x, y + depth)]
}

/// Two rows of 24 houses wall to wall, of 5 to 6.5 m, with two or three storeys.
fn terrace() -> Town {
    let mut town = Town::default();
    for row in 0..2_u32 {
        let mut x = 0.0;
        for house in 0..24_u32 {
            let width = 5.0 + 0.5 * f64::from((house + row) % 4);
            let depth = 9.0 + 0.4 * f64::from(house % 3);
            town.add("house", 2 + house % 2, &[rectangle((x, 30.0 * f64::from(row)), (width, depth))]);
            x += width;
        }
    }
    town
}

/// Twelve blocks of flats around courts, with three to six storeys.
fn blocks() -> Town {
    let mut town = Town::default();
    for block in 0..12_u32 {
        let (column, row) = (f64::from(block % 4), f64::from(block / 4));
        let low = (column * 80.0, row * 70.0);
        let (width, depth) = (40.0 + 4.0 * column, 34.0 + 3.0 * row);
        let court = rectangle((low.0 + 12.0, low.1 + 12.0), (width - 24.0, depth - 24.0));
        town.add("apartments", 3 + block % 4, &[rectangle(low, (width, depth)), court]);
    }
    town
}

/// One office of 15,840 m² a storey: a spine of 220 m with five wings of 100 m, five storeys.
fn office() -> Town {
    let mut comb = vec![(0.0, 0.0), (220.0, 0.0)];
    for wing in (0..5_u32).rev() {
        let x = f64::from(wing) * 49.5;
        comb.extend([(x + 22.0, 22.0), (x + 22.0, 122.0), (x, 122.0), (x, 22.0)]);
    }
    // The outer wings go on in the ends of the spine.
    comb.retain(|corner| !matches!(*corner, (220.0 | 0.0, 22.0)));
    let mut town = Town::default();
    town.add("office", 5, &[comb]);
    town
}

/// Reads and plans a map.
fn planned(map: &Path, catalog: &Catalog, seed: u64) -> Plan {
    let choices = Choices { seed, ..Choices::default() };
    let options = PlanOptions::new(&catalog.room_words).with_planning(&catalog.typologies, &choices);
    read_plans(&[map.to_owned()], &options).plan
}

/// Time of one building, of several plans of a map.
fn time_of_one(map: &Path, catalog: &Catalog, count: u64) -> Duration {
    let (mut spent, mut building_count) = (Duration::ZERO, 0);
    for seed in 0..count {
        let start = Instant::now();
        let plan = planned(map, catalog, seed % SEEDS);
        spent += start.elapsed();
        building_count = plan.buildings.len() as u32;
    }
    spent / building_count
}

fn plan(criterion: &mut Criterion) {
    let catalog = load_catalog(&[]).expect("the built-in catalogue is valid").value;
    let folder = tempfile::tempdir().expect("there is a folder for temporary files");
    let drawn = |name: &str, town: &Town| -> PathBuf {
        let path = folder.path().join(name).with_extension("geojson");
        std::fs::write(&path, town.text()).expect("a temporary file can be written");
        path
    };
    let maps = [
        ("terrace", drawn("terrace", &terrace())),
        ("blocks of flats", drawn("blocks", &blocks())),
        ("office of 15,840 m²", drawn("office", &office())),
        ("quarter of Delft", Path::new(env!("CARGO_MANIFEST_DIR")).join("configs/quarter/delft.city.json")),
        (
            "home of 40 rooms",
            Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases/sweet_home/forty_rooms.sh3d"),
        ),
    ];
    let one_thread = ThreadPoolBuilder::new().num_threads(1).build().expect("a thread can be started");
    let mut group = criterion.benchmark_group("plan");
    group.sample_size(20);
    for (name, map) in &maps {
        let plan = planned(map, &catalog, 1);
        let rooms: usize = plan
            .buildings
            .iter()
            .flat_map(|placed| &placed.building.levels)
            .map(|level| level.rooms.len())
            .sum();
        eprintln!("{name}: {} buildings, {rooms} rooms", plan.buildings.len());
        group.bench_function(*name, |bencher| {
            bencher.iter_custom(|count| one_thread.install(|| time_of_one(map, &catalog, count)));
        });
    }
    group.finish();
}

criterion_group!(benches, plan);
criterion_main!(benches);
