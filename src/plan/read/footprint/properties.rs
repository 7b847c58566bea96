//! The properties of a feature of GeoJSON, or the attributes of an object of CityJSON, as tags, whatever tables they are nested in.

use serde_json::{Map, Value};

use crate::plan::read::footprint::facts::{TagValue, Tags};

/// The tags of properties: their own texts and numbers, those of the tables that exports nest, and a name of Overture.
pub(super) fn tags_of(properties: Option<Map<String, Value>>) -> Tags {
    let mut tags = Tags::default();
    let properties = properties.unwrap_or_default();
    let name = properties.get("names").and_then(overture_name);
    if let Some(name) = name {
        tags.add("name", TagValue::Text(name));
    }
    for (key, value) in properties {
        match value {
            // Exports of OpenStreetMap put what has no column into one, as a table or as text.
            Value::Object(nested) if key == "tags" => {
                nested.into_iter().for_each(|(key, value)| add(&mut tags, key, value));
            }
            Value::String(pairs) if key == "other_tags" => {
                hstore(&pairs).for_each(|(key, value)| tags.add(key, TagValue::Text(value.to_owned())));
            }
            value => add(&mut tags, key, value),
        }
    }
    tags
}

fn add(tags: &mut Tags, key: String, value: Value) {
    match value {
        Value::String(text) => tags.add(key, TagValue::Text(text)),
        Value::Number(number) => {
            if let Some(number) = number.as_f64() {
                tags.add(key, TagValue::Number(number));
            }
        }
        Value::Bool(is_so) => tags.add(key, TagValue::Text(if is_so { "yes" } else { "no" }.to_owned())),
        Value::Array(values) => {
            let words: Vec<&str> = values.iter().filter_map(Value::as_str).collect();
            if !words.is_empty() {
                tags.add(key, TagValue::Text(words.join(";")));
            }
        }
        Value::Null | Value::Object(_) => {}
    }
}

/// The pairs of a text such as `"building:levels"=>"5","roof:shape"=>"flat"`.
pub(crate) fn hstore(text: &str) -> impl Iterator<Item = (&str, &str)> {
    text.split("\",\"").filter_map(|pair| {
        let (key, value) = pair.split_once("\"=>\"")?;
        Some((key.trim_start_matches('"'), value.trim_end_matches('"')))
    })
}

/// `primary` of today's releases, or the first of the `common` names of the first ones.
fn overture_name(names: &Value) -> Option<String> {
    let primary = names.get("primary").and_then(Value::as_str);
    let first = || names.get("common")?.get(0)?.get("value")?.as_str();
    primary.or_else(first).map(str::to_owned)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tags_come_from_nested_tables_too() {
        let text = r#"{"names": {"primary": "Hall"}, "height": 7.5, "skip": null, "buildingPart": true,
            "tags": {"building": "yes"}, "other_tags": "\"building:levels\"=>\"5\",\"roof:shape\"=>\"flat\""}"#;
        let tags = tags_of(serde_json::from_str(text).unwrap());
        let texts = ["name", "building", "buildingPart", "building:levels", "roof:shape"];
        let found = texts.map(|key| tags.text(key));
        assert_eq!(found, [Some("Hall"), Some("yes"), Some("yes"), Some("5"), Some("flat")]);
        assert_eq!(tags.get("height"), Some(&TagValue::Number(7.5)));
        assert_eq!(tags.get("skip"), None);
    }

    #[test]
    fn the_first_releases_of_overture_have_lists_of_names() {
        let names = serde_json::json!({"common": [{"value": "Kerk", "language": "local"}]});
        assert_eq!(overture_name(&names).as_deref(), Some("Kerk"));
        assert_eq!(overture_name(&serde_json::json!({"common": {"en": "x"}})), None);
    }
}
