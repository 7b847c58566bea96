//! Leaves of doors that stand open in a room. Somebody can shut them, so that ways past them are a wish, not a must; but files hold
//! them open, and whoever walks through a scene, or steers a robot through it, meets them there.

use core::cell::OnceCell;
use std::rc::Rc;

use crate::catalog::WalkingRules;
use crate::geometry::{Convex, Point, Solid, distance_of_convex};
use crate::plan::{LEAF_DEPTH, Leaf, OpeningKind, RoomRef};

use super::floor::{Floor, is_in_the_way};
use super::raster::CELL;

/// The leaves that stand open in an empty room.
#[derive(Debug)]
pub(crate) struct OpenLeaves {
    rules: WalkingRules,
    leaves: Vec<Solid>,
    /// The floor of the empty room on which doors are shut.
    shut: Rc<Floor>,
    /// The one on which they are open: most rooms have no furniture so near to a leaf that it is asked for.
    open: OnceCell<Floor>,
}

impl OpenLeaves {
    /// Those of a room with the floor on which its doors are shut; `None` where no leaf opens into it.
    pub(super) fn new(at: RoomRef<'_>, shut: Rc<Floor>, rules: &WalkingRules) -> Option<Self> {
        let doors = at
            .room
            .openings
            .iter()
            .filter(|place| at.level.openings[place.opening].kind == OpeningKind::Door);
        let leaves = doors.flat_map(|place| {
            let opening = &at.level.openings[place.opening];
            let here = opening.leaves_into(&at.room.walls[place.wall]);
            here.filter_map(|leaf| Some(Solid::new(body(leaf)?, 0.0, opening.top)))
        });
        let leaves: Vec<Solid> = leaves.filter(|leaf| is_in_the_way(rules, leaf)).collect();
        (!leaves.is_empty()).then(|| Self { rules: *rules, leaves, shut, open: OnceCell::new() })
    }

    /// A floor of the room with its doors open.
    pub(crate) fn opened(&self, shut: &Floor) -> Floor {
        shut.with(&self.rules, self.leaves.iter())
    }

    /// The floor of the empty room.
    pub(crate) fn floor(&self) -> &Floor {
        self.open.get_or_init(|| self.opened(&self.shut))
    }

    /// Whether a solid may close a way together with a leaf: whether it stands nearer to one than a person is wide.
    pub(crate) fn are_near(&self, solid: &Solid) -> bool {
        let is_near = |leaf: &Solid| {
            solid.bounds.gap(leaf.bounds) < self.rules.person
                && distance_of_convex(solid.footprint(), leaf.footprint()) < self.rules.person
        };
        is_in_the_way(&self.rules, solid) && self.leaves.iter().any(is_near)
    }
}

/// The floor of an open leaf, deep enough to be seen on the cells: it grows towards where it swung over, which furniture keeps free.
fn body(leaf: &Leaf) -> Option<Convex> {
    let along = (leaf.open_tip - leaf.hinge).try_normalize()?;
    let is_left = (leaf.closed_tip - leaf.hinge).perp_dot(along) > 0.0;
    let behind = if is_left { along.perp() } else { -along.perp() };
    let middle = leaf.hinge.midpoint(leaf.open_tip) + behind * ((LEAF_DEPTH - CELL) / 2.0);
    let half = Point::new(leaf.hinge.distance(leaf.open_tip) / 2.0, f64::midpoint(LEAF_DEPTH, CELL));
    Some(Convex::rectangle(middle, half, along))
}
