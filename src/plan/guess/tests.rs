//! Each rule of `configs/room_words.yaml` applies to a room; shafts and the like stay unfurnished.

use std::path::PathBuf;

use super::*;
use crate::catalog::builtin_catalog;
use crate::growth::growth;
use crate::plan::read::real_data::{drafts, folder};
use crate::plan::sample::{at, level, neighbours, opening, points, rectangle};
use crate::plan::{OpeningDraft, OpeningKind, RoomDraft, assemble_level};

fn words() -> &'static RoomWords {
    &builtin_catalog().room_words
}

fn stranger(id: &str, place: (f64, f64), size: (f64, f64)) -> RoomDraft {
    RoomDraft { unknown_word: Some("Zxq".to_owned()), ..rectangle(id, place, size) }
}

/// The guessed type of the last room of a level, and the reasons.
fn read(rooms: Vec<RoomDraft>, openings: Vec<OpeningDraft>, building: Option<&str>) -> (String, String) {
    let mut draft = level(rooms, openings);
    let (level, _) = assemble_level(draft.clone());
    let (words, stack) = (words(), Stack::default());
    let (_, problems) =
        Guessing { words, family: building, stack, told: &mut 0 }.guess(&mut draft, 0, &level);
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
fn a_guess_reports_its_reasons() {
    let (kind, fact) = behind_a_door((2.0, 1.55), 0, None);
    assert_eq!(kind, "storeroom");
    assert_eq!(fact, "room \"a\" (Zxq): read as storeroom: 3.1 m², 1.55 m wide, no window, one door");
}

#[test]
fn shafts_and_the_like_stay_empty() {
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
fn a_room_with_doors_to_many_rooms_is_read_as_a_way() {
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
fn a_room_with_a_railing_is_read_as_open_air() {
    for (building, kind) in [(Some("home"), "balcony"), (None, "terrace")] {
        let mut draft = level(
            vec![rectangle("in", (0.0, 0.0), (4.0, 4.0)), stranger("a", (0.0, -2.1), (4.0, 2.0))],
            Vec::new(),
        );
        draft.railings = vec![points(&[(0.0, -2.15), (4.0, -2.15), (4.0, -2.05), (0.0, -2.05)])];
        let (level, _) = assemble_level(draft.clone());
        let (words, stack) = (words(), Stack::default());
        Guessing { words, family: building, stack, told: &mut 0 }.guess(&mut draft, 0, &level);
        assert_eq!(draft.rooms[1].room_type, kind);
    }
}

#[test]
fn the_kind_of_a_building_is_that_of_most_known_rooms() {
    let room = |kind: &str| RoomDraft { room_type: kind.to_owned(), ..RoomDraft::default() };
    let mut rooms = vec![room("office"), room("classroom"), room("classroom"), room("corridor")];
    let building = |rooms: &[RoomDraft]| BuildingDraft {
        levels: vec![LevelDraft { rooms: rooms.to_vec(), ..LevelDraft::default() }],
        ..BuildingDraft::default()
    };
    assert_eq!(family_of(&building(&rooms), words()), Some("school"));
    rooms.iter_mut().for_each(|room| room.unknown_word = Some("Zxq".to_owned()));
    assert_eq!(family_of(&building(&rooms), words()), None);
    let usual = BuildingDraft { usual_family: Some("home"), ..building(&rooms) };
    assert_eq!(family_of(&usual, words()), Some("home"), "nothing says otherwise");
    rooms[0].fixtures = ["kitchen".to_owned()].into();
    assert_eq!(family_of(&building(&rooms), words()), Some("home"), "a kitchen is drawn");
}

/// A building of levels with rooms of these types, in a row, and how the last room of the first level is read.
fn read_in_tower(levels: Vec<Vec<RoomDraft>>) -> (String, String) {
    let levels = levels.into_iter().map(|rooms| level(rooms, Vec::new())).collect();
    let draft = BuildingDraft { levels, ..BuildingDraft::default() };
    let words = words();
    let mut told = 0;
    let mut guessing = Guessing::of(&draft, words, &mut told).expect("a word is unknown");
    let mut first = draft.levels[0].clone();
    let (_, problems) = guessing.guess(&mut first, 0, &assemble_level(draft.levels[0].clone()).0);
    (first.rooms.last().expect("a room").room_type.clone(), problems[0].message.clone())
}

#[test]
fn stairs_lifts_and_shafts_go_on_from_level_to_level() {
    let above = |kind: &str, x: f64| RoomDraft {
        room_type: kind.to_owned(),
        ..rectangle("above", (x, 0.0), (3.0, 5.0))
    };
    for kind in ["stairs", "elevator", "shaft"] {
        let (read, why) =
            read_in_tower(vec![vec![stranger("a", (0.0, 0.1), (3.0, 5.1))], vec![above(kind, 0.0)]]);
        assert_eq!(read, kind);
        assert!(why.contains(&format!("{kind} above or below")), "{why}");
    }
    let (read, why) =
        read_in_tower(vec![vec![stranger("a", (0.0, 0.0), (3.0, 5.0))], vec![above("stairs", 2.0)]]);
    assert!(read != "stairs" && !why.contains("above"), "it lies beside them: {why}");
    let unknown = stranger("b", (0.0, 0.0), (3.0, 5.0));
    let far = vec![vec![stranger("a", (0.0, 0.0), (3.0, 5.0))], vec![unknown], vec![above("stairs", 0.0)]];
    assert_ne!(read_in_tower(far).0, "stairs", "two levels further up");
}

#[test]
fn fixtures_decide_the_type_of_a_room() {
    let with = |fixtures: &[&str], size| {
        let fixtures = fixtures.iter().map(|kind| (*kind).to_owned()).collect();
        let fixed = RoomDraft { fixtures, ..stranger("a", (0.0, 0.0), size) };
        read(vec![rectangle("known", (0.0, 10.0), (4.0, 4.0)), fixed], Vec::new(), Some("home"))
    };
    let (kind, why) = with(&["sink", "shower"], (4.0, 4.0));
    assert_eq!(kind, "bathroom");
    assert!(why.contains("with shower and sink"), "{why}");
    assert_eq!(with(&["toilet"], (1.2, 1.8)).0, "toilet");
    assert_eq!(with(&["toilet"], (2.2, 2.8)).0, "bathroom");
    assert_eq!(with(&["kitchen"], (3.0, 3.0)).0, "kitchen");
    assert_eq!(with(&["kitchen"], (6.0, 5.0)).0, "living_kitchen");
    assert_eq!(with(&["bed"], (4.0, 3.0)).0, "bedroom");
    assert_eq!(with(&["sofa"], (4.0, 5.0)).0, "living_room");
    assert_eq!(with(&["stairs"], (3.0, 5.0)).0, "stairs");
    assert_eq!(with(&["elevator"], (1.6, 1.6)).0, "elevator");
}

#[test]
fn where_baths_are_drawn_a_room_without_one_is_no_bathroom() {
    let bath =
        RoomDraft { fixtures: ["bathtub".to_owned()].into(), ..rectangle("b", (9.0, 0.0), (2.0, 2.0)) };
    let rooms = |first: RoomDraft| {
        vec![rectangle("known", (0.0, -4.2), (6.0, 4.0)), first, stranger("a", (0.0, 0.0), (2.0, 2.2))]
    };
    let doors = || vec![door("d", 0.6, -0.1, (1.0, 0.0)), door("e", 9.0, 1.0, (0.0, 1.0)), window(3.0, -4.2)];
    assert_eq!(read(rooms(bath.clone()), doors(), Some("home")).0, "storeroom");
    let bare = RoomDraft { fixtures: BTreeSet::new(), ..bath };
    assert_eq!(read(rooms(bare.clone()), doors(), Some("home")).0, "bathroom");
    let bed = RoomDraft { fixtures: ["bed".to_owned()].into(), ..bare };
    assert_eq!(read(rooms(bed), doors(), Some("home")).0, "bathroom", "only beds are drawn");
}

#[test]
fn thousands_of_guesses_are_counted_instead_of_listed() {
    let row = |y: f64| {
        let room = move |index: i32| stranger(&format!("r{index}"), (f64::from(index) * 4.0, y), (3.9, 4.0));
        level((0..500).map(room).collect(), Vec::new())
    };
    let draft = BuildingDraft { levels: vec![row(0.0), row(5.0)], ..BuildingDraft::default() };
    let words = words();
    let mut told = 0;
    let mut guessing = Guessing::of(&draft, words, &mut told).expect("a word is unknown");
    let guesses: Vec<(usize, Vec<Problem>)> = (draft.levels.iter().enumerate())
        .map(|(place, level)| guessing.guess(&mut level.clone(), place, &assemble_level(level.clone()).0))
        .collect();
    assert_eq!(
        guesses.iter().map(|(count, problems)| (*count, problems.len())).collect::<Vec<_>>(),
        [(500, TOLD_GUESSES + 1), (500, 1)]
    );
    assert_eq!(guesses[1].1[0].message, "500 more rooms with unknown words: read as 500 office");
}

#[test]
fn all_buildings_of_an_input_share_the_list_of_guesses() {
    let house = BuildingDraft {
        levels: vec![level(vec![stranger("a", (0.0, 0.0), (4.0, 4.0))], Vec::new())],
        ..BuildingDraft::default()
    };
    let words = words();
    let mut told = 0;
    let messages: Vec<String> = (0..=TOLD_GUESSES)
        .map(|_| {
            let mut draft = house.levels[0].clone();
            let assembled = assemble_level(draft.clone()).0;
            let mut guessing = Guessing::of(&house, words, &mut told).expect("a word is unknown");
            guessing.guess(&mut draft, 0, &assembled).1[0].message.clone()
        })
        .collect();
    assert!(messages[..TOLD_GUESSES].iter().all(|message| message.starts_with("room \"a\" (Zxq): read as")));
    assert_eq!(messages[TOLD_GUESSES], "1 more room with an unknown word: read as 1 office");
}

#[test]
fn time_to_guess_grows_with_the_number_of_rooms() {
    let words = words();
    let tower = |rooms: usize| {
        let room = |index: usize| stranger(&format!("r{index}"), (index as f64 * 4.0, 0.0), (3.9, 4.0));
        let levels: Vec<LevelDraft> = [0, 1]
            .map(|place| {
                let mut level = level((0..rooms).map(room).collect(), Vec::new());
                let known = level.rooms.iter_mut().filter(|_| place == 1);
                known.for_each(|room| room.unknown_word = None);
                level
            })
            .into();
        let assembled = assemble_level(levels[0].clone()).0;
        (BuildingDraft { levels, ..BuildingDraft::default() }, assembled)
    };
    let guess = |(draft, assembled): (BuildingDraft, Level)| {
        let mut told = 0;
        let mut guessing = Guessing::of(&draft, words, &mut told).expect("words are unknown");
        guessing.guess(&mut draft.levels[0].clone(), 0, &assembled);
    };
    let power = growth(200, 8, 1.3, tower, guess);
    assert!(power < 1.3, "time grows with the power {power:.2}");
}

#[test]
fn a_building_whose_words_are_known_has_nothing_to_guess() {
    let draft = BuildingDraft { levels: vec![level(neighbours(), Vec::new())], ..BuildingDraft::default() };
    assert!(Guessing::of(&draft, words(), &mut 0).is_none());
}

/// The use of rooms of a type: guesses need not distinguish an office from a meeting room.
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

/// How many rooms of a building are read as of their use with the words of every `step`th room hidden, from each of the
/// first `step` on, and of how many; the kind of the building is known.
fn guessed_uses(draft: &BuildingDraft, words: &RoomWords, step: usize) -> (usize, usize) {
    let levels: Vec<Level> = draft.levels.iter().map(|level| assemble_level(level.clone()).0).collect();
    let mut counts = (0, 0);
    for first in 0..step {
        let mut blind = BuildingDraft { levels: draft.levels.clone(), ..BuildingDraft::default() };
        let rooms =
            blind.levels.iter_mut().flat_map(|level| level.rooms.iter_mut().skip(first).step_by(step));
        rooms.for_each(|room| room.unknown_word = Some("Zxq".to_owned()));
        let mut guessing =
            Guessing { words, family: family_of(draft, words), stack: Stack::of(&blind), told: &mut 0 };
        for (place, (mut level, assembled)) in blind.levels.into_iter().zip(&levels).enumerate() {
            guessing.guess(&mut level, place, assembled);
            let rooms = draft.levels[place].rooms.iter().zip(&level.rooms);
            for (room, guess) in rooms.filter(|(room, guess)| room.unknown_word != guess.unknown_word) {
                counts.0 += usize::from(use_of(&room.room_type, words) == use_of(&guess.room_type, words));
                counts.1 += 1;
            }
        }
    }
    counts
}

/// Percent of the rooms of shared plans that are read as of their use.
fn guessed_share(paths: &[PathBuf], step: usize) -> f64 {
    let words = words();
    let drafts = paths.iter().flat_map(|path| {
        let mut known = drafts(path, words);
        let blind = drafts(path, &RoomWords { guesses: words.guesses.clone(), ..RoomWords::default() });
        let rooms = known.iter_mut().flat_map(|draft| &mut draft.levels).flat_map(|level| &mut level.rooms);
        let blind = blind.iter().flat_map(|draft| &draft.levels).flat_map(|level| &level.rooms);
        // Some readers look for fixtures only where there is something to guess.
        rooms.zip(blind).for_each(|(room, blind)| room.fixtures.clone_from(&blind.fixtures));
        known
    });
    let counts = drafts.map(|draft| guessed_uses(&draft, words, step));
    let (right, all) = counts.fold((0, 0), |sum, next| (sum.0 + next.0, sum.1 + next.1));
    println!("{}, words of one room in {step} hidden: {right} of {all} rooms", paths[0].display());
    100.0 * right as f64 / all as f64
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn most_rooms_of_real_homes_are_read_as_of_their_use_without_their_words() {
    let Some(homes) = folder("archilyse") else { return };
    assert!(guessed_share(&[homes.join("site_1440")], 1) > 93.0);
    assert!(guessed_share(&[homes.join("site_1440")], 5) > 93.0);
    let plans = std::fs::read_dir(homes.join("annotations")).expect("a folder");
    let mut plans: Vec<PathBuf> = plans.map(|entry| entry.expect("an entry").path()).collect();
    plans.sort();
    assert!(guessed_share(&plans, 1) > 88.0);
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn most_rooms_of_a_real_university_are_read_as_of_their_use_without_their_words() {
    let Some(university) = folder("imdf-spbpu") else { return };
    assert!(guessed_share(std::slice::from_ref(&university), 1) > 55.0);
    assert!(guessed_share(std::slice::from_ref(&university), 5) > 72.0);
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn most_rooms_of_a_real_duplex_are_read_as_of_their_use_without_their_words() {
    let Some(folder) = folder("ifc") else { return };
    assert!(guessed_share(&[folder.join("Duplex_A_20110907.ifc")], 1) > 80.0);
    assert!(guessed_share(&[folder.join("Duplex_A_20110907.ifc")], 5) > 80.0);
}
