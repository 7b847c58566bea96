//! The cost of searches in steps: bounded in large rooms, and independent of earlier questions.

use crate::audit::testing::{TestRoom, required};
use crate::audit::{Code, Held, Question, Severity, judge};
use crate::geometry::{Point, direction};
use crate::solve::RoomSolver;
use crate::solve::answers::Answers;
use crate::solve::constants::MOST_STEPS;
use crate::solve::empty_room::EmptyRoom;
use crate::walk::EmptyFloors;

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
        let (empty, answers) = (EmptyRoom::new(room.level.room(0), &room.catalog, steps), Answers::default());
        let floors = EmptyFloors::new(room.level.room(0), &room.catalog.audit);
        let ask = |question: &Question<'_>| answers.answer(&empty, question);
        let findings = judge(&floors, &furnished, &room.catalog, &ask).findings;
        findings.into_iter().filter(|one| one.code == Code::MissingRequired).collect::<Vec<_>>()
    };
    assert_eq!(findings(MOST_STEPS), [], "no chest fits in");
    let [finding] = &findings(1000)[..] else { panic!("a chest is missing") };
    assert_eq!((finding.severity, finding.not_searched_further), (Severity::Failed, true));
    let words = serde_json::to_value(finding).unwrap();
    assert_eq!(words["not_searched_further"], true);
}

#[test]
fn a_question_about_a_hall_of_any_size_and_shape_costs_no_more_than_the_budget() {
    for room in [comb(300, 300.0), atrium(170.0), TestRoom::rectangle(0.99, 1000.0)] {
        let empty = EmptyRoom::new(room.level.room(0), &room.catalog, 100_000);
        let chest = Question::Class(room.catalog.class_index("chest").unwrap());
        let held = Answers::default().answer(&empty, &chest);
        assert!(empty.budget.made() < 110_000, "{}", empty.budget.made());
        assert_eq!(held == Held::Unknown, empty.budget.is_overdrawn());
    }
}

#[test]
fn two_pieces_find_their_places_in_a_hall() {
    for room in [TestRoom::rectangle(100.0, 60.0), atrium(40.0)] {
        let empty = EmptyRoom::new(room.level.room(0), &room.catalog, MOST_STEPS);
        let classes = ["chest", "desk"].map(|class| room.catalog.class_index(class).unwrap());
        let places = Answers::default().places_together(&empty, &classes);
        assert!(places.is_some(), "{} steps", empty.budget.made());
    }
}

#[test]
fn no_verdict_depends_on_those_before_it() {
    let room = lacking_a_chest(comb(3, 4.0));
    let mut other = lacking_a_chest(comb(3, 4.0));
    other.remove("desk", true);
    let solver = RoomSolver::new(room.level.room(0), &room.catalog);
    for one in [&room, &other, &room, &other] {
        let fresh = RoomSolver::new(room.level.room(0), &room.catalog);
        assert_eq!(solver.judge(&one.furnished()), fresh.judge(&one.furnished()));
        assert_eq!(solver.suggest_places(&one.furnished()), fresh.suggest_places(&one.furnished()));
    }
    let steps = solver.steps();
    let _ = solver.judge(&room.furnished());
    assert_eq!(solver.steps(), steps, "all of it is known");
}
