//! `collision`: two bodies intersect.
//!
//! Parent and child are no exception here. They touch, which is no intersection, and a chair that slides
//! under a table top leaves its legs alone because bodies are judged by their parts.

use crate::geometry::Solid;

use crate::audit::convex::penetration;
use crate::audit::evidence::Evidence;
use crate::audit::fault::Fault;
use crate::audit::quantity::Quantity;
use crate::audit::rounding::ROUNDING;

/// Judges the pairs of bodies that the broad phase found.
pub(crate) fn check(evidence: &Evidence<'_, '_>) -> Vec<Fault> {
    let Evidence { subject, collisions, .. } = *evidence;
    let limit = subject.rules().bodies.collision_depth;
    let fault = |&(a, b): &(usize, usize)| {
        let depth = deepest(&subject.bodies[a].solids, &subject.bodies[b].solids);
        let bodies = || vec![subject.object(a), subject.object(b)];
        (depth > limit + ROUNDING).then(|| Fault::new(Quantity::Depth, bodies(), depth, limit))
    };
    collisions.iter().filter_map(fault).collect()
}

/// How deep the deepest pair of parts intersects; at most zero where none do.
pub(crate) fn deepest(a: &[Solid], b: &[Solid]) -> f64 {
    let pairs = a.iter().flat_map(|one| b.iter().map(move |other| (one, other)));
    pairs.map(|(one, other)| solid_penetration(one, other)).fold(f64::NEG_INFINITY, f64::max)
}

/// How far one prism must move, sideways or upright, for the two to part.
pub(crate) fn solid_penetration(a: &Solid, b: &Solid) -> f64 {
    // The shortest way apart counts: a lamp sunk 2 mm into its table is 2 mm deep, not as deep as it is wide.
    let upright = (a.high - b.low).min(b.high - a.low);
    if upright <= 0.0 { upright } else { upright.min(penetration(a.footprint(), b.footprint())) }
}

#[cfg(test)]
mod tests {
    use crate::audit::Code;
    use crate::audit::testing::{TestRoom, at};
    use crate::layout::Parent;

    #[test]
    fn boxes_side_by_side_touch_and_do_not_collide() {
        let mut room = TestRoom::rectangle(3.0, 3.0);
        room.stand("chest", at(1.0, 2.0));
        room.stand("chest", at(2.0, 2.0));
        assert_eq!(room.count(Code::Collision), 0);
        room.placements[1].position.x -= 0.004;
        let findings = room.audit();
        assert_eq!(findings.len(), 1);
        assert_eq!(findings[0].objects, ["chest.1", "chest.2"]);
        assert!((findings[0].measured - 0.004).abs() < 1e-9);
    }

    #[test]
    fn half_a_millimetre_is_contact() {
        let mut room = TestRoom::rectangle(5.0, 4.0);
        room.stand("chest", at(1.0, 2.0));
        room.stand("chest", at(1.9995, 2.0));
        assert_eq!(room.count(Code::Collision), 0);
    }

    #[test]
    fn a_chair_under_its_table_is_fine_and_through_its_leg_is_not() {
        let mut room = TestRoom::rectangle(5.0, 4.0);
        let table = room.stand("table", at(2.0, 2.0));
        room.add("stool", at(2.0, 1.7), Parent::Object(table));
        assert_eq!(room.count(Code::Collision), 0);
        room.placements[1].position.x = 1.3;
        assert_eq!(room.count(Code::Collision), 1);
    }

    #[test]
    fn a_rug_is_floor_for_all_but_another_rug() {
        let mut room = TestRoom::rectangle(5.0, 4.0);
        let rug = room.stand("chest", at(2.0, 2.0));
        room.placements[rug].size.height = 0.012;
        room.stand("chest", at(2.5, 2.0));
        assert_eq!(room.count(Code::Collision), 0);
        room.placements[rug].size.height = 0.03;
        assert_eq!(room.count(Code::Collision), 1, "one would stumble over it");
        for placement in &mut room.placements {
            placement.size.height = 0.012;
        }
        assert_eq!(room.count(Code::Collision), 1);
    }

    #[test]
    fn one_above_the_other_is_no_collision() {
        let mut room = TestRoom::rectangle(5.0, 4.0);
        let chest = room.stand("chest", at(2.0, 2.0));
        let lamp = room.add("lamp", at(2.0, 2.0), Parent::Object(chest));
        room.placements[lamp].elevation = 0.8;
        assert_eq!(room.count(Code::Collision), 0);
        room.placements[lamp].elevation = 0.7;
        assert_eq!(room.count(Code::Collision), 1);
    }

    #[test]
    fn a_body_inside_a_turned_body_is_found() {
        let mut room = TestRoom::rectangle(5.0, 4.0);
        let chest = room.stand("chest", at(2.0, 2.0));
        room.placements[chest].angle = 0.7;
        room.stand("stool", at(2.0, 2.0));
        assert_eq!(room.count(Code::Collision), 1);
    }
}
