//! Doors: which rooms they join, so that every room is reached from the way in, and where they are.

use std::collections::BTreeSet;

use crate::geometry::{Point, Segment, ring_contains};
use crate::layout::seed::Stream;
use crate::plan::OpeningKind;

use super::dwelling::{Cell, Port};
use super::faces::Partition;
use super::suites::{add_second_doors, move_doors_of_suites};
use super::typology::{RoomNeeds, Typologies};

/// Metres of border, up to the middles of other walls, that the narrowest door needs.
pub(super) const LEAST_BORDER: f64 = 0.92;
/// Metres of wall beside a door.
const BESIDE: f64 = 0.03;
/// Metres of the narrowest door to the open air.
const LEAST_WAY_IN: f64 = 0.7;
/// Metres between two doors in one wall.
const BETWEEN: f64 = 0.2;
/// Metres of wall from which on a kitchen lies open to the living room.
const OPEN_BORDER: f64 = 1.35;
/// Metres of border at most where a corridor ends at another.
const WIDEST_PASSAGE: f64 = 2.6;
/// Metres along which the stairs of a house lie open to its hall, at most.
const WIDEST_OPEN_STAIRS: f64 = 4.5;
/// Share of kitchens that do, where they may.
const OPEN_SHARE: f64 = 0.65;

/// A way between two rooms, or out.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Link {
    /// The rooms by number; one only of a door to the open air.
    pub(super) rooms: (usize, Option<usize>),
    /// How it is closed.
    pub(super) kind: OpeningKind,
    /// Its middle.
    pub(super) center: Point,
    /// Along the wall.
    pub(super) along: Point,
    /// Metres.
    pub(super) width: f64,
    /// One or two.
    pub(super) leaves: u32,
    /// Whether the two of a gate open into the open air.
    pub(super) opens_out: bool,
}

impl Link {
    /// Whether it leads to a room.
    pub(super) fn joins(&self, room: usize) -> bool {
        self.rooms.0 == room || self.rooms.1 == Some(room)
    }

    /// The room on its other side, of one that it leads to.
    pub(super) fn other(&self, room: usize) -> Option<usize> {
        match self.rooms {
            (first, Some(second)) if first == room => Some(second),
            (first, Some(second)) if second == room => Some(first),
            _ => None,
        }
    }
}

/// The ways of a level.
#[derive(Clone, Debug, Default)]
pub(super) struct Links {
    /// All of them.
    pub(super) links: Vec<Link>,
    /// Rooms that none leads to, by number.
    pub(super) unreached: Vec<usize>,
}

/// A way into a room from the open air.
#[derive(Clone, Copy, Debug)]
pub(super) struct Entry {
    /// The room by number.
    pub(super) room: usize,
    /// Where it is in the room's wall.
    pub(super) port: Port,
}

/// A level whose doors are sought.
#[derive(Clone, Copy)]
struct Level<'a> {
    cells: &'a [Cell],
    typologies: &'a Typologies,
    borders: &'a [Vec<(usize, Segment)>],
    /// By room: whether it is the first of its unit, which is the hall or the only room.
    is_entry: &'a [bool],
}

/// Which ways are looked for: what may lead to the hall does, before others are entered through a living room.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Pass {
    /// To the room types that are best for a room.
    Best,
    /// To all room types that its doors may lead to.
    Other,
    /// To a bedroom, where the dwelling has another such room.
    Suite,
}

/// Doors of a level: `entries` are the ways in from outside, `stair_roots` whether people come by the stairs.
pub(super) fn link(
    partition: &Partition<'_>,
    entries: &[Entry],
    stair_roots: bool,
    stream: &mut Stream,
) -> Links {
    let &Partition { cells, typologies, ref borders, .. } = partition;
    let mut units = BTreeSet::new();
    let is_entry: Vec<bool> = cells.iter().map(|cell| units.insert(cell.unit)).collect();
    let level = Level { cells, typologies, borders, is_entry: &is_entry };
    let mut found = Links::default();
    let mut is_reached = vec![false; cells.len()];
    for &Entry { room, port } in entries {
        if let Some(door) = outer_door(room, port, partition) {
            is_reached[room] = true;
            found.links.push(door);
        }
    }
    if stair_roots {
        for (index, cell) in cells.iter().enumerate() {
            is_reached[index] |= cell.room_type == "stairs";
        }
    }
    let is_open: Vec<bool> = cells.iter().map(|_| stream.unit() < OPEN_SHARE).collect();
    for pass in [Pass::Best, Pass::Other, Pass::Suite] {
        loop {
            let next = (0..cells.len())
                .filter(|&room| !is_reached[room])
                .find_map(|room| best_way(level, &is_reached, room, pass).map(|way| (room, way)));
            let Some((room, (to, border))) = next else { break };
            let open = opens(level, room).filter(|(other, _)| is_open[room] && is_reached[*other]);
            let link = match open {
                Some((other, border)) => open_side(room, other, border),
                None => inner_door(cells, (room, to), border, &found.links),
            };
            is_reached[room] = true;
            found.links.push(link);
        }
    }
    // People come by each stairs: those that nobody was led from have a door too, though one leads to the open air.
    for room in (0..cells.len()).filter(|&room| cells[room].room_type == "stairs") {
        if is_reached[room] && !found.links.iter().any(|link| link.other(room).is_some()) {
            let way = best_way(level, &is_reached, room, Pass::Other);
            found.links.extend(way.map(|(to, border)| inner_door(cells, (room, to), border, &found.links)));
        }
    }
    join_corridors(level, &mut found.links);
    move_doors_of_suites(partition, &mut found.links);
    add_second_doors(partition, &mut found.links);
    found.unreached =
        (0..cells.len()).filter(|&room| !is_reached[room] && cells[room].room_type != "shaft").collect();
    found
}

/// Corridors that meet are one, though each has stairs or a way in of its own: rooms whose doors lead to others of their type before
/// all else are open to each other, where no door inside leads from one to the other yet, and where one ends at the other.
fn join_corridors(level: Level<'_>, links: &mut Vec<Link>) {
    let Level { cells, typologies, borders, .. } = level;
    let is_corridor = |room: usize| {
        let needs = typologies.rooms.get(&cells[room].room_type);
        needs.is_some_and(|needs| needs.passage && needs.doors.first() == Some(&cells[room].room_type))
    };
    // By room: a number that all rooms share between which one can walk indoors.
    let mut parts: Vec<usize> = (0..cells.len()).collect();
    let unite = |parts: &mut [usize], one: usize, other: usize| {
        let (from, to) = (parts[one], parts[other]);
        parts.iter_mut().filter(|part| **part == from).for_each(|part| *part = to);
    };
    for link in links.iter() {
        if let (one, Some(other)) = link.rooms {
            unite(&mut parts, one, other);
        }
    }
    for room in (0..cells.len()).filter(|&room| is_corridor(room)) {
        for &(to, border) in &borders[room] {
            let is_alike = cells[to].room_type == cells[room].room_type && cells[to].unit == cells[room].unit;
            let is_end = border.length() < WIDEST_PASSAGE;
            let is_linked = || links.iter().any(|link| link.other(room) == Some(to));
            if is_alike && (parts[to] != parts[room] || is_end && !is_linked()) {
                links.push(inner_door(cells, (room, to), border, links));
                unite(&mut parts, room, to);
            }
        }
    }
}

/// The room behind a way in.
pub(super) fn room_at(cells: &[Cell], port: Port) -> Option<usize> {
    let inside = port.at + port.way * 0.4;
    cells.iter().position(|cell| ring_contains(&cell.ring, inside))
}

/// `None` where the wall holds no door.
fn outer_door(room: usize, port: Port, partition: &Partition<'_>) -> Option<Link> {
    let cell = &partition.cells[room];
    let is_wide = cell.unit.is_none() && !matches!(cell.room_type.as_str(), "storeroom" | "stairs");
    let gate = partition.gate(room);
    let width: f64 = match cell.room_type.as_str() {
        "storeroom" => 0.9,
        _ if is_wide => gate.unwrap_or(1.6),
        _ => 1.0,
    };
    // As far as the wall goes.
    let (_, edge) = partition.faces[room]
        .iter()
        .filter(|edge| edge.normal().dot(port.way) > 0.9)
        .map(|&edge| (edge.distance(port.at), edge))
        .reduce(|a, b| if b.0 < a.0 { b } else { a })?;
    let room_for = edge.length() - 2.0 * BESIDE;
    if room_for < LEAST_WAY_IN {
        return None;
    }
    let width = width.min(room_for);
    let half = 0.5 * width + BESIDE;
    let place = (port.at - edge.start).dot(edge.direction());
    let place = place.max(half).min(edge.length() - half);
    Some(Link {
        rooms: (room, None),
        kind: OpeningKind::Door,
        center: edge.after(place),
        along: edge.direction(),
        width,
        leaves: if width > 1.2 { 2 } else { 1 },
        opens_out: gate.is_some(),
    })
}

/// Whether a door may lead from a room that is not reached to one that is.
fn may_lead(level: Level<'_>, needs: &RoomNeeds, room: usize, to: usize) -> Option<usize> {
    let (own, other) = (&level.cells[room], &level.cells[to]);
    let is_allowed = match (own.unit, other.unit) {
        (a, b) if a == b => true,
        (Some(_), None) => level.is_entry[room],
        _ => false,
    };
    if !is_allowed {
        return None;
    }
    needs.doors.iter().position(|door| *door == other.room_type)
}

fn best_way(level: Level<'_>, is_reached: &[bool], room: usize, pass: Pass) -> Option<(usize, Segment)> {
    let Level { cells, typologies, borders, .. } = level;
    let needs = typologies.rooms.get(&cells[room].room_type)?;
    // Nobody walks through a flat to what all share.
    let is_way =
        |to: usize| is_reached[to] && (cells[to].unit.is_none() || cells[to].unit == cells[room].unit);
    let ways = borders[room].iter().filter(|(to, _)| is_way(*to)).filter_map(|&(to, border)| {
        // The other way round too, after where the room's own door would lead: stairs of a house are reached from its hall, a hall above
        // from the stairs.
        let other = typologies.rooms.get(&cells[to].room_type).filter(|other| other.passage);
        let back = other.and_then(|other| may_lead(level, other, to, room));
        let back = back.map(|place| needs.doors.len() + place);
        let suite = || (pass == Pass::Suite && is_suite(level, is_reached, room, to)).then_some(0);
        let rank = may_lead(level, needs, room, to).or(back).or_else(suite)?;
        (rank == 0 || pass != Pass::Best).then_some((rank, -border.length(), to, border))
    });
    let best = ways.reduce(|a, b| if (b.0, b.1) < (a.0, a.1) { b } else { a });
    best.map(|(_, _, to, border)| (to, border))
}

/// Whether a room may belong to another: a bath to a bedroom, where the dwelling has one that is reached otherwise.
fn is_suite(level: Level<'_>, is_reached: &[bool], room: usize, to: usize) -> bool {
    let Level { cells, typologies, .. } = level;
    let own = &cells[room];
    let is_alike = |(other, cell): (usize, &Cell)| {
        is_reached[other] && cell.unit == own.unit && cell.room_type == own.room_type
    };
    let leads = |needs: &RoomNeeds| needs.suite_of.contains(&cells[to].room_type);
    cells[to].unit == own.unit
        && typologies.rooms.get(&own.room_type).is_some_and(leads)
        && cells.iter().enumerate().any(is_alike)
}

/// The room that another lies open to.
fn opens(level: Level<'_>, room: usize) -> Option<(usize, Segment)> {
    let Level { cells, typologies, borders, .. } = level;
    let needs = typologies.rooms.get(&cells[room].room_type)?;
    let is_open = |to: usize, border: Segment| {
        cells[to].unit == cells[room].unit
            && needs.open_to.contains(&cells[to].room_type)
            && border.length() >= OPEN_BORDER
    };
    borders[room].iter().copied().find(|&(to, border)| is_open(to, border))
}

fn open_side(room: usize, other: usize, border: Segment) -> Link {
    let width = (border.length() - 0.16).min(3.2);
    Link {
        rooms: (room, Some(other)),
        kind: OpeningKind::OpenBoundary,
        center: border.middle(),
        along: border.direction(),
        width,
        leaves: 0,
        opens_out: false,
    }
}

pub(super) fn inner_door(
    cells: &[Cell],
    (room, to): (usize, usize),
    border: Segment,
    links: &[Link],
) -> Link {
    let types = [cells[room].room_type.as_str(), cells[to].room_type.as_str()];
    let has = |room_type: &str| types.contains(&room_type);
    let is_inside = cells[room].unit == cells[to].unit;
    if has("stairs") && has("corridor") && is_inside || types == ["walkway", "walkway"] {
        let width = (border.length() - 0.1).min(WIDEST_OPEN_STAIRS);
        return Link { width, ..open_side(room, to, border) };
    }
    let (kind, wanted): (OpeningKind, f64) = if has("elevator") {
        (OpeningKind::SlidingDoor, 0.9)
    } else if !is_inside || has("walkway") {
        (OpeningKind::Door, 0.95)
    } else if has("bathroom") || has("toilet") || has("storeroom") || has("hotel_bathroom") {
        (OpeningKind::Door, 0.8)
    } else {
        (OpeningKind::Door, 0.88)
    };
    let width = wanted.min(border.length() - 2.0 * BESIDE);
    let center = place_on(border, width, links);
    let rooms = (room, Some(to));
    Link { rooms, kind, center, along: border.direction(), width, leaves: 1, opens_out: false }
}

/// A place on a border: near an end of it, clear of other doors in that wall.
fn place_on(border: Segment, width: f64, links: &[Link]) -> Point {
    let half = width / 2.0 + BESIDE;
    let length = border.length();
    let beside = 0.15f64.min((length - 2.0 * half).max(0.0));
    let places = [half + beside, length - half - beside, length / 2.0];
    let clearance = |place: f64| {
        let at = border.after(place);
        let gap = |link: &Link| {
            let is_in_wall = border.side(link.center).abs() < 0.2;
            let distance = link.center.distance(at) - (width + link.width) / 2.0;
            if is_in_wall { distance } else { distance.max(BETWEEN) }
        };
        links.iter().map(gap).fold(BETWEEN, f64::min)
    };
    let best = places.into_iter().map(|place| (clearance(place), place));
    let (_, place) = best.reduce(|a, b| if b.0 > a.0 + 1e-6 { b } else { a }).unwrap_or((0.0, length / 2.0));
    border.after(place)
}
