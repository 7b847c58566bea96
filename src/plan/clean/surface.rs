//! Converts between the polygons of this project and those of the crate `geo`, which clips them.

use geo::{Area, BooleanOps, Coord, LineString};

use crate::geometry::{Point, Polygon, Region};
use crate::plan::limits::{COORDINATE, OUTLINE_CORNERS};

/// A polygon with holes for the `geo` crate.
pub(crate) fn to_surface(outline: &Polygon, holes: &[Polygon]) -> geo::Polygon<f64> {
    let line = |polygon: &Polygon| to_line(polygon.corners());
    geo::Polygon::new(line(outline), holes.iter().map(line).collect())
}

/// The area within a ring for the `geo` crate.
pub(crate) fn ring_surface(corners: &[Point]) -> geo::Polygon<f64> {
    geo::Polygon::new(to_line(corners), Vec::new())
}

/// A ring for the `geo` crate.
pub(in crate::plan) fn to_line(corners: &[Point]) -> LineString<f64> {
    LineString::from_iter(corners.iter().map(|corner| Coord { x: corner.x, y: corner.y }))
}

/// The points of a ring of the `geo` crate, with its closing point.
pub(crate) fn to_points(line: &LineString<f64>) -> Vec<Point> {
    line.0.iter().map(|coord| Point::new(coord.x, coord.y)).collect()
}

/// The outer border of a surface, if it is a valid [`Polygon`].
pub(in crate::plan) fn to_polygon(surface: &geo::Polygon<f64>) -> Option<Polygon> {
    Polygon::new(&to_points(surface.exterior())).ok()
}

/// A ring as a polygon, where it is one of usable size and place; for outlines that only help.
pub(in crate::plan) fn to_simple(points: &[Point]) -> Option<Polygon> {
    let is_usable =
        points.len() <= OUTLINE_CORNERS && points.iter().all(|point| point.abs().max_element() <= COORDINATE);
    if is_usable { Polygon::new(points).ok() } else { None }
}

/// Metres that a hole reaches beyond its corners: edges that lie on the border of what is cut are cut clean.
const CUT_MARGIN: f64 = 0.002;

/// What is left of a region around a hole, which may lie at its border or divide it.
pub(crate) fn region_without(region: &Region, hole: &Polygon) -> Vec<Region> {
    let middle = hole.bounds().center();
    let beyond = |&corner: &Point| corner + (corner - middle).normalize_or_zero() * CUT_MARGIN;
    let ring: Vec<Point> = hole.corners().iter().map(beyond).collect();
    let left = to_surface(&region.outline, &region.holes).difference(&ring_surface(&ring));
    let to_region = |surface: &geo::Polygon<f64>| {
        let holes = surface.interiors().iter().filter_map(|ring| Polygon::new(&to_points(ring)).ok());
        Some(Region { outline: to_polygon(surface)?, holes: holes.collect() })
    };
    left.0.iter().filter_map(to_region).collect()
}

/// The part with the largest area (the first of equals), and the square metres of all others together.
pub(in crate::plan) fn largest_part(parts: geo::MultiPolygon<f64>) -> Option<(geo::Polygon<f64>, f64)> {
    let total: f64 = parts.0.iter().map(Area::unsigned_area).sum();
    let largest = parts
        .0
        .into_iter()
        .reduce(|best, part| if part.unsigned_area() > best.unsigned_area() { part } else { best })?;
    let rest = total - largest.unsigned_area();
    Some((largest, rest))
}
