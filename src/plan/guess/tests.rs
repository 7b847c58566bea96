//! Each rule of `configs/room_words.yaml` meets a room; what is no room stays empty.

use super::*;
use crate::catalog::load_catalog;
use crate::plan::read::real_data::folder;
use crate::plan::sample::{at, level, neighbours, opening, points, rectangle};
use crate::plan::{OpeningDraft, PlanOptions, RoomDraft, assemble_level, read_plans};

fn words() -> RoomWords {
    load_catalog(&[]).expect("the built-in catalogue is sound").value.room_words
}

fn stranger(id: &str, place: (f64, f64), size: (f64, f64)) -> RoomDraft {
    RoomDraft { unknown_word: Some("Zxq".to_owned()), ..rectangle(id, place, size) }
}

/// What the last room of a level is read as, and why.
fn read(rooms: Vec<RoomDraft>, openings: Vec<OpeningDraft>, building: Option<&str>) -> (String, String) {
    let mut draft = level(rooms, openings);
    let (level, _) = assemble_level(draft.clone());
    let problems = guess_rooms(&mut draft, &level, (&words(), building));
    let last = draft.rooms.last().expect("a room");
    (last.room_type.clone(), problems.last().map(|problem| problem.message.clone()).unwrap_or_default())
}

fn door(id: &str, x: f64, y: f64, along: (f64, f64)) -> OpeningDraft {
    opening(id, OpeningKind::Door, at(x, y, along), 0.9)
}

fn window(x: f64, y: f64) -> OpeningDraft {
    opening(&format!("w{x}"), OpeningKind::Window, at(x, y, (1.0, 0.0)), 1.0)
}

/// A stranger in the north of a known room with a window, behind one door.
fn behind_a_door(size: (f64, f64), windows: usize, building: Option<&str>) -> (String, String) {
    let rooms = vec![rectangle("known", (0.0, -4.2), (6.0, 4.0)), stranger("a", (0.0, 0.0), size)];
    let mut openings = vec![door("d", 0.6, -0.1, (1.0, 0.0)), window(3.0, -4.2)];
    openings.extend((0..windows).map(|index| window(0.8 + 1.2 * index as f64, size.1)));
    read(rooms, openings, building)
}

#[test]
fn a_guess_says_what_it_rests_on() {
    let (kind, fact) = behind_a_door((2.0, 1.55), 0, None);
    assert_eq!(kind, "storeroom");
    assert_eq!(fact, "room \"a\" (Zxq): read as storeroom: 3.1 m², no window, one door");
}

#[test]
fn what_is_no_room_stays_empty() {
    for (size, kind) in [((6.0, 0.3), "void"), ((0.6, 0.7), "void"), ((1.2, 1.5), "shaft")] {
        let mut rooms = neighbours();
        rooms.extend(
            (0..3).map(|index| {
                rectangle(&format!("k{index}"), (0.0, 10.0 * f64::from(index) + 20.0), (4.0, 4.0))
            }),
        );
        let doors = [(4.1, 1.5), (0.0, 22.0), (0.0, 32.0), (0.0, 42.0)];
        let mut openings: Vec<_> = (0..4)
            .map(|index| door(&format!("d{index}"), doors[index].0, doors[index].1, (0.0, 1.0)))
            .collect();
        openings.push(window(1.0, 0.0));
        rooms.push(stranger("a", (0.0, 10.0), size));
        assert_eq!(read(rooms, openings, Some("office")).0, kind, "{size:?}");
    }
}

#[test]
fn homes_have_bathrooms_store_rooms_and_rooms() {
    let read = |size, windows| behind_a_door(size, windows, Some("home")).0;
    assert_eq!(read((1.2, 1.5), 0), "storeroom");
    assert_eq!(read((2.0, 2.2), 0), "bathroom");
    assert_eq!(read((2.0, 2.2), 1), "storeroom");
    assert_eq!(read((3.0, 2.8), 0), "utility_room");
    assert_eq!(read((4.0, 3.5), 2), "room");
    assert_eq!(read((6.0, 5.5), 2), "living_dining");
}

#[test]
fn other_buildings_have_rooms_of_their_kind() {
    let read = |size, building| behind_a_door(size, 1, Some(building)).0;
    assert_eq!(read((4.0, 5.0), "hotel"), "hotel_room");
    assert_eq!(behind_a_door((2.0, 2.2), 0, Some("hotel")).0, "hotel_bathroom");
    assert_eq!(read((4.0, 5.0), "health"), "examination_room");
    assert_eq!(read((6.0, 5.0), "health"), "ward");
    assert_eq!(read((8.0, 7.0), "school"), "classroom");
    assert_eq!(read((5.0, 5.0), "trade"), "shop");
    assert_eq!(read((5.0, 5.0), "office"), "office");
    assert_eq!(read((10.0, 8.0), "office"), "meeting_room");
    assert_eq!(read((2.5, 2.0), "office"), "storeroom");
    assert_eq!(behind_a_door((6.0, 1.9), 0, Some("office")).0, "storeroom");
}

#[test]
fn a_large_room_of_which_nothing_is_known_is_no_hall_of_chairs() {
    assert_eq!(behind_a_door((30.0, 20.0), 2, None).0, "walkway");
}

#[test]
fn what_leads_to_many_rooms_is_a_way() {
    let leading = |width: f64, count: usize, building| {
        let rooms = (0..count)
            .map(|index| rectangle(&format!("r{index}"), (index as f64 * 4.0, width + 0.1), (3.9, 4.0)));
        let rooms = rooms.chain([stranger("a", (0.0, 0.0), (count as f64 * 4.0, width))]).collect();
        let doors = (0..count)
            .map(|index| door(&format!("d{index}"), index as f64 * 4.0 + 2.0, width + 0.05, (1.0, 0.0)));
        read(rooms, doors.chain([window(1.0, width + 4.1)]).collect(), building).0
    };
    assert_eq!(leading(2.0, 5, None), "corridor");
    assert_eq!(leading(9.0, 6, None), "walkway");
    assert_eq!(leading(1.3, 3, Some("home")), "corridor");
    assert_eq!(leading(1.0, 2, Some("office")), "corridor");
}

#[test]
fn what_has_a_railing_lies_in_the_open() {
    for (building, kind) in [(Some("home"), "balcony"), (None, "terrace")] {
        let mut draft = level(
            vec![rectangle("in", (0.0, 0.0), (4.0, 4.0)), stranger("a", (0.0, -2.1), (4.0, 2.0))],
            Vec::new(),
        );
        draft.railings = vec![points(&[(0.0, -2.15), (4.0, -2.15), (4.0, -2.05), (0.0, -2.05)])];
        let (level, _) = assemble_level(draft.clone());
        guess_rooms(&mut draft, &level, (&words(), building));
        assert_eq!(draft.rooms[1].room_type, kind);
    }
}

#[test]
fn a_building_is_what_most_of_its_known_rooms_are() {
    let room = |kind: &str| RoomDraft { room_type: kind.to_owned(), ..RoomDraft::default() };
    let mut rooms = vec![room("office"), room("classroom"), room("classroom"), room("corridor")];
    let building = |rooms: &[RoomDraft]| BuildingDraft {
        levels: vec![LevelDraft { rooms: rooms.to_vec(), ..LevelDraft::default() }],
        ..BuildingDraft::default()
    };
    assert_eq!(family_of(&building(&rooms), &words()), Some("school"));
    rooms.iter_mut().for_each(|room| room.unknown_word = Some("Zxq".to_owned()));
    assert_eq!(family_of(&building(&rooms), &words()), None);
}

/// What people do in rooms of a type: guesses need not tell an office from a meeting room.
fn use_of(kind: &str, words: &RoomWords) -> String {
    const USES: [(&str, &[&str]); 5] = [
        ("way", &["corridor", "walkway", "lobby", "foyer"]),
        ("wet", &["bathroom", "toilet", "restroom", "restroom_male", "hotel_bathroom"]),
        (
            "store",
            &["storeroom", "archive", "utility_room", "laundry", "server_room", "copy_room", "cloakroom"],
        ),
        ("empty", &["shaft", "void", "elevator", "stairs"]),
        ("open air", &["balcony", "loggia", "terrace"]),
    ];
    let found = USES.iter().find(|(_, kinds)| kinds.contains(&kind)).map(|(name, _)| *name);
    let family =
        || words.families.iter().find(|(_, kinds)| kinds.contains(kind)).map(|(name, _)| name.as_str());
    found.or_else(family).unwrap_or(kind).to_owned()
}

/// How many rooms of a building are read as of their use with all words of a level hidden, and of how many.
fn guessed_uses(building: &crate::plan::Building, words: &RoomWords) -> (usize, usize) {
    let draft = |level: &Level, is_hidden: bool| LevelDraft {
        rooms: level
            .rooms
            .iter()
            .map(|room| RoomDraft {
                id: room.id.clone(),
                room_type: room.room_type.clone(),
                unknown_word: is_hidden.then(String::new),
                ..RoomDraft::default()
            })
            .collect(),
        ..LevelDraft::default()
    };
    let levels = building.levels.iter().map(|level| draft(level, false)).collect();
    let family = family_of(&BuildingDraft { name: None, levels }, words);
    let mut counts = (0, 0);
    for level in &building.levels {
        let mut hidden = draft(level, true);
        guess_rooms(&mut hidden, level, (words, family));
        let pairs = level.rooms.iter().zip(&hidden.rooms).filter(|(room, _)| room.room_type != "generic");
        for (room, guess) in pairs {
            counts.0 += usize::from(use_of(&room.room_type, words) == use_of(&guess.room_type, words));
            counts.1 += 1;
        }
    }
    counts
}

#[test]
fn most_rooms_of_real_homes_are_read_as_of_their_use_without_their_words() {
    let Some(homes) = folder("archilyse") else { return };
    let words = words();
    let options = PlanOptions { words: &words };
    let reading = read_plans(&[homes.join("site_1440"), homes.join("annotations")], &options);
    let counts = reading.plan.buildings.iter().map(|placed| guessed_uses(&placed.building, &words));
    let (right, all) = counts.reduce(|sum, next| (sum.0 + next.0, sum.1 + next.1)).expect("buildings");
    println!("{right} of {all} rooms of homes");
    assert!(right * 10 > all * 6, "{right} of {all}");
    let Some(university) = folder("imdf-spbpu") else { return };
    let reading = read_plans(&[university], &options);
    let counts = reading.plan.buildings.iter().map(|placed| guessed_uses(&placed.building, &words));
    let (right, all) = counts.reduce(|sum, next| (sum.0 + next.0, sum.1 + next.1)).expect("buildings");
    println!("{right} of {all} rooms of a university");
    assert!(right * 10 > all * 4, "{right} of {all}");
}
