//! Parts of the shell: of a room, or of an opening.

use std::fmt;
use std::str::FromStr;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::id::as_text;

/// The kinds of parts; the words are part of the output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Part {
    /// Of a room.
    Floor,
    /// Of a room.
    Ceiling,
    /// A wall of a room.
    Wall,
    /// All that never moves of a room but floor and ceiling, where parts are merged.
    Walls,
    /// The boards along the walls of a room.
    Skirting,
    /// A column in a room.
    Column,
    /// A socket on a wall.
    Socket,
    /// A light switch on a wall.
    Switch,
    /// Steps up to the next level, and the balustrade around those from below.
    Stairs,
    /// The floor below an opening.
    Threshold,
    /// Around a door or a window.
    Frame,
    /// A door's leaf, or a panel that slides.
    Leaf,
    /// The pane of a window.
    Glass,
    /// The board below a window.
    Sill,
}

impl Part {
    /// All kinds.
    pub const ALL: [Self; 14] = [
        Self::Floor,
        Self::Ceiling,
        Self::Wall,
        Self::Walls,
        Self::Skirting,
        Self::Column,
        Self::Socket,
        Self::Switch,
        Self::Stairs,
        Self::Threshold,
        Self::Frame,
        Self::Leaf,
        Self::Glass,
        Self::Sill,
    ];

    /// The word in files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Floor => "floor",
            Self::Ceiling => "ceiling",
            Self::Wall => "wall",
            Self::Walls => "walls",
            Self::Skirting => "skirting",
            Self::Column => "column",
            Self::Socket => "socket",
            Self::Switch => "switch",
            Self::Stairs => "stairs",
            Self::Threshold => "threshold",
            Self::Frame => "frame",
            Self::Leaf => "leaf",
            Self::Glass => "glass",
            Self::Sill => "sill",
        }
    }
}

/// A part in its room or opening: `floor`, `wall.2`, `leaf.1`, `socket.2.0`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct PartId {
    /// What it is.
    pub part: Part,
    /// The wall that it is on, for what walls have several of.
    pub wall: Option<usize>,
    /// Which of several.
    pub number: Option<usize>,
}

impl PartId {
    /// The only one of its room or opening.
    #[must_use]
    pub const fn only(part: Part) -> Self {
        Self { part, wall: None, number: None }
    }

    /// One of several.
    #[must_use]
    pub const fn numbered(part: Part, number: usize) -> Self {
        Self { part, wall: None, number: Some(number) }
    }

    /// One of several on a wall.
    #[must_use]
    pub const fn on_wall(part: Part, wall: usize, number: usize) -> Self {
        Self { part, wall: Some(wall), number: Some(number) }
    }
}

impl fmt::Display for PartId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.part.name())?;
        [self.wall, self.number].into_iter().flatten().try_for_each(|number| write!(f, ".{number}"))
    }
}

/// A text that names no part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PartProblem(String);

impl fmt::Display for PartProblem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the id \"{}\" names no part of a room or an opening", self.0)
    }
}

impl FromStr for PartId {
    type Err = PartProblem;

    fn from_str(text: &str) -> Result<Self, PartProblem> {
        let problem = || PartProblem(text.to_owned());
        let mut words = text.split('.');
        let word = words.next().unwrap_or_default();
        let part = Part::ALL.into_iter().find(|part| part.name() == word).ok_or_else(problem)?;
        let numbers: Result<Vec<usize>, _> = words.map(str::parse).collect();
        match numbers.map_err(|_| problem())?.as_slice() {
            [] => Ok(Self::only(part)),
            &[number] => Ok(Self::numbered(part, number)),
            &[wall, number] => Ok(Self::on_wall(part, wall, number)),
            _ => Err(problem()),
        }
    }
}

mod text {
    use std::borrow::Cow;

    use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    use super::{PartId, as_text};

    as_text!(
        PartId,
        "A part in its room or opening: `<part>`, `<part>.<number>` or `<part>.<wall>.<number>`."
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_that_is_shown_is_parsed_as_the_same_part() {
        for part in Part::ALL {
            assert_eq!(serde_json::to_value(part).unwrap(), part.name());
            for id in [PartId::only(part), PartId::numbered(part, 7), PartId::on_wall(part, 2, 0)] {
                assert_eq!(id.to_string().parse(), Ok(id));
            }
        }
        assert_eq!(PartId::on_wall(Part::Socket, 2, 0).to_string(), "socket.2.0");
    }

    #[test]
    fn unknown_words_are_no_parts() {
        for text in ["", "roof", "wall.x", "wall.", "wall.1.2.3"] {
            assert!(text.parse::<PartId>().is_err(), "{text:?}");
        }
    }
}
