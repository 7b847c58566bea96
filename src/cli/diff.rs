//! `diff`: compares two bakes or two files.

use std::collections::BTreeMap;
use std::path::Path;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use rayon::prelude::*;

use super::arguments::DiffArguments;
use super::exit::Outcome;
use super::files::{Overwrite, write_text};
use super::screen::Screen;
use crate::batch::distinct_names;
use crate::catalog::{Catalog, load_catalog};
use crate::diff::{
    DiffOptions, HtmlLimits, Kind, LevelDiff, Report, RoomDiff, RoomPictures, Tolerance, compare, draw_rooms,
    html, markdown, shown_rooms, text,
};
use crate::document::{Fault, Faults, Warned};

/// The word of `--fail-on` for every kind that people see or use.
pub(crate) const ANY: &str = "any";

/// Redraws of the bar per second.
const REDRAWS: u8 = 5;

/// Pictures by building, level and room.
type Pictures = BTreeMap<(String, String, String), RoomPictures>;

/// Runs the command. The report is the result: it goes to stdout, faults of the files to stderr.
pub(crate) fn run(arguments: &DiffArguments, screen: Screen) -> Outcome {
    let compared = check(arguments).and_then(|()| {
        let Warned { value: catalog, warnings } = load_catalog(&arguments.catalog)?;
        screen.faults(&warnings);
        let (report, faults) = compare_sides(arguments, screen, &catalog)?;
        Ok((catalog, report, faults))
    });
    let (catalog, report, faults) = match compared {
        Ok(compared) => compared,
        Err(faults) => {
            screen.faults(&faults);
            return Outcome::NotStarted;
        }
    };
    screen.faults(&faults);
    show(arguments, screen, &report);
    let written = write_page(arguments, &report, &catalog).and(write_pictures(arguments, &report, &catalog));
    if let Err(faults) = &written {
        screen.faults(faults);
    }
    if written.is_err() || !report.troubles.is_empty() {
        return Outcome::NotStarted;
    }
    Outcome::of_failures(asked_for(arguments).any(|kind| report.count(kind) > 0))
}

/// Refuses what could not be written before anything is compared.
fn check(arguments: &DiffArguments) -> Result<(), Faults> {
    match &arguments.html {
        Some(path) if path.exists() && !arguments.force => {
            Err(Fault::of_file(path, "exists already; it is left as it is")
                .with_hint("overwrite it with --force")
                .into())
        }
        _ => Ok(()),
    }
}

/// The kinds of `--fail-on`.
fn asked_for(arguments: &DiffArguments) -> impl Iterator<Item = Kind> + '_ {
    let is_asked = |kind: &Kind| {
        arguments.fail_on.iter().any(|word| word == kind.name() || (word == ANY && kind.is_visible()))
    };
    Kind::ALL.into_iter().filter(is_asked)
}

fn compare_sides(
    arguments: &DiffArguments,
    screen: Screen,
    catalog: &Catalog,
) -> Result<(Report, Faults), Faults> {
    let bar = bar(screen);
    let tolerance = Tolerance { metres: arguments.move_tolerance, degrees: arguments.turn_tolerance };
    let observer = |done: usize, all: usize| {
        bar.set_length(all as u64);
        bar.set_position(done as u64);
    };
    let options = DiffOptions { tolerance, catalog, is_thorough: arguments.verify, observer: &observer };
    let compared = compare(&arguments.old, &arguments.new, &options);
    bar.finish_and_clear();
    compared
}

/// A bar on a terminal, nothing elsewhere.
fn bar(screen: Screen) -> ProgressBar {
    let target = if screen.is_quiet {
        ProgressDrawTarget::hidden()
    } else {
        ProgressDrawTarget::stderr_with_hz(REDRAWS)
    };
    let style = ProgressStyle::with_template("{bar:30} {human_pos} of {human_len} levels, {eta} left");
    ProgressBar::with_draw_target(None, target).with_style(style.expect("the template is fixed"))
}

fn show(arguments: &DiffArguments, screen: Screen, report: &Report) {
    if screen.is_json {
        screen.json(report);
    } else if arguments.markdown {
        screen.result(markdown(report, arguments.markdown_limit).trim_end());
    } else if !screen.is_quiet {
        screen.result(&text(report, !arguments.all));
    }
}

/// Writes the page of `--html`.
fn write_page(arguments: &DiffArguments, report: &Report, catalog: &Catalog) -> Result<(), Faults> {
    let Some(path) = &arguments.html else { return Ok(()) };
    let limits = HtmlLimits { rooms: arguments.html_rooms, ..HtmlLimits::default() };
    let chosen = report.levels.iter().zip(shown_rooms(report, limits.rooms));
    let chosen: Vec<(&LevelDiff, Vec<&RoomDiff>)> =
        chosen.map(|(level, shown)| (level, level.rooms.iter().take(shown).collect())).collect();
    let drawn = chosen.par_iter().map(|(level, rooms)| {
        let pictures = draw(arguments, level, rooms, catalog);
        let key = |room: &str| (level.building.clone(), level.level.clone(), room.to_owned());
        pictures.into_iter().map(|picture| (key(&picture.room), picture)).collect::<Vec<_>>()
    });
    let pictures: Pictures = drawn.collect::<Vec<_>>().into_iter().flatten().collect();
    write_text(path, &html(report, &pictures, limits), Overwrite::forced(arguments.force))
}

fn draw(
    arguments: &DiffArguments,
    level: &LevelDiff,
    rooms: &[&RoomDiff],
    catalog: &Catalog,
) -> Vec<RoomPictures> {
    if rooms.is_empty() {
        return Vec::new();
    }
    draw_rooms(level, rooms, &arguments.old, &arguments.new, catalog)
}

/// Writes the pictures of `--svg`: `<building>/<level>/<room>.before.svg` and `….after.svg`.
fn write_pictures(arguments: &DiffArguments, report: &Report, catalog: &Catalog) -> Result<(), Faults> {
    let Some(folder) = &arguments.svg else { return Ok(()) };
    let names = |of: fn(&LevelDiff) -> &str| {
        let ids: Vec<&str> = report.levels.iter().map(of).collect();
        distinct_names(&ids)
    };
    let (buildings, levels) = (names(|level| &level.building), names(|level| &level.level));
    let jobs: Vec<_> = report.levels.iter().zip(buildings.iter().zip(&levels)).collect();
    let write = |(level, (building, name)): &(&LevelDiff, (&String, &String))| {
        let rooms: Vec<&RoomDiff> = level.rooms.iter().collect();
        let pictures = draw(arguments, level, &rooms, catalog);
        write_level(&folder.join(building).join(name), &pictures, Overwrite::forced(arguments.force))
    };
    let written: Vec<Result<(), Faults>> = jobs.par_iter().map(write).collect();
    let mut faults = Faults::default();
    written.into_iter().filter_map(Result::err).for_each(|others| faults.merge(others));
    if faults.is_empty() { Ok(()) } else { Err(faults) }
}

fn write_level(folder: &Path, pictures: &[RoomPictures], overwrite: Overwrite) -> Result<(), Faults> {
    let ids: Vec<&str> = pictures.iter().map(|picture| picture.room.as_str()).collect();
    for (picture, name) in pictures.iter().zip(distinct_names(&ids)) {
        for (svg, side) in [(&picture.old, "before"), (&picture.new, "after")] {
            if let Some(svg) = svg {
                write_text(&folder.join(format!("{name}.{side}.svg")), svg, overwrite)?;
            }
        }
    }
    Ok(())
}
