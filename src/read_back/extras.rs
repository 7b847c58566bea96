//! The `extras` of nodes as they are read; [`crate::scene::Extras`] is how they are written.

use serde::Deserialize;
use serde_json::Value;

/// A corner in plan metres.
pub(super) type Corner = [f64; 2];

/// What a node is.
#[derive(Clone, Debug)]
pub(super) enum Extras {
    Level(LevelExtras),
    Opening(OpeningExtras),
    Room(RoomExtras),
    Part(PartExtras),
    Furniture(FurnitureExtras),
    /// Of the contract, but not readable; a problem says so.
    Broken,
}

#[derive(Clone, Debug, Deserialize)]
pub(super) struct LevelExtras {
    pub(super) building: String,
    pub(super) level: String,
    pub(super) elevation: f64,
    pub(super) height: f64,
    /// Left out by nobody; only comparisons ask.
    #[serde(default)]
    pub(super) seed: Value,
    #[serde(default)]
    pub(super) generator: Value,
    #[serde(default)]
    pub(super) site: Value,
}

#[derive(Clone, Debug, Deserialize)]
pub(super) struct OpeningExtras {
    pub(super) id: String,
    pub(super) closure: Closure,
    pub(super) width: f64,
    pub(super) height: f64,
    pub(super) sill: f64,
    pub(super) sides: Vec<SideExtras>,
    #[serde(default)]
    pub(super) leaves: Vec<LeafExtras>,
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Closure {
    Door,
    Sliding,
    Passage,
    Open,
    Window,
}

impl Closure {
    /// The word in the file.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Door => "door",
            Self::Sliding => "sliding",
            Self::Passage => "passage",
            Self::Open => "open",
            Self::Window => "window",
        }
    }

    pub(super) fn is_window(self) -> bool {
        matches!(self, Self::Window)
    }
}

#[derive(Clone, Debug, Deserialize)]
pub(super) struct SideExtras {
    pub(super) room: String,
    pub(super) wall: usize,
    pub(super) from: f64,
    pub(super) to: f64,
}

#[derive(Clone, Copy, Debug, Deserialize)]
pub(super) struct LeafExtras {
    pub(super) hinge: Corner,
    pub(super) closed: Corner,
    pub(super) open: Corner,
}

#[derive(Clone, Debug, Deserialize)]
pub(super) struct RoomExtras {
    pub(super) room: String,
    #[serde(rename = "type")]
    pub(super) room_type: String,
    pub(super) style: String,
    #[serde(deserialize_with = "seed")]
    pub(super) seed: u64,
    pub(super) outline: Vec<Corner>,
    pub(super) holes: Vec<Vec<Corner>>,
    pub(super) height: f64,
    pub(super) requested: u32,
    pub(super) removed: Vec<RemovedExtras>,
    /// What the bake found; a verdict of today does not ask.
    #[serde(default)]
    pub(super) findings: Value,
}

#[derive(Clone, Debug, Deserialize)]
pub(super) struct RemovedExtras {
    pub(super) class: String,
    pub(super) reason: String,
    #[serde(default)]
    pub(super) required: bool,
}

#[derive(Clone, Debug, Deserialize)]
pub(super) struct PartExtras {
    pub(super) id: String,
    #[serde(default)]
    pub(super) tags: Vec<String>,
    /// Of columns only.
    pub(super) outline: Option<Vec<Corner>>,
    /// Of columns only.
    pub(super) height: Option<f64>,
}

#[derive(Clone, Debug, Deserialize)]
pub(super) struct FurnitureExtras {
    pub(super) class: String,
    pub(super) id: String,
    pub(super) parent: String,
    pub(super) side: String,
    pub(super) size: [f64; 3],
    pub(super) variant: u32,
}

/// A seed: a text, or a number that somebody made of it.
fn seed<'de, D: serde::Deserializer<'de>>(deserializer: D) -> Result<u64, D::Error> {
    #[derive(Deserialize)]
    #[serde(untagged, expecting = "a seed is a whole number from 0 on")]
    enum Written {
        Number(u64),
        Text(String),
    }
    match Written::deserialize(deserializer)? {
        Written::Number(number) => Ok(number),
        Written::Text(text) => text.parse().map_err(serde::de::Error::custom),
    }
}

impl Extras {
    /// What a node's extras say; `None` where they are about something else.
    pub(super) fn parse(text: &str) -> Result<Option<Self>, String> {
        fn typed<T: serde::de::DeserializeOwned>(value: Value) -> Result<T, String> {
            serde_json::from_value(value).map_err(|error| error.to_string())
        }
        let value: Value = serde_json::from_str(text).map_err(|error| error.to_string())?;
        let kind = value.get("kind").and_then(Value::as_str).unwrap_or_default().to_owned();
        Ok(Some(match kind.as_str() {
            "level" => Self::Level(typed(value)?),
            "opening" => Self::Opening(typed(value)?),
            "room" => Self::Room(typed(value)?),
            "part" => Self::Part(typed(value)?),
            "furniture" => Self::Furniture(typed(value)?),
            _ => return Ok(None),
        }))
    }
}
