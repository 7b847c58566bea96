//! `no_turning_circle` and `narrow_way`, in styles that ask for access by wheelchair: nowhere to turn, and doors or used
//! sides that a wheelchair does not get to. Both are minor: people who walk use the room all the same, and `unreachable`
//! judges it for them.
//!
//! A wheelchair is a disc of its walkway's width on the grid of `unreachable`, and is at a door wherever it has that
//! width before it, for doors are narrower than ways.

use std::rc::Rc;

use crate::catalog::Access;
use crate::walk::{CELL, Floor};

use super::reach::{Target, goals, named, widest};
use crate::audit::evidence::Evidence;
use crate::audit::fault::{Fault, Named};
use crate::audit::possible::Held;
use crate::audit::quantity::Quantity;
use crate::audit::subject::Subject;

/// The floor of a room with some furniture and without it, where the style asks for access.
fn floors<'s>(subject: &'s Subject<'_>) -> Option<(Rc<Floor>, &'s Floor)> {
    let asks = subject.style().access == Access::Wheelchair;
    let is_judged = asks && !subject.bodies.is_empty();
    let empty = subject.empty_floors.wheelchair().filter(|_| is_judged)?;
    Some((subject.empty_floors.wheelchair_among(subject.obstacles())?, empty))
}

/// Whether a wheelchair has nowhere to turn.
pub(crate) fn no_turning_circle(evidence: &Evidence<'_, '_>) -> Vec<Fault> {
    let subject = evidence.subject;
    let Some((floor, empty)) = floors(subject) else { return Vec::new() };
    let rules = subject.rules().access;
    let walk = floor.walk(rules.walkway);
    if walk.wide_places(rules.turning).next().is_some() {
        return Vec::new();
    }
    let steps = (rules.turning / CELL) as u32;
    // From the widest down, a cell at a time: the first that has room is what is measured.
    let mut widths = (1..steps).map(|step| rules.turning - f64::from(step) * CELL);
    let widest = widths.find(|&width| walk.wide_places(width).next().is_some()).unwrap_or(0.0);
    let is_possible = empty.walk(rules.walkway).wide_places(rules.turning).next().is_some();
    let fault = Fault::new(Quantity::Width, Vec::new(), widest, rules.turning);
    vec![fault.if_possible(if is_possible { Held::Yes } else { Held::No })]
}

/// Doors and used sides that a wheelchair does not get to: those that furniture closes, and those that the plan does.
pub(crate) fn narrow_way(evidence: &Evidence<'_, '_>) -> Vec<Fault> {
    let Evidence { subject, zones, .. } = *evidence;
    let Some((floor, empty)) = floors(subject) else { return Vec::new() };
    let width = subject.rules().access.walkway;
    let (walk, empty) = (floor.walk(width), empty.walk(width));
    let home = walk.main_door();
    let goals = goals(subject, zones, &floor);
    let missed: Vec<Target<'_>> = goals.into_iter().filter(|goal| !walk.reaches(home, goal.goal())).collect();
    let (possible, impossible): (Vec<_>, Vec<_>) =
        missed.into_iter().partition(|goal| empty.reaches(home, goal.goal()));
    let fault = |(goals, is_possible): (Vec<Target<'_>>, Held)| {
        let narrowest = widest(&floor, home, &goals, width).into_iter().fold(width, f64::min);
        let mut subjects: Vec<Named> = goals.iter().map(|&goal| named(subject, goal)).collect();
        subjects.sort_unstable();
        subjects.dedup();
        Fault::new(Quantity::Width, subjects, narrowest, width).if_possible(is_possible)
    };
    let groups = [(possible, Held::Yes), (impossible, Held::No)];
    groups.into_iter().filter(|(goals, _)| !goals.is_empty()).map(fault).collect()
}

#[cfg(test)]
mod tests {
    use crate::audit::testing::{TestRoom, at};
    use crate::audit::{Code, Severity};
    use crate::catalog::Access;
    use crate::plan::OpeningKind;

    /// A room 3 m wide with a door in its south wall, whose style asks for access.
    fn room(depth: f64) -> TestRoom {
        let mut room = TestRoom::rectangle(3.0, depth);
        room.open(0, OpeningKind::Door, (0.3, 1.2), (0.0, 2.0));
        room.catalog.styles.get_mut("default").unwrap().access = Access::Wheelchair;
        room
    }

    /// Chests a metre deep along the north wall, with so many metres of floor before them.
    fn with_row(depth: f64) -> TestRoom {
        let mut room = room(depth + 1.0);
        for number in 0..3 {
            room.stand("chest", at(0.5 + f64::from(number), depth + 0.5));
        }
        room
    }

    #[test]
    fn a_wheelchair_turns_in_a_metre_and_a_half_and_not_in_less() {
        assert_eq!(with_row(1.52).audit(), []);
        let findings = with_row(1.42).audit();
        assert_eq!((findings[0].code, findings.len()), (Code::NoTurningCircle, 1), "{findings:?}");
        assert_eq!((findings[0].severity, findings[0].threshold), (Severity::Minor, 1.5));
        assert!((findings[0].measured - 1.4).abs() < 0.051, "{findings:?}");
    }

    #[test]
    fn styles_that_do_not_ask_are_not_judged() {
        let mut room = with_row(1.42);
        room.catalog.styles.get_mut("default").unwrap().access = Access::Walking;
        assert_eq!(room.audit(), []);
    }

    #[test]
    fn a_room_too_narrow_for_the_disc_is_the_plans_fault() {
        let severity = |depth: f64| {
            let mut room = room(depth);
            room.stand("chest", at(2.5, depth - 0.5));
            room.audit().iter().find(|one| one.code == Code::NoTurningCircle).map(|one| one.severity)
        };
        assert_eq!(severity(1.42), Some(Severity::Given));
        assert_eq!(severity(1.55), None, "beside the chest there is room");
    }

    /// A room of 6 × 3 m with doors in its short walls and a chest that leaves a gap at each long wall.
    fn with_gap(gap: f64) -> TestRoom {
        let mut room = TestRoom::rectangle(6.0, 3.0);
        room.open(1, OpeningKind::Door, (1.0, 1.8), (0.0, 2.0));
        room.open(3, OpeningKind::Door, (1.0, 1.8), (0.0, 2.0));
        room.catalog.styles.get_mut("default").unwrap().access = Access::Wheelchair;
        let chest = room.stand("chest", at(3.0, 1.5 - gap / 2.0));
        room.placements[chest].size.depth = 3.0 - gap;
        room
    }

    #[test]
    fn a_way_is_nine_tenths_of_a_metre_wide_although_the_doors_are_narrower() {
        assert_eq!(with_gap(0.92).audit(), []);
        let findings = with_gap(0.78).audit();
        assert_eq!((findings[0].code, findings.len()), (Code::NarrowWay, 1), "{findings:?}");
        assert_eq!((findings[0].severity, findings[0].threshold), (Severity::Minor, 0.9));
        assert_eq!(findings[0].objects, ["door:1"]);
    }
}
