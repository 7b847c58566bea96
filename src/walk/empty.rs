//! The floors of an empty room, from which the furnished ones are made.

use core::cell::OnceCell;
use std::rc::Rc;

use crate::catalog::AuditRules;
use crate::geometry::Solid;
use crate::plan::RoomRef;

use super::floor::Floor;
use super::furnished::furnished;
use super::leaves::OpenLeaves;

/// The floors of an empty room, for people and for wheelchairs: each is made where it is first asked for, and serves all
/// arrangements of the room.
#[derive(Debug)]
pub(crate) struct EmptyFloors<'a> {
    at: RoomRef<'a>,
    rules: &'a AuditRules,
    walking: OnceCell<Option<Rc<Floor>>>,
    open_leaves: OnceCell<Option<OpenLeaves>>,
    wheelchair: OnceCell<Option<Rc<Floor>>>,
}

impl<'a> EmptyFloors<'a> {
    /// Those of a room.
    pub(crate) fn new(at: RoomRef<'a>, rules: &'a AuditRules) -> Self {
        let (walking, open_leaves, wheelchair) = (OnceCell::new(), OnceCell::new(), OnceCell::new());
        Self { at, rules, walking, open_leaves, wheelchair }
    }

    /// The room.
    pub(crate) fn at(&self) -> RoomRef<'a> {
        self.at
    }

    /// The floor for people; `None` where no door leads in.
    pub(crate) fn walking(&self) -> Option<&Floor> {
        self.shared_walking().map(Rc::as_ref)
    }

    fn shared_walking(&self) -> Option<&Rc<Floor>> {
        self.walking.get_or_init(|| Floor::empty(self.at, &self.rules.walking)).as_ref()
    }

    /// The floor for people while doors stand open; `None` where no door has a leaf that opens into the room.
    pub(crate) fn open_leaves(&self) -> Option<&OpenLeaves> {
        let make = || OpenLeaves::new(self.at, Rc::clone(self.shared_walking()?), &self.rules.walking);
        self.open_leaves.get_or_init(make).as_ref()
    }

    /// The floor for wheelchairs; `None` where no door leads in.
    pub(crate) fn wheelchair(&self) -> Option<&Floor> {
        self.shared_wheelchair().map(Rc::as_ref)
    }

    fn shared_wheelchair(&self) -> Option<&Rc<Floor>> {
        self.wheelchair.get_or_init(|| Floor::empty_for_wheelchair(self.at, self.rules)).as_ref()
    }

    /// The floor for people with some solids on it; `None` where no door leads in.
    pub(crate) fn walking_among<'s>(&self, solids: impl Iterator<Item = &'s Solid>) -> Option<Rc<Floor>> {
        Some(furnished(self.shared_walking()?, &self.rules.walking, solids))
    }

    /// The same for wheelchairs.
    pub(crate) fn wheelchair_among<'s>(&self, solids: impl Iterator<Item = &'s Solid>) -> Option<Rc<Floor>> {
        Some(furnished(self.shared_wheelchair()?, &self.rules.walking, solids))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::AuditRules;
    use crate::geometry::Point;
    use crate::plan::{LeafDraft, Level, LevelDraft, OpeningDraft, OpeningKind, OpeningPlace, RoomDraft};

    /// A room with a door in the middle of its first wall.
    fn level(width: f64) -> Level {
        let corners = [(0.0, 0.0), (width, 0.0), (width, 4.0), (0.0, 4.0)];
        let room = RoomDraft {
            id: "room".to_owned(),
            outline: corners.map(|(x, y)| Point::new(x, y)).to_vec(),
            ..RoomDraft::default()
        };
        let door = OpeningDraft {
            id: "door".to_owned(),
            kind: OpeningKind::Door,
            place: OpeningPlace::Points { center: Point::new(width / 2.0, 0.0), along: None },
            rooms: vec!["room".to_owned()],
            width: 0.9,
            bottom: 0.0,
            top: 2.0,
            leaf: LeafDraft::Automatic,
        };
        let draft =
            LevelDraft { height: 3.0, rooms: vec![room], openings: vec![door], ..LevelDraft::default() };
        crate::plan::assemble_level(draft).0
    }

    fn empty(level: &Level) -> Rc<Floor> {
        Floor::empty(level.room(0), &AuditRules::default().walking).unwrap()
    }

    #[test]
    fn equal_rooms_have_one_floor_and_others_have_theirs() {
        let floor = empty(&level(3.0));
        assert!(Rc::ptr_eq(&floor, &empty(&level(3.0))));
        let (wider, mut closed) = (empty(&level(4.0)), level(3.0));
        assert!(wider.cell_count() > floor.cell_count());
        closed.openings[0].kind = OpeningKind::Window;
        assert!(Floor::empty(closed.room(0), &AuditRules::default().walking).is_none());
        let wheelchair = Floor::empty_for_wheelchair(level(3.0).room(0), &AuditRules::default()).unwrap();
        assert!(!Rc::ptr_eq(&floor, &wheelchair));
    }
}
