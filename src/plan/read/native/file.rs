//! The native format as it is written: `version: 1`.
//!
//! The comments of this file are the descriptions of `configs/schema/plan.schema.json`.

use std::collections::BTreeMap;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;

use super::units::LengthUnit;

/// The version of the format that this program reads and writes.
pub(crate) const VERSION: u32 = 1;

/// A floor plan of one building: levels, rooms, openings.
///
/// x points east, y north; lengths are in `units`, angles in degrees counter-clockwise.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "Roomwright plan")]
pub(crate) struct PlanFile {
    /// Version of the format: 1.
    pub(crate) version: u32,
    /// Id of the building, part of the output path and of every seed; the name of the file without its
    /// extension where absent.
    #[serde(default)]
    #[schemars(schema_with = "word")]
    pub(crate) id: Option<String>,
    /// A title for people.
    #[serde(default)]
    #[schemars(schema_with = "word")]
    pub(crate) name: Option<String>,
    /// The text by which the source of the plan asks to be named, such as `© OpenStreetMap contributors, ODbL 1.0`; it goes into
    /// the manifest.
    pub(crate) attribution: Option<String>,
    /// Unit of every length in this file; metres where absent.
    #[serde(default)]
    pub(crate) units: LengthUnit,
    /// Style of rooms that name none.
    pub(crate) style: Option<String>,
    /// Thickness of the walls.
    #[serde(default)]
    pub(crate) walls: WallThickness,
    /// The meaning of the outlines of rooms.
    #[serde(default)]
    pub(crate) outlines: OutlineWord,
    /// Rooms, or groups of rooms, that levels place many times, by name.
    #[serde(default)]
    pub(crate) prototypes: BTreeMap<String, Prototype>,
    /// The levels, lowest first.
    pub(crate) levels: Vec<LevelFile>,
}

/// Thickness of walls.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct WallThickness {
    /// Walls to the open air; 0.3 m where absent.
    pub(crate) exterior: Option<f64>,
    /// Walls between rooms whose outlines share an edge; 0.1 m where absent. Where outlines leave a gap, the
    /// gap is the wall.
    pub(crate) interior: Option<f64>,
}

/// The meaning of the outlines of rooms.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum OutlineWord {
    /// Inner faces of walls: the gaps between rooms are walls.
    #[default]
    Inner,
    /// Centre lines of walls: rooms share edges, and half a wall is taken from each.
    Center,
}

/// One storey, or several equal ones.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct LevelFile {
    /// Id of the level, unique in the building, the name of its output file. `{n}` stands for the level's
    /// number and is needed where `repeat` is above 1.
    #[schemars(schema_with = "word")]
    pub(crate) id: String,
    /// A title for people; may hold `{n}`.
    #[serde(default)]
    #[schemars(schema_with = "word")]
    pub(crate) name: Option<String>,
    /// Number of the level, or of the first of its repetitions: `{n}` in its own id, `{level}` in the ids of its
    /// rooms. Levels are counted from 0 where absent.
    pub(crate) number: Option<i64>,
    /// How many equal storeys follow one another; 1 where absent.
    #[schemars(range(min = 1))]
    pub(crate) repeat: Option<u32>,
    /// Height of the floor above the building's zero; on top of the level before where absent.
    pub(crate) elevation: Option<f64>,
    /// From floor to floor; 3 m where absent.
    pub(crate) height: Option<f64>,
    /// Style of rooms that name none.
    pub(crate) style: Option<String>,
    /// Household of rooms that name none.
    pub(crate) household: Option<String>,
    /// Rooms.
    #[serde(default)]
    pub(crate) rooms: Vec<RoomFile>,
    /// Doors, windows, passages and open boundaries.
    #[serde(default)]
    pub(crate) openings: Vec<OpeningFile>,
    /// Columns and other fixed bodies.
    #[serde(default)]
    pub(crate) columns: Vec<ColumnFile>,
    /// Outlines of railings: edges of rooms along them are railings instead of walls.
    #[serde(default)]
    pub(crate) railings: Vec<Vec<[f64; 2]>>,
    /// Prototypes placed on this level.
    #[serde(default)]
    pub(crate) place: Vec<PlaceFile>,
}

/// One room.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct RoomFile {
    /// Id of the room, unique in the level. `{level}` stands for the level's number. In a prototype `{id}` stands
    /// for the id of its place; an id without it is appended to that as in `101-bath`.
    #[schemars(schema_with = "word")]
    pub(crate) id: String,
    /// A title for people.
    #[serde(default)]
    #[schemars(schema_with = "word")]
    pub(crate) name: Option<String>,
    /// Room type of the catalogue: `bedroom`, `kitchen`, `office`...
    #[serde(rename = "type")]
    pub(crate) room_type: String,
    /// Corners as [x, y], in order around the room, either way round. Either this or `rectangle`.
    pub(crate) outline: Option<Vec<[f64; 2]>>,
    /// [x, y, width, depth] of a rectangle, x and y at its south-west corner. Its edges: 0 south, 1 east, 2 north,
    /// 3 west.
    pub(crate) rectangle: Option<[f64; 4]>,
    /// Outlines of what is cut out of the room.
    #[serde(default)]
    pub(crate) holes: Vec<Vec<[f64; 2]>>,
    /// From floor to ceiling; the level's height less a slab of 0.3 m where absent.
    pub(crate) height: Option<f64>,
    /// Style or building style of the catalogue.
    pub(crate) style: Option<String>,
    /// The flat or other unit that it is part of; rooms of a level with the same word belong together. A copy of a
    /// prototype is one of its own where absent.
    pub(crate) dwelling: Option<String>,
    /// Who lives in its dwelling: a household of the catalogue; drawn where absent.
    pub(crate) household: Option<String>,
    /// Number for the room's seed, unique in the level; made from the id where absent.
    pub(crate) number: Option<u32>,
    /// Properties of its walls.
    #[serde(default)]
    pub(crate) walls: Vec<WallFile>,
}

/// Properties of walls: tags, a railing.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct WallFile {
    /// Edges of the outline: edge 0 runs from corner 0 to corner 1.
    pub(crate) edge: OneOrMany<usize>,
    /// Names that classes of furniture ask for.
    #[serde(default)]
    pub(crate) tags: OneOrMany<String>,
    /// Whether a railing stands there instead of a wall.
    #[serde(default)]
    pub(crate) railing: bool,
}

/// A single value where a list may stand.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub(crate) enum OneOrMany<T> {
    /// A single value.
    One(T),
    /// A list.
    Many(Vec<T>),
}

impl<T> Default for OneOrMany<T> {
    fn default() -> Self {
        Self::Many(Vec::new())
    }
}

impl<T> OneOrMany<T> {
    /// The values.
    pub(crate) fn as_slice(&self) -> &[T] {
        match self {
            Self::One(value) => std::slice::from_ref(value),
            Self::Many(values) => values,
        }
    }
}

/// A hole in the walls: by `at: [x, y]`, or by `room`, `edge` and `at` as the distance along that edge.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct OpeningFile {
    /// Id of the opening, unique in the level; made from kind and order where absent.
    #[serde(default)]
    #[schemars(schema_with = "word")]
    pub(crate) id: Option<String>,
    /// The kind of closure.
    pub(crate) kind: OpeningWord,
    /// [x, y] of its middle, on or in the wall; or, with `room` and `edge`, the distance of its middle from the
    /// start of the edge, the middle of the edge where absent.
    pub(crate) at: Option<OpeningAt>,
    /// Direction of the wall as [x, y], of any length; that of the nearest wall where absent.
    pub(crate) along: Option<[f64; 2]>,
    /// The room whose edge it is on.
    #[serde(default)]
    #[schemars(schema_with = "word")]
    pub(crate) room: Option<String>,
    /// Edge of that room's outline.
    pub(crate) edge: Option<usize>,
    /// Ids of the rooms it joins, one or two; found by its place where absent.
    #[serde(default)]
    #[schemars(length(max = 2))]
    pub(crate) rooms: Vec<String>,
    /// Along the wall; 0.9 m for doors and passages, 1.2 m for windows, the shared edge for open boundaries where
    /// absent.
    pub(crate) width: Option<f64>,
    /// Height of its lower end above the floor; 0.9 m for windows, 0 for all others where absent.
    pub(crate) sill: Option<f64>,
    /// Height of its upper end above the floor; 2 m for doors and passages, 2.1 m for windows, the ceiling for open
    /// boundaries where absent.
    pub(crate) head: Option<f64>,
    /// From its lower to its upper end, in place of `head`.
    pub(crate) height: Option<f64>,
    /// On which side a door's leaf hangs, seen from the room it opens into.
    pub(crate) hinge: Option<HandWord>,
    /// Id of the room that a door's leaf opens into, or `outside`.
    #[serde(default)]
    #[schemars(schema_with = "word")]
    pub(crate) opens_into: Option<String>,
    /// Leaves of a door: 1 or 2, 0 for a frame without a leaf.
    #[schemars(range(max = 2))]
    pub(crate) leaves: Option<u32>,
    /// Angle that a leaf opens; 90 where absent.
    pub(crate) swing: Option<f64>,
}

/// The kind of closure of an opening.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum OpeningWord {
    /// A door with leaves on hinges.
    Door,
    /// A door that slides along its wall.
    SlidingDoor,
    /// A doorway without a leaf.
    Passage,
    /// No wall at all between two rooms.
    OpenBoundary,
    /// A window.
    Window,
}

/// Left or right.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum HandWord {
    /// Left.
    Left,
    /// Right.
    Right,
}

/// Where an opening is.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub(crate) enum OpeningAt {
    /// Distance of the middle from the start of the edge.
    Distance(f64),
    /// Middle of the opening.
    Point([f64; 2]),
}

/// A column or other fixed body: one of `outline`, `rectangle` and `disc`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ColumnFile {
    /// Corners as [x, y].
    pub(crate) outline: Option<Vec<[f64; 2]>>,
    /// [x, y, width, depth], x and y at the south-west corner.
    pub(crate) rectangle: Option<[f64; 4]>,
    /// A round column.
    pub(crate) disc: Option<DiscFile>,
    /// Height of its top above the floor; up to the ceiling where absent.
    pub(crate) height: Option<f64>,
}

/// A circle.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct DiscFile {
    /// Its middle.
    pub(crate) center: [f64; 2],
    /// Its diameter.
    pub(crate) diameter: f64,
}

/// A room or a group of rooms with their openings, described once in a frame of their own.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Prototype {
    /// The rooms.
    pub(crate) rooms: Vec<RoomFile>,
    /// Their openings. A room id that is none of the prototype's is one of the level.
    #[serde(default)]
    pub(crate) openings: Vec<OpeningFile>,
    /// Columns and other fixed bodies.
    #[serde(default)]
    pub(crate) columns: Vec<ColumnFile>,
}

/// A prototype placed once or in a row: mirrored first, then turned, then moved.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct PlaceFile {
    /// Name of the prototype.
    pub(crate) prototype: String,
    /// Where the prototype's origin goes.
    pub(crate) at: [f64; 2],
    /// Degrees counter-clockwise about the prototype's origin; 0 where absent.
    #[serde(default)]
    pub(crate) turn: f64,
    /// Whether left and right change sides: x becomes -x before it is turned.
    #[serde(default)]
    pub(crate) mirror: bool,
    /// Further copies in a row.
    pub(crate) repeat: Option<RepeatFile>,
    /// Id of each copy: `{n}` counts the copies, `{level}` is the level's number; `{n:02}` writes two digits.
    /// `<prototype>-{n}` where absent.
    #[serde(default)]
    #[schemars(schema_with = "word")]
    pub(crate) id: Option<String>,
    /// Number of the first copy; 1 where absent.
    pub(crate) first: Option<i64>,
}

/// A row of copies.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct RepeatFile {
    /// How many, the first included.
    #[schemars(range(min = 1))]
    pub(crate) count: u32,
    /// From one copy to the next as [x, y].
    pub(crate) step: [f64; 2],
    /// By how much the number grows from one copy to the next; 1 where absent, 2 numbers one side of a corridor.
    pub(crate) number_step: Option<i64>,
}

/// A text; a plain number will do.
fn word(_: &mut SchemaGenerator) -> Schema {
    json_schema!({"type": ["string", "integer", "null"]})
}
