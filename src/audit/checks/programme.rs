//! `missing_required` and `unfulfilled`: what the programme asks for and the room does not have.

use std::collections::{BTreeMap, BTreeSet};

use crate::catalog::{Class, ClassIndex, Count, ParentName, Request};

use crate::audit::evidence::Evidence;
use crate::audit::fault::Fault;
use crate::audit::possible::{Ask, Held, Question};
use crate::audit::quantity::Quantity;
use crate::audit::rounding::ROUNDING;
use crate::audit::subject::Subject;

/// Required pieces that are missing though the room could hold them.
pub(crate) fn missing_required(evidence: &Evidence<'_, '_>) -> Vec<Fault> {
    let Evidence { subject, ask, .. } = *evidence;
    let mut faults = Vec::new();
    for class in missing_classes(subject) {
        // A piece that the empty room has no place for is no finding at all, whatever else stands there.
        let alone = ask(&Question::Class(class));
        if alone == Held::No {
            continue;
        }
        let (rest, asked) =
            (resting(subject, &[class]), resting(subject, &[class]) + removed(subject, class));
        let subjects = vec![subject.class(class)];
        let fault = Fault::new(Quantity::Count, subjects, f64::from(rest), f64::from(asked));
        faults.push(fault.if_possible(hold_beside_others(subject, class, ask)));
    }
    faults
}

/// Whether too small a share of the requested pieces rests.
pub(crate) fn unfulfilled(evidence: &Evidence<'_, '_>) -> Vec<Fault> {
    let Evidence { subject, ask, .. } = *evidence;
    let (requested, limit) = (subject.furnished.requested, subject.rules().fulfilment.resting);
    let share = f64::from(count(subject.bodies.len())) / f64::from(requested.max(1));
    if requested == 0 || share >= limit - ROUNDING {
        return Vec::new();
    }
    // A file that is read back may ask for less than it misses.
    let share_without = |impossible: u32| {
        f64::from(count(subject.bodies.len())) / f64::from(requested.saturating_sub(impossible).max(1))
    };
    let Impossible { known, unknown } = impossible_pieces(subject, ask);
    // If enough of the pieces that have a place at all are there, the plan is at fault and not the furniture.
    let is_possible = if share_without(known) >= limit - ROUNDING {
        Held::No
    } else if share_without(known + unknown) >= limit - ROUNDING {
        Held::Unknown
    } else {
        Held::Yes
    };
    vec![Fault::new(Quantity::Share, Vec::new(), share, limit).if_possible(is_possible)]
}

/// Missing pieces that the empty room has no place for.
struct Impossible {
    known: u32,
    /// Those of which the search was given up.
    unknown: u32,
}

fn impossible_pieces(subject: &Subject<'_>, ask: Ask<'_>) -> Impossible {
    let mut missing: BTreeMap<ClassIndex, u32> = BTreeMap::new();
    for removal in &subject.furnished.removals {
        *missing.entry(removal.class).or_insert(0) += 1;
    }
    let mut impossible = Impossible { known: 0, unknown: 0 };
    let stands = |class: &ClassIndex| stands_by_itself(&subject.catalog.classes[*class]);
    for (class, pieces) in missing.into_iter().filter(|(class, _)| stands(class)) {
        match ask(&Question::Class(class)) {
            Held::Yes => {}
            Held::No => impossible.known += pieces,
            Held::Unknown => impossible.unknown += pieces,
        }
    }
    impossible
}

/// Whether the empty room can hold a class together with whatever else it cannot do without.
fn hold_beside_others(subject: &Subject<'_>, missing: ClassIndex, ask: Ask<'_>) -> Held {
    if !stands_by_itself(&subject.catalog.classes[missing]) {
        return Held::Yes;
    }
    ask(&Question::Together(&needed_beside(subject, missing)))
}

/// Each required class that is missing and stands on the floor by itself, first in its list, with whatever else the room
/// cannot do without.
pub(crate) fn missing_pieces(subject: &Subject<'_>) -> Vec<Vec<ClassIndex>> {
    let stands = |class: &ClassIndex| stands_by_itself(&subject.catalog.classes[*class]);
    let missing = missing_classes(subject).into_iter().filter(stands);
    missing.map(|class| needed_beside(subject, class)).collect()
}

/// A missing class and those of the other required lines.
fn needed_beside(subject: &Subject<'_>, missing: ClassIndex) -> Vec<ClassIndex> {
    let area = subject.at.room.region.area();
    let applies = |line: &&&Request| {
        line.is_required
            && !matches!(line.count, Count::PerPiece(..))
            && (line.area.0..=line.area.1).contains(&area)
            && !line.classes.contains(&missing)
    };
    let lines = programme(subject);
    let is_there = |&class: &ClassIndex| resting(subject, &[class]) + removed(subject, class) > 0;
    let others = lines.iter().filter(applies).filter_map(|line| line.classes.iter().copied().find(is_there));
    let mut classes: Vec<ClassIndex> = core::iter::once(missing).chain(others).collect();
    classes.retain(|&class| stands_by_itself(&subject.catalog.classes[class]));
    classes
}

/// Whether a class stands on the floor without belonging to another piece.
fn stands_by_itself(class: &Class) -> bool {
    class
        .parents
        .iter()
        .any(|rule| matches!(rule.parent, ParentName::Wall | ParentName::Floor) && rule.elevation.0 == 0.0)
}

/// Classes with a required removal whose line of the programme is left without what it is for: no piece at
/// all, or a piece of another class without its companion (a desk without a chair).
fn missing_classes(subject: &Subject<'_>) -> BTreeSet<ClassIndex> {
    let removals = subject.furnished.removals.iter().filter(|removal| removal.is_required);
    let classes: BTreeSet<ClassIndex> = removals.map(|removal| removal.class).collect();
    classes.into_iter().filter(|&class| !is_met(subject, class)).collect()
}

/// Whether some required line that may ask for the class is met by what rests.
fn is_met(subject: &Subject<'_>, class: ClassIndex) -> bool {
    let lines = programme(subject);
    let mut asking = lines.iter().filter(|line| line.is_required && line.classes.contains(&class)).peekable();
    if asking.peek().is_none() {
        return resting(subject, &[class]) > 0;
    }
    asking.any(|line| {
        let needed = match line.count {
            Count::PerPiece(companion, each) => f64::from(resting(subject, &[companion])) * each.min(1.0),
            _ => 1.0,
        };
        f64::from(resting(subject, &line.classes)) >= needed.floor()
    })
}

/// The lines that ask for what the room holds.
pub(crate) fn programme<'a>(subject: &Subject<'a>) -> Vec<&'a Request> {
    let room_type = subject.catalog.room_types.get(&subject.at.room.room_type);
    room_type.map(|room_type| subject.style().programme(room_type).collect()).unwrap_or_default()
}

fn resting(subject: &Subject<'_>, classes: &[ClassIndex]) -> u32 {
    count(subject.bodies.iter().filter(|body| classes.contains(&body.placement.class)).count())
}

fn removed(subject: &Subject<'_>, class: ClassIndex) -> u32 {
    let removals = subject.furnished.removals.iter();
    count(removals.filter(|removal| removal.class == class && removal.is_required).count())
}

fn count(length: usize) -> u32 {
    u32::try_from(length).expect("a room holds fewer than four thousand million objects")
}

#[cfg(test)]
mod tests {
    use crate::audit::testing::{TestRoom, at, per_piece, required};
    use crate::audit::{Code, Severity};

    #[test]
    fn a_required_piece_that_fits_and_is_absent_fails_the_room() {
        let mut room = TestRoom::rectangle(5.0, 4.0);
        room.ask(required("chest"));
        room.remove("chest", true);
        let findings = room.audit();
        assert_eq!((findings[0].code, findings.len()), (Code::MissingRequired, 1));
        assert_eq!(findings[0].objects, ["chest"]);
        assert_eq!((findings[0].measured, findings[0].threshold), (0.0, 1.0));
        room.stand("chest", at(2.0, 2.0));
        assert_eq!(room.audit(), [], "one of two asked for is there");
    }

    #[test]
    fn what_was_not_required_may_be_absent() {
        let mut room = TestRoom::rectangle(5.0, 4.0);
        room.remove("chest", false);
        assert_eq!(room.audit(), []);
    }

    #[test]
    fn nothing_is_said_where_the_room_cannot_hold_it() {
        let mut room = TestRoom::rectangle(0.9, 4.0);
        room.ask(required("chest"));
        room.remove("chest", true);
        assert_eq!(room.audit(), []);
    }

    #[test]
    fn a_room_that_misses_more_than_it_asked_for_is_judged() {
        let mut room = TestRoom::rectangle(0.9, 4.0);
        room.remove("chest", false);
        room.remove("chest", false);
        room.requested = Some(1);
        assert_eq!(room.audit()[0].code, Code::Unfulfilled);
    }

    #[test]
    fn each_desk_needs_its_stool() {
        let mut room = TestRoom::rectangle(6.0, 5.0);
        room.ask(per_piece("stool", "desk", 1.0));
        room.stand("desk", at(1.0, 3.0));
        room.stand("desk", at(4.0, 3.0));
        room.stand("stool", at(5.5, 4.5));
        room.remove("stool", true);
        assert_eq!(room.count(Code::MissingRequired), 1);
        room.stand("stool", at(0.3, 4.5));
        assert_eq!(room.count(Code::MissingRequired), 0);
    }

    #[test]
    fn nine_of_ten_are_enough() {
        let mut room = TestRoom::rectangle(5.0, 4.0);
        for number in 0..9 {
            room.stand("lamp", at(0.3 + 0.5 * f64::from(number), 2.0));
        }
        room.requested = Some(10);
        assert_eq!(room.audit(), []);
        room.requested = Some(11);
        let findings = room.audit();
        assert_eq!(findings[0].code, Code::Unfulfilled);
        assert!((findings[0].measured - 9.0 / 11.0).abs() < 1e-12);
    }

    #[test]
    fn what_fits_only_without_the_other_required_pieces_is_not_the_furnitures_fault() {
        // A chest takes a square metre; two of them need two.
        let missing_beside_a_desk = |width: f64| {
            let mut room = TestRoom::rectangle(width, 1.6);
            room.ask(required("chest"));
            room.ask(required("desk"));
            room.stand("desk", at(0.8, 1.2));
            room.remove("chest", true);
            let findings = room.audit();
            findings.iter().find(|finding| finding.code == Code::MissingRequired).unwrap().severity
        };
        assert_eq!(missing_beside_a_desk(1.7), Severity::Given);
        assert_eq!(missing_beside_a_desk(3.0), Severity::Failed);
    }
}
