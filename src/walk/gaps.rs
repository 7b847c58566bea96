//! Gaps between obstacles in millimetres, where cells round: a gap of 0.38 m may look as wide to them as one of 0.45.
//!
//! Whoever stands between two obstacles has no more room than the sum of the distances to them. Distances of cells that say
//! more are lowered to that. Gaps that are much too narrow are closed on the cells as well, and need no second look.

use crate::geometry::{Bounds, Convex, Point, Segment, Solid, edges};
use crate::plan::{Room, RoomOpening};

use super::raster::Raster;

/// Metres that cells may add to a gap at most: half of a cell at each end, across the cells, and their slack. More takes
/// longer and finds no other gap.
const ROUNDED: f64 = 0.12;

/// Metres between obstacles that count as touching.
const CLOSE: f64 = 1e-3;

/// Cosine of the angle between the ways to two obstacles from which on somebody stands between them and not beside both.
/// Nearer to -1 leaves cells at the ends of a gap as they are; from 0 on, corners of rooms would be gaps.
const BETWEEN: f64 = -0.5;

/// Something that people walk around: a convex shape, or a stretch of wall, which is one without depth.
#[derive(Clone, Copy, Debug)]
pub(super) struct Obstacle {
    shape: Convex,
    bounds: Bounds,
    /// The bounds say all about the shape, as they do about most furniture and walls.
    fills_its_bounds: bool,
}

impl Obstacle {
    pub(super) fn of(solid: &Solid) -> Self {
        let (shape, bounds) = (solid.base, solid.bounds);
        Self { shape, bounds, fills_its_bounds: shape.fills_its_bounds() }
    }

    fn stretch(segment: Segment) -> Self {
        let (bounds, shape) =
            (segment.bounds(), Convex::from_corners(&[segment.start, segment.end, segment.start]));
        Self { shape, bounds, fills_its_bounds: bounds.size().min_element() == 0.0 }
    }

    fn edges(&self) -> impl Iterator<Item = Segment> + '_ {
        edges(self.shape.corners())
    }

    /// Metres that it is away at least from the middle of a disc which has room on the cells: cells whose middles lie in it are blocked, and
    /// of a rectangle that is two cells deep there is one near each point of its sides. Of what is thinner nothing is known.
    fn least_distance_of_disc(&self, width: f64, cell: f64) -> f64 {
        let is_on_cells = self.fills_its_bounds && self.bounds.size().min_element() >= 2.0 * cell;
        // From its side to the middle of a blocked cell, across both, and what cells may round a disc.
        if is_on_cells { (width / 2.0 - 2.0 * cell).max(0.0) } else { 0.0 }
    }

    /// Its point nearest to one outside it.
    fn nearest(&self, point: Point) -> Point {
        if self.fills_its_bounds {
            return point.clamp(self.bounds.low, self.bounds.high);
        }
        let nearer =
            |a: Point, b: Point| if point.distance_squared(b) < point.distance_squared(a) { b } else { a };
        self.edges().map(|edge| edge.nearest(point)).reduce(nearer).expect("an obstacle has edges")
    }

    /// Metres to another, if they are less than `most`; zero or `None` where they touch.
    fn gap_to(&self, other: &Self, most: f64) -> Option<f64> {
        let apart = self.bounds.gap(other.bounds);
        // Nearly all pairs end in the first three ways: they are far from each other, stand along the axes or touch.
        let gap = if apart >= most || (self.fills_its_bounds && other.fills_its_bounds) {
            apart
        } else if !self.shape.overlaps(&other.shape, -most) || self.shape.overlaps(&other.shape, -CLOSE) {
            return None;
        } else {
            self.nearest_corner(other).min(other.nearest_corner(self)).sqrt()
        };
        (gap < most).then_some(gap)
    }

    /// Square metres of the square over the distance from its nearest corner to another's sides. `distance_of_convex` takes corners
    /// inside for near, and all that lies on the line of a stretch of wall, which has no inside, would be.
    fn nearest_corner(&self, other: &Self) -> f64 {
        let corners = self.shape.corners().iter();
        let squares =
            corners.flat_map(|&corner| other.edges().map(move |edge| edge.distance_squared(corner)));
        squares.fold(f64::INFINITY, f64::min)
    }
}

/// The solid stretches of a room's walls, and its columns' sides.
pub(super) fn fixed_obstacles(room: &Room, is_walkable: impl Fn(&RoomOpening) -> bool) -> Vec<Obstacle> {
    let mut found = Vec::new();
    for (number, border) in room.region.borders().enumerate() {
        let is_here = |place: &&RoomOpening| place.wall == number && is_walkable(place);
        let holes = room.openings.iter().filter(is_here).map(|place| (place.from, place.to));
        let mut holes: Vec<(f64, f64)> = holes.collect();
        holes.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (length, along) = (border.length(), border.direction());
        let mut from = 0.0;
        for (start, end) in holes.into_iter().chain([(length, length)]) {
            if start - from > CLOSE {
                let [from, to] = [from, start].map(|metres| border.start + along * metres);
                found.push(Obstacle::stretch(Segment::new(from, to)));
            }
            from = end.max(from);
        }
    }
    let columns = room.obstacles.iter().flat_map(|column| column.outline.edges());
    found.extend(columns.map(Obstacle::stretch));
    found
}

/// Cells with their distances, as [`Raster::distances`] gives them.
pub(super) struct Cells<'c> {
    pub(super) raster: &'c Raster,
    pub(super) distances: &'c mut [u16],
    /// The diameters of the discs that walk, in metres.
    pub(super) widths: [f64; 2],
}

impl Cells<'_> {
    /// Lowers the distances that lie in gaps of some obstacles to each other and to others.
    pub(super) fn lower_in_gaps(&mut self, obstacles: &[Obstacle], others: &[&[Obstacle]]) {
        let mut from_the_west: Vec<&Obstacle> = obstacles.iter().collect();
        from_the_west.sort_by(|a, b| a.bounds.low.x.total_cmp(&b.bounds.low.x));
        let widest = self.widest();
        for (number, one) in from_the_west.iter().enumerate() {
            // So that halls with thousands of seats compare each with few.
            let is_near = |other: &&&Obstacle| other.bounds.low.x < one.bounds.high.x + widest;
            let east = from_the_west[number + 1..].iter().take_while(is_near).copied();
            let around = one.bounds.inflated(widest);
            // Nearly all are too far away, which their bounds say at once.
            let all = others.iter().copied().flatten().chain(east);
            for other in all.filter(|other| other.bounds.touches(around)) {
                self.lower_in_gap([one, other]);
            }
        }
    }

    fn widest(&self) -> f64 {
        self.widths[0].max(self.widths[1])
    }

    /// Lowers the distances in the gap of two obstacles, for each width that is wider.
    fn lower_in_gap(&mut self, [one, other]: [&Obstacle; 2]) {
        let Some(gap) = one.gap_to(other, self.widest()) else { return };
        for width in self.widths.into_iter().filter(|width| gap > width - ROUNDED && gap < *width) {
            self.lower_between([one, other], gap, width);
        }
    }

    /// Lowers the distances of those cells in a gap whose discs of a width do not fit between.
    fn lower_between(&mut self, [one, other]: [&Obstacle; 2], gap: f64, width: f64) {
        debug_assert!(gap < width);
        let Self { raster, distances, .. } = self;
        // Who has room for the disc is far from one of them, and so much nearer to the other.
        let near = |obstacle: &Obstacle| width - obstacle.least_distance_of_disc(width, raster.cell());
        let (a, b) = (one.bounds.inflated(near(other)), other.bounds.inflated(near(one)));
        let both = Bounds::new(a.low.max(b.low), a.high.min(b.high));
        let least = raster.least_distance(width);
        raster.cells_in(both, |cell| {
            // Nearly all cells of a gap are too near to one side for that disc anyway.
            if distances[cell] < least {
                return;
            }
            let middle = raster.middle(cell);
            let to_one = one.nearest(middle) - middle;
            let near = to_one.length();
            if near >= width {
                return;
            }
            let to_other = other.nearest(middle) - middle;
            let far = to_other.length();
            if near + far < width && to_one.dot(to_other) < BETWEEN * near * far {
                distances[cell] = distances[cell].min(raster.least_distance(near + far));
            }
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Polygon;
    use crate::walk::raster::CELL;

    const PERSON: f64 = 0.45;

    /// Whether a person gets from one end of a room to the other, through a gap of some metres between two boxes that are
    /// turned and shifted against the cells; with and without a second look.
    fn passes(gap: f64, turn: f64, shift: f64) -> [bool; 2] {
        let along = crate::geometry::direction(turn);
        let middle = Point::new(2.0, 2.0) + Point::splat(shift * CELL);
        let beside = |side: f64| {
            let center = middle + along.perp() * side * (gap / 2.0 + 2.0);
            Solid::new(Convex::rectangle(center, Point::new(0.3, 2.0), along), 0.0, 1.0)
        };
        let solids = [beside(1.0), beside(-1.0)];
        let mut raster = Raster::new(Bounds::new(Point::ZERO, Point::splat(4.0)), CELL);
        raster.paint(&Polygon::rectangle(Point::ZERO, Point::splat(4.0)).edges().collect::<Vec<_>>(), true);
        for solid in &solids {
            raster.paint(&edges(solid.footprint()).collect::<Vec<_>>(), false);
        }
        let rough = raster.distances(raster.reach(PERSON));
        let mut exact = rough.clone();
        let mut cells = Cells { raster: &raster, distances: &mut exact, widths: [PERSON, 0.3] };
        cells.lower_in_gaps(&solids.each_ref().map(Obstacle::of), &[]);
        let least = raster.least_distance(PERSON);
        let is_way = |distances: &[u16]| {
            let mut is_seen = vec![false; raster.len()];
            let is_end = |cell: usize, side: f64| (raster.middle(cell) - middle).dot(along) * side > 0.6;
            let mut left: Vec<usize> =
                (0..raster.len()).filter(|&cell| distances[cell] >= least && is_end(cell, -1.0)).collect();
            while let Some(cell) = left.pop() {
                if std::mem::replace(&mut is_seen[cell], true) {
                    continue;
                }
                let columns = raster.columns();
                let rows = [cell - columns, cell, cell + columns];
                let around = rows.into_iter().flat_map(|cell| [cell - 1, cell, cell + 1]);
                left.extend(around.filter(|&cell| distances[cell] >= least && !is_seen[cell]));
            }
            (0..raster.len()).any(|cell| is_seen[cell] && is_end(cell, 1.0))
        };
        [is_way(&rough), is_way(&exact)]
    }

    #[test]
    fn nobody_passes_a_gap_a_centimetre_too_narrow_and_wider_ones_are_left_to_the_cells() {
        let (mut rounded, mut passed) = (0, 0);
        for step in 0..60 {
            let (turn, shift) = (f64::from(step) * 0.1, f64::from(step % 7) / 7.0);
            let [rough, exact] = passes(PERSON + 0.005, turn, shift);
            assert_eq!(rough, exact, "turned by {turn}");
            passed += usize::from(exact);
            let [rough, exact] = passes(PERSON - 0.01, turn, shift);
            assert!(!exact, "turned by {turn}");
            rounded += usize::from(rough);
        }
        assert!(passed > 40, "{passed} of 60 pass a gap that is wide enough");
        assert!(rounded > 10, "cells alone let somebody through {rounded} times of 60");
    }

    /// The cells between two boxes that stand along the axes, looked at one by one as [`Cells::lower_between`] looks at some of them.
    fn lowered_one_by_one(raster: &Raster, rough: &[u16], [one, other]: [&Obstacle; 2]) -> Vec<u16> {
        let least = raster.least_distance(PERSON);
        let lowered = |(cell, &distance): (usize, &u16)| {
            let middle = raster.middle(cell);
            let [to_one, to_other] = [one, other].map(|obstacle| obstacle.nearest(middle) - middle);
            let across = to_one.length() + to_other.length();
            let is_between = to_one.dot(to_other) < BETWEEN * to_one.length() * to_other.length();
            let is_lowered = distance >= least && across < PERSON && is_between;
            if is_lowered { distance.min(raster.least_distance(across)) } else { distance }
        };
        rough.iter().enumerate().map(lowered).collect()
    }

    #[test]
    fn no_cell_of_a_gap_is_left_out() {
        let mut lowered = 0;
        for step in 0..400_u32 {
            let of = |factor: u32, most: f64| f64::from(step * factor % 401) / 400.0 * most;
            let gap = PERSON - 0.11 + of(7, 0.109);
            // Thick and thin ones, and past each other's ends.
            let (low, depth, aside) =
                (Point::new(1.0 + of(3, 0.05), 1.0 + of(5, 0.05)), 0.02 + of(11, 0.5), of(13, 0.6));
            let boxes = [
                Bounds::new(low, low + Point::new(depth, 0.6)),
                Bounds::new(
                    low + Point::new(depth + gap, aside),
                    low + Point::new(depth + gap + 0.4, aside + 0.5),
                ),
            ];
            let solids = boxes
                .map(|one| Solid::new(Convex::rectangle(one.center(), one.size() / 2.0, Point::X), 0.0, 1.0));
            let mut raster = Raster::new(Bounds::new(Point::ZERO, Point::splat(3.5)), CELL);
            raster
                .paint(&Polygon::rectangle(Point::ZERO, Point::splat(3.5)).edges().collect::<Vec<_>>(), true);
            for solid in &solids {
                raster.paint(&edges(solid.footprint()).collect::<Vec<_>>(), false);
            }
            let rough = raster.distances(raster.reach(PERSON));
            let obstacles = solids.each_ref().map(Obstacle::of);
            let mut exact = rough.clone();
            let mut cells = Cells { raster: &raster, distances: &mut exact, widths: [PERSON, PERSON] };
            cells.lower_in_gaps(&obstacles, &[]);
            if obstacles[0].gap_to(&obstacles[1], PERSON).is_some_and(|gap| gap > PERSON - ROUNDED) {
                let expected = lowered_one_by_one(&raster, &rough, obstacles.each_ref());
                assert_eq!(exact, expected, "{boxes:?}");
                lowered += rough.iter().zip(&exact).filter(|(a, b)| a != b).count();
            }
        }
        assert!(lowered > 400, "{lowered}");
    }
}
