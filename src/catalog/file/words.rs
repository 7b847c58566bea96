//! The keys of `configs/room_words.yaml`.

use std::collections::{BTreeMap, BTreeSet};

use schemars::JsonSchema;
use serde::Deserialize;

use super::FormatVersion;
use crate::plan::GuessRule;

/// The room words of plan formats and the room types that they mean.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "Room words")]
pub(crate) struct WordsFile {
    #[expect(dead_code, reason = "checked while reading")]
    pub(crate) version: FormatVersion,
    /// Plan format, then word (in any case), then room type. Later folders add to earlier ones.
    pub(crate) formats: BTreeMap<String, BTreeMap<String, String>>,
    /// Plan format, then word for a piece of furniture (in any case), then class, for `import --keep-furniture`. Later folders add to
    /// earlier ones.
    #[serde(default)]
    pub(crate) pieces: BTreeMap<String, BTreeMap<String, String>>,
    /// Rules for rooms with other words: the first rule that fits counts. Those of later folders come before earlier ones.
    #[serde(default)]
    pub(crate) guesses: Vec<GuessRule>,
    /// Kinds of buildings: those of room types to which most known rooms of a building belong.
    #[serde(default)]
    pub(crate) families: BTreeMap<String, BTreeSet<String>>,
}
