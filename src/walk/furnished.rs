//! Remembers the floors that a thread furnished last: the audit asks for the one on which the layout has just seen that all ways are open.

use std::cell::RefCell;
use std::rc::Rc;

use crate::catalog::WalkingRules;
use crate::geometry::Solid;

use super::floor::{Floor, is_in_the_way};

/// Floors that a thread remembers: one for people, one for wheelchairs.
const REMEMBERED: usize = 2;

/// A floor with what stands on it.
struct Furnished {
    empty: Rc<Floor>,
    solids: Vec<Solid>,
    floor: Rc<Floor>,
}

thread_local! {
    /// The latest first. A floor follows from its parts alone, so that nothing depends on what is remembered.
    static LATEST: RefCell<Vec<Furnished>> = const { RefCell::new(Vec::new()) };
}

/// An empty floor with some solids on it.
pub(super) fn furnished<'s>(
    empty: &Rc<Floor>,
    rules: &WalkingRules,
    solids: impl Iterator<Item = &'s Solid>,
) -> Rc<Floor> {
    let solids: Vec<Solid> = solids.filter(|solid| is_in_the_way(rules, solid)).copied().collect();
    LATEST.with_borrow_mut(|latest| {
        let is_it = |other: &&Furnished| Rc::ptr_eq(&other.empty, empty) && other.solids == solids;
        if let Some(same) = latest.iter().find(is_it) {
            return Rc::clone(&same.floor);
        }
        let floor = Rc::new(empty.with(rules, solids.iter()));
        latest.retain(|other| !Rc::ptr_eq(&other.empty, empty));
        latest.truncate(REMEMBERED - 1);
        latest.insert(0, Furnished { empty: Rc::clone(empty), solids, floor: Rc::clone(&floor) });
        floor
    })
}
