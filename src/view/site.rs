//! What there is to see, as the page asks for it.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::audit::Code;
use crate::catalog::Catalog;
use crate::contract::Closure;
use crate::geometry::{Bounds, Point, Polygon};
use crate::output::LevelOptions;
use crate::plan::{Building, Level, Opening, Plan, Room};
use crate::scene::closure;
use crate::world::{BuildingGraph, Place};

/// All buildings, without their rooms.
#[derive(Serialize)]
pub(super) struct SiteAnswer<'a> {
    version: &'static str,
    pub(super) revision: u64,
    seed: u64,
    style: Option<&'a str>,
    styles: Vec<&'a str>,
    kind: &'static str,
    pub(super) is_editable: bool,
    /// What each code of a finding means.
    meanings: BTreeMap<&'static str, &'static str>,
    buildings: Vec<BuildingAnswer<'a>>,
}

#[derive(Serialize)]
struct BuildingAnswer<'a> {
    id: &'a str,
    name: Option<&'a str>,
    position: [f64; 2],
    turn: f64,
    bounds: [[f64; 2]; 2],
    levels: Vec<LevelHead<'a>>,
}

#[derive(Serialize)]
struct LevelHead<'a> {
    id: &'a str,
    name: &'a str,
    elevation: f64,
    height: f64,
    rooms: usize,
}

/// What a page can show at all.
#[derive(Clone, Copy)]
pub(super) struct Abilities {
    pub(super) revision: u64,
    pub(super) kind: &'static str,
    pub(super) is_editable: bool,
}

/// The buildings of a project.
pub(super) fn site<'a>(
    plan: &'a Plan,
    catalog: &'a Catalog,
    options: &'a LevelOptions,
    abilities: Abilities,
) -> SiteAnswer<'a> {
    let Abilities { revision, kind, is_editable } = abilities;
    let styles = catalog.styles.ids().chain(catalog.building_styles.keys().map(String::as_str));
    let buildings = plan.buildings.iter().map(|placed| BuildingAnswer {
        id: &placed.id,
        name: placed.building.name.as_deref(),
        position: pair(placed.site.position),
        turn: placed.site.turn,
        bounds: bounds(&placed.building),
        levels: placed.building.levels.iter().map(head).collect(),
    });
    SiteAnswer {
        version: env!("CARGO_PKG_VERSION"),
        revision,
        seed: options.seed,
        style: options.style.as_deref(),
        styles: styles.collect(),
        kind,
        is_editable,
        meanings: Code::ALL.into_iter().map(|code| (code.name(), code.meaning())).collect(),
        buildings: buildings.collect(),
    }
}

fn head(level: &Level) -> LevelHead<'_> {
    let Level { id, name, elevation, height, rooms, .. } = level;
    LevelHead { id, name, elevation: *elevation, height: *height, rooms: rooms.len() }
}

fn bounds(building: &Building) -> [[f64; 2]; 2] {
    let rooms = building.levels.iter().flat_map(|level| &level.rooms);
    let all = rooms.fold(Bounds::EMPTY, |all, room| all.union(room.region.outline.bounds()));
    // A building without rooms has no extent.
    if all.low.is_finite() { [pair(all.low), pair(all.high)] } else { [[0.0; 2]; 2] }
}

/// The rooms of a level and their openings.
#[derive(Serialize)]
pub(super) struct LevelAnswer<'a> {
    building: &'a str,
    level: &'a str,
    name: &'a str,
    elevation: f64,
    height: f64,
    revision: u64,
    rooms: Vec<RoomAnswer<'a>>,
    openings: Vec<OpeningAnswer<'a>>,
}

#[derive(Serialize)]
struct RoomAnswer<'a> {
    id: &'a str,
    name: Option<&'a str>,
    #[serde(rename = "type")]
    room_type: &'a str,
    height: f64,
    outline: Vec<[f64; 2]>,
    holes: Vec<Vec<[f64; 2]>>,
    /// Outlines of columns and other fixed bodies, and of stairs.
    obstacles: Vec<Vec<[f64; 2]>>,
    /// The rooms of the next levels that stairs or a lift lead to.
    above: Option<&'a str>,
    below: Option<&'a str>,
    above_level: Option<&'a str>,
    below_level: Option<&'a str>,
}

#[derive(Serialize)]
struct OpeningAnswer<'a> {
    id: &'a str,
    kind: Closure,
    center: [f64; 2],
    along: [f64; 2],
    width: f64,
    bottom: f64,
    top: f64,
    rooms: Vec<&'a str>,
    leaves: Vec<LeafAnswer>,
}

#[derive(Serialize)]
struct LeafAnswer {
    hinge: [f64; 2],
    closed: [f64; 2],
    open: [f64; 2],
}

/// A level of an occupied building, or of a finished file.
pub(super) fn level<'a>(
    (id, building): (&'a str, &'a Building),
    index: usize,
    graph: &BuildingGraph,
    revision: u64,
) -> LevelAnswer<'a> {
    let level = &building.levels[index];
    let rooms = level.rooms.iter().enumerate().map(|(room, found)| {
        let joined = &graph.cell(Place { level: index, room }).joined;
        let beside = |is_above: bool| {
            let elevation = |place: &Place| building.levels[place.level].elevation;
            let place = joined.iter().find(|place| (elevation(place) > level.elevation) == is_above)?;
            let other = &building.levels[place.level];
            Some((other.id.as_str(), other.rooms[place.room].id.as_str()))
        };
        let (above, below) = (beside(true), beside(false));
        RoomAnswer {
            above: above.map(|(_, room)| room),
            below: below.map(|(_, room)| room),
            above_level: above.map(|(level, _)| level),
            below_level: below.map(|(level, _)| level),
            ..room_answer(found, level.stairs_of(room).and_then(|stairs| stairs.footprint()))
        }
    });
    LevelAnswer {
        building: id,
        level: &level.id,
        name: &level.name,
        elevation: level.elevation,
        height: level.height,
        revision,
        rooms: rooms.collect(),
        openings: level.openings.iter().map(|opening| opening_answer(level, opening)).collect(),
    }
}

fn room_answer<'a>(room: &'a Room, stairs: Option<&Polygon>) -> RoomAnswer<'a> {
    let Room { id, name, room_type, height, region, obstacles, .. } = room;
    let ring = |corners: &[Point]| -> Vec<[f64; 2]> { corners.iter().copied().map(pair).collect() };
    let bodies = obstacles.iter().map(|obstacle| &obstacle.outline).chain(stairs);
    RoomAnswer {
        id,
        name: name.as_deref(),
        room_type,
        height: *height,
        outline: ring(region.outline.corners()),
        holes: region.holes.iter().map(|hole| ring(hole.corners())).collect(),
        obstacles: bodies.map(|outline| ring(outline.corners())).collect(),
        above: None,
        below: None,
        above_level: None,
        below_level: None,
    }
}

fn opening_answer<'a>(level: &'a Level, opening: &'a Opening) -> OpeningAnswer<'a> {
    let leaves = opening.leaves.iter().map(|leaf| LeafAnswer {
        hinge: pair(leaf.hinge),
        closed: pair(leaf.closed_tip),
        open: pair(leaf.open_tip),
    });
    OpeningAnswer {
        id: &opening.id,
        kind: closure(opening.kind),
        center: pair(opening.center),
        along: pair(opening.along),
        width: opening.width,
        bottom: opening.bottom,
        top: opening.top,
        rooms: opening.sides.iter().map(|side| level.rooms[side.room].id.as_str()).collect(),
        leaves: leaves.collect(),
    }
}

fn pair(point: Point) -> [f64; 2] {
    point.to_array()
}
