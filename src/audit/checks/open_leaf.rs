//! `open_leaf`: what stands beside a door leaf and closes, while the doors of the room stand open, as they do in the files, the way to
//! another door or to a side of an object that is used, fixtures of bathrooms apart. Whoever lives there shuts the door; who walks
//! through the scene, or steers a robot through it, meets the leaf.
//!
//! What a leaf closes by itself is the plan's, and what furniture closes by itself is `unreachable`.

use crate::audit::evidence::Evidence;
use crate::audit::fault::Fault;
use crate::audit::groups::FIXTURE;
use crate::audit::possible::Held;
use crate::audit::quantity::Quantity;
use crate::audit::rounding::ROUNDING;
use crate::audit::subject::Subject;
use crate::layout::Parent;

use super::reach::{Target, goals, region, widest};

/// Judges the ways past the leaves that stand open in a room.
pub(crate) fn check(evidence: &Evidence<'_, '_>) -> Vec<Fault> {
    let Evidence { subject, floor, zones, .. } = *evidence;
    let rules = &subject.rules().walking;
    let (Some(shut), Some(leaves)) = (floor, subject.empty_floors.open_leaves()) else { return Vec::new() };
    let is_beside = |index: &usize| {
        let body = &subject.bodies[*index];
        let is_carried = matches!(body.placement.parent, Parent::Object(_));
        let is_floor = body.placement.is_covering();
        !is_carried && !is_floor && body.solids.iter().any(|solid| leaves.are_near(solid))
    };
    let beside: Vec<usize> = (0..subject.bodies.len()).filter(is_beside).collect();
    if beside.is_empty() {
        return Vec::new();
    }
    let open = leaves.opened(shut);
    let walk = open.walk(rules.person);
    let home = walk.main_door();
    let mut goals = goals(subject, zones, &open);
    goals.retain(|goal| !is_private(subject, goal));
    let mut missed: Vec<Target<'_>> =
        goals.into_iter().filter(|goal| !walk.reaches(home, goal.goal())).collect();
    if missed.is_empty() {
        return Vec::new();
    }
    let others = [shut, leaves.floor()].map(|floor| floor.walk(rules.person));
    missed.retain(|goal| others.iter().all(|other| other.reaches(home, goal.goal())));
    // The goals behind one narrow place make one fault: of what stands there, and of all the floor that is cut off.
    let width = widest(&open, home, &missed, rules.person).into_iter().fold(rules.person, f64::min);
    if width >= rules.person - ROUNDING {
        return Vec::new();
    }
    let subjects = beside.into_iter().map(|index| subject.object(index)).collect();
    let fault = Fault::new(Quantity::Width, subjects, width, rules.person);
    let regions = missed.iter().flat_map(|&goal| region(subject, goal)).collect();
    vec![fault.about(regions).if_possible(Held::Yes)]
}

/// Whether a goal is the side of a fixture: who goes to a toilet or a shower shuts the door first, and architects draw them beside
/// the leaf.
fn is_private(subject: &Subject<'_>, goal: &Target<'_>) -> bool {
    match goal {
        Target::Door(_) => false,
        Target::Side(_, owner) => subject.bodies[*owner].is_in(FIXTURE),
    }
}

#[cfg(test)]
mod tests {
    use crate::audit::Code;
    use crate::audit::testing::{TestRoom, at};
    use crate::geometry::Point;
    use crate::plan::{Leaf, OpeningKind};

    /// A corridor of 6 × 1.6 m with doors at both ends and one in its south wall, whose leaf of 0.9 m may stand open into
    /// it; a chest 1 m wide and `depth` metres deep stands at the north wall, its middle `beside` metres from the leaf.
    fn corridor(has_leaf: bool, beside: f64, depth: f64) -> TestRoom {
        let mut room = TestRoom::rectangle(6.0, 1.6);
        room.open(1, OpeningKind::Door, (0.3, 1.2), (0.0, 2.0));
        room.open(3, OpeningKind::Door, (0.3, 1.2), (0.0, 2.0));
        room.open(0, OpeningKind::Door, (2.0, 2.9), (0.0, 2.0));
        if has_leaf {
            let (hinge, closed_tip) = (Point::new(2.0, 0.0), Point::new(2.9, 0.0));
            room.level.openings[2].leaves.push(Leaf { hinge, closed_tip, open_tip: Point::new(2.0, 0.9) });
        }
        let chest = room.stand("chest", at(2.0 - beside, 1.6 - depth / 2.0));
        room.placements[chest].size.depth = depth;
        room
    }

    #[test]
    fn a_chest_opposite_an_open_leaf_closes_the_corridor_and_one_further_on_does_not() {
        let findings = corridor(true, 0.6, 0.4).audit();
        assert_eq!((findings.len(), findings[0].code), (1, Code::OpenLeaf), "{findings:?}");
        assert!(findings[0].measured < 0.45 && findings[0].threshold == 0.45, "{findings:?}");
        assert_eq!(corridor(false, 0.6, 0.4).count(Code::OpenLeaf), 0, "a door without a leaf");
        assert_eq!(corridor(true, 1.5, 0.4).count(Code::OpenLeaf), 0, "a metre further on");
        assert_eq!(corridor(true, 0.6, 0.2).count(Code::OpenLeaf), 0, "half a metre is left");
    }

    #[test]
    fn who_uses_a_fixture_shuts_the_door() {
        let findings = |is_fixture: bool| {
            let mut room = corridor(true, 0.6, 0.4);
            // The door with the leaf is the only one; behind the leaf and the chest is a desk that is used from the east.
            room.level.openings.drain(..2);
            room.level.rooms[0].openings.drain(..2);
            room.level.rooms[0].openings[0].opening = 0;
            let desk = room.stand("desk", at(0.375, 0.8));
            room.placements[desk].angle = core::f64::consts::FRAC_PI_2;
            if is_fixture {
                room.group("desk", "fixture");
            }
            room.count(Code::OpenLeaf)
        };
        assert_eq!([false, true].map(findings), [1, 0]);
    }

    #[test]
    fn what_a_leaf_closes_without_furniture_is_the_plans() {
        let mut room = corridor(true, 0.6, 0.4);
        let leaves = room.level.openings.iter_mut().flat_map(|opening| &mut opening.leaves);
        leaves.for_each(|leaf| leaf.open_tip.y = 1.3);
        assert_eq!(room.count(Code::OpenLeaf), 0);
    }
}
