//! Ids of furniture, of room parts that carry furniture, and of openings.

use std::borrow::Cow;
use std::fmt;
use std::str::FromStr;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// A piece of furniture in its room: `desk.1`.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ObjectId {
    /// Id of its class.
    pub class: String,
    /// Counts the pieces of the class in the room, from 1.
    pub number: u32,
}

/// A variant of a class: `desk.3`.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct VariantId {
    /// Id of the class.
    pub class: String,
    /// Counts the variants of the class, from 0.
    pub number: u32,
}

impl fmt::Display for VariantId {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}.{}", self.class, self.number)
    }
}

/// A room by its ids.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct RoomId {
    /// Id of the building.
    pub building: String,
    /// Id of the level.
    pub level: String,
    /// Id of the room.
    pub room: String,
}

impl RoomId {
    /// The room of these ids.
    #[must_use]
    pub fn new(building: &str, level: &str, room: &str) -> Self {
        Self { building: building.to_owned(), level: level.to_owned(), room: room.to_owned() }
    }
}

impl fmt::Display for RoomId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}/{}", self.building, self.level, self.room)
    }
}

/// An element of a room as `parent`, findings, answers and edits name it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ElementId {
    /// `floor`.
    Floor,
    /// `ceiling`.
    Ceiling,
    /// `wall.<index>`: an index into the walls of the room.
    Wall(usize),
    /// `column.<index>`: an index into the columns of the room.
    Column(usize),
    /// `door:<id>`: any opening that people walk through.
    Door(String),
    /// `window:<id>`.
    Window(String),
    /// `<class>.<number>`.
    Object(ObjectId),
}

/// A text that is no id.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct IdProblem {
    text: String,
    /// What is wrong with it.
    fact: &'static str,
}

impl IdProblem {
    fn without_number(text: &str) -> Self {
        Self { text: text.to_owned(), fact: "ends in no number" }
    }
}

impl ObjectId {
    /// The piece of a class with a number.
    #[must_use]
    pub fn new(class: impl Into<String>, number: u32) -> Self {
        Self { class: class.into(), number }
    }
}

impl ElementId {
    /// The id of an opening.
    #[must_use]
    pub fn opening(id: &str, is_window: bool) -> Self {
        if is_window { Self::Window(id.to_owned()) } else { Self::Door(id.to_owned()) }
    }

    /// The kind of element: the word before the number or the id; for objects, the class.
    #[must_use]
    pub fn kind(&self) -> &str {
        match self {
            Self::Floor => "floor",
            Self::Ceiling => "ceiling",
            Self::Wall(_) => "wall",
            Self::Column(_) => "column",
            Self::Door(_) => "door",
            Self::Window(_) => "window",
            Self::Object(object) => &object.class,
        }
    }
}

impl fmt::Display for ObjectId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{}", self.class, self.number)
    }
}

impl fmt::Display for ElementId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Floor => f.write_str("floor"),
            Self::Ceiling => f.write_str("ceiling"),
            Self::Wall(index) => write!(f, "wall.{index}"),
            Self::Column(index) => write!(f, "column.{index}"),
            Self::Door(id) => write!(f, "door:{id}"),
            Self::Window(id) => write!(f, "window:{id}"),
            Self::Object(object) => object.fmt(f),
        }
    }
}

impl fmt::Display for IdProblem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the id \"{}\" {}", self.text, self.fact)
    }
}

impl std::error::Error for IdProblem {}

impl FromStr for RoomId {
    type Err = IdProblem;

    /// The room of a text as it is displayed: `house/ground/living`.
    fn from_str(text: &str) -> Result<Self, IdProblem> {
        let parts: Vec<&str> = text.split('/').collect();
        match parts[..] {
            [building, level, room] if parts.iter().all(|part| !part.is_empty()) => {
                Ok(Self::new(building, level, room))
            }
            _ => Err(IdProblem { text: text.to_owned(), fact: "is not BUILDING/LEVEL/ROOM" }),
        }
    }
}

impl FromStr for ObjectId {
    type Err = IdProblem;

    fn from_str(text: &str) -> Result<Self, IdProblem> {
        let (class, number) = split(text)?;
        let number = u32::try_from(number).ok().filter(|&number| number > 0);
        Ok(Self::new(class, number.ok_or_else(|| IdProblem::without_number(text))?))
    }
}

impl FromStr for ElementId {
    type Err = IdProblem;

    fn from_str(text: &str) -> Result<Self, IdProblem> {
        match text {
            "floor" => return Ok(Self::Floor),
            "ceiling" => return Ok(Self::Ceiling),
            _ => {}
        }
        if let Some(id) = text.strip_prefix("door:") {
            return Ok(Self::Door(id.to_owned()));
        }
        if let Some(id) = text.strip_prefix("window:") {
            return Ok(Self::Window(id.to_owned()));
        }
        Ok(match split(text)? {
            ("wall", index) => Self::Wall(index),
            ("column", index) => Self::Column(index),
            _ => Self::Object(text.parse()?),
        })
    }
}

/// The text before the last dot, and the number after it.
fn split(text: &str) -> Result<(&str, usize), IdProblem> {
    let parts = text.rsplit_once('.').filter(|(word, _)| !word.is_empty());
    let found = parts.and_then(|(word, number)| Some((word, number.parse().ok()?)));
    found.ok_or_else(|| IdProblem::without_number(text))
}

/// Ids are texts in every file.
macro_rules! as_text {
    ($name:ident, $description:literal) => {
        impl Serialize for $name {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.collect_str(self)
            }
        }

        impl<'de> Deserialize<'de> for $name {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                let text = Cow::<'_, str>::deserialize(deserializer)?;
                text.parse().map_err(serde::de::Error::custom)
            }
        }

        impl JsonSchema for $name {
            fn schema_name() -> Cow<'static, str> {
                stringify!($name).into()
            }

            fn json_schema(_: &mut SchemaGenerator) -> Schema {
                json_schema!({ "type": "string", "description": $description })
            }
        }
    };
}
pub(super) use as_text;

as_text!(ObjectId, "A piece of furniture in its room: `<class>.<number>`, counted from 1.");
as_text!(
    ElementId,
    "An element of a room: `floor`, `ceiling`, `wall.<index>`, `column.<index>`, `door:<id>`, `window:<id>` or \
     `<class>.<number>`."
);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_id_that_is_shown_is_parsed_as_the_same_id() {
        let ids = [
            ElementId::Floor,
            ElementId::Ceiling,
            ElementId::Wall(12),
            ElementId::Column(0),
            ElementId::Door("d.1:a@b".to_owned()),
            ElementId::Window(String::new()),
            ElementId::Object(ObjectId::new("reading_chair", 3)),
            ElementId::Object(ObjectId::new("odd.class", 1)),
        ];
        for id in ids {
            assert_eq!(id.to_string().parse(), Ok(id));
        }
    }

    #[test]
    fn an_id_without_a_number_is_refused() {
        for text in ["", "desk", "desk.", ".1", "desk.one", "desk.-1", "desk.0", "desk.99999999999"] {
            assert!(text.parse::<ElementId>().is_err(), "{text:?}");
            assert!(text.parse::<ObjectId>().is_err(), "{text:?}");
        }
    }
}
