//! Reads buildings with their storeys and spaces.

use std::collections::BTreeMap;

use glam::DAffine3;

use super::columns::{self, Own, Products};
use super::fixtures::note_fixtures;
use super::furniture;
use super::level::{Spaces, Storey, shift, stack};
use super::model::{Entity, Model};
use super::openings;
use super::placement::Geometry;
use super::relations::Relations;
use super::room_types::RoomTypes;
use super::rooms::Naming;
use crate::geometry::{Bounds, Point};
use crate::plan::read::drawn::DrawnPiece;
use crate::plan::read::reader::DraftedBuilding;
use crate::plan::{BuildingDraft, RoomWords};

/// Metres from the building's origin beyond which it is moved there: coordinates of a country, in which millimetres are
/// lost when they are written.
const FARTHEST: f64 = 10_000.0;

/// A building with its storeys in the file's order; 0 for storeys that no building has.
struct Home {
    id: u64,
    storeys: Vec<Entity>,
}

/// All buildings with storeys, by number; ids are the file's name, with a number where there are several. Their furniture
/// only where it is asked for: its shapes are most of a file.
pub(super) fn buildings(
    model: &Model,
    words: &RoomWords,
    name: &str,
    is_furniture_wanted: bool,
) -> Vec<(DraftedBuilding, Vec<DrawnPiece>)> {
    let geometry = Geometry::new(model);
    let relations = Relations::of(model);
    let types = RoomTypes::new(words, model, &relations);
    let mut spaces = spaces_by_storey(model, &relations);
    let homes = homes(model, &relations);
    let is_single = homes.len() == 1;
    let mut own = products_by_building(model, &relations, &homes);
    let mut drafted = Vec::new();
    let room_type = |space: &Entity| types.of(space);
    let mut naming = Naming::new(&room_type);
    for home in &homes {
        let frame = frame(&geometry, home.id);
        let own = own.remove(&home.id).unwrap_or_default();
        let products = Products { geometry: &geometry, relations: &relations, frame, own: &own };
        let mut storeys: Vec<Storey> = Vec::new();
        for storey in &home.storeys {
            let own = spaces.remove(&storey.id).unwrap_or_default();
            let spaces = Spaces { own: &own, relations: &relations, naming: &mut naming };
            storeys.push(Storey::read(&geometry, &frame, storey, spaces));
        }
        products.enclose(&mut storeys, &mut naming);
        stack(&mut storeys);
        note_fixtures(model, &relations, words, &mut storeys);
        products.stand(&mut storeys);
        products.open(&mut storeys);
        storeys.iter_mut().for_each(Storey::measure_outer_walls);
        let id = if is_single { name.to_owned() } else { format!("{name}_{}", home.id) };
        let mut pieces = if is_furniture_wanted { products.furniture(&storeys, &id) } else { Vec::new() };
        let mut levels: Vec<_> = storeys.into_iter().map(|storey| storey.draft).collect();
        let by = recentring(levels.iter().flat_map(|level| &level.rooms).flat_map(|room| &room.outline));
        levels.iter_mut().for_each(|level| shift(level, by));
        pieces.iter_mut().for_each(|piece| piece.center += by);
        let draft = BuildingDraft { name: title(model, home.id), levels, ..BuildingDraft::default() };
        let settled = DraftedBuilding { id, draft, is_settled: true, ..DraftedBuilding::default() };
        drafted.push((settled, pieces));
    }
    for space in spaces.values().flatten() {
        let message = format!("space \"{}\" is on no storey", space.text(2).unwrap_or_default());
        model.error(
            &space.trouble(message),
            "",
            "IfcRelAggregates puts spaces on storeys; the room is left out",
        );
    }
    naming.warn(model);
    types.warn(model);
    drafted
}

/// Spaces by their storey, in the order of their numbers; under 0 those without one. Gross areas and wholes of spaces lie
/// over other spaces and are none.
fn spaces_by_storey(model: &Model, relations: &Relations) -> BTreeMap<u64, Vec<Entity>> {
    let mut spaces: BTreeMap<u64, Vec<Entity>> = BTreeMap::new();
    for space in model.all(&["IFCSPACE"]) {
        let is_whole = relations.parts(space.id).iter().any(|part| model.is(*part, &["IFCSPACE"]));
        if is_whole || space.value(9).word() == Some("GFA") {
            continue;
        }
        let storey = relations.wholes(space.id).find(|whole| model.is(*whole, &["IFCBUILDINGSTOREY"]));
        spaces.entry(storey.unwrap_or(0)).or_default().push(space);
    }
    spaces
}

fn homes(model: &Model, relations: &Relations) -> Vec<Home> {
    let mut homes: BTreeMap<u64, Vec<Entity>> = BTreeMap::new();
    for storey in model.all(&["IFCBUILDINGSTOREY"]) {
        let building = relations.wholes(storey.id).find(|whole| model.is(*whole, &["IFCBUILDING"]));
        homes.entry(building.unwrap_or(0)).or_default().push(storey);
    }
    homes.into_iter().map(|(id, storeys)| Home { id, storeys }).collect()
}

/// Products by building; what is in none goes to the only one.
fn products_by_building(model: &Model, relations: &Relations, homes: &[Home]) -> BTreeMap<u64, Own> {
    let only = if let [home] = homes { Some(home.id) } else { None };
    let mut own: BTreeMap<u64, Own> = BTreeMap::new();
    for kind in columns::kinds().chain(openings::kinds()).chain(furniture::KINDS) {
        for product in model.ids(&[kind]) {
            let home = relations.within(product, |whole| model.is(whole, &["IFCBUILDING"])).or(only);
            own.entry(home.unwrap_or(0)).or_default().entry(kind).or_default().push(product);
        }
    }
    own
}

/// From the world to the axes of a building.
fn frame(geometry: &Geometry<'_>, building: u64) -> DAffine3 {
    if building == 0 {
        return DAffine3::IDENTITY;
    }
    let place = geometry.model.get(building).and_then(|building| geometry.place(&building));
    geometry.model.sound(place).map_or(DAffine3::IDENTITY, |place| place.inverse())
}

/// By how many whole metres a building is moved to its origin: none where it stands near.
fn recentring<'a>(corners: impl Iterator<Item = &'a Point>) -> Point {
    let Bounds { low, .. } = Bounds::around(corners.copied());
    let is_far = low.is_finite() && low.abs().max_element() > FARTHEST;
    if is_far { -low.floor() } else { Point::ZERO }
}

/// The name of a building, or that of the project.
fn title(model: &Model, building: u64) -> Option<String> {
    let project = model.ids(&["IFCPROJECT"]).next();
    let entities = [Some(building), project].into_iter().flatten().filter_map(|id| model.get(id).ok());
    let mut names = entities.filter_map(|entity| {
        let place = if entity.kind == "IFCPROJECT" { 5 } else { 7 };
        entity.text(place).or(entity.text(2)).map(str::to_owned)
    });
    names.next()
}
