//! `import`: converts foreign plans to native ones.

use std::path::{Path, PathBuf};

use super::answer::{ImportAnswer, ImportedAnswer, fault_answers};
use super::arguments::{ImportArguments, MapArguments, SourceArguments};
use super::exit::Outcome;
use super::files::{Overwrite, write_text};
use super::import_report;
use super::kept_furniture::{FurnitureKeeper, KeptFile};
use super::screen::Screen;
use super::sources::read_plans_and_catalog;
use crate::batch::distinct_names;
use crate::document::{Fault, Faults, counted, printable};
use crate::plan::{InputReport, Level, PlacedBuilding, PlanOptions, PlanReading, write_native};

/// Endings of formats that users may expect instead of YAML.
const OTHER_ENDINGS: [&str; 9] = ["json", "geojson", "dxf", "dwg", "ifc", "svg", "glb", "gltf", "zip"];

/// One building and where it goes.
struct Target<'a> {
    placed: &'a PlacedBuilding,
    path: PathBuf,
}

/// A plan that was written.
struct Written<'a> {
    target: &'a Target<'a>,
    /// Its furniture, if some was kept.
    kept: Option<KeptFile>,
}

/// Runs the command.
pub(crate) fn run(arguments: ImportArguments, screen: Screen) -> Outcome {
    let ImportArguments { paths, out, force, catalog, keep_furniture, only, scale, report: is_report_wanted } =
        arguments;
    let map = MapArguments { only, scale, ..MapArguments::default() };
    let sources = SourceArguments { paths, catalog, map, ..SourceArguments::default() };
    let read = read_plans_and_catalog(&sources, |options| PlanOptions {
        keeps_furniture: keep_furniture,
        is_for_writing: true,
        ..options
    });
    let (PlanReading { plan, mut faults, reports, furniture, .. }, catalog) = match read {
        Ok(read) => read,
        Err(faults) => {
            screen.faults(&faults);
            return Outcome::NotStarted;
        }
    };
    let targets = match targets(&plan.buildings, &out) {
        Ok(targets) => targets,
        Err(faults) => {
            screen.faults(&faults);
            return Outcome::NotStarted;
        }
    };
    let mut furniture =
        FurnitureKeeper::new(&catalog, sources.choices(), Overwrite::forced(force), furniture);
    let mut written = Vec::new();
    for target in &targets {
        let text = write_native(&target.placed.building, &target.placed.id);
        if let Err(fault) = write_text(&target.path, &text, Overwrite::forced(force)) {
            faults.merge(fault);
            continue;
        }
        let kept = keep_furniture.then(|| furniture.keep(target.placed, &target.path, &mut faults));
        written.push(Written { target, kept: kept.flatten() });
    }
    screen.faults(&faults);
    let reports = is_report_wanted.then_some(&reports[..]);
    report(&written, &faults, reports, screen);
    match written.is_empty() {
        true => Outcome::NotStarted,
        false => Outcome::of_failures(faults.has_errors()),
    }
}

/// A file for each building: `out` itself if it is named like a plan, else a file in it.
fn targets<'a>(buildings: &'a [PlacedBuilding], out: &Path) -> Result<Vec<Target<'a>>, Faults> {
    if let Some(fault) = other_format(out) {
        return Err(fault.into());
    }
    let is_file = out.extension().is_some_and(|extension| extension == "yaml" || extension == "yml");
    match buildings {
        [placed] if is_file => Ok(vec![Target { placed, path: out.to_owned() }]),
        _ if is_file => {
            let message = format!("is one file, but {} buildings were read", buildings.len());
            Err(Fault::of_file(out, message).with_hint("name a folder with --out").into())
        }
        _ => {
            let ids: Vec<&str> = buildings.iter().map(|placed| placed.id.as_str()).collect();
            let path = |name: String| out.join(format!("{name}.yaml"));
            let names = distinct_names(&ids).into_iter().map(path);
            Ok(buildings.iter().zip(names).map(|(placed, path)| Target { placed, path }).collect())
        }
    }
}

/// A fault if the result is called like a file of another format than the one that is written.
fn other_format(out: &Path) -> Option<Fault> {
    let ending = out.extension()?.to_str()?.to_ascii_lowercase();
    let is_other = OTHER_ENDINGS.contains(&ending.as_str()) && !out.is_dir();
    is_other.then(|| {
        let hint = format!("write --out {}, or name a folder", out.with_extension("yaml").display());
        Fault::of_file(out, format!("plans are written as YAML, not as .{ending}")).with_hint(hint)
    })
}

/// The files written, and the reports of the readers if requested.
fn report(written: &[Written<'_>], faults: &Faults, reports: Option<&[InputReport]>, screen: Screen) {
    let counts = |written: &Written<'_>| {
        let levels = &written.target.placed.building.levels;
        let sum = |count: fn(&Level) -> usize| levels.iter().map(count).sum::<usize>();
        (levels.len(), sum(|level| level.rooms.len()), sum(|level| level.openings.len()))
    };
    if screen.is_json {
        let building = |written: &Written<'_>| {
            let (levels, rooms, openings) = counts(written);
            let path = written.target.path.display().to_string();
            let edits = written.kept.as_ref().map(KeptFile::answer);
            ImportedAnswer { id: written.target.placed.id.clone(), path, levels, rooms, openings, edits }
        };
        let buildings = written.iter().map(building).collect();
        screen.json(&ImportAnswer { buildings, faults: fault_answers(faults), report: reports });
        return;
    }
    for written in written {
        let (levels, rooms, openings) = counts(written);
        let path = written.target.path.display();
        screen.note(&printable(&format!(
            "{path}: {}, {}, {}",
            counted(levels, "level"),
            counted(rooms, "room"),
            counted(openings, "opening")
        )));
        if let Some(kept) = &written.kept {
            screen.note(&printable(&kept.in_words()));
        }
    }
    for report in reports.into_iter().flatten() {
        screen.result(&import_report::text(report));
    }
}
