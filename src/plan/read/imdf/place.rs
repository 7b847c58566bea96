//! Degrees to metres of a building's plane.

use super::features::{Geometry, Position};
use crate::geometry::Point;
use crate::plan::units::LocalPlane;

/// An outline and its holes.
pub(super) struct Outline {
    pub(super) outer: Vec<Point>,
    pub(super) holes: Vec<Vec<Point>>,
}

/// The outlines of an area: one, or several where it has parts; none for what is no area.
pub(super) fn outlines(geometry: &Geometry, plane: &LocalPlane) -> Vec<Outline> {
    let outline = |rings: &Vec<Vec<Position>>| {
        let mut rings = rings.iter().map(|ring| points(ring, plane));
        Outline { outer: rings.next().unwrap_or_default(), holes: rings.collect() }
    };
    match geometry {
        Geometry::Polygon { coordinates } => vec![outline(coordinates)],
        Geometry::MultiPolygon { coordinates } => coordinates.iter().map(outline).collect(),
        Geometry::LineString { .. } | Geometry::Other => Vec::new(),
    }
}

/// A line's points on the plane.
pub(super) fn points(line: &[Position], plane: &LocalPlane) -> Vec<Point> {
    line.iter().map(|position| point(position, plane)).collect()
}

/// A place without two numbers is nowhere; cleaning reports it as not finite.
fn point(position: &[f64], plane: &LocalPlane) -> Point {
    match position {
        [longitude, latitude, ..] => plane.project(*longitude, *latitude),
        _ => Point::NAN,
    }
}

/// The plane at the middle of the bounding box of some areas. `None` if there are none, or no degrees.
pub(super) fn plane_of<'a>(geometries: impl Iterator<Item = &'a Geometry>) -> Option<LocalPlane> {
    let mut low = Point::INFINITY;
    let mut high = Point::NEG_INFINITY;
    for geometry in geometries {
        let rings: Vec<&Vec<Position>> = match geometry {
            Geometry::Polygon { coordinates } => coordinates.iter().collect(),
            Geometry::MultiPolygon { coordinates } => coordinates.iter().flatten().collect(),
            Geometry::LineString { .. } | Geometry::Other => Vec::new(),
        };
        for position in rings.into_iter().flatten() {
            if let [longitude, latitude, ..] = position[..] {
                low = low.min(Point::new(longitude, latitude));
                high = high.max(Point::new(longitude, latitude));
            }
        }
    }
    let middle = (low + high) / 2.0;
    LocalPlane::at(middle.x, middle.y)
}
