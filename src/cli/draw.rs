//! `draw`: furnished levels as SVG.

use std::path::{Path, PathBuf};

use rayon::prelude::*;

use super::arguments::DrawArguments;
use super::bake::DEFAULT_SEED;
use super::exit::Outcome;
use super::files::write_text;
use super::screen::Screen;
use super::sources::{Sources, read_sources, run_style};
use crate::audit::Finding;
use crate::batch::distinct_names;
use crate::best::Judged;
use crate::catalog::Catalog;
use crate::document::{Fault, Faults, did_you_mean};
use crate::draw::{Drawing, draw_level, draw_levels};
use crate::edits::furnish_edited;
use crate::layout::{FurnishOptions, Furnished};
use crate::plan::{Level, PlacedBuilding};

/// A level to draw.
type Subject<'a> = (&'a PlacedBuilding, &'a Level);

/// The levels of one file; several are of one building.
type Page<'a> = Vec<Subject<'a>>;

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
    let pages = pages(subjects, arguments.sheet);
    let draw = |page: &Page<'_>| draw_page(arguments, &sources, style.as_deref(), page);
    let has_faults = sources.faults.has_errors();
    match (&arguments.out, pages.as_slice()) {
        (None, [page]) => {
            screen.result(draw(page).trim_end());
            Outcome::of_failures(has_faults)
        }
        (None, _) => {
            let fault = Fault::of_file(
                Path::new("--out"),
                format!("{} {} need a folder", pages.len(), arguments.pages_word()),
            );
            let hint = "name a folder with --out, or one level with --building and --level";
            refuse(screen, &fault.with_hint(hint).into())
        }
        (Some(out), _) => {
            let written = write_all(&pages, out, arguments, draw);
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

/// The furnished rooms of a level and the findings in each.
type Judgement = (Vec<Furnished>, Vec<Vec<Finding>>);

/// One file for each level, or for each building.
fn pages(subjects: Vec<Subject<'_>>, is_sheet: bool) -> Vec<Page<'_>> {
    if !is_sheet {
        return subjects.into_iter().map(|subject| vec![subject]).collect();
    }
    let mut pages: Vec<Page<'_>> = Vec::new();
    for subject in subjects {
        match pages.last_mut() {
            Some(page) if page[0].0.id == subject.0.id => page.push(subject),
            _ => pages.push(vec![subject]),
        }
    }
    for page in &mut pages {
        page.sort_by(|a, b| a.1.elevation.total_cmp(&b.1.elevation));
    }
    pages
}

/// Furnishes levels as `bake` does and draws them.
fn draw_page(arguments: &DrawArguments, sources: &Sources, style: Option<&str>, page: &Page<'_>) -> String {
    let seed = arguments.furnish.seed.or(sources.settings.seed).unwrap_or(DEFAULT_SEED);
    let furnish = |&subject: &Subject<'_>| furnish_level(arguments, sources, (seed, style), subject);
    let judged: Vec<Judgement> = page.iter().map(furnish).collect();
    let drawings: Vec<Drawing<'_>> = page
        .iter()
        .zip(&judged)
        .map(|(subject, judgement)| drawing(arguments, &sources.catalog, seed, (*subject, judgement)))
        .collect();
    match drawings.as_slice() {
        [one] => draw_level(one),
        several => draw_levels(several),
    }
}

fn drawing<'a>(
    arguments: &DrawArguments,
    catalog: &'a Catalog,
    seed: u64,
    ((placed, level), (furnished, findings)): (Subject<'a>, &'a Judgement),
) -> Drawing<'a> {
    Drawing {
        building: &placed.id,
        site: placed.site,
        level,
        furnished,
        findings,
        catalog,
        seed,
        has_clearances: arguments.clearances,
        has_findings: arguments.findings,
        has_legend: true,
    }
}

fn furnish_level(
    arguments: &DrawArguments,
    sources: &Sources,
    (seed, style): (u64, Option<&str>),
    (placed, level): Subject<'_>,
) -> Judgement {
    let rooms = (0..level.rooms.len()).into_par_iter();
    let run = FurnishOptions::new(seed, &placed.id).with_style(style);
    let edits = sources.edits.level(&placed.id, &level.id);
    let furnish =
        |room| furnish_edited((level, room), &sources.catalog, &run, arguments.furnish.effort, edits).judged;
    let judged = |judged: Judged| (judged.furnished, judged.verdict.findings);
    rooms.map(furnish).map(judged).unzip()
}

fn write_all(
    pages: &[Page<'_>],
    out: &Path,
    arguments: &DrawArguments,
    draw: impl Fn(&Page<'_>) -> String,
) -> Vec<Result<PathBuf, Faults>> {
    let is_file = out.extension().is_some_and(|extension| extension == "svg");
    if is_file && pages.len() > 1 {
        let word = arguments.pages_word();
        let fault = Fault::of_file(out, format!("is one file, but {} {word} are drawn", pages.len()));
        let hint = "name a folder, or choose one level with --building and --level";
        return vec![Err(fault.with_hint(hint).into())];
    }
    let buildings: Vec<&str> = pages.iter().map(|page| page[0].0.id.as_str()).collect();
    let levels: Vec<&str> = pages.iter().map(|page| page[0].1.id.as_str()).collect();
    let names = distinct_names(&buildings).into_iter().zip(distinct_names(&levels));
    let write = |(page, (building, level)): (&Page<'_>, (String, String))| {
        let path = match (is_file, arguments.sheet) {
            (true, _) => out.to_owned(),
            (false, true) => out.join(building + ".svg"),
            (false, false) => out.join(building).join(level + ".svg"),
        };
        write_text(&path, &draw(page), arguments.force).map(|()| path)
    };
    pages.iter().zip(names).map(write).collect()
}

impl DrawArguments {
    /// What each file shows.
    fn pages_word(&self) -> &'static str {
        if self.sheet { "buildings" } else { "levels" }
    }
}
