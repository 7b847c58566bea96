//! Levels of a few rooms, step by step.

use crate::geometry::Point;
use crate::plan::sample::{at, check_guarantees, level, neighbours, opening, points, rectangle};
use crate::plan::{
    LevelDraft, ObstacleDraft, OpeningKind, OutlineKind, RoomDraft, Subject, WallKind, assemble_level,
};

#[test]
fn a_door_joins_the_rooms_on_both_sides_of_its_wall() {
    let door = opening("d", OpeningKind::Door, at(4.1, 1.0, (0.0, 1.0)), 0.9);
    let (level, problems) = assemble_level(level(neighbours(), vec![door]));
    check_guarantees(&level);
    assert_eq!(problems, vec![]);
    let door = &level.openings[0];
    assert_eq!(door.sides.iter().map(|side| side.room).collect::<Vec<_>>(), [0, 1]);
    assert!((door.sides[0].from - 0.55).abs() < 1e-9 && (door.sides[0].to - 1.45).abs() < 1e-9);
    assert!(door.center.distance(Point::new(4.1, 1.0)) < 1e-9);
    let wall = &level.rooms[0].walls[door.sides[0].wall];
    assert!((wall.thickness - 0.1).abs() < 1e-9 && !wall.is_exterior);
    assert_eq!(wall.tags, ["door", "interior"]);
}

#[test]
fn an_outline_with_a_small_loop_is_a_room_and_a_bow_tie_is_none() {
    // Around a duct at the first corner, and then around the room.
    let duct = [(0.0, 0.0), (-0.3, 0.5), (0.0, 0.8), (0.3, 0.5)];
    let mut looped = duct.to_vec();
    looped.extend([(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (-1.0, 3.0), (-1.0, 0.0)]);
    // A loop in the upper edge.
    let crossed = [(6.0, 0.0), (10.0, 0.0), (10.0, 3.0), (8.0, 3.0), (8.3, 3.3), (8.3, 2.7), (6.0, 3.0)];
    let bow = [(20.0, 0.0), (24.0, 3.0), (24.0, 0.0), (20.0, 3.0)];
    let rooms = [("looped", &looped[..]), ("crossed", &crossed[..]), ("bow", &bow[..])];
    let rooms = rooms
        .map(|(id, outline)| RoomDraft { outline: points(outline), ..rectangle(id, (0.0, 0.0), (1.0, 1.0)) });
    let (level, problems) = assemble_level(level(rooms.to_vec(), Vec::new()));
    check_guarantees(&level);
    let areas: Vec<f64> = level.rooms.iter().map(|room| room.region.area()).collect();
    assert_eq!(areas.len(), 2, "{problems:?}");
    // Without the duct of 0.24 m², and the slit that opens it to the outside.
    assert!((areas[0] - 14.75).abs() < 0.01, "{areas:?}");
    assert!((areas[1] - 11.655).abs() < 0.01, "{areas:?}");
    let is_error: Vec<bool> = problems.iter().map(|problem| problem.is_error).collect();
    assert_eq!(is_error, [false, false, true], "{problems:?}");
}

#[test]
fn outer_walls_have_the_outer_thickness_and_every_room_its_tags() {
    let window = opening("w", OpeningKind::Window, at(2.0, 0.0, (1.0, 0.0)), 1.2);
    let door = opening("d", OpeningKind::Door, at(4.1, 1.0, (0.0, 1.0)), 0.9);
    let (level, problems) = assemble_level(level(neighbours(), vec![window, door]));
    check_guarantees(&level);
    assert_eq!(problems, vec![]);
    let walls = &level.rooms[0].walls;
    assert_eq!(walls[0].tags, ["exterior", "longest", "window"]);
    assert_eq!(walls[1].tags, ["door", "interior"]);
    assert_eq!(walls[2].tags, ["blind", "exterior"]);
    assert_eq!(walls[3].tags, ["blind", "end", "exterior", "opposite_door"]);
    assert!((walls[0].thickness - 0.3).abs() < 1e-12);
    // Half way through the outer wall.
    assert!(level.openings[0].center.distance(Point::new(2.0, -0.15)) < 1e-9);
}

#[test]
fn the_end_of_a_room_is_that_of_its_long_axis_away_from_the_door() {
    let hall = || rectangle("hall", (0.0, 0.0), (12.0, 6.0));
    let ends = |door: (f64, f64), way: (f64, f64)| -> Vec<usize> {
        let door = opening("d", OpeningKind::Door, at(door.0, door.1, way), 0.9);
        let (level, problems) = assemble_level(level(vec![hall()], vec![door]));
        assert_eq!(problems, vec![]);
        let walls = level.rooms[0].walls.iter().enumerate();
        walls.filter(|(_, wall)| wall.tags.iter().any(|tag| tag == "end")).map(|(index, _)| index).collect()
    };
    assert_eq!(ends((0.0, 3.0), (0.0, 1.0)), [1], "the east wall, across from a door in the west");
    assert_eq!(ends((12.0, 3.0), (0.0, 1.0)), [3]);
    assert_eq!(ends((10.0, 0.0), (1.0, 0.0)), [3], "also where the door is in a long wall");
}

#[test]
fn center_lines_move_in_by_half_a_wall_where_rooms_meet() {
    let rooms = vec![rectangle("west", (0.0, 0.0), (4.0, 3.0)), rectangle("east", (4.0, 0.0), (3.0, 3.0))];
    let door = opening("d", OpeningKind::Door, at(4.0, 1.5, (0.0, 1.0)), 0.8);
    let draft = LevelDraft { outlines: OutlineKind::Center, ..level(rooms, vec![door]) };
    let (level, problems) = assemble_level(draft);
    check_guarantees(&level);
    assert_eq!(problems, vec![]);
    assert!((level.rooms[0].region.area() - 3.95 * 3.0).abs() < 1e-9);
    assert!((level.rooms[1].region.area() - 2.95 * 3.0).abs() < 1e-9);
    assert!((level.rooms[0].walls[1].thickness - 0.05).abs() < 1e-9);
    assert_eq!(level.openings[0].sides.len(), 2);
}

#[test]
fn a_corridor_narrower_than_its_walls_is_not_lost() {
    let rooms = vec![
        rectangle("south", (0.0, 0.0), (4.0, 3.0)),
        rectangle("slot", (0.0, 3.0), (4.0, 0.08)),
        rectangle("north", (0.0, 3.08), (4.0, 3.0)),
    ];
    let draft = LevelDraft { outlines: OutlineKind::Center, ..level(rooms, Vec::new()) };
    let (level, problems) = assemble_level(draft);
    check_guarantees(&level);
    assert_eq!((level.rooms.len(), problems.len()), (3, 0));
}

#[test]
fn edge_tags_follow_their_edge_through_a_clockwise_ring() {
    let mut room = rectangle("r", (0.0, 0.0), (4.0, 3.0));
    room.outline = points(&[(0.0, 0.0), (0.0, 3.0), (4.0, 3.0), (4.0, 0.0), (0.0, 0.0)]);
    room.edge_tags = vec![(0, "west".to_owned()), (1, "north".to_owned())];
    let (level, problems) = assemble_level(level(vec![room], Vec::new()));
    check_guarantees(&level);
    assert_eq!(problems, vec![]);
    for wall in &level.rooms[0].walls {
        let (is_west, is_north) = (wall.normal().x > 0.9, wall.normal().y < -0.9);
        assert_eq!(wall.tags.contains(&"west".to_owned()), is_west);
        assert_eq!(wall.tags.contains(&"north".to_owned()), is_north);
    }
}

#[test]
fn a_crossing_outline_names_the_corner_and_is_left_out() {
    let mut room = rectangle("bow", (0.0, 0.0), (1.0, 1.0));
    room.outline = points(&[(0.0, 0.0), (2.0, 2.0), (2.0, 0.0), (0.0, 2.0)]);
    let (level, problems) = assemble_level(level(vec![room], Vec::new()));
    assert!(level.rooms.is_empty());
    assert_eq!(problems[0].subject, Subject::RoomCorner(0, 0));
    assert!(problems[0].is_error);
}

#[test]
fn openings_that_cannot_be_attached_are_reported() {
    let lost = opening("lost", OpeningKind::Door, at(20.0, 1.0, (0.0, 1.0)), 0.9);
    let wide = opening("wide", OpeningKind::Door, at(4.1, 1.5, (0.0, 1.0)), 5.0);
    let mut stranger = opening("stranger", OpeningKind::Door, at(4.1, 1.5, (0.0, 1.0)), 0.9);
    stranger.rooms = vec!["wets".to_owned()];
    let (level, problems) = assemble_level(level(neighbours(), vec![lost, wide, stranger]));
    assert!(level.openings.is_empty());
    let texts: Vec<&str> = problems.iter().map(|problem| problem.message.as_str()).collect();
    assert!(texts[0].contains("is on no wall"), "{texts:?}");
    assert!(texts[1].contains("holds only 60 % of it"), "{texts:?}");
    assert!(texts[2].contains("unknown room \"wets\""), "{texts:?}");
    assert_eq!(problems[2].hint.as_deref(), Some("did you mean \"west\"?"));
}

#[test]
fn a_door_over_a_corner_is_moved_into_its_wall() {
    let door = opening("d", OpeningKind::Door, at(4.1, 0.35, (0.0, 1.0)), 0.9);
    let (level, problems) = assemble_level(level(neighbours(), vec![door]));
    check_guarantees(&level);
    assert_eq!(problems, vec![]);
    assert!((level.openings[0].width - 0.9).abs() < 1e-9);
    assert!(level.openings[0].sides[0].from.abs() < 1e-9);
}

#[test]
fn a_leaf_opens_away_from_the_corridor_against_the_nearer_wall() {
    let mut rooms = neighbours();
    rooms[0].room_type = "corridor".to_owned();
    let door = opening("d", OpeningKind::Door, at(4.1, 0.6, (0.0, 1.0)), 0.9);
    let (level, _) = assemble_level(level(rooms, vec![door]));
    let leaf = level.openings[0].leaves[0];
    assert!(leaf.hinge.distance(Point::new(4.2, 0.15)) < 1e-9);
    assert!(leaf.open_tip.distance(Point::new(5.1, 0.15)) < 1e-9);
}

#[test]
fn rooms_that_meet_without_a_drawn_wall_are_open_to_each_other() {
    let rooms = vec![rectangle("west", (0.0, 0.0), (4.0, 3.0)), rectangle("east", (4.0, 0.0), (3.0, 3.0))];
    let mut draft = level(rooms, Vec::new());
    draft.wall_outlines = vec![points(&[(3.95, 2.0), (4.05, 2.0), (4.05, 3.0), (3.95, 3.0)])];
    let (level, problems) = assemble_level(draft);
    check_guarantees(&level);
    assert_eq!(problems, vec![]);
    let boundary = &level.openings[0];
    assert_eq!((boundary.kind, boundary.id.as_str()), (OpeningKind::OpenBoundary, "open:west:east"));
    assert!((boundary.width - 2.0).abs() < 0.06, "{}", boundary.width);
}

#[test]
fn columns_are_cut_to_the_rooms_they_stand_in() {
    let mut draft = level(neighbours(), Vec::new());
    let column = |list: &[(f64, f64)]| ObstacleDraft { outline: points(list), height: None };
    draft.obstacles = vec![
        column(&[(3.8, 1.0), (4.4, 1.0), (4.4, 1.5), (3.8, 1.5)]),
        column(&[(30.0, 1.0), (31.0, 1.0), (31.0, 2.0)]),
    ];
    let (level, problems) = assemble_level(draft);
    check_guarantees(&level);
    assert!((level.rooms[0].obstacles[0].outline.area() - 0.1).abs() < 1e-6);
    assert!((level.rooms[1].obstacles[0].outline.area() - 0.1).abs() < 1e-6);
    assert_eq!(level.rooms[0].obstacles[0].height, level.rooms[0].height);
    assert_eq!(problems.len(), 1);
    assert!(!problems[0].is_error);
}

#[test]
fn railings_are_known_by_their_outline() {
    let mut draft = level(neighbours(), Vec::new());
    draft.railings = vec![points(&[(0.0, -0.1), (4.0, -0.1), (4.0, 0.0), (0.0, 0.0)])];
    let (level, _) = assemble_level(draft);
    assert!(matches!(level.rooms[0].walls[0].kind, WallKind::Railing(_)));
    assert_eq!(level.rooms[0].walls[1].kind, WallKind::Solid);
}

#[test]
fn a_wall_at_which_a_railing_ends_stays_a_wall() {
    // A step in the south wall, as wide as the railing that comes from the south.
    let outline =
        [(0.0, 0.0), (1.0, 0.0), (1.0, 0.03), (1.14, 0.03), (1.14, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)];
    let room = RoomDraft { outline: points(&outline), ..rectangle("room", (0.0, 0.0), (4.0, 3.0)) };
    let mut draft = level(vec![room], Vec::new());
    draft.railings = vec![points(&[(1.0, -4.0), (1.14, -4.0), (1.14, 0.03), (1.0, 0.03)])];
    let (level, _) = assemble_level(draft);
    assert!(
        level.rooms[0].walls.iter().all(|wall| wall.kind == WallKind::Solid),
        "{:?}",
        level.rooms[0].walls
    );
}

/// A bathroom from x = 0 to 3 with a neighbour of a type on the other side of 0.2 m of wall, and a shaft that begins some
/// metres behind its north wall. Answers which of its walls, south, east, north and west, have pipes.
fn walls_with_pipes(neighbour: &str, shaft_distance: f64) -> Vec<usize> {
    let of_type = |room_type: &str, room: RoomDraft| RoomDraft { room_type: room_type.to_owned(), ..room };
    let rooms = vec![
        of_type("bathroom", rectangle("bath", (0.0, 0.0), (3.0, 2.0))),
        of_type(neighbour, rectangle("east", (3.2, 0.0), (3.0, 2.0))),
        of_type("shaft", rectangle("shaft", (1.0, 2.0 + shaft_distance), (0.5, 0.4))),
    ];
    let (level, _) = assemble_level(level(rooms, Vec::new()));
    let walls = level.rooms[0].walls.iter().enumerate();
    walls.filter(|(_, wall)| wall.tags.iter().any(|tag| tag == "pipes")).map(|(index, _)| index).collect()
}

#[test]
fn pipes_run_at_the_shaft_or_else_between_wet_rooms() {
    assert_eq!(walls_with_pipes("bedroom", 0.2), [2], "the shaft is behind the north wall");
    assert_eq!(walls_with_pipes("kitchen", 0.2), [2], "a shaft comes before a wet room");
    assert_eq!(walls_with_pipes("kitchen", 2.0), [1], "the shaft is too far away");
    assert!(walls_with_pipes("bedroom", 2.0).is_empty());
}

#[test]
fn equal_levels_have_equal_digests_and_a_moved_corner_another() {
    let (first, _) = assemble_level(level(neighbours(), Vec::new()));
    let (again, _) = assemble_level(level(neighbours(), Vec::new()));
    let mut rooms = neighbours();
    rooms[1].outline[0].y -= 0.1;
    let (moved, _) = assemble_level(level(rooms, Vec::new()));
    assert_eq!(first.digest, again.digest);
    assert_ne!(first.digest, moved.digest);
}

#[test]
fn equal_ids_and_numbers_are_reported() {
    let mut rooms = vec![rectangle("a", (0.0, 0.0), (2.0, 2.0)), rectangle("a", (5.0, 0.0), (2.0, 2.0))];
    rooms.push(RoomDraft { number: Some(7), ..rectangle("b", (9.0, 0.0), (2.0, 2.0)) });
    rooms.push(RoomDraft { number: Some(7), ..rectangle("c", (13.0, 0.0), (2.0, 2.0)) });
    let (level, problems) = assemble_level(level(rooms, Vec::new()));
    check_guarantees(&level);
    assert_eq!(level.rooms.len(), 3);
    assert!(problems.iter().all(|problem| problem.is_error));
    assert_eq!(problems.len(), 2);
}
