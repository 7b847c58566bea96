//! `configs/room_words.yaml`.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Deserialize;

use super::FormatVersion;

/// The room words of plan formats and the room types that they mean.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "Room words")]
pub(crate) struct WordsFile {
    #[expect(dead_code, reason = "checked while reading")]
    pub(crate) version: FormatVersion,
    /// Plan format, then word (in any case), then room type. Later folders add to earlier ones.
    pub(crate) formats: BTreeMap<String, BTreeMap<String, String>>,
}
