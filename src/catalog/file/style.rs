//! The keys of `configs/styles/*.yaml`.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Deserialize;

use super::building_style::BuildingStyleEntry;
use super::room::RequestEntry;
use super::{FormatVersion, OneOrMany};
use crate::catalog::table::Extends;
use crate::catalog::{Access, Era};

/// Styles: how rooms of a kind are furnished and how they look.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "Styles")]
pub(crate) struct StyleFile {
    #[expect(dead_code, reason = "checked while reading")]
    pub(crate) version: FormatVersion,
    /// The styles by id: lower-case words joined by `_`.
    #[serde(default)]
    pub(crate) styles: BTreeMap<String, StyleEntry>,
    /// Building styles by id: which style each room of a building is furnished in. No style has the same id.
    #[serde(default)]
    pub(crate) building_styles: BTreeMap<String, BuildingStyleEntry>,
}

/// A style.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct StyleEntry {
    /// A title for people; the id with spaces if absent.
    pub(crate) label: Option<String>,
    /// Another style, whose keys are taken where this one has none. `programmes` and `additions` are merged
    /// room type by room type, `untidiness` key by key.
    pub(crate) extends: Option<String>,
    /// Room types it is made for; all if absent.
    pub(crate) room_types: Option<OneOrMany<String>>,
    /// Programmes that replace the room type's own, by room type.
    pub(crate) programmes: Option<BTreeMap<String, Vec<RequestEntry>>>,
    /// Lines added to the programme, by room type.
    pub(crate) additions: Option<BTreeMap<String, Vec<RequestEntry>>>,
    /// The geometry set that recipes build; default `plain`.
    pub(crate) geometry: Option<String>,
    /// The palette; default `modern`.
    pub(crate) palette: Option<String>,
    /// Random offsets that make a room look lived in.
    pub(crate) untidiness: Option<UntidinessEntry>,
    /// Factor on the counts of lines that are not required; default 1.
    pub(crate) density: Option<f64>,
    /// How people move in the rooms: `walking` (default), or `wheelchair`, for wide ways and room to turn.
    pub(crate) access: Option<Access>,
    /// When the furniture is from: classes of other `eras` are not drawn.
    pub(crate) era: Option<Era>,
    /// The cost of the furniture, 1 (cheap) to 3 (expensive): classes of other `wealth` are not used.
    pub(crate) wealth: Option<i64>,
}

impl Extends for StyleEntry {
    const KIND: &'static str = "style";
    const TABLE: &'static str = "styles";

    fn base(&self) -> Option<&str> {
        self.extends.as_deref()
    }
}

/// How untidy.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct UntidinessEntry {
    /// Degrees either way; default 0.
    pub(crate) turn: Option<f64>,
    /// Metres of distance from the parent; default 0.
    pub(crate) distance: Option<f64>,
}
