//! A whole building: tries its kinds and simpler ways until a plan is sound, and drafts it.

use schemars::JsonSchema;
use serde::Serialize;

use crate::geometry::Point;
use crate::layout::seed::{Stream, building_stream};
use crate::plan::{
    BuildingDraft, LeafDraft, LevelDraft, OpeningDraft, OpeningKind, OpeningPlace, OutlineKind, RoomDraft,
    SitePlacement,
};

use super::brief::{Brief, Choices, Known, Measures, briefs};
use super::check::first_fault;
use super::corridor::corridors;
use super::dwelling::{Cell, Port};
use super::facade::Neighbourhood;
use super::flats::flats;
use super::footprint::{Footprint, Site};
use super::house::{house, outer_ports};
use super::links::{Entry, Link, Links, link, room_at};
use super::open::{one_room, open_plan};
use super::plate::Outline;
use super::ring::{area, bounds, longest};
use super::spine::Ground;
use super::thin::{Rules, trade_thin_parts};
use super::typology::{PlanKind, Typologies};
use super::windows::{Window, windows};

/// How often a kind of building is tried with other random numbers before a simpler way is taken.
const TRIES: u32 = 2;
/// Metres of the largest disc below which nobody can stand in a building.
const NARROWEST: f64 = 0.86;
/// Metres of the outer walls of the smallest sheds.
const THINNEST_WALL: f64 = 0.02;
/// Square metres from which on a room may have several ways out.
const LARGE_ROOM: f64 = 250.0;
/// Metres between the ways out of a large room, about: nobody in it walks farther than 35 m to one.
const DOORS_APART: f64 = 22.0;
/// Metres between the places of a wall at which such a door may be.
const PLACES_APART: f64 = 8.0;
/// Metres across from which on a corridor has several.
const LONG_ROOM: f64 = 30.0;
/// Further ways out of a room at most.
const MOST_WAYS_OUT: usize = 24;
/// Metres of floor between storeys.
const SLAB: f64 = 0.3;
/// Metres of the heads of doors.
const DOOR_HEAD: f64 = 2.05;

/// A building with its plan.
#[derive(Clone, Debug)]
pub struct PlannedBuilding {
    /// Its id.
    pub id: String,
    /// Its storeys, in its own frame.
    pub draft: BuildingDraft,
    /// Where that frame is on the plane of the site.
    pub placement: SitePlacement,
    /// How it came about.
    pub report: PlanReport,
}

/// How the plan of a building came about.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct PlanReport {
    /// Id of the building.
    pub id: String,
    /// Its kind.
    pub typology: String,
    /// How that and its storeys are known.
    pub known: Known,
    /// Storeys above the ground.
    pub storeys: u32,
    /// Square metres of the outline.
    pub area: f64,
    /// Flats and other dwellings on all storeys.
    pub dwellings: usize,
    /// Rooms on all storeys.
    pub rooms: usize,
    /// Which way was taken: 0 the kind that was drawn for it, 1 another kind that fits, 2 an open plan, 3 one room on each storey.
    pub rung: u32,
    /// What was wrong with the ways before it.
    pub refused: Vec<String>,
}

/// A level that is sound.
#[derive(Clone)]
struct Storey {
    cells: Vec<Cell>,
    links: Links,
    windows: Vec<Window>,
}

/// Plans the building of a footprint of the site, by its number; `None` where it is too narrow to stand in.
#[must_use]
pub(crate) fn plan_building(
    site: &Site,
    around: &Neighbourhood<'_>,
    index: usize,
    typologies: &Typologies,
    choices: &Choices,
) -> Option<PlannedBuilding> {
    let footprint = &site.footprints[index];
    let outline = Outline::of(footprint, &around.near(index), &around.streets_near(index));
    let measures = Measures { area: outline.area(), depth: outline.depth(), party: outline.party() };
    if measures.depth < NARROWEST {
        return None;
    }
    let kinds = briefs(footprint, measures, typologies, choices);
    let mut refused = Vec::new();
    for (rung, brief) in kinds.iter().enumerate() {
        let grounds = outline.grounds(brief.typology.exterior, brief.storeys);
        if grounds.is_empty() {
            refused.push(format!("{}: the walls leave no floor", brief.name));
            continue;
        }
        for attempt in 0..TRIES {
            let stream = building_stream(choices.seed, &footprint.id, &format!("{} {attempt}", brief.name));
            match storeys(&grounds, brief, typologies, footprint.flats, stream) {
                Ok(storeys) => {
                    let rung = (rung as u32).min(1);
                    return Some(finished(
                        footprint,
                        &outline,
                        brief,
                        (storeys, rung, refused),
                        measures.area,
                    ));
                }
                Err(fault) => refused.push(format!("{}: {fault}", brief.name)),
            }
        }
    }
    let first = kinds.first()?;
    let most = (0.5 * (measures.depth - NARROWEST)).max(THINNEST_WALL);
    let mut grounds =
        outline.grounds(first.typology.exterior.min(measures.depth / 6.0).min(most), first.storeys);
    if grounds.is_empty() {
        grounds = vec![Ground { ring: outline.outer.clone(), facade: outline.facade.clone(), wall: 0.0 }];
    }
    let (storeys, rung) = simplest(&grounds, first, typologies);
    Some(finished(footprint, &outline, first, (storeys, rung, refused), measures.area))
}

/// All storeys by the plan of a kind, each checked.
fn storeys(
    grounds: &[Ground],
    brief: &Brief<'_>,
    typologies: &Typologies,
    known_flats: Option<u32>,
    mut stream: Stream,
) -> Result<Vec<Storey>, String> {
    let main = brief.typology.main.as_deref().unwrap_or("generic");
    let is_house = brief.typology.plan == PlanKind::House;
    // The kinds of levels: the ground floor, and what stands on it.
    let levels = match brief.typology.plan {
        PlanKind::OneRoom => Some(vec![one_room(grounds, main)]),
        PlanKind::House if grounds.len() > 1 => None,
        PlanKind::House => house(&grounds[0], brief, typologies, &mut stream),
        PlanKind::Flats => {
            flats(grounds, brief, typologies, known_flats, &mut stream).map(|cells| vec![cells])
        }
        PlanKind::Corridor | PlanKind::CorridorFlats => {
            corridors(grounds, brief, typologies, &mut stream).map(|cells| vec![cells])
        }
        PlanKind::Open => open_plan(grounds, brief, typologies).map(|cells| vec![cells]),
    };
    let mut levels = levels.ok_or("no arrangement keeps to what rooms need")?;
    for cells in &mut levels {
        // Stairs of a house stand beside other rooms on each level.
        trade_thin_parts(cells, Rules { typologies, fixed: is_house.then_some("stairs") });
    }
    let sound = |cells: &Vec<Cell>, is_ground: bool, stream: &mut Stream| {
        let storey = storey(grounds, cells.clone(), typologies, is_ground, stream);
        match first_fault(grounds, &storey.cells, typologies, &storey.links, &storey.windows) {
            Some(fault) => Err(fault),
            None => Ok(storey),
        }
    };
    let mut found = vec![sound(&levels[0], true, &mut stream)?];
    if brief.storeys > 1 {
        let upper = sound(&levels[levels.len() - 1], false, &mut stream)?;
        found.extend(vec![upper; brief.storeys as usize - 1]);
    }
    Ok(found)
}

fn storey(
    grounds: &[Ground],
    cells: Vec<Cell>,
    typologies: &Typologies,
    is_ground: bool,
    stream: &mut Stream,
) -> Storey {
    let has_stairs = cells.iter().any(|cell| cell.room_type == "stairs");
    let is_entered = has_stairs && !is_ground;
    let mut entries = Vec::new();
    if is_ground {
        entries = ways_in(grounds, &cells, typologies);
        entries.extend(ways_out(&grounds[0], &cells, typologies, &entries));
    }
    let mut links = link(&cells, typologies, &entries, is_entered, stream);
    // What stands apart on the ground has a door of its own.
    while let Some(entry) =
        is_ground.then(|| door_of_its_own(&grounds[0], &cells, typologies, &links)).flatten()
    {
        entries.push(entry);
        links = link(&cells, typologies, &entries, is_entered, stream);
    }
    let windows = windows(&grounds[0], &cells, typologies, &links.links);
    Storey { cells, links, windows }
}

/// A way into the first room that none leads to, if people may pass through it.
fn door_of_its_own(ground: &Ground, cells: &[Cell], typologies: &Typologies, links: &Links) -> Option<Entry> {
    let is_public = |room: &usize| {
        let needs = typologies.rooms.get(&cells[*room].room_type);
        cells[*room].unit.is_none() && needs.is_some_and(|needs| needs.passage)
    };
    links.unreached.iter().copied().filter(is_public).find_map(|room| free_wall(ground, cells, room))
}

/// Further doors of large rooms, so that nobody in them is far from one.
fn ways_out(ground: &Ground, cells: &[Cell], typologies: &Typologies, entries: &[Entry]) -> Vec<Entry> {
    let is_large = |room: &usize| {
        let needs = typologies.rooms.get(&cells[*room].room_type);
        let ring = &cells[*room].ring;
        let is_far_across = area(ring) > LARGE_ROOM || bounds(ring).size().max_element() > LONG_ROOM;
        cells[*room].unit.is_none() && is_far_across && needs.is_some_and(|needs| needs.passage)
    };
    let mut found = Vec::new();
    for room in (0..cells.len()).filter(is_large) {
        let walls = ground.light(&cells[room].ring);
        let walls = walls.iter().filter(|wall| wall.length() > 1.4);
        // In the middle of a wall, and along it: clear of its ends.
        let places: Vec<(Point, Point)> = walls
            .flat_map(|wall| {
                let count = (wall.length() / PLACES_APART).floor().max(1.0) as u32;
                (0..count)
                    .map(move |number| (wall.at((f64::from(number) + 0.5) / f64::from(count)), wall.normal()))
            })
            .collect();
        let mut doors: Vec<Point> = entries.iter().map(|entry| entry.port.at).collect();
        for _ in 0..MOST_WAYS_OUT {
            let gap = |at: Point| doors.iter().map(|door| door.distance(at)).fold(f64::INFINITY, f64::min);
            let farthest = places.iter().map(|place| (gap(place.0), place));
            let farthest = farthest.reduce(|a, b| if b.0 > a.0 { b } else { a });
            let Some((_, &(at, way))) = farthest.filter(|(gap, _)| *gap > DOORS_APART) else { break };
            doors.push(at);
            found.push(Entry { room, port: Port { at, way } });
        }
    }
    found
}

/// Doors of the ground floor: for flats one at each stairs, else where the entrance is. It leads into no private room.
fn ways_in(grounds: &[Ground], cells: &[Cell], typologies: &Typologies) -> Vec<Entry> {
    let is_flats = cells.first().is_some_and(|cell| cell.room_type == "stairs");
    if is_flats {
        let stairs = (0..cells.len()).filter(|&room| cells[room].room_type == "stairs");
        return stairs.filter_map(|room| free_wall(&grounds[0], cells, room)).collect();
    }
    let is_public =
        |room: usize| typologies.rooms.get(&cells[room].room_type).is_some_and(|needs| needs.passage);
    let is_single = cells.len() == grounds.len();
    let wanted = grounds
        .iter()
        .flat_map(outer_ports)
        .find_map(|port| Some(Entry { room: room_at(cells, port).filter(|&room| is_public(room))?, port }));
    // A building of one room, such as a shed, is entered where it has any wall to the open air.
    let any = || if is_single { free_wall(&grounds[0], cells, 0) } else { None };
    wanted.or_else(any).into_iter().collect()
}

/// A way into a room from the open air: in the middle of its longest free wall.
fn free_wall(ground: &Ground, cells: &[Cell], room: usize) -> Option<Entry> {
    let wall = longest(ground.light(&cells[room].ring))?;
    Some(Entry { room, port: Port { at: wall.middle(), way: wall.normal() } })
}

/// Storeys that always come out: open ones with stairs, or one room on each.
fn simplest(grounds: &[Ground], brief: &Brief<'_>, typologies: &Typologies) -> (Vec<Storey>, u32) {
    let mut stream = building_stream(0, "", "simplest");
    let mut open = brief.typology.clone();
    open.main = Some("generic".to_owned());
    open.services.clear();
    let plain = Brief { typology: &open, ..brief.clone() };
    let level = |cells: Vec<Cell>, number: u32, stream: &mut _| {
        storey(grounds, cells, typologies, number == 0, stream)
    };
    if let Some(cells) = open_plan(grounds, &plain, typologies) {
        let storeys: Vec<Storey> =
            (0..brief.storeys).map(|number| level(cells.clone(), number, &mut stream)).collect();
        let is_sound = |storey: &Storey| {
            first_fault(grounds, &storey.cells, typologies, &storey.links, &storey.windows).is_none()
        };
        if storeys.iter().all(is_sound) {
            return (storeys, 2);
        }
    }
    let cells = one_room(grounds, "generic");
    ((0..brief.storeys).map(|number| level(cells.clone(), number, &mut stream)).collect(), 3)
}

fn finished(
    footprint: &Footprint,
    outline: &Outline,
    brief: &Brief<'_>,
    (storeys, rung, refused): (Vec<Storey>, u32, Vec<String>),
    area: f64,
) -> PlannedBuilding {
    let units = |storey: &Storey| {
        let units: std::collections::BTreeSet<usize> =
            storey.cells.iter().filter_map(|cell| cell.unit).collect();
        units.len()
    };
    let dwellings = match brief.typology.plan {
        PlanKind::House => usize::from(rung < 2),
        _ => storeys.iter().map(units).sum(),
    };
    let report = PlanReport {
        id: footprint.id.clone(),
        typology: brief.name.to_owned(),
        known: brief.known.clone(),
        storeys: brief.storeys,
        area: (area * 10.0).round() / 10.0,
        dwellings,
        rooms: storeys.iter().map(|storey| storey.cells.len()).sum(),
        rung,
        refused,
    };
    let levels =
        storeys.iter().enumerate().map(|(number, storey)| level_draft(storey, number, brief)).collect();
    let draft = BuildingDraft { name: footprint.name.clone(), levels };
    let placement = SitePlacement { position: outline.frame.origin, turn: outline.frame.turn };
    PlannedBuilding { id: footprint.id.clone(), draft, placement, report }
}

fn level_draft(storey: &Storey, number: usize, brief: &Brief<'_>) -> LevelDraft {
    let is_house = brief.typology.plan == PlanKind::House;
    let ids = room_ids(&storey.cells, is_house);
    let rooms = storey.cells.iter().zip(&ids).map(|(cell, id)| RoomDraft {
        id: id.clone(),
        room_type: cell.room_type.clone(),
        outline: cell.ring.clone(),
        // A house without a name for its dwelling is one on all levels.
        dwelling: cell.unit.filter(|_| !is_house).map(|unit| format!("flat-{}", unit + 1)),
        ..RoomDraft::default()
    });
    let height = brief.typology.storey_height;
    let doors = storey
        .links
        .links
        .iter()
        .enumerate()
        .map(|(index, link)| door_draft(link, index, &ids, height - SLAB));
    let panes = storey.windows.iter().enumerate().map(|(index, window)| window_draft(window, index, &ids));
    LevelDraft {
        id: if number == 0 { "ground".to_owned() } else { format!("level-{number}") },
        name: String::new(),
        elevation: height * number as f64,
        height,
        exterior_thickness: brief.typology.exterior,
        interior_thickness: brief.typology.interior,
        outlines: OutlineKind::Center,
        rooms: rooms.collect(),
        openings: doors.chain(panes).collect(),
        ..LevelDraft::default()
    }
}

/// Ids of rooms: type and number, after the flat.
fn room_ids(cells: &[Cell], is_house: bool) -> Vec<String> {
    let mut counts = std::collections::BTreeMap::new();
    let id = |cell: &Cell| {
        let prefix = match cell.unit.filter(|_| !is_house) {
            Some(unit) => format!("flat-{}-{}", unit + 1, cell.room_type),
            None => cell.room_type.clone(),
        };
        let prefix = prefix.replace('_', "-");
        let count = counts.entry(prefix.clone()).and_modify(|count| *count += 1).or_insert(1);
        format!("{prefix}-{count}")
    };
    cells.iter().map(id).collect()
}

fn door_draft(link: &Link, index: usize, ids: &[String], ceiling: f64) -> OpeningDraft {
    let leaf = match (link.kind, link.leaves) {
        (OpeningKind::Door, 2) => LeafDraft::Swing {
            hinge_left: true,
            into: Some(ids[link.rooms.0].clone()),
            count: 2,
            angle: std::f64::consts::FRAC_PI_2,
        },
        (OpeningKind::Door, _) => LeafDraft::Automatic,
        _ => LeafDraft::None,
    };
    OpeningDraft {
        id: format!("door-{}", index + 1),
        kind: link.kind,
        place: OpeningPlace::Points { center: link.center, along: Some(link.along) },
        rooms: std::iter::once(link.rooms.0).chain(link.rooms.1).map(|room| ids[room].clone()).collect(),
        width: link.width,
        bottom: 0.0,
        top: if link.kind == OpeningKind::OpenBoundary { ceiling } else { DOOR_HEAD },
        leaf,
    }
}

fn window_draft(window: &Window, index: usize, ids: &[String]) -> OpeningDraft {
    OpeningDraft {
        id: format!("window-{}", index + 1),
        kind: OpeningKind::Window,
        place: OpeningPlace::Points { center: window.center, along: Some(window.along) },
        rooms: vec![ids[window.room].clone()],
        width: window.width,
        bottom: window.bottom,
        top: window.top,
        leaf: LeafDraft::None,
    }
}
