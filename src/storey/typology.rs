//! What kinds of buildings there are, and what their rooms need: the content of `configs/typologies.yaml`.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Deserialize;

/// Kinds of buildings, and which of them a building of a map is.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "Typologies of buildings")]
pub struct Typologies {
    /// Version of the format: 1.
    pub version: u32,
    /// By room type: what rooms need where storeys are planned.
    #[serde(default)]
    pub rooms: BTreeMap<String, RoomNeeds>,
    /// By name: lists of programmes.
    #[serde(default)]
    pub programmes: BTreeMap<String, Vec<Programme>>,
    /// The kinds of buildings by name.
    #[serde(default)]
    pub typologies: BTreeMap<String, Typology>,
    /// By use: which kinds of buildings serve it, and words of maps that mean it.
    #[serde(default)]
    pub uses: BTreeMap<String, Use>,
    /// The use of buildings of which the map says none, the first rule that fits.
    #[serde(default)]
    pub unknown_use: Vec<UseRule>,
}

/// What rooms of a type need.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RoomNeeds {
    /// Metres of the smallest width.
    pub width: f64,
    /// Metres of width from which on it can be furnished without narrow places, up to the middles of its walls: a narrower one is taken
    /// where no other plan is better.
    #[serde(default)]
    pub good_width: Option<f64>,
    /// Whether it needs windows.
    #[serde(default)]
    pub light: Light,
    /// Room types that its door may lead to, the best first.
    #[serde(default)]
    pub doors: Vec<String>,
    /// Room types that it lies open to instead, without a wall between, if it borders on one.
    #[serde(default)]
    pub open_to: Vec<String>,
    /// Room types that the door of one of them leads to, where a dwelling has several on a level: a bath of one bedroom.
    #[serde(default)]
    pub suite_of: Vec<String>,
    /// Metres of the gate that vehicles come in by: it is where one has room behind it, opens outwards, and leaves one window to a
    /// small building.
    #[serde(default)]
    pub gate: Option<f64>,
    /// Whether people look along it, as in a church: the way in is at an end of its long axis, opposite to an apse if it has one, and
    /// no further door is at the other end.
    #[serde(default)]
    pub axial: bool,
    /// Whether people may walk through it to other rooms.
    #[serde(default)]
    pub passage: bool,
    /// Whether it may end before the outer wall where its row is deep: the room beside it has the rest.
    #[serde(default)]
    pub inner: bool,
}

/// Whether rooms need windows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Light {
    /// They are no rooms without.
    Required,
    /// They have windows where they lie at an outer wall.
    Welcome,
    /// They have none.
    #[default]
    None,
}

/// The rooms of a flat, a house's level or a storey of some area.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Programme {
    /// Square metres from which on it is taken; the list rises.
    pub from: f64,
    /// By room type: square metres of a room, or of each of several. All grow or shrink to fill what there is.
    pub rooms: BTreeMap<String, Areas>,
}

/// Square metres of one room or of several.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Areas {
    /// Of one room.
    One(f64),
    /// Of each of several.
    Several(Vec<f64>),
}

impl Areas {
    /// Square metres of each room.
    #[must_use]
    pub fn all(&self) -> &[f64] {
        match self {
            Self::One(area) => std::slice::from_ref(area),
            Self::Several(areas) => areas,
        }
    }
}

/// A kind of building.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Typology {
    /// A title for people.
    pub label: String,
    /// How its storeys are divided.
    pub plan: PlanKind,
    /// Metres from floor to floor.
    pub storey_height: f64,
    /// Metres of its outer walls.
    pub exterior: f64,
    /// Metres of its inner walls.
    pub interior: f64,
    /// Storeys where the map does not say, least and most.
    pub storeys: (u32, u32),
    /// Square metres of a storey, least and most.
    #[serde(default = "any")]
    pub area: (f64, f64),
    /// Square metres of a storey, least and most, with which people build it: beyond them it is drawn where no other kind fits.
    #[serde(default = "any")]
    pub usual_area: (f64, f64),
    /// Metres of depth, the largest disc that the outline holds, least and most.
    #[serde(default = "any")]
    pub depth: (f64, f64),
    /// Metres of its longer side, along most of its walls or across them, least and most.
    #[serde(default = "any")]
    pub length: (f64, f64),
    /// Storeys with which it is built, least and most.
    #[serde(default = "any_storeys")]
    pub levels: (u32, u32),
    /// Share of the outline with a neighbour wall to wall, least and most.
    #[serde(default = "any")]
    pub party: (f64, f64),
    /// Its weight among the kinds that fit.
    #[serde(default = "one")]
    pub weight: f64,
    /// Room type of the halls or corridors.
    #[serde(default)]
    pub hall: Option<String>,
    /// Metres of the width of halls or corridors.
    #[serde(default = "hall_width")]
    pub hall_width: f64,
    /// Room type of the rooms that fill it: the one room, the large one, or those along a corridor.
    #[serde(default)]
    pub main: Option<String>,
    /// Square metres of a part of an open storey at most, such as a fire compartment; larger ones are parted by walls, and so are those
    /// that are longer than two sides of a square of that size.
    #[serde(default)]
    pub compartment: Option<f64>,
    /// Room type that takes the place of flats on the ground floor, such as a shop.
    #[serde(default)]
    pub street_level: Option<String>,
    /// Room type of the room that people come into on the ground floor, along corridors: it takes the place of a room of the main type.
    #[serde(default)]
    pub entrance: Option<String>,
    /// Room type of wings in which no corridor has a place; without it, such buildings are planned in another way.
    #[serde(default)]
    pub open_wing: Option<String>,
    /// Share of buildings whose dwellings above the ground floor have balconies where there is open air for them.
    #[serde(default)]
    pub balconies: f64,
    /// By room type: weights of other rooms along the corridor.
    #[serde(default)]
    pub others: BTreeMap<String, f64>,
    /// Metres along the corridor of each room, least and most.
    #[serde(default)]
    pub module: Option<(f64, f64)>,
    /// Room types of which each storey has one, in dark places first.
    #[serde(default)]
    pub services: BTreeMap<String, f64>,
    /// Share of the floor that the rooms of a type have at least, which the people who are there need; where that is much, they
    /// are several, and open storeys have some in each of their parts.
    #[serde(default)]
    pub service_shares: BTreeMap<String, f64>,
    /// Name of the programmes of flats, or of the ground floor of a house.
    #[serde(default)]
    pub programme: Option<String>,
    /// Name of the programmes of the upper floors of a house.
    #[serde(default)]
    pub upper_programme: Option<String>,
    /// Square metres of a flat with its share of the stairs, or of a section with stairs of its own.
    #[serde(default)]
    pub section: Option<f64>,
}

/// Square metres of a small room up to which it is one: what is more becomes several.
const ONE_SERVICE: f64 = 24.0;
/// Rooms of a type that a floor has at most, whatever a share says.
const MOST_SERVICES: f64 = 12.0;

impl Typology {
    /// The small rooms of a floor of so many square metres, with theirs: first those that grow with it, which nobody goes without.
    pub(super) fn services_of(&self, floor: f64) -> Vec<(&str, f64)> {
        let fixed =
            self.services.iter().filter(|(room_type, _)| !self.service_shares.contains_key(*room_type));
        let fixed = fixed.map(|(room_type, area)| (room_type.as_str(), *area));
        self.shared_services_of(floor).into_iter().chain(fixed).collect()
    }

    /// Of these, those that grow with the floor.
    pub(super) fn shared_services_of(&self, floor: f64) -> Vec<(&str, f64)> {
        let rooms = self.service_shares.iter().flat_map(|(room_type, share)| {
            let least = self.services.get(room_type).copied().unwrap_or(0.0);
            let wanted = least.max(share * floor);
            let count = (wanted / ONE_SERVICE).ceil().clamp(1.0, MOST_SERVICES);
            std::iter::repeat_n((room_type.as_str(), wanted / count), count as usize)
        });
        rooms.filter(|(_, area)| *area > 0.0).collect()
    }
}

/// How storeys are divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum PlanKind {
    /// One room.
    OneRoom,
    /// One dwelling on all storeys, with stairs of its own.
    House,
    /// Flats at landings.
    Flats,
    /// Rooms along corridors.
    Corridor,
    /// Flats along corridors.
    CorridorFlats,
    /// One large room, with small ones at its back.
    Open,
}

/// A use of buildings.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Use {
    /// Words of maps that mean it, in small letters: `building=house` has the word `house`.
    #[serde(default)]
    pub words: Vec<String>,
    /// Names of the kinds of buildings that serve it.
    pub typologies: Vec<String>,
    /// Uses of which a further word of the map may say that it is one of them: a place of worship is a mosque where the religion says so.
    #[serde(default)]
    pub narrower: Vec<String>,
}

/// A guess of the use of a building.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UseRule {
    /// Square metres of the outline below which it holds.
    pub below: f64,
    /// The use.
    #[serde(rename = "use")]
    pub use_name: String,
    /// Uses that it may be instead, where no kind of the first has a sound plan, the likeliest first.
    #[serde(default)]
    pub otherwise: Vec<String>,
}

fn any() -> (f64, f64) {
    (0.0, f64::MAX)
}

fn any_storeys() -> (u32, u32) {
    (0, u32::MAX)
}

fn one() -> f64 {
    1.0
}

fn hall_width() -> f64 {
    1.2
}
