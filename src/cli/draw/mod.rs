//! `draw`: draws furnished levels as SVG.

mod chosen;
mod page;
mod signature;
mod target;

use std::path::PathBuf;

use super::arguments::DrawArguments;
use super::bake::DEFAULT_SEED;
use super::exit::Outcome;
use super::files::{Overwrite, write_text};
use super::screen::Screen;
use super::sources::{read_sources, run_style};
use crate::document::{Faults, printable};
use crate::dwelling::occupied;
use crate::edits::distinct_misfits;
use chosen::{chosen_levels, pages};
use page::draw_page;
use signature::{is_own_drawing, sign};
use target::target;

/// Runs the command.
pub(crate) fn run(arguments: &DrawArguments, screen: Screen) -> Outcome {
    prepare_and_draw(arguments, screen).unwrap_or_else(|faults| {
        screen.faults(&faults);
        Outcome::NotStarted
    })
}

fn prepare_and_draw(arguments: &DrawArguments, screen: Screen) -> Result<Outcome, Faults> {
    let target = target(arguments)?;
    let mut sources = read_sources(&arguments.sources.seeded(arguments.furnish.seed))?;
    let seed = arguments.furnish.seed.or(sources.settings.seed).unwrap_or(DEFAULT_SEED);
    sources.plan = occupied(&sources.plan, &sources.catalog, seed);
    let style = run_style(arguments.furnish.style.as_ref(), &sources)?;
    screen.faults(&sources.faults);
    let levels = chosen_levels(arguments, &sources)?;
    let pages = pages(levels, arguments.sheet || target.is_one_file());
    let jobs = target.jobs(&pages, arguments.sheet)?;
    let (mut failed, mut misfits) = (Vec::new(), Vec::new());
    for (page, path) in jobs {
        let (svg, found) = draw_page(arguments, &sources, style.as_deref(), page);
        let written = show_or_write(&sign(svg), path, arguments.force, screen);
        failed.push(show_written(written, screen));
        misfits.extend(found);
    }
    let misfits = distinct_misfits(&misfits);
    screen.faults(&misfits);
    Ok(outcome(&failed, sources.faults.has_errors() || misfits.has_errors()))
}

/// Prints a drawing, or writes it if it has a path.
fn show_or_write(
    svg: &str,
    path: Option<PathBuf>,
    is_forced: bool,
    screen: Screen,
) -> Result<Option<PathBuf>, Faults> {
    match path {
        Some(path) => {
            let overwrite = if is_forced { Overwrite::All } else { Overwrite::Own(is_own_drawing) };
            write_text(&path, svg, overwrite).map(|()| Some(path))
        }
        None => {
            screen.result(svg.trim_end());
            Ok(None)
        }
    }
}

/// Names a written file; says whether it failed.
fn show_written(written: Result<Option<PathBuf>, Faults>, screen: Screen) -> bool {
    match written {
        Ok(path) => {
            path.iter().for_each(|path: &PathBuf| screen.note(&printable(&path.display().to_string())));
            false
        }
        Err(faults) => {
            screen.faults(&faults);
            true
        }
    }
}

fn outcome(failed: &[bool], has_faults: bool) -> Outcome {
    match failed.iter().all(|failed| *failed) {
        true => Outcome::NotStarted,
        false => Outcome::of_failures(has_faults || failed.contains(&true)),
    }
}
