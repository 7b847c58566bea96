//! The result of furnishing a room.

use super::constants::CONTACT_TOLERANCE;
use crate::catalog::{COVERING_HEIGHT, ClassIndex, Side, Size, StyleRef};
use crate::geometry::Point;

/// A furnished room.
#[derive(Clone, Debug, PartialEq)]
pub struct Furnished {
    /// Index of the room in its level.
    pub room: usize,
    /// The seed that repeats it: first eight bytes of the room's key.
    pub seed: u64,
    /// The style that was used.
    pub style: StyleRef,
    /// How many pieces the programme asked for.
    pub requested: u32,
    /// The pieces that rest, parents before children.
    pub placements: Vec<Placement>,
    /// The requested pieces that are missing, in the order of removal.
    pub removals: Vec<Removal>,
}

impl Furnished {
    /// A room that is not furnished.
    pub(crate) fn empty(room: usize, seed: u64, style: StyleRef) -> Self {
        Self { room, seed, style, requested: 0, placements: Vec::new(), removals: Vec::new() }
    }
}

/// One object at rest.
#[derive(Clone, Debug, PartialEq)]
pub struct Placement {
    /// Index into the catalogue's classes.
    pub class: ClassIndex,
    /// Counts the objects of a class in a room from 1; the id is `<class>.<number>`.
    pub number: u32,
    /// The object or room part that it stands on or belongs to.
    pub parent: Parent,
    /// The parent's side that it touches.
    pub side: Side,
    /// Middle of its underside in the level's plan frame.
    pub position: Point,
    /// Metres of its underside above the room's floor.
    pub elevation: f64,
    /// Radians counter-clockwise; at zero the front faces −y (south).
    pub angle: f64,
    /// Which of the class's variants.
    pub variant: u32,
    /// Its size, that of the variant.
    pub size: Size,
}

impl Placement {
    /// Whether it lies so flat on the floor that others stand on it and people walk over it, like a rug.
    #[must_use]
    pub fn is_covering(&self) -> bool {
        let top = self.elevation + self.size.height;
        self.parent == Parent::Floor && top <= COVERING_HEIGHT + CONTACT_TOLERANCE
    }
}

/// A parent in the hierarchy.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parent {
    /// The floor.
    Floor,
    /// The ceiling.
    Ceiling,
    /// A wall by index.
    Wall(usize),
    /// An opening by index into the level's openings.
    Opening(usize),
    /// A column by index into the room's obstacles.
    Column(usize),
    /// Another object by index into [`Furnished::placements`]; always an earlier one.
    Object(usize),
}

/// A piece that was asked for and does not rest.
#[derive(Clone, Debug, PartialEq)]
pub struct Removal {
    /// Index into the catalogue's classes.
    pub class: ClassIndex,
    /// Why.
    pub reason: RemovalReason,
    /// Whether the programme calls it required.
    pub is_required: bool,
}

/// Why a piece is missing; the texts are part of the output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum RemovalReason {
    /// The room has nothing that the class could stand on.
    NoParent,
    /// All possible parents' sides are taken or too short.
    NoPlace,
    /// Every position tried collides with another body.
    Collision,
    /// Every position tried leaves the room or hangs over its support.
    Outside,
    /// Every position tried stands in a door's way or takes another object's clearance.
    Clearance,
    /// Every position tried misses a relation that the class needs.
    Relation,
    /// Every free place would make the room tight or dark.
    Comfort,
    /// Its parent was lost and no other was found.
    LostParent,
    /// Taken away again by the repair pass.
    Repair,
}

impl RemovalReason {
    /// All of them, in the order of their declaration.
    pub const ALL: [Self; 9] = [
        Self::NoParent,
        Self::NoPlace,
        Self::Collision,
        Self::Outside,
        Self::Clearance,
        Self::Relation,
        Self::Comfort,
        Self::LostParent,
        Self::Repair,
    ];

    /// The word in the output.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::NoParent => "no parent",
            Self::NoPlace => "no place",
            Self::Collision => "collision",
            Self::Outside => "outside",
            Self::Clearance => "clearance",
            Self::Relation => "relation",
            Self::Comfort => "comfort",
            Self::LostParent => "lost parent",
            Self::Repair => "repair",
        }
    }
}
