//! Windows: which rooms have them, how many, and where.

use crate::geometry::{Intervals, Point, Segment};

use super::draft::DOOR_HEAD;
use super::faces::Partition;
use super::links::Link;
use super::ring::{longest, total_length};
use super::spine::Ground;
use super::typology::Light;

/// Square metres of floor for a square metre of glass (German building codes ask for 8 to 10).
pub(super) const FLOOR_OF_GLASS: f64 = 8.0;
/// Metres of wall at each end of a room beside its windows.
const BESIDE: f64 = 0.25;
/// Metres from window to window.
const PIER: f64 = 0.5;
/// Metres between a door and a window.
const DOOR_GAP: f64 = 0.35;
/// Sill and head of usual windows in metres above the floor.
const USUAL: (f64, f64) = (0.85, 2.25);
/// Sill of small windows of baths and stores.
const HIGH_SILL: f64 = 1.3;
/// Sill where a room needs much light.
const LOW_SILL: f64 = 0.4;
/// Metres of windows where there is room for several.
const USUAL_WIDTH: f64 = 2.4;
/// Square metres up to which a room that needs no windows has one at most.
const SMALL_ROOM: f64 = 8.0;
/// The same of a room that vehicles come into: a garage for one or two of them.
const SMALL_GARAGE: f64 = 60.0;
/// Metres within which an inner wall runs beside an outer one as if it were the same.
const BESIDE_WALL: f64 = 0.25;
/// Metres of wall from which on it has windows where the door of a balcony is light enough.
const LEAST_LIT: f64 = 2.5;
/// Metres of the largest window.
const WIDEST: f64 = 2.8;

/// A window.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Window {
    /// Its room by number.
    pub(super) room: usize,
    /// Its middle.
    pub(super) center: Point,
    /// Along the wall.
    pub(super) along: Point,
    /// Metres.
    pub(super) width: f64,
    /// Metres above the floor.
    pub(super) bottom: f64,
    /// Metres above the floor.
    pub(super) top: f64,
}

/// What of outer walls is taken before windows are set.
#[derive(Clone, Copy)]
pub(super) struct Taken<'a> {
    /// All doors.
    pub(super) doors: &'a [Link],
    /// Where balconies are fixed to the wall: the glass behind them is that of their doors.
    pub(super) balconies: &'a [Segment],
}

/// The windows of a level.
pub(super) fn windows(ground: &Ground, partition: &Partition<'_>, taken: Taken<'_>) -> Vec<Window> {
    let &Partition { cells, typologies, .. } = partition;
    let mut found = Vec::new();
    for (room, cell) in cells.iter().enumerate() {
        let Some(needs) = typologies.rooms.get(&cell.room_type).filter(|needs| needs.light != Light::None)
        else {
            continue;
        };
        let pieces: Vec<Segment> = partition
            .light(ground, room)
            .into_iter()
            .flat_map(|piece| free_pieces(piece, room, ground.wall, taken))
            .filter(|piece| piece.length() >= 0.5 + 2.0 * BESIDE.min(piece.length() / 5.0))
            .collect();
        let small = if needs.gate.is_some() { SMALL_GARAGE } else { SMALL_ROOM };
        let is_hall = needs.passage && cell.room_type != "stairs" && super::ring::area(&cell.ring) > small;
        let is_main = needs.light == Light::Required || is_hall;
        if !is_main {
            // One small window is enough.
            let wall = longest(pieces);
            found.extend(wall.map(|piece| {
                let width = if cell.room_type == "stairs" { 1.0 } else { 0.7 };
                let width = f64::min(width, piece.length() - 0.3);
                Window {
                    room,
                    center: piece.middle(),
                    along: piece.direction(),
                    width,
                    bottom: HIGH_SILL,
                    top: USUAL.1,
                }
            }));
            continue;
        }
        let floor = super::ring::area(&cell.ring);
        let wall = total_length(&pieces);
        let glazed = glass_of_doors(room, partition, taken.doors);
        // Where the door of a balcony gives all the light, short walls beside it need none.
        let is_lit = glazed >= floor / FLOOR_OF_GLASS - 0.01;
        let pieces: Vec<Segment> =
            pieces.into_iter().filter(|piece| !is_lit || piece.length() >= LEAST_LIT).collect();
        let wanted = ((floor / FLOOR_OF_GLASS - glazed) / (USUAL.1 - USUAL.0)).max(0.9);
        let bottom = if wanted > 0.55 * wall { LOW_SILL } else { USUAL.0 };
        // More light than needed where there is wall for it, as people build.
        let share = (wanted / wall.max(0.1)).clamp(0.42, 0.85);
        for piece in pieces {
            found.extend(in_piece(piece, share).into_iter().map(|(center, width)| Window {
                room,
                center,
                along: piece.direction(),
                width,
                bottom,
                top: USUAL.1,
            }));
        }
    }
    found
}

/// Square metres of glass of the doors of a room to balconies, whose numbers come after those of the rooms.
fn glass_of_doors(room: usize, partition: &Partition<'_>, doors: &[Link]) -> f64 {
    let is_glazed = |door: &&Link| {
        door.rooms.0 == room && door.rooms.1.is_some_and(|other| other >= partition.cells.len())
    };
    doors.iter().filter(is_glazed).map(|door| door.width * DOOR_HEAD).sum()
}

/// By room whether it has a window, or a glazed door to a balcony.
pub(super) fn lit_rooms(partition: &Partition<'_>, windows: &[Window], doors: &[Link]) -> Vec<bool> {
    let has_window = |room: usize| windows.iter().any(|window| window.room == room);
    (0..partition.cells.len())
        .map(|room| has_window(room) || glass_of_doors(room, partition, doors) > 0.0)
        .collect()
}

/// Windows evenly along a piece of wall: middle and width of each.
fn in_piece(piece: Segment, share: f64) -> Vec<(Point, f64)> {
    let length = piece.length();
    let margin = BESIDE.min(length / 5.0);
    let usable = length - 2.0 * margin;
    let count = (length * share / USUAL_WIDTH).round().clamp(1.0, 40.0);
    let bay = length / count;
    let width = (length * share / count).min(bay - PIER.min(bay * 0.25)).min(usable).clamp(0.4, WIDEST);
    (0..count as u32).map(|index| (piece.at((f64::from(index) + 0.5) / count), width)).collect()
}

/// What doors leave of a piece of wall: outer ones, and those of the room in an inner wall that runs close beside it; and balconies
/// before it.
fn free_pieces(
    piece: Segment,
    room: usize,
    wall: f64,
    Taken { doors, balconies }: Taken<'_>,
) -> Vec<Segment> {
    let (direction, length) = (piece.direction(), piece.length());
    let distance = |point: Point| (piece.side(point) / length).abs();
    let is_in_wall = |link: &&Link| {
        let reach = match link.rooms {
            (_, None) => 0.6,
            (first, Some(second)) if first == room || second == room => BESIDE_WALL,
            _ => return false,
        };
        distance(link.center) < reach && link.along.perp_dot(direction).abs() < 0.1
    };
    let place = |point: Point| (point - piece.start).dot(direction);
    let around = |point: Point, half: f64| (place(point) - half - DOOR_GAP, place(point) + half + DOOR_GAP);
    let taken = doors.iter().filter(is_in_wall).map(|link| around(link.center, link.width / 2.0));
    let is_before = |balcony: &&Segment| {
        distance(balcony.middle()) < wall + BESIDE_WALL && balcony.direction().perp_dot(direction).abs() < 0.1
    };
    let stretches =
        balconies.iter().filter(is_before).map(|balcony| around(balcony.middle(), 0.5 * balcony.length()));
    let mut free = Intervals::new(0.0, length);
    taken.chain(stretches).for_each(|(from, to)| free.subtract(from, to));
    let kept = free.as_slice().iter().filter(|(from, to)| to - from > 0.3);
    kept.map(|(from, to)| Segment::new(piece.at(from / length), piece.at(to / length))).collect()
}
