//! Reads buildings with their storeys and spaces.

use std::collections::BTreeMap;

use glam::DAffine3;

use super::columns::{self, Own, Products};
use super::fixtures::note_fixtures;
use super::furniture;
use super::level::{Spaces, Storey, stack};
use super::model::{Entity, Model};
use super::openings;
use super::placement::Geometry;
use super::relations::Relations;
use super::room_types::RoomTypes;
use super::rooms::Naming;
use super::storeyless::{by_floors, storey_at};
use crate::plan::read::drawn::DrawnPiece;
use crate::plan::read::reader::DraftedBuilding;
use crate::plan::read::recentred::{recentring, shift};
use crate::plan::{BuildingDraft, RoomWords};

const STOREY: &str = "IFCBUILDINGSTOREY";
const BUILDING: &str = "IFCBUILDING";
const SITE: &str = "IFCSITE";

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
    let homes = homes(model, &relations, &spaces);
    let is_single = homes.len() == 1;
    let mut own = products_by_building(model, &relations, &homes);
    let mut drafted = Vec::new();
    let room_type = |space: &Entity| types.of(space);
    let mut naming = Naming::new(&room_type);
    for home in &homes {
        let frame = frame(&geometry, home.id);
        let own = own.remove(&home.id).unwrap_or_default();
        let products = Products { geometry: &geometry, relations: &relations, frame, own: &own };
        let mut storeys = storeys(&products, home, &mut spaces, &mut naming);
        products.enclose(&mut storeys, &mut naming);
        stack(&mut storeys);
        note_fixtures(model, &relations, words, &mut storeys);
        products.stand(&mut storeys);
        products.open(&mut storeys);
        storeys.iter_mut().for_each(Storey::measure_outer_walls);
        let id = if is_single { name.to_owned() } else { format!("{name}_{}", home.id) };
        let mut pieces = if is_furniture_wanted { products.furniture(&storeys, &id) } else { Vec::new() };
        let mut levels: Vec<_> = storeys.into_iter().map(|storey| storey.draft).collect();
        let by = recentring(&levels);
        levels.iter_mut().for_each(|level| shift(level, by));
        pieces.iter_mut().for_each(|piece| piece.center += by);
        let draft = BuildingDraft { name: title(model, home.id), levels, ..BuildingDraft::default() };
        let settled = DraftedBuilding { id, draft, is_settled: true, ..DraftedBuilding::default() };
        drafted.push((settled, pieces));
    }
    let has_rooms = drafted.iter().any(|(building, _)| !building.draft.levels.is_empty());
    report_homeless(model, spaces, has_rooms);
    naming.warn(model);
    types.warn(model);
    drafted
}

/// The storeys of a building with the rooms of their spaces, which are taken out of `spaces`; then those of spaces that are on none.
fn storeys(
    Products { geometry, relations, frame, .. }: &Products<'_>,
    home: &Home,
    spaces: &mut BTreeMap<u64, Vec<Entity>>,
    naming: &mut Naming<'_>,
) -> Vec<Storey> {
    // Under 0 are the spaces of no building.
    let building = geometry.model.get(home.id).ok().filter(|building| building.is(&[BUILDING]));
    let held = building.as_ref().and_then(|building| spaces.remove(&building.id)).unwrap_or_default();
    let mut apart = Vec::new();
    for (floor, own) in by_floors(geometry, frame, held) {
        match storey_at(geometry, frame, &home.storeys, floor) {
            Some(number) => spaces.entry(home.storeys[number].id).or_default().extend(own),
            None => apart.push(own),
        }
    }
    let mut storeys: Vec<Storey> = Vec::new();
    for storey in &home.storeys {
        let own = spaces.remove(&storey.id).unwrap_or_default();
        storeys.push(Storey::read(geometry, frame, storey, Spaces { own: &own, relations, naming }));
    }
    if let Some(building) = building {
        for own in &apart {
            let spaces = Spaces { own, relations, naming };
            storeys.push(Storey::read(geometry, frame, &building, spaces).without_storey());
        }
    }
    storeys
}

/// Reports spaces of no building: such as car parks of the site, which are no fault beside buildings with rooms.
fn report_homeless(model: &Model, spaces: BTreeMap<u64, Vec<Entity>>, has_rooms: bool) {
    let (outside, nowhere): (Vec<_>, Vec<_>) =
        spaces.into_iter().partition(|(whole, _)| has_rooms && model.is(*whole, &[SITE]));
    for space in nowhere.iter().flat_map(|(_, spaces)| spaces) {
        let message = format!("space \"{}\" is on no storey", space.text(2).unwrap_or_default());
        model.error(
            &space.trouble(message),
            "",
            "IfcRelAggregates puts spaces on storeys; the room is left out",
        );
    }
    let outside: Vec<&Entity> = outside.iter().flat_map(|(_, spaces)| spaces).collect();
    if let [first, ..] = outside[..] {
        let message = format!("spaces of the site, outside of buildings: {} left out", outside.len());
        model.warn(first.id, message, "IfcRelAggregates puts spaces on storeys");
    }
}

/// Spaces by their storey, else by their building or site, in the order of their numbers; under 0 those without one. Gross areas and
/// wholes of spaces lie over other spaces and are none.
fn spaces_by_storey(model: &Model, relations: &Relations) -> BTreeMap<u64, Vec<Entity>> {
    let mut spaces: BTreeMap<u64, Vec<Entity>> = BTreeMap::new();
    for space in model.all(&["IFCSPACE"]) {
        let is_whole = relations.parts(space.id).iter().any(|part| model.is(*part, &["IFCSPACE"]));
        if is_whole || space.value(9).word() == Some("GFA") {
            continue;
        }
        let within = |kind: &str| relations.wholes(space.id).find(|whole| model.is(*whole, &[kind]));
        let whole = [STOREY, BUILDING, SITE].into_iter().find_map(within);
        spaces.entry(whole.unwrap_or(0)).or_default().push(space);
    }
    spaces
}

fn homes(model: &Model, relations: &Relations, spaces: &BTreeMap<u64, Vec<Entity>>) -> Vec<Home> {
    let with_spaces = spaces.keys().filter(|whole| model.is(**whole, &[BUILDING]));
    let mut homes: BTreeMap<u64, Vec<Entity>> = with_spaces.map(|building| (*building, Vec::new())).collect();
    for storey in model.all(&[STOREY]) {
        let building = relations.wholes(storey.id).find(|whole| model.is(*whole, &[BUILDING]));
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
            let home = relations.within(product, |whole| model.is(whole, &[BUILDING])).or(only);
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
