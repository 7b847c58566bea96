//! Reads the files of an IMDF folder: GeoJSON collections of one kind of feature each.

use std::collections::BTreeMap;
use std::path::Path;

use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::{Faults, Source};

// Types of our own, not those of the `geojson` crate: that reads each object into a table of values first and makes geometries
// from the table, so that its faults name neither line nor path, and its types have no JSON Schema, by which [`Source::parse`]
// finds all faults of a file at once. With it, each of the faults that the tests of this reader break files for would be a
// single one without a place; what it would save are the two types below.

/// A file; keys that the plan does not need are not listed.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct Collection<P> {
    pub(super) features: Vec<Feature<P>>,
}

/// One feature.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct Feature<P> {
    pub(super) id: String,
    pub(super) geometry: Option<Geometry>,
    pub(super) properties: P,
}

/// Longitude and latitude in degrees, perhaps a height.
pub(super) type Position = Vec<f64>;

/// The geometries that plans are made of.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(tag = "type")]
pub(super) enum Geometry {
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

/// Text by language.
pub(super) type Labels = BTreeMap<String, Option<String>>;

/// Properties of a building.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct BuildingProperties {
    pub(super) name: Option<Labels>,
}

/// Properties of a level.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct LevelProperties {
    /// 0 is the ground floor.
    pub(super) ordinal: i32,
    pub(super) name: Option<Labels>,
    pub(super) building_ids: Option<Vec<String>>,
}

/// Properties of a unit.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct UnitProperties {
    pub(super) category: String,
    pub(super) level_id: String,
    pub(super) name: Option<Labels>,
}

/// Properties of an opening.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct OpeningProperties {
    pub(super) level_id: String,
    pub(super) door: Option<Door>,
}

/// The kind of closure of an opening.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct Door {
    #[serde(rename = "type")]
    pub(super) kind: Option<String>,
}

/// Properties of an anchor: where an occupant is.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct AnchorProperties {
    pub(super) unit_id: Option<String>,
}

/// Properties of an occupant: who uses a unit.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct OccupantProperties {
    pub(super) name: Option<Labels>,
    pub(super) category: Option<String>,
    pub(super) anchor_id: Option<String>,
}

/// A file's text and its features.
pub(super) struct Table<P> {
    pub(super) source: Source,
    pub(super) features: Vec<Feature<P>>,
}

/// Reads `<name>.geojson` of a folder.
pub(super) fn table<P>(folder: &Path, name: &str) -> Result<Table<P>, Faults>
where
    P: for<'de> Deserialize<'de> + JsonSchema,
{
    let source = Source::read(&folder.join(name).with_extension("geojson"))?;
    let collection: Collection<P> = source.parse()?;
    Ok(Table { source, features: collection.features })
}

/// The features of a file; none where the file is missing.
pub(super) fn optional_features<P>(folder: &Path, name: &str) -> Result<Vec<Feature<P>>, Faults>
where
    P: for<'de> Deserialize<'de> + JsonSchema,
{
    let is_there = folder.join(name).with_extension("geojson").exists();
    if is_there { table(folder, name).map(|table| table.features) } else { Ok(Vec::new()) }
}

/// The English text, else the first by language.
pub(super) fn label(labels: Option<&Labels>) -> Option<String> {
    const PREFERRED: &str = "en";
    let texts = labels?;
    let english = texts.get(PREFERRED).and_then(Option::as_ref);
    english.or_else(|| texts.values().flatten().next()).filter(|text| !text.trim().is_empty()).cloned()
}
