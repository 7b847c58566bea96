//! A feature, and its geometry as points, lines or areas.

use std::borrow::Cow;
use std::fmt;

use serde::de::{Deserialize, Deserializer, IgnoredAny, SeqAccess, Visitor};
use serde_json::value::RawValue;
use serde_json::{Map, Value};

use crate::geometry::Point;
use crate::plan::read::footprint::drawn::Rings;

/// Deepest nesting of collections of geometries.
const DEEPEST: usize = 8;

/// A feature; its geometry is read by its type.
#[derive(serde::Deserialize)]
pub(super) struct Feature<'a> {
    pub(super) id: Option<Value>,
    #[serde(borrow)]
    pub(super) geometry: Option<Geometry<'a>>,
    pub(super) properties: Option<Map<String, Value>>,
}

/// A geometry before its coordinates are read.
#[derive(serde::Deserialize)]
pub(super) struct Geometry<'a> {
    #[serde(borrow, rename = "type")]
    kind: Option<Cow<'a, str>>,
    #[serde(borrow)]
    coordinates: Option<&'a RawValue>,
    #[serde(borrow)]
    geometries: Option<Vec<Geometry<'a>>>,
}

/// The places of a feature.
#[derive(Debug, PartialEq)]
pub(super) enum Shape {
    Points(Vec<Point>),
    Lines(Vec<Vec<Point>>),
    Areas(Vec<Rings>),
    Nothing,
}

impl Geometry<'_> {
    /// The places.
    ///
    /// # Errors
    /// The reason in words: coordinates that are none, or a type that is none.
    pub(super) fn shape(&self) -> Result<Shape, String> {
        self.shape_within(DEEPEST)
    }

    fn shape_within(&self, depth: usize) -> Result<Shape, String> {
        let kind = self.kind.as_deref().unwrap_or_default();
        Ok(match kind {
            "Point" => Shape::Points(vec![self.read::<Position>()?.0]),
            "MultiPoint" => Shape::Points(points(self.read()?)),
            "LineString" => Shape::Lines(vec![points(self.read()?)]),
            "MultiLineString" => Shape::Lines(self.read::<Vec<_>>()?.into_iter().map(points).collect()),
            "Polygon" => Shape::Areas(rings(self.read()?).into_iter().collect()),
            "MultiPolygon" => Shape::Areas(self.read::<Vec<_>>()?.into_iter().filter_map(rings).collect()),
            "GeometryCollection" if depth > 0 => self.areas_of_collection(depth - 1)?,
            _ => return Err(format!("its geometry is of the type \"{kind}\"")),
        })
    }

    /// The areas of a collection of geometries: what is beside them says no more of a building.
    fn areas_of_collection(&self, depth: usize) -> Result<Shape, String> {
        let mut areas = Vec::new();
        for geometry in self.geometries.iter().flatten() {
            if let Shape::Areas(found) = geometry.shape_within(depth)? {
                areas.extend(found);
            }
        }
        Ok(if areas.is_empty() { Shape::Nothing } else { Shape::Areas(areas) })
    }

    fn read<'de, T: Deserialize<'de>>(&'de self) -> Result<T, String> {
        let text = self.coordinates.map(RawValue::get).unwrap_or("null");
        serde_json::from_str(text).map_err(|_| "its coordinates are not lists of numbers".to_owned())
    }
}

fn points(positions: Vec<Position>) -> Vec<Point> {
    positions.into_iter().map(|position| position.0).collect()
}

/// Outer ring and holes; `None` of no ring.
fn rings(lines: Vec<Vec<Position>>) -> Option<Rings> {
    let mut lines = lines.into_iter().map(points);
    Some(Rings { outer: lines.next()?, holes: lines.collect() })
}

/// A longitude and a latitude, or metres east and north; what follows, such as a height, is passed over.
struct Position(Point);

impl<'de> Deserialize<'de> for Position {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_seq(PositionVisitor)
    }
}

struct PositionVisitor;

impl<'de> Visitor<'de> for PositionVisitor {
    type Value = Position;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("two numbers")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Position, A::Error> {
        let mut next = |at: usize| {
            let number = items.next_element::<f64>()?;
            number.ok_or_else(|| serde::de::Error::invalid_length(at, &"two numbers"))
        };
        let place = Point::new(next(0)?, next(1)?);
        while items.next_element::<IgnoredAny>()?.is_some() {}
        Ok(Position(place))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shape(text: &str) -> Result<Shape, String> {
        serde_json::from_str::<Geometry<'_>>(text).unwrap().shape()
    }

    #[test]
    fn geometries_are_points_lines_or_areas() {
        let ring = "[[0,0],[1,0],[1,1.5,99],[0,0]]";
        let area = Rings {
            outer: [(0.0, 0.0), (1.0, 0.0), (1.0, 1.5), (0.0, 0.0)].map(Point::from).into(),
            holes: vec![],
        };
        let cases = [
            (
                r#"{"type": "Point", "coordinates": [1, 2]}"#.to_owned(),
                Shape::Points(vec![Point::new(1.0, 2.0)]),
            ),
            (format!(r#"{{"type": "Polygon", "coordinates": [{ring}]}}"#), Shape::Areas(vec![area.clone()])),
            (
                format!(r#"{{"type": "MultiPolygon", "coordinates": [[{ring}]]}}"#),
                Shape::Areas(vec![area.clone()]),
            ),
            (
                format!(
                    r#"{{"type": "GeometryCollection", "geometries": [{{"type": "Point", "coordinates": [0, 0]}}, {{"type": "Polygon", "coordinates": [{ring}]}}]}}"#
                ),
                Shape::Areas(vec![area]),
            ),
            (r#"{"type": "Polygon", "coordinates": []}"#.to_owned(), Shape::Areas(vec![])),
        ];
        for (text, expected) in cases {
            assert_eq!(shape(&text), Ok(expected), "{text}");
        }
    }

    #[test]
    fn coordinates_that_are_none_have_a_reason() {
        for coordinates in ["[[[0,0],[1,null]]]", "[[[0]]]", "[[[\"1\",2]]]", "null", "[[[1e999,0]]]", "7"] {
            let text = format!(r#"{{"type": "Polygon", "coordinates": {coordinates}}}"#);
            assert_eq!(
                shape(&text).unwrap_err(),
                "its coordinates are not lists of numbers",
                "{coordinates}"
            );
        }
        assert_eq!(shape(r#"{"type": "Circle"}"#).unwrap_err(), "its geometry is of the type \"Circle\"");
    }
}
