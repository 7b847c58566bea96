//! `blocked_use`: a body, a column or a wall in the space that people need before a side.

use crate::audit::evidence::Evidence;
use crate::audit::fault::Fault;
use crate::audit::quantity::Quantity;
use crate::audit::taking::{Taking, narrowest, takings};
use crate::audit::zone::Purpose;

/// Judges what takes the smallest clearances; an object and what blocks it make one fault.
pub(crate) fn check(evidence: &Evidence<'_, '_>) -> Vec<Fault> {
    let Evidence { subject, zones, hits, .. } = *evidence;
    let takings = takings(subject, zones, hits, |purpose| match purpose {
        Purpose::Using(owner, number) => Some((owner, number)),
        _ => None,
    });
    let fault = |taking: &Taking| {
        let minimum = subject.bodies[taking.owner].class.clearance(taking.number).minimum;
        let subjects = vec![subject.object(taking.owner), taking.blocker.clone()];
        let fault = Fault::new(Quantity::FreeDepth, subjects, taking.free, minimum);
        fault.about(vec![taking.region(subject, false)])
    };
    narrowest(&takings).into_values().map(fault).collect()
}

#[cfg(test)]
mod tests {
    use crate::audit::Code;
    use crate::audit::testing::{TestRoom, at};
    use crate::catalog::Side;
    use crate::geometry::Polygon;
    use crate::layout::Parent;
    use crate::plan::{Obstacle, OpeningKind};

    /// A desk (1.5 × 0.75, front clearance 0.75 that lets its chair in) with its front at y = 2.
    fn desk_room() -> TestRoom {
        let mut room = TestRoom::rectangle(6.0, 5.0);
        room.stand("desk", at(3.0, 2.375));
        room
    }

    #[test]
    fn a_body_before_the_desk_blocks_it() {
        let mut room = desk_room();
        let chest = room.stand("chest", at(3.0, 0.75));
        assert_eq!(room.count(Code::BlockedUse), 0, "its edge is at 1.25, where the clearance ends");
        room.placements[chest].position.y = 0.85;
        let findings = room.audit();
        assert_eq!((findings[0].code, findings.len()), (Code::BlockedUse, 1));
        assert_eq!(findings[0].objects, ["chest.1", "desk.1"]);
        assert!((findings[0].measured - 0.65).abs() < 1e-9);
        assert!((findings[0].threshold - 0.75).abs() < 1e-9);
    }

    #[test]
    fn a_wall_that_a_front_touches_blocks_it() {
        let front_at = |y: f64| {
            let mut room = TestRoom::rectangle(6.0, 5.0);
            room.stand("desk", at(3.0, 0.375 + y));
            room.audit().into_iter().filter(|finding| finding.code == Code::BlockedUse).collect::<Vec<_>>()
        };
        assert!(front_at(0.76).is_empty());
        for metres in [0.3, 0.01, 0.004, 0.0] {
            let findings = front_at(metres);
            assert_eq!(findings.len(), 1, "the wall is {metres} m before the desk");
            assert!((findings[0].measured - metres).abs() < 1e-6);
        }
    }

    #[test]
    fn its_own_chair_may_stand_there_and_what_lies_on_it_and_nobody_elses() {
        let mut room = desk_room();
        let chair = room.add("stool", at(3.0, 1.7), Parent::Object(0));
        room.placements[chair].side = Side::Front;
        let cushion = room.add("lamp", at(3.0, 1.7), Parent::Object(chair));
        room.placements[cushion].elevation = 0.45;
        assert_eq!(room.count(Code::BlockedUse), 0);
        room.placements[chair].parent = Parent::Floor;
        room.placements[chair].side = Side::Above;
        assert_eq!(room.count(Code::BlockedUse), 2);
    }

    #[test]
    fn the_front_turns_with_the_desk() {
        let mut room = desk_room();
        room.stand("chest", at(3.0, 0.85));
        room.placements[0].angle = core::f64::consts::PI;
        assert_eq!(room.count(Code::BlockedUse), 0);
        room.placements[0].angle = -core::f64::consts::FRAC_PI_2;
        room.placements[1].position = at(1.6, 2.4);
        assert_eq!(room.count(Code::BlockedUse), 1, "turned clockwise the front faces west");
        room.placements[1].position = at(4.4, 2.4);
        assert_eq!(room.count(Code::BlockedUse), 0);
    }

    #[test]
    fn a_lamp_above_the_clearance_takes_nothing() {
        let mut room = desk_room();
        let lamp = room.add("lamp", at(3.0, 1.7), Parent::Ceiling);
        room.placements[lamp].elevation = 2.2;
        assert_eq!(room.count(Code::BlockedUse), 0);
        room.placements[lamp].elevation = 1.5;
        assert_eq!(room.count(Code::BlockedUse), 1);
    }

    #[test]
    fn a_wall_or_a_column_before_the_desk_blocks_it_and_an_opening_does_not() {
        let mut room = desk_room();
        room.placements[0].position.y = 0.375 + 0.74;
        assert_eq!(room.count(Code::BlockedUse), 0, "a centimetre is tolerated");
        room.placements[0].position.y = 0.375 + 0.7;
        let findings = room.audit();
        assert_eq!(findings[0].objects, ["desk.1", "wall.0"]);
        assert!((findings[0].measured - 0.7).abs() < 1e-9);
        room.open(0, OpeningKind::OpenBoundary, (1.0, 5.0), (0.0, 2.5));
        assert_eq!(room.count(Code::BlockedUse), 0);
        room.placements[0].position.y = 2.375;
        let outline = Polygon::rectangle(at(3.0, 1.5), at(0.2, 0.2));
        room.level.rooms[0].obstacles.push(Obstacle { outline, height: 2.5 });
        assert_eq!(room.audit()[0].objects, ["column.0", "desk.1"]);
    }

    #[test]
    fn a_picture_on_the_wall_is_in_nobodys_way_and_a_cabinet_is() {
        let mut room = desk_room();
        room.placements[0].position.y = 0.375 + 0.76;
        let picture = room.add("picture", at(3.0, 0.025), Parent::Wall(0));
        room.placements[picture].elevation = 1.2;
        assert_eq!(room.count(Code::BlockedUse), 0);
        room.placements[picture].size.depth = 0.2;
        room.placements[picture].position.y = 0.1;
        assert_eq!(room.count(Code::BlockedUse), 1);
    }
}
