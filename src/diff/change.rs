//! One difference between two bakes.

use schemars::JsonSchema;
use serde::Serialize;

use super::kind::Kind;
use super::tolerance::{round_degrees, round_metres};

/// One difference of a room, a level or an object.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Change {
    /// Its kind.
    pub kind: Kind,
    /// The subject: an object's or opening's id, a class, a code of the audit; empty for the room or level.
    pub id: String,
    /// The id before, where it was another one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub old_id: Option<String>,
    /// The value before; missing for additions.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub old: Option<Worth>,
    /// The value after; missing for removals.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub new: Option<Worth>,
    /// Metres moved, degrees turned, or how many parts, models or materials differ.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub amount: Option<f64>,
    /// The object that carried it: it moved or turned with that and not by itself.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub with: Option<String>,
}

/// A value before or after.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum Worth {
    /// A word: a class, a type, a style, a parent, a seed.
    Word(String),
    /// Several words: materials, names, objects of a finding.
    Words(Vec<String>),
    /// A count, a number, degrees.
    Number(f64),
    /// Metres: a place (x east, y north, z up) or a size (width, depth, height).
    Numbers(Vec<f64>),
    /// A finding of the audit.
    Finding(FindingWorth),
}

/// A finding of the audit.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FindingWorth {
    /// `given`, `minor` or `failed`.
    pub severity: String,
    /// Ids of the objects concerned.
    pub objects: Vec<String>,
    /// The measured value.
    pub measured: f64,
    /// The threshold that it breaks.
    pub threshold: f64,
}

impl Worth {
    /// Metres, rounded.
    pub(super) fn metres(numbers: impl IntoIterator<Item = f64>) -> Self {
        Self::Numbers(numbers.into_iter().map(round_metres).collect())
    }

    /// Degrees, rounded.
    pub(super) fn degrees(number: f64) -> Self {
        Self::Number(round_degrees(number))
    }

    /// A word.
    pub(super) fn word(text: impl ToString) -> Self {
        Self::Word(text.to_string())
    }
}

impl Change {
    /// A change of something, with nothing known yet about before and after.
    pub(super) fn of(kind: Kind, id: impl Into<String>) -> Self {
        Self { kind, id: id.into(), old_id: None, old: None, new: None, amount: None, with: None }
    }

    /// The same with both values.
    pub(super) fn between(self, old: Worth, new: Worth) -> Self {
        Self { old: Some(old), new: Some(new), ..self }
    }

    /// The same with an amount.
    pub(super) fn by(self, amount: f64) -> Self {
        Self { amount: Some(amount), ..self }
    }
}
