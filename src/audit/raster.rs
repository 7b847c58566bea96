//! A floor as cells of 5 cm, each with its distance to the nearest obstacle.

use core::ops::Range;

use crate::geometry::Point;

/// Metres from cell to cell.
pub(crate) const CELL: f64 = 0.05;

/// Metres by which a disc may seem too wide for a passage because of the cells: half of the step between
/// cells along a diagonal. With it, a passage as wide as the disc is passed whatever its direction.
const SLACK: f64 = 0.35 * CELL;

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
        let low = low - Point::splat(2.0 * CELL);
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

    /// Calls `visit` with the cells whose middles lie inside some rings, row by row.
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
                visit(column(pair[0])..column(pair[1]));
            }
        }
    }

    /// The distance of every cell to the nearest blocked one, in cells and squared; zero for blocked cells.
    ///
    /// P. Felzenszwalb, D. Huttenlocher, "Distance Transforms of Sampled Functions", Theory of Computing 8,
    /// 2012: distances along columns first, then along rows the lower envelope of the parabolas that stand on
    /// their squares. Rows are cut at blocked cells: no parabola from beyond one is the lowest.
    pub(crate) fn distances(&self) -> Vec<u32> {
        let mut squares = self.column_squares();
        let mut envelope = Envelope::default();
        for row in squares.chunks_exact_mut(self.columns) {
            let mut next = 0;
            while let Some(start) = row[next..].iter().position(|&square| square > 0).map(|at| next + at) {
                let length = row[start..].iter().position(|&square| square == 0);
                let end = start + length.expect("the outermost cells are blocked");
                envelope.lower(&mut row[start - 1..=end]);
                next = end;
            }
        }
        squares
    }

    fn column_squares(&self) -> Vec<u32> {
        let columns = self.columns;
        let mut steps = vec![0_u32; self.len()];
        for cell in columns..self.len() {
            if self.is_free[cell] {
                steps[cell] = steps[cell - columns] + 1;
            }
        }
        for cell in (0..self.len() - columns).rev() {
            steps[cell] = steps[cell].min(steps[cell + columns] + 1);
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
pub(crate) fn least_distance(diameter: f64) -> u32 {
    let radius = (diameter / 2.0 - SLACK).max(0.0) / CELL;
    ((radius * radius).ceil() as u32).max(1)
}

/// The lower envelope of parabolas, its buffers kept from run to run.
#[derive(Default)]
struct Envelope {
    /// Places of the parabolas in the envelope, with their heights.
    feet: Vec<(f64, f64)>,
    /// From where on each is the lowest.
    from: Vec<f64>,
}

impl Envelope {
    /// Replaces the heights of parabolas by the lowest value of all parabolas at each place.
    fn lower(&mut self, heights: &mut [u32]) {
        self.feet.clear();
        self.from.clear();
        for (place, &height) in heights.iter().enumerate() {
            let (place, height) = (place as f64, f64::from(height));
            let mut start = f64::NEG_INFINITY;
            while let (Some(&(foot, low)), Some(&from)) = (self.feet.last(), self.from.last()) {
                start = ((height + place * place) - (low + foot * foot)) / (2.0 * (place - foot));
                if start > from {
                    break;
                }
                self.feet.pop();
                self.from.pop();
            }
            self.feet.push((place, height));
            self.from.push(start);
        }
        let mut lowest = 0;
        for (place, height) in heights.iter_mut().enumerate() {
            let place = place as f64;
            while self.from.get(lowest + 1).is_some_and(|&from| from < place) {
                lowest += 1;
            }
            let (foot, low) = self.feet[lowest];
            *height = ((place - foot) * (place - foot) + low) as u32;
        }
    }
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
        let distances = raster.distances();
        let place = |cell: usize| (cell / raster.columns, cell % raster.columns);
        for (cell, &distance) in distances.iter().enumerate() {
            let (row, column) = place(cell);
            let blocked = (0..raster.len()).filter(|&other| !raster.is_free[other]).map(place);
            let nearest = blocked.map(|(y, x)| row.abs_diff(y).pow(2) + column.abs_diff(x).pow(2)).min();
            assert_eq!(distance as usize, nearest.unwrap(), "cell {row} {column}");
        }
    }

    #[test]
    fn a_disc_passes_where_it_fits_and_not_where_it_lacks_a_cell() {
        for shift in 0..10 {
            let shift = f64::from(shift) / 10.0 * CELL;
            let widest = |width: f64| {
                let mut raster = Raster::new((Point::ZERO, Point::new(2.0, 3.0)));
                raster.paint(&edges((0.1, 0.5 + shift), (1.5, width)), true);
                raster.distances().into_iter().max().unwrap()
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
            assert!(raster.distances().into_iter().max().unwrap() >= least_distance(0.45));
        }
    }
}
