//! What a page may ask. A project answers all of it, a finished bake what can be said of files.

use std::sync::Arc;

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use crate::contract::RoomId;

/// Why a question has no answer.
#[derive(Debug)]
pub(crate) enum Refusal {
    /// There is no such thing.
    NotFound(String),
    /// The question makes no sense.
    Bad(String),
}

impl Refusal {
    /// The status of HTTP, and the fact.
    pub(super) fn told(self) -> (u16, String) {
        match self {
            Self::NotFound(error) => (404, error),
            Self::Bad(error) => (422, error),
        }
    }
}

/// Seed and style, which the page may change while the server runs.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Controls {
    /// Seed of the run; that of the project where none is said.
    pub(crate) seed: Option<u64>,
    /// Style of the run, likewise.
    pub(crate) style: Option<String>,
}

/// Where a page looks from: metres in the frame of the building, degrees, metres a second.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Look {
    pub(super) building: String,
    pub(super) level: String,
    pub(super) position: [f64; 2],
    #[serde(default)]
    pub(super) direction: [f64; 2],
    #[serde(default)]
    pub(super) velocity: [f64; 2],
    #[serde(default)]
    pub(super) fov: f64,
    pub(super) mode: Mode,
}

/// How a page looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Mode {
    /// As somebody who is there.
    Walk,
    /// From above, on all of a level.
    Orbit,
}

/// The rooms to draw, the most urgent first.
#[derive(Serialize)]
pub(crate) struct LookAnswer {
    pub(super) revision: u64,
    pub(super) rooms: Vec<ShownRoom>,
    /// Rooms that are not there yet.
    pub(super) waiting: usize,
}

/// A room to draw.
#[derive(Serialize)]
pub(super) struct ShownRoom {
    pub(super) building: String,
    pub(super) level: String,
    pub(super) room: String,
    /// Another word for another room.
    pub(super) version: String,
    pub(super) is_visible: bool,
}

/// An edit of an object; without an entry it is forgotten.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Edit {
    pub(super) building: String,
    pub(super) level: String,
    pub(super) room: String,
    pub(super) object: String,
    pub(super) entry: Option<Map<String, Value>>,
}

fn read_only<T>() -> Result<T, Refusal> {
    Err(Refusal::Bad("finished files are only looked at: view the plan to furnish and to edit".to_owned()))
}

/// Takes note of an event; `false` where nobody listens any more.
pub(crate) type Listener = Box<dyn Fn(&str) -> bool + Send>;

/// What answers a page.
pub(crate) trait Answers: Send + Sync {
    /// All buildings and levels.
    fn site(&self) -> Value;

    /// The rooms and openings of a level.
    ///
    /// # Errors
    /// If there is no such level.
    fn level(&self, building: &str, level: &str) -> Result<Value, Refusal>;

    /// A file that a room or level refers to.
    ///
    /// # Errors
    /// If none refers to it.
    fn shared(&self, path: &str) -> Result<Arc<Vec<u8>>, Refusal>;

    /// Tells a listener what changes from now on, as JSON.
    fn listen(&self, listener: Listener);

    /// The finished file of a level.
    ///
    /// # Errors
    /// If there is none.
    fn level_file(&self, building: &str, level: &str) -> Result<Vec<u8>, Refusal> {
        Err(Refusal::NotFound(format!("{building}/{level} is no finished file: its rooms come one by one")))
    }

    /// Looks around.
    ///
    /// # Errors
    /// If there is no such level.
    fn look(&self, _: &Look) -> Result<LookAnswer, Refusal> {
        read_only()
    }

    /// A room as a binary glTF file.
    ///
    /// # Errors
    /// If it is not there.
    fn room(&self, _: &RoomId) -> Result<Vec<u8>, Refusal> {
        read_only()
    }

    /// Why each piece of a room stands where it is.
    ///
    /// # Errors
    /// If there is no such room.
    fn explain(&self, _: &RoomId) -> Result<Value, Refusal> {
        read_only()
    }

    /// The edits of a building that are in force, as edits files write them.
    fn edits(&self, _: &str) -> Value {
        serde_json::json!({"rooms": []})
    }

    /// Changes the edit of an object.
    ///
    /// # Errors
    /// If it cannot be made or kept.
    fn edit(&self, _: &Edit) -> Result<Value, Refusal> {
        read_only()
    }

    /// Gives a room the next seed.
    ///
    /// # Errors
    /// If it cannot be kept.
    fn reroll(&self, _: &RoomId) -> Result<Value, Refusal> {
        read_only()
    }

    /// Furnishes with another seed or style from now on.
    ///
    /// # Errors
    /// If there is no such style.
    fn set_controls(&self, _: Controls) -> Result<Value, Refusal> {
        read_only()
    }
}
