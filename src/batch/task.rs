//! A level to write, wherever its content comes from.

use super::job::Job;
use super::record::LevelKey;

/// A level to write.
pub(crate) trait Task: Sync {
    /// Building id and level id.
    fn key(&self) -> LevelKey;
    /// Hash of all that it is made from, the program excepted.
    fn inputs(&self) -> &str;
    /// How many rooms it has.
    fn room_count(&self) -> usize;
}

impl Task for Job<'_> {
    fn key(&self) -> LevelKey {
        LevelKey { building: self.placed.id.clone(), level: self.level.id.clone() }
    }

    fn inputs(&self) -> &str {
        &self.inputs
    }

    fn room_count(&self) -> usize {
        self.level.rooms.len()
    }
}
