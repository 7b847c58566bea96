//! Attaches openings to walls: finds which rooms an opening joins, and from where to where on each side.
//!
//! ```text
//!        room b           n (left of `along`)
//!   ----[=====]-----      ^
//!   ////|  c  |/////      |     c: the middle of the opening; each face that looks away
//!   ----[=====]-----      +-->  from it and covers enough of it is a side
//!        room a             along
//! ```

use super::assemble::{WallIndex, WallPlace};
use super::limits::ROOM_OPENINGS;
use super::{Opening, OpeningKind, OpeningSide, Room, RoomOpening};
use crate::geometry::Segment;

mod boundaries;
mod leaves;
mod request;
#[cfg(test)]
mod tests;

pub(super) use boundaries::open_boundaries;
use boundaries::without_posts;
pub(super) use leaves::hang_leaves;
pub(super) use request::{Request, request};

/// The face of a room is looked for this many metres from an opening's middle.
const REACH: f64 = 0.6;
/// The middle of an opening may lie this many metres inside a room: lines are drawn by hand.
const DRAWN_INSIDE: f64 = 0.3;
/// Largest gap in metres between the two faces of one opening.
const THICKEST_WALL: f64 = 0.7;
/// Rooms may overlap by this many metres at an opening.
const OVERLAPPING_FACES: f64 = 0.1;
/// Sine of the largest angle between an opening and its wall.
const PARALLEL_SINE: f64 = 0.26;
/// Share of an opening that must lie within the wall; the rest is made up by moving or cutting it.
const LEAST_SHARE: f64 = 0.8;
/// A room behind a door that shows this share of it is the one the door leads to: the door moves along.
const LEAST_PARTNER_SHARE: f64 = 0.5;
/// Walls that are looked at for an opening.
const MOST_FACES: usize = 256;
/// Windows may be cut down to this share where a door stands beside them.
const LEAST_WINDOW_SHARE: f64 = 0.4;
/// Metres of the narrowest opening.
pub(super) const NARROWEST_OPENING: f64 = 0.1;
/// A window's far side may show this share of it: a balcony behind half of a window.
const LEAST_WINDOW_PARTNER: f64 = 0.25;
/// Metres of the narrowest piece of a window that runs on along several walls.
const NARROWEST_PIECE: f64 = 0.4;
/// Hollow parts of the building: what is drawn against them looks at their wall, not into them.
const HOLLOW_ROOM_TYPE: &str = "shaft";

/// A face that an opening may lie in.
#[derive(Clone, Copy, Debug)]
struct Face {
    place: WallPlace,
    /// Metres from the middle of the opening to the face, into the room.
    depth: f64,
    /// The wall's ends along the opening's axis, from its middle.
    low: f64,
    high: f64,
    /// Whether the room lies to the left of the opening's direction.
    is_left: bool,
}

/// Why an opening is on no wall.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum AttachFault {
    /// No wall runs near it.
    NoWall,
    /// A named room has no wall there.
    NotOnRoom(usize),
    /// The best wall of this room holds only this share of it.
    TooLittleWall(usize, f64),
    /// The named rooms do not face each other there.
    Apart,
    /// Other openings leave no place on the walls of this room.
    Taken(usize),
    /// This room has all the openings that a room may have.
    TooMany(usize),
}

/// Finds the sides of an opening and fits it between the ends of its walls and what lies there already.
pub(super) fn attach(request: &Request, rooms: &[Room], index: &WallIndex) -> Result<Opening, AttachFault> {
    let faces = faces_near(request, rooms, index);
    let chosen = choose(request, &faces)?;
    let room_of = |face: &Face| face.place.room;
    if let Some(full) = chosen.iter().map(room_of).find(|&room| rooms[room].openings.len() >= ROOM_OPENINGS) {
        return Err(AttachFault::TooMany(full));
    }
    let (low, high) = fit(request, rooms, &chosen)?;
    Ok(build(request, rooms, &chosen, low, high))
}

/// As [`attach`]; a window that no wall holds is cut into pieces, one for each wall it runs along.
///
/// Pieces come in the order of the opening's direction and still have the same id.
pub(super) fn attach_pieces(
    request: &Request,
    rooms: &[Room],
    index: &WallIndex,
) -> Result<Vec<Opening>, AttachFault> {
    match attach(request, rooms, index) {
        Ok(opening) => Ok(vec![opening]),
        Err(fault) => {
            // An opening that names its room or edge must fit there as a whole.
            let may_split = request.kind == OpeningKind::Window && request.rooms.is_empty();
            let mut pieces = Vec::new();
            if may_split && matches!(fault, AttachFault::TooLittleWall(..)) {
                split(request, rooms, index, &mut pieces);
            }
            if pieces.is_empty() { Err(fault) } else { Ok(pieces) }
        }
    }
}

fn split(request: &Request, rooms: &[Room], index: &WallIndex, pieces: &mut Vec<Opening>) {
    let overlap = |face: &Face| request.overlap(face.low, face.high);
    let faces = faces_near(request, rooms, index);
    // The first of equals.
    let best = faces.iter().reduce(|best, face| if overlap(face) > overlap(best) { face } else { best });
    let Some(face) = best.filter(|face| overlap(face) >= NARROWEST_PIECE) else { return };
    let half = request.width / 2.0;
    let (low, high) = (face.low.max(-half), face.high.min(half));
    if low + half >= NARROWEST_PIECE {
        split(&request.stretch(-half, low), rooms, index, pieces);
    }
    pieces.extend(attach(&request.stretch(low, high), rooms, index));
    if half - high >= NARROWEST_PIECE {
        split(&request.stretch(high, half), rooms, index, pieces);
    }
}

/// Enters an opening into the lists of its rooms, which are sorted by wall and place.
pub(super) fn enlist(opening: &Opening, number: usize, rooms: &mut [Room]) {
    for side in &opening.sides {
        let entry = RoomOpening { opening: number, wall: side.wall, from: side.from, to: side.to };
        let entries = &mut rooms[side.room].openings;
        let place = entries.partition_point(|other| (other.wall, other.from) <= (entry.wall, entry.from));
        entries.insert(place, entry);
    }
}

fn faces_near(request: &Request, rooms: &[Room], index: &WallIndex) -> Vec<Face> {
    let half = request.along * request.width.min(REACH * 2.0) / 2.0;
    let axis = Segment::new(request.center - half, request.center + half);
    let near = index.some_near(axis, REACH, MOST_FACES);
    let left = request.along.perp();
    near.into_iter()
        .filter(|place| rooms[place.room].room_type != HOLLOW_ROOM_TYPE)
        .filter_map(|place| {
            let wall = &rooms[place.room].walls[place.wall];
            let is_parallel = wall.direction().perp_dot(request.along).abs() < PARALLEL_SINE;
            let is_left = wall.normal().dot(left) > 0.0;
            let depth = (wall.start - request.center).dot(wall.normal());
            let ends = [wall.start, wall.end].map(|end| (end - request.center).dot(request.along));
            let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
            let face = Face { place, depth, low, high, is_left };
            let is_in_reach = (-DRAWN_INSIDE..=REACH).contains(&depth);
            (is_parallel && is_in_reach && request.overlap(low, high) > 0.0).then_some(face)
        })
        .collect()
}

/// One face or two opposite ones; the nearest that hold enough of the opening.
fn choose(request: &Request, faces: &[Face]) -> Result<Vec<Face>, AttachFault> {
    let least = request.least_overlap();
    let good: Vec<Face> =
        faces.iter().copied().filter(|face| request.overlap(face.low, face.high) >= least).collect();
    let named = &request.rooms;
    let has_named = |chosen: &[Face]| {
        named.iter().all(|&room| chosen.iter().any(|face| face.place.room == room))
            && (named.len() < 2 || chosen.iter().all(|face| named.contains(&face.place.room)))
    };
    let fits = |chosen: &Vec<Face>| has_named(chosen);
    let score = |chosen: &Vec<Face>| match chosen[..] {
        [left, right] => {
            let misfit = (left.depth - right.depth).abs();
            (left.depth + right.depth).abs() + misfit - request.common(left, right)
        }
        _ => chosen[0].depth.abs() - request.overlap(chosen[0].low, chosen[0].high),
    };
    let best = |choices: Vec<Vec<Face>>| {
        // The first of equals, so that the order of walls decides.
        choices.into_iter().filter(fits).min_by(|a, b| score(a).total_cmp(&score(b)))
    };
    // A single face only where no pair was found; at a corner behind the wall, the room behind most of the opening.
    let chosen = best(pairs(request, faces, request.least_common()))
        .or_else(|| best(pairs(request, faces, request.least_partner())))
        .or_else(|| best(good.iter().map(|&face| vec![face]).collect()));
    let mut chosen = chosen.ok_or_else(|| why_not(request, faces))?;
    chosen.sort_by_key(|face| (named.iter().position(|&room| room == face.place.room), face.place));
    Ok(chosen)
}

/// Opposite faces of which one holds the opening and both together this many metres of it.
fn pairs(request: &Request, faces: &[Face], common: f64) -> Vec<Vec<Face>> {
    let holds = |face: Face| request.overlap(face.low, face.high) >= request.least_overlap();
    let lefts = faces.iter().filter(|face| face.is_left);
    lefts
        .flat_map(|&left| faces.iter().filter(|face| !face.is_left).map(move |&right| (left, right)))
        .filter(|&(left, right)| {
            let gap = left.depth + right.depth;
            // Of one room, two faces whose gap is none have the room between them, where it is narrow, and no wall.
            let least = if left.place.room == right.place.room { 0.0 } else { -OVERLAPPING_FACES };
            (least..=THICKEST_WALL).contains(&gap)
                && (holds(left) || holds(right))
                && request.common(left, right) >= common
        })
        .map(|(left, right)| vec![left, right])
        .collect()
}

/// The wall that holds too little: of each named room its best one, else the best of all.
fn why_not(request: &Request, faces: &[Face]) -> AttachFault {
    let overlap = |face: &Face| request.overlap(face.low, face.high);
    let best = |room: Option<usize>| {
        let faces = faces.iter().filter(|face| room.is_none_or(|room| face.place.room == room));
        faces.map(|face| (face.place.room, overlap(face))).max_by(|a, b| a.1.total_cmp(&b.1))
    };
    let mut worst = if request.rooms.is_empty() { best(None) } else { None };
    for &room in &request.rooms {
        let Some(found) = best(Some(room)) else { return AttachFault::NotOnRoom(room) };
        if worst.is_none_or(|(_, least)| found.1 < least) {
            worst = Some(found);
        }
    }
    match worst {
        None => AttachFault::NoWall,
        Some((room, held)) if held < request.least_overlap() => {
            AttachFault::TooLittleWall(room, held / request.width)
        }
        Some(_) => AttachFault::Apart,
    }
}

/// From and to along the opening's axis, after moving or cutting.
fn fit(request: &Request, rooms: &[Room], chosen: &[Face]) -> Result<(f64, f64), AttachFault> {
    // A window keeps its place in the wall that holds it, whatever its far side shows.
    let least_held = if request.kind == OpeningKind::Window { request.least_overlap() } else { 0.0 };
    let holding = chosen.iter().filter(|face| request.overlap(face.low, face.high) >= least_held);
    let (low, high) = holding.fold((f64::NEG_INFINITY, f64::INFINITY), |(low, high), face| {
        (low.max(face.low), high.min(face.high))
    });
    let mut taken_spans = Vec::new();
    for face in chosen {
        let wall = &rooms[face.place.room].walls[face.place.wall];
        for entry in near_entries(request, &rooms[face.place.room], face) {
            let ends = [entry.from, entry.to].map(|at| (wall.after(at) - request.center).dot(request.along));
            taken_spans.push((ends[0].min(ends[1]), ends[0].max(ends[1])));
        }
    }
    let free = gaps(low, high, taken_spans.clone());
    let best = free.into_iter().max_by(|a, b| {
        let (first, second) = (request.overlap(a.0, a.1), request.overlap(b.0, b.1));
        // Of equal gaps the first: `max_by` would take the last.
        first.total_cmp(&second).then(b.0.total_cmp(&a.0))
    });
    let taken = AttachFault::Taken(chosen[0].place.room);
    let (low, high) = best.ok_or(taken.clone())?;
    let least = match (request.kind, chosen.len()) {
        (OpeningKind::Window, _) => request.width * LEAST_WINDOW_SHARE,
        (_, 1) => request.least_overlap(),
        _ => request.least_partner(),
    };
    if request.overlap(low, high) < least.max(NARROWEST_OPENING) {
        return Err(taken);
    }
    let half = request.width / 2.0;
    let cut = (low.max(-half), high.min(half));
    if request.kind == OpeningKind::OpenBoundary {
        let walls = chosen.iter().map(|face| (face.low, face.high));
        return Ok(without_posts(cut, walls, &taken_spans));
    }
    if high - low < request.width {
        return Ok(cut);
    }
    let middle = 0f64.clamp(low + half, (high - half).max(low + half));
    Ok((middle - half, middle + half))
}

/// The openings of a wall that an opening may meet, and the next one on either side: of the others none is beside it.
fn near_entries<'a>(request: &Request, room: &'a Room, face: &Face) -> &'a [RoomOpening] {
    let number = face.place.wall;
    let first = room.openings.partition_point(|entry| entry.wall < number);
    let count = room.openings[first..].partition_point(|entry| entry.wall == number);
    let entries = &room.openings[first..first + count];
    let wall = &room.walls[number];
    // The ends of the opening, seen along the wall: they are parallel, or nearly so.
    let (start, slope) =
        ((wall.start - request.center).dot(request.along), wall.direction().dot(request.along));
    let ends = [-request.width / 2.0, request.width / 2.0].map(|end| (end - start) / slope);
    let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
    let before = entries.partition_point(|entry| entry.to <= low).saturating_sub(1);
    let behind = entries.partition_point(|entry| entry.from < high);
    &entries[before..entries.len().min(behind + 1)]
}

/// The free parts of a stretch between spans, from its low to its high end.
fn gaps(low: f64, high: f64, mut spans: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    spans.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut free = Vec::new();
    let mut from = low;
    for (start, end) in spans {
        free.push((from, start.min(high)));
        from = from.max(end);
    }
    free.push((from, high));
    free.retain(|(from, to)| from < to);
    free
}

fn build(request: &Request, rooms: &[Room], chosen: &[Face], low: f64, high: f64) -> Opening {
    let mut sides: Vec<OpeningSide> = Vec::with_capacity(chosen.len());
    let mut middles = Vec::with_capacity(chosen.len());
    for face in chosen {
        let wall = &rooms[face.place.room].walls[face.place.wall];
        let ends = [low, high].map(|at| {
            let point = request.center + request.along * at;
            (point - wall.start).dot(wall.direction()).clamp(0.0, wall.length())
        });
        let (from, to) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        sides.push(OpeningSide { room: face.place.room, wall: face.place.wall, from, to });
        let middle = request.center + request.along * ((low + high) / 2.0);
        middles.push(wall.after((middle - wall.start).dot(wall.direction())));
    }
    let first = &rooms[chosen[0].place.room].walls[chosen[0].place.wall];
    let center = match middles[..] {
        [one, other] => one.midpoint(other),
        _ => middles[0] - first.normal() * (first.thickness / 2.0),
    };
    let ceiling = chosen.iter().map(|face| rooms[face.place.room].height).fold(f64::INFINITY, f64::min);
    Opening {
        id: request.id.clone(),
        kind: request.kind,
        center,
        along: first.direction(),
        width: sides.iter().map(|side| side.to - side.from).fold(0.0, f64::max),
        bottom: request.bottom,
        top: request.top.min(ceiling),
        leaves: Vec::new(),
        sides,
    }
}
