//! A reference to a room of a level.

use super::{Level, Room};

/// A room of a level, with its level around it.
#[derive(Clone, Copy, Debug)]
pub struct RoomRef<'a> {
    /// The level.
    pub level: &'a Level,
    /// The room.
    pub room: &'a Room,
    /// Its index in the rooms of the level.
    pub index: usize,
}

impl Level {
    /// A room by its index.
    ///
    /// # Panics
    /// If the level has no such room.
    #[must_use]
    pub fn room(&self, index: usize) -> RoomRef<'_> {
        RoomRef { level: self, room: &self.rooms[index], index }
    }
}
