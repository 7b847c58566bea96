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

impl Table {
    /// Adds the values of features.
    pub(super) fn new(features: &[Feature], arrays: &mut Arrays) -> Self {
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
