//! The findings of a room as a whole, and the time that a verdict takes.

use crate::audit::Code;
use crate::audit::testing::{TestRoom, required};
use crate::geometry::Point;
use crate::growth::growth;
use crate::layout::{Furnished, Parent};

#[test]
fn a_finding_with_a_known_answer_says_nothing_of_the_search() {
    let mut room = TestRoom::rectangle(5.0, 4.0);
    room.ask(required("chest"));
    room.remove("chest", true);
    let findings = room.audit();
    assert_eq!((findings[0].code, findings[0].not_searched_further), (Code::MissingRequired, false));
    assert!(serde_json::to_value(&findings[0]).unwrap().get("not_searched_further").is_none());
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
            drop(crate::solve::judge_room(room.level.room(0), &furnished, &room.catalog));
        };
        // From where a heap has as many neighbours as are looked at.
        let power = growth(480, 4, 1.3, furnish, judge);
        assert!(power < 1.3, "heap: {is_heap}: {power}");
    }
}

#[test]
fn findings_of_a_heap_grow_as_its_pieces_do() {
    let count = |tables: u32| hall(tables, true).audit().len();
    let (few, many) = (count(50), count(200));
    assert!(few > 100 && many < 5 * few, "{few}, then {many}");
}
