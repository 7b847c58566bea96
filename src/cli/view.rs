//! `view`: shows furnished buildings in a browser on this machine.

use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use serde_json::Value;

use super::arguments::{SourceArguments, TextureWord, ViewArguments};
use super::audit::level_files;
use super::bake::{cache_root, textures};
use super::edits::change_edits_file;
use super::exit::Outcome;
use super::explain::explain_room;
use super::find_room::FoundRoom;
use super::screen::Screen;
use super::sources::{read_sources, run_style};
use super::watch::{Inputs, watch_inputs};
use crate::batch::{PROGRAM, is_bake};
use crate::cache::Cache;
use crate::catalog::load_catalog;
use crate::document::{Fault, Faults, Warned};
use crate::edits::edits_path;
use crate::output::{LevelOptions, is_read_back};
use crate::plan::{PlacedBuilding, RoomRef};
use crate::project::{Project, RoomWriter};
use crate::view::{Answers, Baked, Controls, EditsChange, Server, Session, ViewSources, serve};

/// Runs the command until Ctrl-C.
pub(crate) fn run(arguments: ViewArguments, screen: Screen) -> Outcome {
    // Nothing is half written at any time.
    let is_handled = ctrlc::set_handler(|| std::process::exit(Outcome::Done as i32)).is_ok();
    match start(&arguments, screen, if is_handled { " Ctrl-C ends." } else { "" }) {
        Ok(()) => Outcome::Done,
        Err(faults) => {
            screen.faults(&faults);
            Outcome::NotStarted
        }
    }
}

fn start(arguments: &ViewArguments, screen: Screen, how_to_end: &str) -> Result<(), Faults> {
    let fault = |error: std::io::Error| {
        let message = format!("the server cannot start: {error}");
        Fault::of_file(Path::new("--port"), message).with_hint("take another port, or 0 for any that is free")
    };
    let answers: Arc<dyn Answers> = match finished_levels(&arguments.sources)? {
        Some((files, faults)) => Arc::new(baked(arguments, &files, faults, screen)?),
        None => session(arguments, screen)?,
    };
    let server = Server::listen(arguments.port).map_err(fault)?;
    let address = server.address();
    screen.result(&address);
    screen.note(&format!("The page is for this machine alone.{how_to_end}"));
    if !arguments.no_open
        && let Err(error) = open::that_detached(&address)
    {
        screen.note(&format!("No browser could be opened ({error}): open the address yourself."));
    }
    serve(server, answers).map_err(|error| fault(error).into())
}

/// The finished levels that the paths name: files of levels, and folders with a manifest; none where the paths are plans.
fn finished_levels(sources: &SourceArguments) -> Result<Option<(Vec<PathBuf>, Faults)>, Faults> {
    let is_finished = |path: &PathBuf| is_bake(path) || is_read_back(path);
    if sources.paths.is_empty() || !sources.paths.iter().all(is_finished) {
        return Ok(None);
    }
    level_files(&sources.paths).map(Some)
}

/// Finished levels; `faults` are those of the folders that they lie in.
fn baked(
    arguments: &ViewArguments,
    files: &[PathBuf],
    mut faults: Faults,
    screen: Screen,
) -> Result<Baked, Faults> {
    let Warned { value: catalog, warnings } = load_catalog(&arguments.sources.catalog)?;
    let (baked, found) = Baked::read(files, catalog)?;
    faults.merge(warnings);
    faults.merge(found);
    screen.faults(&faults);
    Ok(baked)
}

/// A project that is furnished on demand and read again when its files change.
fn session(arguments: &ViewArguments, screen: Screen) -> Result<Arc<Session>, Faults> {
    let ViewArguments { sources, furnish, textures, cache, threads, .. } = arguments.clone();
    let controls = Controls { seed: furnish.seed, style: furnish.style.clone() };
    let inputs = Arc::default();
    let files = Files {
        sources: sources.clone(),
        effort: furnish.effort,
        textures,
        cache,
        inputs: Arc::clone(&inputs),
    };
    let (mut project, options) = files.read(&controls)?;
    screen.faults(&std::mem::take(&mut project.faults));
    let threads = threads.and_then(NonZeroUsize::new);
    let threads = threads.or_else(|| std::thread::available_parallelism().ok()).unwrap_or(NonZeroUsize::MIN);
    let opened = Session::open(Box::new(files), controls, (project, options), Some(threads));
    let opened = opened.map_err(|error| {
        Fault::of_file(Path::new("--threads"), format!("the threads cannot start: {error}"))
            .with_hint("take fewer")
    })?;
    let session = Arc::new(opened);
    if !sources.paths.is_empty() {
        let session = Arc::clone(&session);
        std::thread::spawn(move || {
            let place = sources.paths.first().cloned().unwrap_or_default();
            let read = || {
                session.reload();
                lock(&inputs).clone()
            };
            // By itself: the lock would be held for as long as the call takes.
            let first = lock(&inputs).clone();
            let ended = watch_inputs(&place, first, read);
            screen.faults(&ended);
        });
    }
    Ok(session)
}

/// The files of the command line.
struct Files {
    sources: SourceArguments,
    effort: u32,
    textures: TextureWord,
    cache: Option<PathBuf>,
    /// What was read last, faulty or not.
    inputs: Arc<Mutex<Inputs>>,
}

fn lock(inputs: &Mutex<Inputs>) -> MutexGuard<'_, Inputs> {
    inputs.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Files {
    fn cache(&self) -> Option<Cache> {
        cache_root(self.cache.clone()).map(|root| Cache::new(&root, PROGRAM))
    }
}

impl ViewSources for Files {
    fn read(&self, controls: &Controls) -> Result<(Project, LevelOptions), Faults> {
        let read = read_sources(&self.sources.seeded(controls.seed));
        let seen = read.as_ref().map(|project| (&project.plan, &project.faults));
        *lock(&self.inputs) = Inputs::of_reading(&self.sources, seen);
        let mut project = read?;
        project.models = project.models.with_cache(self.cache());
        let style = run_style(controls.style.as_ref(), &project)?;
        let defaults = project.level_options();
        let seed = controls.seed.unwrap_or(defaults.seed);
        let textures = textures(self.textures, true);
        let options = LevelOptions { seed, style, effort: self.effort, textures, ..defaults }.shared();
        Ok((project, options))
    }

    fn explain(
        &self,
        project: &Project,
        options: &LevelOptions,
        building: &PlacedBuilding,
        at: RoomRef<'_>,
    ) -> Option<Value> {
        Some(explain_room(project, FoundRoom { placed: building, at }, options))
    }

    fn change_edits(
        &self,
        project: &Project,
        building: &str,
        change: &EditsChange<'_>,
    ) -> Result<PathBuf, Faults> {
        // Files that were named win over those beside plans, the last of them over all.
        let named = self.sources.edits.files.last().cloned();
        let beside = || {
            let placed = project.plan.buildings.iter().find(|placed| placed.id == building)?;
            let source = &placed.source;
            Some(edits_path(source.project.as_ref().unwrap_or(&source.plan)))
        };
        let unknown = || Fault::of_file(Path::new(building), "there is no such building");
        let file = named.or_else(beside).ok_or_else(unknown)?;
        change_edits_file(&file, change)?;
        Ok(file)
    }

    fn is_editable(&self) -> bool {
        // The demo has no files that stay.
        !self.sources.paths.is_empty() && !self.sources.edits.no_edits
    }

    fn writer(&self, project: &Project, options: &LevelOptions) -> RoomWriter {
        RoomWriter::new(&project.catalog, options, self.cache())
    }
}
