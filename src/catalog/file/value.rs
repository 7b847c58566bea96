//! Values that may be written in more than one way: one or several, one number or two.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;

use crate::catalog::Variety;

/// One value or a list of values.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(untagged)]
pub(crate) enum OneOrMany<T> {
    /// A list.
    Many(Vec<T>),
    /// A value that stands for the list of itself.
    One(T),
}

impl<T> OneOrMany<T> {
    /// The values, each with its place in the list where there is one.
    pub(crate) fn items(&self) -> impl Iterator<Item = (Option<usize>, &T)> {
        let (values, is_list) = match self {
            Self::Many(values) => (values.as_slice(), true),
            Self::One(value) => (std::slice::from_ref(value), false),
        };
        values.iter().enumerate().map(move |(index, value)| (is_list.then_some(index), value))
    }
}

impl<T: JsonSchema> JsonSchema for OneOrMany<T> {
    fn schema_name() -> Cow<'static, str> {
        format!("OneOrMany{}", T::schema_name()).into()
    }

    fn inline_schema() -> bool {
        true
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let one = generator.subschema_for::<T>();
        let item = one.clone();
        json_schema!({"anyOf": [one, {"type": "array", "items": item, "minItems": 1}]})
    }
}

/// The schema of a number where a list of so many numbers may stand. The derived one would offer a choice, and
/// faults would then name neither of its ways.
macro_rules! number_or_list {
    ($name:ident, $count:literal) => {
        impl JsonSchema for $name {
            fn schema_name() -> Cow<'static, str> {
                stringify!($name).into()
            }

            fn inline_schema() -> bool {
                true
            }

            fn json_schema(_: &mut SchemaGenerator) -> Schema {
                json_schema!({
                    "type": ["number", "array"],
                    "items": {"type": "number"},
                    "minItems": $count,
                    "maxItems": $count
                })
            }
        }
    };
}

/// A number, or the lowest and the highest.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(untagged)]
pub(crate) enum Pair {
    /// One number.
    One(f64),
    /// Lowest and highest.
    Two([f64; 2]),
}

impl Pair {
    /// Lowest and highest, one number standing for both.
    pub(crate) fn both(self) -> (f64, f64) {
        match self {
            Self::One(value) => (value, value),
            Self::Two([low, high]) => (low, high),
        }
    }

    /// Lowest and highest, one number standing for the highest.
    pub(crate) fn with_lowest(self, lowest: f64) -> (f64, f64) {
        match self {
            Self::One(highest) => (lowest, highest),
            Self::Two([low, high]) => (low, high),
        }
    }

    /// Lowest and highest, one number standing for the lowest.
    pub(crate) fn with_highest(self, highest: f64) -> (f64, f64) {
        match self {
            Self::One(lowest) => (lowest, highest),
            Self::Two([low, high]) => (low, high),
        }
    }
}

number_or_list!(Pair, 2);

/// A number for all edges, or left, front, right, back.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(untagged)]
pub(crate) enum Edges {
    /// The same at all edges.
    One(f64),
    /// Left, front, right, back.
    Four([f64; 4]),
}

impl Edges {
    /// Left, front, right, back.
    pub(crate) fn all(self) -> [f64; 4] {
        match self {
            Self::One(value) => [value; 4],
            Self::Four(values) => values,
        }
    }
}

number_or_list!(Edges, 4);

/// A coordinate inside a box as written: metres from the low end, or a share of the length.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(untagged)]
pub(crate) enum ExtentText {
    /// Metres from the low end.
    Metres(f64),
    /// `P%`, `P%+m` or `P%-m`.
    Share(String),
}

impl JsonSchema for ExtentText {
    fn schema_name() -> Cow<'static, str> {
        "Extent".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "Metres from the low end (left, front, underside), or a share of the length: \"50%\", \"100%-0.03\".",
            "type": ["number", "string"]
        })
    }
}

/// Whether pieces differ from each other as written: yes, no, or in details.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(untagged)]
pub(crate) enum VariedEntry {
    /// In everything or in nothing.
    Whether(bool),
    /// In details only.
    In(VariedWord),
}

/// The word of a [`VariedEntry`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum VariedWord {
    /// Of one shape, filled differently.
    Details,
}

impl From<VariedEntry> for Variety {
    fn from(entry: VariedEntry) -> Self {
        match entry {
            VariedEntry::Whether(false) => Self::None,
            VariedEntry::Whether(true) => Self::Full,
            VariedEntry::In(VariedWord::Details) => Self::Details,
        }
    }
}

impl JsonSchema for VariedEntry {
    fn schema_name() -> Cow<'static, str> {
        "Varied".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "enum": [false, true, "details"] })
    }
}
