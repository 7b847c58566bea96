//! A floor as cells of 5 cm, in the largest rooms of 10 or 15, each with its distance to the nearest obstacle.

use core::ops::Range;

use crate::geometry::{Bounds, Point, Segment};

/// Metres from cell to cell, but in the largest rooms.
pub(crate) const CELL: f64 = 0.05;

/// Cells of a floor at most: those of a box of 28,000 m². Around larger rooms cells are twice as wide, or three times, as
/// they need be. A cell takes 40 bytes while ways are looked for, so that all of them take 450 MB; the largest room that
/// is read has cells of 15 cm.
const MOST_CELLS: f64 = 11_200_000.0;

/// Metres by which cells are shifted against the room's corner, no whole millimetres: faces of walls and furniture, which
/// are, then do not run through the middles of a row, where rounding would decide whether it is free.
const OFF_GRID: f64 = 0.012_34;

/// Cells by which a disc may seem too wide for a passage because of the cells: half of the step between
/// cells along a diagonal. With it, a passage as wide as the disc is passed whatever its direction.
const SLACK: f64 = 0.35;

/// Cells of the largest radius whose squares are counted: 7.5 m, more than anybody needs to pass.
const MOST_REACH: u16 = 150;

/// Cells of a row whose distances are found at once: as many as stay in registers while all that lie beside them are tried.
const BLOCK: usize = 32;

/// A grid of free and blocked cells. The outermost cells are always blocked.
#[derive(Clone, Debug)]
pub(crate) struct Raster {
    /// Middle of the first cell.
    low: Point,
    /// Metres from cell to cell.
    cell: f64,
    columns: usize,
    is_free: Vec<bool>,
}

impl Raster {
    /// A grid of cells of a width around a box, all of it blocked.
    pub(crate) fn new(bounds: Bounds, cell: f64) -> Self {
        let low = bounds.low - Point::splat(2.0 * cell + OFF_GRID);
        let size = (bounds.high - low) / cell + Point::splat(3.0);
        let (columns, rows) = (size.x as usize, size.y as usize);
        Self { low, cell, columns, is_free: vec![false; columns * rows] }
    }

    /// Metres from cell to cell.
    pub(crate) fn cell(&self) -> f64 {
        self.cell
    }

    /// Number of cells in a row.
    pub(crate) fn columns(&self) -> usize {
        self.columns
    }

    /// Number of cells.
    pub(crate) fn len(&self) -> usize {
        self.is_free.len()
    }

    /// Whether a cell is free.
    pub(crate) fn is_free(&self, cell: usize) -> bool {
        self.is_free[cell]
    }

    /// The outer corner of the first cell.
    pub(crate) fn corner(&self) -> Point {
        self.low - Point::splat(self.cell / 2.0)
    }

    /// The middle of a cell.
    pub(crate) fn middle(&self, cell: usize) -> Point {
        let (row, column) = (cell / self.columns, cell % self.columns);
        self.low + Point::new(column as f64, row as f64) * self.cell
    }

    /// Calls `visit` with every cell whose middle lies in a box, row by row.
    pub(super) fn cells_in(&self, Bounds { low, high }: Bounds, mut visit: impl FnMut(usize)) {
        let (low, high, rows) = (low - self.low, high - self.low, self.len() / self.columns);
        let columns = self.index_after(low.x, self.columns)..self.index_after(high.x, self.columns);
        for row in self.index_after(low.y, rows)..self.index_after(high.y, rows) {
            columns.clone().for_each(|column| visit(row * self.columns + column));
        }
    }

    /// Marks the cells whose middles lie inside some rings; where rings overlap, every second one counts. Returns them,
    /// row by row.
    pub(crate) fn paint(&mut self, edges: &[Segment], is_free: bool) -> Vec<Range<usize>> {
        let mut spans = Vec::new();
        self.spans(edges, |span| spans.push(span));
        spans.iter().for_each(|span| self.is_free[span.clone()].fill(is_free));
        spans
    }

    /// Calls `visit` with the cells whose middles lie inside some rings, row by row; never with none.
    pub(crate) fn spans(&self, edges: &[Segment], mut visit: impl FnMut(Range<usize>)) {
        let Bounds { low, high } =
            edges.iter().fold(Bounds::EMPTY, |bounds, edge| bounds.union(edge.bounds()));
        let rows = self.len() / self.columns;
        let mut crossings: Vec<f64> = Vec::new();
        // Most furniture stands along the rows: the columns of one row are those of the next.
        let (mut last, mut columns) = ([f64::NAN; 2], [0; 2]);
        for row in self.index_after(low.y - self.low.y, rows)..self.index_after(high.y - self.low.y, rows) {
            let y = self.low.y + row as f64 * self.cell;
            let crossed = edges.iter().filter(|edge| (edge.start.y > y) != (edge.end.y > y));
            crossings.clear();
            crossings.extend(crossed.map(|edge| crossing(edge, y)));
            crossings.sort_unstable_by(f64::total_cmp);
            for pair in crossings.chunks_exact(2) {
                if pair != last {
                    last.copy_from_slice(pair);
                    columns = last.map(|x| self.index_after(x - self.low.x, self.columns));
                }
                if columns[0] < columns[1] {
                    visit(row * self.columns + columns[0]..row * self.columns + columns[1]);
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
        let columns = self.columns;
        // One cell farther than is asked for, so that what is beyond the reach is not taken for exactly at it.
        let mut squares = self.column_squares(reach + 1);
        // A row with as many cells on both sides as are tried, and more up to a whole block: all of no obstacle.
        let margin = usize::from(reach);
        let mut heights = vec![u16::MAX - reach * reach; columns.next_multiple_of(BLOCK) + 2 * margin];
        for row in squares.chunks_exact_mut(columns) {
            heights[margin..][..columns].copy_from_slice(row);
            for (block, squares) in row.chunks_mut(BLOCK).enumerate() {
                let least = least_squares(&heights[block * BLOCK..][..BLOCK + 2 * margin], margin);
                squares.copy_from_slice(&least[..squares.len()]);
            }
        }
        squares
    }

    /// Updates [`Raster::distances`] after the cells of some spans are blocked too. `blocked` as [`Raster::paint`] gives it.
    pub(crate) fn lower_distances(&self, distances: &mut [u16], blocked: &[Range<usize>], reach: u16) {
        let (all_rows, all_columns) = (self.len() / self.columns, self.columns);
        let reach = usize::from(reach);
        let mut squares_aside: Vec<u16> = Vec::new();
        // Most furniture stands along the rows: its spans are one rectangle, whose cells need not be asked one row at a time.
        let is_below = |a: &Range<usize>, b: &Range<usize>| {
            a.start + all_columns == b.start && a.end + all_columns == b.end
        };
        for rectangle in blocked.chunk_by(is_below) {
            let (row, from) = (rectangle[0].start / all_columns, rectangle[0].start % all_columns);
            let (rows, columns) = (row..row + rectangle.len(), from..from + rectangle[0].len());
            let near = around(&columns, reach, all_columns);
            squares_aside.clear();
            squares_aside.extend(near.clone().map(|column| steps_to(&columns, column).pow(2)));
            for row in around(&rows, reach, all_rows) {
                let above = steps_to(&rows, row).pow(2);
                let squares = &mut distances[row * all_columns..][near.clone()];
                for (square, &aside) in squares.iter_mut().zip(&squares_aside) {
                    *square = (*square).min(above + aside);
                }
            }
        }
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

    /// The first index whose cell middle lies at or after `metres` from the first, at most `count`.
    fn index_after(&self, metres: f64, count: usize) -> usize {
        // Rounded up by hand, which is a call on processors of twenty years ago, for which this is compiled. Numbers below zero
        // become zero.
        let place = metres / self.cell;
        let whole = place as usize;
        whole.saturating_add(usize::from(place > whole as f64)).min(count)
    }

    /// The least distance, as [`Raster::distances`] gives it, of cells where a disc of a diameter may be.
    pub(crate) fn least_distance(&self, diameter: f64) -> u16 {
        // Less slack closes passages that are as wide as the disc and lie askew; more opens some that are two centimetres too narrow.
        let radius = (diameter / 2.0 - SLACK * self.cell).max(0.0) / self.cell;
        ((radius * radius).ceil() as u16).max(1)
    }

    /// Cells from the middle to the edge of a disc of a diameter, rounded up.
    pub(crate) fn reach(&self, diameter: f64) -> u16 {
        ((diameter / 2.0 / self.cell).ceil() as u16).min(MOST_REACH)
    }
}

/// A range and so many steps more on both sides, of those from zero to an end.
fn around(range: &Range<usize>, reach: usize, end: usize) -> Range<usize> {
    range.start.saturating_sub(reach)..(range.end + reach).min(end)
}

/// Steps from a place near a range, which is not empty, to the range; zero inside.
fn steps_to(range: &Range<usize>, place: usize) -> u16 {
    range.start.saturating_sub(place).max((place + 1).saturating_sub(range.end)) as u16
}

/// Where an edge that crosses a row does so.
fn crossing(&Segment { start, end }: &Segment, y: f64) -> f64 {
    if start.x == end.x { start.x } else { start.x + (y - start.y) / (end.y - start.y) * (end.x - start.x) }
}

/// The least sums of squares of a block of cells. `heights` are the squares along columns of the cells and of `margin` more on
/// both sides.
fn least_squares(heights: &[u16], margin: usize) -> [u16; BLOCK] {
    let block = |from: usize| -> &[u16; BLOCK] {
        heights[from..][..BLOCK].try_into().expect("a block lies so far from both ends")
    };
    let mut least = *block(margin);
    for step in 1..=margin {
        let aside = (step * step) as u16;
        let (before, after) = (block(margin - step), block(margin + step));
        for ((least, &before), &after) in least.iter_mut().zip(before).zip(after) {
            *least = (*least).min(before.min(after) + aside);
        }
    }
    least
}

/// Metres from cell to cell for a floor of a size in metres: as wanted, or twice, three times as much for a large one.
pub(crate) fn cell_around(size: Point, wanted: f64) -> f64 {
    let cells = (size.x / wanted) * (size.y / wanted);
    wanted * (cells / MOST_CELLS).sqrt().ceil().max(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Polygon;

    fn edges(low: (f64, f64), size: (f64, f64)) -> Vec<Segment> {
        Polygon::rectangle(low.into(), size.into()).edges().collect()
    }

    fn room(size: (f64, f64)) -> Raster {
        let mut raster = Raster::new(Bounds::new(Point::ZERO, size.into()), CELL);
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
                let mut raster = Raster::new(Bounds::new(Point::ZERO, Point::new(2.0, 3.0)), CELL);
                raster.paint(&edges((0.1, 0.5 + shift), (1.5, width)), true);
                (raster.distances(raster.reach(0.45)).into_iter().max().unwrap(), raster.least_distance(0.45))
            };
            let passes = |(distance, least): (u16, u16)| distance >= least;
            assert!(passes(widest(0.451)), "shifted by {shift}");
            assert!(!passes(widest(0.399)), "shifted by {shift}");
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
            let mut raster = Raster::new(polygon.bounds(), CELL);
            raster.paint(&polygon.edges().collect::<Vec<_>>(), true);
            let widest = raster.distances(raster.reach(0.45)).into_iter().max().unwrap();
            assert!(widest >= raster.least_distance(0.45));
        }
    }

    #[test]
    fn rooms_of_ordinary_size_have_cells_of_five_centimetres_and_the_largest_no_more_cells_than_others() {
        let cell = |width: f64, depth: f64| (cell_around(Point::new(width, depth), CELL) * 100.0).round();
        assert_eq!([cell(1.0, 1.0), cell(30.0, 20.0), cell(160.0, 170.0)], [5.0; 3]);
        assert_eq!([cell(300.0, 300.0), cell(500.0, 500.0), cell(1000.0, 250.0)], [10.0, 15.0, 15.0]);
        let raster = Raster::new(
            Bounds::new(Point::ZERO, Point::splat(500.0)),
            cell_around(Point::splat(500.0), CELL),
        );
        assert!((raster.len() as f64) < 1.01 * MOST_CELLS, "{}", raster.len());
    }

    #[test]
    fn distances_to_new_obstacles_are_those_of_asking_all_again() {
        let mut raster = room((3.0, 2.0));
        raster.paint(&edges((0.3, 0.4), (0.1, 0.5)), false);
        let reach = 6;
        let mut distances = raster.distances(reach);
        for (low, size) in [((1.0, 0.2), (0.35, 0.45)), ((2.6, 1.5), (0.4, 0.5)), ((1.2, 0.5), (0.1, 0.1))] {
            let blocked = raster.paint(&edges(low, size), false);
            raster.lower_distances(&mut distances, &blocked, reach);
        }
        // Askew, so that no row is like the next, and with two spans in a row.
        let corners = [(1.9, 0.3), (2.4, 0.8), (1.9, 1.5), (2.1, 0.8)].map(Point::from);
        let blocked = raster.paint(&Polygon::new(&corners).unwrap().edges().collect::<Vec<_>>(), false);
        raster.lower_distances(&mut distances, &blocked, reach);
        let near = |distance: u16| distance.min(reach * reach + 1);
        let all_again: Vec<u16> = raster.distances(reach).into_iter().map(near).collect();
        assert_eq!(distances.into_iter().map(near).collect::<Vec<u16>>(), all_again);
    }
}
