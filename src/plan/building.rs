//! A checked building: what every later stage works on.

use std::path::PathBuf;
use std::sync::Arc;

use super::shared::Shared;
use super::stairs::Stairs;
use crate::geometry::{Point, Polygon, Region, Segment};

/// All buildings of one run, in the order in which they were named.
#[derive(Clone, Debug, Default)]
pub struct Plan {
    /// The buildings; ids are unique.
    pub buildings: Vec<PlacedBuilding>,
}

/// One building of a city. A hundred equal hotels share one [`Building`].
#[derive(Clone, Debug)]
pub struct PlacedBuilding {
    /// Unique in the plan; part of every seed and of the output path.
    pub id: String,
    /// Where the building's own origin stands on the site.
    pub site: SitePlacement,
    /// The building itself, in its own frame.
    pub building: Arc<Building>,
    /// The files that say so.
    pub source: Arc<PlanSource>,
}

/// Where a building is written.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct PlanSource {
    /// The plan: a file, or a folder of a foreign format.
    pub plan: PathBuf,
    /// The project that places it, if one does.
    pub project: Option<PathBuf>,
    /// Whether the project exchanges east and west.
    pub is_mirrored: bool,
}

/// Where a building stands: its own frame is turned, then moved. Recorded in the manifest and the level's
/// extras; the geometry of a level stays in the building's frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SitePlacement {
    /// Metres east and north of the site's origin.
    pub position: Point,
    /// Radians counter-clockwise.
    pub turn: f64,
}

/// A building's levels, lowest first as far as the plan says.
#[derive(Clone, Debug)]
pub struct Building {
    /// A title for people, if the plan has one.
    pub name: Option<String>,
    /// The text by which the source of the plan asks to be named, if it does.
    pub attribution: Option<String>,
    /// The levels; ids are unique in the building.
    pub levels: Vec<Level>,
}

/// One storey, complete: rooms, openings, all references resolved to indices.
#[derive(Clone, Debug)]
pub struct Level {
    /// Unique in the building; the file name of the output.
    pub id: String,
    /// A title for people; the id where the plan has none.
    pub name: String,
    /// Metres of the floor above the building's zero.
    pub elevation: f64,
    /// Metres from floor to floor.
    pub height: f64,
    /// The rooms; ids are unique in the level.
    pub rooms: Shared<Room>,
    /// Doors, windows, passages and open boundaries; ids are unique in the level.
    pub openings: Shared<Opening>,
    /// The steps that lead up from here and come up to here, by room; of rooms of stairs that stand on each other.
    pub stairs: Shared<Stairs>,
    /// Faulty parts of the plan that the level lacks, in words; empty where nothing was left out.
    pub left_out: Vec<String>,
    /// SHA-256 of everything above but `left_out`: equal for equal levels, whatever file they came from.
    pub digest: [u8; 32],
}

/// One room, its walls and what stands in it by the architect's will.
#[derive(Clone, Debug)]
pub struct Room {
    /// Unique in the level.
    pub id: String,
    /// The room's number for its seed; unique in the level.
    pub number: u32,
    /// A title for people, if the plan has one.
    pub name: Option<String>,
    /// Id of a room type of the catalogue.
    pub room_type: String,
    /// Id of a style or building style of the catalogue, if the plan asks for one.
    pub style: Option<String>,
    /// The flat or other unit that it is part of, if the plan says: equal for rooms of a level that belong together.
    pub dwelling: Option<String>,
    /// Id of the household of its dwelling, if the plan asks for one.
    pub household: Option<String>,
    /// Who lives in its dwelling. Plans do not say it: `dwelling::Occupancy` does, and finished files.
    pub home: Option<Home>,
    /// The free floor between the inner faces of the walls.
    pub region: Region,
    /// Metres from floor to ceiling.
    pub height: f64,
    /// One per border of `region`, in the order of [`Region::borders`].
    pub walls: Vec<Wall>,
    /// Columns and other fixed bodies inside the outline.
    pub obstacles: Vec<Obstacle>,
    /// The openings in this room's walls, by wall, then along it.
    pub openings: Vec<RoomOpening>,
}

/// The people that a room is furnished for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Home {
    /// Id of their household.
    pub household: String,
    /// How many they are.
    pub persons: u32,
    /// The rooms of their dwelling in which somebody sleeps.
    pub bedrooms: u32,
    /// The room's type in the plan, where [`Room::room_type`] is the role that it has in the dwelling instead.
    pub planned_type: Option<String>,
}

/// One straight wall of a room, with the room on its left.
#[derive(Clone, Debug, PartialEq)]
pub struct Wall {
    /// Start of the inner face.
    pub start: Point,
    /// End of the inner face.
    pub end: Point,
    /// Metres of material behind the inner face that belong to this room: half of the wall to a
    /// neighbour, all of an outer wall; zero where the plan's walls have no thickness.
    pub thickness: f64,
    /// Whether open air lies behind.
    pub is_exterior: bool,
    /// The structure on the edge.
    pub kind: WallKind,
    /// Names that classes ask for (the paper's section 4), sorted.
    pub tags: Vec<String>,
}

/// The tag of walls with water pipes in them.
pub const PIPES_TAG: &str = "pipes";

/// The structure on an edge of a room.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WallKind {
    /// A wall up to the ceiling.
    Solid,
    /// A railing or parapet; metres above the floor.
    Railing(f64),
}

impl Level {
    /// What leads up and down in a room, by its index.
    #[must_use]
    pub fn stairs_of(&self, room: usize) -> Option<&Stairs> {
        let found = self.stairs.binary_search_by_key(&room, |stairs| stairs.room);
        found.ok().map(|index| &self.stairs[index])
    }

    /// A level of rooms without openings, at the building's zero; rooms are numbered in their order. Metres.
    #[must_use]
    pub fn bare(id: &str, height: f64, mut rooms: Vec<Room>) -> Self {
        for (number, room) in (1..).zip(&mut rooms) {
            room.number = number;
        }
        Self {
            id: id.to_owned(),
            name: id.to_owned(),
            elevation: 0.0,
            height,
            rooms: rooms.into(),
            openings: Shared::default(),
            stairs: Shared::default(),
            left_out: Vec::new(),
            digest: [0; 32],
        }
    }
}

impl Room {
    /// A room with a solid wall of one thickness on each border, and nothing else. Metres.
    #[must_use]
    pub fn bare(id: &str, room_type: &str, region: Region, height: f64, thickness: f64) -> Self {
        let wall = |Segment { start, end }| Wall {
            start,
            end,
            thickness,
            is_exterior: false,
            kind: WallKind::Solid,
            tags: Vec::new(),
        };
        Self {
            id: id.to_owned(),
            number: 1,
            name: None,
            room_type: room_type.to_owned(),
            style: None,
            dwelling: None,
            household: None,
            home: None,
            walls: region.borders().map(wall).collect(),
            region,
            height,
            obstacles: Vec::new(),
            openings: Vec::new(),
        }
    }
}

impl Wall {
    /// Walls around an outline, for tests.
    #[cfg(test)]
    pub(crate) fn around(corners: &[(f64, f64)]) -> Vec<Self> {
        let point = |index: usize| Point::new(corners[index].0, corners[index].1);
        let wall = |index: usize| Self {
            start: point(index),
            end: point((index + 1) % corners.len()),
            thickness: 0.1,
            is_exterior: false,
            kind: WallKind::Solid,
            tags: Vec::new(),
        };
        (0..corners.len()).map(wall).collect()
    }

    /// Its inner face, seen from above.
    #[must_use]
    pub fn segment(&self) -> Segment {
        Segment::new(self.start, self.end)
    }

    /// Metres from start to end.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.start.distance(self.end)
    }

    /// Unit vector from start to end.
    #[must_use]
    pub fn direction(&self) -> Point {
        (self.end - self.start).normalize()
    }

    /// The point of its inner face so many metres after its start.
    #[must_use]
    pub fn after(&self, metres: f64) -> Point {
        self.segment().after(metres)
    }

    /// The stretch of its inner face between two distances from its start, in metres: that of an opening of the room
    /// ([`RoomOpening::from`] and [`RoomOpening::to`]), say.
    #[must_use]
    pub fn stretch(&self, from: f64, to: f64) -> Segment {
        Segment::new(self.after(from), self.after(to))
    }

    /// Unit vector into the room.
    #[must_use]
    pub fn normal(&self) -> Point {
        self.direction().perp()
    }
}

/// A column, chimney or other fixed body.
#[derive(Clone, Debug, PartialEq)]
pub struct Obstacle {
    /// Its footprint in the level's frame.
    pub outline: Polygon,
    /// Metres of its top above the floor.
    pub height: f64,
}

/// A hole in the walls of a level.
#[derive(Clone, Debug, PartialEq)]
pub struct Opening {
    /// Unique in the level.
    pub id: String,
    /// The kind of closure.
    pub kind: OpeningKind,
    /// Middle of the opening, halfway through the wall.
    pub center: Point,
    /// Unit vector along the wall.
    pub along: Point,
    /// Metres along the wall.
    pub width: f64,
    /// Metres above the floor where it begins: zero for doors, the sill of a window.
    pub bottom: f64,
    /// Metres above the floor where it ends: the head.
    pub top: f64,
    /// The leaves of a hinged door: none, one or two.
    pub leaves: Vec<Leaf>,
    /// The rooms it joins: one (to the open air) or two.
    pub sides: Vec<OpeningSide>,
}

/// Metres of wall on either side of a door or passage that its frame takes.
pub const FRAME_WIDTH: f64 = 0.06;
/// Metres that the frame of a door or passage stands out of its wall, at most.
pub const FRAME_DEPTH: f64 = 0.02;

/// Metres from the line between hinge and free end to the far face of a leaf, with the air before it.
pub const LEAF_DEPTH: f64 = 0.044;
/// Metres that a handle stands out of a leaf, that it and its plate take along the leaf from the free end on, and from where
/// to where above the floor.
pub const HANDLE_REACH: f64 = 0.06;
/// See [`HANDLE_REACH`].
pub const HANDLE_LENGTH: f64 = 0.22;
/// See [`HANDLE_REACH`].
pub const HANDLE_HEIGHTS: (f64, f64) = (1.03, 1.09);

/// The kind of closure of an opening.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OpeningKind {
    /// A door with leaves on hinges.
    Door,
    /// A door that slides along its wall.
    SlidingDoor,
    /// A doorway without a leaf.
    Passage,
    /// No wall at all between two rooms.
    OpenBoundary,
    /// A window.
    Window,
}

impl OpeningKind {
    /// Whether people walk through.
    #[must_use]
    pub fn is_walkable(self) -> bool {
        self != Self::Window
    }

    /// Whether a door's frame stands around it.
    #[must_use]
    pub fn has_frame(self) -> bool {
        matches!(self, Self::Door | Self::SlidingDoor | Self::Passage)
    }
}

/// A door leaf; it sweeps the sector from `closed_tip` to `open_tip` around `hinge`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leaf {
    /// The axis it turns around.
    pub hinge: Point,
    /// Its free end when shut.
    pub closed_tip: Point,
    /// Its free end when fully open; on the side of the room it opens into.
    pub open_tip: Point,
}

impl Opening {
    /// The leaves that open into the room of a wall.
    pub(crate) fn leaves_into<'a>(&'a self, wall: &Wall) -> impl Iterator<Item = &'a Leaf> + use<'a> {
        let inward = wall.normal();
        self.leaves.iter().filter(move |leaf| (leaf.open_tip - leaf.hinge).dot(inward) > 0.0)
    }
}

impl Leaf {
    /// The floor under a leaf that stands open, then under its handle on that side: counter-clockwise corners. The leaf is
    /// behind the line from hinge to free end, as the sector that it sweeps is before it. None for a leaf without length.
    #[must_use]
    pub fn standing_open(&self) -> Option<[[Point; 4]; 2]> {
        let (shut, open) = (self.closed_tip - self.hinge, self.open_tip - self.hinge);
        let along = open.try_normalize()?;
        // Of a leaf that turns counter-clockwise, the body is on the left.
        let is_left = shut.perp_dot(open) > 0.0;
        let side = if is_left { along.perp() } else { -along.perp() };
        let base = |from: Point, depth: f64| {
            let corners = [from, self.open_tip, self.open_tip + side * depth, from + side * depth];
            if is_left { corners } else { [corners[1], corners[0], corners[3], corners[2]] }
        };
        let handle = self.open_tip - along * HANDLE_LENGTH.min(open.length());
        Some([base(self.hinge, LEAF_DEPTH), base(handle, LEAF_DEPTH + HANDLE_REACH)])
    }
}

/// Where an opening meets a room.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OpeningSide {
    /// Index into [`Level::rooms`].
    pub room: usize,
    /// Index into [`Room::walls`].
    pub wall: usize,
    /// Metres from the wall's start; `from < to`, both within the wall.
    pub from: f64,
    /// Metres from the wall's start.
    pub to: f64,
}

/// An opening as its room sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoomOpening {
    /// Index into [`Level::openings`].
    pub opening: usize,
    /// Index into [`Room::walls`].
    pub wall: usize,
    /// Metres from the wall's start.
    pub from: f64,
    /// Metres from the wall's start.
    pub to: f64,
}
