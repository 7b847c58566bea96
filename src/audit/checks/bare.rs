//! `bare`: desks, sideboards and worktops with nothing on them.

use crate::audit::evidence::Evidence;
use crate::audit::fault::Fault;
use crate::audit::groups::DISPLAY;
use crate::audit::quantity::Quantity;
use crate::audit::rounding::ROUNDING;
use crate::audit::subject::Body;
use crate::catalog::Side;

/// Judges the surfaces of a room together: one empty worktop among several is in order.
pub(crate) fn check(evidence: &Evidence<'_, '_>) -> Vec<Fault> {
    let Evidence { subject, .. } = *evidence;
    let surfaces = subject.bodies.iter().enumerate().filter(|(_, body)| is_surface(body));
    let is_on_top = |object: usize| subject.bodies[object].placement.side == Side::Above;
    let carries = |surface: usize| subject.children(surface).any(is_on_top);
    let (carrying, empty): (Vec<_>, Vec<_>) = surfaces.partition(|&(surface, _)| carries(surface));
    let all = carrying.len() + empty.len();
    let limit = subject.rules().fulfilment.carrying;
    // Surfaces count once each, whatever their size: a long worktop with one kettle is not bare.
    let share = carrying.len() as f64 / all.max(1) as f64;
    if all == 0 || share >= limit - ROUNDING {
        return Vec::new();
    }
    let surfaces = empty.into_iter().map(|(surface, _)| subject.object(surface)).collect();
    vec![Fault::new(Quantity::Share, surfaces, share, limit)]
}

/// Whether a body is meant to carry small things.
fn is_surface(body: &Body<'_>) -> bool {
    body.class.offer(Side::Above).places > 0 && DISPLAY.iter().any(|group| body.is_in(group))
}

#[cfg(test)]
mod tests {
    use crate::audit::Code;
    use crate::audit::testing::{TestRoom, at};
    use crate::catalog::Side;
    use crate::layout::Parent;

    fn desks(count: usize) -> TestRoom {
        let mut room = TestRoom::rectangle(9.0, 4.0);
        room.group("table", "work_surface");
        let table = room.catalog.class_index("table").unwrap();
        room.catalog.classes[table].sides[Side::Above.index()].places = 4;
        for number in 0..count {
            room.stand("table", at(1.5 + 3.0 * number as f64, 2.0));
        }
        room
    }

    fn put_lamp(room: &mut TestRoom, table: usize) {
        let position = room.placements[table].position;
        let lamp = room.add("lamp", position, Parent::Object(table));
        room.placements[lamp].elevation = 0.75;
    }

    #[test]
    fn an_empty_desk_is_bare_and_one_with_a_lamp_is_not() {
        let mut room = desks(1);
        let findings = room.audit();
        assert_eq!((findings[0].code, findings.len()), (Code::Bare, 1));
        assert_eq!(findings[0].objects, ["table.1"]);
        put_lamp(&mut room, 0);
        assert_eq!(room.audit(), []);
    }

    #[test]
    fn half_of_them_may_be_empty() {
        let mut room = desks(3);
        put_lamp(&mut room, 0);
        let findings = room.audit();
        assert_eq!(findings[0].objects, ["table.2", "table.3"]);
        put_lamp(&mut room, 1);
        assert_eq!(room.audit(), []);
    }

    #[test]
    fn what_offers_no_place_carries_nothing() {
        let mut room = desks(1);
        let table = room.catalog.class_index("table").unwrap();
        room.catalog.classes[table].sides[Side::Above.index()].places = 0;
        assert_eq!(room.audit(), []);
    }
}
