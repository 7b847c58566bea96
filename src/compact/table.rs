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

/// All columns.
const COLUMNS: [Column; 6] = [
    ("building", "Building id", |feature| &feature.building),
    ("level", "Level id", |feature| &feature.level),
    ("room", "Room id; of an opening the ids of the rooms that it joins", |feature| &feature.room),
    ("room_type", "Room type; empty for openings", |feature| &feature.room_type),
    ("class", "Class of furniture, or kind of part or opening", |feature| &feature.class),
    ("id", "Unique in the room; of an opening unique in the level", |feature| &feature.id),
];

/// A table whose columns are not yet in views.
pub(super) struct Table {
    count: usize,
    /// Of each column: the numbers of its values and of their offsets.
    columns: Vec<[usize; 2]>,
}

impl Table {
    /// Adds the values of features.
    pub(super) fn new(features: &[Feature], arrays: &mut Arrays) -> Self {
        let columns = COLUMNS.iter().map(|(_, _, value)| {
            let mut text = Vec::new();
            let mut offsets = vec![0; 4];
            for feature in features {
                text.extend_from_slice(value(feature).as_bytes());
                let offset = u32::try_from(text.len()).expect("ids are short, and features are few");
                offsets.extend_from_slice(&offset.to_le_bytes());
            }
            // A view holds at least one byte.
            text.resize(text.len().max(1), 0);
            [arrays.add_table(text), arrays.add_table(offsets)]
        });
        Self { count: features.len(), columns: columns.collect() }
    }

    /// The extension of the file, given the view of each column.
    pub(super) fn extension(&self, views: &[usize]) -> Value {
        let property =
            |(_, about, _): &Column| json!({"description": about, "type": "STRING", "required": true});
        let properties: Map<String, Value> =
            COLUMNS.iter().map(|column| (column.0.to_owned(), property(column))).collect();
        let values: Map<String, Value> = COLUMNS
            .iter()
            .zip(&self.columns)
            .map(|(column, [text, offsets])| {
                (column.0.to_owned(), json!({"values": views[*text], "stringOffsets": views[*offsets]}))
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
