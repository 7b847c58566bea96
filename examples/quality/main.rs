//! Measures the quality of rooms: furnishes plans over many seeds, audits every room, and prints one line for each plan.
//!
//! ```text
//! cargo run --release --example quality -- [--seeds N] [--random N [--first N] [--draw FOLDER]] [--catalog FOLDER]
//!     [--style STYLE] [--type TYPE]… [--beside CLASS CLASS] [--details] [--slowest N] PLAN…
//! ```
//! A PLAN is a file or folder as `bake` takes it; `--random` adds rooms of random shape, size, type and style, those of
//! `tests/properties`. Nothing is written but the drawings asked for with `--draw`.
#![allow(clippy::print_stdout)] // the table is what it is for
#![allow(unreachable_pub)] // of the shared file

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use clap::Parser;
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::{Config, RngSeed, TestRunner};
use rayon::prelude::*;
use roomwright::internals::audit::{Finding, Grade, Severity};
use roomwright::internals::best::{DEFAULT_EFFORT, furnish_best};
use roomwright::internals::catalog::{Catalog, load_catalog};
use roomwright::internals::draw::{Drawing, draw_level};
use roomwright::internals::dwelling::occupied;
use roomwright::internals::geometry::{Convex, Point, direction};
use roomwright::internals::layout::{FurnishOptions, Furnished, Placement};
use roomwright::internals::plan::{Level, Plan, PlanOptions, SitePlacement, read_plans};

use slowest::Slowest;

#[path = "../../tests/properties/rooms.rs"]
mod rooms;
mod slowest;

#[derive(Parser)]
#[command(about = "Audits plans over many seeds")]
struct Arguments {
    /// Files or folders, each a line of the table.
    plans: Vec<PathBuf>,
    /// Seeds per room.
    #[arg(long, default_value_t = 100)]
    seeds: u64,
    /// So many rooms of random shape: convex, concave, slanted, with columns; 1 to 500 m².
    #[arg(long, default_value_t = 0)]
    random: usize,
    /// Number of the first of those random rooms: others than from 0 on.
    #[arg(long, default_value_t = 0)]
    first: usize,
    /// Draw those random rooms that have findings into this folder, the grade first in the file's name.
    #[arg(long)]
    draw: Option<PathBuf>,
    /// Layouts per room and seed at most, as for `bake`.
    #[arg(long, default_value_t = DEFAULT_EFFORT)]
    effort: u32,
    /// Folders of configuration beside the built-in one.
    #[arg(long)]
    catalog: Vec<PathBuf>,
    /// Style or building style of the rooms, as for `bake`.
    #[arg(long)]
    style: Option<String>,
    /// Only rooms of these types.
    #[arg(long = "type")]
    types: Vec<String>,
    /// Also count how many rooms with a piece of the first class or group have one directly beside one of the second.
    #[arg(long, num_args = 2)]
    beside: Vec<String>,
    /// Also list findings and missing pieces by class.
    #[arg(long)]
    details: bool,
    /// Also list so many rooms that took longest; the times are those of one room when RAYON_NUM_THREADS is 1.
    #[arg(long, default_value_t = 0)]
    slowest: usize,
}

impl Arguments {
    fn wants(&self, level: &Level, room: usize) -> bool {
        self.types.is_empty() || self.types.contains(&level.rooms[room].room_type)
    }
}

/// What rooms came to; sums over rooms and seeds.
#[derive(Default)]
struct Tally {
    rooms: u64,
    without_finding: u64,
    failed_findings: u64,
    /// Rooms in which the plan itself makes a rule impossible.
    given: u64,
    requested: u64,
    placed: u64,
    /// Rooms that have a piece of the first class of `--beside`, and those where one touches one of the second.
    with_first: u64,
    with_neighbours: u64,
    /// Counts of findings and of missing pieces by what they concern.
    details: BTreeMap<String, u64>,
    slowest: Slowest,
}

impl Tally {
    fn of(
        level: &Level,
        room: usize,
        catalog: &Catalog,
        options: &FurnishOptions<'_>,
        arguments: &Arguments,
    ) -> Self {
        let (judged, timed) = slowest::furnish(level.room(room), catalog, options, arguments.effort);
        let furnished = judged.furnished;
        let mut tally = Self { slowest: Slowest::of(timed, arguments.slowest), ..Self::default() };
        if furnished.requested == 0 {
            return tally;
        }
        tally.rooms = 1;
        tally.requested = u64::from(furnished.requested);
        tally.placed = furnished.placements.len() as u64;
        if let [first, second] = &arguments.beside[..] {
            let having = |name: &str| having(&furnished, catalog, name);
            let (first, second) = (having(first), having(second));
            tally.with_first = u64::from(!first.is_empty());
            let is_beside = |one: &&Placement| second.iter().any(|other| touches(one, other));
            tally.with_neighbours = u64::from(first.iter().any(is_beside));
        }
        tally.judge(level, &furnished, &judged.verdict.findings, catalog);
        tally
    }

    fn judge(&mut self, level: &Level, furnished: &Furnished, findings: &[Finding], catalog: &Catalog) {
        let room_type = &level.rooms[furnished.room].room_type;
        self.without_finding = u64::from(Grade::of(findings) == Grade::None);
        self.given = u64::from(findings.iter().any(|finding| finding.severity == Severity::Given));
        self.failed_findings = findings.iter().filter(|f| f.severity == Severity::Failed).count() as u64;
        for finding in findings {
            let classes: Vec<&str> =
                finding.objects.iter().map(|id| id.split('.').next().unwrap_or(id)).collect();
            let name = finding.code.name();
            let kind = match finding.severity {
                Severity::Given => "given",
                Severity::Minor => "minor",
                Severity::Failed => "FAILED",
            };
            *self
                .details
                .entry(format!("{kind} {name}: {} in {room_type}", classes.join(", ")))
                .or_default() += 1;
        }
        for removal in &furnished.removals {
            let (class, reason) = (&catalog.classes[removal.class].id, removal.reason.name());
            *self.details.entry(format!("missing {class}: {reason} in {room_type}")).or_default() += 1;
        }
    }

    fn join(mut self, other: Self) -> Self {
        self.rooms += other.rooms;
        self.without_finding += other.without_finding;
        self.failed_findings += other.failed_findings;
        self.given += other.given;
        self.requested += other.requested;
        self.placed += other.placed;
        self.with_first += other.with_first;
        self.with_neighbours += other.with_neighbours;
        self.slowest = self.slowest.join(other.slowest);
        for (key, count) in other.details {
            *self.details.entry(key).or_default() += count;
        }
        self
    }
}

/// The pieces of a class or group.
fn having<'a>(furnished: &'a Furnished, catalog: &Catalog, name: &str) -> Vec<&'a Placement> {
    let is_such = |placement: &&Placement| {
        let class = &catalog.classes[placement.class];
        class.id == name || class.groups.iter().any(|group| group == name)
    };
    furnished.placements.iter().filter(is_such).collect()
}

/// Whether one piece begins within five centimetres of another's left or right side.
fn touches(one: &Placement, other: &Placement) -> bool {
    let footprint = |placement: &Placement, margin: f64| {
        let half = Point::new(placement.size.width / 2.0 + margin, placement.size.depth / 2.0);
        Convex::rectangle(placement.position, half, direction(placement.angle))
    };
    footprint(one, 0.05).overlaps(&footprint(other, 0.0), 0.01)
}

fn main() {
    let arguments = Arguments::parse();
    let catalog = load_catalog(&arguments.catalog).unwrap_or_else(|faults| panic!("{faults}")).value;
    println!(
        "| set | rooms × seeds | failing findings | rooms without finding | placed of requested | impossible by plan |"
    );
    println!("|---|---|---|---|---|---|");
    for plan in &arguments.plans {
        print_line(&plan.display().to_string(), measure(plan, &catalog, &arguments), &arguments);
    }
    if arguments.random > 0 {
        print_line("random polygons", measure_random(&catalog, &arguments), &arguments);
    }
}

fn print_line(name: &str, tally: Tally, arguments: &Arguments) {
    let share = |part: u64, whole: u64| 100.0 * part as f64 / whole.max(1) as f64;
    println!(
        "| {name} | {} | {} | {:.2} % | {:.2} % | {:.2} % |",
        tally.rooms,
        tally.failed_findings,
        share(tally.without_finding, tally.rooms),
        share(tally.placed, tally.requested),
        share(tally.given, tally.rooms),
    );
    if let [first, second] = &arguments.beside[..] {
        let (with, of) = (tally.with_neighbours, tally.with_first);
        println!("    {first} beside {second}: {with} of {of} rooms, {:.2} %", share(with, of));
    }
    if arguments.details {
        let mut details: Vec<_> = tally.details.into_iter().collect();
        details.sort_by_key(|(text, count)| (std::cmp::Reverse(*count), text.clone()));
        details.iter().for_each(|(text, count)| println!("    {count:6} {text}"));
    }
    tally.slowest.print();
}

/// Random rooms, each with a seed of its own; the same number is always the same room.
fn measure_random(catalog: &Catalog, arguments: &Arguments) -> Tally {
    let config = Config { rng_seed: RngSeed::Fixed(1), ..Config::default() };
    let (mut runner, sketches) = (TestRunner::new(config), rooms::sketches());
    let mut sketch = |_| sketches.new_tree(&mut runner).expect("sketches reject nothing").current();
    let sketches: Vec<rooms::Sketch> =
        (0..arguments.first + arguments.random).map(&mut sketch).skip(arguments.first).collect();
    let tally = |(offset, sketch): (usize, &rooms::Sketch)| {
        let number = arguments.first + offset;
        let options = FurnishOptions::new(sketch.seed, "random");
        let level = sketch.level(catalog).filter(|level| arguments.wants(level, 0));
        level.map(|level| {
            if let Some(folder) = &arguments.draw {
                draw_random(folder, number, &level, catalog, (&options, arguments.effort));
            }
            let mut tally = Tally::of(&level, 0, catalog, &options, arguments);
            tally.slowest.name(&format!("--first {number} --random 1"));
            tally
        })
    };
    sketches.par_iter().enumerate().filter_map(tally).reduce(Tally::default, Tally::join)
}

/// Draws a random room if anything is wrong with it.
fn draw_random(
    folder: &Path,
    number: usize,
    level: &Level,
    catalog: &Catalog,
    (options, effort): (&FurnishOptions<'_>, u32),
) {
    let judged = furnish_best(level.room(0), catalog, options, effort);
    let (furnished, findings) = ([judged.furnished], [judged.verdict.findings]);
    let grade = Grade::of(&findings[0]);
    if grade == Grade::None {
        return;
    }
    let drawing = Drawing {
        building: options.building,
        site: SitePlacement::default(),
        level,
        furnished: &furnished,
        findings: &findings,
        catalog,
        seed: options.seed,
        has_clearances: true,
        has_findings: true,
        has_legend: true,
    };
    let name = format!("{grade:?}-{}-{number}.svg", level.rooms[0].room_type).to_lowercase();
    std::fs::create_dir_all(folder).expect("the folder can be made");
    std::fs::write(folder.join(name), draw_level(&drawing)).expect("the folder can be written to");
}

/// All rooms of a plan over all seeds; storeys that repeat count once.
fn measure(plan: &PathBuf, catalog: &Catalog, arguments: &Arguments) -> Tally {
    let reading = read_plans(std::slice::from_ref(plan), &PlanOptions::new(&catalog.room_words));
    // With each seed, other people live there.
    let plans: Vec<(u64, Plan)> =
        (0..arguments.seeds).map(|seed| (seed, occupied(&reading.plan, catalog, seed))).collect();
    let levels = plans.iter().flat_map(|(seed, plan)| {
        let buildings = plan.buildings.iter().map(|placed| (placed.id.as_str(), &placed.building.levels));
        buildings.flat_map(move |(id, levels)| levels.iter().map(move |level| (*seed, id, level)))
    });
    let rooms: Vec<(u64, &str, &Level, usize)> = levels
        .flat_map(|(seed, id, level)| (0..level.rooms.len()).map(move |room| (seed, id, level, room)))
        .filter(|&(_, _, level, room)| arguments.wants(level, room))
        .collect();
    rooms
        .par_iter()
        .map(|&(seed, building, level, room)| {
            let options = FurnishOptions::new(seed, building).with_style(arguments.style.as_deref());
            Tally::of(level, room, catalog, &options, arguments)
        })
        .reduce(Tally::default, Tally::join)
}
