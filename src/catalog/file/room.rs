//! The keys of `configs/rooms/*.yaml`.

use std::borrow::Cow;
use std::collections::BTreeMap;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;

use super::building_style::ShareWord;
use super::{FormatVersion, OneOrMany, Pair};
use crate::catalog::table::Extends;

/// Room types: what each kind of room holds.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "Room types")]
pub(crate) struct RoomFile {
    #[expect(dead_code, reason = "checked while reading")]
    pub(crate) version: FormatVersion,
    /// The room types by id: lower-case words joined by `_`.
    pub(crate) room_types: BTreeMap<String, RoomTypeEntry>,
}

/// A kind of room.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct RoomTypeEntry {
    /// A title for people; the id with spaces if absent.
    pub(crate) label: Option<String>,
    /// Another room type, whose keys are taken where this one has none. `finish` is merged key by key.
    pub(crate) extends: Option<String>,
    /// Whether it is only there to be extended; never inherited.
    #[serde(default, rename = "abstract")]
    pub(crate) is_abstract: bool,
    /// Whether it is furnished at all; default true.
    pub(crate) furnish: Option<bool>,
    /// Whether people go from level to level in it: stairs, lifts; default false.
    pub(crate) joins_levels: Option<bool>,
    /// Square metres that such rooms usually have; default [0, 1000000].
    pub(crate) area: Option<Pair>,
    /// The sizes of such rooms that cause no warning; merged key by key.
    pub(crate) plausible: Option<PlausibleEntry>,
    /// Lowest and highest share of the floor that furniture covers; default [0, 1].
    pub(crate) density: Option<Pair>,
    /// Classes and groups that contradict it.
    pub(crate) excludes: Option<OneOrMany<String>>,
    /// Material slots of the shell, and what is fitted to its walls.
    pub(crate) finish: Option<FinishEntry>,
    /// The rooms whose furniture looks alike if no building style says it; default `building`.
    pub(crate) share: Option<ShareWord>,
    /// The pieces of such a room, unless the style has a programme of its own.
    pub(crate) programme: Option<Vec<RequestEntry>>,
}

impl Extends for RoomTypeEntry {
    const KIND: &'static str = "room type";
    const TABLE: &'static str = "room_types";

    fn base(&self) -> Option<&str> {
        self.extends.as_deref()
    }
}

/// Sizes beyond which a plan is asked whether they are meant.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct PlausibleEntry {
    /// Square metres, least and most; default [0, 1000000].
    pub(crate) area: Option<Pair>,
    /// Metres from floor to ceiling, least and most; default [0, 50].
    pub(crate) height: Option<Pair>,
}

/// Material slots of the shell, and what is fitted to its walls.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct FinishEntry {
    /// Default `parquet`.
    pub(crate) floor: Option<String>,
    /// Default `plaster`.
    pub(crate) wall: Option<String>,
    /// Another material on the lower part of the walls; default none.
    pub(crate) dado: Option<DadoEntry>,
    /// Default `ceiling`.
    pub(crate) ceiling: Option<String>,
    /// Metres of wall for each socket; 0 for none; default 3.
    pub(crate) sockets: Option<f64>,
    /// Whether light switches are beside the doors; default true.
    pub(crate) switches: Option<bool>,
}

/// The lower part of the walls.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct DadoEntry {
    /// Its material slot.
    pub(crate) slot: String,
    /// Metres above the floor up to which it reaches, at most up to the ceiling; 0 for none where the room type it
    /// extends has one.
    pub(crate) height: f64,
}

/// One line of a programme.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct RequestEntry {
    /// A class or group, or several of which one is drawn for each room.
    pub(crate) class: OneOrMany<String>,
    /// Classes and groups that stand in, one after the other, where a piece of `class` finds no place. For a required
    /// piece, only where no arrangement of the room has a place for it.
    pub(crate) or: Option<OneOrMany<String>>,
    /// How many; default 1.
    pub(crate) count: Option<CountEntry>,
    /// Square metres of floor between which the line applies; one number is the least.
    pub(crate) area: Option<Pair>,
    /// Whether the room is wrong without it; default false.
    #[serde(default)]
    pub(crate) required: bool,
    /// Probability that the line applies at all, 0 to 1; default 1.
    pub(crate) chance: Option<f64>,
    /// Only where the room has a window; default false.
    #[serde(default)]
    pub(crate) window: bool,
    /// Only in dwellings of these households.
    pub(crate) household: Option<OneOrMany<String>>,
    /// Only where so many people live, least and most; one number is the least. Nobody lives in a room of no dwelling.
    pub(crate) persons: Option<Pair>,
}

/// How many pieces.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged)]
pub(crate) enum CountEntry {
    /// Exactly.
    Fixed(i64),
    /// At least, at most.
    Range([i64; 2]),
    /// Depending on the room.
    Fields(CountFields),
}

/// The long forms of a count: exactly one of `per`, `per_area`, `fill`, or the last two.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct CountFields {
    /// For each piece of this class.
    pub(crate) per: Option<String>,
    /// With `per`: how many for each.
    pub(crate) each: Option<f64>,
    /// With `per`: in a dwelling, at most so many more than people.
    pub(crate) guests: Option<i64>,
    /// Pieces per square metre.
    pub(crate) per_area: Option<f64>,
    /// With `per_area`: at least.
    pub(crate) least: Option<i64>,
    /// With `per_area`: at most.
    pub(crate) most: Option<i64>,
    /// As many as fit, at most this many; with `per_area`, at most so many per square metre too.
    pub(crate) fill: Option<i64>,
}

impl JsonSchema for CountEntry {
    fn schema_name() -> Cow<'static, str> {
        "Count".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "A number, [least, most], {per: class or window, each: n}, {per_area: n, least: n, most: n}, {fill: n} or {fill: n, per_area: n}.",
            "type": ["integer", "array", "object"],
            "items": {"type": "integer"},
            "minItems": 2,
            "maxItems": 2,
            "properties": {
                "per": {"type": "string", "description": "So many for each piece of this class that was asked for, or for each window of the room."},
                "each": {"type": "number", "description": "With per: how many for each piece; default 1."},
                "guests": {"type": "integer", "description": "With per, in a dwelling: no more than its people and so many guests, and a place for each bedroom."},
                "per_area": {"type": "number", "description": "Pieces per square metre of floor."},
                "least": {"type": "integer", "description": "With per_area: at least; default 0."},
                "most": {"type": "integer", "description": "With per_area: at most."},
                "fill": {"type": "integer", "description": "As many as fit, at most this many; with per_area, at most so many per square metre too."}
            },
            "additionalProperties": false
        })
    }
}
