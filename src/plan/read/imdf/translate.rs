//! Turns features into drafts of buildings.

use std::collections::{BTreeMap, BTreeSet};

use super::features::{LevelProperties, OpeningProperties, UnitProperties, label};
use super::{Archive, NAME};
use crate::document::{FaultSeverity, Faults, PathStep};
use crate::geometry::Point;
use crate::plan::read::foreign::{TypeOfWord, UniqueIds, slug, unknown_words};
use crate::plan::read::geojson::{Feature, Geometry, outlines, plane_of, points};
use crate::plan::read::indoor::{STOREY_HEIGHT, Storey, opening_along};
use crate::plan::read::reader::{DraftedBuilding, ReadBuildings, ReadResult};
use crate::plan::read::room_names::{most_telling, plain_words, type_of_words};
use crate::plan::units::LocalPlane;
use crate::plan::{
    BuildingDraft, LevelDraft, OpeningDraft, OpeningKind, RoomDraft, RoomWords, SiteOrigin, SitePlacement,
};

/// The type of "Room 12": a name that says no more.
const PLAIN_ROOM: &str = "room";

/// All buildings with levels, and warnings for unknown words and lost features.
pub(super) fn buildings(archive: &Archive, words: &RoomWords) -> ReadResult {
    let mut translation = Translation::of(archive, words);
    translation.report_strays();
    let mut buildings = Vec::new();
    let mut ids = UniqueIds::default();
    let site = plane_of(translation.levels.values().flatten().filter_map(|level| level.geometry.as_ref()));
    for building in &archive.buildings.features {
        let levels = translation.levels_of(&building.id);
        if levels.is_empty() {
            continue;
        }
        let name = label(building.properties.name.as_ref());
        // A name that reads well in paths, or the feature's own id.
        let wanted = [slug(name.as_deref().unwrap_or_default()), building.id.clone()];
        let id = ids.first_free(wanted).unwrap_or_else(|| building.id.clone());
        let Some(plane) = translation.plane(&levels) else { continue };
        let levels = translation.levels(&levels, &plane);
        buildings.push(DraftedBuilding {
            id,
            draft: BuildingDraft { name, levels, ..BuildingDraft::default() },
            placement: placement(&plane, site.as_ref()),
            ..DraftedBuilding::default()
        });
    }
    translation.report_unknown_words();
    let origin = site.map(|site| site.degrees(Point::ZERO)).and_then(|at| SiteOrigin::at(at.x, at.y, 0.0));
    Ok(ReadBuildings { origin, ..ReadBuildings::new(buildings, translation.faults)? })
}

/// Where the frame of a building is on the site, to the millimetre.
fn placement(building: &LocalPlane, site: Option<&LocalPlane>) -> SitePlacement {
    const PARTS: f64 = 1_000.0;
    let at = building.degrees(Point::ZERO);
    let position = site.map_or(Point::ZERO, |site| site.project(at.x, at.y));
    // Adding zero makes a negative zero positive.
    SitePlacement { position: (position * PARTS).round() / PARTS + Point::ZERO, turn: 0.0 }
}

struct Translation<'a> {
    archive: &'a Archive,
    words: &'a RoomWords,
    /// By building; a level of several buildings belongs to the first it names that there is.
    levels: BTreeMap<&'a str, Vec<&'a Feature<LevelProperties>>>,
    /// With their places in the file, by level.
    units: BTreeMap<&'a str, Vec<(usize, &'a Feature<UnitProperties>)>>,
    /// By level.
    openings: BTreeMap<&'a str, Vec<&'a Feature<OpeningProperties>>>,
    /// Whether no opening has a leaf: then the map's maker left the editor's preset alone.
    is_open_preset: bool,
    /// word → (place of its first unit, how many).
    unknown: BTreeMap<String, (usize, usize)>,
    faults: Faults,
}

impl<'a> Translation<'a> {
    fn of(archive: &'a Archive, words: &'a RoomWords) -> Self {
        let openings = archive.openings.as_ref().map(|table| table.features.as_slice()).unwrap_or_default();
        let known: BTreeSet<&str> =
            archive.buildings.features.iter().map(|building| building.id.as_str()).collect();
        let mut all = Self {
            archive,
            words,
            levels: BTreeMap::new(),
            units: BTreeMap::new(),
            openings: BTreeMap::new(),
            is_open_preset: openings.iter().all(|opening| door_kind(opening) == Some("open")),
            unknown: BTreeMap::new(),
            faults: Faults::default(),
        };
        for level in &archive.levels.features {
            if let Some(building) = first_building(level, &known) {
                all.levels.entry(building).or_default().push(level);
            }
        }
        for (index, unit) in archive.units.features.iter().enumerate() {
            all.units.entry(unit.properties.level_id.as_str()).or_default().push((index, unit));
        }
        for opening in openings {
            all.openings.entry(opening.properties.level_id.as_str()).or_default().push(opening);
        }
        all
    }

    /// The levels of a building, lowest first.
    fn levels_of(&self, building: &str) -> Vec<&'a Feature<LevelProperties>> {
        let mut levels = self.levels.get(building).cloned().unwrap_or_default();
        levels.sort_by_key(|level| level.properties.ordinal);
        levels
    }

    /// The plane of a building, at the middle of its levels; a fault if that is nowhere.
    fn plane(&mut self, levels: &[&'a Feature<LevelProperties>]) -> Option<LocalPlane> {
        let plane = plane_of(levels.iter().filter_map(|level| level.geometry.as_ref()));
        if plane.is_none() {
            let index = levels[0].index_in(&self.archive.levels.features);
            let path = [PathStep::from("features"), index.into(), "geometry".into()];
            let hint = Some("longitude and latitude in degrees are needed".to_owned());
            let message = "the levels of a building are nowhere on Earth";
            self.faults.push(self.archive.levels.source.fault(&path, message, hint, FaultSeverity::Error));
        }
        plane
    }

    fn levels(&mut self, levels: &[&'a Feature<LevelProperties>], plane: &LocalPlane) -> Vec<LevelDraft> {
        let mut copies: BTreeMap<i32, u32> = BTreeMap::new();
        levels
            .iter()
            .map(|level| {
                let ordinal = level.properties.ordinal;
                let copy = copies.entry(ordinal).or_default();
                *copy += 1;
                let suffix = if *copy > 1 { format!("_{copy}") } else { String::new() };
                self.level(level, format!("level_{ordinal}{suffix}"), plane)
            })
            .collect()
    }

    fn level(&mut self, level: &Feature<LevelProperties>, id: String, plane: &LocalPlane) -> LevelDraft {
        let units = self.units.get(level.id.as_str()).cloned().unwrap_or_default();
        let rooms = units.into_iter().flat_map(|(index, unit)| self.rooms(index, unit, plane)).collect();
        let storey = Storey {
            id,
            name: label(level.properties.name.as_ref()).unwrap_or_default(),
            elevation: f64::from(level.properties.ordinal) * STOREY_HEIGHT,
            height: STOREY_HEIGHT,
            rooms,
            openings: self.openings(&level.id, plane),
        };
        storey.into()
    }

    fn rooms(&mut self, index: usize, unit: &Feature<UnitProperties>, plane: &LocalPlane) -> Vec<RoomDraft> {
        let TypeOfWord { room_type, unknown_word } = self.room_type(index, unit);
        let occupant = self.archive.occupants.get(&unit.id);
        let name =
            label(unit.properties.name.as_ref()).or_else(|| occupant.and_then(|tenant| tenant.name.clone()));
        let outlines = unit.geometry.as_ref().map(|geometry| outlines(geometry, plane)).unwrap_or_default();
        let rooms = outlines.into_iter().enumerate().map(|(part, outline)| RoomDraft {
            id: if part == 0 { unit.id.clone() } else { format!("{}.{}", unit.id, part + 1) },
            name: name.clone(),
            room_type: room_type.clone(),
            unknown_word: unknown_word.clone(),
            outline: outline.outer,
            holes: outline.holes,
            ..RoomDraft::default()
        });
        rooms.collect()
    }

    fn room_type(&mut self, index: usize, unit: &Feature<UnitProperties>) -> TypeOfWord {
        let word = unit.properties.category.as_deref().unwrap_or_default();
        let tenant = self.archive.occupants.get(&unit.id).and_then(|tenant| tenant.category.as_deref());
        let own = self.words.room_type(NAME, word);
        let lent = tenant.and_then(|category| self.words.room_type(NAME, category));
        // The tenant and then the name are asked where the word says no more than "a room".
        let name = label(unit.properties.name.as_ref()).map(|name| plain_words(&name)).unwrap_or_default();
        let named = type_of_words(self.words, &[NAME, "ifc"], &name).filter(|named| *named != PLAIN_ROOM);
        if let Some(found) = most_telling([own, lent, named].into_iter().flatten()) {
            return TypeOfWord::known(word, found);
        }
        if !word.is_empty() {
            self.unknown.entry(word.to_owned()).or_insert((index, 0)).1 += 1;
        }
        TypeOfWord::unknown(word)
    }

    fn openings(&self, level: &str, plane: &LocalPlane) -> Vec<OpeningDraft> {
        let mine = self.openings.get(level).into_iter().flatten();
        mine.filter_map(|opening| {
            let Some(Geometry::LineString { coordinates }) = &opening.geometry else { return None };
            let kind = match door_kind(opening) {
                Some("open") if !self.is_open_preset => OpeningKind::Passage,
                Some("sliding" | "movablepartition" | "shutter") => OpeningKind::SlidingDoor,
                _ => OpeningKind::Door,
            };
            opening_along(&opening.id, kind, &points(coordinates, plane))
        })
        .collect()
    }

    /// Units and openings that no level of a building takes, and those without a shape.
    fn report_strays(&mut self) {
        let archive = self.archive;
        let levels: BTreeSet<&str> = self.levels.values().flatten().map(|level| level.id.as_str()).collect();
        let mut faults = Faults::default();
        let mut report = |source: &crate::document::Source, index: usize, key: &str, message: String| {
            let path = [PathStep::from("features"), index.into(), key.into()];
            let hint = Some("it was left out".to_owned());
            faults.push(source.fault(&path, message, hint, FaultSeverity::Warning));
        };
        for (index, unit) in archive.units.features.iter().enumerate() {
            if !levels.contains(unit.properties.level_id.as_str()) {
                report(&archive.units.source, index, "properties", stray("unit", &unit.id));
            } else if !matches!(
                &unit.geometry,
                Some(Geometry::Polygon { .. } | Geometry::MultiPolygon { .. })
            ) {
                report(&archive.units.source, index, "geometry", format!("unit {} is no area", unit.id));
            }
        }
        for (index, opening) in archive.openings.iter().flat_map(|table| table.features.iter().enumerate()) {
            let Some(table) = &archive.openings else { continue };
            if !levels.contains(opening.properties.level_id.as_str()) {
                report(&table.source, index, "properties", stray("opening", &opening.id));
            } else if !matches!(&opening.geometry, Some(Geometry::LineString { coordinates }) if coordinates.len() > 1)
            {
                report(&table.source, index, "geometry", format!("opening {} is no line", opening.id));
            }
        }
        self.faults.merge(faults);
    }

    fn report_unknown_words(&mut self) {
        let source = &self.archive.units.source;
        let warnings = unknown_words(NAME, &self.unknown).map(|(index, message, hint)| {
            let path = [PathStep::from("features"), (*index).into(), "properties".into(), "category".into()];
            source.fault(&path, message, Some(hint), FaultSeverity::Warning)
        });
        self.faults.0.extend(warnings);
    }
}

/// The first building of a level that is one of those of the file.
fn first_building<'a>(level: &'a Feature<LevelProperties>, known: &BTreeSet<&str>) -> Option<&'a str> {
    let buildings = level.properties.building_ids.as_ref()?;
    buildings.iter().map(String::as_str).find(|building| known.contains(building))
}

fn stray(what: &str, id: &str) -> String {
    format!("{what} {id} is on no level of a building")
}

fn door_kind(opening: &Feature<OpeningProperties>) -> Option<&str> {
    opening.properties.door.as_ref()?.kind.as_deref()
}

impl<P> Feature<P> {
    fn index_in(&self, features: &[Self]) -> usize {
        features.iter().position(|feature| std::ptr::eq(feature, self)).unwrap_or_default()
    }
}
