//! Storeys that are drafted alike are put together once, and share their rooms.

use std::mem;

use super::{assemble_level, level_digest};
use crate::plan::limits::COORDINATE;
use crate::plan::{Level, LevelDraft, Problem};

/// Puts the levels of a building together, one after the other.
#[derive(Default)]
pub(in crate::plan) struct Storeys {
    /// The last level without a problem, as it was drafted, but for the title, and as it came out.
    last: Option<(LevelDraft, Level)>,
}

impl Storeys {
    /// As [`assemble_level`].
    pub(in crate::plan) fn assemble(&mut self, draft: LevelDraft) -> (Level, Vec<Problem>) {
        if let Some(level) = self.alike(&draft) {
            return (level, Vec::new());
        }
        let (level, problems) = assemble_level(draft.clone());
        if problems.is_empty() {
            self.last = Some((draft, level.clone()));
        }
        (level, problems)
    }

    /// The last level with the title and the elevation of a draft that differs from its draft in nothing else.
    fn alike(&mut self, draft: &LevelDraft) -> Option<Level> {
        let (last, level) = self.last.as_mut()?;
        let id = mem::replace(&mut last.id, draft.id.clone());
        let name = mem::replace(&mut last.name, draft.name.clone());
        let elevation = mem::replace(&mut last.elevation, draft.elevation);
        if last != draft || draft.elevation.abs() > COORDINATE {
            (last.id, last.name, last.elevation) = (id, name, elevation);
            return None;
        }
        let name = if draft.name.is_empty() { &draft.id } else { &draft.name };
        let (id, name) = (draft.id.clone(), name.clone());
        let mut level = Level { id, name, elevation: draft.elevation, ..level.clone() };
        level.digest = level_digest(&level);
        Some(level)
    }
}

#[cfg(test)]
mod tests {
    use std::ptr;

    use super::*;
    use crate::geometry::{Point, Polygon};
    use crate::plan::RoomDraft;

    fn draft(id: &str, elevation: f64, width: f64) -> LevelDraft {
        let outline = Polygon::rectangle(Point::ZERO, Point::new(width, 4.0)).corners().to_vec();
        let room =
            RoomDraft { id: "a".to_owned(), room_type: "office".to_owned(), outline, ..RoomDraft::default() };
        LevelDraft { id: id.to_owned(), elevation, height: 3.0, rooms: vec![room], ..LevelDraft::default() }
    }

    #[test]
    fn equal_storeys_share_their_rooms_and_are_what_each_is_alone() {
        let mut storeys = Storeys::default();
        let drafts =
            [draft("0", 0.0, 5.0), draft("1", 3.0, 5.0), draft("2", 6.0, 4.0), draft("3", f64::NAN, 4.0)];
        let mut levels = Vec::new();
        for draft in drafts {
            let (level, problems) = storeys.assemble(draft.clone());
            let (alone, found) = assemble_level(draft);
            assert_eq!((level.digest, &level.name, &problems), (alone.digest, &alone.name, &found));
            levels.push(level);
        }
        let is_shared = |one: usize, other: usize| ptr::eq(&*levels[one].rooms, &*levels[other].rooms);
        assert!(is_shared(0, 1) && !is_shared(1, 2) && !is_shared(2, 3));
        assert_eq!(levels[3].elevation, 0.0);
    }
}
