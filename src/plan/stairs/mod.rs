//! Stairs that lead from one level to the next: in rooms of stairs that stand on each other.
//!
//! No plan draws steps. Each run of such rooms gets the first of some forms that fits through all of its storeys, the same place on
//! each, so that what comes up at a level goes on from there. Where none does, the rooms stay without steps.

mod fit;
mod flight;
mod form;
mod joined;
mod landing;
#[cfg(test)]
mod tests;

pub use flight::{Flight, RailPoint, Stairs, Step, Well};
pub(crate) use joined::{joined_rooms, middle, neighbours};

use std::collections::BTreeMap;

use super::digest::level_digest;
use super::{Level, OpeningKind, Room, Shared, Wall};
use crate::geometry::{Intervals, Point, Polygon, Segment, edges};
use fit::{Fitted, Storey, fit};

/// The type of rooms that hold stairs.
pub(crate) const STAIRS_ROOM_TYPE: &str = "stairs";
/// Metres from floor to floor that stairs bridge.
const RISES: (f64, f64) = (1.0, 7.0);
/// Metres within which a wall stands along an edge.
const AT_WALL: f64 = 0.12;

/// A room of a level, both as indices.
type Place = (usize, usize);

/// Gives the levels of a building the stairs that join them.
pub(super) fn join_levels(levels: &mut [Level]) {
    let mut found: BTreeMap<usize, Vec<Stairs>> = BTreeMap::new();
    for run in runs(levels) {
        for (level, stairs) in through(levels, &run) {
            found.entry(level).or_default().push(stairs);
        }
    }
    let mut last: Shared<Stairs> = Shared::default();
    for (level, mut stairs) in found {
        stairs.sort_by_key(|stairs| stairs.room);
        // The storeys of a tower have the same stairs.
        if *last != stairs {
            last = stairs.into();
        }
        levels[level].stairs = last.clone();
        levels[level].digest = level_digest(&levels[level]);
    }
}

/// The runs of rooms that stand on each other, the lowest first.
fn runs(levels: &[Level]) -> Vec<Vec<Place>> {
    let is_stairs = |room: &Room| room.room_type == STAIRS_ROOM_TYPE;
    let mut above: BTreeMap<Place, Place> = BTreeMap::new();
    let mut below: BTreeMap<Place, Place> = BTreeMap::new();
    for (lower, upper) in neighbours(levels) {
        for (from, to) in joined_rooms(&levels[lower], &levels[upper], is_stairs) {
            let (from, to) = ((lower, from), (upper, to));
            let rise = levels[upper].elevation - levels[lower].elevation;
            let is_usual = (RISES.0..=RISES.1).contains(&rise);
            if is_usual && !above.contains_key(&from) && !below.contains_key(&to) {
                above.insert(from, to);
                below.insert(to, from);
            }
        }
    }
    let lowest = above.keys().filter(|place| !below.contains_key(place));
    let run = |&first: &Place| {
        std::iter::successors(Some(first), |place| above.get(place).copied()).collect::<Vec<Place>>()
    };
    lowest.map(run).collect()
}

/// The stairs through a run of rooms, by level; none where no form fits.
fn through(levels: &[Level], run: &[Place]) -> Vec<(usize, Stairs)> {
    let rise = |at: usize| levels[run[at + 1].0].elevation - levels[run[at].0].elevation;
    let highest = (0..run.len() - 1).map(rise).fold(0.0, f64::max);
    let storeys = distinct(levels, run);
    let Some(fitted) = fit(&storeys, highest) else { return Vec::new() };
    // What comes up at a level is the flight of the one below it.
    let mut below: Option<Flight> = None;
    let stairs = |(at, &(level, room)): (usize, &Place)| {
        let walls = &solid_walls(&levels[level], &levels[level].rooms[room]);
        let up = (at + 1 < run.len()).then(|| flight(&fitted, walls, rise(at))).flatten();
        let well = below.take().map(|below| well(&fitted, walls, &below, up.is_some()));
        below.clone_from(&up);
        (level, Stairs { room, up, well })
    };
    run.iter().enumerate().map(stairs).collect()
}

/// The storeys of a run, each once that is not like the one below it.
fn distinct<'l>(levels: &'l [Level], run: &[Place]) -> Vec<Storey<'l>> {
    let mut storeys = Vec::new();
    let mut last: Option<(&Level, usize, bool, bool)> = None;
    for (at, &(level, room)) in run.iter().enumerate() {
        let (comes_up, goes_up) = (at > 0, at + 1 < run.len());
        let level = &levels[level];
        let is_alike = last.is_some_and(|(other, other_room, came, went)| {
            (other_room, came, went) == (room, comes_up, goes_up)
                && std::ptr::eq(&*other.rooms, &*level.rooms)
        });
        if !is_alike {
            storeys.push(Storey::of(level, room, comes_up, goes_up));
        }
        last = Some((level, room, comes_up, goes_up));
    }
    storeys
}

/// The steps of a rise.
fn flight(fitted: &Fitted, walls: &[Segment], rise: f64) -> Option<Flight> {
    let Fitted { form, frame } = fitted;
    let (local, rails) = form.steps(rise);
    let each = rise / (local.len() + 1) as f64;
    let top = |step: usize| each * (step + 1) as f64;
    let step = |(number, step): (usize, form::LocalStep)| Step {
        corners: frame.ring(&step.corners),
        top: top(number),
        rise: each,
        is_landing: step.is_landing,
    };
    let rail = |rail: form::LocalRail| {
        let points = rail.points.iter().map(|&(at, step)| RailPoint { at: frame.point(at), foot: top(step) });
        (points.collect::<Vec<RailPoint>>(), rail.is_outer)
    };
    let is_free = |(points, is_outer): &(Vec<RailPoint>, bool)| {
        points.len() > 1 && !(*is_outer && points.iter().all(|point| is_at_wall(walls, point.at)))
    };
    Some(Flight {
        steps: local.into_iter().enumerate().map(step).collect(),
        opening: opening(fitted)?,
        handrails: rails.into_iter().map(rail).filter(is_free).map(|(points, _)| points).collect(),
    })
}

/// The hole that a flight from below comes through.
fn well(fitted: &Fitted, walls: &[Segment], flight: &Flight, goes_on: bool) -> Well {
    let Fitted { form, frame } = fitted;
    let ring = frame.ring(&form.ring());
    let [foot, head] = [form.foot(), form.head()].map(|edge| frame.segment(edge));
    let is_same = |one: Segment, other: Segment| one.middle().distance(other.middle()) < 0.01;
    let is_guarded = |edge: &Segment| {
        let is_passed = is_same(*edge, head) || goes_on && is_same(*edge, foot);
        let is_at_wall = [edge.start, edge.middle(), edge.end].iter().all(|at| is_at_wall(walls, *at));
        !is_passed && !is_at_wall
    };
    let guards = edges(&ring).filter(is_guarded).collect();
    Well { nosings: flight.nosings(), opening: flight.opening.clone(), guards }
}

fn opening(fitted: &Fitted) -> Option<Polygon> {
    Polygon::new(&fitted.frame.ring(&fitted.form.ring())).ok()
}

/// The stretches of a room's borders at which something stands: there, stairs need no handrail.
fn solid_walls(level: &Level, room: &Room) -> Vec<Segment> {
    let stretches = |(number, wall): (usize, &Wall)| {
        let mut solid = Intervals::new(0.0, wall.length());
        for at in room.openings.iter().filter(|at| at.wall == number) {
            if matches!(level.openings[at.opening].kind, OpeningKind::OpenBoundary | OpeningKind::Passage) {
                solid.subtract(at.from, at.to);
            }
        }
        solid.as_slice().iter().map(|&(from, to)| wall.stretch(from, to)).collect::<Vec<Segment>>()
    };
    room.walls.iter().enumerate().flat_map(stretches).collect()
}

fn is_at_wall(walls: &[Segment], at: Point) -> bool {
    walls.iter().any(|wall| wall.distance(at) <= AT_WALL)
}
