//! Which rooms one sees: sectors that narrow from portal to portal.
//!
//! A ray leaves a room through one of its openings and enters the next through the same opening in that room's wall. The part of
//! the circle around the eye that goes through both is the sector of the next room, and so on (D. Luebke, C. Georges, "Portals and
//! Mirrors", 1995, here in the plan). Walls inside a room hide nothing: the answer may hold rooms that
//! a corner hides, and lacks none that one sees within the distances below.

use std::collections::{BTreeMap, VecDeque};

use super::graph::{BuildingGraph, Place};
use crate::geometry::{Point, Segment};
use crate::plan::Building;

/// Metres to the farthest opening through which one sees a room.
const SIGHT: f64 = 60.0;
/// Metres to the farthest window or door of a room that one sees from outside, or through another window.
const OUTDOORS: f64 = 30.0;
/// Metres up and down to the levels that one sees from outside.
const STOREYS_OUTDOORS: f64 = 10.0;
/// Metres from an opening at which one stands in it and sees all of the room behind.
const AT_OPENING: f64 = 0.35;
/// Openings that are looked through at most, so that the time has a bound in every building; the nearest rooms come first.
const MOST_OPENINGS: usize = 4096;
/// Openings one behind the other at most.
const MOST_BEHIND: u32 = 12;

/// A part of the circle around the eye of less than half of it, by its ends: counter-clockwise from right to left.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sector {
    right: Point,
    left: Point,
}

impl Sector {
    /// The sector around a direction, radians wide; none where it is half the circle or more, or has no direction.
    pub(crate) fn around(direction: Point, width: f64) -> Option<Self> {
        let direction = direction.try_normalize()?;
        if !(width > 0.0 && width < core::f64::consts::PI) {
            return None;
        }
        let (sine, cosine) = libm::sincos(width / 2.0);
        let (across, along) = (direction.perp() * sine, direction * cosine);
        Some(Self { right: along - across, left: along + across })
    }

    /// The sector of a segment that lies counter-clockwise around the eye; none if the eye is on it or on its other side.
    fn of(eye: Point, from: Point, to: Point) -> Option<Self> {
        let (right, left) = (from - eye, to - eye);
        (right.perp_dot(left) > 0.0).then_some(Self { right, left })
    }

    fn contains(self, direction: Point) -> bool {
        self.right.perp_dot(direction) >= 0.0 && direction.perp_dot(self.left) >= 0.0
    }

    /// The part in both.
    pub(crate) fn both(self, other: Self) -> Option<Self> {
        let right = match () {
            () if self.contains(other.right) => other.right,
            () if other.contains(self.right) => self.right,
            () => return None,
        };
        let left = match () {
            () if self.contains(other.left) => other.left,
            () if other.contains(self.left) => self.left,
            () => return None,
        };
        Some(Self { right, left })
    }
}

/// The whole circle, or a part of it.
type Opened = Option<Sector>;

/// A room that one sees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Seen {
    /// Metres from the eye to the first opening through which one sees it; zero for the room that one is in.
    pub(crate) distance: f64,
    /// Whether one sees it without turning the head.
    pub(crate) is_in_view: bool,
}

/// The eye in the frame of a building.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stand {
    /// The level.
    pub(crate) level: usize,
    /// Where.
    pub(crate) position: Point,
    /// What is in view; none for all around.
    pub(crate) view: Opened,
}

/// All rooms that one sees by turning around.
pub(crate) fn seen_from(graph: &BuildingGraph, building: &Building, stand: &Stand) -> BTreeMap<Place, Seen> {
    let mut search = Search {
        graph,
        eye: stand.position,
        view: stand.view,
        seen: BTreeMap::new(),
        queue: VecDeque::new(),
        crossings: MOST_OPENINGS,
    };
    let starts = rooms_at(graph, building, stand.level, stand.position);
    if starts.is_empty() {
        let near = graph.levels.iter().enumerate().filter(|(_, other)| {
            let own = graph.levels.get(stand.level).map_or(0.0, |level| level.elevation);
            (other.elevation - own).abs() <= STOREYS_OUTDOORS
        });
        for (level, _) in near {
            search.look_in(level, None, Ray { is_outside: true, ..Ray::default() });
        }
    }
    let start = |room| (Place { level: stand.level, room }, None, Ray::default());
    search.queue.extend(starts.into_iter().map(start));
    while let Some((place, sector, ray)) = search.queue.pop_front() {
        search.enter(place, sector, ray);
    }
    search.seen
}

/// The rooms that one stands in: one, two in a doorway, none in the open air.
pub(crate) fn rooms_at(graph: &BuildingGraph, building: &Building, level: usize, at: Point) -> Vec<usize> {
    let Some((cells, rooms)) = graph.levels.get(level).map(|cells| (cells, &building.levels[level].rooms))
    else {
        return Vec::new();
    };
    let near =
        cells.cells.iter().enumerate().filter(|(_, cell)| cell.bounds.inflated(AT_OPENING).contains(at));
    let stands = near.filter(|(room, cell)| {
        rooms[*room].region.contains(at) || cell.portals.iter().any(|portal| is_at(portal.face, at))
    });
    stands.map(|(room, _)| room).collect()
}

fn is_at(face: Segment, eye: Point) -> bool {
    face.distance_squared(eye) <= AT_OPENING * AT_OPENING
}

/// How a ray came to a room.
#[derive(Clone, Copy, Debug, Default)]
struct Ray {
    /// Openings behind the eye's room.
    depth: u32,
    /// Metres to the last of them.
    distance: f64,
    /// Whether it went through the open air.
    is_outside: bool,
    /// Whether it went up or down stairs.
    is_on_stairs: bool,
}

struct Search<'a> {
    graph: &'a BuildingGraph,
    eye: Point,
    view: Opened,
    seen: BTreeMap<Place, Seen>,
    /// Sectors of rooms, those through few openings first.
    queue: VecDeque<(Place, Opened, Ray)>,
    crossings: usize,
}

impl Search<'_> {
    /// A sector reaches a room.
    fn enter(&mut self, place: Place, sector: Opened, ray: Ray) {
        let is_in_view = match (self.view, sector) {
            (Some(view), Some(sector)) => view.both(sector).is_some(),
            _ => true,
        };
        let seen = Seen { distance: ray.distance, is_in_view };
        let known = self.seen.entry(place).or_insert(seen);
        known.distance = known.distance.min(seen.distance);
        known.is_in_view |= is_in_view;
        if ray.depth >= MOST_BEHIND {
            return;
        }
        let cell = self.graph.cell(place);
        for portal in &cell.portals {
            let Some((beyond, ray)) = self.through(portal.face, sector, ray) else { continue };
            match portal.behind {
                Some(behind) => {
                    // The wall has two faces, and a ray goes through both. In the doorway one sees all of both rooms.
                    let far = if is_at(behind.face, self.eye) {
                        Some(beyond)
                    } else {
                        self.narrowed(behind.face.reversed(), beyond)
                    };
                    let next = far.map(|beyond| (Place { room: behind.room, ..place }, beyond, ray));
                    self.queue.extend(next);
                }
                None if !ray.is_outside => {
                    self.look_in(place.level, beyond, Ray { is_outside: true, ..ray });
                }
                None => (),
            }
        }
        if !ray.is_on_stairs {
            let ray = Ray { depth: ray.depth + 1, is_on_stairs: true, ..ray };
            self.queue.extend(cell.joined.iter().map(|&next| (next, sector, ray)));
        }
    }

    /// A sector in the open air reaches the windows and doors of a level.
    fn look_in(&mut self, level: usize, sector: Opened, ray: Ray) {
        let Some(cells) = self.graph.levels.get(level) else { return };
        for &(room, portal) in &cells.outer {
            let face = cells.cells[room].portals[portal].face;
            // From behind: the room is on the other side of its wall.
            let Some((beyond, ray)) = self.through(face.reversed(), sector, ray) else { continue };
            if ray.distance <= OUTDOORS {
                self.queue.push_back((Place { level, room }, beyond, ray));
            }
        }
    }

    /// What of a sector goes through an opening that one sees from the left of it.
    fn through(&mut self, face: Segment, sector: Opened, ray: Ray) -> Option<(Opened, Ray)> {
        if self.crossings == 0 {
            return None;
        }
        let distance = face.distance(self.eye);
        if distance > SIGHT {
            return None;
        }
        let beyond = match sector {
            // One sees all around through it, once: no ray comes back to the eye.
            None if distance <= AT_OPENING && ray.depth == 0 => None,
            Some(_) if distance <= AT_OPENING => return None,
            _ => self.narrowed(face, sector)?,
        };
        self.crossings -= 1;
        Some((beyond, Ray { depth: ray.depth + 1, distance: distance.max(ray.distance), ..ray }))
    }

    /// The part of a sector within a hole that one sees from the left of it.
    fn narrowed(&self, face: Segment, sector: Opened) -> Option<Opened> {
        let hole = Sector::of(self.eye, face.start, face.end)?;
        match sector {
            Some(sector) => Some(Some(sector.both(hole)?)),
            None => Some(Some(hole)),
        }
    }
}
