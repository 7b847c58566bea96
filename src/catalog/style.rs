//! Room types and styles: what a room holds, and how it looks.

use std::collections::BTreeMap;

use super::class::ClassIndex;

/// A kind of room and its programme.
#[derive(Clone, Debug)]
pub struct RoomType {
    /// The word used in plans.
    pub id: String,
    /// A title for people.
    pub label: String,
    /// Whether it is furnished at all; shafts and stairs are not.
    pub is_furnished: bool,
    /// What it holds unless the style says otherwise.
    pub programme: Vec<Request>,
    /// Groups of classes that contradict it (`sleeping` in an office), sorted.
    pub excludes: Vec<String>,
    /// Square metres that such rooms usually have, least and most.
    pub area: (f64, f64),
    /// Lowest and highest share of the floor that furniture covers.
    pub density: (f64, f64),
    /// Material slots of floor, wall and ceiling.
    pub finish: Finish,
}

/// Materials of the shell.
#[derive(Clone, Debug, PartialEq)]
pub struct Finish {
    /// Material slot of the floor.
    pub floor: String,
    /// Material slot of the walls.
    pub wall: String,
    /// Material slot of the ceiling.
    pub ceiling: String,
}

/// One line of a programme.
#[derive(Clone, Debug, PartialEq)]
pub struct Request {
    /// One of these classes is drawn for each room; at least one.
    pub classes: Vec<ClassIndex>,
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
    /// Name of the geometry set that recipes build.
    pub geometry: String,
    /// Name of the palette.
    pub palette: String,
    /// How untidy.
    pub untidiness: Untidiness,
    /// Factor on the counts of lines that are not required; 1 is as written.
    pub density: f64,
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

    /// The programme of a room type in this style: the style's own or the room type's, then its additions.
    pub fn programme<'a>(&'a self, room_type: &'a RoomType) -> impl Iterator<Item = &'a Request> {
        let base = self.programmes.get(&room_type.id).unwrap_or(&room_type.programme);
        base.iter().chain(self.additions.get(&room_type.id).into_iter().flatten())
    }
}
