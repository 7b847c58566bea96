//! The table that names features (`EXT_structural_metadata`).

use serde_json::{Map, Value, json};

use super::buffer::Arrays;
use super::feature::Feature;

/// The extension.
pub(super) const STRUCTURAL_METADATA: &str = "EXT_structural_metadata";

/// The class of the schema.
const CLASS: &str = "piece";

/// A column: its name, what it says, and its value for a feature.
type Column = (&'static str, &'static str, fn(&Feature) -> &str);

/// What is the same for all features of a file: each is the default of its property and has no column.
const OF_LEVEL: [Column; 2] = [
    ("building", "Building id", |feature| &feature.building),
    ("level", "Level id", |feature| &feature.level),
];

/// What each feature has of its own.
const COLUMNS: [Column; 4] = [
    ("room", "Room id; of an opening the ids of the rooms that it joins", |feature| &feature.room),
    ("room_type", "Room type; empty for openings", |feature| &feature.room_type),
    ("class", "Class of furniture, or kind of part or opening", |feature| &feature.class),
    ("id", "Unique in the room; of an opening unique in the level", |feature| &feature.id),
];

/// A table whose columns are not yet in views.
pub(super) struct Table<'f> {
    count: usize,
    /// A feature of the level.
    any: &'f Feature,
    columns: Vec<Texts>,
}

/// The texts of a column.
struct Texts {
    /// The numbers of its arrays.
    values: usize,
    offsets: usize,
    offset_type: &'static str,
}

/// Numbers that rise, in as few bytes as the last of them needs, and the name of their type.
fn packed(rising: &[u32]) -> (&'static str, Vec<u8>) {
    let shorts: Result<Vec<u16>, _> = rising.iter().map(|&number| u16::try_from(number)).collect();
    match shorts {
        Ok(shorts) => ("UINT16", shorts.into_iter().flat_map(u16::to_le_bytes).collect()),
        Err(_) => ("UINT32", rising.iter().flat_map(|number| number.to_le_bytes()).collect()),
    }
}

impl<'f> Table<'f> {
    /// Adds the values of features; `None` without any.
    pub(super) fn new(features: &'f [Feature], arrays: &mut Arrays) -> Option<Self> {
        let any = features.first()?;
        let columns = COLUMNS.iter().map(|(_, _, value)| {
            let mut text = Vec::new();
            let mut offsets = vec![0];
            for feature in features {
                text.extend_from_slice(value(feature).as_bytes());
                offsets.push(u32::try_from(text.len()).expect("ids are short, and features are few"));
            }
            let (offset_type, offsets) = packed(&offsets);
            // A view holds at least one byte.
            text.resize(text.len().max(1), 0);
            Texts { values: arrays.add_table(text), offset_type, offsets: arrays.add_table(offsets) }
        });
        Some(Self { count: features.len(), any, columns: columns.collect() })
    }

    /// The extension of the file, given the view of each column.
    pub(super) fn extension(&self, views: &[usize]) -> Value {
        let of_level = OF_LEVEL.iter().map(|(name, about, value)| {
            (*name, json!({"description": about, "type": "STRING", "default": value(self.any)}))
        });
        let of_feature = COLUMNS.iter().map(|(name, about, _)| {
            (*name, json!({"description": about, "type": "STRING", "required": true}))
        });
        let properties: Map<String, Value> =
            of_level.chain(of_feature).map(|(name, property)| (name.to_owned(), property)).collect();
        let values: Map<String, Value> = COLUMNS
            .iter()
            .zip(&self.columns)
            .map(|(column, texts)| {
                let Texts { values, offsets, offset_type } = *texts;
                let texts = json!({
                    "values": views[values], "stringOffsets": views[offsets], "stringOffsetType": offset_type,
                });
                (column.0.to_owned(), texts)
            })
            .collect();
        json!({
            "schema": {
                "id": "roomwright",
                "classes": {CLASS: {"name": "Piece", "properties": properties}},
            },
            "propertyTables": [{"class": CLASS, "count": self.count, "properties": values}],
        })
    }
}
