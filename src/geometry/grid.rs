//! A uniform grid over a room: the broad phase of collision and containment.

use super::{Bounds, Convex, Point, Segment, edges};

/// Metres of a cell; about the size of one piece of furniture, so that most bodies lie in one to four cells.
const CELL: f64 = 1.0;
/// Cells along one axis at most; larger halls get larger cells.
const MAXIMUM_CELLS: usize = 64;
/// Metres that rounding may shift the edge of a cell, and far more.
const ROUNDING: f64 = 1e-6;
const NONE: u32 = u32::MAX;

/// Items by the cells that their bounding boxes touch. Items are numbers of the caller's; an item may be
/// reported more than once by a query.
#[derive(Clone, Debug)]
pub struct Grid {
    origin: Point,
    /// Cells per metre.
    scale: Point,
    columns: usize,
    rows: usize,
    /// First entry of each cell.
    heads: Vec<u32>,
    /// Item and next entry of the same cell.
    entries: Vec<(u32, u32)>,
}

impl Grid {
    /// A grid over a box; what lies outside is kept in the border cells.
    #[must_use]
    pub fn new(bounds: Bounds) -> Self {
        let size = bounds.size().max(Point::splat(CELL));
        let cells = |length: f64| ((length / CELL).ceil() as usize).clamp(1, MAXIMUM_CELLS);
        let (columns, rows) = (cells(size.x), cells(size.y));
        let scale = Point::new(columns as f64 / size.x, rows as f64 / size.y);
        Self {
            origin: bounds.low,
            scale,
            columns,
            rows,
            heads: vec![NONE; columns * rows],
            entries: Vec::new(),
        }
    }

    fn cells(&self, bounds: Bounds) -> (usize, usize, usize, usize) {
        let [low, high] = [bounds.low, bounds.high].map(|corner| (corner - self.origin) * self.scale);
        (
            index_of(low.x, self.columns),
            index_of(high.x, self.columns),
            index_of(low.y, self.rows),
            index_of(high.y, self.rows),
        )
    }

    /// Adds an item with its bounding box.
    pub fn insert(&mut self, item: u32, bounds: Bounds) {
        let (left, right, bottom, top) = self.cells(bounds);
        for row in bottom..=top {
            for column in left..=right {
                let head = &mut self.heads[row * self.columns + column];
                let entry =
                    u32::try_from(self.entries.len()).expect("a room holds fewer than 2^32 cells of bodies");
                self.entries.push((item, *head));
                *head = entry;
            }
        }
    }

    /// Takes an item out again; `bounds` as it was added.
    pub fn remove(&mut self, item: u32, bounds: Bounds) {
        let (left, right, bottom, top) = self.cells(bounds);
        // Backwards: an item that was added last gives back all of its entries.
        for row in (bottom..=top).rev() {
            for column in (left..=right).rev() {
                self.unlink(row * self.columns + column, item);
            }
        }
    }

    fn unlink(&mut self, cell: usize, item: u32) {
        let mut previous = NONE;
        let mut entry = self.heads[cell];
        while entry != NONE {
            let (found, next) = self.entries[entry as usize];
            if found == item {
                match previous {
                    NONE => self.heads[cell] = next,
                    _ => self.entries[previous as usize].1 = next,
                }
                if entry as usize + 1 == self.entries.len() {
                    self.entries.pop();
                }
                return;
            }
            previous = entry;
            entry = next;
        }
    }

    /// Whether any item whose cells meet the box answers yes; stops at the first.
    pub fn any(&self, bounds: Bounds, mut question: impl FnMut(u32) -> bool) -> bool {
        let (left, right, bottom, top) = self.cells(bounds);
        (bottom..=top).any(|row| {
            (left..=right).any(|column| self.items(row * self.columns + column).any(&mut question))
        })
    }

    fn items(&self, cell: usize) -> impl Iterator<Item = u32> + '_ {
        let mut entry = self.heads[cell];
        std::iter::from_fn(move || {
            let &(item, next) = self.entries.get(entry as usize)?;
            entry = next;
            Some(item)
        })
    }

    /// Calls `visit` for every item whose cells meet the box.
    pub fn each(&self, bounds: Bounds, mut visit: impl FnMut(u32)) {
        self.any(bounds, |item| {
            visit(item);
            false
        });
    }

    /// The same for every item whose cells meet a convex polygon: far fewer than meet its box, where it is the strip
    /// along a slanted wall.
    pub fn each_under(&self, base: &Convex, mut visit: impl FnMut(u32)) {
        let bounds = base.bounds();
        let (left, right, bottom, top) = self.cells(bounds);
        if base.fills_its_bounds() || left == right || bottom == top {
            // Along an axis, as most walls run, the box is the strip.
            return self.each(bounds, visit);
        }
        for row in bottom..=top {
            // Cells of the border hold what lies outside, too.
            let low = if row == 0 { f64::NEG_INFINITY } else { self.bottom_of(row) };
            let high = if row + 1 == self.rows { f64::INFINITY } else { self.bottom_of(row + 1) };
            let Some((from, to)) = extent_between(base, low - ROUNDING, high + ROUNDING) else { continue };
            let column_of = |x: f64| index_of((x - self.origin.x) * self.scale.x, self.columns);
            let (from, to) = (column_of(from - ROUNDING), column_of(to + ROUNDING));
            for column in from.max(left)..=to.min(right) {
                self.items(row * self.columns + column).for_each(&mut visit);
            }
        }
    }

    fn bottom_of(&self, row: usize) -> f64 {
        self.origin.y + row as f64 / self.scale.y
    }
}

/// The row or column of a place in cells, of so many; what lies outside is in the first or the last.
fn index_of(place: f64, count: usize) -> usize {
    (place.max(0.0) as usize).min(count - 1)
}

/// Lowest and highest x of what a polygon has between two heights of the plan; `None` where it has nothing there.
fn extent_between(base: &Convex, low: f64, high: f64) -> Option<(f64, f64)> {
    let mut extent = None;
    for Segment { start: a, end: b } in edges(base.corners()) {
        let (lower, upper) = if a.y <= b.y { (a, b) } else { (b, a) };
        if upper.y < low || lower.y > high {
            continue;
        }
        let at = |y: f64| lower.x + (upper.x - lower.x) * ((y - lower.y) / (upper.y - lower.y));
        let start = if lower.y < low { at(low) } else { lower.x };
        let end = if upper.y > high { at(high) } else { upper.x };
        let (from, to) = extent.unwrap_or((start, start));
        extent = Some((start.min(end).min(from), start.max(end).max(to)));
    }
    extent
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_grid_finds_near_items_and_forgets_removed_ones() {
        let mut grid = Grid::new(Bounds::new(Point::ZERO, Point::splat(10.0)));
        grid.insert(7, Bounds::new(Point::splat(1.2), Point::splat(3.4)));
        grid.insert(8, Bounds::new(Point::splat(8.0), Point::splat(8.5)));
        let found = |grid: &Grid, x: f64| {
            let mut items = Vec::new();
            grid.each(Bounds::new(Point::splat(x), Point::splat(x + 0.1)), |item| items.push(item));
            items
        };
        assert_eq!(found(&grid, 2.5), [7]);
        assert_eq!(found(&grid, 8.2), [8]);
        grid.remove(7, Bounds::new(Point::splat(1.2), Point::splat(3.4)));
        assert!(found(&grid, 2.5).is_empty());
        grid.remove(8, Bounds::new(Point::splat(8.0), Point::splat(8.5)));
        let entry_count = grid.entries.len();
        for _ in 0..3 {
            grid.insert(9, Bounds::new(Point::splat(1.2), Point::splat(3.4)));
            assert_eq!(found(&grid, 2.5), [9]);
            grid.remove(9, Bounds::new(Point::splat(1.2), Point::splat(3.4)));
        }
        assert_eq!(grid.entries.len(), entry_count, "what came last leaves nothing behind");
    }

    #[test]
    fn items_outside_the_grid_are_found_at_its_border() {
        let mut grid = Grid::new(Bounds::new(Point::ZERO, Point::splat(4.0)));
        grid.insert(1, Bounds::new(Point::splat(-3.0), Point::splat(-2.0)));
        assert!(grid.any(Bounds::new(Point::splat(-5.0), Point::splat(-1.0)), |item| item == 1));
    }

    #[test]
    fn a_slanted_strip_finds_all_items_that_it_meets_and_few_others() {
        let mut grid = Grid::new(Bounds::new(Point::ZERO, Point::splat(20.0)));
        let box_of = |item: u32| {
            let low = Point::new(f64::from(item % 23), f64::from(item / 23)) - 1.5;
            Bounds::new(low, low + 0.6)
        };
        (0..23 * 23).for_each(|item| grid.insert(item, box_of(item)));
        for turn in 0..12 {
            let axis = Point::from_angle(f64::from(turn) * 0.27);
            let strip = Convex::rectangle(Point::new(10.0, 9.5), Point::new(11.0, 0.3), axis);
            let mut found = std::collections::BTreeSet::new();
            grid.each_under(&strip, |item| {
                found.insert(item);
            });
            let is_met = |&item: &u32| {
                let bounds = box_of(item);
                Convex::rectangle(bounds.center(), bounds.size() / 2.0, Point::X).overlaps(&strip, 0.0)
            };
            let met: Vec<u32> = (0..23 * 23).filter(is_met).collect();
            assert!(met.len() > 10 && met.iter().all(|item| found.contains(item)), "turn {turn}");
            assert!(found.len() < 140, "turn {turn}: {}", found.len());
        }
    }
}
