//! The frame of a building: turned so that most of its walls run east and north.

use crate::geometry::{Point, Polygon, Region, direction};

use super::ring::{Ring, on_grid};

/// Walls within this angle in radians of the heaviest one count for it: 3 degrees.
const SAME_DIRECTION: f64 = 0.0524;
/// Edges that are weighed, the longest first: more are a curve.
const EDGES_WEIGHED: usize = 64;

/// Where a building stands, and how it is turned: plan frame → site by turning, then moving.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Frame {
    /// Metres on the site's plane of the plan's origin.
    pub(super) origin: Point,
    /// Radians counter-clockwise from the site's east to the plan's.
    pub(super) turn: f64,
    east: Point,
}

impl Frame {
    /// The frame of an outline: x along the direction that most metres of its walls have, or across it where the building is
    /// longer that way.
    pub(super) fn of(region: &Region) -> Self {
        let turn = heaviest_direction(&region.outline);
        let origin = region.outline.bounds().center().round();
        let frame = Self { origin, turn, east: direction(turn) };
        let size = super::ring::bounds(&frame.ring(region.outline.corners())).size();
        if size.x >= size.y {
            return frame;
        }
        // A quarter more, within the half circle: a building that is drawn upside down is the same building.
        let turn =
            if turn > 0.0 { turn - std::f64::consts::FRAC_PI_2 } else { turn + std::f64::consts::FRAC_PI_2 };
        Self { origin, turn, east: direction(turn) }
    }

    /// A point of the site in the frame.
    pub(super) fn point(&self, point: Point) -> Point {
        let offset = point - self.origin;
        on_grid(Point::new(offset.dot(self.east), offset.dot(self.east.perp())))
    }

    /// Corners of the site in the frame.
    pub(super) fn ring(&self, corners: &[Point]) -> Ring {
        corners.iter().map(|&corner| self.point(corner)).collect()
    }
}

/// Radians in (-45°, 45°] of the direction that most metres of walls have, whichever way they run.
fn heaviest_direction(outline: &Polygon) -> f64 {
    let quarter = std::f64::consts::FRAC_PI_2;
    let folded = |angle: f64| angle - (angle / quarter).round() * quarter;
    let mut walls: Vec<(f64, f64)> = outline
        .edges()
        .map(|edge| (edge.length(), folded(libm::atan2(edge.vector().y, edge.vector().x))))
        .collect();
    walls.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.total_cmp(&b.1)));
    walls.truncate(EDGES_WEIGHED);
    let like = |angle: f64| {
        let near = walls.iter().map(move |&(length, other)| (length, folded(other - angle)));
        near.filter(|(_, difference)| difference.abs() <= SAME_DIRECTION)
    };
    let weight = |angle: f64| like(angle).map(|(length, _)| length).sum::<f64>();
    let Some((best, total)) = walls
        .iter()
        .map(|&(_, angle)| (angle, weight(angle)))
        .reduce(|best, next| if next.1 > best.1 + 1e-6 { next } else { best })
    else {
        return 0.0;
    };
    best + like(best).map(|(length, difference)| length * difference).sum::<f64>() / total
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_turned_house_stands_straight_in_its_frame() {
        let corners = [(0.0, 0.0), (12.0, 0.0), (12.0, 8.0), (0.0, 8.0)].map(Point::from);
        let turned =
            |angle: f64| corners.map(|corner| direction(angle).rotate(corner) + Point::new(500.0, 70.0));
        for angle in [0.0, 0.3, 0.8, 1.5, 2.9, -1.2] {
            let region = Region::simple(Polygon::new(&turned(angle)).unwrap());
            let frame = Frame::of(&region);
            let size = super::super::ring::bounds(&frame.ring(region.outline.corners())).size();
            assert!((size - Point::new(12.0, 8.0)).length() < 0.01, "{angle}: {size}");
        }
    }
}
