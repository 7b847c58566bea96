//! Places sockets and light switches.

use super::fitting::{Fitting, PLATE};
use super::opening_size::{casing, opening_heights};
use super::skirting::between;
use super::ticks::Ticks;
use crate::geometry::{Convex, Point, distance_to_convex};
use crate::plan::{Level, Opening, OpeningKind, Room, RoomOpening, Wall, WallKind};

/// A fitting in a wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Fitted {
    pub fitting: Fitting,
    /// Number of the wall.
    pub wall: usize,
    /// On the wall's inner face.
    pub position: Point,
    /// Metres of its middle above the floor.
    pub elevation: f64,
}

/// Metres of the middle of switches and sockets above the floor (DIN 18015-3).
const SWITCH_HEIGHT: f64 = 1.05;
const SOCKET_HEIGHT: f64 = 0.30;
/// The same of sockets over worktops.
const WORKTOP_SOCKET_HEIGHT: f64 = 1.15;
/// Metres before a wall at which a worktop along it is looked for: gaps behind furniture are smaller, worktops deeper.
const BEFORE_WALL: f64 = 0.2;
/// Metres from the boards around a door to the middle of its switch.
const BESIDE_DOOR: f64 = 0.12;
/// Metres from the ends of a stretch of wall to the middle of its outer sockets.
const FROM_END: f64 = 0.35;
/// Metres of the shortest stretch of wall with a socket.
const SHORTEST: f64 = 1.2;

/// The switches of a room: one beside each of its doors, at the side of the handle if there is room.
pub(super) fn switches(level: &Level, room: &Room) -> Vec<Fitted> {
    let beside = |place: &RoomOpening| {
        let opening = &level.openings[place.opening];
        let wall = &room.walls[place.wall];
        let is_door =
            matches!(opening.kind, OpeningKind::Door | OpeningKind::SlidingDoor | OpeningKind::Passage);
        if !is_door || wall.kind != WallKind::Solid {
            return None;
        }
        let away = casing(level, opening).metres() + BESIDE_DOOR;
        let (before, after) = (place.from - away, place.to + away);
        let places = if is_handle_after(opening, wall) { [after, before] } else { [before, after] };
        let at = places.into_iter().find(|&at| is_free(level, room, place.wall, at, SWITCH_HEIGHT))?;
        Some(fitted(Fitting::Switch, room, place.wall, at))
    };
    room.openings.iter().filter_map(beside).collect()
}

/// The sockets of a room: on each stretch of wall one for so many metres, the outer ones near its ends, over the worktops that
/// stand before them.
pub(super) fn sockets(level: &Level, room: &Room, interval: f64, worktops: &[Convex]) -> Vec<Fitted> {
    let mut found = Vec::new();
    let solid = room.walls.iter().enumerate().filter(|(_, wall)| wall.kind == WallKind::Solid);
    for (index, wall) in solid {
        let blocked = holes(level, room, index, SOCKET_HEIGHT);
        for (from, to) in between(blocked, wall.length()) {
            let length = to - from;
            if length < SHORTEST {
                continue;
            }
            let count = (length / interval).round().max(1.0);
            let step = (length - 2.0 * FROM_END) / (count - 1.0).max(1.0);
            let at = |number: u32| from + FROM_END + step * f64::from(number);
            let along = (0..count as u32).map(at);
            found.extend(
                along.map(|at| over_worktop(fitted(Fitting::Socket, room, index, at), room, worktops)),
            );
        }
    }
    found
}

/// A socket, higher where a worktop would hide it.
fn over_worktop(socket: Fitted, room: &Room, worktops: &[Convex]) -> Fitted {
    let before = socket.position + room.walls[socket.wall].normal() * BEFORE_WALL;
    let is_hidden = worktops.iter().any(|worktop| distance_to_convex(worktop.corners(), before) == 0.0);
    if is_hidden { Fitted { elevation: WORKTOP_SOCKET_HEIGHT, ..socket } } else { socket }
}

fn fitted(fitting: Fitting, room: &Room, wall: usize, at: f64) -> Fitted {
    let on = &room.walls[wall];
    let elevation = if fitting == Fitting::Switch { SWITCH_HEIGHT } else { SOCKET_HEIGHT };
    Fitted { fitting, wall, position: on.after(at), elevation }
}

/// Whether the free end of a door's only leaf is farther along the wall than its hinge; so for doors without hinges.
fn is_handle_after(opening: &Opening, wall: &Wall) -> bool {
    match opening.leaves.as_slice() {
        [leaf] => (leaf.closed_tip - leaf.hinge).dot(wall.direction()) > 0.0,
        _ => true,
    }
}

/// Whether a plate at a place along a wall and a height lies on the wall alone.
fn is_free(level: &Level, room: &Room, wall: usize, at: f64, height: f64) -> bool {
    let half = PLATE.metres();
    let is_on_wall = at > 2.0 * half && at < room.walls[wall].length() - 2.0 * half;
    let mut holes = holes(level, room, wall, height).into_iter();
    is_on_wall && holes.all(|(from, to)| at + half < from || at - half > to)
}

/// The stretches of a wall in which openings with their frames leave no wall for a plate at a height.
fn holes(level: &Level, room: &Room, wall: usize, height: f64) -> Vec<(f64, f64)> {
    let (under, over) = (Ticks::of(height) - PLATE, Ticks::of(height) + PLATE);
    let places = room.openings.iter().filter(|place| place.wall == wall).filter_map(|place| {
        let opening = &level.openings[place.opening];
        let (low, high) = opening_heights(level, opening);
        let casing = casing(level, opening).metres();
        (low < over && high > under).then_some((place.from - casing, place.to + casing))
    });
    places.collect()
}
