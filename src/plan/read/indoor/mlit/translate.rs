//! Turns the features of a building into its draft.

use std::collections::{BTreeMap, BTreeSet};

use super::NAME;
use super::features::{Feature, FloorProperties, SpaceProperties, StoreyFiles};
use super::frame::Frame;
use crate::document::{FaultSeverity, Faults, PathStep, Source};
use crate::geometry::Point;
use crate::plan::read::foreign::{TypeOfWord, unknown_words};
use crate::plan::read::geojson::{Geometry, Position, corners_of};
use crate::plan::read::indoor::storey::{STOREY_HEIGHT, Storey, opening_along};
use crate::plan::read::native::number_of_id;
use crate::plan::read::reader::DraftedBuilding;
use crate::plan::read::rings::Rings;
use crate::plan::{BuildingDraft, OpeningDraft, OpeningKind, RoomDraft, RoomWords, SiteOrigin};

/// Parts in which ordinals are counted: mezzanines have `1.5`.
const ORDINAL_PARTS: f64 = 100.0;
/// The farthest storey that is believed.
const FARTHEST_ORDINAL: f64 = 300.0;

/// By which the ministry asks to be named ("source: MLIT, indoor map, changed"). The files do not have the title of their data set.
const ATTRIBUTION: &str = "出典：国土交通省 屋内地図オープンデータを加工 (MLIT, Japan)";

/// The draft of a building, where it is on the earth, and warnings.
///
/// # Errors
/// Faults that leave no building.
pub(super) fn building(
    id: &str,
    storeys: &[StoreyFiles],
    words: &RoomWords,
) -> Result<(DraftedBuilding, Option<SiteOrigin>, Faults), Faults> {
    let frame = frame_of(storeys)?;
    let mut translation = Translation {
        frame,
        words,
        levels: BTreeMap::new(),
        unknown: BTreeMap::new(),
        faults: Faults::default(),
    };
    for (number, storey) in storeys.iter().enumerate() {
        translation.add_storey(number, storey);
    }
    translation.report_fixtures(storeys);
    translation.report_unknown_words(storeys);
    let levels = translation.levels.into_values().filter(|level| !level.rooms.is_empty());
    let building = DraftedBuilding {
        id: id.to_owned(),
        draft: BuildingDraft {
            attribution: Some(ATTRIBUTION.to_owned()),
            levels: levels.map(Into::into).collect(),
            ..BuildingDraft::default()
        },
        is_settled: true,
        ..DraftedBuilding::default()
    };
    Ok((building, translation.frame.origin(), translation.faults))
}

/// The plane of all files, which name the same reference system.
fn frame_of(storeys: &[StoreyFiles]) -> Result<Frame, Faults> {
    let mut systems: BTreeMap<Option<&str>, &Source> = BTreeMap::new();
    for storey in storeys {
        let spaces = (storey.spaces.reference_system.as_deref(), &storey.spaces.source);
        let openings = storey.openings.as_ref().filter(|table| !table.features.is_empty());
        let openings = openings.map(|table| (table.reference_system.as_deref(), &table.source));
        for (system, source) in [Some(spaces), openings].into_iter().flatten() {
            systems.entry(system).or_insert(source);
        }
    }
    let geometries = storeys.iter().flat_map(|storey| &storey.spaces.features);
    let geometries = geometries.filter_map(|space| space.geometry.as_ref());
    let corners: Vec<Point> = geometries.flat_map(corners_of).collect();
    let (system, source) =
        systems.iter().next_back().map_or((None, None), |(system, source)| (*system, Some(*source)));
    let found = match systems.len() {
        0 | 1 => Frame::of(system, &corners),
        _ => {
            let names: Vec<&str> = systems.keys().map(|name| name.unwrap_or("none")).collect();
            let message = format!("the files name different reference systems: {}", names.join(", "));
            Err((message, "convert all of them to one".to_owned()))
        }
    };
    found.map_err(|(message, hint)| match source {
        Some(source) => {
            Faults::from(source.fault(&["crs".into()], message, Some(hint), FaultSeverity::Error))
        }
        None => Faults::default(),
    })
}

struct Translation<'a> {
    frame: Frame,
    words: &'a RoomWords,
    /// By ordinal, in parts.
    levels: BTreeMap<i32, Storey>,
    /// Code without a room type → (its first space: number of the storey and index, how many).
    unknown: BTreeMap<String, ((usize, usize), usize)>,
    faults: Faults,
}

impl Translation<'_> {
    fn add_storey(&mut self, number: usize, storey: &StoreyFiles) {
        let mut levels: BTreeMap<&str, i32> = BTreeMap::new();
        for (index, floor) in storey.floors.features.iter().enumerate() {
            match self.add_floor(floor) {
                Some(level) => _ = levels.insert(floor.properties.id.as_str(), level),
                None => {
                    let message = format!("ordinal {} of a floor is no storey", floor.properties.ordinal);
                    self.warn(&storey.floors.source, index, "properties", message);
                }
            }
        }
        let mut taken = BTreeSet::new();
        for (index, space) in storey.spaces.features.iter().enumerate() {
            let SpaceProperties { id, floor_id, .. } = &space.properties;
            let source = &storey.spaces.source;
            let areas = space.geometry.as_ref().map(|geometry| self.areas(geometry)).unwrap_or_default();
            let Some(&level) = levels.get(floor_id.as_str()) else {
                self.warn(source, index, "properties", format!("space {id} is on no floor"));
                continue;
            };
            if areas.is_empty() {
                self.warn(source, index, "geometry", format!("space {id} is no area"));
            } else if taken.insert(id.as_str()) {
                let rooms = self.rooms((number, index), &space.properties, areas);
                self.levels.entry(level).or_default().rooms.extend(rooms);
            } else {
                self.warn(source, index, "properties", format!("the id of space {id} is taken"));
            }
        }
        self.add_openings(storey, &levels);
    }

    /// The level of a floor, in parts of ordinals; `None` of one that is none.
    fn add_floor(&mut self, floor: &Feature<FloorProperties>) -> Option<i32> {
        let FloorProperties { ordinal, name, .. } = &floor.properties;
        if ordinal.is_nan() || ordinal.abs() > FARTHEST_ORDINAL {
            return None;
        }
        let key = (ordinal * ORDINAL_PARTS).round() as i32;
        let ordinal = f64::from(key) / ORDINAL_PARTS;
        let level = self.levels.entry(key).or_insert_with(|| Storey {
            id: format!("level_{ordinal}"),
            // Buildings are counted from 1, and open ground lies as high as their ground floors.
            elevation: STOREY_HEIGHT * if ordinal >= 0.0 { (ordinal - 1.0).max(0.0) } else { ordinal },
            height: STOREY_HEIGHT,
            ..Storey::default()
        });
        if level.name.is_empty() {
            level.name = name.clone().unwrap_or_default();
        }
        Some(key)
    }

    fn rooms(&mut self, place: (usize, usize), space: &SpaceProperties, areas: Vec<Rings>) -> Vec<RoomDraft> {
        let code = space.category.as_deref().unwrap_or_default();
        let TypeOfWord { room_type, unknown_word } = match self.words.room_type(NAME, code) {
            Some(found) => TypeOfWord::known(code, found),
            None => {
                if !code.is_empty() {
                    self.unknown.entry(code.to_owned()).or_insert((place, 0)).1 += 1;
                }
                TypeOfWord::unknown(code)
            }
        };
        let room = |(part, area): (usize, Rings)| {
            let id = if part == 0 { space.id.clone() } else { format!("{}.{}", space.id, part + 1) };
            RoomDraft {
                number: Some(number_of_id(&id)),
                id,
                name: space.name.clone().filter(|name| !name.trim().is_empty()),
                room_type: room_type.clone(),
                unknown_word: unknown_word.clone(),
                outline: area.outer,
                holes: area.holes,
                ..RoomDraft::default()
            }
        };
        areas.into_iter().enumerate().map(room).collect()
    }

    fn add_openings(&mut self, storey: &StoreyFiles, levels: &BTreeMap<&str, i32>) {
        let Some(table) = &storey.openings else { return };
        for (index, opening) in table.features.iter().enumerate() {
            let id = &opening.properties.id;
            let Some(&level) = levels.get(opening.properties.floor_id.as_str()) else {
                self.warn(&table.source, index, "properties", format!("opening {id} is on no floor"));
                continue;
            };
            match self.opening(id, opening.geometry.as_ref()) {
                Some(opening) => self.levels.entry(level).or_default().openings.push(opening),
                None => self.warn(&table.source, index, "geometry", format!("opening {id} is no line")),
            }
        }
    }

    fn opening(&self, id: &str, geometry: Option<&Geometry>) -> Option<OpeningDraft> {
        let Some(Geometry::LineString { coordinates }) = geometry else { return None };
        let line: Vec<Point> = coordinates.iter().map(|position| self.frame.point(position)).collect();
        opening_along(id, OpeningKind::Door, &line).filter(|_| line.len() > 1)
    }

    fn areas(&self, geometry: &Geometry) -> Vec<Rings> {
        let ring = |line: &Vec<Position>| line.iter().map(|position| self.frame.point(position)).collect();
        let area = |lines: &Vec<Vec<Position>>| {
            let mut lines = lines.iter().map(ring);
            Rings { outer: lines.next().unwrap_or_default(), holes: lines.collect() }
        };
        match geometry {
            Geometry::Polygon { coordinates } => vec![area(coordinates)],
            Geometry::MultiPolygon { coordinates } => coordinates.iter().map(area).collect(),
            Geometry::Point { .. } | Geometry::LineString { .. } | Geometry::Other => Vec::new(),
        }
    }

    fn warn(&mut self, source: &Source, index: usize, key: &str, message: String) {
        let path = [PathStep::from("features"), index.into(), key.into()];
        let hint = Some("it was left out".to_owned());
        self.faults.push(source.fault(&path, message, hint, FaultSeverity::Warning));
    }

    /// The first warning counts what is not read, at the first storey that has any.
    fn report_fixtures(&mut self, storeys: &[StoreyFiles]) {
        let count: usize = storeys.iter().map(|storey| storey.fixture_count).sum();
        let Some(storey) = storeys.iter().find(|storey| storey.fixture_count > 0) else { return };
        let message = format!("{count} fixtures are not read");
        let hint = Some("they were left out: the map says no more of them than a code".to_owned());
        self.faults.push(storey.floors.source.fault(
            &["features".into()],
            message,
            hint,
            FaultSeverity::Warning,
        ));
    }

    fn report_unknown_words(&mut self, storeys: &[StoreyFiles]) {
        for (&(storey, index), message, hint) in unknown_words(NAME, &self.unknown) {
            let path = [PathStep::from("features"), index.into(), "properties".into(), "category".into()];
            let source = &storeys[storey].spaces.source;
            self.faults.push(source.fault(&path, message, Some(hint), FaultSeverity::Warning));
        }
    }
}
