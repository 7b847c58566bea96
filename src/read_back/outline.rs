//! Corners to polygons.

use super::extras::Corner;
use crate::geometry::{Point, Polygon};

/// Metres of the farthest coordinate.
const FARTHEST: f64 = 1e6;
/// Corners of the largest outline: what asks every pair of edges takes its time.
const MOST_CORNERS: usize = 4096;
/// Square metres of the largest box around a room: what walks are looked for in has 400 cells on each.
const LARGEST_BOX: f64 = 250_000.0;

/// A point.
pub(super) fn point([x, y]: Corner) -> Point {
    Point::new(x, y)
}

/// A polygon with exactly these corners.
///
/// # Errors
/// Says what is wrong with them.
pub(super) fn polygon(corners: &[Corner]) -> Result<Polygon, String> {
    if corners.len() > MOST_CORNERS {
        return Err(format!("has {} corners, {MOST_CORNERS} are the most that is read", corners.len()));
    }
    let points: Vec<Point> = corners.iter().map(|&corner| point(corner)).collect();
    if points.iter().any(|point| point.abs().max_element() > FARTHEST) {
        return Err(format!("has a corner beyond {FARTHEST} m"));
    }
    let polygon = Polygon::new(&points).map_err(|fault| fault.to_string())?;
    if polygon.corners() != points {
        return Err("has corners that coincide or run clockwise: its walls cannot be told apart".to_owned());
    }
    let (low, high) = polygon.bounds();
    if (high - low).element_product() > LARGEST_BOX {
        return Err(format!("is larger than {LARGEST_BOX} m²"));
    }
    Ok(polygon)
}
