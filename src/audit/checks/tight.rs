//! `tight_use`: a clearance between its minimum and its good depth.

use std::collections::BTreeMap;

use crate::audit::evidence::Evidence;
use crate::audit::fault::Fault;
use crate::audit::possible::Question;
use crate::audit::quantity::Quantity;
use crate::audit::rounding::ROUNDING;
use crate::audit::taking::{Taking, narrowest};
use crate::layout::Placement;

/// Metres within which two bodies take as much of a clearance: the 32-bit numbers of a file do not decide which is named.
const SAME_DEPTH: f64 = 1e-5;

/// Judges what takes the good clearances; an object makes one finding, that of its tightest side. Where the
/// good depth does not fit into the empty room, the plan asks for no more than the minimum.
pub(crate) fn check(evidence: &Evidence<'_, '_>) -> Vec<Fault> {
    let Evidence { subject, comfort, ask, .. } = *evidence;
    let slack = subject.rules().clearances.intrusion + ROUNDING;
    let clearance = |taking: &Taking| subject.bodies[taking.owner].class.clearance(taking.number);
    let lacks = |taking: &Taking| clearance(taking).good - taking.free;
    let mut tightest: BTreeMap<usize, &Taking> = BTreeMap::new();
    for taking in narrowest(comfort).into_values() {
        // Below the minimum the side is not tight but blocked.
        if taking.free < clearance(taking).minimum - slack {
            continue;
        }
        match tightest.get(&taking.owner) {
            Some(known) if lacks(known) >= lacks(taking) - SAME_DEPTH => {}
            _ => drop(tightest.insert(taking.owner, taking)),
        }
    }
    let fault = |(owner, taking): (usize, &Taking)| {
        let subjects = vec![subject.object(owner), taking.blocker.clone()];
        let fault = Fault::new(Quantity::FreeDepth, subjects, taking.free, clearance(taking).good);
        let Placement { class, size, .. } = *subject.bodies[owner].placement;
        let is_possible = ask(&Question::Comfortably { class, size });
        fault.about(vec![taking.region(subject, true)]).if_possible(is_possible)
    };
    tightest.into_iter().map(fault).collect()
}

#[cfg(test)]
mod tests {
    use crate::audit::testing::{TestRoom, at};
    use crate::audit::{Code, Element, Severity};
    use crate::catalog::{Clearance, Side};
    use crate::layout::Parent;

    #[test]
    fn between_minimum_and_good_a_side_is_tight() {
        // A desk with its front at y = 2; 0.75 is needed before it, 0.9 is good.
        let mut room = TestRoom::rectangle(6.0, 5.0);
        room.stand("desk", at(3.0, 2.375));
        let chest = room.stand("chest", at(3.0, 0.55));
        assert_eq!(room.audit(), []);
        room.placements[chest].position.y = 0.7;
        let findings = room.audit();
        assert_eq!((findings[0].code, findings.len()), (Code::TightUse, 1));
        assert_eq!(
            (findings[0].severity, &findings[0].objects[..]),
            (Severity::Minor, &["chest.1".to_owned(), "desk.1".to_owned()][..])
        );
        assert!((findings[0].measured - 0.8).abs() < 1e-9 && (findings[0].threshold - 0.9).abs() < 1e-9);
        room.placements[chest].position.y = 0.85;
        assert_eq!(room.count(Code::TightUse), 0, "this is blocked");
        assert_eq!(room.count(Code::BlockedUse), 1);
    }

    #[test]
    fn a_room_too_small_for_the_good_depth_is_not_the_furnitures_fault() {
        let tight = |depth: f64| {
            let mut room = TestRoom::rectangle(1.55, depth);
            room.stand("desk", at(0.775, 0.8 + 0.375));
            room.audit()
        };
        for (depth, severity) in [(2.0, Severity::Minor), (1.6, Severity::Given)] {
            let findings = tight(depth);
            assert_eq!((findings[0].code, findings.len()), (Code::TightUse, 1));
            assert_eq!((findings[0].severity, &findings[0].objects[1][..]), (severity, "wall.0"));
        }
    }

    #[test]
    fn of_sides_of_which_one_is_enough_the_one_with_most_room_counts() {
        // A chest of a metre with so much left and right of it.
        let tight = |left: f64, right: f64| {
            let mut room = TestRoom::rectangle(left + 1.0 + right, 4.0);
            let chest = room.catalog.class_index("chest").unwrap();
            let beside = |side| Clearance { side, good: 1.0, minimum: 0.5, ..Clearance::SEAT };
            room.catalog.classes[chest].either = vec![beside(Side::Left), beside(Side::Right)];
            room.stand("chest", at(left + 0.5, 2.0));
            room.audit().into_iter().map(|finding| (finding.code, finding.measured)).collect::<Vec<_>>()
        };
        assert_eq!(tight(0.1, 1.1), []);
        assert_eq!(tight(1.1, 0.1), []);
        let findings = tight(0.6, 0.8);
        assert_eq!((findings.len(), findings[0].0), (1, Code::TightUse));
        assert!((findings[0].1 - 0.8).abs() < 1e-9, "{findings:?}");
        let findings = tight(0.3, 0.4);
        assert_eq!((findings.len(), findings[0].0), (1, Code::BlockedUse), "{findings:?}");
    }

    #[test]
    fn what_stands_between_twins_is_in_the_way_of_neither() {
        // A chest beside a stool, 0.9 m from it; the lamp between the two stands 0.5 m from the chest.
        let between = |parent: fn(usize) -> Parent| {
            let mut room = TestRoom::rectangle(6.0, 4.0);
            let chest = room.catalog.class_index("chest").unwrap();
            room.catalog.classes[chest].clearances =
                vec![Clearance { side: Side::Left, good: 0.9, minimum: 0.3, ..Clearance::SEAT }];
            let stool = room.stand("stool", at(0.5, 2.0));
            let half = |class: &str| {
                room.catalog.classes[room.catalog.class_index(class).unwrap()].sizes[0].width / 2.0
            };
            let side = 0.5 + half("stool") + 0.9;
            let [lamp_at, chest_at] = [side - 0.5 - half("lamp"), side + half("chest")];
            for (class, x) in [("chest", chest_at), ("lamp", lamp_at)] {
                let piece = room.add(class, at(x, 2.0), parent(stool));
                room.placements[piece].side = Side::Right;
            }
            room.count(Code::TightUse)
        };
        assert_eq!(between(Parent::Object), 0);
        assert_eq!(between(|_| Parent::Floor), 1);
    }

    #[test]
    fn the_region_of_a_tight_side_is_the_good_clearance_that_is_taken() {
        let mut room = TestRoom::rectangle(6.0, 5.0);
        room.stand("desk", at(3.0, 2.375));
        room.stand("chest", at(3.0, 0.7));
        let finding = &room.audit()[0];
        assert_eq!(
            finding.elements,
            [Element::Object(1), Element::Object(0)],
            "in the order of {:?}",
            finding.objects
        );
        let [side] = &finding.region[..] else { panic!("one side: {:?}", finding.region) };
        let depths: Vec<f64> = side.iter().map(|corner| corner.y).collect();
        let (low, high) = (depths.iter().copied().fold(f64::INFINITY, f64::min), 2.0);
        assert!((low - (high - 0.9)).abs() < 1e-9 && depths.iter().all(|&y| y <= high + 1e-9), "{side:?}");
    }
}
