//! Simple polygons in the plan frame, and regions with holes.

use std::fmt;

use super::rows::Rows;
use super::{Bounds, Point, Segment, edges};

/// Corners closer than this are one corner (real plans carry corners 2 cm apart; this is below any of them).
pub const CORNER_TOLERANCE: f64 = 1e-4;
/// Smallest area of a polygon in square metres.
pub const MINIMUM_AREA: f64 = 1e-4;

/// Corners from which on the rows of edges pay.
const MANY: usize = 24;

/// A simple polygon in plan metres: at least three corners, counter-clockwise, not closed (the last
/// corner is not the first), no two neighbouring corners equal, area above [`MINIMUM_AREA`].
#[derive(Clone, Debug, PartialEq)]
pub struct Polygon {
    corners: Vec<Point>,
    rows: Rows,
}

/// Why a list of points is no [`Polygon`].
#[derive(Clone, Debug, PartialEq)]
pub enum PolygonFault {
    /// Fewer than three distinct corners remain.
    TooFewCorners(usize),
    /// A coordinate is NaN or infinite; the index of the point in the input.
    NotFinite(usize),
    /// Two edges cross or touch; the indices of their first corners in the input.
    SelfCrossing(usize, usize),
    /// The area in square metres is too small.
    NoArea(f64),
}

impl fmt::Display for PolygonFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooFewCorners(count) => write!(f, "outline has {count} distinct corners, three are needed"),
            Self::NotFinite(index) => write!(f, "corner {index} is not a finite number"),
            Self::SelfCrossing(a, b) => write!(f, "outline crosses itself: edge {a} meets edge {b}"),
            Self::NoArea(area) => write!(f, "outline encloses only {area:.6} m²"),
        }
    }
}

impl Polygon {
    /// Checks and orders the corners: drops a closing point and repeated corners, turns clockwise rings.
    ///
    /// # Errors
    /// The first [`PolygonFault`] found, with indices into `points`.
    pub fn new(points: &[Point]) -> Result<Self, PolygonFault> {
        if let Some(index) = points.iter().position(|point| !point.is_finite()) {
            return Err(PolygonFault::NotFinite(index));
        }
        let mut kept: Vec<(usize, Point)> = Vec::with_capacity(points.len());
        for (index, &point) in points.iter().enumerate() {
            if kept.last().is_none_or(|&(_, last)| last.distance(point) > CORNER_TOLERANCE) {
                kept.push((index, point));
            }
        }
        while kept.len() > 1 && kept[0].1.distance(kept[kept.len() - 1].1) <= CORNER_TOLERANCE {
            kept.pop();
        }
        if kept.len() < 3 {
            return Err(PolygonFault::TooFewCorners(kept.len()));
        }
        let mut corners: Vec<Point> = kept.iter().map(|&(_, point)| point).collect();
        if let Some((a, b)) = first_crossing(&corners) {
            return Err(PolygonFault::SelfCrossing(kept[a].0, kept[b].0));
        }
        let area = signed_area(&corners);
        if area.abs() < MINIMUM_AREA {
            return Err(PolygonFault::NoArea(area.abs()));
        }
        if area < 0.0 {
            corners.reverse();
        }
        Ok(Self::of(corners))
    }

    /// An axis-parallel rectangle; `size` in metres, both above zero.
    #[must_use]
    pub fn rectangle(origin: Point, size: Point) -> Self {
        assert!(size.x > 0.0 && size.y > 0.0, "a rectangle has a positive size");
        Self::of(Bounds::new(origin, origin + size).corners().into())
    }

    fn of(corners: Vec<Point>) -> Self {
        Self { corners, rows: Rows::default() }
    }

    /// The corners, counter-clockwise.
    #[must_use]
    pub fn corners(&self) -> &[Point] {
        &self.corners
    }

    /// The edges, edge `i` from corner `i` to corner `i + 1`; the inside is on the left.
    pub fn edges(&self) -> impl ExactSizeIterator<Item = Segment> + '_ {
        let count = self.corners.len();
        (0..count).map(move |i| Segment::new(self.corners[i], self.corners[(i + 1) % count]))
    }

    /// Area in square metres, above zero.
    #[must_use]
    pub fn area(&self) -> f64 {
        signed_area(&self.corners)
    }

    /// Whether the point lies inside; points on the border may answer either way.
    #[must_use]
    pub fn contains(&self, point: Point) -> bool {
        match self.corners.len() {
            0..MANY => ring_contains(&self.corners, point),
            _ => self.rows.contain(&self.corners, point),
        }
    }

    /// The axis-parallel box around it.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        Bounds::around(self.corners.iter().copied())
    }
}

/// A polygon with holes: the floor of a room. Holes are counter-clockwise too, lie inside the outline
/// and do not touch each other.
#[derive(Clone, Debug, PartialEq)]
pub struct Region {
    /// The outer border.
    pub outline: Polygon,
    /// The holes (a shaft, a light well).
    pub holes: Vec<Polygon>,
}

impl Region {
    /// A region without holes.
    #[must_use]
    pub fn simple(outline: Polygon) -> Self {
        Self { outline, holes: Vec::new() }
    }

    /// Area in square metres without the holes.
    #[must_use]
    pub fn area(&self) -> f64 {
        self.outline.area() - self.holes.iter().map(Polygon::area).sum::<f64>()
    }

    /// Whether the point lies inside the outline and outside all holes.
    #[must_use]
    pub fn contains(&self, point: Point) -> bool {
        self.outline.contains(point) && !self.holes.iter().any(|hole| hole.contains(point))
    }

    /// All borders with the free side on the left: the outline's edges in order, then each hole's edges
    /// reversed. This order numbers the walls of a room.
    pub fn borders(&self) -> impl Iterator<Item = Segment> + '_ {
        let holes = self.holes.iter().flat_map(Polygon::edges);
        self.outline.edges().chain(holes.map(Segment::reversed))
    }
}

/// Whether a point lies inside a simple ring of corners; points on the border may answer either way.
#[must_use]
pub fn ring_contains(corners: &[Point], point: Point) -> bool {
    edges(corners).filter(|edge| edge.is_east_of(point)).count() % 2 == 1
}

/// Square metres of a simple ring of corners: below zero if it is clockwise, zero without corners.
#[must_use]
pub fn signed_area(corners: &[Point]) -> f64 {
    let count = corners.len();
    if count == 0 {
        return 0.0;
    }
    // Relative to the first corner: far from the origin the plain sum loses digits.
    let base = corners[0];
    (0..count).map(|i| (corners[i] - base).perp_dot(corners[(i + 1) % count] - base)).sum::<f64>() / 2.0
}

/// The first pair of edges that share a point other than the corner between neighbours.
fn first_crossing(corners: &[Point]) -> Option<(usize, usize)> {
    let count = corners.len();
    let edge = |i: usize| Segment::new(corners[i], corners[(i + 1) % count]);
    for i in 0..count {
        let (this, next) = (edge(i).vector(), edge((i + 1) % count).vector());
        let folds_back = this.perp_dot(next).abs() <= 1e-12 && this.dot(next) < 0.0;
        if folds_back {
            return Some((i, (i + 1) % count));
        }
        for j in i + 2..count {
            let neighbours = i == 0 && j == count - 1;
            if !neighbours && segments_touch(edge(i), edge(j)) {
                return Some((i, j));
            }
        }
    }
    None
}

fn segments_touch(one: Segment, other: Segment) -> bool {
    let sides = |of: Segment, other: Segment| (of.side(other.start), of.side(other.end));
    let (start_side, end_side) = sides(one, other);
    let (other_start_side, other_end_side) = sides(other, one);
    if start_side * end_side < 0.0 && other_start_side * other_end_side < 0.0 {
        return true;
    }
    let is_on = |segment: Segment, side: f64, point: Point| side == 0.0 && segment.bounds().contains(point);
    is_on(one, start_side, other.start)
        || is_on(one, end_side, other.end)
        || is_on(other, other_start_side, one.start)
        || is_on(other, other_end_side, one.end)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(list: &[(f64, f64)]) -> Vec<Point> {
        list.iter().map(|&(x, y)| Point::new(x, y)).collect()
    }

    #[test]
    fn clockwise_closed_ring_becomes_counter_clockwise_and_open() {
        let ring = points(&[(0.0, 0.0), (0.0, 2.0), (3.0, 2.0), (3.0, 0.0), (0.0, 0.0)]);
        let polygon = Polygon::new(&ring).unwrap();
        assert_eq!(polygon.corners().len(), 4);
        assert!((polygon.area() - 6.0).abs() < 1e-12);
    }

    #[test]
    fn a_bow_tie_names_the_crossing_edges() {
        let bow_tie = points(&[(0.0, 0.0), (2.0, 2.0), (2.0, 0.0), (0.0, 2.0)]);
        assert_eq!(Polygon::new(&bow_tie), Err(PolygonFault::SelfCrossing(0, 2)));
    }

    #[test]
    fn a_spike_is_a_crossing() {
        let spike = points(&[(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (2.0, 1.0), (0.0, 1.0)]);
        assert!(matches!(Polygon::new(&spike), Err(PolygonFault::SelfCrossing(..))));
    }

    #[test]
    fn not_a_number_is_named_by_its_index() {
        let broken = points(&[(0.0, 0.0), (f64::NAN, 0.0), (1.0, 1.0)]);
        assert_eq!(Polygon::new(&broken), Err(PolygonFault::NotFinite(1)));
    }

    #[test]
    fn a_hole_is_not_contained() {
        let region = Region {
            outline: Polygon::rectangle(Point::ZERO, Point::splat(4.0)),
            holes: vec![Polygon::rectangle(Point::splat(1.0), Point::splat(1.0))],
        };
        assert!(region.contains(Point::splat(0.5)));
        assert!(!region.contains(Point::splat(1.5)));
        assert!((region.area() - 15.0).abs() < 1e-12);
        assert_eq!(region.borders().count(), 8);
    }
}
