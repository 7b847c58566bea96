//! `edits`: writes changes by hand into the file beside the plan.

use crate::contract::RoomId;
use std::path::{Path, PathBuf};

use super::answer::EditsAnswer;
use super::arguments::{EditsCommand, SourceArguments};
use super::bake::{DEFAULT_SEED, cache_root};
use super::exit::Outcome;
use super::reroll::{Rolled, reroll};
use super::screen::Screen;
use super::sources::read_plans_only;
use super::update::update_text;
use crate::batch::{distinct_names, recorded_plan};
use crate::catalog::load_catalog;
use crate::document::{Fault, Faults, printable};
use crate::edits::{
    Captured, EDITS_ENDING, EditsFile, RoomEntry, capture, edits_path, lock_objects, merge, read_edits,
    read_edits_file, write_edits,
};
use crate::plan::{PlanReading, project_settings};
use crate::read_back::{Survey, parse_survey, read_bytes};

/// New edits, where they go, and what else is to be said.
struct NewEdits {
    file: PathBuf,
    entries: Vec<RoomEntry>,
    notes: Faults,
}

/// Runs the command.
pub(crate) fn run(command: EditsCommand, screen: Screen) -> Outcome {
    let done = find(command).and_then(|found| {
        screen.faults(&found.notes);
        write(&found)?;
        report(&found, screen);
        Ok(Outcome::of_failures(!found.notes.is_empty()))
    });
    done.unwrap_or_else(|faults| {
        screen.faults(&faults);
        Outcome::NotStarted
    })
}

fn find(command: EditsCommand) -> Result<NewEdits, Faults> {
    match command {
        EditsCommand::Capture { old, edited, edits, cache, catalog } => {
            let catalog = load_catalog(&catalog)?.value;
            let (before, after) = (survey(&old)?, survey(&edited)?);
            let Captured { entries, notes } = capture(&before, &after, &catalog, &edited)?;
            Ok(NewEdits { file: file_of(edits, cache, &old, &after)?, entries, notes })
        }
        EditsCommand::Lock { floor, room, objects, edits, cache } => {
            let survey = survey(&floor)?;
            let entry =
                lock_objects(&survey, &room, &objects).map_err(|message| Fault::of_file(&floor, message))?;
            let file = file_of(edits, cache, &floor, &survey)?;
            Ok(NewEdits { file, entries: vec![entry], notes: Faults::default() })
        }
        EditsCommand::Reroll { plan, room, to, edits, catalog } => {
            let file = edits.unwrap_or_else(|| edits_path(&plan));
            let entry = rolled(&plan, catalog, &file, &room, to)?;
            Ok(NewEdits { file, entries: vec![entry], notes: Faults::default() })
        }
    }
}

/// The entry with the next seed of a room, or the one that was asked for.
fn rolled(
    plan: &Path,
    catalog: Vec<PathBuf>,
    file: &Path,
    room: &str,
    to: Option<u64>,
) -> Result<RoomEntry, Faults> {
    let paths = vec![plan.to_owned()];
    let run_seed = project_settings(&paths)?.seed.unwrap_or(DEFAULT_SEED);
    let known = load_catalog(&catalog)?.value;
    let PlanReading { plan: read, .. } =
        read_plans_only(&SourceArguments { paths, catalog, ..SourceArguments::default() })?;
    let named: Vec<PathBuf> = [file.to_owned()].into_iter().filter(|file| file.exists()).collect();
    let (mut book, faults) = read_edits(&read, &named, &known);
    if faults.has_errors() {
        return Err(faults);
    }
    let Rolled { room: RoomId { building, level, room }, seed } =
        reroll(&read, &mut book, run_seed, room, "ROOM")?;
    let seed = Some(to.unwrap_or(seed));
    Ok(RoomEntry { building: Some(building), level, room, seed, ..RoomEntry::default() })
}

fn survey(path: &Path) -> Result<Survey, Faults> {
    Ok(parse_survey(path, &read_bytes(path)?)?)
}

/// The file that was named, else the one beside the plan or project that a level was baked from.
///
/// # Errors
/// If the plan is not known.
fn file_of(
    named: Option<PathBuf>,
    cache: Option<PathBuf>,
    floor: &Path,
    survey: &Survey,
) -> Result<PathBuf, Faults> {
    if let Some(named) = named {
        return Ok(named);
    }
    let noted = cache_root(cache).and_then(|cache| recorded_plan(&cache, floor, &survey.building));
    let Some(plan) = noted else {
        let fault =
            Fault::of_file(floor, format!("the plan of building \"{}\" is not known", survey.building));
        let name = distinct_names(&[survey.building.as_str()]).remove(0) + EDITS_ENDING;
        let hint = format!(
            "name a level where `roomwright bake` wrote it, or the file beside the plan: --edits plans/{name}"
        );
        return Err(fault.with_hint(hint).into());
    };
    let file = edits_path(&plan);
    let here = std::env::current_dir().and_then(|here| here.canonicalize());
    let below_here = here.ok().and_then(|here| Some(file.strip_prefix(here).ok()?.to_owned()));
    Ok(below_here.unwrap_or(file))
}

/// Adds the edits to what the file says already.
fn write(found: &NewEdits) -> Result<(), Faults> {
    if found.entries.is_empty() {
        return Ok(());
    }
    change_edits_file(&found.file, &|known| Ok(merge(known, found.entries.clone())))
}

/// Changes an edits file, which need not be there yet.
///
/// # Errors
/// Those of `change`, and if the file cannot be read or written.
pub(super) fn change_edits_file(
    path: &Path,
    change: &dyn Fn(Option<EditsFile>) -> Result<EditsFile, Faults>,
) -> Result<(), Faults> {
    update_text(path, || {
        let known = if path.exists() { Some(read_edits_file(path)?) } else { None };
        Ok(write_edits(&change(known)?))
    })
}

fn report(found: &NewEdits, screen: Screen) {
    let NewEdits { file, entries, notes } = found;
    if screen.is_json {
        let notes = notes.0.iter().map(|note| note.message.clone()).collect();
        return screen.json(&EditsAnswer { file: file.display().to_string(), edits: entries, notes });
    }
    if screen.is_quiet {
        return;
    }
    for entry in entries {
        let seed = entry.seed.map(|seed| format!("seed {seed}"));
        let objects = entry.objects.keys().cloned();
        let what: Vec<String> = seed.into_iter().chain(objects).collect();
        screen.result(&printable(&format!("{}/{}: {}", entry.level, entry.room, what.join(", "))));
    }
    screen.result(&match entries.is_empty() {
        true => "Nothing was changed.".to_owned(),
        false => format!("Written to {}: every bake of its plan applies these edits.", file.display()),
    });
}
