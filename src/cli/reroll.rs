//! Gives one room another seed.

use std::fmt;

use super::find_room::{Wanted, find_room};
use crate::contract::RoomId;
use crate::document::Faults;
use crate::edits::EditBook;
use crate::plan::Plan;

/// A room with its new seed.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Rolled {
    /// The room.
    pub(crate) room: RoomId,
    /// The seed that its furniture has now.
    pub(crate) seed: u64,
}

impl fmt::Display for Rolled {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: seed {}", self.room, self.seed)
    }
}

/// Gives a room, named `[BUILDING/][LEVEL/]ROOM`, the seed after the one that it has: its own, else that of the run.
///
/// # Errors
/// If there is no such room, or more than one.
pub(crate) fn reroll(
    plan: &Plan,
    edits: &mut EditBook,
    run_seed: u64,
    named: &str,
    argument: &'static str,
) -> Result<Rolled, Faults> {
    let wanted = Wanted { room: named, building: None, level: None, argument };
    let [building, level, room] = find_room(&plan.buildings, wanted)?.ids();
    let room = RoomId::new(building, level, room);
    let own = edits.level(&room.building, &room.level).and_then(|edits| edits.room(&room.room)?.seed);
    let seed = own.unwrap_or(run_seed).wrapping_add(1);
    edits.pin(&room, seed);
    Ok(Rolled { room, seed })
}
