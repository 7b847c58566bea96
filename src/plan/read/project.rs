//! Reads project files: the plans of a city, and the place of each building.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use schemars::JsonSchema;
use serde::Deserialize;

use super::finish::{Drafted, Finished, Variation, finish};
use super::native::{
    FILE_NAME_FORBIDDEN, PatternValues, Report, VERSION, check_style, expand_pattern, id_fault, item,
    names_value, step,
};
use super::{ReadBuilding, read_drafts};
use crate::document::{Faults, PathStep, Source};
use crate::geometry::Point;
use crate::plan::{
    Building, PlacedBuilding, PlanOptions, PlanSource, ProjectSettings, SiteOrigin, SitePlacement,
};

/// Most buildings of a project.
const BUILDING_LIMIT: u32 = 1_000_000;
/// Metres from the site's origin to the farthest building: no two places on the earth are farther apart.
const FARTHEST: f64 = 2e7;

/// A project: plans to bake together.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "Roomwright project")]
pub(crate) struct ProjectFile {
    /// Version of the format: 1.
    version: u32,
    /// The project.
    project: Project,
}

/// The plans that are baked together, and their settings.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Project {
    /// A title for people.
    #[allow(dead_code)] // for people who read the file
    name: Option<String>,
    /// Style of rooms that name none, unless the command line names one.
    style: Option<String>,
    /// Seed of the run, unless the command line names one.
    seed: Option<u64>,
    /// Name of the reference system in which the site's origin is given, such as `EPSG:25832`.
    reference_system: Option<String>,
    /// Where the site's origin is.
    origin: Option<OriginFile>,
    /// Further folders of configuration, relative to this file.
    #[serde(default)]
    catalog: Vec<PathBuf>,
    /// The plans.
    plans: Vec<ProjectPlan>,
}

/// Where the origin of a site is.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct OriginFile {
    /// In the units of the reference system: degrees of longitude and latitude, or metres east and north.
    position: [f64; 2],
    /// Degrees of longitude and latitude.
    degrees: Option<[f64; 2]>,
}

/// One plan, built once or many times.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ProjectPlan {
    /// A plan of any format, relative to this file.
    plan: PathBuf,
    /// Id of each building: `{id}` is that of the plan, `{n}` counts; `{id}`, or `{id}-{n}` with `count`, where absent.
    id: Option<String>,
    /// How many; 1 where absent.
    #[schemars(range(min = 1))]
    count: Option<u32>,
    /// Number of the first; 1 where absent.
    first: Option<i64>,
    /// Metres east and north of the site's origin where the first stands.
    #[serde(default)]
    position: [f64; 2],
    /// Metres from one to the next as [x, y]; with `columns`, x between columns and y between rows.
    #[serde(default)]
    step: [f64; 2],
    /// Buildings in a row of a grid.
    #[schemars(range(min = 1))]
    columns: Option<u32>,
    /// Degrees counter-clockwise.
    #[serde(default)]
    turn: f64,
    /// Whether east and west of the building are exchanged.
    #[serde(default)]
    mirror: bool,
    /// Style of rooms that name none, in place of the project's.
    style: Option<String>,
}

/// The settings of a project file.
///
/// # Errors
/// All faults of the file.
pub(super) fn project_settings(source: &Source) -> Result<ProjectSettings, Faults> {
    let project = parse(source)?.project;
    let folder = folder_of(source);
    let catalog = project.catalog.iter().map(|path| folder.join(path)).collect();
    let system = project.reference_system.as_deref();
    let origin = project.origin.and_then(|origin| {
        SiteOrigin::of(system, Point::from(origin.position), origin.degrees.map(Point::from))
    });
    Ok(ProjectSettings { catalog, style: project.style, seed: project.seed, origin })
}

/// All buildings of a project, and what is wrong with the project and its plans.
pub(super) fn read_project(source: &Source, options: &PlanOptions<'_>) -> (Vec<ReadBuilding>, Faults) {
    let words = options.words;
    let file = match parse(source) {
        Ok(file) => file,
        Err(faults) => return (Vec::new(), faults),
    };
    let mut report = Report::new(source);
    if !check_style(&["project".into()], file.project.style.as_ref(), words, &mut report) {
        // All rooms would look other than asked for: better none of them.
        return (Vec::new(), report.finish());
    }
    let mut reading = Reading {
        report,
        folder: folder_of(source),
        options,
        drafts: BTreeMap::new(),
        buildings: BTreeMap::new(),
        placed: Vec::new(),
        faults: Faults::default(),
    };
    let last_uses: BTreeMap<&Path, usize> =
        file.project.plans.iter().zip(0..).map(|(plan, index)| (plan.plan.as_path(), index)).collect();
    for (index, plan) in file.project.plans.iter().enumerate() {
        reading.add_plan(&item(&["project".into()], "plans", index), plan);
        // Drafts are ten times as large as the buildings made of them: those of a whole city are not kept.
        if last_uses.get(plan.plan.as_path()) == Some(&index) {
            reading.drafts.remove(&reading.folder.join(&plan.plan));
        }
    }
    let mut faults = reading.report.finish();
    faults.merge(reading.faults);
    (reading.placed, faults)
}

fn parse(source: &Source) -> Result<ProjectFile, Faults> {
    let file: ProjectFile = source.parse()?;
    let mut report = Report::new(source);
    if file.version != VERSION {
        let hint = Some(format!("this program reads version {VERSION}"));
        report.error(&["version".into()], format!("version {} is not known", file.version), hint);
    }
    if file.project.plans.is_empty() {
        report.error(&["project".into(), "plans".into()], "the project has no plan", None);
    }
    let faults = report.finish();
    if faults.is_empty() { Ok(file) } else { Err(faults) }
}

fn folder_of(source: &Source) -> PathBuf {
    source.file().parent().unwrap_or(Path::new("")).to_owned()
}

type Drafts = Arc<Vec<Drafted>>;

struct Reading<'a> {
    report: Report<'a>,
    folder: PathBuf,
    options: &'a PlanOptions<'a>,
    /// The content of each plan file that is still needed, read once however often it is built; none where it cannot be read.
    drafts: BTreeMap<PathBuf, Option<Drafts>>,
    /// Buildings by file, number in the file, and variation: equal ones are one.
    buildings: BTreeMap<(PathBuf, usize, Variation), Arc<Building>>,
    placed: Vec<ReadBuilding>,
    faults: Faults,
}

impl Reading<'_> {
    fn add_plan(&mut self, path: &[PathStep], plan: &ProjectPlan) {
        let count = plan.count.unwrap_or(1);
        if count > BUILDING_LIMIT {
            self.report.error(&step(path, "count"), format!("{count} buildings are too many"), None);
            return;
        }
        let numbers = [("position", plan.position), ("step", plan.step), ("turn", [plan.turn, 0.0])];
        if let Some((key, _)) =
            numbers.iter().find(|(_, values)| !values.iter().all(|value| value.is_finite()))
        {
            self.report.error(&step(path, *key), "is not finite", None);
            return;
        }
        let last = site(plan, count.saturating_sub(1)).position;
        if Point::from(plan.position).abs().max(last.abs()).max_element() > FARTHEST {
            let message = "the building stands farther than 20,000 km from the site's origin";
            let hint = "positions are metres east and north of it".to_owned();
            self.report.error(&step(path, "position"), message, Some(hint));
            return;
        }
        let has_style = check_style(path, plan.style.as_ref(), self.options.words, &mut self.report);
        let style = plan.style.clone().filter(|_| has_style);
        let file = self.folder.join(&plan.plan);
        let Some(drafts) = self.drafts_of(path, &file) else { return };
        let project = self.report.source().file().to_owned();
        let source = Arc::new(PlanSource {
            plan: file.clone(),
            project: Some(project.clone()),
            is_mirrored: plan.mirror,
        });
        for (number, drafted) in drafts.iter().enumerate() {
            let variation = Variation { is_mirrored: plan.mirror, style: style.clone() };
            let building = self.building(&file, number, drafted, variation);
            if building.levels.is_empty() {
                continue;
            }
            for copy in 0..count {
                let Some(id) = self.id(path, plan, &drafted.id, copy) else { return };
                let site = within(site(plan, copy), drafted.placement);
                let (building, source) = (Arc::clone(&building), Arc::clone(&source));
                let placed = PlacedBuilding { id, site, building, source };
                self.placed.push(ReadBuilding { placed, file: project.clone() });
            }
        }
    }

    fn drafts_of(&mut self, path: &[PathStep], file: &Path) -> Option<Drafts> {
        if let Some(known) = self.drafts.get(file) {
            return known.clone();
        }
        let drafts = if file.exists() {
            let reading = read_drafts(file, self.options);
            self.faults.merge(reading.faults);
            let is_plan = !reading.is_project;
            if !is_plan {
                let hint = "name the plans of the other project here";
                self.report.error(
                    &step(path, "plan"),
                    "a project cannot hold a project",
                    Some(hint.to_owned()),
                );
            }
            is_plan.then(|| Arc::new(reading.drafts))
        } else {
            let message = format!("there is no file \"{}\"", file.display());
            let hint = "paths are relative to the project file";
            self.report.error(&step(path, "plan"), message, Some(hint.to_owned()));
            None
        };
        self.drafts.insert(file.to_owned(), drafts.clone());
        drafts
    }

    fn building(
        &mut self,
        file: &Path,
        number: usize,
        drafted: &Drafted,
        variation: Variation,
    ) -> Arc<Building> {
        let key = (file.to_owned(), number, variation);
        if let Some(building) = self.buildings.get(&key) {
            return Arc::clone(building);
        }
        let Finished { building, faults, .. } = finish(drafted, &key.2, self.options.words, &mut 0);
        // Variations of one draft have the same faults; `sort` drops the repetition.
        self.faults.merge(faults);
        let building = Arc::new(building);
        self.buildings.insert(key, Arc::clone(&building));
        building
    }

    fn id(&mut self, path: &[PathStep], plan: &ProjectPlan, own: &str, copy: u32) -> Option<String> {
        let is_many = plan.count.unwrap_or(1) > 1;
        let usual = if is_many { "{id}-{n}" } else { "{id}" };
        let pattern = plan.id.as_deref().unwrap_or(usual);
        let n = plan.first.unwrap_or(1).saturating_add(i64::from(copy));
        let values = PatternValues { n: Some(n), level: None, id: Some(own) };
        let path = step(path, "id");
        if is_many && !names_value(pattern, "n") {
            let message = format!("{} buildings have the id \"{pattern}\"", plan.count.unwrap_or(1));
            self.report.error(&path, message, Some("write \"{n}\" into it".to_owned()));
            return None;
        }
        let id = expand_pattern(pattern, &values).and_then(|id| match id_fault(&id, FILE_NAME_FORBIDDEN) {
            None => Ok(id),
            Some(fault) => Err((fault, "it names a folder of the output".to_owned())),
        });
        id.map_err(|(message, hint)| self.report.error(&path, message, Some(hint))).ok()
    }
}

/// A place of a map that is itself placed.
fn within(outer: SitePlacement, inner: SitePlacement) -> SitePlacement {
    let position = outer.position + crate::geometry::direction(outer.turn).rotate(inner.position);
    SitePlacement { position, turn: outer.turn + inner.turn }
}

fn site(plan: &ProjectPlan, copy: u32) -> SitePlacement {
    let (column, row) = plan.columns.map_or((copy, copy), |columns| {
        let columns = columns.max(1);
        (copy % columns, copy / columns)
    });
    let steps = Point::new(f64::from(column), f64::from(row)) * Point::from(plan.step);
    SitePlacement { position: Point::from(plan.position) + steps, turn: plan.turn.to_radians() }
}
