//! Reads the files of an IMDF folder: GeoJSON collections of features of one kind each, with the properties of that kind.

use std::collections::BTreeMap;
use std::path::Path;

use schemars::JsonSchema;
use serde::{Deserialize, Deserializer};

use crate::document::Faults;
use crate::plan::read::geojson::{Feature, Id, Table, id, optional_id, optional_ids, read_table};

/// Text by language; some programs write a text alone.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub(super) enum Labels {
    ByLanguage(BTreeMap<String, Option<String>>),
    Text(String),
}

/// Properties of a building.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct BuildingProperties {
    pub(super) name: Option<Labels>,
}

/// Properties of a level.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct LevelProperties {
    /// 0 is the ground floor.
    #[serde(deserialize_with = "whole")]
    pub(super) ordinal: i32,
    pub(super) name: Option<Labels>,
    #[serde(default, deserialize_with = "optional_ids")]
    #[schemars(with = "Option<Vec<Id>>")]
    pub(super) building_ids: Option<Vec<String>>,
}

/// Properties of a unit.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct UnitProperties {
    pub(super) category: Option<String>,
    #[serde(deserialize_with = "id")]
    #[schemars(with = "Id")]
    pub(super) level_id: String,
    pub(super) name: Option<Labels>,
}

/// Properties of an opening.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct OpeningProperties {
    #[serde(deserialize_with = "id")]
    #[schemars(with = "Id")]
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
    #[serde(default, deserialize_with = "optional_id")]
    #[schemars(with = "Option<Id>")]
    pub(super) unit_id: Option<String>,
}

/// Properties of an occupant: who uses a unit.
#[derive(Debug, Deserialize, JsonSchema)]
pub(super) struct OccupantProperties {
    pub(super) name: Option<Labels>,
    pub(super) category: Option<String>,
    #[serde(default, deserialize_with = "optional_id")]
    #[schemars(with = "Option<Id>")]
    pub(super) anchor_id: Option<String>,
}

/// A whole number, also as programs write it that have no others than fractions: `1.0`.
fn whole<'de, D: Deserializer<'de>>(value: D) -> Result<i32, D::Error> {
    let number = f64::deserialize(value)?;
    let is_whole = number.fract() == 0.0 && number.abs() <= f64::from(i32::MAX);
    is_whole.then_some(number as i32).ok_or_else(|| serde::de::Error::custom("is no whole number"))
}

/// Reads `<name>.geojson` of a folder.
pub(super) fn table<P>(folder: &Path, name: &str) -> Result<Table<P>, Faults>
where
    P: for<'de> Deserialize<'de> + JsonSchema,
{
    read_table(&folder.join(name).with_extension("geojson"))
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
    let text = match labels? {
        Labels::Text(text) => Some(text),
        Labels::ByLanguage(texts) => {
            let is_english = |language: &str| language.split(['-', '_']).next() == Some(PREFERRED);
            let english =
                texts.iter().filter(|(language, _)| is_english(language)).find_map(|(_, text)| text.as_ref());
            english.or_else(|| texts.values().flatten().next())
        }
    };
    text.filter(|text| !text.trim().is_empty()).cloned()
}
