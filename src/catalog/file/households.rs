//! The keys of `configs/households.yaml`.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Deserialize;

use super::{FormatVersion, Pair};

/// Who lives in dwellings, and what their rooms are then.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "Households")]
pub(crate) struct HouseholdsFile {
    #[expect(dead_code, reason = "checked while reading")]
    pub(crate) version: FormatVersion,
    /// Which rooms are parts of dwellings. Keys of later folders replace those of earlier ones.
    pub(crate) homes: Option<HomesEntry>,
    /// Room types that rooms may be furnished as. Those of later folders replace earlier ones of the same id.
    #[serde(default)]
    pub(crate) roles: BTreeMap<String, RoleEntry>,
    /// The households by id: lower-case words joined by `_`. Those of later folders replace earlier ones of the same id.
    #[serde(default)]
    pub(crate) households: BTreeMap<String, HouseholdEntry>,
}

/// What the room types of plans say about dwellings.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct HomesEntry {
    /// The types of rooms of dwellings. Rooms that doors join are no dwelling if one of them is of another type.
    pub(crate) inside: Option<Vec<String>>,
    /// Types of what stands between dwellings or outside of them: stairs, balconies.
    pub(crate) between: Option<Vec<String>>,
    /// Types of rooms in the open: a door to one lets light in.
    pub(crate) outdoors: Option<Vec<String>>,
    /// Types of rooms in which meals are cooked.
    pub(crate) kitchens: Option<Vec<String>>,
    /// Types of rooms with a sofa and a screen.
    pub(crate) living: Option<Vec<String>>,
    /// Types of rooms with a table for meals.
    pub(crate) dining: Option<Vec<String>>,
    /// Types of rooms with a bath or shower.
    pub(crate) bathrooms: Option<Vec<String>>,
    /// Square metres from which on a kitchen has a table for meals.
    pub(crate) dining_kitchen: Option<f64>,
    /// What a living room is where the plan names none.
    pub(crate) living_roles: Option<LivingEntry>,
    /// The roles of rooms that nobody claims: the first that fits.
    pub(crate) spare: Option<Vec<String>>,
}

/// What a living room is.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct LivingEntry {
    /// Where no other room has a table for meals: the first role that fits.
    pub(crate) table_is_missing: Vec<String>,
    /// Where one has: the first role that fits.
    pub(crate) table_is_there: Vec<String>,
    /// Where there is no other room to live or sleep in.
    pub(crate) only_room: String,
    /// A second one of the plan: without a screen.
    pub(crate) second: String,
    /// That of a dwelling whose plan names a living room and no kitchen: the first role that fits.
    #[serde(default)]
    pub(crate) kitchen_is_missing: Vec<String>,
}

/// Which rooms may be furnished as a room type.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct RoleEntry {
    /// The types of a plan that leave this role open.
    pub(crate) of: Vec<String>,
    /// Square metres, least and most; one number is the least.
    pub(crate) area: Option<Pair>,
    /// Whether it takes a room without daylight only where no other is left; default false.
    #[serde(default)]
    pub(crate) window: bool,
    /// Whether somebody sleeps there; default false.
    #[serde(default)]
    pub(crate) sleeps: bool,
    /// Which of the rooms that suit it; default `largest`.
    #[serde(default)]
    pub(crate) pick: PickWord,
}

/// Which of several rooms.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum PickWord {
    /// That with most floor.
    #[default]
    Largest,
    /// That with least floor.
    Smallest,
}

/// A kind of household.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct HouseholdEntry {
    /// A title for people; the id with spaces if absent.
    pub(crate) label: Option<String>,
    /// How many people it is; those of its rooms are added.
    pub(crate) persons: i64,
    /// Its weight in dwellings with no room to sleep in besides the living room, with one, with two and so on; the last
    /// counts for all with more. 0 is never.
    pub(crate) chance: Vec<f64>,
    /// Room types that only such households have: a plan that names one belongs to one of them.
    #[serde(default)]
    pub(crate) with: Vec<String>,
    /// Who takes a room, in this order.
    #[serde(default)]
    pub(crate) rooms: Vec<ClaimEntry>,
}

/// A wish of a household for rooms.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ClaimEntry {
    /// What the rooms are then: one of `roles`.
    pub(crate) role: String,
    /// How many rooms, at most; default 1.
    pub(crate) count: Option<i64>,
    /// Probability of the wish, 0 to 1; default 1.
    pub(crate) chance: Option<f64>,
    /// The numbers of rooms to sleep in, least and most, with which it holds; one number is the least.
    pub(crate) rooms: Option<Pair>,
    /// How many people each of these rooms adds to the household; default 0.
    pub(crate) persons: Option<i64>,
}
