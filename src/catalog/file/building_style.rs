//! The keys of `building_styles` in `configs/styles/*.yaml`.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Deserialize;

use crate::catalog::Share;
use crate::catalog::table::Extends;

/// A building style: which style each room of a building is furnished in.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct BuildingStyleEntry {
    /// A title for people; the id with spaces if absent.
    pub(crate) label: Option<String>,
    /// Another building style, whose keys are taken where this one has none. `rooms` is merged room type by room type,
    /// `instead` style by style.
    pub(crate) extends: Option<String>,
    /// Which rooms are drawn for together, so that their styles agree; default `dwelling`.
    pub(crate) share: Option<ShareWord>,
    /// Styles of rooms whose type is not in `rooms`; the default style if absent.
    pub(crate) styles: Option<ChoiceEntry>,
    /// Styles by room type.
    pub(crate) rooms: Option<BTreeMap<String, ChoiceEntry>>,
    /// By drawn style, the styles that single dwellings (rooms, where the plan knows none) get in its place, each with its
    /// share of all: `{hotel: {hotel_accessible: 0.05}}`.
    pub(crate) instead: Option<BTreeMap<String, BTreeMap<String, f64>>>,
}

/// Which rooms share one draw.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum ShareWord {
    /// None: each draws for itself.
    Room,
    /// The rooms of a flat or another copy of a prototype; where the plan knows none, those of a level.
    Dwelling,
    /// The rooms of a level.
    Level,
    /// All rooms of the building.
    Building,
}

impl From<ShareWord> for Share {
    fn from(word: ShareWord) -> Self {
        match word {
            ShareWord::Room => Self::Room,
            ShareWord::Dwelling => Self::Dwelling,
            ShareWord::Level => Self::Level,
            ShareWord::Building => Self::Building,
        }
    }
}

/// A style, several of which each is as likely, or several with their weights.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub(crate) enum ChoiceEntry {
    /// Always this one.
    One(String),
    /// One of these.
    Even(Vec<String>),
    /// One of these, as often as their weights say.
    Weighted(BTreeMap<String, f64>),
}

impl Extends for BuildingStyleEntry {
    const KIND: &'static str = "building style";
    const TABLE: &'static str = "building_styles";

    fn base(&self) -> Option<&str> {
        self.extends.as_deref()
    }
}
