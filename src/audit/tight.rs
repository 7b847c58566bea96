//! `tight_use`: a clearance between its minimum and its good depth.

use std::collections::BTreeMap;

use super::clearances::taken;
use super::finding::{Code, Finding};
use super::fit::can_hold_comfortably;
use super::subject::Subject;
use super::thresholds::ROUNDING;
use super::zone::{NearPair, Purpose, Zone};

/// The tightest side of an object: metres free, metres that are good, and what takes them.
struct Tightest {
    free: f64,
    good: f64,
    blocker: String,
}

/// Judges what takes the good clearances; an object makes one finding, that of its tightest side. Where the
/// good depth does not fit into the empty room, the plan asks for no more than the minimum.
pub(crate) fn judge(
    subject: &Subject<'_>,
    zones: &[Zone],
    hits: &[NearPair<'_>],
    findings: &mut Vec<Finding>,
) {
    let slack = subject.rules().clearances.intrusion + ROUNDING;
    let taken = taken(subject, zones, hits, |purpose| match purpose {
        Purpose::Comfort(owner, number) => Some((owner, number)),
        _ => None,
    });
    let mut tightest: BTreeMap<usize, Tightest> = BTreeMap::new();
    for ((owner, blocker), (free, number)) in taken {
        let clearance = &subject.bodies[owner].class.clearances[number];
        // Below the minimum the side is not tight but blocked.
        if free < clearance.minimum - slack {
            continue;
        }
        let side = Tightest { free, good: clearance.good, blocker };
        let lacks = |side: &Tightest| side.good - side.free;
        match tightest.get(&owner) {
            Some(known) if lacks(known) >= lacks(&side) => {}
            _ => drop(tightest.insert(owner, side)),
        }
    }
    findings.extend(tightest.into_iter().map(|(owner, side)| {
        let body = &subject.bodies[owner];
        let objects = vec![body.id.clone(), side.blocker];
        let finding = Finding::new(Code::TightUse, objects, side.free, side.good);
        if can_hold_comfortably(subject, body) { finding } else { finding.given() }
    }));
}

#[cfg(test)]
mod tests {
    use crate::audit::testing::{TestRoom, at};
    use crate::audit::{Code, Severity};

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
}
