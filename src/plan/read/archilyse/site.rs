//! Reads a site: tables of buildings, floors, drawings, areas and apartments.

use std::collections::BTreeMap;
use std::path::Path;

use schemars::JsonSchema;
use serde::Deserialize;

use super::areas::Area;
use super::drawing::Drawing;
use super::level::{Floor, Heights, Naming, level};
use super::rooms::{Outlined, RoomTypes, outlined};
use super::single::pixel_size;
use super::tables::Table;
use super::{NEEDED, PARTS, SITE_FILE};
use crate::document::{Fault, FaultSeverity, Faults, PathStep};
use crate::plan::read::foreign::{UniqueIds, both, missing_parts};
use crate::plan::read::reader::{DraftedBuilding, ReadBuildings, ReadResult};
use crate::plan::{BuildingDraft, LevelDraft, RoomWords};

#[derive(Deserialize, JsonSchema)]
struct ProjectRow {
    plan_id: i64,
    data: Drawing,
}

#[derive(Deserialize, JsonSchema)]
struct FloorRow {
    floor_number: i32,
    plan_id: i64,
    building_id: i64,
}

#[derive(Deserialize, JsonSchema)]
struct PlanRow {
    id: i64,
    default_wall_height: Option<f64>,
    default_window_lower_edge: Option<f64>,
    default_window_upper_edge: Option<f64>,
}

#[derive(Deserialize, JsonSchema)]
struct BuildingRow {
    id: i64,
    street: Option<String>,
    housenumber: Option<String>,
}

#[derive(Deserialize, JsonSchema)]
struct UnitRow {
    id: i64,
    apartment_no: Option<i64>,
}

#[derive(Deserialize, JsonSchema)]
struct UnitAreaRow {
    area_id: i64,
    unit_id: i64,
}

/// The tables of a site.
struct Site {
    projects: Table<ProjectRow>,
    areas: Table<Area>,
    floors: Table<FloorRow>,
    heights: BTreeMap<i64, Heights>,
    /// Title by building.
    titles: BTreeMap<i64, String>,
    /// Apartment by area.
    apartments: BTreeMap<i64, String>,
}

/// Reads a site's folder: one building for each that a floor names, floors lowest first.
///
/// A floor that cannot be read is reported and left out.
pub(super) fn read(folder: &Path, words: &RoomWords) -> ReadResult {
    let mut faults = Faults::default();
    let site = Site::read(folder, &mut faults).map_err(|found| name_missing(folder, found))?;
    let mut outlines: BTreeMap<i64, Outlined<'_>> = BTreeMap::new();
    for (area, parts) in outlined(&site.areas, &mut faults) {
        if let Some(plan) = area.plan_id {
            outlines.entry(plan).or_default().push((area, parts));
        }
    }
    let mut types = RoomTypes::new(words);
    let mut buildings: BTreeMap<i64, Vec<(i32, LevelDraft)>> = BTreeMap::new();
    for (index, floor) in site.floors.rows() {
        let floors = buildings.entry(floor.building_id).or_default();
        match site.level(index, floor, &outlines, &mut types) {
            Ok(level) => floors.push((floor.floor_number, level)),
            Err(found) => faults.merge(found),
        }
    }
    faults.merge(types.warnings(&site.areas));
    let name = folder_name(folder);
    // Counted with those that lost all floors, so that a fault does not rename the others.
    let is_single = buildings.len() == 1;
    let drafted = buildings.into_iter().map(|(building, mut floors)| {
        // The table of floors is in no order.
        floors.sort_by_key(|(number, _)| *number);
        let id = if is_single { name.clone() } else { format!("{name}_{building}") };
        let mut ids = UniqueIds::default();
        // A building may have two drawings of one number, such as those of two stairwells.
        let unique = |(_, level): (i32, LevelDraft)| LevelDraft { id: ids.numbered(&level.id), ..level };
        let levels = floors.into_iter().map(unique).collect();
        let draft =
            BuildingDraft { name: site.titles.get(&building).cloned(), levels, ..BuildingDraft::default() };
        DraftedBuilding { id, draft, ..DraftedBuilding::default() }
    });
    ReadBuildings::new(drafted.collect(), faults)
}

/// The faults of a site, those of all missing files in one that says what lies there instead.
fn name_missing(folder: &Path, mut faults: Faults) -> Faults {
    if NEEDED.iter().any(|name| !folder.join(name).is_file()) {
        faults.0.retain(|fault| fault.file.exists());
        let (message, hint) = missing_parts(folder, PARTS);
        faults.push(Fault::of_file(folder, format!("the site {message}")).with_hint(hint));
    }
    faults
}

/// The folder's own name, also where the path is `.`.
fn folder_name(folder: &Path) -> String {
    let full = std::fs::canonicalize(folder).unwrap_or_else(|_| folder.to_owned());
    full.file_name().map_or_else(|| "site".to_owned(), |name| name.to_string_lossy().into_owned())
}

impl Site {
    fn read(folder: &Path, faults: &mut Faults) -> Result<Self, Faults> {
        let (projects, (areas, floors)) = both(
            Table::read(&folder.join(SITE_FILE), faults),
            both(
                Table::read(&folder.join("areas.json"), faults),
                Table::read(&folder.join("floors.json"), faults),
            ),
        )?;
        let (plans, (buildings, (units, unit_areas))) = both(
            optional_rows::<PlanRow>(folder, "plans.json", faults),
            both(
                optional_rows::<BuildingRow>(folder, "buildings.json", faults),
                both(
                    optional_rows::<UnitRow>(folder, "units.json", faults),
                    optional_rows::<UnitAreaRow>(folder, "unit_areas.json", faults),
                ),
            ),
        )?;
        Ok(Self {
            projects,
            areas,
            floors,
            heights: plans.iter().map(|plan| (plan.id, plan.heights())).collect(),
            titles: buildings.into_iter().filter_map(|row| Some((row.id, row.title()?))).collect(),
            apartments: apartments(&units, &unit_areas),
        })
    }

    /// The level of a row of the table of floors.
    fn level(
        &self,
        row: usize,
        floor: &FloorRow,
        outlines: &BTreeMap<i64, Outlined<'_>>,
        types: &mut RoomTypes<'_>,
    ) -> Result<LevelDraft, Faults> {
        let mut projects = self.projects.rows();
        let project = projects.find(|(_, project)| project.plan_id == floor.plan_id);
        let (place, project) = project.ok_or_else(|| {
            let path = [PathStep::from(row), "plan_id".into()];
            let message = format!("floor {} has no drawing {}", floor.floor_number, floor.plan_id);
            let hint = Some(format!("\"{SITE_FILE}\" needs a sound entry with this plan_id"));
            self.floors.source.fault(&path, message, hint, FaultSeverity::Error)
        })?;
        let drawing = &project.data;
        let path = [PathStep::from(place), "data".into(), "scale".into()];
        let pixel = pixel_size(&self.projects.source, drawing.scale, &path)?;
        let areas = outlines.get(&floor.plan_id).cloned().unwrap_or_default();
        let heights = self.heights.get(&floor.plan_id).copied().unwrap_or_default();
        let floor = Floor { drawing, pixel, areas, heights, number: floor.floor_number };
        let mut naming = Naming {
            room_type: &mut |area, is_toilet| types.of(area, is_toilet),
            apartment: &|area| self.apartments.get(&area.id).cloned(),
        };
        Ok(level(&floor, &mut naming))
    }
}

/// No rows where the file is missing.
fn optional_rows<T>(folder: &Path, name: &str, faults: &mut Faults) -> Result<Vec<T>, Faults>
where
    T: for<'de> Deserialize<'de> + JsonSchema,
{
    let file = folder.join(name);
    if !file.exists() {
        return Ok(Vec::new());
    }
    Table::read(&file, faults).map(Table::into_rows)
}

fn apartments(units: &[UnitRow], unit_areas: &[UnitAreaRow]) -> BTreeMap<i64, String> {
    let numbers: BTreeMap<i64, i64> =
        units.iter().filter_map(|unit| Some((unit.id, unit.apartment_no?))).collect();
    unit_areas
        .iter()
        .map(|row| {
            let number = numbers.get(&row.unit_id).unwrap_or(&row.unit_id);
            (row.area_id, format!("apartment {number}"))
        })
        .collect()
}

impl PlanRow {
    fn heights(&self) -> Heights {
        let usual = Heights::default();
        Heights {
            wall: self.default_wall_height.unwrap_or(usual.wall),
            window_low: self.default_window_lower_edge.unwrap_or(usual.window_low),
            window_high: self.default_window_upper_edge.unwrap_or(usual.window_high),
        }
    }
}

impl BuildingRow {
    fn title(&self) -> Option<String> {
        let street = self.street.as_deref()?;
        Some(
            self.housenumber.as_ref().map_or_else(|| street.to_owned(), |house| format!("{street}, {house}")),
        )
    }
}
