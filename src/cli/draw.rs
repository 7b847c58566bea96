//! `draw`: furnished levels as SVG.

use std::path::{Path, PathBuf};

use rayon::prelude::*;

use super::arguments::DrawArguments;
use super::bake::DEFAULT_SEED;
use super::exit::Outcome;
use super::files::write_text;
use super::screen::Screen;
use super::sources::{Sources, read_sources, run_style};
use crate::batch::distinct_names;
use crate::best::{Judged, furnish_best};
use crate::document::{Fault, Faults, did_you_mean};
use crate::draw::{Drawing, draw_level};
use crate::layout::FurnishOptions;
use crate::plan::{Level, PlacedBuilding};

/// A level to draw.
type Subject<'a> = (&'a PlacedBuilding, &'a Level);

/// Runs the command.
pub(crate) fn run(arguments: &DrawArguments, screen: Screen) -> Outcome {
    let read = read_sources(&arguments.sources).and_then(|sources| {
        let style = run_style(arguments.furnish.style.as_ref(), &sources)?;
        Ok((sources, style))
    });
    let (sources, style) = match read {
        Ok(read) => read,
        Err(faults) => return refuse(screen, &faults),
    };
    screen.faults(&sources.faults);
    let subjects = match subjects(arguments, &sources) {
        Ok(subjects) => subjects,
        Err(faults) => return refuse(screen, &faults),
    };
    let draw = |subject: Subject<'_>| draw_one(arguments, &sources, style.as_deref(), subject);
    let has_faults = sources.faults.has_errors();
    match (&arguments.out, subjects.as_slice()) {
        (None, &[subject]) => {
            screen.result(draw(subject).trim_end());
            Outcome::of_failures(has_faults)
        }
        (None, _) => {
            let fault =
                Fault::of_file(Path::new("--out"), format!("{} levels need a folder", subjects.len()));
            let hint = "name a folder with --out, or one level with --building and --level";
            refuse(screen, &fault.with_hint(hint).into())
        }
        (Some(out), _) => {
            let written = write_all(&subjects, out, arguments.force, draw);
            for one in &written {
                match one {
                    Ok(path) => screen.note(&path.display().to_string()),
                    Err(faults) => screen.faults(faults),
                }
            }
            let failed_count = written.iter().filter(|one| one.is_err()).count();
            match failed_count == written.len() {
                true => Outcome::NotStarted,
                false => Outcome::of_failures(has_faults || failed_count > 0),
            }
        }
    }
}

fn refuse(screen: Screen, faults: &Faults) -> Outcome {
    screen.faults(faults);
    Outcome::NotStarted
}

/// The levels that were asked for, sorted by building and level as in the output folder.
fn subjects<'a>(arguments: &DrawArguments, sources: &'a Sources) -> Result<Vec<Subject<'a>>, Faults> {
    let buildings = &sources.plan.buildings;
    let of_building =
        |placed: &&PlacedBuilding| arguments.building.as_ref().is_none_or(|id| *id == placed.id);
    let chosen: Vec<&PlacedBuilding> = buildings.iter().filter(of_building).collect();
    if let (Some(id), true) = (&arguments.building, chosen.is_empty()) {
        return Err(unknown("building", id, buildings.iter().map(|placed| placed.id.clone()).collect()));
    }
    let levels = chosen.iter().flat_map(|placed| placed.building.levels.iter().map(|level| (*placed, level)));
    let levels: Vec<Subject<'_>> = levels.collect();
    let of_level = |subject: &&Subject<'_>| arguments.level.as_ref().is_none_or(|id| *id == subject.1.id);
    let mut found: Vec<Subject<'_>> = levels.iter().filter(of_level).copied().collect();
    if let (Some(id), true) = (&arguments.level, found.is_empty()) {
        return Err(unknown("level", id, levels.iter().map(|(_, level)| level.id.clone()).collect()));
    }
    found.sort_by(|a, b| (&a.0.id, &a.1.id).cmp(&(&b.0.id, &b.1.id)));
    Ok(found)
}

fn unknown(what: &str, id: &str, known: Vec<String>) -> Faults {
    let fault = Fault::of_file(Path::new(&format!("--{what}")), format!("no {what} \"{id}\""));
    match did_you_mean(id, known) {
        Some(hint) => fault.with_hint(hint).into(),
        None => fault.into(),
    }
}

/// Furnishes a level as `bake` does and draws it.
fn draw_one(
    arguments: &DrawArguments,
    sources: &Sources,
    style: Option<&str>,
    subject: Subject<'_>,
) -> String {
    let (placed, level) = subject;
    let catalog = &sources.catalog;
    let seed = arguments.furnish.seed.or(sources.settings.seed).unwrap_or(DEFAULT_SEED);
    let options = FurnishOptions { seed, building: &placed.id, style };
    let rooms = || (0..level.rooms.len()).into_par_iter();
    let best = |room| furnish_best(level, room, catalog, &options, arguments.furnish.effort);
    let judged = |judged: Judged| (judged.furnished, judged.verdict.findings);
    let (furnished, findings): (Vec<_>, Vec<_>) = rooms().map(best).map(judged).unzip();
    draw_level(&Drawing {
        building: &placed.id,
        site: placed.site,
        level,
        furnished: &furnished,
        findings: &findings,
        catalog,
        seed,
        has_clearances: arguments.clearances,
        has_findings: arguments.findings,
    })
}

fn write_all(
    subjects: &[Subject<'_>],
    out: &Path,
    is_forced: bool,
    draw: impl Fn(Subject<'_>) -> String,
) -> Vec<Result<PathBuf, Faults>> {
    let is_file = out.extension().is_some_and(|extension| extension == "svg");
    if is_file && subjects.len() > 1 {
        let fault = Fault::of_file(out, format!("is one file, but {} levels are drawn", subjects.len()));
        let hint = "name a folder, or choose one level with --building and --level";
        return vec![Err(fault.with_hint(hint).into())];
    }
    let buildings: Vec<&str> = subjects.iter().map(|(placed, _)| placed.id.as_str()).collect();
    let levels: Vec<&str> = subjects.iter().map(|(_, level)| level.id.as_str()).collect();
    let names = distinct_names(&buildings).into_iter().zip(distinct_names(&levels));
    let write = |(&subject, (building, level)): (&Subject<'_>, (String, String))| {
        let path = if is_file { out.to_owned() } else { out.join(building).join(level + ".svg") };
        write_text(&path, &draw(subject), is_forced).map(|()| path)
    };
    subjects.iter().zip(names).map(write).collect()
}
