//! Which rooms are wanted for an eye, the most urgent first.

use core::cmp::Ordering;
use std::collections::BTreeMap;

use super::graph::{BuildingGraph, Key, Place};
use super::near::near;
use super::sight::{Sector, Stand, rooms_at, seen_from};
use crate::geometry::Point;
use crate::plan::Building;

/// Seconds ahead in which one may come to see a room.
const AHEAD: [f64; 2] = [1.0, 2.0];
/// Metres to a door through which one may look at any moment, besides those that one walks in the meantime.
const DOOR: f64 = 3.0;
/// Places from which one looks ahead at most.
const MOST_STANDS: usize = 12;
/// Degrees added to the field of view: how far the head turns while a room is made.
const MARGIN: f64 = 20.0;

/// Why a room is wanted; the more urgent first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Need {
    /// It is in view now.
    Visible,
    /// It is in view when one turns the head.
    Around,
    /// It is in view after the next steps.
    Ahead,
    /// One reaches it within a few steps.
    Near,
}

/// A room that is wanted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Wanted {
    /// The room.
    pub(crate) key: Key,
    /// Why.
    pub(crate) need: Need,
    /// Metres to it: to the opening through which one sees it, or of the way to it.
    pub(crate) distance: f64,
    /// Whether one reaches it within [`Gaze::reach`], whatever else it is wanted for.
    pub(crate) is_near: bool,
}

impl Wanted {
    /// The more urgent first.
    pub(crate) fn order(&self, other: &Self) -> Ordering {
        self.need.cmp(&other.need).then_with(|| self.distance.total_cmp(&other.distance))
    }
}

/// The eye in the frame of a building.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Gaze {
    /// Index of the level.
    pub(crate) level: usize,
    /// Where, in metres.
    pub(crate) position: Point,
    /// Where it looks; any length.
    pub(crate) direction: Point,
    /// How it moves, in metres a second.
    pub(crate) velocity: Point,
    /// Radians of its field of view, from side to side.
    pub(crate) field_of_view: f64,
    /// Metres of the way to the rooms that are wanted though one does not see them.
    pub(crate) reach: f64,
}

/// The rooms of a building that are wanted, each once, in the order of the plan.
pub(crate) fn wishes(
    graph: &BuildingGraph,
    building: (usize, &Building),
    gaze: &Gaze,
) -> impl Iterator<Item = Wanted> + use<> {
    let (index, building) = building;
    let mut found: BTreeMap<Place, Wanted> = BTreeMap::new();
    let mut want = |place: Place, need: Need, distance: f64, is_near: bool| {
        let new = Wanted { key: Key { building: index, place }, need, distance, is_near };
        let known = found.entry(place).or_insert(new);
        let is_near = known.is_near || is_near;
        if new.order(known).is_lt() {
            *known = new;
        }
        known.is_near = is_near;
    };
    let view = Sector::around(gaze.direction, gaze.field_of_view + MARGIN.to_radians());
    let stand = Stand { level: gaze.level, position: gaze.position, view };
    for (place, seen) in seen_from(graph, building, &stand) {
        want(place, if seen.is_in_view { Need::Visible } else { Need::Around }, seen.distance, false);
    }
    for stand in next_stands(graph, building, gaze) {
        // Stairs are short: what one sees at their end is as near as if one stood there.
        let way = stand.position.distance(gaze.position);
        for (place, seen) in seen_from(graph, building, &stand) {
            want(place, Need::Ahead, seen.distance + way, false);
        }
    }
    let reach = gaze.reach + gaze.velocity.length() * AHEAD[1];
    for (place, metres) in near(graph, building, (gaze.level, gaze.position), reach) {
        want(place, Need::Near, metres, metres <= gaze.reach);
    }
    found.into_values()
}

/// Where one may be in a moment: straight on, in the doors that are near, and at the other end of stairs. What one sees from there
/// is made before (the paper's section 6.2).
fn next_stands(graph: &BuildingGraph, building: &Building, gaze: &Gaze) -> Vec<Stand> {
    let Gaze { level, position, velocity, .. } = *gaze;
    let speed = velocity.length();
    let straight =
        AHEAD.into_iter().filter(|_| speed > 0.0).map(|seconds| (level, position + velocity * seconds));
    let mut stands: Vec<(usize, Point)> = straight.collect();
    for room in rooms_at(graph, building, level, position) {
        let cell = graph.cell(Place { level, room });
        stands.extend(cell.joined.iter().map(|joined| (joined.level, position)));
        let walkable = cell.portals.iter().filter(|portal| portal.is_walkable);
        let doors = walkable.filter_map(|portal| Some(portal.behind?.face.middle()));
        let near = doors.filter(|at| at.distance(position) <= DOOR + speed * AHEAD[1]);
        stands.extend(near.map(|at| (level, at)));
    }
    stands.truncate(MOST_STANDS);
    stands.into_iter().map(|(level, position)| Stand { level, position, view: None }).collect()
}
