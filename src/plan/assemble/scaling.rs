//! Time grows with the size of a plan by a power of 1.3 at most: twice the rooms take less than two and a half times as long.

use crate::growth::growth;
use crate::plan::sample::{at, level, opening, points, rectangle};
use crate::plan::{LevelDraft, ObstacleDraft, OpeningKind, OutlineKind, RoomDraft, assemble_level};

/// Power of the size by which time may grow.
const STEEPEST: f64 = 1.3;
/// Rooms of the smaller of two levels, and how many times as many the larger has.
const ROOMS: usize = 200;
const TIMES: usize = 8;

fn assert_steady(what: &str, draft: impl Fn(usize) -> LevelDraft) {
    let power = growth(ROOMS, TIMES, STEEPEST, draft, |draft| drop(assemble_level(draft)));
    assert!(power < STEEPEST, "{what}: time grows with the power {power:.2} of their number");
}

/// Rooms in rows and columns, this many metres apart.
fn rows(count: usize, width: f64, depth: f64, apart: f64) -> Vec<RoomDraft> {
    let across = (count as f64).sqrt().ceil() as usize;
    let place = |index: usize| ((index % across) as f64 * apart, (index / across) as f64 * apart);
    (0..count).map(|index| rectangle(&format!("r{index}"), place(index), (width, depth))).collect()
}

#[test]
fn many_rooms_of_a_level() {
    assert_steady("rooms on centre lines", |count| LevelDraft {
        outlines: OutlineKind::Center,
        ..level(rows(count, 4.0, 4.0, 4.0), Vec::new())
    });
}

#[test]
fn many_rooms_that_overlap_their_neighbours() {
    assert_steady("overlapping rooms", |count| level(rows(count, 4.0, 4.0, 3.0), Vec::new()));
}

#[test]
fn many_rooms_in_one_place() {
    let stacked = |count: usize| {
        let place = |index: usize| (index as f64 * 1e-4, index as f64 * 1e-4);
        (0..count).map(|index| rectangle(&format!("r{index}"), place(index), (4.0, 4.0))).collect()
    };
    assert_steady("rooms on each other", |count| level(stacked(count), Vec::new()));
}

#[test]
fn many_rooms_on_centre_lines_in_one_place() {
    assert_steady("rooms on each other on centre lines", |count| LevelDraft {
        outlines: OutlineKind::Center,
        ..level(
            (0..count * 2).map(|index| rectangle(&format!("r{index}"), (0.0, 0.0), (4.0, 4.0))).collect(),
            Vec::new(),
        )
    });
}

#[test]
fn many_rooms_drawn_inside_one() {
    assert_steady("rooms in a room", |count| {
        let mut rooms = rows(count, 3.0, 3.0, 4.0);
        let side = (count as f64).sqrt().ceil() * 4.0 + 2.0;
        rooms.push(rectangle("all", (-1.0, -1.0), (side, side)));
        level(rooms, Vec::new())
    });
}

#[test]
fn many_openings_of_one_wall() {
    assert_steady("openings of a wall", |count| {
        let place = |index: usize| at(0.3 + index as f64 * 0.4, 0.0, (1.0, 0.0));
        let window = |index: usize| opening(&format!("w{index}"), OpeningKind::Window, place(index), 0.3);
        let room = rectangle("hall", (0.0, 0.0), (count as f64 * 0.4 + 1.0, 4.0));
        level(vec![room], (0..count).map(window).collect())
    });
}

#[test]
fn many_windows_of_one_place() {
    assert_steady("windows in the same place", |count| {
        let window =
            |index: usize| opening(&format!("w{index}"), OpeningKind::Window, at(5.0, 0.0, (1.0, 0.0)), 1.0);
        level(vec![rectangle("hall", (0.0, 0.0), (10.0, 4.0))], (0..count).map(window).collect())
    });
}

#[test]
fn many_openings_that_name_rooms() {
    assert_steady("doors of unknown rooms", |count| {
        let door = |index: usize| {
            let mut door = opening(&format!("d{index}"), OpeningKind::Door, at(0.0, 0.0, (1.0, 0.0)), 1.0);
            door.rooms = vec![format!("nowhere{index}")];
            door
        };
        level(rows(count, 3.0, 3.0, 4.0), (0..count).map(door).collect())
    });
}

#[test]
fn many_columns() {
    assert_steady("columns", |count| {
        let rooms = rows(count, 3.0, 3.0, 4.0);
        let column = |room: &RoomDraft| {
            let (x, y) = (room.outline[0].x + 1.0, room.outline[0].y + 1.0);
            let outline = points(&[(x, y), (x + 0.3, y), (x + 0.3, y + 0.3), (x, y + 0.3)]);
            ObstacleDraft { outline, height: None }
        };
        let obstacles = rooms.iter().map(column).collect();
        LevelDraft { obstacles, ..level(rooms, Vec::new()) }
    });
}

#[test]
fn many_rooms_whose_numbers_are_taken() {
    assert_steady("numbers", |count| {
        let mut rooms = rows(count, 3.0, 3.0, 4.0);
        for (index, room) in rooms.iter_mut().enumerate().take(count / 2) {
            room.number = Some((count / 2 + index) as u32 + 1);
        }
        level(rooms, Vec::new())
    });
}

#[test]
fn many_gaps_between_the_same_two_rooms() {
    assert_steady("stubs of walls", |count| {
        let length = count as f64 * 0.6;
        let mut draft = level(
            vec![rectangle("west", (0.0, 0.0), (4.0, length)), rectangle("east", (4.0, 0.0), (4.0, length))],
            Vec::new(),
        );
        let stub = |index: usize| {
            let y = index as f64 * 0.67;
            points(&[(3.95, y), (4.05, y), (4.05, y + 0.05), (3.95, y + 0.05)])
        };
        draft.wall_outlines = (0..count * 7 / 8).map(stub).collect();
        draft
    });
}
