//! Remembers what is made for the shapes of rooms: the levels of a tower are drawn once and stand there fifty times.

use std::rc::Rc;

use hashbrown::HashMap;

use crate::geometry::Segment;
use crate::plan::{RoomOpening, RoomRef};

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

/// What a thread remembers, by shape. Values depend on their shapes alone, so that nothing depends on what is remembered.
pub(super) struct Known<T> {
    values: HashMap<Shape, Rc<T>>,
    cells: usize,
}

impl<T> Default for Known<T> {
    fn default() -> Self {
        Self { values: HashMap::new(), cells: 0 }
    }
}

impl<T> Known<T> {
    /// The value of a shape: the remembered one, or one that is made, and remembered by the number of its cells.
    pub(super) fn value(
        &mut self,
        shape: Shape,
        make: impl FnOnce() -> T,
        cells: impl FnOnce(&T) -> usize,
    ) -> Rc<T> {
        if let Some(value) = self.values.get(&shape) {
            return Rc::clone(value);
        }
        let value = Rc::new(make());
        let cells = cells(&value);
        if self.cells + cells > MOST_CELLS {
            *self = Self::default();
        }
        // A hall that is larger than all others together is made anew each time.
        if cells <= MOST_CELLS {
            self.cells += cells;
            self.values.insert(shape, Rc::clone(&value));
        }
        value
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_remembered_is_bounded() {
        let mut known = Known::default();
        let first = known.value(vec![0], || 0, |_| 1);
        assert!(Rc::ptr_eq(&first, &known.value(vec![0], || 1, |_| 1)));
        for number in 1..100 {
            assert_eq!(*known.value(vec![number], || number, |_| 150_000), number);
            assert!(known.cells <= MOST_CELLS && known.values.len() <= 14);
        }
        assert!(!Rc::ptr_eq(&first, &known.value(vec![0], || 0, |_| 1)));
        let huge = known.value(vec![100], || 100, |_| MOST_CELLS + 1);
        assert!(!Rc::ptr_eq(&huge, &known.value(vec![100], || 100, |_| MOST_CELLS + 1)));
    }
}
