//! Room types and styles: the pieces of a room, and their looks.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::building_style::Share;
use super::by_id::PaletteRef;
use super::class::{Class, ClassIndex};
use crate::plan::Home;
use crate::recipes::{GeometrySet, Slot};

/// A kind of room and its programme.
#[derive(Clone, Debug)]
pub struct RoomType {
    /// The word used in plans.
    pub id: String,
    /// A title for people.
    pub label: String,
    /// Whether it is furnished at all; shafts and stairs are not.
    pub is_furnished: bool,
    /// Whether people go from level to level in it: stairs, lifts.
    pub joins_levels: bool,
    /// The pieces of such a room, unless the style has a programme of its own.
    pub programme: Vec<Request>,
    /// Groups of classes that contradict it (`sleeping` in an office), sorted.
    pub excludes: Vec<String>,
    /// Square metres that such rooms usually have, least and most.
    pub area: (f64, f64),
    /// Sizes beyond which a plan is asked whether they are meant.
    pub plausible: Plausible,
    /// Lowest and highest share of the floor that furniture covers.
    pub density: (f64, f64),
    /// Material slots of floor, wall and ceiling.
    pub finish: Finish,
    /// Which rooms' furniture looks alike where no building style tells it.
    pub share: Share,
}

/// What rooms of a type may be without a question, least and most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plausible {
    /// Square metres of floor.
    pub area: (f64, f64),
    /// Metres from floor to ceiling.
    pub height: (f64, f64),
}

impl Default for Plausible {
    /// Whatever can be read.
    fn default() -> Self {
        Self { area: (0.0, f64::INFINITY), height: (0.0, f64::INFINITY) }
    }
}

/// Materials of the shell, and what is fitted to its walls.
#[derive(Clone, Debug, PartialEq)]
pub struct Finish {
    /// Material slot of the floor.
    pub floor: Slot,
    /// Material slot of the walls.
    pub wall: Slot,
    /// Another material on the lower part of the walls.
    pub dado: Option<Dado>,
    /// Material slot of the ceiling.
    pub ceiling: Slot,
    /// Metres of wall for each socket; none without sockets.
    pub sockets: Option<f64>,
    /// Whether light switches are beside its doors.
    pub has_switches: bool,
}

/// The lower part of walls.
#[derive(Clone, Debug, PartialEq)]
pub struct Dado {
    /// Material slot.
    pub slot: Slot,
    /// Metres above the floor up to which it reaches, above zero.
    pub height: f64,
}

/// One line of a programme.
#[derive(Clone, Debug, PartialEq)]
pub struct Request {
    /// One of these classes is drawn for each room; at least one.
    pub classes: Vec<ClassIndex>,
    /// What stands in, one after the other, for a piece that finds no place.
    pub substitutes: Vec<ClassIndex>,
    /// How many.
    pub count: Count,
    /// Square metres of floor between which the line applies.
    pub area: (f64, f64),
    /// Whether the room is wrong without it.
    pub is_required: bool,
    /// Probability that the line applies at all.
    pub chance: f64,
    /// Only where the room has a window.
    pub needs_window: bool,
    /// The people that it is for.
    pub for_whom: ForWhom,
}

/// The people that a line of a programme is for.
#[derive(Clone, Debug, PartialEq)]
pub struct ForWhom {
    /// Ids of households; empty for everybody.
    pub households: Vec<String>,
    /// The sizes of households, least and most. A room of no dwelling has nobody.
    pub persons: (u32, u32),
    /// Of a count by piece: so many seats more than people, and no more than that.
    pub guests: Option<u32>,
}

impl Default for ForWhom {
    /// Everybody and nobody.
    fn default() -> Self {
        Self { households: Vec::new(), persons: (0, u32::MAX), guests: None }
    }
}

impl ForWhom {
    /// Whether a room of a household, or of none, gets the line.
    #[must_use]
    pub fn includes(&self, home: Option<&Home>) -> bool {
        let persons = home.map_or(0, |home| home.persons);
        let is_named = |home: &Home| self.households.contains(&home.household);
        (self.persons.0..=self.persons.1).contains(&persons)
            && (self.households.is_empty() || home.is_some_and(is_named))
    }

    /// How many pieces of a line that counts by piece people have use for: an even number of seats.
    #[must_use]
    pub fn most(&self, home: Option<&Home>) -> Option<u32> {
        let (guests, home) = (self.guests?, home?);
        Some((home.persons + guests).max(home.bedrooms).next_multiple_of(2))
    }
}

impl Request {
    /// Whether it may bring a piece of a class into the room.
    #[must_use]
    pub fn asks_for(&self, class: ClassIndex) -> bool {
        self.classes.contains(&class) || self.substitutes.contains(&class)
    }
}

/// How many pieces a line asks for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Count {
    /// Exactly.
    Fixed(u32),
    /// At least, at most, drawn evenly.
    Range(u32, u32),
    /// Pieces per square metre of floor, then at least and at most.
    PerArea(f64, u32, u32),
    /// Pieces for each piece of another class that was asked for (four chairs a table).
    PerPiece(ClassIndex, f64),
    /// Pieces for each window of the room.
    PerWindow(f64),
    /// As many as fit, at most.
    Fill(u32),
    /// As many as fit, at most so many per square metre of floor, and at most.
    FillPerArea(f64, u32),
}

impl Count {
    /// Whether its pieces only fill what room is left and are not missed.
    #[must_use]
    pub fn is_fill(self) -> bool {
        matches!(self, Self::Fill(_) | Self::FillPerArea(..))
    }
}

/// A style, all inheritance resolved.
#[derive(Clone, Debug)]
pub struct Style {
    /// The word used in plans and on the command line.
    pub id: String,
    /// A title for people.
    pub label: String,
    /// Room types it is made for; empty for all.
    pub room_types: Vec<String>,
    /// Programmes that replace the room type's own, by room type.
    pub programmes: BTreeMap<String, Vec<Request>>,
    /// Lines added to the programme, by room type.
    pub additions: BTreeMap<String, Vec<Request>>,
    /// The shapes of its furniture.
    pub geometry: GeometrySet,
    /// The look of its materials.
    pub palette: PaletteRef,
    /// How untidy.
    pub untidiness: Untidiness,
    /// Factor on the counts of lines that are not required; 1 is as written.
    pub density: f64,
    /// The people who move about in its rooms.
    pub access: Access,
    /// When the furniture is from, if that matters.
    pub era: Option<Era>,
    /// The cost of its furniture, from [`WEALTH`], if that matters.
    pub wealth: Option<u32>,
}

/// Lowest and highest cost of furniture: 1 is cheap, 2 usual, 3 expensive.
pub const WEALTH: (u32, u32) = (1, 3);

/// How people move in a room.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Access {
    /// People who walk.
    #[default]
    Walking,
    /// People in wheelchairs too: they get everywhere by wide ways, and there is room to turn.
    Wheelchair,
}

/// When furniture was made.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Era {
    /// Before electric appliances.
    Historic,
    /// The middle of the twentieth century.
    Midcentury,
    /// Today.
    Contemporary,
}

impl Access {
    /// The word in configuration.
    #[must_use]
    pub fn word(self) -> &'static str {
        ["walking", "wheelchair"][self as usize]
    }
}

impl Era {
    /// The word in configuration.
    #[must_use]
    pub fn word(self) -> &'static str {
        ["historic", "midcentury", "contemporary"][self as usize]
    }
}

/// Random offsets that make a room look lived in (section 4.2).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Untidiness {
    /// Radians either way, added to a movable object's angle.
    pub turn: f64,
    /// Metres, added to a movable object's distance from its parent.
    pub distance: f64,
}

impl Style {
    /// Whether it is made for rooms of a type.
    #[must_use]
    pub fn suits(&self, room_type: &str) -> bool {
        self.room_types.is_empty() || self.room_types.iter().any(|one| one == room_type)
    }

    /// Those of some classes that go with the style's era and wealth, in their order. Classes made for these come before
    /// those that go with any; where a style names neither, those that go with any come before the others.
    #[must_use]
    pub fn fitting(&self, requested: &[ClassIndex], classes: &[Class]) -> Vec<ClassIndex> {
        let ranks = requested.iter().map(|&class| (self.fit(&classes[class]), class));
        let ranks: Vec<(u32, ClassIndex)> = ranks.filter(|(fit, _)| *fit > 0).collect();
        let best = ranks.iter().map(|(fit, _)| *fit).max();
        ranks.into_iter().filter(|(fit, _)| Some(*fit) == best).map(|(_, class)| class).collect()
    }

    /// How well a class goes with the era and wealth; 0 for not at all.
    fn fit(&self, class: &Class) -> u32 {
        let of_key = |has_key: bool, is_met: Option<bool>| match (has_key, is_met) {
            // What is for any stands between what is made for it and, in a style that does not say, what is special.
            (false, _) => 2,
            (true, Some(true)) => 3,
            (true, Some(false)) => 0,
            (true, None) => 1,
        };
        let era = of_key(!class.eras.is_empty(), self.era.map(|era| class.eras.contains(&era)));
        let is_within =
            |(least, most): (u32, u32)| self.wealth.map(|wealth| (least..=most).contains(&wealth));
        era * of_key(class.wealth.is_some(), class.wealth.and_then(is_within))
    }

    /// The programme of a room type in this style: the style's own or the room type's, then its additions.
    pub fn programme<'a>(&'a self, room_type: &'a RoomType) -> impl Iterator<Item = &'a Request> {
        let base = self.programmes.get(&room_type.id).unwrap_or(&room_type.programme);
        base.iter().chain(self.additions.get(&room_type.id).into_iter().flatten())
    }
}
