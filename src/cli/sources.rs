//! Reads plans and configuration for all commands that need them.

use std::fs;
use std::path::{Path, PathBuf};

use super::arguments::SourceArguments;
use crate::catalog::{Catalog, builtin_files, load_catalog, load_catalog_so_far};
use crate::disk::TemporaryFolder;
use crate::document::{Fault, Faults, Warned};
use crate::edits::read_edits;
use crate::model::ModelLibrary;
use crate::plan::{PlanOptions, PlanReading, project_settings, read_plans};
use crate::project::{EditsChoice, Project, ProjectPaths};

/// The project that is baked when no path is given, below `configs/`.
const DEMO: &str = "demo.yaml";

/// Reads the catalogue, its models, then the plans; without a path those of the demo.
///
/// # Errors
/// If nothing could be read: faults of the catalogue, of the project, or of every plan.
pub(crate) fn read_sources(arguments: &SourceArguments) -> Result<Project, Faults> {
    let demo;
    let mut plans = arguments.paths.clone();
    if plans.is_empty() {
        demo = extract_demo().map_err(|error| {
            Fault::of_file(&std::env::temp_dir(), format!("cannot unpack the demo: {error}"))
        })?;
        plans.push(demo.path().join(DEMO));
    }
    let edits = match arguments.edits.no_edits {
        true => EditsChoice::Without,
        false => EditsChoice::With(arguments.edits.files.clone()),
    };
    // Folders of the command line come after those of the project: what is typed wins.
    Project::read(&ProjectPaths {
        plans,
        catalog: arguments.catalog.clone(),
        edits,
        choices: arguments.choices(),
    })
}

/// As [`read_sources`], but where that ends at the faults of some files, the others are read all the same: all faults of all
/// files come back at once.
pub(crate) fn survey_sources(arguments: &SourceArguments) -> (Option<Project>, Faults) {
    match read_sources(arguments) {
        Ok(mut sources) => {
            let faults = std::mem::take(&mut sources.faults);
            (Some(sources), faults)
        }
        Err(mut faults) => {
            faults.merge(all_faults(arguments));
            faults.sort();
            (None, faults)
        }
    }
}

fn all_faults(arguments: &SourceArguments) -> Faults {
    let (settings, mut faults) = match project_settings(&arguments.paths) {
        Ok(settings) => (Some(settings), Faults::default()),
        Err(faults) => (None, faults),
    };
    let of_projects = settings.iter().flat_map(|settings| &settings.catalog);
    let folders: Vec<PathBuf> = of_projects.chain(&arguments.catalog).cloned().collect();
    let (mut catalog, found) = load_catalog_so_far(&folders);
    let is_whole = !found.has_errors();
    faults.merge(found);
    if settings.is_none() {
        // Folders of configuration may be missing.
        catalog.room_words.accept_everything();
    }
    faults.merge(ModelLibrary::load(&catalog).err().unwrap_or_default());
    let reading = read_plans(
        &arguments.paths,
        &PlanOptions::new(&catalog.room_words).with_planning(&catalog.typologies, &arguments.choices()),
    );
    faults.merge(reading.faults);
    if is_whole && !arguments.edits.no_edits {
        faults.merge(read_edits(&reading.plan, &arguments.edits.files, &catalog).1);
    }
    faults
}

/// Reads plans for which no furniture is needed; the catalogue says what their words mean.
///
/// # Errors
/// As [`read_sources`].
pub(crate) fn read_plans_only(arguments: &SourceArguments) -> Result<PlanReading, Faults> {
    read_plans_and_catalog(arguments, |options| options).map(|(reading, _)| reading)
}

/// As [`read_plans_only`], with the catalogue that the words came from, and with other options.
///
/// # Errors
/// As there.
pub(crate) fn read_plans_and_catalog(
    arguments: &SourceArguments,
    with: impl Fn(PlanOptions<'_>) -> PlanOptions<'_>,
) -> Result<(PlanReading, Catalog), Faults> {
    let settings = project_settings(&arguments.paths)?;
    let folders: Vec<PathBuf> = settings.catalog.iter().chain(&arguments.catalog).cloned().collect();
    let Warned { value: catalog, warnings: mut faults } = load_catalog(&folders)?;
    let choices = arguments.choices();
    let options = PlanOptions::new(&catalog.room_words).with_planning(&catalog.typologies, &choices);
    let reading = read_plans(&arguments.paths, &with(options));
    faults.merge(reading.faults);
    match reading.plan.buildings.is_empty() {
        true => Err(faults),
        false => Ok((PlanReading { faults, ..reading }, catalog)),
    }
}

/// The plans inside the program as files, for as long as the answer lives.
fn extract_demo() -> std::io::Result<TemporaryFolder> {
    let folder = TemporaryFolder::new(&std::env::temp_dir(), "roomwright-demo-")?;
    for file in builtin_files() {
        let path = folder.path().join(file.path);
        if let Some(parent) = path.parent() {
            fs::create_dir_all(parent)?;
        }
        fs::write(path, file.text)?;
    }
    Ok(folder)
}

/// The style of the run: what was typed, else what the project says.
///
/// # Errors
/// If the catalogue has no such style.
pub(crate) fn run_style(typed: Option<&String>, sources: &Project) -> Result<Option<String>, Faults> {
    let catalog = &sources.catalog;
    let is_known = |style: &&String| catalog.has_style(style);
    // The project's own is reported where it is written.
    let of_project = sources.settings.style.as_ref().filter(is_known);
    let Some(style) = typed else { return Ok(of_project.cloned()) };
    match sources.level_options_in(style) {
        Ok(options) => Ok(options.style),
        Err(unknown) => {
            let fault = Fault::of_file(Path::new("--style"), unknown.fact());
            Err(fault.with_hint(unknown.hint).into())
        }
    }
}
