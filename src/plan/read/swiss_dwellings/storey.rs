//! Turns the elements of a floor into a drawing with areas, and that into a level, as the program does that the data set was made
//! with.

use std::collections::BTreeMap;

use super::elements::{Element, Entity};
use super::notes::Notes;
use super::room_types::RoomTypes;
use crate::geometry::Point;
use crate::plan::LevelDraft;
use crate::plan::read::archilyse::areas::{Area, Outline};
use crate::plan::read::archilyse::drawing::{
    Drawing, Hole, HoleHeights, HoleProperties, Item, ItemProperties, Layer, Line, Measure, Rings,
};
use crate::plan::read::archilyse::level::{Floor, Heights, Naming, level};
use crate::plan::read::foreign::{WIDEST_LEAF, number_rooms};
use crate::plan::read::oriented::Oriented;
use crate::plan::read::solids::solid_pieces;
use crate::plan::units::CENTIMETRE;

/// Metres of a sill below which a window's elevation is that of its floor.
const LEAST_SILL: f64 = 0.05;
/// Metres of the lowest window that stands on the floor.
const LEAST_FRENCH_WINDOW: f64 = 2.0;
/// Metres between which the heights of rooms and doors lie.
const ROOM_HEIGHT: (f64, f64) = (1.8, 12.0);
/// Metres from a floor to the next that is that of one storey: others are missing between.
const STOREY: (f64, f64) = (2.2, 6.0);

/// A floor with its elements in an order that does not depend on that of the rows.
pub(super) struct Storey {
    /// The id of the floor in the table.
    pub(super) id: String,
    /// Metres of its floor.
    pub(super) elevation: f64,
    /// Each once: walls between two apartments have a row for each.
    pub(super) elements: Vec<Element>,
}

impl Storey {
    pub(super) fn of(id: &str, mut elements: Vec<Element>) -> Self {
        let key = |element: &Element| {
            let bounds = element.bounds();
            let millimetres = |value: f64| (value * 1000.0).round() as i64;
            let place = [bounds.low.x, bounds.low.y, bounds.high.x, bounds.high.y].map(millimetres);
            (element.entity, element.area_id, element.subtype.clone(), place)
        };
        elements.sort_by_cached_key(|element| (key(element), element.line));
        elements.dedup_by(|next, first| key(next) == key(first) && are_same(&next.outlines, &first.outlines));
        let of_kind = |entity: Entity| elements.iter().filter(move |element| element.entity == entity);
        let elevation = usual(of_kind(Entity::Area).filter_map(|area| area.elevation))
            .or_else(|| usual(of_kind(Entity::Separator).filter_map(|wall| wall.elevation)));
        Self { id: id.to_owned(), elevation: elevation.unwrap_or(0.0), elements }
    }

    /// The id of its level.
    pub(super) fn level_id(&self) -> String {
        format!("floor_{}", self.id)
    }

    fn of_kind(&self, entity: Entity) -> impl Iterator<Item = &Element> {
        self.elements.iter().filter(move |element| element.entity == entity)
    }

    fn heights(&self) -> Heights {
        let is_height = |height: &f64| (ROOM_HEIGHT.0..=ROOM_HEIGHT.1).contains(height);
        let heights = self.of_kind(Entity::Area).filter_map(|area| area.height).filter(is_height);
        let usual_heights = Heights::default();
        Heights { wall: usual(heights).unwrap_or(usual_heights.wall), ..usual_heights }
    }

    /// The areas by id, those of one id as one of several parts.
    fn areas(&self) -> Vec<(Area, Vec<Outline>)> {
        let mut areas: BTreeMap<i64, (Area, Vec<Outline>)> = BTreeMap::new();
        for (number, element) in self.of_kind(Entity::Area).enumerate() {
            // No id of the data set is below zero.
            let id = element.area_id.unwrap_or(-1 - number as i64);
            let area = || Area {
                id,
                area_type: element.subtype.to_string(),
                plan_id: None,
                scaled_polygon: String::new(),
            };
            areas
                .entry(id)
                .or_insert_with(|| (area(), Vec::new()))
                .1
                .extend(element.outlines.iter().cloned());
        }
        areas.into_values().collect()
    }

    /// The level; `above` are the metres from this floor to the next of its building.
    pub(super) fn draft(
        &self,
        above: Option<f64>,
        types: &mut RoomTypes<'_>,
        notes: &mut Notes,
    ) -> LevelDraft {
        let heights = self.heights();
        let drawing = self.drawing(heights, notes);
        let areas = self.areas();
        let dwellings: BTreeMap<i64, &String> = self
            .of_kind(Entity::Area)
            .filter_map(|area| Some((area.area_id?, area.dwelling.as_ref()?)))
            .collect();
        let mut first_lines: BTreeMap<&str, usize> = BTreeMap::new();
        for area in self.of_kind(Entity::Area) {
            let line = first_lines.entry(&*area.subtype).or_insert(area.line);
            *line = area.line.min(*line);
        }
        let floor = Floor {
            drawing: &drawing,
            pixel: 1.0,
            areas: areas.iter().map(|(area, outlines)| (area, outlines.clone())).collect(),
            heights,
            number: 0,
        };
        let mut naming = Naming {
            room_type: &mut |area, is_toilet| {
                let line = first_lines.get(area.area_type.as_str()).copied().unwrap_or(1);
                types.of(&area.area_type, is_toilet, line)
            },
            apartment: &|area| dwellings.get(&area.id).map(|dwelling| (*dwelling).clone()),
        };
        let storey = above.filter(|metres| (STOREY.0..=STOREY.1).contains(metres) && *metres > heights.wall);
        let mut draft = LevelDraft {
            id: self.level_id(),
            name: format!("Floor {}", self.id),
            elevation: self.elevation,
            ..level(&floor, &mut naming)
        };
        draft.height = storey.unwrap_or(draft.height);
        number_rooms(&mut draft.rooms);
        draft
    }

    fn drawing(&self, heights: Heights, notes: &mut Notes) -> Drawing {
        let mut layer = Layer { lines: BTreeMap::new(), holes: BTreeMap::new(), items: BTreeMap::new() };
        for (number, element) in self.elements.iter().enumerate() {
            let kind = element.subtype.to_lowercase();
            let key = format!("{kind}_{number:06}");
            match (element.entity, kind.as_str()) {
                (Entity::Area, _) => {}
                (Entity::Separator, "wall" | "railing" | "column") => {
                    for (part, ring) in element.outlines.iter().flat_map(solid_pieces).enumerate() {
                        let line = Line { kind: kind.clone(), coordinates: rings(&ring) };
                        layer.lines.insert(format!("{key}_{part}"), line);
                    }
                }
                (Entity::Opening, "door" | "entrance_door" | "window") => {
                    let hole = self.hole(element, &kind, heights);
                    layer.holes.extend(hole.map(|hole| (key, hole)));
                }
                (Entity::Feature, _) => layer.items.extend(item(element, &kind).map(|item| (key, item))),
                _ => notes.unknown_kind(element.line, &element.subtype),
            }
        }
        Drawing { scale: 1.0, layers: [("floor".to_owned(), layer)].into() }
    }

    /// A door or window; `None` for a point.
    fn hole(&self, element: &Element, kind: &str, heights: Heights) -> Option<Hole> {
        let around = Oriented::around(&element.outlines[0].outer)?;
        let is_sliding = kind == "door" && around.size.x > WIDEST_LEAF;
        let sill = element.elevation.map_or(0.0, |elevation| elevation - self.elevation);
        let (low, high) = match kind {
            "window" => window_heights(sill, element.height, heights),
            _ => (None, element.height.filter(|height| (ROOM_HEIGHT.0..=heights.wall).contains(height))),
        };
        let in_centimetres = |edge: Option<f64>| edge.map(|edge| edge / CENTIMETRE);
        let heights = HoleHeights { lower_edge: in_centimetres(low), upper_edge: in_centimetres(high) };
        Some(Hole {
            kind: if is_sliding { "sliding_door".to_owned() } else { kind.to_owned() },
            coordinates: rings(&around.corners()),
            door_sweeping_points: None,
            properties: Some(HoleProperties { heights: Some(heights) }),
        })
    }
}

/// Whether two rows draw the same shape.
fn are_same(one: &[Outline], other: &[Outline]) -> bool {
    one.len() == other.len() && one.iter().zip(other).all(|(one, other)| one.outer == other.outer)
}

/// Sill and head of a window where its row says them.
fn window_heights(sill: f64, height: Option<f64>, heights: Heights) -> (Option<f64>, Option<f64>) {
    let Some(height) = height.filter(|height| *height > LEAST_SILL) else { return (None, None) };
    let stands_on_floor = sill.abs() <= LEAST_SILL && height >= LEAST_FRENCH_WINDOW;
    if stands_on_floor || (LEAST_SILL..heights.wall - LEAST_SILL).contains(&sill) {
        let sill = sill.max(0.0);
        return (Some(sill), Some((sill + height).min(heights.wall)));
    }
    (None, None)
}

/// A fixture by the rectangle around it.
fn item(element: &Element, kind: &str) -> Option<Item> {
    let around = Oriented::around(&element.outlines[0].outer)?;
    let measure = |metres: f64| Measure { value: metres / CENTIMETRE };
    Some(Item {
        kind: kind.to_owned(),
        x: around.center.x,
        y: around.center.y,
        rotation: libm::atan2(around.axis.y, around.axis.x).to_degrees(),
        properties: ItemProperties { width: measure(around.size.x), length: measure(around.size.y) },
    })
}

fn rings(ring: &[Point]) -> Rings {
    vec![ring.iter().map(|corner| corner.to_array()).collect()]
}

/// The value that most have, to a centimetre; the lowest of equals.
fn usual(values: impl Iterator<Item = f64>) -> Option<f64> {
    let mut counts: BTreeMap<i64, (usize, f64)> = BTreeMap::new();
    for value in values {
        counts.entry((value * 100.0).round() as i64).or_insert((0, value)).0 += 1;
    }
    let most = counts.into_values().reduce(|best, next| if next.0 > best.0 { next } else { best });
    most.map(|(_, value)| value)
}
