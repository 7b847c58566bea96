//! `plan`: plans the storeys of buildings of which a map shows only the outline, as native plans and a project that places them.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use rayon::prelude::*;
use schemars::JsonSchema;
use serde::Serialize;
use serde_saphyr::{FlowMap, FlowSeq};

use super::answer::{FaultAnswer, fault_answers};
use super::arguments::{PlanArguments, SourceArguments};
use super::exit::Outcome;
use super::files::{Overwrite, write_text};
use super::screen::Screen;
use crate::batch::distinct_names;
use crate::catalog::{Catalog, load_catalog};
use crate::document::{Faults, Warned, counted, printable};
use crate::plan::{PlanOptions, PlannedSite, SiteNotes, finish_draft, id_taken, plan_outlines, write_native};
use crate::storey::{Origin, PlanReport, PlannedBuilding};

/// The answer of `plan`.
#[derive(Serialize, JsonSchema)]
pub(crate) struct PlanAnswer {
    /// The files of the plans, and the project.
    pub(crate) files: usize,
    /// Buildings by the way that was taken: 0 the kind that was drawn for them, 1 another kind that fits, 2 an open plan, 3 one room
    /// on each storey.
    pub(crate) rungs: [usize; 4],
    /// What is wrong with the maps.
    pub(crate) faults: Vec<FaultAnswer>,
}

/// What `--report` writes.
#[derive(Serialize, JsonSchema)]
pub(crate) struct ReportFile {
    /// What became of features of the maps that are no buildings of their own.
    maps: Vec<SiteNotes>,
    /// The buildings.
    buildings: Vec<PlanReport>,
}

/// Runs the command.
pub(crate) fn run(arguments: PlanArguments, screen: Screen) -> Outcome {
    let PlanArguments { paths, out, force, catalog, seed, report, mut map } = arguments;
    map.seed = Some(seed);
    let sources = SourceArguments { paths, catalog, map, ..SourceArguments::default() };
    let (planned, catalog, mut faults) = match read(&sources) {
        Ok(read) => read,
        Err(faults) => {
            screen.faults(&faults);
            return Outcome::NotStarted;
        }
    };
    let overwrite = Overwrite::forced(force);
    let mut written = 0;
    let mut rungs = [0; 4];
    let mut entries = Vec::new();
    let buildings: Vec<&PlannedBuilding> = planned.iter().flat_map(|site| &site.buildings).collect();
    let ids: Vec<&str> = buildings.iter().map(|building| building.id.as_str()).collect();
    let write = |(building, name): (&&PlannedBuilding, String)| {
        let (checked, found) = finish_draft(&building.id, &building.draft, &catalog.room_words);
        let path = PathBuf::from(format!("{name}.yaml"));
        let text = write_native(&checked, &building.id);
        let result = write_text(&out.join(&path), &text, overwrite);
        (path, found, result)
    };
    let results: Vec<_> = buildings.par_iter().zip(distinct_names(&ids)).map(write).collect();
    for (building, (path, found, result)) in buildings.into_iter().zip(results) {
        faults.merge(found);
        match result {
            Ok(()) => {
                written += 1;
                rungs[building.report.rung.min(3) as usize] += 1;
                entries.push(entry(building, path));
            }
            Err(fault) => faults.merge(fault),
        }
    }
    let project = project_text(&planned, entries, seed);
    match write_text(&out.join("project.yaml"), &project, overwrite) {
        Ok(()) => written += 1,
        Err(fault) => faults.merge(fault),
    }
    if let Some(path) = report {
        faults.merge(write_report(&path, planned, overwrite).err().unwrap_or_default());
    }
    screen.faults(&faults);
    if screen.is_json {
        screen.json(&PlanAnswer { files: written, rungs, faults: fault_answers(&faults) });
    } else {
        let [first, other, open, single] = rungs;
        let ways = format!("as drawn {first}, as another kind {other}, open {open}, one room {single}");
        let count = counted(rungs.iter().sum::<usize>(), "building");
        screen.note(&printable(&format!("{}: {count} planned ({ways})", out.display())));
    }
    if written == 0 { Outcome::NotStarted } else { Outcome::of_failures(faults.has_errors()) }
}

fn read(sources: &SourceArguments) -> Result<(Vec<PlannedSite>, Catalog, Faults), Faults> {
    let Warned { value: catalog, warnings: mut faults } = load_catalog(&sources.catalog)?;
    let choices = sources.choices();
    let options = PlanOptions::new(&catalog.room_words).with_planning(&catalog.typologies, &choices);
    let mut planned = Vec::new();
    let mut owners: BTreeMap<String, &PathBuf> = BTreeMap::new();
    for path in &sources.paths {
        match plan_outlines(path, &options) {
            Ok(mut site) => {
                faults.merge(std::mem::take(&mut site.site.faults));
                site.buildings.retain(|building| {
                    let first = *owners.entry(building.id.clone()).or_insert(path);
                    if first != path {
                        faults.push(id_taken(path, &building.id, first));
                    }
                    first == path
                });
                planned.push(site);
            }
            Err(found) => faults.merge(found),
        }
    }
    if planned.is_empty() { Err(faults) } else { Ok((planned, catalog, faults)) }
}

/// A plan of the project.
#[derive(Serialize)]
struct Entry {
    plan: PathBuf,
    position: FlowSeq<[f64; 2]>,
    turn: f64,
}

#[derive(Serialize)]
struct OutProject {
    version: u32,
    project: OutSettings,
}

#[derive(Serialize)]
struct OutSettings {
    seed: u64,
    #[serde(skip_serializing_if = "Option::is_none")]
    reference_system: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    origin: Option<FlowMap<OutOrigin>>,
    plans: Vec<FlowMap<Entry>>,
}

#[derive(Serialize)]
struct OutOrigin {
    position: FlowSeq<[f64; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    degrees: Option<FlowSeq<[f64; 2]>>,
}

fn entry(building: &PlannedBuilding, plan: PathBuf) -> FlowMap<Entry> {
    let rounded = |number: f64, steps: f64| (number * steps).round() / steps + 0.0;
    let position = building.placement.position;
    FlowMap(Entry {
        plan,
        position: FlowSeq([rounded(position.x, 1000.0), rounded(position.y, 1000.0)]),
        turn: rounded(building.placement.turn.to_degrees(), 1e7),
    })
}

fn project_text(planned: &[PlannedSite], plans: Vec<FlowMap<Entry>>, seed: u64) -> String {
    // Several maps stand on planes of their own: then nothing is said of where on the earth they are.
    let site = match planned {
        [one] => Some(&one.site.site),
        _ => None,
    };
    let origin = |Origin { position, degrees, .. }: Origin| {
        FlowMap(OutOrigin { position: FlowSeq(position), degrees: degrees.map(FlowSeq) })
    };
    let project = OutProject {
        version: 1,
        project: OutSettings {
            seed,
            reference_system: site.and_then(|site| site.reference_system.clone()),
            origin: site.filter(|site| site.reference_system.is_some()).map(|site| origin(site.origin)),
            plans,
        },
    };
    let options = serde_saphyr::ser_options! { prefer_block_scalars: false, compact_list_indent: true };
    serde_saphyr::to_string_with_options(&project, options).expect("a project is texts and numbers")
}

fn write_report(path: &Path, planned: Vec<PlannedSite>, overwrite: Overwrite) -> Result<(), Faults> {
    let mut report = ReportFile { maps: Vec::new(), buildings: Vec::new() };
    for site in planned {
        report.maps.push(site.site.notes);
        report.buildings.extend(site.buildings.into_iter().map(|building| building.report));
    }
    let text = serde_json::to_string_pretty(&report).expect("a report is texts and numbers");
    write_text(path, &(text + "\n"), overwrite)
}
