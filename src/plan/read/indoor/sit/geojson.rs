//! GeoJSON with the tags as properties: exports of Overpass, JOSM, osmtogeojson and osmium. Other exports have the tags in a table
//! `tags`, or those without a column of their own as a text (`other_tags`).

use std::collections::BTreeMap;
use std::path::Path;

use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::Value;

use super::mapped::{Mapped, Shape, Tags, is_wanted};
use crate::document::{Fault, FaultSeverity, Faults, PathStep, Source};
use crate::geometry::Point;
use crate::plan::read::footprint::hstore;
use crate::plan::read::geojson::{Geometry, Position, as_collection};
use crate::plan::read::rings::Rings;

#[derive(Debug, Deserialize, JsonSchema)]
struct Collection {
    features: Vec<Feature>,
}

/// A feature. Programs write the id as a text, as a number or among the properties.
#[derive(Debug, Deserialize, JsonSchema)]
struct Feature {
    id: Option<Value>,
    geometry: Option<Geometry>,
    properties: Option<BTreeMap<String, Value>>,
}

/// The property that holds the tags without a column of their own, as `"key"=>"value"`: an export of GDAL.
pub(super) const OTHER_TAGS: &str = "other_tags";
/// The property that holds all tags as a table.
const TAGS: &str = "tags";

/// Reads a file: its text, and the elements that plans are made of.
///
/// # Errors
/// All faults of the file, each at its place.
pub(super) fn read(path: &Path) -> Result<(Source, Vec<Mapped>), Faults> {
    let source = as_collection(Source::read(path)?);
    let collection: Collection = source.parse()?;
    let mapped = collection
        .features
        .into_iter()
        .zip(0..)
        .filter_map(|(feature, index)| mapped(feature, index))
        .collect();
    Ok((source, mapped))
}

/// A fault of a feature, by its index.
pub(super) fn fault_of(source: &Source, place: u64, message: &str) -> Fault {
    let index = usize::try_from(place).unwrap_or_default();
    let path = [PathStep::from("features"), index.into(), "properties".into()];
    source.fault(&path, message.to_owned(), None, FaultSeverity::Error)
}

fn mapped(feature: Feature, place: u64) -> Option<Mapped> {
    let properties = feature.properties?;
    let id = id_of(feature.id.as_ref(), &properties).unwrap_or_else(|| format!("f{place}"));
    let tags = tags_of(properties);
    if !tags.keys().any(|key| is_wanted(key)) {
        return None;
    }
    let shape = match feature.geometry {
        Some(Geometry::Point { coordinates }) => Shape::Point(point(&coordinates)),
        Some(Geometry::LineString { coordinates }) => Shape::Line(line(&coordinates)),
        Some(Geometry::Polygon { coordinates }) => Shape::Areas(vec![rings(&coordinates)]),
        Some(Geometry::MultiPolygon { coordinates }) => {
            Shape::Areas(coordinates.iter().map(|polygon| rings(polygon)).collect())
        }
        // Left out where it is sorted, as a room without an outline.
        Some(Geometry::Other) | None => Shape::Line(Vec::new()),
    };
    Some(Mapped { id, place, tags, shape })
}

/// The tags of a feature, wherever it has them.
fn tags_of(properties: BTreeMap<String, Value>) -> Tags {
    let mut tags = Tags::new();
    for (key, value) in properties {
        match value {
            Value::Object(nested) if key == TAGS => {
                tags.extend(nested.into_iter().filter_map(|(key, value)| Some((key, text_of(&value)?))));
            }
            Value::String(pairs) if key == OTHER_TAGS => {
                tags.extend(hstore(&pairs).map(|(key, value)| (key.to_owned(), value.to_owned())));
            }
            value => tags.extend(text_of(&value).map(|text| (key, text))),
        }
    }
    tags
}

fn text_of(value: &Value) -> Option<String> {
    match value {
        Value::String(text) => Some(text.clone()),
        Value::Number(number) => Some(number.to_string()),
        Value::Bool(is_so) => Some(if *is_so { "yes" } else { "no" }.to_owned()),
        _ => None,
    }
}

/// `way/123` as `w123`; other ids in letters that ids of rooms may have.
fn id_of(id: Option<&Value>, properties: &BTreeMap<String, Value>) -> Option<String> {
    let keys = ["@id", "id"].map(|key| properties.get(key));
    let words = [id].into_iter().chain(keys).flatten().find_map(text_of)?;
    for (long, short) in [("way/", "w"), ("relation/", "r"), ("node/", "n")] {
        let number = words.strip_prefix(long).and_then(|number| number.parse::<i64>().ok());
        if let Some(number) = number {
            return Some(format!("{short}{number}"));
        }
    }
    let is_fit = |letter: char| letter.is_ascii_alphanumeric() || matches!(letter, '-' | '_');
    let id: String = words.chars().take(64).map(|letter| if is_fit(letter) { letter } else { '_' }).collect();
    (!id.is_empty()).then_some(id)
}

fn rings(lines: &[Vec<Position>]) -> Rings {
    let mut lines = lines.iter().map(|positions| line(positions));
    Rings { outer: lines.next().unwrap_or_default(), holes: lines.collect() }
}

fn line(positions: &[Position]) -> Vec<Point> {
    positions.iter().map(|position| point(position)).collect()
}

/// A place without two numbers is nowhere; its element is left out.
fn point(position: &[f64]) -> Point {
    match position {
        [longitude, latitude, ..] => Point::new(*longitude, *latitude),
        _ => Point::NAN,
    }
}
