//! Geometries as they come in JSON: GeoJSON objects, well-known text, and lists of both.

use serde_json::Value;

use super::notes::{Notes, Place, below};
use crate::geometry::Point;
use crate::plan::read::archilyse::areas::{Outline, outlines};

/// Outlines of a class with their places.
pub(super) type Shapes = Vec<(Place, Outline)>;

const HINT: &str = "a Polygon or MultiPolygon is needed, as GeoJSON or well-known text; it is left out";
/// Lists in lists: instances, and their geometries.
const DEEPEST: usize = 3;

/// The outlines of a value; `None` if it is nothing that may be a geometry, such as a number or a graph.
pub(super) fn shapes(value: &Value, place: &Place, notes: &mut Notes) -> Option<Shapes> {
    shapes_within(value, place, DEEPEST, notes)
}

fn shapes_within(value: &Value, place: &Place, depth: usize, notes: &mut Notes) -> Option<Shapes> {
    match value {
        Value::Array(values) if depth > 0 => {
            let parts = values
                .iter()
                .enumerate()
                .filter_map(|(number, value)| shapes_within(value, &below(place, number), depth - 1, notes));
            let parts: Vec<Shapes> = parts.collect();
            (!parts.is_empty()).then(|| parts.into_iter().flatten().collect())
        }
        Value::Object(keys) => match (keys.get("geom"), keys.get("type"), keys.get("coordinates")) {
            (Some(geometry), ..) => {
                shapes_within(geometry, &below(place, "geom"), depth.checked_sub(1)?, notes)
            }
            (None, Some(Value::String(kind)), Some(coordinates)) => {
                of_geojson(kind, coordinates, place, notes)
            }
            (None, Some(Value::String(kind)), None) if kind == "GeometryCollection" => {
                let parts = keys.get("geometries")?;
                shapes_within(parts, &below(place, "geometries"), depth.checked_sub(1)?, notes)
            }
            _ => None,
        },
        Value::String(text)
            if text.trim_start().get(..7).is_some_and(|word| word.eq_ignore_ascii_case("POLYGON"))
                || text
                    .trim_start()
                    .get(..12)
                    .is_some_and(|word| word.eq_ignore_ascii_case("MULTIPOLYGON")) =>
        {
            Some(match outlines(text) {
                Ok(found) => sound(found, place, notes),
                Err(message) => {
                    notes.error(place, message, HINT);
                    Vec::new()
                }
            })
        }
        _ => None,
    }
}

fn of_geojson(kind: &str, coordinates: &Value, place: &Place, notes: &mut Notes) -> Option<Shapes> {
    let found = match kind {
        "Polygon" => polygon(coordinates).map(|outline| vec![outline]),
        "MultiPolygon" => coordinates.as_array().and_then(|parts| parts.iter().map(polygon).collect()),
        // Lines and points have no area; the data set has some where polygons shrank away.
        _ => return Some(Vec::new()),
    };
    let Some(found) = found else {
        notes.error(&below(place, "coordinates"), format!("are no coordinates of a {kind}"), HINT);
        return Some(Vec::new());
    };
    Some(sound(found, place, notes))
}

/// The outline of the coordinates of a polygon; without corners if that has none.
fn polygon(rings: &Value) -> Option<Outline> {
    let rings: Vec<Vec<Point>> = rings.as_array()?.iter().map(ring).collect::<Option<_>>()?;
    let mut rings = rings.into_iter();
    Some(Outline { outer: rings.next().unwrap_or_default(), holes: rings.collect() })
}

fn ring(corners: &Value) -> Option<Vec<Point>> {
    let corner = |corner: &Value| Some(Point::new(corner.get(0)?.as_f64()?, corner.get(1)?.as_f64()?));
    corners.as_array()?.iter().map(corner).collect()
}

/// The outlines with corners, all of them numbers.
fn sound(found: Vec<Outline>, place: &Place, notes: &mut Notes) -> Shapes {
    let is_finite = |outline: &Outline| {
        outline.outer.iter().chain(outline.holes.iter().flatten()).all(|corner| corner.is_finite())
    };
    if !found.iter().all(is_finite) {
        notes.error(place, "has a coordinate that is no number", HINT);
        return Vec::new();
    }
    found
        .into_iter()
        .filter(|outline| outline.outer.len() >= 3)
        .map(|outline| (place.clone(), outline))
        .collect()
}
