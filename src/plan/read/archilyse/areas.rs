//! The areas of a floor: well-known text in metres, in the drawing's frame.

use std::str::FromStr;

use schemars::JsonSchema;
use serde::Deserialize;
use wkt::Wkt;
use wkt::types::{LineString, Polygon};

use crate::geometry::Point;

/// An area as it stands in the file; keys that the plan does not need are not listed.
#[derive(Debug, Deserialize, JsonSchema)]
pub(crate) struct Area {
    pub(crate) id: i64,
    pub(crate) area_type: String,
    /// The floor's drawing, in files that hold several.
    pub(crate) plan_id: Option<i64>,
    /// Well-known text.
    pub(crate) scaled_polygon: String,
}

/// An outline and its holes as found.
#[derive(Clone, Debug, Default)]
pub(crate) struct Outline {
    pub(crate) outer: Vec<Point>,
    pub(crate) holes: Vec<Vec<Point>>,
}

impl Area {
    /// The outlines of the area: one, or several where it has parts.
    ///
    /// # Errors
    /// The kind of shape that the text describes instead.
    pub(crate) fn outlines(&self) -> Result<Vec<Outline>, String> {
        outlines(&self.scaled_polygon)
    }
}

/// The outlines that a well-known text describes: one, or several where it has parts.
///
/// # Errors
/// The kind of shape that the text describes instead.
pub(crate) fn outlines(text: &str) -> Result<Vec<Outline>, String> {
    let text = text.trim();
    let word: String = text.chars().take_while(char::is_ascii_alphabetic).collect();
    // Collections nest without bound; nothing but polygons makes a room.
    if !["POLYGON", "MULTIPOLYGON"].iter().any(|known| word.eq_ignore_ascii_case(known)) {
        return Err(format!("\"{}\" is no polygon", text.chars().take(20).collect::<String>()));
    }
    match Wkt::<f64>::from_str(text) {
        Ok(Wkt::Polygon(polygon)) => Ok(vec![outline(&polygon)]),
        Ok(Wkt::MultiPolygon(parts)) => Ok(parts.polygons().iter().map(outline).collect()),
        Ok(_) => Err("is no polygon".to_owned()),
        Err(error) => Err(format!("broken well-known text: {error}")),
    }
}

fn outline(polygon: &Polygon<f64>) -> Outline {
    let mut rings = polygon.rings().iter().map(ring);
    Outline { outer: rings.next().unwrap_or_default(), holes: rings.collect() }
}

fn ring(line: &LineString<f64>) -> Vec<Point> {
    line.coords().iter().map(|coord| Point::new(coord.x, coord.y)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(text: &str) -> Area {
        Area { id: 1, area_type: "ROOM".to_owned(), plan_id: None, scaled_polygon: text.to_owned() }
    }

    #[test]
    fn polygons_with_holes_and_parts() {
        let one = area("POLYGON ((0 0, 4 0, 4 4, 0 0), (1 1, 2 1, 2 2, 1 1))").outlines().unwrap();
        assert_eq!((one.len(), one[0].outer.len(), one[0].holes.len()), (1, 4, 1));
        let two = area("MULTIPOLYGON (((0 0, 1 0, 1 1, 0 0)), ((5 5, 6 5, 6 6, 5 5)))").outlines().unwrap();
        assert_eq!(two[1].outer[1], Point::new(6.0, 5.0));
    }

    #[test]
    fn other_geometries_are_named() {
        assert_eq!(area("POINT (1 2)").outlines().unwrap_err(), "\"POINT (1 2)\" is no polygon");
        assert!(area("POLYGON ((0 0, 4").outlines().unwrap_err().starts_with("broken well-known text"));
        let nested = "GEOMETRYCOLLECTION (".repeat(100_000);
        assert!(area(&nested).outlines().is_err());
        assert!(area("").outlines().is_err());
    }
}
