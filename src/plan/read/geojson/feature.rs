//! GeoJSON (RFC 7946) as typed values.

use std::path::Path;

use schemars::JsonSchema;
use serde::{Deserialize, Deserializer};
use serde_json::{Number, Value};

use crate::document::{Faults, Source};

// Types of our own, not those of the `geojson` crate: that reads each object into a table of values first and makes geometries
// from the table, so that its faults name neither line nor path, and its types have no JSON Schema, by which [`Source::parse`]
// finds all faults of a file at once. With it, each of the faults that the tests of the reader of IMDF break files for would be a
// single one without a place; what it would save are the two types below.

/// A file; keys that the plan does not need are not listed.
#[derive(Debug, Deserialize, JsonSchema)]
pub(crate) struct Collection<P> {
    pub(crate) features: Vec<Feature<P>>,
}

/// One feature.
#[derive(Debug, Deserialize, JsonSchema)]
pub(crate) struct Feature<P> {
    #[serde(deserialize_with = "id")]
    #[schemars(with = "Id")]
    pub(crate) id: String,
    pub(crate) geometry: Option<Geometry>,
    pub(crate) properties: P,
}

/// An id as files have it: RFC 7946 allows numbers.
#[derive(Deserialize, JsonSchema)]
#[serde(untagged)]
pub(crate) enum Id {
    Text(String),
    Number(Number),
}

impl From<Id> for String {
    fn from(id: Id) -> Self {
        match id {
            Id::Text(text) => text,
            Id::Number(number) => number.to_string(),
        }
    }
}

/// Reads an id, for `deserialize_with`; its schema is that of [`Id`].
pub(crate) fn id<'de, D: Deserializer<'de>>(value: D) -> Result<String, D::Error> {
    Id::deserialize(value).map(Into::into)
}

/// Reads an id that may be `null`; absent ones need `default`.
pub(crate) fn optional_id<'de, D: Deserializer<'de>>(value: D) -> Result<Option<String>, D::Error> {
    Option::<Id>::deserialize(value).map(|id| id.map(Into::into))
}

/// Reads a list of ids that may be `null`; absent ones need `default`.
pub(crate) fn optional_ids<'de, D: Deserializer<'de>>(value: D) -> Result<Option<Vec<String>>, D::Error> {
    let ids = Option::<Vec<Id>>::deserialize(value)?;
    Ok(ids.map(|ids| ids.into_iter().map(Into::into).collect()))
}

/// Longitude and latitude in degrees, perhaps a height.
pub(crate) type Position = Vec<f64>;

/// The geometries that plans are made of.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(tag = "type")]
pub(crate) enum Geometry {
    /// A place.
    Point { coordinates: Position },
    /// A line through places.
    LineString { coordinates: Vec<Position> },
    /// Outer ring, then holes.
    Polygon { coordinates: Vec<Vec<Position>> },
    /// Several polygons.
    MultiPolygon { coordinates: Vec<Vec<Vec<Position>>> },
    /// Anything else.
    #[serde(other)]
    Other,
}

/// A file's text and its features.
pub(crate) struct Table<P> {
    pub(crate) source: Source,
    pub(crate) features: Vec<Feature<P>>,
}

/// Reads a file that holds a collection of features.
///
/// # Errors
/// All faults of the file, each at its place.
pub(crate) fn read_table<P>(path: &Path) -> Result<Table<P>, Faults>
where
    P: for<'de> Deserialize<'de> + JsonSchema,
{
    let source = Source::read(path)?;
    let collection: Collection<P> = source.parse()?;
    Ok(Table { source, features: collection.features })
}

/// The name of a reference system: the `crs` of files before RFC 7946.
pub(crate) fn reference_system(crs: Option<&Value>) -> Option<String> {
    let properties = crs?.get("properties")?;
    let name = properties.get("name").and_then(Value::as_str).map(str::to_owned);
    name.or_else(|| Some(format!("EPSG:{}", properties.get("code")?.as_u64()?)))
}
