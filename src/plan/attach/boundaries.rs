//! Finds open boundaries, which a drawing shows by leaving out the wall.

use super::Request;
use crate::geometry::{Bounds, Point, ray_hit};
use crate::plan::assemble::{OutlineIndex, WallIndex, WallPlace};
use crate::plan::{OpeningKind, Room, Wall, WallKind};

/// Two room edges this close in metres have no wall between them.
const STEP: f64 = 0.06;
/// Sine of the largest angle between two such edges.
const PARALLEL_SINE: f64 = 0.05;
/// Metres between the places that are looked at.
const SAMPLE_INTERVAL: f64 = 0.05;
/// A wall this close in metres to an edge closes it.
const WALL_REACH: f64 = 0.03;
/// Shorter gaps in metres are no ways through: a walker needs 0.45 m and some room to turn.
const SHORTEST_BOUNDARY: f64 = 0.6;
/// A narrower piece of wall in metres, beside an open boundary at the end of a wall, is the width of a drawn line or of a corner
/// that the other room has elsewhere: it would stand as a post in the way.
const NARROWEST_POST: f64 = 0.05;

/// Room types without a floor: nobody walks in, wall or no wall.
const FLOORLESS_ROOM_TYPES: [&str; 2] = ["shaft", "void"];

fn has_floor(room: &Room) -> bool {
    !FLOORLESS_ROOM_TYPES.contains(&room.room_type.as_str())
}

/// The stretches where two rooms meet without a wall, by room, wall and place; ids are `open:<room>:<room>`, not
/// yet unique.
pub(in crate::plan) fn open_boundaries(
    rooms: &[Room],
    index: &WallIndex,
    solids: &OutlineIndex,
) -> Vec<Request> {
    let mut found: Vec<Request> = Vec::new();
    for (room, value) in rooms.iter().enumerate().filter(|(_, room)| has_floor(room)) {
        for (wall, piece) in value.walls.iter().enumerate() {
            let place = WallPlace { room, wall };
            let near = index.near_segment(piece.segment(), STEP);
            let partners = near.into_iter().filter(|far| far.room > room && has_floor(&rooms[far.room]));
            for far in partners {
                let shared = shared_stretch(piece, &rooms[far.room].walls[far.wall]);
                for (low, high) in
                    shared.map(|(low, high)| free_stretches(piece, low, high, solids)).unwrap_or_default()
                {
                    found.push(boundary(rooms, place, far, low, high));
                }
            }
        }
    }
    found
}

/// From and to along the wall where the other runs beside it, a step away at most.
fn shared_stretch(wall: &Wall, far: &Wall) -> Option<(f64, f64)> {
    let along = wall.direction();
    let is_opposite =
        along.dot(far.direction()) < 0.0 && along.perp_dot(far.direction()).abs() < PARALLEL_SINE;
    let is_solid = wall.kind == WallKind::Solid && far.kind == WallKind::Solid;
    let low = (far.end - wall.start).dot(along).max(0.0);
    let high = (far.start - wall.start).dot(along).min(wall.length());
    if !is_opposite || !is_solid || high - low < SHORTEST_BOUNDARY {
        return None;
    }
    let middle = wall.start + along * ((low + high) / 2.0);
    let gap = (middle - far.start).dot(far.normal());
    (gap.abs() <= STEP).then_some((low, high))
}

fn free_stretches(wall: &Wall, low: f64, high: f64, solids: &OutlineIndex) -> Vec<(f64, f64)> {
    let count = ((high - low) / SAMPLE_INTERVAL).ceil().max(1.0) as usize;
    let at = |index: usize| low + (high - low) * index as f64 / count as f64;
    let mut stretches: Vec<(f64, f64)> = Vec::new();
    for index in 0..count {
        let (from, to) = (at(index), at(index + 1));
        if is_walled(wall.after((from + to) / 2.0), wall, solids) {
            continue;
        }
        match stretches.last_mut() {
            Some(last) if last.1 == from => last.1 = to,
            _ => stretches.push((from, to)),
        }
    }
    stretches.retain(|(from, to)| to - from >= SHORTEST_BOUNDARY);
    stretches
}

fn is_walled(point: Point, wall: &Wall, solids: &OutlineIndex) -> bool {
    let (inside, outside) = (point + wall.normal() * WALL_REACH, point - wall.normal() * WALL_REACH);
    let near = solids.near(Bounds::around_point(point, WALL_REACH));
    near.into_iter().any(|solid| {
        solid.contains(point)
            || solid
                .edges()
                .any(|edge| ray_hit(inside, outside - inside, edge).is_some_and(|share| share <= 1.0))
    })
}

/// The span of an open boundary, up to the ends of its walls where it would leave a post there; `taken` are the spans of
/// other openings. All in metres from the middle of the boundary.
pub(super) fn without_posts(
    (low, high): (f64, f64),
    walls: impl Iterator<Item = (f64, f64)>,
    taken: &[(f64, f64)],
) -> (f64, f64) {
    let is_post = |from: f64, to: f64| {
        to > from && to - from < NARROWEST_POST && !taken.iter().any(|span| span.0 < to && from < span.1)
    };
    walls.fold((low, high), |(from, to), (start, end)| {
        let from = if is_post(start, low) { from.min(start) } else { from };
        (from, if is_post(high, end) { to.max(end) } else { to })
    })
}

fn boundary(rooms: &[Room], place: WallPlace, far: WallPlace, low: f64, high: f64) -> Request {
    let wall = &rooms[place.room].walls[place.wall];
    let (room, other) = (&rooms[place.room], &rooms[far.room]);
    Request {
        id: format!("open:{}:{}", room.id, other.id),
        kind: OpeningKind::OpenBoundary,
        center: wall.after((low + high) / 2.0),
        along: wall.direction(),
        width: high - low,
        bottom: 0.0,
        top: room.height.min(other.height),
        rooms: vec![place.room, far.room],
    }
}
