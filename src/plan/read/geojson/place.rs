//! Converts degrees to metres in the plane of a building.

use super::feature::{Geometry, Position};
use crate::geometry::{Bounds, Point};
use crate::plan::limits::median;
use crate::plan::read::rings::Rings;
use crate::plan::units::LocalPlane;

/// Degrees beyond which no building reaches: some 50 km, less towards the poles.
const WIDEST_BUILDING: f64 = 0.5;

/// The outlines of an area: one, or several where it has parts; none for what is no area.
pub(in crate::plan::read) fn outlines(geometry: &Geometry, plane: &LocalPlane) -> Vec<Rings> {
    let outline = |rings: &Vec<Vec<Position>>| {
        let mut rings = rings.iter().map(|ring| points(ring, plane));
        Rings { outer: rings.next().unwrap_or_default(), holes: rings.collect() }
    };
    match geometry {
        Geometry::Polygon { coordinates } => vec![outline(coordinates)],
        Geometry::MultiPolygon { coordinates } => coordinates.iter().map(outline).collect(),
        Geometry::Point { .. } | Geometry::LineString { .. } | Geometry::Other => Vec::new(),
    }
}

/// A line's points on the plane.
pub(crate) fn points(line: &[Position], plane: &LocalPlane) -> Vec<Point> {
    line.iter().map(|position| point(position, plane)).collect()
}

/// A place without two numbers is nowhere; cleaning reports it as not finite.
fn point(position: &[f64], plane: &LocalPlane) -> Point {
    match position {
        [longitude, latitude, ..] => plane.project(*longitude, *latitude),
        _ => Point::NAN,
    }
}

/// The plane at the middle of some areas, as [`plane_around`].
pub(crate) fn plane_of<'a>(geometries: impl Iterator<Item = &'a Geometry>) -> Option<LocalPlane> {
    plane_around(&geometries.flat_map(corners_of).collect::<Vec<_>>())
}

/// The plane at the middle of the bounding box of corners in degrees, or at the middle of most of them where one lies far off.
/// `None` if there are none, or no degrees.
pub(crate) fn plane_around(corners: &[Point]) -> Option<LocalPlane> {
    let bounds = Bounds::around(corners.iter().copied());
    let middle = if bounds.size().max_element() > WIDEST_BUILDING {
        Point::new(median(corners.iter().map(|at| at.x)), median(corners.iter().map(|at| at.y)))
    } else {
        bounds.center()
    };
    LocalPlane::at(middle.x, middle.y)
}

/// The corners of an area, in the units of its file.
pub(crate) fn corners_of(geometry: &Geometry) -> Vec<Point> {
    let rings: Vec<&Vec<Position>> = match geometry {
        Geometry::Polygon { coordinates } => coordinates.iter().collect(),
        Geometry::MultiPolygon { coordinates } => coordinates.iter().flatten().collect(),
        Geometry::Point { .. } | Geometry::LineString { .. } | Geometry::Other => Vec::new(),
    };
    let point = |position: &Position| match position[..] {
        [longitude, latitude, ..] => Some(Point::new(longitude, latitude)),
        _ => None,
    };
    rings.into_iter().flatten().filter_map(point).collect()
}
