//! Sequences of features, one on each line (GeoJSONL, also with the record separators of RFC 8142), as one collection.

use crate::document::Source;

/// What begins each text of a sequence by RFC 8142.
pub(crate) const RECORD_SEPARATOR: char = '\u{1e}';

/// A text with one collection: the text itself, or the features that follow each other in it. Faults keep their lines.
pub(crate) fn as_collection(source: Source) -> Source {
    let text = source.text();
    let is_separated = text.trim_start().starts_with(RECORD_SEPARATOR);
    if !is_separated && source.top_keys().iter().any(|key| key == "features") {
        return source;
    }
    let mut collection = String::with_capacity(text.len() + text.len() / 64);
    let mut before = r#"{"type": "FeatureCollection", "features": ["#;
    for line in text.split_inclusive('\n') {
        // A feature that is written over several lines has its braces indented.
        let begins = if is_separated { RECORD_SEPARATOR } else { '{' };
        if line.starts_with(begins) {
            collection.push_str(before);
            before = ",";
        }
        collection.extend(line.chars().filter(|letter| *letter != RECORD_SEPARATOR));
    }
    collection.push_str("]}");
    Source::new(source.file(), &collection)
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    fn collection(text: &str) -> String {
        let source = as_collection(Source::new(Path::new("a.geojsonl"), text));
        let value: serde_json::Value = serde_json::from_str(source.text()).unwrap();
        value["features"].to_string()
    }

    #[test]
    fn features_on_lines_are_a_collection() {
        assert_eq!(collection("{\"a\": 1}\n{\"a\": 2}\r\n"), r#"[{"a":1},{"a":2}]"#);
        assert_eq!(collection("\u{1e}{\"a\": 1}\n\u{1e}{\n\"a\": [\n{}]}\n"), r#"[{"a":1},{"a":[{}]}]"#);
        assert_eq!(collection("{\n  \"a\": [\n    {}\n  ]\n}"), r#"[{"a":[{}]}]"#);
        assert_eq!(collection("{\"features\": [{\"a\": 1}]}"), r#"[{"a":1}]"#);
    }
}
