//! The floor of a room of stairs that is left to walk on.

use crate::geometry::{Bounds, Point, distance_to_convex};
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
        let is_inside = |at: Point| {
            room.region.contains(at) && !room.obstacles.iter().any(|column| column.outline.contains(at))
        };
        let floor = Self { low, cell, columns, rows, is_free: Vec::new() };
        let mut is_free: Vec<bool> =
            (0..columns * rows).map(|index| is_inside(floor.middle(index))).collect();
        let around_columns = room.obstacles.iter().flat_map(|column| column.outline.edges());
        for border in room.region.borders().chain(around_columns) {
            let is_near = |at: Point| border.distance_squared(at) < BODY * BODY;
            floor.close(&mut is_free, border.bounds().inflated(BODY), is_near);
        }
        Self { is_free, ..floor }
    }

    fn middle(&self, index: usize) -> Point {
        let (column, row) = (index % self.columns, index / self.columns);
        self.low + Point::new(column as f64 + 0.5, row as f64 + 0.5) * self.cell
    }

    /// The cells that meet some bounds, row by row.
    fn cells(&self, bounds: Bounds) -> impl Iterator<Item = usize> {
        let span = |axis: usize, count: usize| {
            let at = |metres: f64| ((metres - self.low[axis]) / self.cell).clamp(0.0, count as f64) as usize;
            at(bounds.low[axis])..at(bounds.high[axis] + self.cell)
        };
        let (columns, width) = (span(0, self.columns), self.columns);
        span(1, self.rows).flat_map(move |row| columns.clone().map(move |column| row * width + column))
    }

    /// Takes from some cells those within bounds whose middle is closed.
    fn close(&self, cells: &mut [bool], bounds: Bounds, is_closed: impl Fn(Point) -> bool) {
        for index in self.cells(bounds) {
            cells[index] = cells[index] && !is_closed(self.middle(index));
        }
    }

    /// Whether one gets from each of some places to each other past bodies, given as convex rings.
    pub(super) fn joins(&self, places: &[Point], bodies: &[Vec<Point>]) -> bool {
        let Some((&first, others)) = places.split_first() else { return true };
        let mut open = self.is_free.clone();
        for ring in bodies {
            let bounds = Bounds::around(ring.iter().copied()).inflated(BODY);
            self.close(&mut open, bounds, |at| distance_to_convex(ring, at) < BODY);
        }
        let Some(start) = self.nearest(&open, first) else { return false };
        // Most of what is not joined has no floor at all before it.
        if others.iter().any(|&place| self.nearest(&open, place).is_none()) {
            return false;
        }
        open[start] = false;
        let (mut next, mut missed) = (vec![start], others.to_vec());
        while let Some(index) = next.pop() {
            let here = self.middle(index);
            missed.retain(|place| here.distance_squared(*place) > NEAR * NEAR);
            if missed.is_empty() {
                return true;
            }
            // What was reached is closed behind.
            next.extend(self.beside(index).filter(|&cell| core::mem::replace(&mut open[cell], false)));
        }
        false
    }

    /// The cell nearest to a place, of some.
    fn nearest(&self, cells: &[bool], place: Point) -> Option<usize> {
        let distance = |index: usize| self.middle(index).distance_squared(place);
        let near = self.cells(Bounds::around_point(place, NEAR));
        let near = near.filter(|&index| cells[index] && distance(index) <= NEAR * NEAR);
        near.min_by(|&one, &other| distance(one).total_cmp(&distance(other)))
    }

    /// The cells that share a side with one.
    fn beside(&self, index: usize) -> impl Iterator<Item = usize> {
        let (column, row) = (index % self.columns, index / self.columns);
        let neighbours = [
            (column > 0).then(|| index - 1),
            (column + 1 < self.columns).then(|| index + 1),
            (row > 0).then(|| index - self.columns),
            (row + 1 < self.rows).then(|| index + self.columns),
        ];
        neighbours.into_iter().flatten()
    }
}
