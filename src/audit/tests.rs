//! What judging costs, in steps: bounded in large rooms, and whatever was asked before.

use crate::audit::budget::Budget;
use crate::audit::fit::{Held, can_hold};
use crate::audit::subject::Subject;
use crate::audit::testing::{TestRoom, required};
use crate::audit::thresholds::MOST_STEPS;
use crate::audit::together::{Together, place_together};
use crate::audit::{Code, RoomAudit, Severity, judge};
use crate::geometry::{Point, direction};
use crate::growth::growth;
use crate::layout::{Furnished, Parent};

/// Teeth a metre wide that hang from a corridor a metre wide; no chest of a metre fits in.
fn comb(teeth: u32, depth: f64) -> TestRoom {
    let width = 0.99;
    let mut corners = vec![(0.0, 0.0), (f64::from(2 * teeth - 1) * width, 0.0)];
    for tooth in (0..teeth).rev() {
        let (left, right) = (f64::from(2 * tooth) * width, f64::from(2 * tooth + 1) * width);
        corners.extend([(right, depth), (left, depth)]);
        corners.extend([(left, width), (left - width, width)].into_iter().filter(|_| tooth > 0));
    }
    TestRoom::outline(&corners)
}

/// As many corners as a circle of a radius needs to look round.
fn atrium(radius: f64) -> TestRoom {
    let corner = |number: u32| direction(f64::from(number) / 60.0 * core::f64::consts::TAU) * radius;
    TestRoom::outline(&(0..60).map(corner).map(|Point { x, y }| (x, y)).collect::<Vec<_>>())
}

fn lacking_a_chest(mut room: TestRoom) -> TestRoom {
    room.ask(required("chest"));
    room.remove("chest", true);
    room
}

#[test]
fn a_search_that_is_given_up_leaves_the_finding_and_says_so() {
    let room = lacking_a_chest(comb(3, 4.0));
    let furnished = room.furnished();
    let findings = |steps: u64| {
        let mut subject = Subject::new(&room.level, 0, &furnished, &room.catalog);
        subject.budget = Budget::new(steps);
        let findings = judge(&subject).findings;
        findings.into_iter().filter(|one| one.code == Code::MissingRequired).collect::<Vec<_>>()
    };
    assert_eq!(findings(MOST_STEPS), [], "no chest fits in");
    let [finding] = &findings(1000)[..] else { panic!("a chest is missing") };
    assert_eq!((finding.severity, finding.not_searched_further), (Severity::Failed, true));
    let words = serde_json::to_value(finding).unwrap();
    assert_eq!(words["not_searched_further"], true);
}

#[test]
fn what_was_searched_to_the_end_says_nothing_of_the_search() {
    let findings = lacking_a_chest(TestRoom::rectangle(5.0, 4.0)).audit();
    assert_eq!((findings[0].code, findings[0].not_searched_further), (Code::MissingRequired, false));
    assert!(serde_json::to_value(&findings[0]).unwrap().get("not_searched_further").is_none());
}

#[test]
fn a_question_about_a_hall_of_any_size_and_shape_costs_no_more_than_the_budget() {
    for room in [comb(300, 300.0), atrium(170.0), TestRoom::rectangle(0.99, 1000.0)] {
        let furnished = room.furnished();
        let mut subject = Subject::new(&room.level, 0, &furnished, &room.catalog);
        subject.budget = Budget::new(100_000);
        let held = can_hold(&subject, room.catalog.class_index("chest").unwrap());
        assert!(subject.budget.made() < 110_000, "{}", subject.budget.made());
        assert_eq!(held == Held::Unknown, subject.budget.is_overdrawn());
    }
}

#[test]
fn two_pieces_find_their_places_in_a_hall() {
    for room in [TestRoom::rectangle(100.0, 60.0), atrium(40.0)] {
        let furnished = room.furnished();
        let subject = Subject::new(&room.level, 0, &furnished, &room.catalog);
        let classes = ["chest", "desk"].map(|class| room.catalog.class_index(class).unwrap());
        let together = place_together(&subject, &classes);
        assert!(matches!(together, Together::Fit(_)), "{} steps", subject.budget.made());
    }
}

#[test]
fn no_verdict_depends_on_those_before_it() {
    let room = lacking_a_chest(comb(3, 4.0));
    let mut other = lacking_a_chest(comb(3, 4.0));
    other.remove("desk", true);
    let audit = RoomAudit::new(&room.level, 0, &room.catalog);
    for one in [&room, &other, &room, &other] {
        let fresh = RoomAudit::new(&room.level, 0, &room.catalog);
        assert_eq!(audit.judge(&one.furnished()), fresh.judge(&one.furnished()));
        assert_eq!(audit.suggest_places(&one.furnished()), fresh.suggest_places(&one.furnished()));
    }
    let steps = audit.steps();
    let _ = audit.judge(&room.furnished());
    assert_eq!(audit.steps(), steps, "all of it is known");
}

/// A hall with so many tables, each with a stool that belongs to it: in rows, or all at one place.
fn hall(tables: u32, is_heap: bool) -> TestRoom {
    let columns = f64::from(tables).sqrt().ceil();
    let mut room = TestRoom::rectangle(columns * 3.0, columns * 3.0);
    room.open(0, crate::plan::OpeningKind::Door, (0.3, 1.2), (0.0, 2.0));
    for number in 0..tables {
        let (row, column) = ((f64::from(number) / columns).floor(), f64::from(number) % columns);
        let place = if is_heap { (2.0, 2.0) } else { (1.0 + 3.0 * column, 1.0 + 3.0 * row) };
        let table = room.stand("desk", Point::new(place.0, place.1));
        room.add("stool", Point::new(place.0, place.1 - 0.6), Parent::Object(table));
    }
    room
}

#[test]
fn the_time_of_a_verdict_grows_as_the_pieces_do() {
    for is_heap in [false, true] {
        let furnish = |tables: usize| {
            let room = hall(u32::try_from(tables).unwrap(), is_heap);
            (room.furnished(), room)
        };
        let judge = |(furnished, room): (Furnished, TestRoom)| {
            drop(crate::audit::judge_room(&room.level, 0, &furnished, &room.catalog));
        };
        // From where a heap has as many neighbours as are looked at.
        let power = growth((480, 4), 1.3, furnish, judge);
        assert!(power < 1.3, "heap: {is_heap}: {power}");
    }
}

#[test]
fn findings_of_a_heap_grow_as_its_pieces_do() {
    let count = |tables: u32| hall(tables, true).audit().len();
    let (few, many) = (count(50), count(200));
    assert!(few > 100 && many < 5 * few, "{few}, then {many}");
}
