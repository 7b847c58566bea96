//! Doors of the ground floor to the open air: where people come in, and how they get out of large rooms.

use crate::geometry::{Point, Segment};
use crate::layout::seed::Stream;

use super::axial;
use super::dwelling::Port;
use super::egress::too_far_out;
use super::faces::Partition;
use super::house::outer_ports;
use super::links::{Entry, Links, link, room_at};
use super::ring::{area, bounds, longest};
use super::spine::Ground;
use super::typology::Light;

/// Square metres from which on a room may have several ways out.
const LARGE_ROOM: f64 = 250.0;
/// Metres between the ways out of a large room, about: nobody in it walks farther than 35 m to one.
const DOORS_APART: f64 = 22.0;
/// Metres between the places of a wall at which such a door may be.
const PLACES_APART: f64 = 8.0;
/// Metres across from which on a corridor has several.
const LONG_ROOM: f64 = 30.0;
/// The room type of rooms that people come into from others.
const STORE: &str = "storeroom";
/// Metres of wall at the street that are enough for a door.
const LEAST_FRONT: f64 = 1.2;
/// Metres of wall that are enough for a gate, and of floor behind it for a small car with the strip before it that stays free.
const LEAST_GATE: f64 = 2.0;
const BEHIND_GATE: f64 = 4.4;
/// Metres of wall from which on it has a place for a way out.
const LEAST_WALL: f64 = 1.4;
/// Metres from the middle of a way in to the nearest window, and of wall that a window needs.
const BESIDE_DOOR: f64 = 0.9;
const LEAST_WINDOW: f64 = 0.9;
/// Further ways out of a room at most.
const MOST_WAYS_OUT: usize = 24;

/// Doors of the ground floor, with those to the open air.
pub(super) fn links_of_ground(grounds: &[Ground], partition: &Partition<'_>, stream: &mut Stream) -> Links {
    let mut entries = ways_in(grounds, partition);
    entries.extend(ways_out(&grounds[0], partition, &entries));
    let mut links = link(partition, &entries, false, stream);
    // What stands apart has a door of its own.
    while let Some(entry) = door_of_its_own(&grounds[0], partition, &links, &entries) {
        entries.push(entry);
        links = link(partition, &entries, false, stream);
    }
    // So has what is far from all others.
    while let Some(entry) = door_of_the_far(&grounds[0], partition, &links, &entries) {
        entries.push(entry);
        links = link(partition, &entries, false, stream);
    }
    links
}

/// A way out of the room that is farthest from all others, where that is too far; of one that people do not pass through, out of the
/// one before it.
fn door_of_the_far(
    ground: &Ground,
    partition: &Partition<'_>,
    links: &Links,
    entries: &[Entry],
) -> Option<Entry> {
    let (room, _) = too_far_out(partition, links, true)?;
    if entries.len() >= MOST_WAYS_OUT {
        return None;
    }
    let is_new = entries.iter().all(|entry| entry.room != room);
    let own = if is_new && partition.is_public(room) { free_wall(ground, partition, room) } else { None };
    let before = links.links.iter().filter_map(|link| link.other(room));
    own.or_else(|| {
        before.filter(|&before| partition.is_public(before)).find_map(|before| {
            let places = door_places(ground, partition, before);
            // What is near through a wall is no way out.
            let own = entries.iter().filter(|entry| entry.room == before);
            let doors: Vec<Point> = own.map(|entry| entry.port.at).collect();
            let (gap, port) = farthest_from(&doors, &places)?;
            (gap > PLACES_APART).then_some(Entry { room: before, port })
        })
    })
}

/// A way into the first room that none leads to, if people may pass through it.
fn door_of_its_own(
    ground: &Ground,
    partition: &Partition<'_>,
    links: &Links,
    entries: &[Entry],
) -> Option<Entry> {
    // Where a door did not fit, it will not again.
    let is_new = |room: usize| entries.iter().all(|entry| entry.room != room);
    let mut rooms = links.unreached.iter().copied().filter(|&room| is_new(room) && partition.is_public(room));
    rooms.find_map(|room| free_wall(ground, partition, room))
}

/// Further doors of large rooms, so that nobody in them is far from one.
fn ways_out(ground: &Ground, partition: &Partition<'_>, entries: &[Entry]) -> Vec<Entry> {
    let is_large = |room: &usize| {
        let ring = &partition.cells[*room].ring;
        let is_far_across = area(ring) > LARGE_ROOM || bounds(ring).size().max_element() > LONG_ROOM;
        is_far_across && partition.is_public(*room)
    };
    let mut found = Vec::new();
    for room in (0..partition.cells.len()).filter(is_large) {
        let places = door_places(ground, partition, room);
        let mut doors: Vec<Point> = entries.iter().map(|entry| entry.port.at).collect();
        for _ in 0..MOST_WAYS_OUT {
            let farthest = farthest_from(&doors, &places);
            let Some((_, port)) = farthest.filter(|(gap, _)| *gap > DOORS_APART) else { break };
            doors.push(port.at);
            found.push(Entry { room, port });
        }
    }
    found
}

/// Where a room may have doors to the open air: in the middle of its free walls, and along them, clear of their ends.
fn door_places(ground: &Ground, partition: &Partition<'_>, room: usize) -> Vec<Port> {
    let walls = partition.light(ground, room);
    let walls = walls.iter().filter(|wall| wall.length() > LEAST_WALL);
    let axis = axial::axis(ground, partition, room);
    walls
        .flat_map(|wall| {
            let count = (wall.length() / PLACES_APART).floor().max(1.0) as u32;
            (0..count).map(move |number| Port {
                at: wall.at((f64::from(number) + 0.5) / f64::from(count)),
                way: wall.normal(),
            })
        })
        .filter(|port| axial::may_have_door(axis, port.at))
        .collect()
}

/// The place that is farthest from the nearest of some doors, with its metres.
fn farthest_from(doors: &[Point], places: &[Port]) -> Option<(f64, Port)> {
    let gap = |at: Point| doors.iter().map(|door| door.distance(at)).fold(f64::INFINITY, f64::min);
    let farthest = places.iter().map(|port| (gap(port.at), *port));
    farthest.reduce(|a, b| if b.0 > a.0 { b } else { a })
}

/// Doors of the ground floor: for flats one at each stairs and each shop below them, else where the entrance is. It leads into no
/// private room.
fn ways_in(grounds: &[Ground], partition: &Partition<'_>) -> Vec<Entry> {
    let cells = partition.cells;
    let is_flats = cells.first().is_some_and(|cell| cell.room_type == "stairs");
    if is_flats {
        let is_store = |room: usize| cells[room].room_type == STORE;
        let entered = (0..cells.len()).filter(|&room| partition.is_public(room) && !is_store(room));
        return entered.filter_map(|room| own_way_in(&grounds[0], partition, room)).collect();
    }
    let mut rooms = (0..cells.len()).filter(|&room| partition.is_public(room));
    if let Some(gate) = rooms.find_map(|room| gate(&grounds[0], partition, room)) {
        return vec![gate];
    }
    if let Some(entry) = axial::way_in(&grounds[0], partition) {
        return vec![entry];
    }
    let is_single = cells.len() == grounds.len();
    // Nobody comes into a building through one of its flats.
    let has_hall = (0..cells.len()).any(|room| partition.is_public(room) && cells[room].room_type != STORE);
    let leads_on = |room: usize| partition.is_passage(room) && (!has_hall || partition.is_public(room));
    let behind = |port: Port, may_be: &dyn Fn(usize, Port) -> bool| {
        let room = room_at(cells, port).filter(|&room| leads_on(room) && may_be(room, port))?;
        Some(Entry { room, port })
    };
    let first = |may_be: &dyn Fn(usize, Port) -> bool| {
        grounds.iter().flat_map(outer_ports).find_map(|port| behind(port, may_be))
    };
    // Where one room takes most of the floor, nobody comes in through its stores.
    let total: f64 = cells.iter().map(|cell| area(&cell.ring)).sum();
    let takes_most = |room: &usize| partition.is_public(*room) && area(&cells[*room].ring) > 0.5 * total;
    let most = (0..cells.len()).find(takes_most);
    let is_store_of = |room: usize| cells[room].room_type == STORE && most.is_some_and(|most| most != room);
    // A building of one room, such as a shed, is entered where it has any wall to the open air.
    let any = || if is_single { free_wall(&grounds[0], partition, 0) } else { None };
    first(&|room, port| !is_store_of(room) && keeps_light(&grounds[0], partition, room, port))
        .or_else(|| first(&|room, _| !is_store_of(room)))
        .or_else(|| free_wall(&grounds[0], partition, most?))
        .or_else(|| first(&|_, _| true))
        .or_else(any)
        .into_iter()
        .collect()
}

/// Whether a room that needs windows has a place for one beside a way in.
fn keeps_light(ground: &Ground, partition: &Partition<'_>, room: usize, port: Port) -> bool {
    let needs = partition.typologies.rooms.get(&partition.cells[room].room_type);
    if needs.is_none_or(|needs| needs.light != Light::Required) {
        return true;
    }
    partition.light(ground, room).iter().any(|wall| {
        let at = (port.at - wall.start).dot(wall.direction());
        let is_in_it = wall.distance(port.at) < ground.wall + 0.1;
        let beside = if is_in_it { at.max(wall.length() - at) - BESIDE_DOOR } else { wall.length() };
        beside >= LEAST_WINDOW
    })
}

/// A way into a room from the open air: a gate, if it needs one that has a place, else a door.
fn own_way_in(ground: &Ground, partition: &Partition<'_>, room: usize) -> Option<Entry> {
    gate(ground, partition, room).or_else(|| free_wall(ground, partition, room))
}

/// A way in for vehicles: in the middle of the longest free wall with floor behind it for one, at the street if there is such a wall.
fn gate(ground: &Ground, partition: &Partition<'_>, room: usize) -> Option<Entry> {
    partition.gate(room)?;
    let corners = &partition.cells[room].ring;
    let is_gate = |wall: &Segment| {
        let behind = |corner: &Point| (*corner - wall.start).dot(wall.normal());
        let floor = corners.iter().map(behind).fold(0.0, f64::max);
        wall.length() >= LEAST_GATE && floor >= BEHIND_GATE
    };
    let longest_gate = |walls: Vec<Segment>| longest(walls.into_iter().filter(is_gate).collect());
    let street = longest_gate(partition.street(ground, room));
    let wall = street.or_else(|| longest_gate(partition.light(ground, room)))?;
    Some(Entry { room, port: Port { at: wall.middle(), way: wall.normal() } })
}

/// A way into a room from the open air: in the middle of its longest free wall, at the street if it has one there.
fn free_wall(ground: &Ground, partition: &Partition<'_>, room: usize) -> Option<Entry> {
    let street = longest(partition.street(ground, room)).filter(|wall| wall.length() > LEAST_FRONT);
    let wall = street.or_else(|| longest(partition.light(ground, room)))?;
    Some(Entry { room, port: Port { at: wall.middle(), way: wall.normal() } })
}
