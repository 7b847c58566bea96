//! Balconies: each dwelling above the ground floor has one before its living room, where there is open air for it.

use crate::geometry::{Point, Segment, distance_of_convex, distance_to_convex};
use crate::plan::OpeningKind;

use super::draft::DOOR_HEAD;
use super::dwelling::Cell;
use super::facade::Facade;
use super::faces::Partition;
use super::links::Link;
use super::ring::{Ring, area, on_grid};
use super::spine::Ground;
use super::typology::Light;
use super::windows::FLOOR_OF_GLASS;

/// The room type.
pub(super) const BALCONY: &str = "balcony";
/// Metres of open air that a balcony needs before the wall.
const SIGHT: f64 = 5.0;
/// Metres that it stands out.
const DEPTH: f64 = 1.5;
/// Metres along the wall, least and most.
const WIDTH: (f64, f64) = (2.4, 4.2);
/// Metres of wall that the room keeps beside it.
const BESIDE: f64 = 0.2;
/// Metres of the sliding door that leads to it, the least, and of wall beside it.
const DOOR: (f64, f64) = (1.5, 0.3);
/// Share of the balcony before the door at most: people sit before the rest.
const DOOR_SHARE: f64 = 0.45;
/// Metres to other balconies and to walls that stand out.
const FREE: f64 = 1.0;
/// Metres of its railing.
const RAILING: f64 = 0.06;

/// A balcony with its door.
#[derive(Clone, Debug)]
pub(super) struct Balcony {
    /// Its room, outside the outer wall.
    pub(super) cell: Cell,
    /// The door, between the room before which it lies and the number that its own room will have.
    pub(super) door: Link,
}

/// A balcony for each dwelling of a level that has open air before its living room.
pub(super) fn balconies(ground: &Ground, partition: &Partition<'_>) -> Vec<Balcony> {
    let mut found: Vec<Balcony> = Vec::new();
    for room in living_rooms(partition) {
        let mut pieces = partition.open_air(ground, room, SIGHT);
        pieces.sort_by(|a, b| b.length().total_cmp(&a.length()));
        let number = partition.cells.len() + found.len();
        let places = pieces.into_iter().filter(|piece| piece.length() >= WIDTH.0 + 2.0 * BESIDE);
        let balconies = places.map(|piece| balcony(piece, ground.wall, (room, number), partition));
        let is_free = |balcony: &Balcony| {
            let ring = &balcony.cell.ring;
            let others = found.iter().map(|other| distance_of_convex(ring, &other.cell.ring));
            others.chain([space_before(ring, &ground.facade)]).all(|distance| distance >= FREE)
        };
        found.extend(balconies.into_iter().find(is_free));
    }
    found
}

/// By dwelling its largest room that people live and may walk in.
fn living_rooms(partition: &Partition<'_>) -> Vec<usize> {
    let cells = partition.cells;
    let mut largest: std::collections::BTreeMap<usize, usize> = std::collections::BTreeMap::new();
    for (room, cell) in cells.iter().enumerate() {
        let needs = partition.typologies.rooms.get(&cell.room_type);
        let is_living = needs.is_some_and(|needs| needs.passage && needs.light == Light::Required);
        let Some(unit) = cell.unit.filter(|_| is_living) else { continue };
        let known = largest.entry(unit).or_insert(room);
        if area(&cells[*known].ring) < area(&cell.ring) {
            *known = room;
        }
    }
    largest.into_values().collect()
}

/// The balcony at the first end of a piece of a room's face, behind an outer wall of some metres.
fn balcony(piece: Segment, wall: f64, (room, number): (usize, usize), partition: &Partition<'_>) -> Balcony {
    let (along, out) = (piece.direction(), -piece.normal());
    let width = (piece.length() - 2.0 * BESIDE).min(WIDTH.1);
    // The door is the window too.
    let wanted = area(&partition.cells[room].ring) / FLOOR_OF_GLASS / DOOR_HEAD;
    let door = wanted.clamp(DOOR.0, DOOR.0.max(DOOR_SHARE * width));
    let corner = |from: f64, depth: f64| on_grid(piece.start + along * from + out * depth);
    let (from, to) = (BESIDE, BESIDE + width);
    let ring: Ring =
        vec![corner(from, wall), corner(from, wall + DEPTH), corner(to, wall + DEPTH), corner(to, wall)];
    let door = Link {
        rooms: (room, Some(number)),
        kind: OpeningKind::SlidingDoor,
        center: piece.start + along * (from + DOOR.1 + 0.5 * door) + out * (0.5 * wall),
        along,
        width: door,
        leaves: 1,
        opens_out: false,
    };
    let unit = partition.cells[room].unit;
    Balcony { cell: Cell { unit, ..Cell::shared(ring, BALCONY) }, door }
}

/// Metres between a balcony and the walls that stand out before the one that it is fixed to.
fn space_before(ring: &[Point], facade: &Facade) -> f64 {
    let wall = Segment::new(ring[3], ring[0]).reversed();
    let before = -0.1 * wall.length();
    let stands_out = |line: &Segment| [line.start, line.end].iter().any(|point| wall.side(*point) < before);
    let lines = facade.spans.iter().map(|span| span.line).filter(stands_out);
    let distances = lines.flat_map(|line| {
        let from_ends = [line.start, line.end].map(|end| distance_to_convex(ring, end));
        from_ends.into_iter().chain(ring.iter().map(move |corner| line.distance(*corner)))
    });
    distances.fold(f64::INFINITY, f64::min)
}

/// The railing of a balcony, as an outline around its three free sides.
pub(super) fn railing(ring: &[Point]) -> Vec<Point> {
    let (along, out) = ((ring[2] - ring[1]).normalize(), (ring[1] - ring[0]).normalize());
    let beside = along * RAILING;
    let before = out * RAILING;
    vec![
        ring[0],
        ring[0] - beside,
        ring[1] - beside + before,
        ring[2] + beside + before,
        ring[3] + beside,
        ring[3],
        ring[2],
        ring[1],
    ]
}
