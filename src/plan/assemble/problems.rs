//! The messages for faults of a draft.

use super::super::attach::{AttachFault, Request};
use super::super::clean::{HoleFault, RingFault};
use crate::geometry::PolygonFault;
use crate::plan::limits::{OUTLINE_CORNERS, ROOM_OPENINGS};
use crate::plan::{Opening, Problem, Room, Subject};

impl Problem {
    /// The subject was left out, or something else was put in its place.
    pub(in crate::plan) fn error(subject: Subject, message: String, hint: Option<&str>) -> Self {
        Self { subject, message, hint: hint.map(str::to_owned), is_error: true, is_impossible: false }
    }

    /// The subject was mended or is drawing noise.
    pub(in crate::plan) fn warning(subject: Subject, message: String, hint: Option<&str>) -> Self {
        Self { is_error: false, ..Self::error(subject, message, hint) }
    }

    /// The subject was left out, because no building has such a part.
    pub(in crate::plan) fn impossible(subject: Subject, message: String, hint: &str) -> Self {
        Self { is_impossible: true, ..Self::error(subject, message, Some(hint)) }
    }
}

/// An id that is empty or taken.
pub(super) fn duplicate(subject: Subject, what: &str, id: &str) -> Problem {
    if id.is_empty() {
        return Problem::error(subject, format!("{what} without an id"), Some("give it an id"));
    }
    Problem::error(subject, format!("{what} id \"{id}\" is used twice"), Some("ids are unique in a level"))
}

/// A room's outline that is none.
pub(super) fn bad_outline(room: usize, id: &str, fault: &RingFault) -> Problem {
    let subject = fault.corner().map_or(Subject::Room(room), |corner| Subject::RoomCorner(room, corner));
    let message = format!("room \"{id}\": {fault}");
    match fault {
        RingFault::Sliver(..) => Problem::warning(subject, message, Some("it was left out")),
        RingFault::Polygon(PolygonFault::SelfCrossing(..)) => {
            Problem::error(subject, message, Some("list the corners in order around the room"))
        }
        RingFault::TooFar(..) => {
            Problem::impossible(subject, message, "coordinates are metres near the origin")
        }
        RingFault::TooManyCorners(_) => {
            let hint =
                format!("{OUTLINE_CORNERS} corners are the most that is read: draw curves in fewer steps");
            Problem::impossible(subject, message, &hint)
        }
        _ => Problem::error(subject, message, None),
    }
}

/// An outline that crosses itself in a small part, of which the rest is taken.
pub(super) fn mended_outline(room: usize, id: &str, fault: &RingFault) -> Problem {
    let hint = "the largest part was kept; list the corners in order around the room";
    Problem::warning(Subject::Room(room), format!("room \"{id}\": {fault}"), Some(hint))
}

/// The change to a hole.
pub(super) fn hole(room: usize, id: &str, fault: &HoleFault) -> Problem {
    match fault {
        HoleFault::Ring(hole, fault) => {
            let message = format!("hole {hole} of room \"{id}\": {fault}");
            let is_error = !matches!(fault, RingFault::Sliver(..));
            let hint = Some("it was left out".to_owned());
            Problem { subject: Subject::Hole(room, *hole), message, hint, is_error, is_impossible: false }
        }
        HoleFault::Merged => Problem::warning(
            Subject::Room(room),
            format!("holes of room \"{id}\" touch each other or its outline"),
            Some("they were merged and cut out of the outline"),
        ),
        HoleFault::CutOff(area) => Problem::warning(
            Subject::Room(room),
            format!("holes cut {area:.2} m² off room \"{id}\""),
            Some("the largest part was kept; draw the others as rooms of their own"),
        ),
        HoleFault::AllDropped => Problem::error(
            Subject::Room(room),
            format!("holes leave nothing sound of room \"{id}\""),
            Some("they were left out"),
        ),
    }
}

/// An opening that found no wall.
pub(super) fn unattached(number: usize, request: &Request, fault: &AttachFault, rooms: &[Room]) -> Problem {
    let (id, center) = (&request.id, request.center);
    let at = format!("at ({:.2}, {:.2})", center.x, center.y);
    let (fact, hint) = match fault {
        AttachFault::NoWall => {
            (format!("opening \"{id}\" {at} is on no wall"), "move it onto a wall of a room, along the wall")
        }
        AttachFault::NotOnRoom(room) => (
            format!("opening \"{id}\" {at} is on no wall of room \"{}\", which it names", rooms[*room].id),
            "move it onto a wall that these rooms share",
        ),
        AttachFault::TooLittleWall(room, share) => (
            format!(
                "opening \"{id}\" {at}, {:.2} m wide: a wall of room \"{}\" holds only {:.0} % of it",
                request.width,
                rooms[*room].id,
                share * 100.0
            ),
            "make it narrower, or move it away from the corner",
        ),
        AttachFault::Apart => (
            format!("opening \"{id}\" {at}: the rooms that it names do not face each other there"),
            "name two rooms with one wall between them",
        ),
        AttachFault::TooMany(room) => (
            format!(
                "opening \"{id}\" {at}: room \"{}\" has {ROOM_OPENINGS} openings already, the most that is read",
                rooms[*room].id
            ),
            "divide the room",
        ),
        AttachFault::Taken(room) => (
            format!(
                "opening \"{id}\" {at}: other openings of room \"{}\" take its place in the wall",
                rooms[*room].id
            ),
            "move it, or take the other one out",
        ),
    };
    Problem::error(Subject::Opening(number), fact, Some(hint))
}

/// An opening of a room that was left out.
pub(super) fn of_lost_room(number: usize, id: &str, room: &str) -> Problem {
    let fact = format!("opening \"{id}\" names room \"{room}\", which was left out");
    Problem::warning(Subject::Opening(number), fact, Some("it was left out too"))
}

/// A window that runs on along several walls.
pub(super) fn cut_to_pieces(number: usize, id: &str, count: usize) -> Problem {
    let fact = format!("window \"{id}\" runs along {count} walls and was cut into as many pieces");
    Problem::warning(Subject::Opening(number), fact, None)
}

/// An opening that begins above the ceiling.
pub(super) fn above_ceiling(number: usize, opening: &Opening) -> Problem {
    let fact = format!(
        "opening \"{}\" begins at {:.2} m, its room ends at {:.2} m",
        opening.id, opening.bottom, opening.top
    );
    Problem::error(Subject::Opening(number), fact, Some("lower its sill or raise the room"))
}

/// A leaf that opens into a room on neither side.
pub(super) fn leaf_elsewhere(number: usize, id: &str, room: &str) -> Problem {
    let fact = format!("the leaf of opening \"{id}\" opens into room \"{room}\", which it does not join");
    Problem::error(Subject::Opening(number), fact, Some("name one of the rooms that the door joins"))
}
