//! Reads JSON into a document in memory, without places.

use std::fmt;

use serde::de::{Deserialize, Deserializer, Error, IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde_json::Value;

use super::node::{Content, Entry, Node, Spelling};
use super::unique::UniqueKeys;

/// The value of a text.
///
/// # Errors
/// The first fault of syntax; an object that names a key twice.
pub(super) fn parse_json(text: &str) -> Result<Node, serde_json::Error> {
    serde_json::from_str::<Parsed>(text).map(|parsed| node(parsed.0))
}

struct Parsed(Content);

fn node(content: Content) -> Node {
    Node { position: (0, 0), content }
}

fn scalar(value: impl Into<Value>) -> Parsed {
    Parsed(Content::Scalar { value: value.into(), spelling: Spelling::Json })
}

impl<'de> Deserialize<'de> for Parsed {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(ParsedVisitor)
    }
}

struct ParsedVisitor;

impl<'de> Visitor<'de> for ParsedVisitor {
    type Value = Parsed;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("any value")
    }

    fn visit_bool<E>(self, value: bool) -> Result<Parsed, E> {
        Ok(scalar(value))
    }

    fn visit_i64<E>(self, value: i64) -> Result<Parsed, E> {
        Ok(scalar(value))
    }

    fn visit_u64<E>(self, value: u64) -> Result<Parsed, E> {
        Ok(scalar(value))
    }

    fn visit_f64<E>(self, value: f64) -> Result<Parsed, E> {
        Ok(scalar(value))
    }

    fn visit_str<E>(self, value: &str) -> Result<Parsed, E> {
        Ok(scalar(value))
    }

    fn visit_unit<E>(self) -> Result<Parsed, E> {
        Ok(scalar(Value::Null))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Parsed, A::Error> {
        let mut nodes = Vec::new();
        while let Some(item) = items.next_element::<Parsed>()? {
            nodes.push(node(item.0));
        }
        Ok(Parsed(Content::Sequence(nodes)))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<Parsed, A::Error> {
        let (mut found, mut keys) = (Vec::new(), UniqueKeys::default());
        while let Some(key) = entries.next_key::<String>()? {
            if !keys.insert(&found, &key) {
                entries.next_value::<IgnoredAny>()?;
                return Err(A::Error::custom(format!("duplicate key \"{key}\"")));
            }
            let value = node(entries.next_value::<Parsed>()?.0);
            found.push(Entry { key, key_position: (0, 0), value });
        }
        Ok(Parsed(Content::Mapping(found)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_object_must_not_name_a_key_twice() {
        let text = |twice: &str| {
            let keys: Vec<String> = (0..40).map(|key| format!("\"k{key}\": 1")).collect();
            format!("{{{}, \"{twice}\": 2}}", keys.join(", "))
        };
        assert!(parse_json(&text("new")).is_ok());
        for twice in ["k0", "k20"] {
            let message = parse_json(&text(twice)).unwrap_err().to_string();
            assert!(message.starts_with(&format!("duplicate key \"{twice}\"")), "{message}");
        }
        assert!(parse_json("{\"a\": 1, \"a\": 2}").is_err());
    }
}
