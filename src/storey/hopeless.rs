//! Floors of a building on which no flat came out: later attempts, and other kinds of buildings with the same flats, cut the same
//! floors, and need not try them again.

use std::cell::RefCell;
use std::collections::BTreeSet;

use crate::geometry::Segment;

use super::brief::Brief;
use super::ring::{Key, key, total_length};
use super::spine::Ground;
use super::typology::{PlanKind, Typologies};

/// What the flats of a building are planned by.
#[derive(Clone, Copy)]
pub(super) struct Kind<'a> {
    /// The kind of building and its storeys.
    pub(super) brief: &'a Brief<'a>,
    /// Needs of rooms.
    pub(super) typologies: &'a Typologies,
    /// What is tried no more.
    pub(super) hopeless: &'a Hopeless,
}

impl Kind<'_> {
    /// A flat's floor that is entered somewhere on a border, as it is known by.
    pub(super) fn floor(self, flat: &Ground, border: Segment) -> Floor {
        Floor {
            outline: flat.ring.iter().map(|&corner| key(corner)).collect(),
            border: [key(border.start), key(border.end)],
            light: (total_length(&flat.light(&flat.ring)) * 1000.0).round() as i64,
            programme: self.brief.typology.programme.clone(),
            is_on_corridor: self.brief.typology.plan == PlanKind::CorridorFlats,
        }
    }
}

/// The floor of a flat, in steps of the grid, and what was to be set into it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Floor {
    outline: Vec<Key>,
    border: [Key; 2],
    /// Millimetres of outer wall with light.
    light: i64,
    programme: Option<String>,
    is_on_corridor: bool,
}

/// The floors on which no flat came out.
#[derive(Debug, Default)]
pub(super) struct Hopeless(RefCell<BTreeSet<Floor>>);

impl Hopeless {
    /// Whether nothing came out on a floor.
    pub(super) fn knows(&self, floor: &Floor) -> bool {
        self.0.borrow().contains(floor)
    }

    /// What comes out on a floor, unless that is known to be nothing.
    pub(super) fn unless_known<T>(&self, floor: Floor, plan: impl FnOnce() -> Option<T>) -> Option<T> {
        if self.knows(&floor) {
            return None;
        }
        let planned = plan();
        if planned.is_none() {
            self.0.borrow_mut().insert(floor);
        }
        planned
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_floor_on_which_nothing_came_out_is_not_tried_again() {
        let floor = |light| Floor {
            outline: vec![(0, 0), (4_000, 0), (4_000, 3_000)],
            border: [(0, 0), (4_000, 0)],
            light,
            programme: None,
            is_on_corridor: false,
        };
        let hopeless = Hopeless::default();
        assert_eq!(hopeless.unless_known(floor(0), || None::<u32>), None);
        assert!(hopeless.knows(&floor(0)) && !hopeless.knows(&floor(4_000)), "more light is another floor");
        assert_eq!(hopeless.unless_known(floor(0), || Some(1)), None);
        // What came out may come out again.
        assert_eq!(hopeless.unless_known(floor(4_000), || Some(1)), Some(1));
        assert_eq!(hopeless.unless_known(floor(4_000), || Some(2)), Some(2));
    }
}
