//! The files, as they are written and read. All lengths are metres in the frame of the level's plan: x east, y north, z up.

use std::collections::BTreeSet;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// For whom a mesh is: an upright cylinder.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Agent {
    /// Metres from its middle to its side.
    pub radius: f64,
    /// Metres from the floor to its top: what hangs higher is not in its way.
    pub height: f64,
    /// Metres that it climbs without noticing: what is lower is not in its way.
    pub step: f64,
}

/// The navigation mesh of a level: where the middle of an agent may be.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeshFile {
    /// Of this format: 1.
    pub version: u32,
    /// Id of the building.
    pub building: String,
    /// Id of the level.
    pub level: String,
    /// Metres of the floor above the building's zero; all corners are at this height.
    pub elevation: f64,
    /// For whom it is.
    pub agent: Agent,
    /// Places, east and north, which polygons name by their index.
    pub corners: Vec<[f64; 2]>,
    /// Convex, disjoint, and together all free floor but places of less than 0.02 m² that nothing leads to.
    pub polygons: Vec<MeshPolygon>,
    /// Where an agent gets from one polygon to another.
    pub portals: Vec<MeshPortal>,
    /// The rooms of the level, sorted as in the plan.
    pub rooms: Vec<MeshRoom>,
    /// Square metres of each island, the largest first: polygons of an island are reached from each other.
    pub islands: Vec<f64>,
}

/// A polygon of a mesh.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeshPolygon {
    /// Indices of its corners, counter-clockwise.
    pub corners: Vec<u32>,
    /// Where it lies.
    pub part: Part,
    /// Index of its island.
    pub island: u32,
}

/// The part of a level that a polygon lies in.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Part {
    /// A room, by its id.
    Room(String),
    /// The floor within a wall, in a door or passage, by the id of the opening.
    Opening(String),
}

/// A common border of two polygons.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeshPortal {
    /// Indices of the polygons.
    pub polygons: [u32; 2],
    /// Its ends: the left and the right one for who goes from the first polygon to the second.
    pub ends: [[f64; 2]; 2],
}

/// A room of a mesh.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeshRoom {
    /// Id of the room.
    pub id: String,
    /// Id of its room type.
    #[serde(rename = "type")]
    pub room_type: String,
    /// Square metres of the room.
    pub area: f64,
    /// Square metres of its polygons.
    pub free: f64,
    /// Whether stairs or a lift are in it, by which one gets to other levels.
    pub joins_levels: bool,
}

/// All levels of a folder.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct IndexFile {
    /// Of this format: 1.
    pub version: u32,
    /// The program that wrote the folder.
    pub generator: String,
    /// For whom the meshes are.
    pub agent: Agent,
    /// The levels, sorted by building and level.
    pub levels: Vec<IndexedMap>,
}

/// A level of a folder.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct IndexedMap {
    /// Id of the building.
    pub building: String,
    /// Id of the level.
    pub level: String,
    /// Metres of the floor above the building's zero.
    pub elevation: f64,
    /// Square metres of free floor, of all islands.
    pub free: f64,
    /// Number of islands.
    pub islands: u32,
    /// Rooms of which no floor belongs to the largest island.
    pub unreached: Vec<String>,
    /// Mesh, map and picture of the map.
    pub files: Vec<MapFile>,
}

/// A file of a level.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MapFile {
    /// Its path from the folder of the index, with `/`.
    pub path: String,
    /// Its length.
    pub bytes: u64,
    /// Its SHA-256, in hexadecimal digits.
    pub sha256: String,
}

impl MeshFile {
    /// Ids of the rooms of which no polygon is on the first island.
    pub(crate) fn unreached(&self) -> Vec<String> {
        let reached: BTreeSet<&Part> =
            self.polygons.iter().filter(|polygon| polygon.island == 0).map(|polygon| &polygon.part).collect();
        let rooms = self.rooms.iter().map(|room| room.id.clone());
        rooms.filter(|id| !reached.contains(&Part::Room(id.clone()))).collect()
    }
}
