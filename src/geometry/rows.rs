//! The edges of a ring by the rows that they pass: what a point is asked against, where a ring has many.

use std::sync::OnceLock;

use super::{Point, Segment, edges};

/// Rows at most: an edge as high as the ring stands in each of them.
const MOST_ROWS: usize = 64;

/// Made at the first question. What it says of a ring is in the corners already: rings with it and without are equal.
#[derive(Clone, Debug, Default)]
pub(super) struct Rows {
    found: OnceLock<Box<Edges>>,
}

/// The numbers of edges, row after row, and where each row begins among them.
#[derive(Clone, Debug)]
struct Edges {
    low: f64,
    /// Rows a metre.
    scale: f64,
    numbers: Vec<u32>,
    starts: Vec<u32>,
}

impl PartialEq for Rows {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl Rows {
    /// Whether a point lies inside the ring; the very answer that all its edges give.
    pub(super) fn contain(&self, corners: &[Point], point: Point) -> bool {
        let rows = self.found.get_or_init(|| Box::new(Edges::of(corners)));
        let count = corners.len();
        let crossed = rows.at(point.y).iter().filter(|&&number| {
            let number = number as usize;
            Segment::new(corners[number], corners[(number + 1) % count]).is_east_of(point)
        });
        crossed.count() % 2 == 1
    }
}

impl Edges {
    fn of(corners: &[Point]) -> Self {
        let heights = || corners.iter().map(|corner| corner.y);
        let low = heights().fold(f64::INFINITY, f64::min);
        let high = heights().fold(f64::NEG_INFINITY, f64::max);
        let count = (corners.len() / 4).clamp(1, MOST_ROWS);
        let mut rows = Self { low, scale: count as f64 / (high - low), numbers: Vec::new(), starts: vec![0] };
        let mut listed: Vec<Vec<u32>> = vec![Vec::new(); count];
        for (number, edge) in (0..).zip(edges(corners)) {
            let (one, other) = (rows.row(edge.start.y, count), rows.row(edge.end.y, count));
            for row in &mut listed[one.min(other)..=one.max(other)] {
                row.push(number);
            }
        }
        for row in listed {
            rows.numbers.extend(row);
            rows.starts.push(rows.numbers.len() as u32);
        }
        rows
    }

    /// The row of a height. Higher is never a row lower, however it is rounded: an edge is listed wherever a point is beside it.
    fn row(&self, y: f64, count: usize) -> usize {
        (((y - self.low) * self.scale) as usize).min(count - 1)
    }

    fn at(&self, y: f64) -> &[u32] {
        let row = self.row(y, self.starts.len() - 1);
        &self.numbers[self.starts[row] as usize..self.starts[row + 1] as usize]
    }
}

#[cfg(test)]
mod tests {
    use crate::geometry::{Point, Polygon, ring_contains};

    /// A comb of so many teeth, turned.
    fn comb(teeth: usize, angle: f64) -> Vec<Point> {
        let mut corners = vec![Point::new(0.0, -1.0), Point::new(teeth as f64, -1.0)];
        for tooth in (0..teeth).rev() {
            let at = tooth as f64;
            corners.extend([Point::new(at + 0.6, 3.0), Point::new(at + 0.4, 3.0), Point::new(at, 0.2)]);
        }
        corners.iter().map(|corner| Point::from_angle(angle).rotate(*corner)).collect()
    }

    #[test]
    fn rows_answer_as_all_edges_do() {
        for angle in [0.0, 0.5, 1.57, 4.0] {
            let ring = comb(40, angle);
            let polygon = Polygon::new(&ring).expect("a comb is simple");
            let places = (0..60 * 60).map(|index| {
                let at = Point::new(f64::from(index % 60) * 0.75 - 2.0, f64::from(index / 60) * 0.1 - 2.0);
                Point::from_angle(angle).rotate(at)
            });
            let corners = ring.iter().copied();
            let (mut inside, mut outside) = (0, 0);
            for place in places.chain(corners) {
                let expected = ring_contains(polygon.corners(), place);
                assert_eq!(polygon.contains(place), expected, "{place} at {angle}");
                if expected { inside += 1 } else { outside += 1 }
            }
            assert!(inside > 500 && outside > 500, "{inside} inside, {outside} outside");
        }
    }
}
