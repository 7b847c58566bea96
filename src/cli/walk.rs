//! `walk`: walks through furnished buildings without a picture, and reports whether rooms were there in time.

use std::fmt::Write as _;
use std::sync::Arc;

use schemars::JsonSchema;
use serde::Serialize;

use super::answer::{FaultAnswer, fault_answers};
use super::arguments::{SourceArguments, WalkArguments};
use super::exit::Outcome;
use super::screen::Screen;
use super::sources::{read_sources, run_style};
use crate::document::{Faults, counted};
use crate::output::LevelOptions;
use crate::project::Project;
use crate::world::{Budget, Pace, Spread, WalkPath, WalkReport, World, walk};

/// Metres of a random walk where nothing else is said.
const USUAL_METRES: f64 = 1000.0;

/// The answer of `walk`.
#[derive(Serialize, JsonSchema)]
pub(crate) struct WalkAnswer {
    /// Rooms of all buildings.
    rooms: usize,
    /// Milliseconds to read plans and catalogue.
    read_ms: f64,
    /// Milliseconds from then until the world was open.
    open_ms: f64,
    /// The walks, one for each speed.
    walks: Vec<WalkReport>,
    /// What is wrong with the plans.
    faults: Vec<FaultAnswer>,
}

/// Runs the command.
pub(crate) fn run(arguments: &WalkArguments, screen: Screen) -> Outcome {
    match answer(arguments) {
        Ok(answer) => {
            if screen.is_json {
                screen.json(&answer.0);
            } else {
                screen.faults(&answer.1);
                screen.result(text(&answer.0).trim_end());
            }
            Outcome::of_failures(answer.1.has_errors())
        }
        Err(faults) => {
            screen.faults(&faults);
            Outcome::NotStarted
        }
    }
}

fn answer(arguments: &WalkArguments) -> Result<(WalkAnswer, Faults), Faults> {
    let begun = std::time::Instant::now();
    let sources: SourceArguments = arguments.sources.seeded(arguments.furnish.seed);
    let mut project = read_sources(&sources)?;
    let faults = std::mem::take(&mut project.faults);
    let style = run_style(arguments.furnish.style.as_ref(), &project)?;
    let defaults = project.level_options();
    let seed = arguments.furnish.seed.unwrap_or(defaults.seed);
    let options = LevelOptions { seed, style, effort: arguments.furnish.effort, ..defaults };
    let path = path(arguments, &project)?;
    let rooms = project.room_ids().count();
    let read_ms = begun.elapsed().as_secs_f64() * 1000.0;
    let project = Arc::new(project);
    let mut open_ms = 0.0;
    let mut walks = Vec::new();
    for &speed in &arguments.speed {
        let begun = std::time::Instant::now();
        // Each walk begins with nothing.
        let mut world = World::open(Arc::clone(&project), options.clone());
        open_ms = begun.elapsed().as_secs_f64() * 1000.0;
        let pace = Pace {
            speed,
            field_of_view: arguments.view.to_radians(),
            reach: arguments.reach,
            threads: arguments.threads,
            budget: Budget { rooms: arguments.budget_rooms, bytes: arguments.budget_megabytes << 20 },
        };
        let report = walk(&mut world, &path, &pace);
        walks.push(report.expect("paths were checked against the plan"));
    }
    Ok((WalkAnswer { rooms, read_ms, open_ms, walks, faults: fault_answers(&faults) }, faults))
}

fn path(arguments: &WalkArguments, project: &Project) -> Result<WalkPath, Faults> {
    if let Some(file) = &arguments.path {
        return WalkPath::read(file, &project.plan);
    }
    let metres = arguments.random.unwrap_or(USUAL_METRES);
    WalkPath::random(&project.plan, &project.catalog, arguments.path_seed, metres)
}

/// The report for people: a column for each speed.
fn text(answer: &WalkAnswer) -> String {
    let mut text = String::new();
    let WalkAnswer { rooms, read_ms, open_ms, walks, .. } = answer;
    let _ = writeln!(text, "{}, read in {read_ms:.0} ms, open in {open_ms:.2} ms\n", counted(*rooms, "room"));
    let mut row = |name: &str, value: &dyn Fn(&WalkReport) -> String| {
        let cells: String = walks.iter().map(|walk| format!(" {:>22}", value(walk))).collect();
        let _ = writeln!(text, "{name:<42}{cells}");
    };
    let spread = |spread: &Spread| format!("{:.2} / {:.2} / {:.2}", spread.p50, spread.p99, spread.max);
    let counts = |spread: &Spread| format!("{:.1} / {:.0}", spread.mean, spread.max);
    row("speed, m/s", &|walk| format!("{}", walk.speed));
    row("walked, m", &|walk| format!("{:.0}", walk.metres));
    row("rooms in view, mean / most", &|walk| counts(&walk.rooms_in_view));
    row("pieces in view, mean / most", &|walk| counts(&walk.pieces_in_view));
    row("further rooms near, mean / most", &|walk| counts(&walk.rooms_near));
    row("rooms needed", &|walk| walk.needed.to_string());
    row("needed until there, ms, p50 / p99 / most", &|walk| spread(&walk.latency_ms));
    row("in view before they were there", &|walk| walk.popped.to_string());
    row("frames with such a room", &|walk| format!("{} of {}", walk.late_frames, walk.frames));
    row("arrivals; all in view there, ms, p50 / most", &|walk| {
        format!("{}; {:.1} / {:.1}", walk.arrivals, walk.arrival_ms.p50, walk.arrival_ms.max)
    });
    row("rooms furnished; again", &|walk| format!("{}; {}", walk.made, walk.made_again));
    row("furnishing a room, ms, p50 / p99 / most", &|walk| spread(&walk.make_ms));
    row("a look around, µs, p50 / p99 / most", &|walk| {
        let Spread { p50, p99, max, .. } = walk.look_us;
        format!("{p50:.0} / {p99:.0} / {max:.0}")
    });
    row("rooms held at most", &|walk| walk.most_rooms.to_string());
    row("megabytes of rooms at most", &|walk| format!("{:.2}", walk.most_bytes as f64 / 1048576.0));
    text
}
