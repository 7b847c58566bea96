//! Levels with difficult shells: corners, holes, columns, every kind of opening.

use roomwright::internals::geometry::{Polygon, Region};
use roomwright::internals::plan::{Level, OpeningKind, WallKind};

use crate::fixture::*;

pub(crate) const L_SHAPE: [(f64, f64); 6] =
    [(0.0, 0.0), (6.0, 0.0), (6.0, 2.5), (2.5, 2.5), (2.5, 5.0), (0.0, 5.0)];

/// Each with a name for messages.
pub(crate) fn all() -> Vec<(&'static str, Level)> {
    vec![
        ("two rooms", two_rooms()),
        ("concave with windows", concave()),
        ("hole and column", hole_and_column()),
        ("slanted walls, narrow nib", slanted()),
        ("outline folding back on itself", folding_back()),
        ("openings at corners", openings_at_corners()),
        ("door beside a corner", door_beside_a_corner()),
        ("corner of open sides", open_corner()),
        ("every kind of opening", every_kind()),
        ("no thickness", without_thickness()),
        ("balcony", balcony()),
    ]
}

fn window(id: &str, wall: usize, at: f64, width: f64) -> (String, [(usize, usize, f64); 1], f64) {
    (id.to_owned(), [(0, wall, at)], width)
}

fn add_window(level: &mut Level, (id, sides, width): (String, [(usize, usize, f64); 1], f64)) {
    let kind = OpeningKind::Window;
    add_opening(level, &OpeningPlan { kind, id: &id, sides: &sides, width, heights: (0.9, 2.2) });
}

pub(crate) fn concave() -> Level {
    let mut level = level(vec![room("1", &L_SHAPE)]);
    add_window(&mut level, window("a", 0, 1.5, 1.0));
    add_window(&mut level, window("b", 0, 3.5, 2.4));
    add_window(&mut level, window("c", 3, 1.2, 0.6));
    level
}

fn hole_and_column() -> Level {
    let outline = Polygon::rectangle(point(-3.0, -3.0), point(6.0, 6.0));
    let shaft = Polygon::rectangle(point(-0.5, -0.5), point(1.0, 1.5));
    let mut room = room_of_region("1", Region { outline, holes: vec![shaft] });
    room.obstacles = vec![column(point(2.0, 2.0), 0.2, 2.6), column(point(-2.0, -2.0), 0.15, 1.0)];
    level(vec![room])
}

fn slanted() -> Level {
    let corners = [
        (0.0, 0.0),
        (5.0, -1.0),
        (6.5, 3.0),
        (3.1, 3.5),
        (3.1, 2.5),
        (3.0, 2.5),
        (3.0, 3.5),
        (2.0, 6.0),
        (-1.0, 3.0),
        (-0.5, 1.5),
    ];
    let mut level = level(vec![room("1", &corners)]);
    add_window(&mut level, window("a", 1, 2.0, 1.4));
    level
}

/// A notch with next to no gap, as drawn plans have them, and a jog of a few millimetres.
fn folding_back() -> Level {
    let corners = [
        (0.0, 0.0),
        (6.0, 0.0),
        (6.0, 2.0),
        (6.004, 2.0),
        (6.004, 4.0),
        (3.0003, 4.0),
        (3.0, 1.5),
        (2.9997, 4.0),
        (0.0, 4.0),
    ];
    level(vec![room("1", &corners)])
}

fn openings_at_corners() -> Level {
    let mut level = level(vec![room("1", &L_SHAPE)]);
    // From the very start of a wall, up to its very end, side by side, and right behind a concave corner.
    add_window(&mut level, window("a", 0, 0.5, 1.0));
    add_window(&mut level, window("b", 0, 5.5, 1.0));
    add_window(&mut level, window("c", 4, 0.6, 1.0));
    add_window(&mut level, window("d", 4, 1.6, 1.0));
    add_window(&mut level, window("e", 2, 3.2, 0.6));
    add_window(&mut level, window("f", 3, 0.3, 0.6));
    let door = OpeningPlan {
        kind: OpeningKind::Door,
        id: "g",
        sides: &[(0, 5, 3.0)],
        width: 0.8,
        heights: (0.0, 9.0),
    };
    add_opening(&mut level, &door);
    level
}

/// A door nearer to a corner that points into the room than the walls are thick.
fn door_beside_a_corner() -> Level {
    let mut level = level(vec![room("1", &L_SHAPE)]);
    let door = OpeningPlan {
        kind: OpeningKind::Door,
        id: "a",
        sides: &[(0, 3, 0.6)],
        width: 0.9,
        heights: (0.0, 2.0),
    };
    add_opening(&mut level, &door);
    level
}

/// A kitchen in the corner of a living room: both of its inner sides are open as a whole.
pub(crate) fn open_corner() -> Level {
    let mut kitchen = room("1", &[(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]);
    let living = [(2.01, 0.0), (6.0, 0.0), (6.0, 5.0), (0.0, 5.0), (0.0, 2.01), (2.01, 2.01)];
    let mut living = room("2", &living);
    for wall in kitchen.walls[1..3].iter_mut().chain(&mut living.walls[4..]) {
        (wall.thickness, wall.is_exterior) = (0.0, false);
    }
    let mut level = level(vec![kitchen, living]);
    for (id, sides) in [("a", [(0, 1, 1.0), (1, 5, 1.0)]), ("b", [(0, 2, 1.0), (1, 4, 1.01)])] {
        let kind = OpeningKind::OpenBoundary;
        add_opening(&mut level, &OpeningPlan { kind, id, sides: &sides, width: 2.0, heights: (0.0, 2.6) });
    }
    level
}

pub(crate) fn every_kind() -> Level {
    let mut left = room("1", &[(0.0, 0.0), (5.0, 0.0), (5.0, 8.0), (0.0, 8.0)]);
    let mut right = room("2", &[(5.2, 0.0), (9.0, 0.0), (9.0, 8.0), (5.2, 8.0)]);
    right.height = 2.4;
    for wall in [&mut left.walls[1], &mut right.walls[3]] {
        (wall.thickness, wall.is_exterior) = (0.1, false);
    }
    let mut level = level(vec![left, right]);
    let between = |at: f64| [(0, 1, at), (1, 3, 8.0 - at)];
    let kinds = [
        (OpeningKind::OpenBoundary, "open", 1.0, 2.0, (0.0, 2.6)),
        (OpeningKind::Passage, "passage", 3.0, 1.0, (0.0, 2.2)),
        (OpeningKind::SlidingDoor, "sliding", 5.0, 1.6, (0.0, 2.2)),
        (OpeningKind::Door, "door", 6.6, 0.9, (0.0, 2.0)),
        (OpeningKind::Window, "hatch", 7.5, 0.5, (1.2, 1.8)),
    ];
    for (kind, id, at, width, heights) in kinds {
        add_opening(&mut level, &OpeningPlan { kind, id, sides: &between(at), width, heights });
    }
    let french = OpeningPlan {
        kind: OpeningKind::Window,
        id: "french",
        sides: &[(0, 0, 2.5)],
        width: 2.0,
        heights: (0.0, 2.4),
    };
    add_opening(&mut level, &french);
    level
}

fn without_thickness() -> Level {
    let mut level = every_kind();
    level.rooms.iter_mut().flat_map(|room| &mut room.walls).for_each(|wall| wall.thickness = 0.0);
    level
}

fn balcony() -> Level {
    let mut inside = room("1", &[(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)]);
    let mut outside = room("balcony", &[(0.0, -1.6), (4.0, -1.6), (4.0, -0.3), (0.0, -0.3)]);
    (inside.walls[0].thickness, inside.walls[0].is_exterior) = (0.15, false);
    (outside.walls[2].thickness, outside.walls[2].is_exterior) = (0.15, false);
    for (wall, thickness) in [(0, 0.0), (1, 0.2), (3, 0.0)] {
        outside.walls[wall].kind = WallKind::Railing(1.05);
        outside.walls[wall].thickness = thickness;
    }
    let mut level = level(vec![inside, outside]);
    let door = OpeningPlan {
        kind: OpeningKind::SlidingDoor,
        id: "1",
        sides: &[(0, 0, 2.0), (1, 2, 2.0)],
        width: 1.8,
        heights: (0.0, 2.2),
    };
    add_opening(&mut level, &door);
    level
}
