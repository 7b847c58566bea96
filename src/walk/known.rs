//! Remembers the floors of empty rooms: the levels of a tower are drawn once and stand there fifty times.

use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

use crate::geometry::Segment;
use crate::plan::{RoomOpening, RoomRef};

use super::floor::Floor;

/// Cells of all floors that a thread remembers, which are about 8 MB: more than a level of forty rooms has.
const MOST_CELLS: usize = 2_000_000;

/// All numbers that the floor of an empty room follows from.
pub(super) type Shape = Vec<u64>;

/// The shape of a room and of the doors in it, with further numbers that its floor depends on.
pub(super) fn shape(at: RoomRef<'_>, doors: &[&RoomOpening], further: &[f64]) -> Shape {
    let room = at.room;
    let edge = |edge: Segment| [edge.start.x, edge.start.y, edge.end.x, edge.end.y];
    let walls = room.walls.iter().flat_map(|wall| edge(Segment::new(wall.start, wall.end)));
    let columns = room.obstacles.iter().flat_map(|column| column.outline.edges().flat_map(edge));
    let ends = doors.iter().flat_map(|door| [door.from, door.to]);
    let places = doors.iter().flat_map(|door| [door.opening as u64, door.wall as u64]);
    // How many there are of each comes first, so that equal lists are equal parts.
    let counts = [room.walls.len(), room.obstacles.len(), doors.len()].map(|count| count as u64);
    let borders = room.region.borders().flat_map(edge);
    let numbers = borders.chain(walls).chain(columns).chain(ends).chain(further.iter().copied());
    counts.into_iter().chain(places).chain(numbers.map(f64::to_bits)).collect()
}

/// What a thread remembers. Floors depend on their shapes alone, so that nothing depends on what is remembered.
#[derive(Default)]
struct Known {
    floors: HashMap<Shape, Rc<Floor>>,
    cells: usize,
}

thread_local! {
    static KNOWN: RefCell<Known> = RefCell::default();
}

/// The floor of a shape: the remembered one, or one that is made, and remembered.
pub(super) fn floor_of(shape: Shape, make: impl FnOnce() -> Floor) -> Rc<Floor> {
    KNOWN.with_borrow_mut(|known| {
        if let Some(floor) = known.floors.get(&shape) {
            return Rc::clone(floor);
        }
        let floor = Rc::new(make());
        if known.cells + floor.cell_count() > MOST_CELLS {
            *known = Known::default();
        }
        // A hall that is larger than all others together is made anew each time.
        if floor.cell_count() <= MOST_CELLS {
            known.cells += floor.cell_count();
            known.floors.insert(shape, Rc::clone(&floor));
        }
        floor
    })
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

    #[test]
    fn what_is_remembered_is_bounded() {
        let first = empty(&level(3.0));
        // Each of these halls has 48,000 cells or more.
        (0..50).for_each(|number| drop(empty(&level(30.0 + f64::from(number)))));
        KNOWN.with_borrow(|known| {
            assert!(known.cells <= MOST_CELLS);
            assert_eq!(known.cells, known.floors.values().map(|floor| floor.cell_count()).sum::<usize>());
        });
        assert!(!Rc::ptr_eq(&first, &empty(&level(3.0))));
        assert_eq!(first.cell_count(), empty(&level(3.0)).cell_count());
    }
}
