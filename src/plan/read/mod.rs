//! Reads files as buildings: one reader for each format, and the code that they share. `readers.rs` says how to add a reader.

pub(crate) mod archilyse;
mod drawn;
#[cfg(test)]
mod example;
mod finish;
mod fit_ids;
pub(crate) mod footprint;
mod foreign;
mod geojson;
mod honeybee;
pub(crate) mod ifc;
pub(crate) mod imdf;
mod indoor;
mod inputs;
mod names;
pub(crate) mod native;
mod nothing;
mod oriented;
mod osm;
pub(crate) mod outlines;
mod project;
mod reader;
mod readers;
#[cfg(test)]
pub(super) mod real_data;
mod recentred;
mod resplan;
mod rings;
mod room_names;
mod sample;
mod solids;
mod straight;
mod sweet_home;
mod swiss_dwellings;
mod told;
mod unread;
mod walled;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use rayon::prelude::*;

use self::finish::{Drafted, Finished, Provenance, Variation, finish};
#[cfg(test)]
pub(crate) use {native::PlanFile, project::ProjectFile};

pub use self::drawn::DrawnPiece;
pub(crate) use self::finish::finish_draft;
use self::fit_ids::{fit_building_id, fit_ids};
pub(crate) use self::footprint::{Projection, SiteNotes, code_of};
use self::inputs::{Input, find_inputs};
use self::native::{NativeDraft, read_native};
pub(crate) use self::outlines::PlannedSite;
pub use self::reader::ReadFormat;
use self::reader::{DraftedBuilding, ReadBuildings};
use self::readers::FOREIGN_FORMATS;
pub use self::readers::{drawn_furniture, read_formats};
pub use self::unread::unread_formats;
use super::{
    BuildingReport, InputReport, PlacedBuilding, Plan, PlanOptions, PlanReading, PlanSource, ProjectSettings,
    RoomWords, SiteOrigin, SitePlacement,
};
use crate::document::{Fault, Faults, Source, first_of_each_kind};

/// Reads all plans that paths name: native plans, projects, foreign plans, folders and patterns of them.
///
/// One bad file does not stop the others. The answer does not depend on the order of `paths`: buildings are
/// sorted by id, faults by file and place. Files are read in parallel.
#[must_use]
pub fn read_plans(paths: &[PathBuf], options: &PlanOptions<'_>) -> PlanReading {
    let (inputs, mut faults) = find_inputs(paths);
    let readings: Vec<_> = inputs.par_iter().map(|input| read_input(input, options)).collect();
    let (mut buildings, mut reports, mut origins) = (Vec::new(), Vec::new(), Vec::new());
    let mut furniture = BTreeMap::new();
    for (reading, input) in readings.into_iter().zip(&inputs) {
        furniture.extend(reading.furniture.map(|pieces| (input.path.clone(), pieces)));
        origins.push(reading.origin);
        buildings.extend(reading.buildings);
        faults.merge(reading.faults);
        reports.extend(reading.report);
    }
    let plan = Plan { buildings: unique(buildings, &mut faults) };
    if plan.buildings.is_empty() && faults.is_empty() {
        paths.iter().for_each(|path| faults.merge(nothing::of_path(path)));
    }
    faults.sort();
    // Several files stand on planes of their own: then nothing is said of where on the earth they are.
    let origin = if let [origin] = origins.as_mut_slice() { origin.take() } else { None };
    PlanReading { plan, faults, reports, origin, furniture }
}

/// As [`read_plans`], of one plan in YAML or JSON that is in memory; the name of its source is the file of its faults.
#[must_use]
pub fn parse_plan(source: Source, options: &PlanOptions<'_>) -> PlanReading {
    let path = source.file().to_owned();
    let reading: Reading = match kind_of(&source) {
        Kind::Project => {
            let fault = Fault::of_file(&path, "is a project, which names plans in other files");
            Faults::from(fault.with_hint("take one of its plans")).into()
        }
        Kind::Plan | Kind::Other => read_text(source, options.words),
    };
    let Reading { buildings, mut faults, report, origin, .. } = reading;
    let plan = Plan { buildings: unique(buildings, &mut faults) };
    faults.sort();
    PlanReading { plan, faults, reports: report.into_iter().collect(), origin, ..PlanReading::default() }
}

/// The settings of the project files among the paths: read before the catalogue, which they may extend.
///
/// # Errors
/// All faults of the project files, and settings that contradict each other.
pub fn project_settings(paths: &[PathBuf]) -> Result<ProjectSettings, Faults> {
    let (inputs, _) = find_inputs(paths);
    let mut merged = ProjectSettings::default();
    let mut faults = Faults::default();
    for input in inputs.iter().filter(|input| input.is_named && input.format.is_none()) {
        // A file that cannot be read is reported with the plans.
        let Ok(source) = Source::read(&input.path) else { continue };
        if kind_of(&source) != Kind::Project {
            continue;
        }
        match project::project_settings(&source) {
            Ok(settings) => merge_settings(&mut merged, settings, &input.path, &mut faults),
            Err(found) => faults.merge(found),
        }
    }
    if faults.is_empty() { Ok(merged) } else { Err(faults) }
}

fn merge_settings(merged: &mut ProjectSettings, settings: ProjectSettings, file: &Path, faults: &mut Faults) {
    let ProjectSettings { catalog, style, seed, origin } = settings;
    merged.catalog.extend(catalog);
    let mut contradict = |what: &str, differ: bool| {
        if differ {
            let message = format!("names another {what} than the projects before it");
            faults.push(Fault::of_file(file, message).with_hint("bake them one after the other"));
        }
    };
    contradict("style", merged.style.is_some() && style.is_some() && merged.style != style);
    contradict("seed", merged.seed.is_some() && seed.is_some() && merged.seed != seed);
    merged.style = merged.style.take().or(style);
    contradict("origin", merged.origin.is_some() && origin.is_some() && merged.origin != origin);
    merged.seed = merged.seed.or(seed);
    merged.origin = merged.origin.take().or(origin);
}

/// A building and the file that named it.
struct ReadBuilding {
    placed: PlacedBuilding,
    file: PathBuf,
}

/// The content of an input.
#[derive(Default)]
struct Reading {
    buildings: Vec<ReadBuilding>,
    faults: Faults,
    /// None of what is no plan, and of projects.
    report: Option<InputReport>,
    /// Where the site is on the earth, if the file says; projects say it in their settings.
    origin: Option<SiteOrigin>,
    /// The furniture that is kept, if the reader read it on the way.
    furniture: Option<Vec<DrawnPiece>>,
}

impl From<Faults> for Reading {
    fn from(faults: Faults) -> Self {
        Self { faults, ..Self::default() }
    }
}

fn read_input(input: &Input, options: &PlanOptions<'_>) -> Reading {
    let words = options.words;
    if let Some(format) = input.format {
        return finish_all(&input.path, format.about.name, read_drafts(&input.path, options), words);
    }
    match unread::refusal(&input.path) {
        Some(fault) if input.is_named => return Faults::from(fault).into(),
        // In folders and patterns plans stand beside much else.
        Some(_) => return Reading::default(),
        None => {}
    }
    let source = match Source::read(&input.path) {
        Ok(source) => source,
        Err(faults) => return faults.into(),
    };
    match kind_of(&source) {
        // Projects count when they are named; in a folder their plans stand beside them.
        Kind::Project if input.is_named => {
            let (buildings, faults) = project::read_project(&source, options);
            Reading { buildings, faults, ..Reading::default() }
        }
        Kind::Other | Kind::Project if !input.is_named => Reading::default(),
        _ => read_text(source, words),
    }
}

/// A plan in the native format, or what else the text may be.
fn read_text(source: Source, words: &RoomWords) -> Reading {
    if kind_of(&source) == Kind::Other && !native::may_be_plan(&source) {
        return Faults::from(nothing::of_text(&source)).into();
    }
    let path = source.file().to_owned();
    finish_all(&path, "native", native_drafts(source, words), words)
}

fn finish_all(file: &Path, format: &'static str, reading: Drafts, words: &RoomWords) -> Reading {
    let mut faults = reading.faults;
    let mut buildings = Vec::new();
    let mut report = InputReport { path: file.to_owned(), format, buildings: Vec::new() };
    let source = Arc::new(PlanSource { plan: file.to_owned(), ..PlanSource::default() });
    for ((id, site), Finished { building, faults: found, levels }) in finish_each(reading.drafts, words) {
        faults.merge(found);
        report.buildings.push(BuildingReport { id: id.clone(), levels });
        if building.levels.is_empty() {
            continue;
        }
        let placed = PlacedBuilding { id, site, building: Arc::new(building), source: Arc::clone(&source) };
        buildings.push(ReadBuilding { placed, file: file.to_owned() });
    }
    Reading { buildings, faults, report: Some(report), origin: reading.origin, furniture: reading.furniture }
}

/// Finishes the buildings of a file: one after the other where guesses are told, which are counted over all of them. Each draft is
/// dropped when its building is there: those of a city take as much memory as its plans.
fn finish_each(drafts: Vec<Drafted>, words: &RoomWords) -> Vec<((String, SitePlacement), Finished)> {
    let has_guesses = |drafted: &Drafted| {
        drafted.draft.levels.iter().flat_map(|level| &level.rooms).any(|room| room.unknown_word.is_some())
    };
    if drafts.iter().any(has_guesses) {
        let mut told = 0;
        let mut finish = |drafted: Drafted| {
            let finished = finish(&drafted, &Variation::default(), words, &mut told);
            ((drafted.id, drafted.placement), finished)
        };
        return drafts.into_iter().map(&mut finish).collect();
    }
    let finish = |drafted: Drafted| {
        let finished = finish(&drafted, &Variation::default(), words, &mut 0);
        ((drafted.id, drafted.placement), finished)
    };
    drafts.into_par_iter().map(finish).collect()
}

/// The content of a file or folder, before assembly.
#[derive(Default)]
struct Drafts {
    drafts: Vec<Drafted>,
    faults: Faults,
    /// Where the site is on the earth, if the file says.
    origin: Option<SiteOrigin>,
    /// The furniture that is kept, if the reader read it on the way.
    furniture: Option<Vec<DrawnPiece>>,
    is_project: bool,
}

/// Reads a map and plans the buildings that are chosen, in parallel.
///
/// # Errors
/// The faults of the file, what it is where it is no map, and choices that leave no building.
pub(crate) fn plan_outlines(path: &Path, options: &PlanOptions<'_>) -> Result<PlannedSite, Faults> {
    let refusal = if (outlines::FORMAT.recognises)(path) { None } else { unread::refusal(path) };
    refusal.map_or_else(|| outlines::read_and_plan(path, options), |fault| Err(fault.into()))
}

/// Reads a plan of any format.
fn read_drafts(path: &Path, options: &PlanOptions<'_>) -> Drafts {
    let Some(format) = FOREIGN_FORMATS.iter().find(|format| (format.recognises)(path)) else {
        if let Some(fault) = unread::refusal(path) {
            return Drafts { faults: fault.into(), ..Drafts::default() };
        }
        return match Source::read(path) {
            Ok(source) if kind_of(&source) == Kind::Project => {
                Drafts { is_project: true, ..Drafts::default() }
            }
            Ok(source) if !native::may_be_plan(&source) => {
                Drafts { faults: nothing::of_text(&source).into(), ..Drafts::default() }
            }
            Ok(source) => native_drafts(source, options.words),
            Err(faults) => Drafts { faults, ..Drafts::default() },
        };
    };
    match (format.read)(path, options) {
        Ok(ReadBuildings { buildings, faults, origin, mut furniture }) => {
            let drafted = |DraftedBuilding { id, mut draft, placement, is_settled }| {
                fit_ids(&mut draft);
                Drafted {
                    is_settled: is_settled && !options.is_for_writing,
                    id: fit_building_id(&id),
                    draft,
                    placement,
                    provenance: Provenance::Foreign(path.to_owned()),
                }
            };
            for piece in furniture.iter_mut().flatten() {
                piece.building = fit_building_id(&piece.building);
            }
            let drafts = buildings.into_iter().map(drafted).collect();
            Drafts { drafts, faults, origin, furniture, is_project: false }
        }
        Err(faults) => Drafts { faults, ..Drafts::default() },
    }
}

fn native_drafts(source: Source, words: &RoomWords) -> Drafts {
    match read_native(&source, words) {
        Ok(NativeDraft { id, draft, origins, faults }) => {
            let provenance = Provenance::Native(source, origins);
            let placement = SitePlacement::default();
            Drafts {
                drafts: vec![Drafted { id, draft, placement, provenance, is_settled: false }],
                faults,
                ..Drafts::default()
            }
        }
        Err(faults) => Drafts { faults, ..Drafts::default() },
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Plan,
    Project,
    Other,
}

/// The kind of a file, by its keys.
fn kind_of(source: &Source) -> Kind {
    let keys = source.top_keys();
    let has = |key: &str| keys.iter().any(|known| known == key);
    if has("project") {
        Kind::Project
    } else if has("levels") {
        Kind::Plan
    } else {
        Kind::Other
    }
}

/// The fault of a building whose id one of another file has.
pub(crate) fn id_taken(file: &Path, id: &str, first: &Path) -> Fault {
    let message = format!("building id \"{id}\" is used by \"{}\" too", first.display());
    Fault::of_file(file, message).with_hint("give one of them another `id`")
}

/// Sorted by id; of two with one id the one whose file comes first stays.
fn unique(mut buildings: Vec<ReadBuilding>, faults: &mut Faults) -> Vec<PlacedBuilding> {
    buildings.sort_by(|a, b| a.placed.id.cmp(&b.placed.id).then_with(|| a.file.cmp(&b.file)));
    let mut kept: BTreeMap<String, PathBuf> = BTreeMap::new();
    let mut placed = Vec::with_capacity(buildings.len());
    let mut taken = Faults::default();
    for building in buildings {
        let id = &building.placed.id;
        if let Some(first) = kept.get(id) {
            taken.push(id_taken(&building.file, id, first));
        } else {
            kept.insert(id.clone(), building.file);
            placed.push(building.placed);
        }
    }
    faults.merge(first_of_each_kind(taken));
    placed
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::Building;

    #[test]
    fn of_hundreds_of_files_with_one_id_the_first_are_reported() {
        let read = |number: usize| ReadBuilding {
            placed: PlacedBuilding {
                id: "house".to_owned(),
                site: SitePlacement::default(),
                building: Arc::new(Building { name: None, attribution: None, levels: Vec::new() }),
                source: Arc::default(),
            },
            file: PathBuf::from(format!("{number:03}.yaml")),
        };
        let mut faults = Faults::default();
        assert_eq!(unique((0..900).map(read).collect(), &mut faults).len(), 1);
        assert_eq!(faults.0.len(), 201);
        assert!(faults.0[200].message.ends_with("(and 698 more like it)"), "{}", faults.0[200].message);
    }
}
