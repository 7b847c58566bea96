//! Openings on walls: rooms, edges, corners, neighbours; leaves and open boundaries.

use crate::geometry::Point;
use crate::plan::sample::{at, check_guarantees, level, neighbours, opening, points, rectangle};
use crate::plan::{
    LeafDraft, Level, LevelDraft, OpeningDraft, OpeningKind, OpeningPlace, Problem, RoomDraft, assemble_level,
};

fn assembled(rooms: Vec<RoomDraft>, openings: Vec<OpeningDraft>) -> (Level, Vec<Problem>) {
    let (level, problems) = assemble_level(level(rooms, openings));
    check_guarantees(&level);
    (level, problems)
}

fn rooms_of(level: &Level, opening: usize) -> Vec<&str> {
    level.openings[opening].sides.iter().map(|side| level.rooms[side.room].id.as_str()).collect()
}

/// Room `south` below two rooms whose wall meets it in the middle.
fn three() -> Vec<RoomDraft> {
    vec![
        rectangle("south", (0.0, 0.0), (6.0, 3.0)),
        rectangle("west", (0.0, 3.1), (2.95, 3.0)),
        rectangle("east", (3.05, 3.1), (2.95, 3.0)),
    ]
}

#[test]
fn a_door_at_a_corner_behind_leads_to_the_room_behind_most_of_it() {
    let door = opening("d", OpeningKind::Door, at(2.7, 3.05, (1.0, 0.0)), 0.9);
    let (level, problems) = assembled(three(), vec![door]);
    assert_eq!(problems, vec![]);
    assert_eq!(rooms_of(&level, 0), ["south", "west"]);
    // Moved from 2.25..3.15 into the wall of the western room.
    assert!((level.openings[0].center.x - 2.5).abs() < 1e-9);
    assert!((level.openings[0].width - 0.9).abs() < 1e-9);
}

#[test]
fn an_opening_joins_the_two_rooms_that_it_names() {
    let mut door = opening("d", OpeningKind::Door, at(2.7, 3.05, (1.0, 0.0)), 0.9);
    door.rooms = vec!["south".to_owned(), "west".to_owned()];
    let (level, problems) = assembled(three(), vec![door]);
    assert!(level.openings.is_empty());
    assert!(problems[0].message.contains("a wall of room \"west\" holds only 78 % of it"), "{problems:?}");
}

#[test]
fn named_rooms_far_from_each_other_are_reported() {
    let mut door = opening("d", OpeningKind::Door, at(4.45, 1.5, (0.0, 1.0)), 0.9);
    door.rooms = vec!["west".to_owned(), "east".to_owned()];
    let mut rooms = neighbours();
    rooms[1] = rectangle("east", (4.9, 0.0), (3.0, 3.0));
    let (_, problems) = assembled(rooms, vec![door]);
    let apart = problems.iter().find(|problem| problem.is_error).unwrap();
    assert!(apart.message.contains("do not face each other"), "{problems:?}");
}

#[test]
fn named_rooms_come_in_the_order_of_their_names_and_must_be_there() {
    let mut door = opening("d", OpeningKind::Door, at(1.0, 3.05, (1.0, 0.0)), 0.9);
    door.rooms = vec!["west".to_owned(), "south".to_owned()];
    let mut stray = door.clone();
    stray.id = "stray".to_owned();
    stray.rooms = vec!["east".to_owned(), "south".to_owned()];
    let (level, problems) = assembled(three(), vec![door, stray]);
    assert_eq!(rooms_of(&level, 0), ["west", "south"]);
    assert!(problems[0].message.contains("is on no wall of room \"east\""), "{problems:?}");
}

#[test]
fn an_opening_on_an_edge_follows_the_outline_as_drawn() {
    let mut room = rectangle("r", (0.0, 0.0), (4.0, 3.0));
    // Clockwise, from the north-west corner: edge 1 is the eastern one, from north to south.
    room.outline = points(&[(0.0, 3.0), (4.0, 3.0), (4.0, 0.0), (0.0, 0.0)]);
    let mut window = opening("w", OpeningKind::Window, OpeningPlace::Edge { edge: 1, at: 0.8 }, 1.0);
    window.rooms = vec!["r".to_owned()];
    let mut off = window.clone();
    (off.id, off.place) = ("off".to_owned(), OpeningPlace::Edge { edge: 1, at: 3.5 });
    let mut none = window.clone();
    (none.id, none.place) = ("none".to_owned(), OpeningPlace::Edge { edge: 4, at: 0.5 });
    let (level, problems) = assembled(vec![room], vec![window, off, none]);
    assert!(level.openings[0].center.distance(Point::new(4.15, 2.2)) < 1e-9);
    assert_eq!(problems[0].hint.as_deref(), Some("the edge is 3.000 m long"));
    assert_eq!(problems[1].hint.as_deref(), Some("the outline has 4 edges, counted from 0"));
}

#[test]
fn without_a_direction_the_nearest_wall_gives_it() {
    let place = OpeningPlace::Points { center: Point::new(0.2, 1.5), along: None };
    let (level, problems) = assembled(neighbours(), vec![opening("w", OpeningKind::Window, place, 1.0)]);
    assert_eq!(problems, vec![]);
    assert!(level.openings[0].along.x.abs() < 1e-9);
    assert_eq!(level.openings[0].sides[0].wall, 3);
}

#[test]
fn a_ribbon_window_is_cut_at_the_wall_between_the_rooms() {
    let window = opening("w", OpeningKind::Window, at(4.0, 0.0, (1.0, 0.0)), 4.0);
    let (level, problems) = assembled(neighbours(), vec![window]);
    assert_eq!(problems.len(), 1);
    assert!(!problems[0].is_error);
    let ids: Vec<&str> = level.openings.iter().map(|opening| opening.id.as_str()).collect();
    assert_eq!(ids, ["w", "w:2"]);
    assert_eq!((rooms_of(&level, 0), rooms_of(&level, 1)), (vec!["west"], vec!["east"]));
    assert!((level.openings[0].width - 2.0).abs() < 1e-9 && (level.openings[1].width - 1.8).abs() < 1e-9);
}

#[test]
fn a_window_onto_half_a_balcony_keeps_its_width() {
    let rooms = vec![rectangle("room", (0.0, 0.0), (4.0, 3.0)), rectangle("balcony", (2.0, 3.3), (4.0, 1.5))];
    let window = opening("w", OpeningKind::Window, at(2.0, 3.15, (1.0, 0.0)), 3.0);
    let (level, problems) = assembled(rooms, vec![window]);
    assert_eq!(problems, vec![]);
    let sides = &level.openings[0].sides;
    assert_eq!((sides.len(), level.openings[0].width), (2, 3.0));
    assert!((sides[1].to - sides[1].from - 1.5).abs() < 1e-9);
    assert!(level.openings[0].center.distance(Point::new(2.0, 3.15)) < 1e-9);
}

#[test]
fn the_door_has_the_wall_before_the_window() {
    let window = opening("w", OpeningKind::Window, at(1.5, 0.0, (1.0, 0.0)), 1.6);
    let door = opening("d", OpeningKind::Door, at(2.4, 0.0, (1.0, 0.0)), 0.9);
    let same = opening("same", OpeningKind::Door, at(2.4, 0.0, (1.0, 0.0)), 0.9);
    let (level, problems) = assembled(neighbours(), vec![window, door, same]);
    let ids: Vec<&str> = level.openings.iter().map(|opening| opening.id.as_str()).collect();
    assert_eq!(ids, ["w", "d"]);
    let [window, door] = [0, 1].map(|index| level.openings[index].sides[0]);
    assert!((door.from, door.to) == (1.95, 2.85) || (door.from - 1.95).abs() < 1e-9);
    assert!(window.to <= door.from && window.to - window.from > 1.1);
    assert!(problems[0].message.contains("other openings of room \"west\" take its place"), "{problems:?}");
}

#[test]
fn openings_end_at_the_ceiling_and_below_it_or_not_at_all() {
    let mut door = opening("d", OpeningKind::Door, at(1.0, 0.0, (1.0, 0.0)), 0.9);
    door.top = 9.0;
    let mut window = opening("w", OpeningKind::Window, at(3.0, 0.0, (1.0, 0.0)), 0.9);
    (window.bottom, window.top) = (2.9, 3.5);
    let mut upside_down = opening("u", OpeningKind::Window, at(3.0, 3.0, (1.0, 0.0)), 0.9);
    (upside_down.bottom, upside_down.top) = (2.0, 1.0);
    let (level, problems) = assembled(neighbours(), vec![door, window, upside_down]);
    assert_eq!(level.openings.len(), 1);
    assert!((level.openings[0].top - 2.7).abs() < 1e-9);
    assert!(problems[0].message.contains("begins at 2.90 m, its room ends at 2.70 m"), "{problems:?}");
    assert!(problems[1].message.contains("reaches from 2 m to 1 m height"), "{problems:?}");
}

fn leaf_of(leaf: LeafDraft, width: f64) -> Vec<[f64; 4]> {
    let mut door = opening("d", OpeningKind::Door, at(4.1, 1.5, (0.0, 1.0)), width);
    door.leaf = leaf;
    let (level, problems) = assembled(neighbours(), vec![door]);
    assert_eq!(problems, vec![]);
    let round = |value: f64| (value * 1000.0).round() / 1000.0;
    let leaves = level.openings[0].leaves.iter();
    leaves.map(|leaf| [leaf.hinge.x, leaf.hinge.y, leaf.open_tip.x, leaf.open_tip.y].map(round)).collect()
}

fn swing(hinge_left: bool, into: Option<&str>, count: u32) -> LeafDraft {
    LeafDraft::Swing { hinge_left, into: into.map(str::to_owned), count, angle: std::f64::consts::FRAC_PI_2 }
}

#[test]
fn swings_are_seen_from_the_room_they_open_into() {
    // From the western room one looks east at the door: left is north.
    assert_eq!(leaf_of(swing(true, Some("west"), 1), 1.0), [[4.0, 2.0, 3.0, 2.0]]);
    assert_eq!(leaf_of(swing(false, Some("west"), 1), 1.0), [[4.0, 1.0, 3.0, 1.0]]);
    // From the eastern room left is south.
    assert_eq!(leaf_of(swing(true, Some("east"), 1), 1.0), [[4.2, 1.0, 5.2, 1.0]]);
    let double = leaf_of(swing(true, Some("east"), 2), 1.0);
    assert_eq!(double, [[4.2, 1.0, 4.7, 1.0], [4.2, 2.0, 4.7, 2.0]]);
}

#[test]
fn wide_doors_have_two_leaves_and_passages_none() {
    assert_eq!(leaf_of(LeafDraft::Automatic, 1.3).len(), 1);
    assert_eq!(leaf_of(LeafDraft::Automatic, 1.5).len(), 2);
    assert!(leaf_of(LeafDraft::None, 0.9).is_empty());
    let passage = opening("p", OpeningKind::Passage, at(4.1, 1.5, (0.0, 1.0)), 1.0);
    let (level, _) = assembled(neighbours(), vec![passage]);
    assert!(level.openings[0].leaves.is_empty());
}

#[test]
fn a_door_to_the_open_air_opens_inwards_by_default() {
    let mut door = opening("d", OpeningKind::Door, at(1.0, 0.0, (1.0, 0.0)), 1.0);
    let (level, _) = assembled(neighbours(), vec![door.clone()]);
    assert!(level.openings[0].leaves[0].open_tip.y > 0.9);
    door.leaf = swing(true, None, 1);
    let (level, _) = assembled(neighbours(), vec![door]);
    // Hung in the outer face, 0.3 m behind; seen from outside, looking north, left is west.
    let leaf = level.openings[0].leaves[0];
    assert!(leaf.hinge.distance(Point::new(0.5, -0.3)) < 1e-9);
    assert!(leaf.open_tip.distance(Point::new(0.5, -1.3)) < 1e-9);
}

#[test]
fn a_leaf_avoids_the_column_behind_it() {
    let mut draft = level(neighbours(), vec![opening("d", OpeningKind::Door, at(4.1, 1.5, (0.0, 1.0)), 0.9)]);
    // The smaller room would be chosen, were it not for the columns in the way of both its swings.
    draft.obstacles = [1.0, 1.6]
        .map(|y| crate::plan::ObstacleDraft {
            outline: points(&[(4.7, y), (5.0, y), (5.0, y + 0.3), (4.7, y + 0.3)]),
            height: None,
        })
        .to_vec();
    let (level, _) = assemble_level(draft);
    assert!(level.openings[0].leaves[0].open_tip.x < 4.0);
}

#[test]
fn a_leaf_opens_out_of_a_room_that_it_would_fill() {
    // Into the corridor from a toilet of this depth, seen at the height of its tip.
    let opens_out = |depth: f64, width: f64| {
        let mut rooms = vec![
            rectangle("corridor", (0.0, 0.0), (4.0, 1.4)),
            rectangle("toilet", (0.0, 1.5), (1.0, depth)),
        ];
        rooms[0].room_type = "corridor".to_owned();
        let door = opening("d", OpeningKind::Door, at(0.5, 1.45, (1.0, 0.0)), width);
        let (level, problems) = assembled(rooms, vec![door]);
        assert_eq!(problems, vec![]);
        level.openings[0].leaves[0].open_tip.y < 1.4
    };
    assert!(opens_out(1.7, 0.8));
    assert!(!opens_out(2.6, 0.8), "there is room beside the leaf");
    assert!(!opens_out(1.7, 0.6), "a small leaf takes less of it");
}

#[test]
fn a_leaf_into_a_room_elsewhere_is_reported() {
    let mut door = opening("d", OpeningKind::Door, at(1.0, 0.0, (1.0, 0.0)), 1.0);
    door.leaf = swing(true, Some("east"), 1);
    let (_, problems) = assembled(neighbours(), vec![door]);
    assert!(problems[0].message.contains("opens into room \"east\", which it does not join"), "{problems:?}");
}

/// Two rooms that share an edge, with some walls drawn elsewhere.
fn joined() -> LevelDraft {
    let rooms = vec![rectangle("west", (0.0, 0.0), (4.0, 3.0)), rectangle("east", (4.0, 0.0), (3.0, 3.0))];
    let mut draft = level(rooms, Vec::new());
    draft.wall_outlines = vec![points(&[(0.0, -0.3), (7.0, -0.3), (7.0, 0.0), (0.0, 0.0)])];
    draft
}

fn boundaries(draft: LevelDraft) -> Vec<(String, f64)> {
    let (level, _) = assemble_level(draft);
    check_guarantees(&level);
    let open = level.openings.iter().filter(|opening| opening.kind == OpeningKind::OpenBoundary);
    open.map(|opening| (opening.id.clone(), (opening.width * 10.0).round() / 10.0)).collect()
}

#[test]
fn open_boundaries_need_a_drawing_a_floor_and_no_wall() {
    assert_eq!(boundaries(joined()), [("open:west:east".to_owned(), 3.0)]);
    let mut bare = joined();
    bare.wall_outlines.clear();
    assert_eq!(boundaries(bare), []);
    let mut hollow = joined();
    hollow.rooms[1].room_type = "void".to_owned();
    assert_eq!(boundaries(hollow), []);
    let mut railed = joined();
    railed.railings = vec![points(&[(3.97, 0.0), (4.03, 0.0), (4.03, 3.0), (3.97, 3.0)])];
    assert_eq!(boundaries(railed), []);
}

#[test]
fn stubs_and_doors_part_an_open_boundary() {
    let mut draft = joined();
    draft.wall_outlines.push(points(&[(3.95, 1.0), (4.05, 1.0), (4.05, 1.4), (3.95, 1.4)]));
    let parts = [("open:west:east".to_owned(), 1.0), ("open:west:east:2".to_owned(), 1.6)];
    assert_eq!(boundaries(draft), parts);
    let mut draft = joined();
    draft.openings = vec![opening("d", OpeningKind::Passage, at(4.0, 0.5, (0.0, 1.0)), 1.0)];
    assert_eq!(boundaries(draft), [("open:west:east".to_owned(), 2.0)]);
}

#[test]
fn an_open_boundary_leaves_no_post() {
    let mut draft = joined();
    draft.rooms[1] = rectangle("east", (4.01, 0.0105), (3.0, 2.95));
    let (level, _) = assemble_level(draft);
    check_guarantees(&level);
    let spans: Vec<[f64; 2]> =
        level.rooms.iter().map(|room| [room.openings[0].from, room.openings[0].to]).collect();
    assert_eq!(spans[0], [0.0, 3.0], "the wall in the west is longer by the width of a line");
    assert!(spans[1][0] < 1e-9 && (spans[1][1] - 2.95).abs() < 1e-9, "{spans:?}");
}

#[test]
fn an_opening_does_not_join_two_sides_of_a_narrow_room() {
    let rooms = vec![rectangle("slit", (0.0, 0.0), (4.0, 0.08))];
    let openings = vec![opening("w", OpeningKind::Window, at(2.0, 0.08, (1.0, 0.0)), 1.0)];
    let (level, _) = assembled(rooms, openings);
    assert_eq!(rooms_of(&level, 0), ["slit"]);
}

#[test]
fn gaps_between_spans_in_any_order() {
    let free = super::gaps(0.0, 10.0, vec![(6.0, 7.0), (-1.0, 1.0), (2.0, 3.0), (2.5, 4.0), (9.0, 12.0)]);
    assert_eq!(free, [(1.0, 2.0), (4.0, 6.0), (7.0, 9.0)]);
    assert_eq!(super::gaps(0.0, 10.0, Vec::new()), [(0.0, 10.0)]);
    assert_eq!(super::gaps(0.0, 10.0, vec![(-5.0, 20.0)]), []);
}
