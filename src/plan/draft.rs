//! A level as a reader found it: points and words, not checked yet.
//!
//! Every reader fills a [`LevelDraft`]; `assemble` turns it into a [`super::Level`], so that attachment,
//! wall thickness and corner cleaning are written once for all formats.
//!
//! A reader hands over:
//! - lengths in metres, angles in radians; x east, y north, in one frame for all levels of a building. Heights
//!   of openings, columns and ceilings are above the floor of their level. Where the frame is on the site is said beside the draft
//!   (`placement` of the `DraftedBuilding`);
//! - coordinates near the origin: beyond 100 km no part is read (`limits::COORDINATE`), and digits are lost long before. Those of a
//!   country are moved with `read/recentred.rs`;
//! - room types that exist. Those of `RoomWords` do; any other word is not checked for foreign formats, and its room stays empty;
//! - levels from the lowest up, without those that have no room.
//!
//! All else is checked when drafts are put together. What is wrong is reported by level and id, without a line; in files of foreign
//! formats as a warning, unless no building can be so. It leaves out:
//! - of levels with one id the later ones, and levels of which no drafted room can be read;
//! - rooms without an id, and of rooms with one id the later ones; outlines of fewer than three corners, that cross themselves, or
//!   are not finite, too far, too fine or slivers; rooms too large, too high or kilometres from the others; those behind the first
//!   `limits::LEVEL_ROOMS`;
//! - openings without an id, and of those with one id the later ones; those that name a room that the level lacks or that was left
//!   out, or more than two; those too narrow, too wide or not upright, on no wall, or in the place of another; those behind the
//!   first `limits::LEVEL_OPENINGS`;
//! - columns with unsound outlines, without height, or in no room.
//!
//! It mends:
//! - height, elevation and thicknesses of a level beyond their limits, and ceilings below 1 m: usual values are taken;
//! - numbers of rooms that are used twice: the later room gets another;
//! - ids of foreign files that no native plan takes, as with `/`, empty or too long (`read/fit_ids.rs`);
//! - closing points, repeated corners, spikes and corners on straight lines of outlines, in silence; unsound holes, which are
//!   filled; rooms upon each other, as [`LevelDraft::rooms`] says;
//! - windows along several walls, which become several; leaves into a room on neither side, whose side is chosen.
//!
//! Nothing checks `limits::BUILDING_LEVELS` and `limits::BUILDING_ROOMS`, which a file that repeats levels may exceed.

use std::collections::BTreeSet;

use crate::geometry::Point;

use super::building::OpeningKind;

/// One building before checking.
#[derive(Clone, Debug, Default)]
pub struct BuildingDraft {
    /// A title for people, if the plan has one.
    pub name: Option<String>,
    /// The text by which the source of the plan asks to be named, if it does.
    pub attribution: Option<String>,
    /// The family of buildings (`families` in `room_words.yaml`) by which rooms without a known word are guessed where no word and no
    /// fixture of the building tells another: `home` for a program that draws homes.
    pub usual_family: Option<&'static str>,
    /// The storeys, lowest first as far as the plan says: nothing sorts them, and guesses take the neighbours in the list for the
    /// storeys below and above. A building without any is left out, without a message; one that loses all is left out as well.
    pub levels: Vec<LevelDraft>,
}

/// One storey before checking. It has no outline of its own: a wall with no room within 0.6 m behind most of it is exterior.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LevelDraft {
    /// Unique in the building: it names the file of the level. `UniqueIds` of `read/foreign.rs` makes such ids of any texts.
    pub id: String,
    /// A title for people; the id if empty.
    pub name: String,
    /// Metres above the building's zero. It is not compared with the heights of other levels: storeys may overlap or leave gaps.
    pub elevation: f64,
    /// Metres from floor to floor: the clear height of the rooms and the slab above them. 1 to 100 m.
    pub height: f64,
    /// Metres of walls to the open air.
    pub exterior_thickness: f64,
    /// Metres of walls between rooms whose outlines share an edge.
    pub interior_thickness: f64,
    /// The meaning of the room outlines.
    pub outlines: OutlineKind,
    /// The rooms. One that is drawn inside another is cut out of it with a warning; others that overlap stay, with a warning.
    pub rooms: Vec<RoomDraft>,
    /// The openings.
    pub openings: Vec<OpeningDraft>,
    /// Columns, given to the rooms they stand in.
    pub obstacles: Vec<ObstacleDraft>,
    /// Railings as outlines; room edges along them become railings.
    pub railings: Vec<Vec<Point>>,
    /// Outlines of solid walls, where the format draws them. If there are any, room edges that touch none
    /// of them and face another room within a step are open boundaries.
    pub wall_outlines: Vec<Vec<Point>>,
}

/// The meaning of the outlines of rooms.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum OutlineKind {
    /// Inner faces: walls fill the gaps between rooms.
    #[default]
    Inner,
    /// Centre lines: rooms share edges, and half of `interior_thickness` is taken from each. Edges without a neighbour stay where
    /// they are, and their walls grow outwards. Rooms more than 3 cm apart share no edge: the gap is their wall, as with `Inner`.
    Center,
}

/// One room before checking.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RoomDraft {
    /// Unique in the level, not empty, without `/`; `UniqueIds` of `read/foreign.rs` makes such ids of any texts.
    pub id: String,
    /// Number for the seed, unique in the level; made from the order if absent, so that a room that is added changes those behind
    /// it. `number_rooms` of `read/foreign.rs` makes it from the id.
    pub number: Option<u32>,
    /// A title for people.
    pub name: Option<String>,
    /// Id of a room type.
    pub room_type: String,
    /// The plan's word for it, if no type is known for that word: then the type is guessed.
    pub unknown_word: Option<String>,
    /// Kinds of fixtures that the plan draws in it, in small letters: guesses rest on them if its word is unknown.
    pub fixtures: BTreeSet<String>,
    /// Id of a style or building style.
    pub style: Option<String>,
    /// The flat or other unit that it is part of, if the plan says: equal for rooms of a level that belong together.
    pub dwelling: Option<String>,
    /// Id of the household of its dwelling, if the plan asks for one.
    pub household: Option<String>,
    /// Corners as found, in either direction; a last one that repeats the first is dropped.
    pub outline: Vec<Point>,
    /// Corners of each hole as found.
    pub holes: Vec<Vec<Point>>,
    /// Metres from floor to ceiling, the clear height; the level's height less a slab of 0.3 m if absent. It may exceed the level's
    /// height, as that of halls does.
    pub height: Option<f64>,
    /// Tags by edge: edge `i` runs from corner `i` to corner `i + 1` of `outline` as found.
    pub edge_tags: Vec<(usize, String)>,
}

/// One opening before checking.
#[derive(Clone, Debug, PartialEq)]
pub struct OpeningDraft {
    /// Unique in the level, not empty, without `/`.
    pub id: String,
    /// The kind of closure: `Door`, `SlidingDoor`, `Passage`, `Window`, or `OpenBoundary` where there is no wall, whose width is cut
    /// to the edge that its rooms share.
    pub kind: OpeningKind,
    /// Where it is.
    pub place: OpeningPlace,
    /// Ids of the rooms it joins, as the draft has them, if the plan names them: none, one or two. Two must face each other at its
    /// place, and it joins them; one must have a wall there, and what is behind is found by geometry; of none both sides are.
    pub rooms: Vec<String>,
    /// Metres along the wall.
    pub width: f64,
    /// Metres above the floor where it begins.
    pub bottom: f64,
    /// Metres above the floor where it ends; cut off at the lower ceiling of its rooms.
    pub top: f64,
    /// How its leaves turn; ignored for what has none.
    pub leaf: LeafDraft,
}

/// Where an opening is.
#[derive(Clone, Debug, PartialEq)]
pub enum OpeningPlace {
    /// In the level's frame.
    Points {
        /// Middle of the opening, in the wall or on a face of it: 0.3 m inside a room and 0.6 m behind its wall's face at most.
        center: Point,
        /// Direction along the wall, any length above zero, up to 15° askew; `None` takes that of the nearest wall within 1 m.
        along: Option<Point>,
    },
    /// On an edge of the first room it names.
    Edge {
        /// Edge of the outline as found: from corner `edge` to the next.
        edge: usize,
        /// Metres from the edge's start to the middle of the opening.
        at: f64,
    },
}

/// How the leaves of a door turn.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum LeafDraft {
    /// One leaf, hinge and side chosen: into the room that is no corridor, hinge at the end nearer a corner.
    #[default]
    Automatic,
    /// No leaf.
    None,
    /// As drawn.
    Points(Vec<super::building::Leaf>),
    /// One or two leaves.
    Swing {
        /// Hinge at the left end, seen from the room that the leaf opens into (ignored for two leaves).
        hinge_left: bool,
        /// Id of the room that it opens into; `None` opens to the open air.
        into: Option<String>,
        /// One or two.
        count: u32,
        /// Radians it opens.
        angle: f64,
    },
}

/// A column before checking.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ObstacleDraft {
    /// Corners as found.
    pub outline: Vec<Point>,
    /// Metres of its top above the floor; up to the ceiling if absent.
    pub height: Option<f64>,
}

/// Something wrong or doubtful in a draft. It is reported with the file: of a native plan at its line, of any other with the id of
/// its level and without a line, so that a reader of such a file itself reports what should have its line.
#[derive(Clone, Debug, PartialEq)]
pub struct Problem {
    /// Its subject.
    pub subject: Subject,
    /// The fact, with the value.
    pub message: String,
    /// Advice for the user.
    pub hint: Option<String>,
    /// Whether the subject was left out.
    pub is_error: bool,
    /// Whether no building can be so, whatever a drawing leaves open: an error in files of every format.
    pub is_impossible: bool,
}

/// The subject of a [`Problem`], as an index into the draft's lists.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// The level itself.
    Level,
    /// A room.
    Room(usize),
    /// A corner of a room's outline.
    RoomCorner(usize, usize),
    /// A hole of a room.
    Hole(usize, usize),
    /// An opening.
    Opening(usize),
    /// A column.
    Obstacle(usize),
}
