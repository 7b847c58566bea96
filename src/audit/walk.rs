//! Where people get to on the floor of a room.

use crate::geometry::Point;
use crate::plan::RoomOpening;

use super::convex::{depth, edges, nearest_on_segment};
use super::raster::{CELL, Raster, least_distance};
use super::subject::{Body, Subject};

/// The floor of a room with what stands on it.
pub(crate) struct Floor {
    raster: Raster,
    distances: Vec<u32>,
    /// One per walkable opening.
    doors: Vec<Doorway>,
}

/// An opening that people walk through.
struct Doorway {
    /// Index into the level's openings.
    opening: usize,
    /// The cells on its threshold.
    threshold: Vec<usize>,
}

/// Where a disc gets to from the doors.
pub(crate) struct Walk<'f> {
    floor: &'f Floor,
    diameter: f64,
    /// Which group of doors each cell is reached from, zero for none.
    cells: Vec<u16>,
    /// The group of each door; doors of a group are reached from each other.
    groups: Vec<u16>,
    /// Cells by group; the first counts those that no group reaches.
    sizes: Vec<usize>,
}

impl Floor {
    /// The floor of a room with some bodies; `None` where no door leads in.
    pub(crate) fn new<'b, 'a: 'b>(
        subject: &Subject<'_>,
        bodies: impl Iterator<Item = &'b Body<'a>>,
    ) -> Option<Self> {
        let places: Vec<&RoomOpening> = subject
            .room
            .openings
            .iter()
            .filter(|place| subject.level.openings[place.opening].kind.is_walkable())
            .collect();
        if places.is_empty() {
            return None;
        }
        let rules = subject.rules().walking;
        // Somebody on a threshold stands half behind it.
        let behind = rules.person / 2.0 + 2.0 * CELL;
        let (low, high) = subject.room.region.outline.bounds();
        let mut raster = Raster::new((low - Point::splat(behind), high + Point::splat(behind)));
        raster.paint(&subject.room.region.borders().collect::<Vec<_>>(), true);
        for place in &places {
            raster.paint(&strip(subject, place, -behind, CELL), true);
        }
        for column in &subject.room.obstacles {
            raster.paint(&column.outline.edges().collect::<Vec<_>>(), false);
        }
        let is_in_the_way = |low: f64, high: f64| low < rules.body_height && high > rules.step;
        for solid in bodies.flat_map(|body| &body.solids).filter(|solid| is_in_the_way(solid.low, solid.high))
        {
            raster.paint(&edges(solid.footprint()).collect::<Vec<_>>(), false);
        }
        let doors = places.iter().map(|place| Doorway::new(subject, place, &raster)).collect();
        Some(Self { distances: raster.distances(), raster, doors })
    }

    /// The doors, as indices into the level's openings.
    pub(crate) fn doors(&self) -> impl Iterator<Item = usize> {
        self.doors.iter().map(|door| door.opening)
    }

    /// Where a disc of a diameter gets to.
    pub(crate) fn walk(&self, diameter: f64) -> Walk<'_> {
        let mut walk = Walk {
            floor: self,
            diameter,
            cells: vec![0; self.raster.len()],
            groups: vec![0; self.doors.len()],
            sizes: vec![0],
        };
        for door in 0..self.doors.len() {
            if walk.groups[door] == 0 {
                walk.set_out(door);
            }
        }
        walk
    }
}

/// The strip along an opening between two distances from the wall's inner face, above zero inside the room.
fn strip(subject: &Subject<'_>, place: &RoomOpening, from: f64, to: f64) -> Vec<(Point, Point)> {
    let wall = &subject.room.walls[place.wall];
    let at = |along: f64, inward: f64| wall.start + wall.direction() * along + wall.normal() * inward;
    let corners = [at(place.from, from), at(place.to, from), at(place.to, to), at(place.from, to)];
    edges(&corners).collect()
}

impl Doorway {
    fn new(subject: &Subject<'_>, place: &RoomOpening, raster: &Raster) -> Self {
        let mut threshold = Vec::new();
        raster.spans(&strip(subject, place, -CELL, CELL), |span| threshold.extend(span));
        Self { opening: place.opening, threshold }
    }
}

impl Walk<'_> {
    /// Walks from a door, and from all doors that are met: who leaves by a wide opening may come in again at
    /// its other end.
    fn set_out(&mut self, door: usize) {
        let group = u16::try_from(self.sizes.len()).expect("a room has fewer than 65,000 doors");
        self.sizes.push(0);
        let mut pending = vec![door];
        while let Some(door) = pending.pop() {
            self.groups[door] = group;
            self.spread(door, group);
            let is_met = |doorway: &Doorway| doorway.threshold.iter().any(|&cell| self.cells[cell] == group);
            let doors = self.floor.doors.iter().enumerate();
            let met = doors.filter(|&(other, doorway)| self.groups[other] == 0 && is_met(doorway));
            pending = met.map(|(other, _)| other).collect();
        }
    }

    fn spread(&mut self, door: usize, group: u16) {
        let least = least_distance(self.diameter);
        let columns = self.floor.raster.columns();
        let mut pending = self.floor.doors[door].threshold.clone();
        while let Some(cell) = pending.pop() {
            if self.cells[cell] != 0 || self.floor.distances[cell] < least {
                continue;
            }
            self.cells[cell] = group;
            self.sizes[usize::from(group)] += 1;
            // Cells where the disc may be are never at the edge of the grid.
            for row in [cell - columns, cell, cell + columns] {
                pending.extend((row - 1..=row + 1).filter(|&next| self.cells[next] == 0));
            }
        }
    }

    /// A door of the group of most doors, then of most cells; an index into the level's openings.
    pub(crate) fn main_door(&self) -> usize {
        let main = self.main_group();
        let main_door = self.doors().find(|&(_, group)| group == main);
        main_door.expect("a group has a door").0
    }

    /// The group of a door.
    pub(crate) fn group(&self, door: usize) -> u16 {
        self.doors().find(|&(other, _)| other == door).expect("all walks have the same doors").1
    }

    fn main_group(&self) -> u16 {
        let groups = 1..self.sizes.len();
        let door_count = |group: usize| self.groups.iter().filter(|&&one| usize::from(one) == group).count();
        let best = groups.max_by_key(|&group| (door_count(group), self.sizes[group], usize::MAX - group));
        best.map_or(0, |group| u16::try_from(group).expect("groups are counted in 16 bits"))
    }

    /// Doors, as indices into the level's openings, with the group of each.
    pub(crate) fn doors(&self) -> impl Iterator<Item = (usize, u16)> {
        self.floor.doors.iter().zip(&self.groups).map(|(door, &group)| (door.opening, group))
    }

    /// Whether a disc of a group touches a convex area.
    pub(crate) fn touches(&self, group: u16, area: &[Point]) -> bool {
        let mut is_inside = false;
        let sides: Vec<(Point, Point)> = edges(area).collect();
        self.floor.raster.spans(&sides, |span| is_inside |= self.cells[span].contains(&group));
        is_inside || self.touches_from_outside(group, area)
    }

    fn touches_from_outside(&self, group: u16, area: &[Point]) -> bool {
        let radius = self.diameter / 2.0;
        let nothing = (Point::INFINITY, Point::NEG_INFINITY);
        let (low, high) =
            area.iter().fold(nothing, |(low, high), &corner| (low.min(corner), high.max(corner)));
        let (low, high) = (low - Point::splat(radius), high + Point::splat(radius));
        let around = [low, Point::new(high.x, low.y), high, Point::new(low.x, high.y)];
        let is_near = |middle: Point| {
            depth(area, middle) >= -radius
                && edges(area).any(|edge| middle.distance(nearest_on_segment(middle, edge)) <= radius)
        };
        let mut found = false;
        self.floor.raster.spans(&edges(&around).collect::<Vec<_>>(), |span| {
            found = found
                || span
                    .into_iter()
                    .any(|cell| self.cells[cell] == group && is_near(self.floor.raster.middle(cell)));
        });
        found
    }

    /// The share of all places where the disc could stand that a group reaches (the walkable rate of
    /// PhyScene, Yang et al. 2024, for one door).
    pub(crate) fn rate(&self, group: u16) -> f64 {
        let least = least_distance(self.diameter);
        let all = self.floor.distances.iter().filter(|&&distance| distance >= least).count();
        if all == 0 { 0.0 } else { self.sizes[usize::from(group)] as f64 / all as f64 }
    }
}
