//! A floor as cells of 5 cm, each with its distance to the nearest obstacle.

use core::ops::Range;

use crate::geometry::Point;

/// Metres from cell to cell.
pub(crate) const CELL: f64 = 0.05;

/// Metres by which cells are shifted against the room's corner, no whole millimetres: faces of walls and furniture, which
/// are, then do not run through the middles of a row, where rounding would decide whether it is free.
const OFF_GRID: f64 = 0.012_34;

/// Metres by which a disc may seem too wide for a passage because of the cells: half of the step between
/// cells along a diagonal. With it, a passage as wide as the disc is passed whatever its direction.
const SLACK: f64 = 0.35 * CELL;

/// Cells of the largest radius whose squares are counted: 7.5 m, more than anybody needs to pass.
const MOST_REACH: u16 = 150;

/// A grid of free and blocked cells. The outermost cells are always blocked.
pub(crate) struct Raster {
    /// Middle of the first cell.
    low: Point,
    columns: usize,
    is_free: Vec<bool>,
}

impl Raster {
    /// A grid around a box, all of it blocked.
    pub(crate) fn new((low, high): (Point, Point)) -> Self {
        let low = low - Point::splat(2.0 * CELL + OFF_GRID);
        let size = (high - low) / CELL + Point::splat(3.0);
        let (columns, rows) = (size.x as usize, size.y as usize);
        Self { low, columns, is_free: vec![false; columns * rows] }
    }

    /// Number of cells in a row.
    pub(crate) fn columns(&self) -> usize {
        self.columns
    }

    /// Number of cells.
    pub(crate) fn len(&self) -> usize {
        self.is_free.len()
    }

    /// The middle of a cell.
    pub(crate) fn middle(&self, cell: usize) -> Point {
        let (row, column) = (cell / self.columns, cell % self.columns);
        self.low + Point::new(column as f64, row as f64) * CELL
    }

    /// Marks the cells whose middles lie inside some rings; where rings overlap, every second one counts.
    pub(crate) fn paint(&mut self, edges: &[(Point, Point)], is_free: bool) {
        let mut spans = Vec::new();
        self.spans(edges, |span| spans.push(span));
        spans.into_iter().for_each(|span| self.is_free[span].fill(is_free));
    }

    /// Calls `visit` with the cells whose middles lie inside some rings, row by row; never with none.
    pub(crate) fn spans(&self, edges: &[(Point, Point)], mut visit: impl FnMut(Range<usize>)) {
        let (low, high) =
            edges.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), (start, end)| {
                (low.min(start.y.min(end.y)), high.max(start.y.max(end.y)))
            });
        let rows = self.len() / self.columns;
        let mut crossings: Vec<f64> = Vec::new();
        for row in index_after(low - self.low.y, rows)..index_after(high - self.low.y, rows) {
            let y = self.low.y + row as f64 * CELL;
            let crossed = edges.iter().filter(|(start, end)| (start.y > y) != (end.y > y));
            crossings.clear();
            crossings.extend(
                crossed.map(|(start, end)| start.x + (y - start.y) / (end.y - start.y) * (end.x - start.x)),
            );
            crossings.sort_unstable_by(f64::total_cmp);
            for pair in crossings.chunks_exact(2) {
                let column = |x: f64| row * self.columns + index_after(x - self.low.x, self.columns);
                let span = column(pair[0])..column(pair[1]);
                if !span.is_empty() {
                    visit(span);
                }
            }
        }
    }

    /// The distance of every cell to the nearest blocked one, in cells and squared: exact up to `reach` cells,
    /// more than that beyond it, zero for blocked cells.
    ///
    /// T. Saito, J. Toriwaki, "New algorithms for Euclidean distance transformation", Pattern Recognition 27,
    /// 1994: distances along columns first, then along rows the least sum of squares. A person's radius reaches
    /// over so few cells that trying each of them, on whole rows at once, is faster than any cleverer search.
    pub(crate) fn distances(&self, reach: u16) -> Vec<u16> {
        let heights = self.column_squares(reach + 1);
        let mut squares = heights.clone();
        let rows = squares.chunks_exact_mut(self.columns).zip(heights.chunks_exact(self.columns));
        for (squares, heights) in rows {
            for step in (1..=reach).take(self.columns - 1) {
                let (from, aside) = (usize::from(step), step * step);
                let lower = |(square, &height): (&mut u16, &u16)| *square = (*square).min(height + aside);
                squares[from..].iter_mut().zip(heights).for_each(lower);
                squares.iter_mut().zip(&heights[from..]).for_each(lower);
            }
        }
        squares
    }

    /// The distance of every cell to the nearest blocked one of its column, at most `most`, squared.
    fn column_squares(&self, most: u16) -> Vec<u16> {
        let columns = self.columns;
        let mut steps = vec![0_u16; self.len()];
        for start in (columns..self.len()).step_by(columns) {
            let (before, row) = steps[start - columns..start + columns].split_at_mut(columns);
            for ((step, &before), &is_free) in row.iter_mut().zip(&*before).zip(&self.is_free[start..]) {
                *step = u16::from(is_free) * (before + 1).min(most);
            }
        }
        for start in (columns..self.len()).step_by(columns).rev() {
            let (row, after) = steps[start - columns..start + columns].split_at_mut(columns);
            row.iter_mut().zip(&*after).for_each(|(step, &after)| *step = (*step).min(after + 1));
        }
        steps.iter_mut().for_each(|step| *step *= *step);
        steps
    }
}

/// The first index whose cell middle lies at or after `metres` from the first, at most `count`.
fn index_after(metres: f64, count: usize) -> usize {
    // Numbers below zero become zero.
    ((metres / CELL).ceil() as usize).min(count)
}

/// The least distance, as [`Raster::distances`] gives it, of cells where a disc of a diameter may be.
pub(crate) fn least_distance(diameter: f64) -> u16 {
    let radius = (diameter / 2.0 - SLACK).max(0.0) / CELL;
    ((radius * radius).ceil() as u16).max(1)
}

/// Cells from the middle to the edge of a disc of a diameter, rounded up.
pub(crate) fn reach(diameter: f64) -> u16 {
    ((diameter / 2.0 / CELL).ceil() as u16).min(MOST_REACH)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Polygon;

    fn edges(low: (f64, f64), size: (f64, f64)) -> Vec<(Point, Point)> {
        Polygon::rectangle(low.into(), size.into()).edges().collect()
    }

    fn room(size: (f64, f64)) -> Raster {
        let mut raster = Raster::new((Point::ZERO, size.into()));
        raster.paint(&edges((0.0, 0.0), size), true);
        raster
    }

    #[test]
    fn a_rectangle_has_its_area_in_cells() {
        let raster = room((2.0, 1.0));
        let free = raster.is_free.iter().filter(|&&is_free| is_free).count();
        assert_eq!(free, 40 * 20);
        let columns = raster.columns();
        assert!(
            !raster.is_free[..columns].contains(&true)
                && !raster.is_free[raster.len() - columns..].contains(&true)
        );
    }

    #[test]
    fn distances_are_those_of_asking_every_blocked_cell() {
        let mut raster = room((1.6, 1.3));
        raster.paint(&edges((0.3, 0.4), (0.1, 0.5)), false);
        raster.paint(&edges((1.0, 0.2), (0.05, 0.05)), false);
        raster.paint(&edges((1.1, 0.9), (0.3, 0.1)), false);
        let reach = 6;
        let distances = raster.distances(reach);
        let place = |cell: usize| (cell / raster.columns, cell % raster.columns);
        let mut beyond = 0;
        for (cell, &distance) in distances.iter().enumerate() {
            let (row, column) = place(cell);
            let blocked = (0..raster.len()).filter(|&other| !raster.is_free[other]).map(place);
            let nearest = blocked.map(|(y, x)| row.abs_diff(y).pow(2) + column.abs_diff(x).pow(2)).min();
            let (distance, nearest) = (usize::from(distance), nearest.unwrap());
            let is_beyond = nearest > usize::from(reach * reach);
            assert!(
                if is_beyond { distance > usize::from(reach * reach) } else { distance == nearest },
                "cell {row} {column}: {distance}, not {nearest}"
            );
            beyond += usize::from(is_beyond);
        }
        assert!(beyond > 10, "{beyond}");
    }

    #[test]
    fn a_disc_passes_where_it_fits_and_not_where_it_lacks_a_cell() {
        for shift in 0..10 {
            let shift = f64::from(shift) / 10.0 * CELL;
            let widest = |width: f64| {
                let mut raster = Raster::new((Point::ZERO, Point::new(2.0, 3.0)));
                raster.paint(&edges((0.1, 0.5 + shift), (1.5, width)), true);
                raster.distances(reach(0.45)).into_iter().max().unwrap()
            };
            assert!(widest(0.451) >= least_distance(0.45), "shifted by {shift}");
            assert!(widest(0.399) < least_distance(0.45), "shifted by {shift}");
        }
    }

    #[test]
    fn a_disc_passes_across_the_cells_too() {
        let along = Point::new(0.8, 0.6);
        for shift in 0..10 {
            let start = Point::new(0.5, 0.5) + Point::splat(f64::from(shift) / 10.0 * CELL);
            let corners = [start, start + along * 2.0, start + along * 2.0 + along.perp() * 0.45];
            let polygon =
                Polygon::new(&[corners[0], corners[1], corners[2], start + along.perp() * 0.45]).unwrap();
            let mut raster = Raster::new(polygon.bounds());
            raster.paint(&polygon.edges().collect::<Vec<_>>(), true);
            assert!(raster.distances(reach(0.45)).into_iter().max().unwrap() >= least_distance(0.45));
        }
    }
}
