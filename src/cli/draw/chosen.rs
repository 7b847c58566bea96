//! Selects the levels that the options name, by file.

use std::path::Path;

use super::super::arguments::DrawArguments;
use crate::document::{Fault, Faults, did_you_mean};
use crate::plan::{Level, PlacedBuilding};
use crate::project::Project;

/// A level to draw.
#[derive(Clone, Copy)]
pub(super) struct Subject<'a> {
    /// The building around it.
    pub(super) placed: &'a PlacedBuilding,
    pub(super) level: &'a Level,
}

/// The levels of one file; several are of one building, from below to above.
pub(super) type Page<'a> = Vec<Subject<'a>>;

/// The levels that were asked for, sorted by building and level as in the output folder.
///
/// # Errors
/// If there is no such building or level.
pub(super) fn chosen_levels<'a>(
    arguments: &DrawArguments,
    sources: &'a Project,
) -> Result<Vec<Subject<'a>>, Faults> {
    let buildings = &sources.plan.buildings;
    let of_building =
        |placed: &&PlacedBuilding| arguments.building.as_ref().is_none_or(|id| *id == placed.id);
    let chosen: Vec<&PlacedBuilding> = buildings.iter().filter(of_building).collect();
    if let (Some(id), true) = (&arguments.building, chosen.is_empty()) {
        return Err(unknown("building", id, buildings.iter().map(|placed| placed.id.clone()).collect()));
    }
    let subjects = |placed: &'a PlacedBuilding| {
        placed.building.levels.iter().map(move |level| Subject { placed, level })
    };
    let levels: Vec<Subject<'_>> = chosen.into_iter().flat_map(subjects).collect();
    let of_level = |subject: &&Subject<'_>| arguments.level.as_ref().is_none_or(|id| *id == subject.level.id);
    let mut found: Vec<Subject<'_>> = levels.iter().filter(of_level).copied().collect();
    if let (Some(id), true) = (&arguments.level, found.is_empty()) {
        return Err(unknown("level", id, levels.iter().map(|subject| subject.level.id.clone()).collect()));
    }
    found.sort_by(|a, b| (&a.placed.id, &a.level.id).cmp(&(&b.placed.id, &b.level.id)));
    Ok(found)
}

fn unknown(what: &str, id: &str, known: Vec<String>) -> Faults {
    let fault = Fault::of_file(Path::new(&format!("--{what}")), format!("no {what} \"{id}\""));
    match did_you_mean(id, known) {
        Some(hint) => fault.with_hint(hint).into(),
        None => fault.into(),
    }
}

/// One file for each level, or a sheet for each building.
pub(super) fn pages(subjects: Vec<Subject<'_>>, is_sheet: bool) -> Vec<Page<'_>> {
    if !is_sheet {
        return subjects.into_iter().map(|subject| vec![subject]).collect();
    }
    let mut pages: Vec<Page<'_>> = Vec::new();
    for subject in subjects {
        match pages.last_mut() {
            Some(page) if page[0].placed.id == subject.placed.id => page.push(subject),
            _ => pages.push(vec![subject]),
        }
    }
    for page in &mut pages {
        page.sort_by(|a, b| a.level.elevation.total_cmp(&b.level.elevation));
    }
    pages
}
