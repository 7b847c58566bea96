//! A table with a lamp on it, a stool and a chest in a room of 5 × 4 m.

use super::edits;
use crate::audit::testing::{TestRoom, at};
use crate::best::Judged;
use crate::edits::{Finished, finish};
use crate::layout::{Alternative, Furnished, Parent, Placement, Shortcomings};

fn room() -> TestRoom {
    let mut room = TestRoom::rectangle(5.0, 4.0);
    room.requested = Some(4);
    let table = room.stand("table", at(1.0, 2.0));
    let lamp = room.add("lamp", at(1.5, 2.0), Parent::Object(table));
    room.placements[lamp].elevation = 0.75;
    room.stand("stool", at(3.0, 1.0));
    room.stand("chest", at(4.0, 3.0));
    room
}

fn edited(room: &TestRoom, lines: &[&str]) -> Finished {
    let judged = Judged {
        furnished: room.furnished(),
        verdict: room.judge(),
        alternative: Alternative::default(),
        shortcomings: Shortcomings::default(),
    };
    let judge =
        |furnished: &Furnished| crate::solve::judge_room(room.level.room(0), furnished, &room.catalog);
    finish(&room.level, judged, &edits(lines), &room.catalog, judge)
}

/// The objects: id, place to the millimetre, height, degrees, id of the parent if that is an object.
fn shown(room: &TestRoom, lines: &[&str]) -> Vec<String> {
    let Furnished { placements, .. } = edited(room, lines).judged.furnished;
    let id =
        |placement: &Placement| format!("{}.{}", room.catalog.classes[placement.class].id, placement.number);
    let line = |placement: &Placement| {
        let on = match placement.parent {
            Parent::Object(parent) => format!(" on {}", id(&placements[parent])),
            _ => String::new(),
        };
        let place = placement.position;
        let degrees = placement.angle.to_degrees();
        format!("{} {:.3} {:.3} {:.2} {degrees:.0}{on}", id(placement), place.x, place.y, placement.elevation)
    };
    placements.iter().map(line).collect()
}

fn misfits(room: &TestRoom, lines: &[&str]) -> Vec<(bool, String)> {
    let Finished { misfits, .. } = edited(room, lines);
    misfits.into_iter().map(|misfit| (misfit.is_made, misfit.fault.message)).collect()
}

const AS_ARRANGED: [&str; 4] = [
    "table.1 1.000 2.000 0.00 0",
    "lamp.1 1.500 2.000 0.75 0 on table.1",
    "stool.1 3.000 1.000 0.00 0",
    "chest.1 4.000 3.000 0.00 0",
];

#[test]
fn without_edits_the_room_is_as_it_was_arranged() {
    let room = room();
    assert_eq!(shown(&room, &[]), AS_ARRANGED);
    let Finished { judged, misfits } = edited(&room, &["stool.1: {at: [3, 1]}"]);
    assert_eq!(judged.furnished.placements, room.placements, "to the last digit");
    assert_eq!((judged.verdict, misfits.len()), (room.judge(), 0));
}

#[test]
fn objects_on_an_edited_object_move_and_turn_with_it() {
    let shown = shown(&room(), &["table.1: {at: [2, 2], turn: 90}"]);
    assert_eq!(shown[..2], ["table.1 2.000 2.000 0.00 90", "lamp.1 2.000 2.500 0.75 90 on table.1"]);
    assert_eq!(shown[2..], AS_ARRANGED[2..]);
}

#[test]
fn a_place_on_an_object_is_in_its_frame() {
    let shown = shown(&room(), &["lamp.1: {at: [0, 0.2]}", "table.1: {turn: 180}"]);
    assert_eq!(shown[1], "lamp.1 1.000 1.800 0.75 180 on table.1");
}

#[test]
fn a_removed_object_takes_along_what_stands_on_it_unless_that_was_moved() {
    let room = room();
    assert_eq!(shown(&room, &["table.1: {remove: true}"]), AS_ARRANGED[2..]);
    let lamp = "lamp.1: {parent: chest.1, at: [0.1, 0]}";
    let kept = shown(&room, &["table.1: {remove: true}", lamp]);
    assert_eq!(kept, [AS_ARRANGED[3], "lamp.1 4.100 3.000 0.80 0 on chest.1", AS_ARRANGED[2]]);
}

#[test]
fn counts_follow_the_edits() {
    let requested = |lines: &[&str]| edited(&room(), lines).judged.furnished.requested;
    assert_eq!(requested(&["chest.1: {remove: true}"]), 3);
    assert_eq!(requested(&["stool.4: {add: true, at: [2, 3]}"]), 5);
}

#[test]
fn an_added_object_stands_on_its_parent_and_may_carry_others() {
    let chest = "chest.2: {add: true, parent: wall.0, at: [2, 0.5]}";
    let lamp = "lamp.7: {add: true, parent: chest.2, at: [0, 0]}";
    // With its back to the wall in the south it faces north; whichever is said first.
    for lines in [[chest, lamp], [lamp, chest]] {
        let shown = shown(&room(), &lines);
        assert_eq!(shown[4..], ["chest.2 2.000 0.500 0.00 180", "lamp.7 2.000 0.500 0.80 180 on chest.2"]);
    }
}

#[test]
fn an_id_that_is_taken_is_reported_and_the_next_one_given() {
    let lines = ["stool.1: {add: true, at: [2, 3]}"];
    assert_eq!(shown(&room(), &lines)[4], "stool.2 2.000 3.000 0.00 0");
    assert_eq!(
        misfits(&room(), &lines),
        [(true, "stool.1 is in the room already: the new one is stool.2".into())]
    );
}

#[test]
fn a_swapped_object_keeps_its_place_and_can_be_named_by_both_ids() {
    let swap = "stool.1: {class: chest}";
    assert_eq!(shown(&room(), &[swap])[2], "chest.2 3.000 1.000 0.00 0");
    for moved in ["chest.2: {at: [3, 1.5]}", "stool.1: {class: chest, at: [3, 1.5]}"] {
        let shown = shown(&room(), &[swap, moved]);
        assert_eq!(shown[2], "chest.2 3.000 1.500 0.00 0", "{moved}");
    }
}

#[test]
fn a_resized_object_keeps_its_back_to_the_wall_and_carries_what_stands_on_it() {
    let mut room = room();
    room.placements[0].parent = Parent::Wall(0);
    // The chest is 0.25 m deeper than the table, and 5 cm higher.
    let shown = shown(&room, &["table.1: {class: chest}"]);
    assert_eq!(shown[..2], ["chest.2 1.000 1.875 0.00 0", "lamp.1 1.500 1.875 0.80 0 on chest.2"]);
}

#[test]
fn edits_of_missing_objects_are_reported_and_change_nothing() {
    let room = room();
    let (gone, no_wall) = ("stool.9: {at: [1, 1]}", "stool.1: {parent: wall.9, at: [1, 1]}");
    assert_eq!(misfits(&room, &[gone]), [(false, "there is no stool.9 in room \"101\"".to_owned())]);
    assert_eq!(
        misfits(&room, &[no_wall]),
        [(false, "there is no wall.9 in room \"101\" to stand on".to_owned())]
    );
    assert_eq!(shown(&room, &[gone, no_wall]), AS_ARRANGED);
    assert_eq!(misfits(&room, &["stool.9: {variant: 0, at: [1, 1]}"]).len(), 1, "told once");
}

#[test]
fn nothing_stands_on_itself() {
    let lines = ["table.1: {parent: lamp.1, at: [0, 0]}"];
    assert_eq!(misfits(&room(), &lines), [(false, "lamp.1 stands on table.1 itself".to_owned())]);
    assert_eq!(shown(&room(), &lines), AS_ARRANGED);
}

#[test]
fn an_edited_object_that_collides_stays_and_is_reported() {
    let lines = ["stool.1: {at: [4, 3]}"];
    assert_eq!(shown(&room(), &lines)[2], "stool.1 4.000 3.000 0.00 0");
    let told = misfits(&room(), &lines);
    assert_eq!(told.len(), 1);
    assert!(told[0].0 && told[0].1.contains("collision of chest.1 and stool.1"), "{told:?}");
    assert_eq!(misfits(&room(), &["stool.1: {at: [2.5, 3]}"]), []);
}
