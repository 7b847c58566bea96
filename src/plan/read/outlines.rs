//! Maps of building outlines: reads the site, and plans the storeys of each building.

use std::path::Path;

use rayon::prelude::*;

use super::footprint::{FootprintFormat, ReadSite, read_site, recognises};
use super::osm::ATTRIBUTION;
use super::reader::{DraftedBuilding, ForeignFormat, ReadBuildings, ReadFormat};
use crate::document::{Fault, Faults, did_you_mean};
use crate::geometry::{Bounds, Point};
use crate::plan::units::{LocalPlane, US_FOOT};
use crate::plan::{PlanOptions, Planning, SiteOrigin};
use crate::storey::{Neighbourhood, Origin, PlannedBuilding, Site, plan_building};

/// Maps of building outlines.
pub(super) const FORMAT: ForeignFormat = ForeignFormat {
    about: ReadFormat {
        name: "footprints",
        title: "maps of building outlines",
        input: "a GeoJSON, CityJSON, OSM XML or OSM PBF file",
        content: "outlines, storeys, uses and entrances of buildings; rooms, doors and windows are planned",
    },
    recognises: |path| recognises(path).is_some(),
    near_miss: |_| None,
    read: |path, options| {
        let planned = read_and_plan(path, options)?;
        let drafted = |building: PlannedBuilding| DraftedBuilding {
            is_settled: true,
            id: building.id,
            draft: building.draft,
            placement: building.placement,
        };
        let origin = on_earth(&planned.site.site);
        let read =
            ReadBuildings::new(planned.buildings.into_iter().map(drafted).collect(), planned.site.faults)?;
        Ok(ReadBuildings { origin, ..read })
    },
    furniture: None,
};

/// A map with the plans of its buildings.
pub(crate) struct PlannedSite {
    /// The map.
    pub(crate) site: ReadSite,
    /// The buildings that were chosen, in the order of the site.
    pub(crate) buildings: Vec<PlannedBuilding>,
}

/// Reads a map and plans the buildings that are chosen, in parallel.
///
/// # Errors
/// The faults of the file, and choices that leave no building.
pub(super) fn read_and_plan(path: &Path, options: &PlanOptions<'_>) -> Result<PlannedSite, Faults> {
    let Some(planning) = options.planning else {
        let message = "is a map of outlines, and there are no kinds of buildings to plan them by";
        return Err(Fault::of_file(path, message).into());
    };
    check_use(planning)?;
    let mut read = read_site(path)?;
    let chosen = chosen(&read, planning);
    if chosen.is_empty() {
        let message = format!("none of its {} buildings is chosen", read.site.footprints.len());
        return Err(Fault::of_file(path, message).with_hint("see --only and --bbox").into());
    }
    let around = Neighbourhood::new(&read.site);
    let plan =
        |&index: &usize| plan_building(&read.site, &around, index, planning.typologies, planning.choices);
    let planned: Vec<Option<PlannedBuilding>> = chosen.par_iter().map(plan).collect();
    let is_planned = planned.iter().map(Option::is_some);
    let narrow: Vec<usize> = chosen
        .iter()
        .zip(is_planned)
        .filter(|(_, is_planned)| !is_planned)
        .map(|(&index, _)| index)
        .collect();
    if !narrow.is_empty() {
        read.leave_out(path, &narrow, "nobody can stand in it");
    }
    let mut buildings: Vec<PlannedBuilding> = planned.into_iter().flatten().collect();
    if is_of_openstreetmap(path) {
        buildings.iter_mut().for_each(|building| building.draft.attribution = Some(ATTRIBUTION.to_owned()));
    }
    Ok(PlannedSite { site: read, buildings })
}

/// Whether a map says by its format where it is from; exports as GeoJSON do not.
fn is_of_openstreetmap(path: &Path) -> bool {
    matches!(recognises(path), Some(FootprintFormat::OsmXml | FootprintFormat::OsmPbf))
}

/// Where the plane of a site is on the earth, where its map says so.
fn on_earth(site: &Site) -> Option<SiteOrigin> {
    let Origin { position, degrees, .. } = site.origin;
    SiteOrigin::of(site.reference_system.as_deref(), Point::from(position), degrees.map(Point::from))
}

/// A use that nobody knows would be passed over, and each building planned as the map says.
fn check_use(Planning { typologies, choices }: Planning<'_>) -> Result<(), Faults> {
    let Some(unknown) = choices.use_name.as_ref().filter(|name| !typologies.uses.contains_key(*name)) else {
        return Ok(());
    };
    let fault = Fault::of_file(Path::new("--use"), format!("unknown use \"{unknown}\""));
    let hint = did_you_mean(unknown, typologies.uses.keys());
    Err(fault.with_hint(hint.unwrap_or_else(|| "see `uses` in typologies.yaml".to_owned())).into())
}

/// The numbers of the buildings that are asked for. The id of a building that is several stands for all of them.
fn chosen(ReadSite { site, notes, .. }: &ReadSite, planning: Planning<'_>) -> Vec<usize> {
    let choices = planning.choices;
    let split: Vec<&str> = notes.split.iter().map(|split| split.id.as_str()).collect();
    let is_piece_of = |id: &str, whole: &str| {
        let number = id.strip_prefix(whole).and_then(|rest| rest.strip_prefix('-'));
        number.is_some_and(|number| number.parse::<usize>().is_ok()) && split.contains(&whole)
    };
    let box_of_choice = choices.bounds.and_then(|bounds| on_plane(site, bounds));
    let is_chosen = |index: &usize| {
        let footprint = &site.footprints[*index];
        let is_meant = |id: &String| *id == footprint.id || is_piece_of(&footprint.id, id);
        let is_named = choices.only.is_empty() || choices.only.iter().any(is_meant);
        let middle = footprint.region.outline.bounds().center();
        is_named && (choices.bounds.is_none() || box_of_choice.is_some_and(|bounds| bounds.contains(middle)))
    };
    (0..site.footprints.len()).filter(is_chosen).collect()
}

/// A box in the units of the map, west, south, east, north, on the plane of the site.
fn on_plane(site: &Site, [west, south, east, north]: [f64; 4]) -> Option<Bounds> {
    let Origin { position: [x, y], degrees, is_in_feet } = site.origin;
    let is_degrees = degrees == Some([x, y]);
    let unit = if is_in_feet { US_FOOT } else { 1.0 };
    let point = |x_of: f64, y_of: f64| match is_degrees {
        true => LocalPlane::at(x, y).map(|plane| plane.project(x_of, y_of)),
        false => Some(Point::new(x_of - x, y_of - y) * unit),
    };
    Some(Bounds::new(point(west, south)?, point(east, north)?))
}
