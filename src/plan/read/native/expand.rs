//! Expands a plan file into drafts: repeats levels, places prototypes, completes ids.

use std::collections::{BTreeMap, BTreeSet};

use super::file::{LevelFile, OutlineWord, PlaceFile, PlanFile, Prototype};
use super::ids::{FILE_NAME_FORBIDDEN, NODE_NAME_FORBIDDEN, id_fault};
use super::level_parts::LevelParts;
use super::motion::Motion;
use super::numbers::number_rooms;
use super::origins::LevelOrigins;
use super::pattern::{PatternValues, expand, names_value};
use super::report::{Report, item, step};
use super::scope::Scope;
use crate::document::{PathStep, did_you_mean};
use crate::geometry::Point;
use crate::plan::limits::{BUILDING_LEVELS, BUILDING_ROOMS};
use crate::plan::{BuildingDraft, LevelDraft, OutlineKind};

/// Metres from floor to floor where nothing is said.
const USUAL_LEVEL_HEIGHT: f64 = 3.0;
/// Metres of walls to the open air where nothing is said.
const USUAL_EXTERIOR_THICKNESS: f64 = 0.3;
/// Metres of walls between rooms that share an edge where nothing is said.
const USUAL_INTERIOR_THICKNESS: f64 = 0.1;

/// A building whose prototypes are placed and whose levels are repeated, and where all of it was written.
pub(super) struct Expanded {
    pub(super) draft: BuildingDraft,
    pub(super) origins: Vec<LevelOrigins>,
}

/// Expands a file without the rooms at some document paths; what is wrong goes to the report.
pub(super) fn expand_building(
    file: &PlanFile,
    left_out: &BTreeSet<Vec<PathStep>>,
    report: &mut Report<'_>,
) -> Expanded {
    let draft = BuildingDraft {
        name: file.name.clone(),
        attribution: file.attribution.clone(),
        ..BuildingDraft::default()
    };
    let mut expansion = Expansion {
        file,
        left_out,
        report,
        result: Expanded { draft, origins: Vec::new() },
        next_number: 0,
        next_elevation: 0.0,
        level_ids: BTreeMap::new(),
        room_count: 0,
    };
    for (index, level) in file.levels.iter().enumerate() {
        expansion.add_levels(index, level);
    }
    expansion.result
}

struct Expansion<'a, 'b> {
    file: &'a PlanFile,
    /// Document paths of rooms that are not placed.
    left_out: &'a BTreeSet<Vec<PathStep>>,
    report: &'a mut Report<'b>,
    result: Expanded,
    next_number: i64,
    next_elevation: f64,
    /// Where each level's id was written.
    level_ids: BTreeMap<String, Vec<PathStep>>,
    room_count: usize,
}

impl<'a> Expansion<'a, '_> {
    fn add_levels(&mut self, index: usize, level: &'a LevelFile) {
        let path: Vec<PathStep> = vec!["levels".into(), index.into()];
        let count = level.repeat.unwrap_or(1) as usize;
        if self.result.draft.levels.len() + count > BUILDING_LEVELS {
            let message = format!("the building has more than {BUILDING_LEVELS} levels");
            self.report.error(&step(&path, "repeat"), message, None);
            return;
        }
        if count > 1 && !names_value(&level.id, "n") {
            let hint = Some(format!("write \"{{n}}\" into it: \"{}-{{n}}\"", level.id));
            self.report.error(
                &step(&path, "id"),
                format!("{count} levels have the id \"{}\"", level.id),
                hint,
            );
            return;
        }
        let metres = |length: f64| self.file.units.to_metres(length);
        let height = level.height.map_or(USUAL_LEVEL_HEIGHT, metres);
        self.next_elevation = level.elevation.map_or(self.next_elevation, metres);
        self.next_number = level.number.unwrap_or(self.next_number);
        for _ in 0..count {
            if self.room_count > BUILDING_ROOMS {
                return;
            }
            self.add_level(&path, level, height);
            self.next_number = self.next_number.saturating_add(1);
            self.next_elevation += height;
        }
    }

    fn add_level(&mut self, path: &[PathStep], level: &'a LevelFile, height: f64) {
        let values = PatternValues { n: Some(self.next_number), level: Some(self.next_number), id: None };
        let Some(id) = self.expand_id(&step(path, "id"), &level.id, &values, FILE_NAME_FORBIDDEN) else {
            return;
        };
        let name = level.name.as_deref().unwrap_or("");
        let Some(name) = self.expand_text(&step(path, "name"), name, &values) else { return };
        if let Some(first) = self.level_ids.insert(id.clone(), step(path, "id")) {
            let first = self.report.line_of(&first).unwrap_or_default();
            let message = format!("level id \"{id}\" is used twice, first in line {first}");
            let hint = Some("ids of levels are unique in a building".to_owned());
            self.report.error(&step(path, "id"), message, hint);
        }
        let metres = |length: f64| self.file.units.to_metres(length);
        let thickness = |given: Option<f64>, usual: f64| given.map_or(usual, metres);
        let draft = LevelDraft {
            id: id.clone(),
            name,
            elevation: self.next_elevation,
            height,
            exterior_thickness: thickness(self.file.walls.exterior, USUAL_EXTERIOR_THICKNESS),
            interior_thickness: thickness(self.file.walls.interior, USUAL_INTERIOR_THICKNESS),
            outlines: match self.file.outlines {
                OutlineWord::Inner => OutlineKind::Inner,
                OutlineWord::Center => OutlineKind::Center,
            },
            ..LevelDraft::default()
        };
        let origins = LevelOrigins { path: path.to_vec(), id, ..LevelOrigins::default() };
        let mut parts = LevelParts { draft, origins, ..LevelParts::default() };
        self.fill(path, level, &mut parts);
        self.room_count += parts.draft.rooms.len();
        if self.room_count > BUILDING_ROOMS {
            self.report.error(path, format!("the building has more than {BUILDING_ROOMS} rooms"), None);
        }
        self.result.draft.levels.push(parts.draft);
        self.result.origins.push(parts.origins);
    }

    /// All rooms first, so that openings find the rooms they name wherever those stand in the file.
    fn fill(&mut self, path: &[PathStep], level: &'a LevelFile, parts: &mut LevelParts) {
        let units = self.file.units;
        let own = Scope {
            units,
            level: self.next_number,
            style: level.style.as_ref().or(self.file.style.as_ref()),
            household: level.household.as_ref(),
            motion: Motion::NONE,
            path: path.to_vec(),
            instance: None,
            rooms: &[],
            left_out: self.left_out,
        };
        let placed = self.placed_scopes(path, level, &own);
        own.add_rooms(&level.rooms, parts, self.report);
        for (scope, prototype) in &placed {
            scope.add_rooms(&prototype.rooms, parts, self.report);
        }
        own.add_openings(&level.openings, parts, self.report);
        own.add_columns(&level.columns, parts);
        for (scope, prototype) in &placed {
            scope.add_openings(&prototype.openings, parts, self.report);
            scope.add_columns(&prototype.columns, parts);
        }
        for railing in &level.railings {
            parts.draft.railings.push(railing.iter().map(|point| own.point(*point)).collect());
        }
        number_rooms(parts, self.report);
    }

    fn placed_scopes(
        &mut self,
        path: &[PathStep],
        level: &'a LevelFile,
        own: &Scope<'a>,
    ) -> Vec<(Scope<'a>, &'a Prototype)> {
        let mut placed = Vec::new();
        let mut ids = BTreeSet::new();
        for (index, place) in level.place.iter().enumerate() {
            let path = item(path, "place", index);
            let Some(prototype) = self.file.prototypes.get(&place.prototype) else {
                let hint = did_you_mean(&place.prototype, self.file.prototypes.keys());
                let message = format!("unknown prototype \"{}\"", place.prototype);
                self.report.error(&step(&path, "prototype"), message, hint);
                continue;
            };
            for scope in self.copies(&path, place, prototype, own) {
                let id = scope.instance_id().unwrap_or_default().to_owned();
                if !ids.insert(id.clone()) {
                    let message = format!("id \"{id}\" is placed twice");
                    let hint = "count with {n}, and let `first` tell the rows apart";
                    self.report.error(&step(&path, "id"), message, Some(hint.to_owned()));
                    break;
                }
                placed.push((scope, prototype));
                if placed.len() > BUILDING_ROOMS {
                    let message = format!("the level has more than {BUILDING_ROOMS} copies");
                    self.report.error(&path, message, None);
                    return placed;
                }
            }
        }
        placed
    }

    fn copies(
        &mut self,
        path: &[PathStep],
        place: &'a PlaceFile,
        prototype: &'a Prototype,
        own: &Scope<'a>,
    ) -> Vec<Scope<'a>> {
        let repeat = place.repeat.as_ref();
        let count = repeat.map_or(1, |repeat| repeat.count);
        if count as usize > BUILDING_ROOMS {
            self.report.error(&step(path, "repeat"), format!("{count} copies are too many"), None);
            return Vec::new();
        }
        let step_by = repeat.map_or(Point::ZERO, |repeat| own.point(repeat.step));
        let number_step = repeat.and_then(|repeat| repeat.number_step).unwrap_or(1);
        let usual = format!("{}-{{n}}", place.prototype);
        let pattern = place.id.as_deref().unwrap_or(&usual);
        if count > 1 && !names_value(pattern, "n") {
            let message = format!("{count} copies have the id \"{pattern}\"");
            self.report.error(&step(path, "id"), message, Some("write \"{n}\" into it".to_owned()));
            return Vec::new();
        }
        let motion = Motion::new(place.mirror, place.turn, own.point(place.at));
        let prototype_path = vec!["prototypes".into(), place.prototype.as_str().into()];
        let copy = |number: u32| {
            let n = place.first.unwrap_or(1).saturating_add(number_step.saturating_mul(i64::from(number)));
            let values = PatternValues { n: Some(n), level: Some(own.level), id: None };
            let id = self.expand_id(&step(path, "id"), pattern, &values, NODE_NAME_FORBIDDEN)?;
            let motion = motion.moved(step_by * f64::from(number));
            let instance = Some((id, path.to_vec()));
            let path = prototype_path.clone();
            Some(Scope { motion, path, instance, rooms: &prototype.rooms, ..own.clone() })
        };
        (0..count).map_while(copy).collect()
    }

    fn expand_text(
        &mut self,
        path: &[PathStep],
        pattern: &str,
        values: &PatternValues<'_>,
    ) -> Option<String> {
        expand(pattern, values).map_err(|(message, hint)| self.report.error(path, message, Some(hint))).ok()
    }

    fn expand_id(
        &mut self,
        path: &[PathStep],
        pattern: &str,
        values: &PatternValues<'_>,
        forbidden: &[char],
    ) -> Option<String> {
        let id = self.expand_text(path, pattern, values)?;
        match id_fault(&id, forbidden) {
            None => Some(id),
            Some(message) => {
                self.report.error(path, message, Some("letters, digits, - and _ are safe".to_owned()));
                None
            }
        }
    }
}
