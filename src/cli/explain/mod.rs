//! `explain`: reports why each object of a room stands where it is.

mod report;
mod text;

use super::arguments::{ExplainArguments, SourceArguments};
use super::bake::DEFAULT_SEED;
use super::exit::Outcome;
use super::find_room::{FoundRoom, Wanted, find_room};
use super::screen::Screen;
use super::sources::{read_sources, run_style};
use crate::audit::Finding;
use crate::best::furnish_best;
use crate::dwelling::occupied;
use crate::edits::RoomEdits;
use crate::layout::{Explanation, FurnishOptions, Furnished, RoomLayout};
use crate::output::LevelOptions;
use crate::project::Project;

/// A room in its building, and all that is to be said about it.
struct Subject<'a> {
    sources: &'a Project,
    found: FoundRoom<'a>,
    seed: u64,
    /// Which of the alternatives of `--effort` it is, from 0.
    alternative: u32,
    furnished: Furnished,
    findings: Vec<Finding>,
    explanation: Explanation,
    /// Ids of the objects that are edited after the arrangement, which is what is explained.
    edited: Vec<String>,
}

/// Runs the command.
pub(crate) fn run(arguments: &ExplainArguments, screen: Screen) -> Outcome {
    let ExplainArguments { plan, catalog, edits, .. } = arguments.clone();
    let sources = SourceArguments { paths: vec![plan], catalog, edits, ..SourceArguments::default() };
    let told = read_sources(&sources.seeded(arguments.furnish.seed)).and_then(|mut sources| {
        let seed = arguments.furnish.seed.or(sources.settings.seed).unwrap_or(DEFAULT_SEED);
        sources.plan = occupied(&sources.plan, &sources.catalog, seed);
        screen.faults(&sources.faults);
        let style = run_style(arguments.furnish.style.as_ref(), &sources)?;
        let wanted = Wanted {
            room: arguments.room.as_deref().unwrap_or_default(),
            building: arguments.building.as_deref(),
            level: arguments.level.as_deref(),
            argument: "ROOM",
        };
        let found = find_room(&sources.plan.buildings, wanted)?;
        let options =
            LevelOptions { seed, style, effort: arguments.furnish.effort, ..LevelOptions::default() };
        let subject = subject(&sources, found, &options);
        if screen.is_json {
            screen.json(&report::report(&subject));
        } else {
            screen.result(text::text(&subject).trim_end());
        }
        Ok(Outcome::of_failures(sources.faults.has_errors()))
    });
    told.unwrap_or_else(|faults| {
        screen.faults(&faults);
        Outcome::NotStarted
    })
}

/// The explanation of a room of an occupied building for machines.
pub(crate) fn explain_room(
    sources: &Project,
    found: FoundRoom<'_>,
    options: &LevelOptions,
) -> serde_json::Value {
    serde_json::to_value(report::report(&subject(sources, found, options))).expect("answers are plain data")
}

/// Furnishes the room as `bake` does, then once more with a trace of the search.
fn subject<'a>(sources: &'a Project, found: FoundRoom<'a>, options: &LevelOptions) -> Subject<'a> {
    let LevelOptions { seed, ref style, effort, .. } = *options;
    let (at, catalog) = (found.at, &sources.catalog);
    let edits = sources.edits.level(&found.placed.id, &at.level.id);
    let edits = edits.and_then(|edits| edits.room(&at.room.id));
    let locks = edits.map(|edits| edits.locks(at, catalog)).unwrap_or_default();
    let run = FurnishOptions::new(seed, &found.placed.id).with_style(style.as_deref());
    let options = edits.map_or(run, |edits| edits.options(run, &locks));
    let best = furnish_best(at, catalog, &options, effort);
    let (furnished, explanation) = RoomLayout::new(at, catalog, &options).explain(&best.alternative);
    Subject {
        sources,
        found,
        seed,
        alternative: best.alternative.number,
        furnished,
        findings: best.verdict.findings,
        explanation,
        edited: edits.map(RoomEdits::later_edits).unwrap_or_default(),
    }
}
