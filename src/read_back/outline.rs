//! Makes polygons of corners.

use crate::contract::Corner;
use crate::geometry::{Point, Polygon};
use crate::plan::limits::{COORDINATE, OUTLINE_CORNERS, room_excess};

/// A point.
pub(super) fn point([x, y]: Corner) -> Point {
    Point::new(x, y)
}

/// A polygon with exactly these corners.
///
/// # Errors
/// Says what is wrong with them.
pub(super) fn polygon(corners: &[Corner]) -> Result<Polygon, String> {
    if corners.len() > OUTLINE_CORNERS {
        return Err(format!("has {} corners, {OUTLINE_CORNERS} are the most that is read", corners.len()));
    }
    let points: Vec<Point> = corners.iter().map(|&corner| point(corner)).collect();
    if points.iter().any(|point| point.abs().max_element() > COORDINATE) {
        return Err(format!("has a corner beyond {COORDINATE} m"));
    }
    let polygon = Polygon::new(&points).map_err(|fault| fault.to_string())?;
    if polygon.corners() != points {
        return Err("has corners that coincide or run clockwise: its walls cannot be told apart".to_owned());
    }
    match room_excess(&polygon) {
        Some(excess) => Err(format!("{}: {}", excess.fact, excess.allowed)),
        None => Ok(polygon),
    }
}
