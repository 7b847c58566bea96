//! The borders of a room and of its columns, with a broad phase where they are many.

use crate::geometry::{Bounds, Grid, Point, Segment};

use super::empty_room::EmptyRoom;

/// Borders from which on a grid finds those near a place faster than looking at each.
const MANY: usize = 32;
/// Metres around a place in which the nearest border is looked for, where there are many.
const REACH: f64 = 1.0;

/// The edges of a room's outline, holes and columns.
pub(super) struct Borders {
    edges: Vec<Segment>,
    grid: Option<Grid>,
}

impl Borders {
    pub(super) fn new(empty: &EmptyRoom<'_>) -> Self {
        let columns = empty.at.room.obstacles.iter().flat_map(|column| column.outline.edges());
        // Columns bound the floor from inside as the outline does from outside: a piece crosses neither.
        let edges: Vec<Segment> = empty.at.room.region.borders().chain(columns).collect();
        let grid = (edges.len() > MANY).then(|| {
            let mut grid = Grid::new(empty.at.room.region.outline.bounds());
            for (number, edge) in (0..).zip(&edges) {
                grid.insert(number, edge.bounds());
            }
            grid
        });
        Self { edges, grid }
    }

    /// How many there are.
    pub(super) fn len(&self) -> usize {
        self.edges.len()
    }

    /// Metres from a point to the nearest border, or less where that is farther than [`REACH`]; and how many borders
    /// were looked at.
    pub(super) fn distance(&self, point: Point) -> (f64, u64) {
        let to_edge = |edge: &Segment| edge.distance_squared(point);
        let Some(grid) = &self.grid else {
            let nearest = self.edges.iter().map(to_edge).fold(f64::INFINITY, f64::min);
            // Squares are compared, and one root is taken of the least.
            return (nearest.sqrt(), self.edges.len() as u64);
        };
        let (mut nearest, mut looked_at) = (REACH * REACH, 0);
        grid.each(Bounds::around_point(point, REACH), |number| {
            looked_at += 1;
            nearest = nearest.min(to_edge(&self.edges[number as usize]));
        });
        (nearest.sqrt(), looked_at)
    }

    /// Whether a border whose box meets some bounds, or comes as near as `margin`, answers yes; and how many were
    /// looked at.
    pub(super) fn any_near(
        &self,
        bounds: Bounds,
        margin: f64,
        question: impl Fn(Segment) -> bool,
    ) -> (bool, u64) {
        // Boxes overlap by more than a negative length where they come nearer than that length.
        let is_it = |edge: Segment| edge.bounds().overlaps(bounds, -margin) && question(edge);
        let Some(grid) = &self.grid else {
            return (self.edges.iter().any(|&edge| is_it(edge)), self.edges.len() as u64);
        };
        let mut looked_at = 0;
        let found = grid.any(bounds.inflated(margin), |number| {
            looked_at += 1;
            is_it(self.edges[number as usize])
        });
        (found, looked_at)
    }
}
