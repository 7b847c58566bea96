//! Reads YAML or JSON straight into a value.

use std::collections::BTreeSet;
use std::fmt;
use std::path::Path;

use serde::de::{DeserializeOwned, Deserializer, Error as _, IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde_saphyr::options::{DuplicateKeyPolicy, MergeKeyPolicy, NonFiniteFloatPolicy};

use super::limits::{ALIAS_LIMIT, DEPTH_LIMIT, FILE_SIZE_LIMIT, VALUE_LIMIT};

/// How a document is spelled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// For people.
    Yaml,
    /// For machines: over ten times faster to read.
    Json,
}

/// Why a document was refused: the first reason that was met.
#[derive(Clone, Debug)]
pub(super) struct Refusal {
    /// The reason.
    pub(super) message: String,
    /// Line and column from 1, where known.
    pub(super) position: Option<(usize, usize)>,
    /// Whether the text is no YAML or JSON at all, whatever it was to mean.
    pub(super) is_syntax: bool,
    /// Whether the text ends too early.
    pub(super) is_cut_off: bool,
}

impl Format {
    /// By the extension: `.json` and `.geojson` are JSON, everything else YAML (of which JSON is a part).
    #[must_use]
    pub fn of(file: &Path) -> Self {
        let extension = file.extension().and_then(|extension| extension.to_str()).unwrap_or_default();
        let is_json = ["json", "geojson"].iter().any(|known| extension.eq_ignore_ascii_case(known));
        if is_json { Self::Json } else { Self::Yaml }
    }

    /// Reads a text into a value.
    pub(super) fn parse<T: DeserializeOwned>(self, text: &str) -> Result<T, Refusal> {
        match self {
            Self::Yaml => serde_saphyr::from_str_with_options(text, yaml_options()).map_err(|e| of_yaml(&e)),
            Self::Json => {
                let value = serde_json::from_str(text).map_err(|error| of_json(&error))?;
                serde_json::from_str::<UniqueKeys>(text).map_err(|error| of_json(&error))?;
                Ok(value)
            }
        }
    }
}

/// Whether a YAML text might hold a number that is not finite. Rarely true without reason, never false
/// with one, and far cheaper than a look at every value.
pub(super) fn may_be_infinite(text: &str) -> bool {
    let bytes = text.as_bytes();
    bytes.windows(4).any(|window| {
        window.eq_ignore_ascii_case(b".nan")
            || window.eq_ignore_ascii_case(b".inf")
            || (window[0].eq_ignore_ascii_case(&b'e')
                && window[2..].iter().all(u8::is_ascii_digit)
                && (window[1].is_ascii_digit() || window[1] == b'+'))
    }) || bytes.split(|byte| !byte.is_ascii_digit()).any(|digits| digits.len() >= f64::MAX_10_EXP as usize)
}

fn yaml_options() -> serde_saphyr::Options {
    serde_saphyr::options! {
        budget: serde_saphyr::budget! {
            max_reader_input_bytes: Some(FILE_SIZE_LIMIT as usize),
            max_events: VALUE_LIMIT * 4,
            max_nodes: VALUE_LIMIT * 2,
            max_aliases: ALIAS_LIMIT,
            max_anchors: ALIAS_LIMIT,
            max_depth: DEPTH_LIMIT,
            max_total_scalar_bytes: FILE_SIZE_LIMIT as usize,
        },
        duplicate_keys: DuplicateKeyPolicy::Error,
        merge_keys: MergeKeyPolicy::Error,
        strict_booleans: true,
        non_finite_float_policy: NonFiniteFloatPolicy::Reject,
        with_snippet: false,
    }
}

fn of_yaml(error: &serde_saphyr::Error) -> Refusal {
    let message = error.without_snippet().to_string();
    // The place is kept apart from the message, which repeats it.
    let message = message.split(" at line ").next().unwrap_or_default().to_owned();
    let message = message
        .split_once(": ")
        .filter(|(place, _)| place.starts_with("line "))
        .map_or(message.clone(), |(_, rest)| rest.to_owned());
    let known = error.location().filter(|location| location.line() > 0);
    let position = known.and_then(|location| {
        Some((usize::try_from(location.line()).ok()?, usize::try_from(location.column()).ok()?.max(1)))
    });
    Refusal { message, position, is_syntax: false, is_cut_off: false }
}

fn of_json(error: &serde_json::Error) -> Refusal {
    let message = error.to_string();
    let message = message.rsplit_once(" at line ").map_or(message.as_str(), |(reason, _)| reason).to_owned();
    let position = (error.line() > 0).then(|| (error.line(), error.column().max(1)));
    Refusal { message, position, is_syntax: error.is_syntax() || error.is_eof(), is_cut_off: error.is_eof() }
}

/// Refuses JSON objects that name a key twice, which `serde_json` accepts for maps.
struct UniqueKeys;

impl<'de> serde::Deserialize<'de> for UniqueKeys {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(UniqueKeysVisitor)
    }
}

struct UniqueKeysVisitor;

impl<'de> Visitor<'de> for UniqueKeysVisitor {
    type Value = UniqueKeys;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("any value")
    }

    fn visit_bool<E>(self, _: bool) -> Result<UniqueKeys, E> {
        Ok(UniqueKeys)
    }

    fn visit_i64<E>(self, _: i64) -> Result<UniqueKeys, E> {
        Ok(UniqueKeys)
    }

    fn visit_u64<E>(self, _: u64) -> Result<UniqueKeys, E> {
        Ok(UniqueKeys)
    }

    fn visit_f64<E>(self, _: f64) -> Result<UniqueKeys, E> {
        Ok(UniqueKeys)
    }

    fn visit_str<E>(self, _: &str) -> Result<UniqueKeys, E> {
        Ok(UniqueKeys)
    }

    fn visit_unit<E>(self) -> Result<UniqueKeys, E> {
        Ok(UniqueKeys)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<UniqueKeys, A::Error> {
        while items.next_element::<UniqueKeys>()?.is_some() {}
        Ok(UniqueKeys)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<UniqueKeys, A::Error> {
        let mut keys = BTreeSet::new();
        while let Some(key) = entries.next_key::<String>()? {
            if keys.contains(&key) {
                entries.next_value::<IgnoredAny>()?;
                return Err(A::Error::custom(format!("duplicate key \"{key}\"")));
            }
            keys.insert(key);
            entries.next_value::<UniqueKeys>()?;
        }
        Ok(UniqueKeys)
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;

    #[test]
    fn the_extension_tells_the_format() {
        assert_eq!(Format::of(Path::new("a/b.JSON")), Format::Json);
        assert_eq!(Format::of(Path::new("a.yml")), Format::Yaml);
        assert_eq!(Format::of(Path::new("a")), Format::Yaml);
    }

    #[test]
    fn a_json_map_must_not_name_a_key_twice() {
        let read = |text| Format::Json.parse::<BTreeMap<String, f64>>(text);
        assert_eq!(read(r#"{"a": 1, "b": 2}"#).unwrap().len(), 2);
        assert_eq!(read(r#"{"a": 1, "a": 2}"#).unwrap_err().message, "duplicate key \"a\"");
    }

    #[test]
    fn infinite_numbers_are_suspected() {
        for text in ["a: .nan", "a: -.INF", "a: 1e999", "a: 1E+400"] {
            assert!(may_be_infinite(text), "{text}");
        }
        assert!(may_be_infinite(&"9".repeat(400)));
        assert!(!may_be_infinite("a: 1e9\nb: 3.5\nc: text"));
    }
}
