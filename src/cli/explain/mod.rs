//! `explain`: why everything in a room is where it is.

mod report;
mod text;

use std::path::Path;

use super::arguments::{ExplainArguments, SourceArguments};
use super::bake::DEFAULT_SEED;
use super::exit::Outcome;
use super::screen::Screen;
use super::sources::{Sources, read_sources, run_style};
use crate::audit::Finding;
use crate::best::furnish_best;
use crate::document::{Fault, Faults, did_you_mean};
use crate::edits::RoomEdits;
use crate::layout::{Explanation, FurnishOptions, Furnished, explain_alternative};
use crate::plan::{Level, PlacedBuilding, Room};

/// A room in its building, and all that is to be said about it.
struct Subject<'a> {
    sources: &'a Sources,
    found: Found<'a>,
    seed: u64,
    /// Which of the alternatives of `--effort` it is, from 0.
    alternative: u32,
    furnished: Furnished,
    findings: Vec<Finding>,
    explanation: Explanation,
    /// Ids of the objects that are edited after the arrangement, which is what is explained.
    edited: Vec<String>,
}

/// Where a room is.
#[derive(Clone, Copy)]
struct Found<'a> {
    placed: &'a PlacedBuilding,
    level: &'a Level,
    /// Index in the level.
    room: usize,
}

impl<'a> Found<'a> {
    fn room(&self) -> &'a Room {
        &self.level.rooms[self.room]
    }
}

/// Runs the command.
pub(crate) fn run(arguments: &ExplainArguments, screen: Screen) -> Outcome {
    let ExplainArguments { plan, catalog, edits, .. } = arguments.clone();
    let sources = SourceArguments { paths: vec![plan], catalog, edits };
    let told = read_sources(&sources).and_then(|sources| {
        screen.faults(&sources.faults);
        let style = run_style(arguments.furnish.style.as_ref(), &sources)?;
        let found = find(arguments, &sources)?;
        let subject = subject(arguments, &sources, found, style.as_deref());
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

/// Furnishes the room as `bake` does, then once more with somebody who listens.
fn subject<'a>(
    arguments: &ExplainArguments,
    sources: &'a Sources,
    found: Found<'a>,
    style: Option<&str>,
) -> Subject<'a> {
    let seed = arguments.furnish.seed.or(sources.settings.seed).unwrap_or(DEFAULT_SEED);
    let (level, room, catalog) = (found.level, found.room, &sources.catalog);
    let edits = sources.edits.level(&found.placed.id, &level.id);
    let edits = edits.and_then(|edits| edits.room(&level.rooms[room].id));
    let locks = edits.map(|edits| edits.locks(level, room, catalog)).unwrap_or_default();
    let run = FurnishOptions::new(seed, &found.placed.id).with_style(style);
    let options = edits.map_or(run, |edits| edits.options(run, &locks));
    let best = furnish_best(level, room, catalog, &options, arguments.furnish.effort);
    let (furnished, explanation) = explain_alternative(level, room, catalog, &options, &best.alternative);
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

/// The one room of that id, or, if there is none, of that name.
fn find<'a>(arguments: &ExplainArguments, sources: &'a Sources) -> Result<Found<'a>, Faults> {
    let buildings = &sources.plan.buildings;
    let is_wanted = |wanted: &Option<String>, id: &str| wanted.as_ref().is_none_or(|wanted| wanted == id);
    let in_buildings: Vec<&PlacedBuilding> =
        buildings.iter().filter(|placed| is_wanted(&arguments.building, &placed.id)).collect();
    if let (Some(id), true) = (&arguments.building, in_buildings.is_empty()) {
        return Err(unknown("building", id, buildings.iter().map(|placed| placed.id.as_str()).collect()));
    }
    let levels: Vec<(&PlacedBuilding, &Level)> = in_buildings
        .iter()
        .flat_map(|placed| placed.building.levels.iter().map(|level| (*placed, level)))
        .collect();
    let in_levels: Vec<(&PlacedBuilding, &Level)> =
        levels.iter().filter(|(_, level)| is_wanted(&arguments.level, &level.id)).copied().collect();
    if let (Some(id), true) = (&arguments.level, in_levels.is_empty()) {
        return Err(unknown("level", id, levels.iter().map(|(_, level)| level.id.as_str()).collect()));
    }
    let all: Vec<Found<'a>> = in_levels
        .iter()
        .flat_map(|&(placed, level)| (0..level.rooms.len()).map(move |room| Found { placed, level, room }))
        .collect();
    choose(&arguments.room, &all)
}

fn choose<'a>(wanted: &str, all: &[Found<'a>]) -> Result<Found<'a>, Faults> {
    let of = |is_it: &dyn Fn(&Room) -> bool| -> Vec<Found<'a>> {
        all.iter().filter(|found| is_it(found.room())).copied().collect()
    };
    let mut found = of(&|room| room.id == wanted);
    if found.is_empty() {
        found = of(&|room| room.name.as_deref() == Some(wanted));
    }
    match found.as_slice() {
        [found] => Ok(*found),
        [] => {
            let words = all.iter().flat_map(|found| {
                let room = found.room();
                [Some(room.id.as_str()), room.name.as_deref()].into_iter().flatten()
            });
            Err(unknown("room", wanted, words.collect()))
        }
        several => {
            let message = format!("{} rooms are called \"{wanted}\"", several.len());
            let places: Vec<String> =
                several.iter().map(|found| format!("{}/{}", found.placed.id, found.level.id)).collect();
            let hint = format!("choose with --building and --level: {}", places.join(", "));
            Err(Fault::of_file(Path::new("ROOM"), message).with_hint(hint).into())
        }
    }
}

fn unknown(what: &str, id: &str, known: Vec<&str>) -> Faults {
    let place = if what == "room" { "ROOM".to_owned() } else { format!("--{what}") };
    let fault = Fault::of_file(Path::new(&place), format!("no {what} \"{id}\""));
    match did_you_mean(id, known) {
        Some(hint) => fault.with_hint(hint).into(),
        None => fault.into(),
    }
}
