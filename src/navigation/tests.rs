use super::*;
use crate::audit::testing::{TestRoom, at};
use crate::catalog::Catalog;
use crate::geometry::{Point, ring_contains, signed_area};
use crate::layout::Furnished;
use crate::plan::{
    LeafDraft, Level, LevelDraft, OpeningDraft, OpeningKind, OpeningPlace, RoomDraft, assemble_level,
};

const AGENT: Agent = Agent { radius: 0.2, height: 1.5, step: 0.02 };

/// Two rooms of 4 × 3 m side by side, with 0.2 m of wall between them and a passage of 1 m in its middle.
fn two_rooms() -> Level {
    let room = |id: &str, x: f64| RoomDraft {
        id: id.to_owned(),
        outline: [(x, 0.0), (x + 4.0, 0.0), (x + 4.0, 3.0), (x, 3.0)].map(|(x, y)| Point::new(x, y)).to_vec(),
        ..RoomDraft::default()
    };
    let passage = OpeningDraft {
        id: "passage".to_owned(),
        kind: OpeningKind::Passage,
        place: OpeningPlace::Points { center: Point::new(4.1, 1.5), along: None },
        rooms: vec!["west".to_owned(), "east".to_owned()],
        width: 1.0,
        bottom: 0.0,
        top: 2.0,
        leaf: LeafDraft::Automatic,
    };
    let rooms = vec![room("west", 0.0), room("east", 4.2)];
    let draft = LevelDraft { height: 3.0, rooms, openings: vec![passage], ..LevelDraft::default() };
    let (level, faults) = assemble_level(draft);
    assert!(faults.is_empty(), "{faults:?}");
    level
}

fn mesh_of(level: &Level, furnished: &[Option<Furnished>], catalog: &Catalog, agent: Agent) -> MeshFile {
    mesh("house", &LevelFloor::new(level, furnished, catalog, agent), agent)
}

fn bare(room: usize) -> Option<Furnished> {
    let room_of_tests = TestRoom::rectangle(4.0, 3.0).furnished();
    Some(Furnished { room, placements: Vec::new(), ..room_of_tests })
}

fn corners(mesh: &MeshFile, polygon: &MeshPolygon) -> Vec<Point> {
    polygon.corners.iter().map(|&corner| Point::from_array(mesh.corners[corner as usize])).collect()
}

fn free(mesh: &MeshFile) -> f64 {
    mesh.polygons.iter().map(|polygon| signed_area(&corners(mesh, polygon))).sum()
}

#[test]
fn rooms_with_a_passage_are_one_island_and_without_one_two() {
    let mut level = two_rooms();
    let furnished = [bare(0), bare(1)];
    let catalog = TestRoom::rectangle(1.0, 1.0).catalog;
    let joined = mesh_of(&level, &furnished, &catalog, AGENT);
    // Two floors of 3.6 × 2.6 m, and 0.2 × 0.6 m in the wall with what is before it.
    let floors = 2.0 * 3.6 * 2.6;
    assert_eq!(joined.islands.len(), 1);
    assert!((floors + 0.12..floors + 0.5).contains(&free(&joined)), "{}", free(&joined));
    assert!((joined.islands[0] - free(&joined)).abs() < 1e-3);
    assert!(joined.unreached().is_empty());
    assert!(joined.polygons.iter().any(|polygon| polygon.part == Part::Opening("passage".to_owned())));
    level.openings[0].kind = OpeningKind::Window;
    let apart = mesh_of(&level, &furnished, &catalog, AGENT);
    assert_eq!((apart.islands.len(), apart.unreached().len()), (2, 1));
    assert!((free(&apart) - floors).abs() < 0.05);
}

#[test]
fn an_agent_wider_than_the_passage_stays_in_its_room_and_one_as_wide_passes() {
    let (level, furnished) = (two_rooms(), [bare(0), bare(1)]);
    let catalog = TestRoom::rectangle(1.0, 1.0).catalog;
    let islands =
        |radius: f64| mesh_of(&level, &furnished, &catalog, Agent { radius, ..AGENT }).islands.len();
    assert_eq!([islands(0.0), islands(0.45), islands(0.5), islands(0.51)], [1, 1, 1, 2]);
    assert_eq!(mesh_of(&level, &furnished, &catalog, Agent { radius: 9.0, ..AGENT }).polygons, []);
}

#[test]
fn polygons_are_convex_and_portals_lie_between_their_polygons() {
    let mut room = TestRoom::rectangle(6.0, 5.0);
    room.open(0, OpeningKind::Door, (1.0, 2.0), (0.0, 2.0));
    let chest = room.stand("chest", at(3.0, 2.5));
    room.placements[chest].angle = 0.3;
    room.stand("table", at(1.2, 3.9));
    let furnished = [Some(room.furnished())];
    let mesh = mesh_of(&room.level, &furnished, &room.catalog, AGENT);
    for polygon in &mesh.polygons {
        let corners = corners(&mesh, polygon);
        for index in 0..corners.len() {
            let [a, b, c] = [0, 1, 2].map(|step| corners[(index + step) % corners.len()]);
            assert!((b - a).perp_dot(c - b) >= -1e-9, "{corners:?}");
        }
        assert!(!ring_contains(&corners, at(3.0, 2.5)), "the chest stands there");
    }
    assert!(!mesh.portals.is_empty());
    for portal in &mesh.portals {
        let [left, right] = portal.ends.map(Point::from_array);
        let aside = (left - right).normalize().perp() * 0.002;
        let [from, to] = portal.polygons.map(|polygon| corners(&mesh, &mesh.polygons[polygon as usize]));
        // Who has the left end on the left goes away from the first polygon.
        let middle = (left + right) / 2.0;
        let is_in = |corners: &[Point], place: Point| ring_contains(corners, place);
        assert!(is_in(&from, middle + aside) && is_in(&to, middle - aside), "{portal:?}");
    }
}

#[test]
fn agents_pass_under_what_hangs_and_over_what_is_flat() {
    let mut room = TestRoom::rectangle(4.0, 4.0);
    room.open(0, OpeningKind::Door, (1.0, 2.0), (0.0, 2.0));
    let area = |room: &TestRoom, height: f64| {
        free(&mesh_of(&room.level, &[Some(room.furnished())], &room.catalog, Agent { height, ..AGENT }))
    };
    let empty = area(&room, 1.5);
    let lamp = room.stand("lamp", at(2.0, 2.0));
    room.placements[lamp].elevation = 1.8;
    assert_eq!(area(&room, 1.5), empty);
    assert!(area(&room, 1.9) < empty - 0.1);
    room.placements[lamp].elevation = 0.0;
    assert!(area(&room, 1.5) < empty - 0.1);
}

#[test]
fn wide_halls_are_cut_into_squares_without_losing_floor() {
    let hall = TestRoom::rectangle(50.0, 40.0);
    let mesh = mesh_of(&hall.level, &[Some(hall.furnished())], &hall.catalog, AGENT);
    assert_eq!((mesh.islands.len(), mesh.polygons.len()), (1, 12));
    assert!((free(&mesh) - 49.6 * 39.6).abs() < 1.0, "{}", free(&mesh));
}

#[test]
fn rooms_without_known_furniture_are_left_out() {
    let level = two_rooms();
    let catalog = TestRoom::rectangle(1.0, 1.0).catalog;
    let mesh = mesh_of(&level, &[None, bare(1)], &catalog, AGENT);
    assert_eq!(mesh.unreached(), ["west"]);
    let none = mesh_of(&level, &[], &catalog, AGENT);
    assert_eq!((none.polygons.len(), none.islands.len()), (0, 0));
    let map = occupancy(&LevelFloor::new(&level, &[], &catalog, AGENT), 0.05);
    assert_eq!(grey(&map, &[Point::ZERO]), [205]);
}

/// The grey of places of a map.
fn grey(map: &Occupancy, places: &[Point]) -> Vec<u8> {
    let mut reader = png::Decoder::new(std::io::Cursor::new(&map.picture)).read_info().unwrap();
    let (width, height) = (reader.info().width as usize, reader.info().height as usize);
    let mut pixels = vec![0; width * height];
    reader.next_frame(&mut pixels).unwrap();
    let text = map.description("map.png");
    let line = text.lines().find_map(|line| line.strip_prefix("origin: [")).unwrap();
    let origin: Vec<f64> = line.trim_end_matches(']').split(", ").map(|word| word.parse().unwrap()).collect();
    let pixel = |place: &Point| {
        let [column, row] = [place.x - origin[0], place.y - origin[1]].map(|metres| (metres / 0.05) as usize);
        pixels[(height - 1 - row) * width + column]
    };
    places.iter().map(pixel).collect()
}

#[test]
fn a_map_shows_floor_walls_furniture_and_what_is_unknown() {
    let mut room = TestRoom::rectangle(4.0, 3.0);
    room.open(0, OpeningKind::Door, (1.0, 2.0), (0.0, 2.0));
    room.stand("chest", at(3.0, 2.0));
    let furnished = [Some(room.furnished())];
    let map = occupancy(&LevelFloor::new(&room.level, &furnished, &room.catalog, AGENT), 0.05);
    let places = [
        at(1.0, 1.0),
        at(3.0, 2.0),
        at(3.4, 2.4),
        at(3.6, 2.0),
        at(-0.05, 1.0),
        at(1.5, -0.02),
        at(0.5, -0.05),
    ];
    assert_eq!(grey(&map, &places), [254, 0, 0, 254, 0, 254, 0]);
    let (level, catalog) = (two_rooms(), room.catalog);
    let map = occupancy(&LevelFloor::new(&level, &[bare(0), None], &catalog, AGENT), 0.05);
    assert_eq!(grey(&map, &[at(2.0, 2.0), at(4.1, 1.5), at(4.1, 0.5)]), [254, 254, 0]);
    assert!(map.description("a \"b\".png").starts_with("image: \"a \\\"b\\\".png\"\n"));
}
