//! The floor of a room of stairs that is left to walk on.

use std::collections::VecDeque;

use crate::geometry::{Bounds, Point, distance_to_convex, edges, ring_contains};
use crate::plan::Room;

/// Metres that the middle of a person keeps from walls and stairs.
const BODY: f64 = 0.28;
/// Metres of a cell; larger in large rooms, so that no room has more than so many in a row.
const CELL: f64 = 0.14;
/// See [`CELL`].
const MOST_CELLS: f64 = 160.0;
/// Metres around a place within which a free cell counts as that place.
const NEAR: f64 = 0.4;

/// The cells of a room on which the middle of a person may be.
pub(super) struct Floor {
    low: Point,
    cell: f64,
    columns: usize,
    rows: usize,
    is_free: Vec<bool>,
}

impl Floor {
    /// The floor of a room without stairs.
    pub(super) fn of(room: &Room) -> Self {
        let Bounds { low, high } = room.region.outline.bounds();
        let size = high - low;
        let cell = CELL.max(size.max_element() / MOST_CELLS);
        let count = |metres: f64| (metres / cell).ceil().max(1.0) as usize;
        let (columns, rows) = (count(size.x), count(size.y));
        let borders: Vec<_> = room.region.borders().collect();
        let bodies: Vec<&[Point]> =
            room.obstacles.iter().map(|obstacle| obstacle.outline.corners()).collect();
        let is_free = |at: Point| {
            room.region.contains(at)
                && borders.iter().all(|border| border.distance_squared(at) >= BODY * BODY)
                && bodies.iter().all(|ring| !ring_contains(ring, at))
                && bodies.iter().all(|ring| edges(ring).all(|edge| edge.distance_squared(at) >= BODY * BODY))
        };
        let mut floor = Self { low, cell, columns, rows, is_free: Vec::new() };
        floor.is_free = (0..columns * rows).map(|index| is_free(floor.middle(index))).collect();
        floor
    }

    fn middle(&self, index: usize) -> Point {
        let (column, row) = (index % self.columns, index / self.columns);
        self.low + Point::new(column as f64 + 0.5, row as f64 + 0.5) * self.cell
    }

    /// Whether one gets from each of some places to each other past bodies, given as convex rings.
    pub(super) fn joins(&self, places: &[Point], bodies: &[Vec<Point>]) -> bool {
        let Some((&first, others)) = places.split_first() else { return true };
        let is_open = |index: usize| {
            let at = self.middle(index);
            self.is_free[index] && bodies.iter().all(|ring| distance_to_convex(ring, at) >= BODY)
        };
        let open: Vec<bool> = (0..self.is_free.len()).map(is_open).collect();
        let Some(start) = self.nearest(&open, first) else { return false };
        let reached = self.reached(&open, start);
        others.iter().all(|&place| self.nearest(&reached, place).is_some())
    }

    /// The cell nearest to a place, of some.
    fn nearest(&self, cells: &[bool], place: Point) -> Option<usize> {
        let distance = |index: usize| self.middle(index).distance_squared(place);
        let span = |axis: usize, count: usize| {
            let at = |metres: f64| (metres / self.cell).clamp(0.0, count as f64) as usize;
            let along = place[axis] - self.low[axis];
            at(along - NEAR)..at(along + NEAR + self.cell)
        };
        let columns = span(0, self.columns);
        let all =
            span(1, self.rows).flat_map(|row| columns.clone().map(move |column| row * self.columns + column));
        let near = all.filter(|&index| cells[index] && distance(index) <= NEAR * NEAR);
        near.min_by(|&one, &other| distance(one).total_cmp(&distance(other)))
    }

    fn reached(&self, open: &[bool], start: usize) -> Vec<bool> {
        let mut reached = vec![false; open.len()];
        reached[start] = true;
        let mut next = VecDeque::from([start]);
        while let Some(index) = next.pop_front() {
            let (column, row) = (index % self.columns, index / self.columns);
            let neighbours = [
                (column > 0).then(|| index - 1),
                (column + 1 < self.columns).then(|| index + 1),
                (row > 0).then(|| index - self.columns),
                (row + 1 < self.rows).then(|| index + self.columns),
            ];
            for neighbour in neighbours.into_iter().flatten() {
                if open[neighbour] && !reached[neighbour] {
                    reached[neighbour] = true;
                    next.push_back(neighbour);
                }
            }
        }
        reached
    }
}
