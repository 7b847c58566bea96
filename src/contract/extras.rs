//! The `extras` of nodes: the facts of a level, room, opening, part, object or light.

use std::borrow::Cow;

use schemars::JsonSchema;
use serde::de::{DeserializeOwned, Error};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::Value;

use super::id::{ElementId, ObjectId};
use super::part::{Part, PartId};

/// A corner in plan metres.
pub type Corner = [f64; 2];

/// A word of a list that later versions may add to.
pub type Word = Cow<'static, str>;

/// The `extras` of a node.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Extras {
    /// The root.
    Level(LevelExtras),
    /// A door, window, passage or open boundary.
    Opening(OpeningExtras),
    /// A room.
    Room(RoomExtras),
    /// Floor, ceiling, wall, or a piece of an opening.
    Part(PartExtras),
    /// The light of a lamp, a child of the lamp.
    Light(LightExtras),
    /// A piece of furniture.
    Furniture(FurnitureExtras),
}

/// The extras of a level.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LevelExtras {
    /// Building id.
    pub building: String,
    /// Level id.
    pub level: String,
    /// Metres above the building's zero.
    pub elevation: f64,
    /// Metres from floor to floor.
    pub height: f64,
    /// Seed of the run. Editors may give large numbers back as texts, or lose them.
    #[serde(default, deserialize_with = "seed_if_any")]
    #[schemars(with = "u64")]
    pub seed: Option<u64>,
    /// Program and version.
    #[serde(default)]
    pub generator: Word,
    /// Where the building stands, unless it stands at the site's origin; no node is moved by it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub site: Option<SiteExtras>,
}

/// Where a building stands, in plan axes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SiteExtras {
    /// Metres east and north of the site's origin.
    pub position: [f64; 2],
    /// Radians counter-clockwise.
    pub turn: f64,
}

/// The extras of an opening.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct OpeningExtras {
    /// Whether people walk through it.
    pub opening: OpeningWord,
    /// How it is closed.
    pub closure: Closure,
    /// Unique in the level; the node's name is `door:<id>` or `window:<id>`.
    pub id: String,
    /// Room ids.
    #[serde(default)]
    pub rooms: Vec<String>,
    /// Where it is in the walls of these rooms.
    pub sides: Vec<SideExtras>,
    /// Metres along the wall.
    pub width: f64,
    /// Metres from bottom to top.
    pub height: f64,
    /// Metres of the bottom above the floor.
    pub sill: f64,
    /// The leaves on hinges.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub leaves: Vec<LeafExtras>,
}

/// Whether people walk through an opening.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum OpeningWord {
    /// They do.
    Door,
    /// They do not.
    Window,
}

/// How an opening is closed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Closure {
    /// By leaves on hinges.
    Door,
    /// By panels that slide.
    Sliding,
    /// Not at all.
    Passage,
    /// Not at all, and it is as wide as the border of two rooms.
    Open,
    /// By glass.
    Window,
}

impl Closure {
    /// The word in the file.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Door => "door",
            Self::Sliding => "sliding",
            Self::Passage => "passage",
            Self::Open => "open",
            Self::Window => "window",
        }
    }
}

impl OpeningExtras {
    /// Its id in `parent` and in findings, and the name of its node.
    #[must_use]
    pub fn element(&self) -> ElementId {
        ElementId::opening(&self.id, self.closure == Closure::Window)
    }
}

/// Where an opening is in a wall of a room.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SideExtras {
    /// Room id.
    pub room: String,
    /// Number of the wall: `wall.<n>` of that room.
    pub wall: usize,
    /// Metres from the wall's start where it begins.
    pub from: f64,
    /// Metres from the wall's start where it ends.
    pub to: f64,
}

/// The sector a door leaf sweeps, as points in plan metres.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LeafExtras {
    /// The axis it turns around.
    pub hinge: Corner,
    /// Its free end when shut.
    pub closed: Corner,
    /// Its free end when fully open, as the leaf's node stands.
    pub open: Corner,
}

/// The extras of a room.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct RoomExtras {
    /// Room id.
    pub room: String,
    /// The room type by which it is furnished: that of the plan, or its role in its dwelling.
    #[serde(rename = "type")]
    pub room_type: String,
    /// Its type in the plan, where `type` is its role in its dwelling instead.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub planned_type: Option<String>,
    /// Who lives in its dwelling.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub household: Option<HouseholdExtras>,
    /// Style used.
    pub style: String,
    /// Seed that repeats the room; a text in the file, for most readers of JSON keep 53 bits of a number.
    #[serde(serialize_with = "as_text", deserialize_with = "seed")]
    #[schemars(with = "String", regex(pattern = "^[0-9]+$"))]
    pub seed: u64,
    /// Corners in plan metres, counter-clockwise, not closed.
    pub outline: Vec<Corner>,
    /// Corners of each hole.
    pub holes: Vec<Vec<Corner>>,
    /// Metres from floor to ceiling.
    pub height: f64,
    /// Pieces the programme asked for.
    pub requested: u32,
    /// Pieces that rest.
    #[serde(default)]
    pub placed: u32,
    /// Pieces that do not, each with its reason.
    pub removed: Vec<RemovedExtras>,
    /// The audit's grade: `none`, `minor` or `failed`.
    #[serde(default)]
    pub grade: Word,
    /// The audit's score from 0 to 1; none if no piece was requested.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub score: Option<f64>,
    /// The findings of the audit when the floor was baked. Findings that cannot be read are dropped: a new audit judges again.
    #[serde(default, deserialize_with = "or_default")]
    pub findings: Vec<FindingExtras>,
}

/// The people of a dwelling.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct HouseholdExtras {
    /// Household id.
    pub id: String,
    /// How many they are.
    pub persons: u32,
    /// The rooms of the dwelling in which somebody sleeps.
    pub bedrooms: u32,
}

/// A missing piece.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct RemovedExtras {
    /// Class id.
    pub class: String,
    /// Why.
    pub reason: Word,
    /// Whether the programme calls it required.
    #[serde(default)]
    pub required: bool,
}

/// The findings of the audit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FindingExtras {
    /// Its kind.
    pub code: Word,
    /// `given`, `minor` or `failed`.
    #[serde(default)]
    pub severity: Word,
    /// Ids of the elements concerned, sorted; a missing piece is named by its class.
    #[serde(default)]
    pub objects: Vec<String>,
    /// The measured value, in the unit of its kind.
    #[serde(default)]
    pub measured: f64,
    /// The threshold that it breaks, in the same unit.
    #[serde(default)]
    pub threshold: f64,
    /// Whether it was not searched further if the plan leaves another choice: the finding then counts as if it did.
    #[serde(default, skip_serializing_if = "is_false")]
    pub not_searched_further: bool,
}

/// The extras of a part.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PartExtras {
    /// The kind of part. `walls` shows all other parts of a room but floor and ceiling, where parts are merged.
    pub part: Part,
    /// Unique in its room or opening; what `parent` of an object names: `floor`, `wall.2`, `leaf.1`.
    pub id: PartId,
    /// The paper's tags.
    #[serde(default)]
    pub tags: Vec<String>,
    /// Of a column, its corners in plan metres, counter-clockwise, not closed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub outline: Option<Vec<Corner>>,
    /// Of a column, metres of its top above the floor.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub height: Option<f64>,
}

impl PartExtras {
    /// A part of which nothing but its id is known.
    #[must_use]
    pub fn of(id: PartId) -> Self {
        Self { part: id.part, id, tags: Vec::new(), outline: None, height: None }
    }
}

/// The extras of a lamp's light.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LightExtras {
    /// Luminous flux in lumens.
    pub lumens: f64,
    /// Colour temperature in kelvins.
    pub kelvin: f64,
}

/// The extras of a piece of furniture.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FurnitureExtras {
    /// Class id.
    pub class: String,
    /// Unique in the room.
    pub id: ObjectId,
    /// The object or the part of the room that it stands on or belongs to.
    pub parent: ElementId,
    /// The parent's side that it touches.
    pub side: Word,
    /// Width, depth, height in metres.
    pub size: [f64; 3],
    /// Variant number.
    pub variant: u32,
}

impl Extras {
    /// The extras in a text; `None` where they are about something else.
    ///
    /// # Errors
    /// Says what keeps extras of the contract from being read.
    pub fn parse(text: &str) -> Result<Option<Self>, String> {
        fn typed<T: DeserializeOwned>(value: Value) -> Result<T, String> {
            serde_json::from_value(value).map_err(|error| error.to_string())
        }
        let value: Value = serde_json::from_str(text).map_err(|error| error.to_string())?;
        let kind = value.get("kind").and_then(Value::as_str).unwrap_or_default().to_owned();
        Ok(Some(match kind.as_str() {
            "level" => Self::Level(typed(value)?),
            "opening" => Self::Opening(typed(value)?),
            "room" => Self::Room(typed(value)?),
            "part" => Self::Part(typed(value)?),
            "light" => Self::Light(typed(value)?),
            "furniture" => Self::Furniture(typed(value)?),
            _ => return Ok(None),
        }))
    }
}

/// A number as a text.
fn as_text<S: Serializer>(number: &u64, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(number)
}

/// A seed: a text, or a number that somebody made of it.
fn seed<'de, D: Deserializer<'de>>(deserializer: D) -> Result<u64, D::Error> {
    #[derive(Deserialize)]
    #[serde(untagged, expecting = "a seed is a whole number from 0 on")]
    enum Written {
        Number(u64),
        Text(String),
    }
    match Written::deserialize(deserializer)? {
        Written::Number(number) => Ok(number),
        Written::Text(text) => text.parse().map_err(D::Error::custom),
    }
}

/// As [`seed`]; none where it cannot be read.
fn seed_if_any<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<u64>, D::Error> {
    Ok(seed(Value::deserialize(deserializer)?).ok())
}

/// The value if it can be read, else nothing.
fn or_default<'de, T, D>(deserializer: D) -> Result<T, D::Error>
where
    T: DeserializeOwned + Default,
    D: Deserializer<'de>,
{
    Ok(serde_json::from_value(Value::deserialize(deserializer)?).unwrap_or_default())
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "the signature that serde asks for")]
fn is_false(word: &bool) -> bool {
    !word
}
