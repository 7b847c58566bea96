//! Checks a native plan after its rooms are built. Assembling mends small faults of foreign plans; in plans that people
//! wrote, they are reported.

use std::collections::BTreeMap;

use crate::plan::{Level, LevelDraft, OpeningKind, Problem, Room, Subject};

/// Metres that an opening may lose to the ends of its wall without a word.
const LOST_WIDTH: f64 = 0.005;
/// Rooms of these types need no way in.
const CLOSED_ROOM_TYPES: [&str; 2] = ["shaft", "void"];

/// The requests of a draft, remembered while it is assembled.
pub(crate) struct NativeChecks {
    /// Place in the draft and asked width, by id.
    openings: BTreeMap<String, (usize, f64)>,
    /// Place in the draft, by id.
    rooms: BTreeMap<String, usize>,
}

impl NativeChecks {
    /// The requests of a level.
    pub(crate) fn of(level: &LevelDraft) -> Self {
        let openings = level.openings.iter().enumerate();
        let rooms = level.rooms.iter().enumerate();
        Self {
            openings: openings.map(|(index, entry)| (entry.id.clone(), (index, entry.width))).collect(),
            rooms: rooms.map(|(index, room)| (room.id.clone(), index)).collect(),
        }
    }

    /// Compares with what it has.
    pub(crate) fn run(&self, level: &Level, problems: &mut Vec<Problem>) {
        self.cut_openings(level, problems);
        self.sealed_rooms(level, problems);
    }

    fn cut_openings(&self, level: &Level, problems: &mut Vec<Problem>) {
        for opening in level.openings.iter().filter(|opening| opening.kind != OpeningKind::OpenBoundary) {
            let Some(&(index, asked)) = self.openings.get(&opening.id) else { continue };
            let (id, width) = (&opening.id, opening.width);
            if width < asked - LOST_WIDTH {
                let fact = format!("opening \"{id}\" is {asked} m wide, its wall has room for {width:.3} m");
                let hint = Some("make it narrower, or move it away from the corner");
                problems.push(Problem::error(Subject::Opening(index), fact, hint));
            }
        }
    }

    fn sealed_rooms(&self, level: &Level, problems: &mut Vec<Problem>) {
        for room in &level.rooms {
            let is_reached =
                room.openings.iter().any(|entry| level.openings[entry.opening].kind.is_walkable());
            if !is_reached && !CLOSED_ROOM_TYPES.contains(&room.room_type.as_str()) {
                let fact = format!("room \"{}\" has no way in", room.id);
                let hint = Some("add a door, a passage or an open boundary");
                problems.push(Problem::warning(self.subject(room), fact, hint));
            }
        }
    }

    fn subject(&self, room: &Room) -> Subject {
        self.rooms.get(&room.id).map_or(Subject::Level, |index| Subject::Room(*index))
    }
}
