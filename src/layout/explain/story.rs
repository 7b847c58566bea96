//! The parts of an explanation.

use schemars::JsonSchema;
use serde::Serialize;

use crate::catalog::Side;

/// The explanation of a furnished room.
#[derive(Clone, Debug, Default, PartialEq, Serialize, JsonSchema)]
pub struct Explanation {
    /// How often the room was furnished; more than once where something important was missing.
    pub attempts: u32,
    /// Which of these attempts was kept, counted from 1.
    pub kept: u32,
    /// Why each object is where it is, in the order of [`crate::layout::Furnished::placements`].
    pub objects: Vec<ObjectStory>,
    /// Why each missing piece is missing, in the order of [`crate::layout::Furnished::removals`].
    pub missing: Vec<MissingStory>,
}

/// Why an object is where it is.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ObjectStory {
    /// `<class>.<number>`.
    pub id: String,
    /// The sum of the points of its wishes.
    pub score: f64,
    /// The points for and against its place.
    pub wishes: Vec<Wish>,
    /// How it was found.
    pub search: SearchStory,
}

/// Why a piece is missing.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MissingStory {
    /// `<class>.<number>` that it would have had.
    pub id: String,
    /// The word of its [`crate::layout::RemovalReason`].
    pub reason: &'static str,
    /// Whether the programme calls it required.
    pub is_required: bool,
    /// How it searched.
    pub search: SearchStory,
    /// The pieces along the walls, for pieces that go there.
    pub walls: Option<WallStory>,
    /// Objects that it could stand on or beside, and how full their sides are.
    pub parents: Vec<ParentStory>,
}

/// What stands along the walls in the end, looked at every tenth of a metre: the search itself tries only
/// stretches of wall that are long enough.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WallStory {
    /// Places that were looked at.
    pub places: u32,
    /// Why a piece cannot stand there, the most frequent reason first.
    pub refused: Vec<Refusal>,
}

/// A side of an object that could take a child.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ParentStory {
    /// Id of the object.
    pub id: String,
    /// The side.
    pub side: Side,
    /// Children that it has.
    pub taken: u32,
    /// Children that it has places for.
    pub places: u32,
}

/// Something that speaks for or against a place.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Wish {
    /// The word of the relation, or what is bad about the place.
    pub about: &'static str,
    /// The group or the classes that the wish is about; empty for what is bad.
    pub target: String,
    /// Whether it is met; what is bad never is.
    pub is_met: bool,
    /// The one thing that decides, if there is any: an object's id or a room part.
    pub decided_by: Option<String>,
    /// Metres to it; of `clear of`, to the nearest space where a leaf swings.
    pub distance: Option<f64>,
    /// Degrees between the object's front and the direction to it.
    pub angle: Option<f64>,
    /// Points for a wish that is met in full.
    pub weight: f64,
    /// Points for this place.
    pub points: f64,
}

/// The record of an agent's search.
#[derive(Clone, Debug, Default, PartialEq, Serialize, JsonSchema)]
pub struct SearchStory {
    /// How often it searched: once in each size that it tried, and again each time that it lost its parent.
    pub searches: u32,
    /// Places that it tried.
    pub places: u32,
    /// Whether it stood in the only way to something and was sent away.
    pub was_sent_away: bool,
    /// Whether it was pushed to where there is more room.
    pub was_pushed: bool,
    /// Refused places, the most frequent reason first.
    pub refused: Vec<Refusal>,
}

/// Places refused for one reason.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Refusal {
    /// The word of the [`crate::layout::RemovalReason`].
    pub reason: &'static str,
    /// How many.
    pub places: u32,
    /// The obstacles, the most frequent first; one place may have several.
    pub obstacles: Vec<ObstacleStory>,
}

/// Something that stood in the way.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct ObstacleStory {
    /// An object's id, a room part, or what is wrong.
    pub name: String,
    /// At how many of the refused places.
    pub places: u32,
}
