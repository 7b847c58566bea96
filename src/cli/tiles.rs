//! `tiles`: 3D Tiles of plans, or of a finished bake.

use super::arguments::{InstancingWord, Near, RunArguments, TilesArguments};
use super::bake::{
    Request, Teller, check_folder, refuse, show_listed, textures, threads, work, write_levels,
};
use super::exit::Outcome;
use super::screen::Screen;
use crate::batch::{BakeOptions, FinishedInput, OutputFolder, Unplanned, is_bake, write_finished};
use crate::catalog::load_catalog;
use crate::compact::Instancing;
use crate::document::Fault;
use crate::model::ModelLibrary;
use crate::output::{Format, IndexOptions, LevelOptions};
use crate::plan::SiteOrigin;
use crate::scene::SceneOptions;

/// The word of the format in the table.
const FORMAT: &str = "tiles";

/// Runs the command.
pub(crate) fn run(arguments: TilesArguments, screen: Screen) -> Outcome {
    let TilesArguments { run, out, near: Near(near), origin, heading, instancing } = arguments;
    let heading = heading.unwrap_or(0.0).to_radians();
    let origin = origin.map(|origin| SiteOrigin { heading, ..origin });
    let level = LevelOptions {
        format: Format::named(FORMAT).expect("the table has this format"),
        textures: textures(run.textures, true),
        scene: SceneOptions { door_angle: run.door_angle, ..SceneOptions::default() },
        instancing: match instancing {
            InstancingWord::Gpu => Instancing::Gpu,
            InstancingWord::None => Instancing::None,
        },
        ..LevelOptions::default()
    };
    let request = Request { run, out, level, index: IndexOptions { near, origin } };
    let paths = &request.run.sources.paths;
    match paths.iter().filter(|path| is_bake(path)).count() {
        0 => write_levels(request, screen),
        1 if paths.len() == 1 => write_bake(request, screen),
        _ => {
            let fault = Fault::of_file(
                &paths[0],
                "finished bakes are written one by one, and not together with plans",
            );
            screen.faults(&fault.with_hint("name one folder").into());
            Outcome::NotStarted
        }
    }
}

/// Writes the levels of a finished bake as they are.
fn write_bake(request: Request, screen: Screen) -> Outcome {
    let Request { run, out, level, index } = request;
    let bake = &run.sources.paths[0];
    if let Err(outcome) = check_folder(&out, screen) {
        return outcome;
    }
    if let Some(fault) = inapplicable(&run) {
        screen.faults(&fault.into());
        return Outcome::NotStarted;
    }
    let is_same =
        bake.canonicalize().ok().is_some_and(|bake| out.canonicalize().is_ok_and(|out| out == bake));
    if is_same {
        let fault = Fault::of_file(&out, "is the folder of the bake itself");
        screen.faults(&fault.with_hint("name another folder with --out").into());
        return Outcome::NotStarted;
    }
    // Formats ask for a catalogue, but what stands in the levels is in their files.
    let catalog = match load_catalog(&run.sources.catalog) {
        Ok(loaded) => loaded.value,
        Err(faults) => {
            screen.faults(&faults);
            return Outcome::NotStarted;
        }
    };
    let models = match ModelLibrary::load(&catalog) {
        Ok(models) => models,
        Err(faults) => {
            screen.faults(&faults);
            return Outcome::NotStarted;
        }
    };
    let options = BakeOptions {
        level,
        index,
        threads: threads(run.threads),
        shard: run.shard,
        only_levels: None,
        unplanned: if run.prune { Unplanned::Removed } else { Unplanned::SetApart },
        cache: None,
    };
    let folder = match OutputFolder::open(&out, run.force) {
        Ok(folder) => folder,
        Err(fault) => return refuse(screen, &fault),
    };
    show_listed(folder.faults(), screen);
    screen.note(&format!("Writing the levels of {} as tiles into {}.", bake.display(), out.display()));
    let input = FinishedInput { bake, catalog: &catalog, models: &models, options: &options };
    let teller = Teller {
        out: out.clone(),
        format: options.level.format,
        is_demo: false,
        progress: run.progress,
        has_input_faults: false,
    };
    work(&teller, &|observer| write_finished(&input, &folder, observer), screen)
}

/// A fault if the user asks for other rooms than those of the bake.
fn inapplicable(run: &RunArguments) -> Option<Fault> {
    let asked = [
        ("--seed", run.furnish.seed.is_some()),
        ("--style", run.furnish.style.is_some()),
        ("--reroll", !run.reroll.is_empty()),
        ("--edits", !run.sources.edits.files.is_empty()),
        ("--door-angle", run.door_angle.is_some()),
        ("--list-levels", run.list_levels),
        ("--only-levels", run.only_levels.is_some()),
    ];
    let (option, _) = asked.into_iter().find(|(_, is_asked)| *is_asked)?;
    let message = format!("is a finished bake, which is written as it is: {option} does not apply");
    let hint = "name the plans instead, or bake them again with it";
    Some(Fault::of_file(&run.sources.paths[0], message).with_hint(hint))
}
