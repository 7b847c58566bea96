//! `bake`: turns the arguments into a run, then runs it.

use std::path::{Path, PathBuf};
use std::time::Instant;

use super::arguments::{
    BakeArguments, DetailWord, LightsWord, NormalsWord, PartsWord, ProfileWord, ProgressWord, RunArguments,
    TextureWord,
};
use super::exit::Outcome;
use super::leftovers::leftovers_text;
use super::level_lists::{list_levels, shares_without_index};
use super::progress::Progress;
use super::reroll::reroll;
use super::room_styles::check_room_styles;
use super::screen::Screen;
use super::sources::{read_sources, run_style};
use super::summary::{bake_answer, failure_text, summary_text, timing_text, where_to_look};
use super::watch::watch;
use crate::batch::{
    BakeInput, BakeOptions, BakeReport, ChosenLevels, LevelList, LevelMisfit, Observer, OutputFault,
    OutputFolder, PROGRAM, Unplanned, bake, record_plans,
};
use crate::cache::Cache;
use crate::document::{Fault, Faults, counted};
use crate::edits::distinct_misfits;
use crate::gltf::FlatNormals;
use crate::model::Detail;
use crate::output::{Format, IndexOptions, LevelOptions, TextureOptions};
use crate::project::Project;
use crate::scene::{Lights, Parts, SceneOptions};
use crate::texture::TextureSize;

/// Most failures that are listed one by one.
const LISTED_FAILURES: usize = 20;

/// Endings of files that users may expect `--out` to name.
const OTHER_RESULTS: [&str; 5] = ["usd", "usda", "usdc", "usdz", "zip"];

/// Seed of runs without a seed of their own.
pub(crate) const DEFAULT_SEED: u64 = 1;

/// The meaning of a command line.
pub(super) struct Run {
    pub(super) sources: Project,
    pub(super) options: BakeOptions,
    cache_root: Option<PathBuf>,
    is_forced: bool,
    pub(super) teller: Teller,
}

/// What has to be known to tell how the work goes.
pub(super) struct Teller {
    pub(super) out: PathBuf,
    pub(super) format: Format,
    pub(super) is_demo: bool,
    pub(super) progress: ProgressWord,
    pub(super) has_input_faults: bool,
}

/// The work itself.
pub(super) type Work<'w> = dyn Fn(&Observer<'_>) -> Result<BakeReport, OutputFault> + 'w;

/// Runs the command, once or again and again.
pub(crate) fn run(arguments: BakeArguments, screen: Screen) -> Outcome {
    if arguments.watch { watch(&arguments, screen) } else { bake_once(arguments, screen) }
}

/// Bakes.
pub(super) fn bake_once(arguments: BakeArguments, screen: Screen) -> Outcome {
    let level = LevelOptions {
        format: match arguments.profile {
            ProfileWord::Any => arguments.format,
            ProfileWord::Web => Format::named("web").expect("the table has this format"),
        },
        has_shared_library: arguments.shared_library,
        textures: textures(arguments.run.textures, arguments.shared_textures),
        flat_normals: flat_normals(arguments.flat_normals, arguments.run.textures),
        detail: match arguments.detail {
            DetailWord::Full => Detail::Full,
            DetailWord::Reduced => Detail::Reduced,
            DetailWord::Boxes => Detail::Boxes,
        },
        scene: scene_options(&arguments),
        ..LevelOptions::default()
    };
    write_levels(
        Request { run: arguments.run, out: arguments.out, level, index: IndexOptions::default() },
        screen,
    )
}

/// What is to be written, and how. Seed, style and effort of `level` are those of `run`, and the origin of `index` is that of the
/// project where it has none.
pub(super) struct Request {
    pub(super) run: RunArguments,
    pub(super) out: PathBuf,
    pub(super) level: LevelOptions,
    pub(super) index: IndexOptions,
}

/// Looks whether a folder can be written into: everything that can be refused is refused before the first second of work.
///
/// # Errors
/// The end of the command, which has been told.
pub(super) fn check_folder(out: &Path, screen: Screen) -> Result<(), Outcome> {
    if let Some(fault) = file_as_folder(out) {
        screen.faults(&fault.into());
        return Err(Outcome::NotStarted);
    }
    OutputFolder::check(out).map_err(|fault| refuse(screen, &fault))
}

/// Writes levels: the work of `bake` and `tiles`.
pub(super) fn write_levels(request: Request, screen: Screen) -> Outcome {
    if let Some(fault) = shares_without_index(&request) {
        screen.faults(&fault.into());
        return Outcome::NotStarted;
    }
    if request.run.list_levels {
        return list_levels(request, screen);
    }
    if let Err(outcome) = check_folder(&request.out, screen) {
        return outcome;
    }
    let run = match understand(request, screen) {
        Ok(run) => run,
        Err(outcome) => return outcome,
    };
    match OutputFolder::open(&run.teller.out, run.is_forced) {
        Ok(folder) => {
            show_listed(folder.faults(), screen);
            screen.note(&announcement(&run));
            let Project { plan, edits, catalog, models, .. } = &run.sources;
            let input = BakeInput { plan, edits, catalog, models, options: &run.options };
            let outcome = work(&run.teller, &|observer| bake(&input, &folder, observer), screen);
            note_plans(&run);
            outcome
        }
        Err(fault) => refuse(screen, &fault),
    }
}

/// A fault if the output folder has the name of a file that users may expect instead.
fn file_as_folder(out: &Path) -> Option<Fault> {
    let ending = out.extension()?.to_str()?.to_ascii_lowercase();
    let is_result = Format::named(&ending).is_some() || OTHER_RESULTS.contains(&ending.as_str());
    let is_file_name = is_result && !out.is_dir();
    is_file_name.then(|| {
        let hint = format!("name a folder, for example --out {}", out.with_extension("").display());
        Fault::of_file(out, "is the name of a file; a bake writes a file for each level into a folder")
            .with_hint(hint)
    })
}

/// From what was typed to what it means.
pub(super) fn understand(request: Request, screen: Screen) -> Result<Run, Outcome> {
    let Request { run: arguments, out, level, index } = request;
    let refused = |faults: Faults| {
        screen.faults(&faults);
        Outcome::NotStarted
    };
    let chosen = |file: PathBuf| LevelList::read(&file).map(|list| ChosenLevels { file, list });
    let only_levels = arguments.only_levels.clone().map(chosen).transpose().map_err(refused)?;
    let is_demo = arguments.sources.paths.is_empty();
    let read = read_sources(&arguments.sources.seeded(arguments.furnish.seed)).and_then(|sources| {
        let style = run_style(arguments.furnish.style.as_ref(), &sources)?;
        Ok((sources, style))
    });
    let (mut sources, style) = read.map_err(refused)?;
    let style_faults = check_room_styles(&sources.plan, &sources.catalog);
    sources.faults.merge(style_faults);
    screen.faults(&sources.faults);
    let seed = arguments.furnish.seed.or(sources.settings.seed).unwrap_or(DEFAULT_SEED);
    for room in &arguments.reroll {
        let rolled = reroll(&sources.plan, &mut sources.edits, seed, room, "--reroll").map_err(refused)?;
        screen.note(&rolled.to_string());
    }
    let cache_root = cache_root(arguments.cache.clone());
    let cache = cache_root.as_deref().map(|root| Cache::new(root, PROGRAM));
    sources.models = sources.models.with_cache(cache.clone());
    let origin = index.origin.or_else(|| sources.settings.origin.clone());
    let options = BakeOptions {
        level: LevelOptions { seed, style, effort: arguments.furnish.effort, ..level },
        index: IndexOptions { origin, ..index },
        threads: threads(arguments.threads),
        shard: arguments.shard,
        only_levels,
        unplanned: unplanned(arguments.prune, &sources.faults, screen),
        cache,
    };
    let has_input_faults = sources.faults.has_errors();
    Ok(Run {
        sources,
        options,
        cache_root,
        is_forced: arguments.force,
        teller: Teller { out, format: level.format, is_demo, progress: arguments.progress, has_input_faults },
    })
}

/// The threads that were asked for, or one for each core.
pub(super) fn threads(asked: Option<u16>) -> usize {
    let cores = || std::thread::available_parallelism().map_or(1, usize::from);
    asked.map_or_else(cores, usize::from)
}

/// The treatment of levels that the plans do not have. They are not known while some plans cannot be read.
fn unplanned(is_pruned: bool, faults: &Faults, screen: Screen) -> Unplanned {
    match (is_pruned, faults.has_errors()) {
        (false, false) => Unplanned::SetApart,
        (true, false) => Unplanned::Removed,
        (false, true) => Unplanned::Listed,
        (true, true) => {
            screen.error(
                "nothing is pruned while plans have errors: the files may belong to a plan that cannot be read",
            );
            Unplanned::Listed
        }
    }
}

fn scene_options(arguments: &BakeArguments) -> SceneOptions {
    SceneOptions {
        lights: match arguments.lights {
            LightsWord::Shining => Lights::Shining,
            LightsWord::Physical => Lights::Physical,
            LightsWord::None => Lights::Off,
        },
        parts: match arguments.parts {
            PartsWord::Merged => Parts::Merged,
            PartsWord::Separate => Parts::Separate,
        },
        door_angle: arguments.run.door_angle,
        has_variants: arguments.variants,
    }
}

/// The folder for textures, models and notes, if there is one.
pub(super) fn cache_root(typed: Option<PathBuf>) -> Option<PathBuf> {
    // A variable that is empty says as little as one that is not set.
    let typed = typed.filter(|root| !root.as_os_str().is_empty());
    typed.or_else(Cache::default_root).filter(|root| root.as_os_str() != "none")
}

pub(super) fn textures(word: TextureWord, are_shared: bool) -> TextureOptions {
    let size = match word {
        TextureWord::None => None,
        TextureWord::Small => Some(TextureSize::Small),
        TextureWord::Large => Some(TextureSize::Large),
    };
    TextureOptions { size, are_shared }
}

/// Users who leave out textures want small files.
fn flat_normals(word: Option<NormalsWord>, textures: TextureWord) -> FlatNormals {
    match word {
        Some(NormalsWord::Written) => FlatNormals::Written,
        Some(NormalsWord::Implied) => FlatNormals::Implied,
        None if textures == TextureWord::None => FlatNormals::Implied,
        None => FlatNormals::Written,
    }
}

pub(super) fn refuse(screen: Screen, fault: &OutputFault) -> Outcome {
    show_fault(screen, fault);
    Outcome::NotStarted
}

fn show_fault(screen: Screen, fault: &OutputFault) {
    screen.error(&format!("error[{}]: {fault}", fault.code.name()));
    if let Some(hint) = &fault.hint {
        screen.error(&format!("  hint: {hint}"));
    }
}

/// Writes, and tells what came of it.
pub(super) fn work(teller: &Teller, write: &Work<'_>, screen: Screen) -> Outcome {
    let started = Instant::now();
    let progress = Progress::new(teller.progress, screen.is_quiet);
    let report = match write(&|event| progress.observe(event)) {
        Ok(report) => report,
        Err(fault) => return refuse(screen, &fault),
    };
    progress.finish(&report);
    let elapsed = started.elapsed();

    show_failures(&report, screen);
    show_misfits(&report, screen);
    if screen.is_json {
        screen.json(&bake_answer(&report, &teller.out));
    } else if !screen.is_quiet {
        screen.result(&summary_text(&report, elapsed));
        screen.result(&where_to_look(&report, &teller.out, teller.format));
        if teller.is_demo {
            screen.result(NEXT_STEPS);
        }
    }
    if let Some(text) = leftovers_text(&report.leftovers, &teller.out) {
        screen.note(&text);
    }
    if report.baked > 0 {
        screen.note(&timing_text(&report));
    }
    outcome(teller, &report)
}

/// Notes where the plans of the folder lie.
fn note_plans(run: &Run) {
    // The demo's plans are gone when the program ends.
    if let Some(cache) = run.cache_root.as_ref().filter(|_| !run.teller.is_demo) {
        // Where nothing can be noted, `edits` asks for the file.
        let _ = record_plans(cache, &run.teller.out, &run.sources.plan);
    }
}

fn announcement(run: &Run) -> String {
    let Run { sources, options, teller: Teller { out, is_demo, .. }, .. } = run;
    let levels: usize = sources.plan.buildings.iter().map(|placed| placed.building.levels.len()).sum();
    let what = if *is_demo { "the built-in demo: " } else { "" };
    format!(
        "Baking {what}{} of {} into {} (seed {}, {}).",
        counted(levels, "level"),
        counted(sources.plan.buildings.len(), "building"),
        out.display(),
        options.level.seed,
        counted(options.threads, "thread"),
    )
}

fn show_failures(report: &BakeReport, screen: Screen) {
    for failure in report.failures.iter().take(LISTED_FAILURES) {
        screen.error(&failure_text(failure));
    }
    if report.failures.len() > LISTED_FAILURES {
        let more = report.failures.len() - LISTED_FAILURES;
        screen.error(&format!("… and {more} more failures; --json lists all"));
    }
    if let Err(fault) = &report.joined {
        show_fault(screen, fault);
    }
}

/// Shows the first of many faults.
pub(super) fn show_listed(faults: &Faults, screen: Screen) {
    let listed = faults.0.iter().take(LISTED_FAILURES).cloned().collect();
    screen.faults(&Faults(listed));
    if faults.0.len() > LISTED_FAILURES {
        screen.note(&format!("… and {} more faults of records", faults.0.len() - LISTED_FAILURES));
    }
}

/// Each rejected edit once, however many rooms one line of an edits file is for.
fn show_misfits(report: &BakeReport, screen: Screen) {
    let told = distinct_misfits(report.misfits.iter().map(|LevelMisfit { misfit, .. }| misfit));
    screen.faults(&Faults(told.0.iter().take(LISTED_FAILURES).cloned().collect()));
    if told.0.len() > LISTED_FAILURES {
        let more = told.0.len() - LISTED_FAILURES;
        screen.error(&format!("… and {more} more rejected edits; --json lists all"));
    }
}

/// Commands to try after the demo.
const NEXT_STEPS: &str = "\
Open a .glb in Blender or any glTF viewer, or try next:
  roomwright draw --out drawings         the same levels as SVG
  roomwright bake --seed 2 --out out2    the same plans with other arrangements
  roomwright bake PLAN.yaml --out out    your own plan; `roomwright check PLAN.yaml` reports its faults
  roomwright catalog rooms               the room types and their furniture";

fn outcome(teller: &Teller, report: &BakeReport) -> Outcome {
    let nothing_done = report.baked + report.kept == 0 && !report.failures.is_empty();
    if nothing_done {
        return Outcome::NotStarted;
    }
    let has_unmade_edits = report.in_place.misfits > 0;
    let has_failures =
        teller.has_input_faults || has_unmade_edits || !report.failures.is_empty() || report.joined.is_err();
    Outcome::of_failures(has_failures || report.skipped > 0)
}
