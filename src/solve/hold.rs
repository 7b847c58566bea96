//! Whether an empty room could hold a piece. A piece that is missing is a fault of the layout only if it could.
//!
//! All of it is paid from the budget of the judgement ([`super::budget`]): where that is spent, an answer means nothing.

use std::rc::Rc;

use crate::catalog::{Class, ClassIndex, Clearance, Size};
use crate::geometry::{Bounds, Line, Solid};

use super::constants::{FIT_STEP, MOST_STEPS};
use super::empty_room::EmptyRoom;
use super::footprint::{Footprint, lowest_underside, needed_boxes};
use super::space::Space;
use super::spots::{Spot, Trial};

/// Places that are asked for at most before they are taken more coarsely: those of the largest rooms that people live
/// in. Each is some hundred bytes where the piece may stand. Fewer where the room has so many borders that half of the
/// budget would not suffice.
const MOST_SPOTS: f64 = 400_000.0;

/// A piece where it could stand.
#[derive(Clone, Debug)]
pub(crate) struct Stand {
    /// Where.
    pub(crate) spot: Spot,
    /// Its footprint, then those of its clearances.
    pub(crate) parts: Vec<Footprint>,
    /// The box around them.
    pub(crate) bounds: Bounds,
}

/// The free places of a piece.
#[derive(Clone, Debug)]
pub(crate) struct Stands {
    /// Those along the walls first.
    pub(crate) stands: Rc<Vec<Stand>>,
    /// Whether there is none between them: else they were taken more coarsely.
    pub(crate) are_all: bool,
}

/// Whether some size of a class, with its smallest clearances, fits somewhere on the empty floor: clear of
/// walls, columns and door zones, and with its back to a solid stretch of wall if it can stand in no other
/// way. Positions are tried every [`FIT_STEP`]; "no" may miss a fit without slack, "yes" never errs.
pub(crate) fn can_hold(empty: &EmptyRoom<'_>, class: ClassIndex) -> bool {
    let class = &empty.catalog.classes[class];
    let space = Space::empty(empty);
    class.sizes.iter().any(|&size| space.holds(class, size, |clearance| clearance.minimum))
}

/// The same for one size with its good clearances.
pub(crate) fn can_hold_comfortably(empty: &EmptyRoom<'_>, class: ClassIndex, size: Size) -> bool {
    Space::empty(empty).holds(&empty.catalog.classes[class], size, |clearance| clearance.good)
}

/// Whether a size of a class could stand, with its smallest clearances, among some bodies to the left of a line.
pub(crate) fn has_room_beside(
    empty: &EmptyRoom<'_>,
    class: ClassIndex,
    size: Size,
    among: &[&Solid],
    line: Line,
) -> bool {
    let space = Space::empty(empty).beside(among.to_vec(), line);
    space.holds(&empty.catalog.classes[class], size, |clearance| clearance.minimum)
}

/// All free places for the smallest size of a class with its smallest clearances.
pub(crate) fn free_stands(empty: &EmptyRoom<'_>, class: ClassIndex) -> Stands {
    let class = &empty.catalog.classes[class];
    Space::empty(empty).free_stands(class, smallest_size(class))
}

/// The size of a class that takes least floor.
pub(crate) fn smallest_size(class: &Class) -> Size {
    let area = |size: &&Size| size.width * size.depth;
    // Of equal areas the first of the class's list: `min_by` keeps it.
    let smallest = class.sizes.iter().min_by(|a, b| area(a).total_cmp(&area(b)));
    *smallest.expect("a class has a size")
}

impl Space<'_, '_> {
    fn holds(&self, class: &Class, size: Size, depth_of: impl Fn(&Clearance) -> f64) -> bool {
        let mut either = needed_boxes(class, size, depth_of).into_iter();
        lowest_underside(class) + size.height <= self.empty.at.room.height
            && either.any(|boxes| {
                self.any_free(&Trial { class, size, boxes: &boxes, step: FIT_STEP }, |_, _| true)
            })
    }

    fn free_stands(&self, class: &Class, size: Size) -> Stands {
        let either = needed_boxes(class, size, |clearance| clearance.minimum);
        let all: Vec<Stands> = either.iter().map(|boxes| self.free_stands_of(class, size, boxes)).collect();
        let are_all = all.iter().all(|stands| stands.are_all);
        match <[Stands; 1]>::try_from(all) {
            Ok([stands]) => stands,
            Err(all) => {
                let stands = all.into_iter().flat_map(|stands| Rc::unwrap_or_clone(stands.stands));
                Stands { stands: Rc::new(stands.collect()), are_all }
            }
        }
    }

    /// The free places for boxes of a piece and its clearances.
    fn free_stands_of(&self, class: &Class, size: Size, boxes: &[Bounds]) -> Stands {
        // One half of the budget lists the places, the other compares them with those of other pieces.
        let most = MOST_SPOTS.min((MOST_STEPS / 2 / self.steps_a_spot(boxes.len())) as f64);
        // Whole multiples of the usual step. Places on a net are as many as the square of its fineness, therefore the root.
        let coarseness = (self.spot_count(class) / most).sqrt().ceil().max(1.0);
        let trial = Trial { class, size, boxes, step: FIT_STEP * coarseness };
        let stands = self.stands_of(&trial);
        // Places that a coarse net misses are few.
        if stands.is_empty() && coarseness > 1.0 {
            let stands = Rc::new(self.stands_of(&Trial { step: FIT_STEP, ..trial }));
            return Stands { stands, are_all: true };
        }
        Stands { stands: Rc::new(stands), are_all: coarseness == 1.0 }
    }

    fn stands_of(&self, trial: &Trial<'_>) -> Vec<Stand> {
        let mut stands = Vec::new();
        self.any_free(trial, |spot, parts| {
            let parts: Vec<Footprint> =
                parts.iter().map(|part| part.footprint.moved(spot.position)).collect();
            let bounds = Bounds::around(parts.iter().flat_map(|part| part.corners));
            // All places are wanted: the search is told of each that it is not the one it looks for.
            stands.push(Stand { spot, bounds, parts });
            false
        });
        stands
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::audit::testing::{TestRoom, at};
    use crate::catalog::Side;
    use crate::geometry::{Point, Polygon, direction};
    use crate::plan::{FRAME_WIDTH, Obstacle, OpeningKind};

    fn holds(room: &TestRoom, class: &str) -> bool {
        let empty = EmptyRoom::new(room.level.room(0), &room.catalog, MOST_STEPS);
        can_hold(&empty, room.catalog.class_index(class).unwrap())
    }

    #[test]
    fn a_chest_needs_its_own_size() {
        assert!(holds(&TestRoom::rectangle(1.01, 1.01), "chest"));
        assert!(!holds(&TestRoom::rectangle(0.99, 3.0), "chest"));
    }

    #[test]
    fn a_desk_needs_its_clearance_too() {
        assert!(holds(&TestRoom::rectangle(1.52, 1.52), "desk"));
        assert!(!holds(&TestRoom::rectangle(1.45, 1.45), "desk"));
    }

    #[test]
    fn a_clearance_wholly_behind_a_wall_is_not_in_the_room() {
        let mut room = TestRoom::rectangle(1.6, 2.0);
        let chest = room.catalog.class_index("chest").unwrap();
        let desk = room.catalog.class_index("desk").unwrap();
        let beside = room.catalog.classes[desk].clearances[0];
        for side in [Side::Left, Side::Right, Side::Front, Side::Back] {
            room.catalog.classes[chest].clearances.push(Clearance { side, minimum: 0.31, ..beside });
        }
        assert!(!holds(&room, "chest"));
        let mut wide = TestRoom::rectangle(1.7, 2.0);
        wide.catalog = room.catalog;
        assert!(holds(&wide, "chest"));
    }

    #[test]
    fn of_sides_of_which_one_is_enough_one_needs_room() {
        let mut room = TestRoom::rectangle(1.4, 1.1);
        let (chest, desk) =
            (room.catalog.class_index("chest").unwrap(), room.catalog.class_index("desk").unwrap());
        let beside = Clearance { minimum: 0.35, ..room.catalog.classes[desk].clearances[0] };
        let sides = vec![Clearance { side: Side::Left, ..beside }, Clearance { side: Side::Right, ..beside }];
        room.catalog.classes[chest].clearances.clone_from(&sides);
        assert!(!holds(&room, "chest"));
        room.catalog.classes[chest].clearances.clear();
        room.catalog.classes[chest].either = sides;
        assert!(holds(&room, "chest"));
    }

    #[test]
    fn a_door_or_a_column_takes_the_room() {
        let mut room = TestRoom::rectangle(1.6, 1.1);
        assert!(holds(&room, "chest"));
        room.open(0, OpeningKind::Passage, (0.4, 1.2), (0.0, 2.0));
        assert!(!holds(&room, "chest"));
        let mut room = TestRoom::rectangle(1.6, 1.1);
        let outline = Polygon::rectangle(at(0.7, 0.4), at(0.2, 0.2));
        room.level.rooms[0].obstacles.push(Obstacle { outline, height: 2.5 });
        assert!(!holds(&room, "chest"));
    }

    #[test]
    fn the_frame_of_a_door_takes_a_little_of_the_walls_beside_it() {
        let beside_door = |depth: f64| {
            let mut room = TestRoom::rectangle(1.01, depth);
            room.open(1, OpeningKind::Passage, (0.1, 0.9), (0.0, 2.0));
            room
        };
        assert!(holds(&beside_door(0.9 + FRAME_WIDTH + 1.01), "chest"));
        assert!(!holds(&beside_door(0.9 + 1.01), "chest"));
    }

    #[test]
    fn a_picture_needs_a_wall_beside_the_window() {
        let mut room = TestRoom::rectangle(3.0, 3.0);
        assert!(holds(&room, "picture"));
        let picture = room.catalog.class_index("picture").unwrap();
        room.catalog.classes[picture].parents[0].elevation = (2.1, 2.2);
        assert!(!holds(&room, "picture"), "half a metre under the ceiling at 2.5 m is too little");
        room.catalog.classes[picture].parents[0].elevation = (1.2, 2.2);
        assert!(holds(&room, "picture"));
        for wall in 0..4 {
            room.open(wall, OpeningKind::Window, (0.2, 2.8), (0.9, 2.2));
        }
        assert!(!holds(&room, "picture"));
    }

    #[test]
    fn a_slanted_room_is_tried_along_its_own_walls() {
        let turn = direction(0.5);
        let corners = [(0.0, 0.0), (1.02, 0.0), (1.02, 1.02), (0.0, 1.02)]
            .map(|(x, y)| turn.rotate(Point::new(x, y)))
            .map(|corner| (corner.x, corner.y));
        assert!(holds(&TestRoom::outline(&corners), "chest"));
    }
}
