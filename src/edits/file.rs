//! The format of edits files: `configs/schema/edits.schema.json`.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::catalog::Side;

/// The version that this program reads and writes.
pub(super) const VERSION: u32 = 1;

/// Changes by hand to the furnished rooms of a plan or project.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "Roomwright edits")]
pub struct EditsFile {
    /// Version of the format: 1.
    pub version: u32,
    /// The edits, room by room.
    pub edits: Vec<RoomEntry>,
}

/// The edits of one room.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RoomEntry {
    /// Id of the building; every building of the plan that has such a room where absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub building: Option<String>,
    /// Id of the level.
    pub level: String,
    /// Id of the room.
    pub room: String,
    /// Seed of the furniture in this room, in place of the run's.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seed: Option<u64>,
    /// The edits of objects, by their ids.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub objects: BTreeMap<String, ObjectEntry>,
}

/// The edit of one object. Without a key, that property stays as it is arranged.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ObjectEntry {
    /// Whether the object is added; its id names the class.
    #[serde(default, skip_serializing_if = "is_false")]
    pub add: bool,
    /// Whether it goes, with all that stands on it.
    #[serde(default, skip_serializing_if = "is_false")]
    pub remove: bool,
    /// Whether it stands at this place first and the other furniture is arranged around it.
    #[serde(default, skip_serializing_if = "is_false")]
    pub lock: bool,
    /// The class that it is of now.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub class: Option<String>,
    /// Its variant, counted from 0: size and look.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub variant: Option<u32>,
    /// Its parent: `floor`, `ceiling`, `wall.2`, `column.0`, `door:ID`, `window:ID`, or an object.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub parent: Option<String>,
    /// The side of that which it touches.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub side: Option<Side>,
    /// Metres of the middle of its underside: east, north and, if said, above the floor, in the frame of the level; for
    /// what stands on an object, in that object's frame: to its right, to its back, above its underside.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(length(min = 2, max = 3))]
    pub at: Option<Vec<f64>>,
    /// Degrees counter-clockwise from facing south; for what stands on an object, from facing as that does.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub turn: Option<f64>,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "the signature that serde asks for")]
fn is_false(flag: &bool) -> bool {
    !flag
}
