//! The borders of all rooms and doorways of a level, found by place: what walls must not enter.

use super::thickness::built_thickness;
use crate::geometry::{Bounds, Grid, Point, Segment};
use crate::plan::{Level, Opening, OpeningSide, Wall};

/// Metres that the sides of a doorway lie inside the opening, so that they are no border to the wall that it is in.
const INSIDE: f64 = 0.005;

/// A level with its borders by place.
pub(crate) struct Storey<'l> {
    /// The level.
    pub level: &'l Level,
    borders: Vec<Border>,
    grid: Grid,
}

/// An edge of a room or doorway, which is on its left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Border {
    /// Index of the room in its level; none for a doorway.
    pub room: Option<usize>,
    /// Where it begins.
    pub start: Point,
    /// Where it ends.
    pub end: Point,
}

impl<'l> Storey<'l> {
    /// Sorts the borders of a level's rooms by place.
    pub(crate) fn of(level: &'l Level) -> Self {
        let edges = |room: usize| {
            level.rooms[room].region.borders().map(move |Segment { start, end }| Border {
                room: Some(room),
                start,
                end,
            })
        };
        let rooms = (0..level.rooms.len()).flat_map(edges);
        let doorways = level.openings.iter().flat_map(|opening| doorway_sides(level, opening));
        let borders: Vec<Border> = rooms.chain(doorways).collect();
        let whole = borders.iter().map(Border::bounds).fold(Bounds::EMPTY, Bounds::union);
        let mut grid =
            Grid::new(if borders.is_empty() { Bounds::new(Point::ZERO, Point::ZERO) } else { whole });
        for (number, border) in (0..).zip(&borders) {
            grid.insert(number, border.bounds());
        }
        Self { level, borders, grid }
    }

    /// The borders whose boxes meet a box, in the order of the level's rooms, each once.
    pub(super) fn borders_near(&self, place: Bounds) -> Vec<Border> {
        let mut numbers = Vec::new();
        self.grid.each(place, |number| numbers.push(number as usize));
        numbers.sort_unstable();
        numbers.dedup();
        let near = numbers.into_iter().map(|number| self.borders[number]);
        near.filter(|border| border.bounds().touches(place)).collect()
    }
}

impl Border {
    fn bounds(&self) -> Bounds {
        Segment::new(self.start, self.end).bounds()
    }
}

/// The two sides of the way through the wall of an opening, from face to face.
fn doorway_sides(level: &Level, opening: &Opening) -> Vec<Border> {
    let Some(first) = opening.sides.first() else { return Vec::new() };
    let wall = wall_of(level, first);
    let (along, outward) = (wall.direction(), -wall.normal());
    let local = |point: Point| Point::new((point - wall.start).dot(along), (point - wall.start).dot(outward));
    let (mut low, mut high, mut depth) = (first.from, first.to, built_thickness(wall));
    if let Some(second) = opening.sides.get(1) {
        let far = wall_of(level, second);
        let ends = [second.from, second.to].map(|at| local(far.after(at)));
        low = low.max(ends[0].x.min(ends[1].x));
        high = high.min(ends[0].x.max(ends[1].x));
        depth = f64::midpoint(ends[0].y, ends[1].y);
    }
    (low, high) = (low + INSIDE, high - INSIDE);
    if low >= high || depth <= INSIDE {
        return Vec::new();
    }
    let at = |along_wall: f64, depth: f64| wall.start + along * along_wall + outward * depth;
    let side = |start: Point, end: Point| Border { room: None, start, end };
    vec![side(at(low, 0.0), at(low, depth)), side(at(high, depth), at(high, 0.0))]
}

fn wall_of<'l>(level: &'l Level, side: &OpeningSide) -> &'l Wall {
    &level.rooms[side.room].walls[side.wall]
}
