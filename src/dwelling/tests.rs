//! Dwellings drawn as squares in a row: who lives there, and what that makes of their rooms.

use std::sync::Arc;

use super::Occupancy;
use crate::catalog::{Catalog, builtin_catalog};
use crate::geometry::{Point, Polygon, Region};
use crate::plan::{Building, Level, Opening, OpeningKind, OpeningSide, Room, RoomOpening};

/// Metres between the west walls of neighbouring rooms.
const PITCH: f64 = 10.0;

/// A room of a type and so many square metres, with a window in its south wall.
fn room(place: usize, kind: &str, area: f64) -> Room {
    let (west, width) = (place as f64 * PITCH, area / 4.0);
    let corners = [(west, 0.0), (west + width, 0.0), (west + width, 4.0), (west, 4.0)];
    let outline = Polygon::new(&corners.map(|(x, y)| Point::new(x, y))).unwrap();
    Room::bare(&format!("{kind}-{place}"), kind, Region::simple(outline), 2.5, 0.1)
}

fn opening(id: String, kind: OpeningKind, rooms: &[usize]) -> Opening {
    let sides = rooms.iter().map(|&room| OpeningSide { room, wall: 0, from: 0.1, to: 0.9 });
    Opening {
        id,
        kind,
        center: Point::ZERO,
        along: Point::X,
        width: 0.8,
        bottom: 0.0,
        top: 2.0,
        leaves: Vec::new(),
        sides: sides.collect(),
    }
}

/// A flat of rooms that all have a window and a door to the first of them.
fn flat(rooms: &[(&str, f64)]) -> Building {
    building(vec![level("ground", rooms)])
}

fn building(levels: Vec<Level>) -> Building {
    Building { name: None, attribution: None, levels }
}

fn level(id: &str, rooms: &[(&str, f64)]) -> Level {
    let rooms = rooms.iter().enumerate().map(|(place, (kind, area))| room(place, kind, *area)).collect();
    let mut level = Level::bare(id, 3.0, rooms);
    for index in 0..level.rooms.len() {
        open(&mut level, OpeningKind::Window, &[index]);
        if index > 0 {
            open(&mut level, OpeningKind::Door, &[0, index]);
        }
    }
    level
}

fn open(level: &mut Level, kind: OpeningKind, rooms: &[usize]) {
    let number = level.openings.len();
    level.openings.push(opening(format!("o{number}"), kind, rooms));
    for &room in rooms {
        level.rooms[room].openings.push(RoomOpening { opening: number, wall: 0, from: 0.1, to: 0.9 });
    }
}

fn catalog() -> &'static Catalog {
    builtin_catalog()
}

/// The rooms of a building's first level with the people of a seed.
fn rooms(building: &Building, seed: u64, catalog: &Catalog) -> Vec<Room> {
    let building = Arc::new(building.clone());
    Occupancy::new(&building, "b", &catalog.households, seed).apply(&building).levels[0].rooms.to_vec()
}

fn types(rooms: &[Room]) -> Vec<&str> {
    rooms.iter().map(|room| room.room_type.as_str()).collect()
}

/// The types of rooms where a household lives that the plan names.
fn types_with(household: &str, of: &[(&str, f64)]) -> Vec<String> {
    let mut building = flat(of);
    building.levels[0].rooms[0].household = Some(household.to_owned());
    let rooms = rooms(&building, 1, catalog());
    assert!(rooms.iter().all(|room| room.home.as_ref().unwrap().household == household));
    types(&rooms).into_iter().map(str::to_owned).collect()
}

const FLAT: [(&str, f64); 7] = [
    ("corridor", 8.0),
    ("kitchen", 7.0),
    ("bathroom", 5.0),
    ("room", 14.0),
    ("room", 24.0),
    ("room", 16.0),
    ("room", 10.0),
];

#[test]
fn the_largest_open_room_is_the_only_living_room_and_the_next_the_main_bedroom() {
    let (catalog, building) = (catalog(), flat(&FLAT));
    for seed in 0..40 {
        let rooms = rooms(&building, seed, catalog);
        let types = types(&rooms);
        assert_eq!(types[4], "living_dining", "the kitchen has no room for a table");
        assert!(["main_bedroom", "elders_bedroom", "shared_room"].contains(&types[5]), "{types:?}");
        let living = types.iter().filter(|kind| catalog.households.homes.living.contains(**kind)).count();
        assert_eq!(living, 1, "{types:?}");
        assert!(!types.contains(&"room"), "{types:?}");
        assert_eq!(rooms[5].home.as_ref().unwrap().planned_type.as_deref(), Some("room"));
    }
}

#[test]
fn rooms_follow_from_who_lives_there() {
    let roles = |household| types_with(household, &FLAT)[3..].to_vec();
    assert_eq!(roles("family_2")[0], "childrens_room");
    assert_eq!(roles("family_2")[3], "childrens_room");
    assert_eq!(roles("shared_flat"), ["shared_room", "living_dining", "shared_room", "shared_room"]);
    assert_eq!(roles("old_couple"), ["guest_bedroom", "living_dining", "elders_bedroom", "guest_bedroom"]);
    let small = [
        ("corridor", 8.0),
        ("kitchen", 14.0),
        ("bathroom", 5.0),
        ("room", 20.0),
        ("room", 16.0),
        ("room", 12.0),
    ];
    let of_two = types_with("family_2", &small);
    assert_eq!(
        of_two[3..],
        ["living_room", "main_bedroom", "shared_childrens_room"],
        "a kitchen with a table"
    );
}

#[test]
fn what_a_plan_names_stays_and_says_who_lives_there() {
    let catalog = catalog();
    let mut named = FLAT;
    (named[3].0, named[5].0, named[6].0) = ("childrens_room", "bedroom", "study");
    let building = flat(&named);
    for seed in 0..40 {
        let rooms = rooms(&building, seed, catalog);
        assert_eq!(types(&rooms)[3..], ["childrens_room", "living_dining", "main_bedroom", "study"]);
        assert!(rooms[0].home.as_ref().unwrap().household.starts_with("family"), "{:?}", rooms[0].home);
    }
}

#[test]
fn one_room_with_a_bath_is_lived_and_slept_in_and_without_one_lived_in_only() {
    let studio = [("corridor", 4.0), ("kitchen", 4.0), ("bathroom", 4.0), ("room", 22.0)];
    let catalog = catalog();
    assert_eq!(types(&rooms(&flat(&studio), 3, catalog))[3], "studio");
    let below = [("corridor", 4.0), ("kitchen", 4.0), ("toilet", 2.0), ("room", 22.0)];
    assert_eq!(types(&rooms(&flat(&below), 3, catalog))[3], "living_dining");
}

#[test]
fn a_second_living_room_has_no_screen() {
    let mut two = FLAT;
    (two[4].0, two[5].0) = ("living_room", "living_room");
    assert_eq!(types(&rooms(&flat(&two), 1, catalog()))[4..6], ["living_room", "sitting_room"]);
}

#[test]
fn people_cook_in_their_living_room_where_the_plan_names_no_kitchen() {
    let catalog = catalog();
    let role = |bath: &str, (living, area): (&str, f64), other: &str| {
        let flat = flat(&[("corridor", 6.0), (bath, 4.0), (living, area), (other, 14.0)]);
        rooms(&flat, 1, catalog)[2].room_type.clone()
    };
    let living_room = |bath: &str, other: &str, area: f64| role(bath, ("living_dining", area), other);
    let studio = |bath: &str, other: &str, area: f64| role(bath, ("studio", area), other);
    assert_eq!(living_room("bathroom", "bedroom", 26.0), "living_kitchen");
    assert_eq!(living_room("bathroom", "bedroom", 16.0), "living_dining", "no room for a row");
    assert_eq!(living_room("bathroom", "kitchen", 26.0), "living_dining");
    assert_eq!(studio("bathroom", "storeroom", 20.0), "studio_kitchen");
    assert_eq!(studio("bathroom", "storeroom", 14.0), "studio", "no room for a row");
    assert_eq!(studio("bathroom", "kitchenette", 20.0), "studio");
    // A floor of a larger dwelling.
    assert_eq!(studio("toilet", "storeroom", 20.0), "studio");
    assert_eq!(living_room("toilet", "bedroom", 26.0), "living_dining");
    assert_eq!(living_room("bathroom", "study", 26.0), "living_dining");
}

#[test]
fn offices_hotels_and_rooms_by_themselves_are_no_dwellings() {
    let catalog = catalog();
    for others in
        [&[("corridor", 8.0), ("kitchen", 8.0), ("office", 20.0), ("room", 20.0)][..], &[("room", 20.0)]]
    {
        let rooms = rooms(&flat(others), 1, catalog);
        assert!(rooms.iter().all(|room| room.home.is_none()));
        assert_eq!(types(&rooms).last(), Some(&"room"));
    }
}

#[test]
fn a_dwelling_keeps_its_people_whatever_is_beside_it() {
    let catalog = catalog();
    let alone = building(vec![Level { rooms: named_flat(0, "1").into(), ..level("ground", &[]) }]);
    let mut both = alone.clone();
    both.levels[0].rooms.splice(0..0, named_flat(20, "2"));
    for seed in 0..20 {
        let (alone, both) = (rooms(&alone, seed, catalog), rooms(&both, seed, catalog));
        assert_eq!(types(&alone), types(&both)[FLAT.len()..]);
        assert_eq!(alone[0].home, both[FLAT.len()].home);
    }
}

/// The rooms of a flat that the plan names.
fn named_flat(first: usize, name: &str) -> Vec<Room> {
    let rooms = FLAT.iter().enumerate().map(|(place, (kind, area))| room(first + place, kind, *area));
    rooms.map(|room| Room { dwelling: Some(name.to_owned()), ..room }).collect()
}

#[test]
fn a_house_with_one_kitchen_is_one_dwelling_on_all_levels() {
    let ground = level("ground", &[("corridor", 8.0), ("kitchen", 14.0), ("room", 30.0), ("toilet", 2.0)]);
    let upper = level("upper", &[("corridor", 8.0), ("bathroom", 6.0), ("room", 18.0), ("room", 12.0)]);
    let house = Arc::new(building(vec![ground, upper]));
    let house = Occupancy::new(&house, "b", &catalog().households, 1).apply(&house);
    let homes: Vec<_> = house.levels.iter().map(|level| level.rooms[0].home.clone().unwrap()).collect();
    assert_eq!(homes[0], homes[1]);
    assert_eq!(house.levels[0].rooms[2].room_type, "living_room");
    assert!(house.levels[1].rooms[2].room_type != "room");
}

#[test]
fn flats_of_a_building_differ_and_small_ones_have_few_people() {
    let catalog = catalog();
    let people = |of: &[(&str, f64)]| -> f64 {
        (0..200)
            .map(|seed| f64::from(rooms(&flat(of), seed, catalog)[0].home.as_ref().unwrap().persons))
            .sum()
    };
    let small = [("corridor", 4.0), ("kitchen", 8.0), ("bathroom", 4.0), ("room", 20.0), ("room", 12.0)];
    assert!(people(&small) / 200.0 < 1.8 && people(&FLAT) / 200.0 > 2.5);
}
