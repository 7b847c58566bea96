//! Counts and guarantees on the shared university, and faults of broken files.

use std::path::Path;

use geo::{Distance, Euclidean};

use super::{read, recognises};
use crate::document::Faults;
use crate::geometry::Point;
use crate::growth::growth;
use crate::plan::read::reader::{DraftedBuilding, ReadBuildings, ReadResult};
use crate::plan::read::real_data::{folder, words};
use crate::plan::{GENERIC_ROOM_TYPE, LevelDraft, OpeningPlace, RoomDraft, assemble_level};

fn university() -> Option<Vec<DraftedBuilding>> {
    let path = folder("imdf-spbpu")?;
    assert!(recognises(&path));
    let found = read(&path, &words()).unwrap_or_else(|faults| panic!("{faults}"));
    assert!(found.faults.is_empty(), "{}", found.faults);
    Some(found.buildings)
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn the_shared_university_has_the_counts_of_its_source() {
    let Some(buildings) = university() else { return };
    let rooms = |building: &DraftedBuilding| -> Vec<(String, usize)> {
        building.draft.levels.iter().map(|level| (level.id.clone(), level.rooms.len())).collect()
    };
    let level = |ordinal: i32, units: usize| (format!("level_{ordinal}"), units);
    assert_eq!(buildings.len(), 2);
    assert_eq!(buildings[0].id, "main_academic_building");
    assert_eq!(rooms(&buildings[0]), [level(0, 118), level(1, 122), level(2, 34)]);
    assert_eq!(buildings[1].id, "academic_building_3");
    let expected = [level(1, 50), level(2, 40), level(3, 32), level(4, 21), level(5, 26)];
    assert_eq!(rooms(&buildings[1]), expected);
    let levels = buildings.iter().flat_map(|building| &building.draft.levels);
    assert_eq!(levels.map(|level| level.openings.len()).sum::<usize>(), 472);
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn every_shared_level_assembles_and_every_opening_joins_two_rooms() {
    let Some(buildings) = university() else { return };
    for draft in buildings.into_iter().flat_map(|building| building.draft.levels) {
        let (room_count, opening_count) = (draft.rooms.len(), draft.openings.len());
        let (level, problems) = assemble_level(draft);
        // Four stairwells are drawn on the corridor around them.
        for problem in problems {
            assert!(!problem.is_error && problem.message.contains("lies on"), "{}", problem.message);
        }
        assert_eq!((level.rooms.len(), level.openings.len()), (room_count, opening_count));
        assert!(level.openings.iter().all(|opening| opening.sides.len() == 2), "{}", level.id);
        assert!(level.rooms.iter().all(|room| (room.height - 3.3).abs() < 1e-9));
        let thickest = level.rooms.iter().flat_map(|room| &room.walls).map(|wall| wall.thickness);
        assert!(thickest.fold(0.0, f64::max) <= 0.4);
    }
}

/// How many rooms lie within 0.3 m of an opening's line, as drawn.
fn rooms_near(level: &LevelDraft, center: Point, along: Point) -> usize {
    let coord = |point: Point| geo::Coord { x: point.x, y: point.y };
    let line = geo::Line::new(coord(center - along / 2.0), coord(center + along / 2.0));
    let near = level.rooms.iter().filter(|room| {
        let ring = room.outline.iter().map(|&corner| coord(corner)).collect();
        let holes = room.holes.iter().map(|hole| hole.iter().map(|&corner| coord(corner)).collect());
        Euclidean.distance(&line, &geo::Polygon::new(ring, holes.collect())) <= 0.3
    });
    near.count()
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn most_openings_of_the_university_lie_between_two_rooms() {
    let Some(buildings) = university() else { return };
    let mut counts = [0usize; 3];
    for level in buildings.iter().flat_map(|building| &building.draft.levels) {
        for opening in &level.openings {
            let OpeningPlace::Points { center, along } = opening.place else { panic!("no points") };
            match rooms_near(level, center, along.unwrap()) {
                2 => counts[0] += 1,
                3.. => counts[1] += 1,
                _ => counts[2] += 1,
            }
        }
    }
    let percent = counts.map(|count| (count as f64 / 4.72).round());
    assert_eq!(percent[..2], [88.0, 12.0], "{counts:?}");
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn projection_keeps_shared_edges_shared_and_sizes_true() {
    let Some(buildings) = university() else { return };
    // The main building is 230 m long; its rooms are some square metres to some hundreds.
    let levels = buildings.iter().flat_map(|building| &building.draft.levels);
    for room in levels.flat_map(|level| &level.rooms) {
        assert!(room.outline.iter().all(|corner| corner.length() < 200.0), "{}", room.id);
    }
}

/// The miniature campus of the tests with some texts of its files replaced, read.
fn changed(changes: &[(&str, &str, &str)]) -> ReadResult {
    let folder = tempfile::tempdir().unwrap();
    for entry in std::fs::read_dir("tests/cases/plan_import/campus").unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap();
        let mut text = std::fs::read_to_string(&path).unwrap();
        for (_, from, to) in changes.iter().filter(|(file, ..)| name == *file) {
            assert!(text.contains(from), "{name:?} has no {from}");
            text = text.replace(from, to);
        }
        std::fs::write(folder.path().join(name), text).unwrap();
    }
    assert!(recognises(folder.path()));
    read(folder.path(), &words())
}

/// The faults of the campus with the first of some texts of a file replaced.
fn broken(name: &str, from: &str, to: &str) -> Faults {
    let text = std::fs::read_to_string(Path::new("tests/cases/plan_import/campus").join(name)).unwrap();
    let once = text.replacen(from, to, 1);
    match changed(&[(name, &text, &once)]) {
        Ok(read) => read.faults,
        Err(faults) => faults,
    }
}

fn sound(changes: &[(&str, &str, &str)]) -> ReadBuildings {
    changed(changes).unwrap_or_else(|faults| panic!("{faults}"))
}

#[test]
fn ordinals_with_a_fraction_of_nothing_and_ids_in_numbers_are_read() {
    let usual = format!("{:?}", sound(&[]).buildings);
    let floats = [
        ("level.geojson", "\"ordinal\": 1", "\"ordinal\": 1.0"),
        ("level.geojson", "\"ordinal\": 0", "\"ordinal\": 0.0"),
    ];
    assert_eq!(format!("{:?}", sound(&floats).buildings), usual);
    let numbers =
        ["level.geojson", "unit.geojson", "opening.geojson"].map(|file| (file, "\"level-a\"", "71"));
    assert_eq!(format!("{:?}", sound(&numbers).buildings), usual);
    let half = broken("level.geojson", "\"ordinal\": 1", "\"ordinal\": 0.5");
    assert!(half.to_string().contains("expected a whole number, found 0.5"), "{half}");
}

#[test]
fn a_level_belongs_to_the_first_of_its_buildings_that_there_is() {
    let usual = sound(&[]).buildings.len();
    let read =
        sound(&[("level.geojson", "\"building_ids\": [", "\"building_ids\": [\"no-such-building\", ")]);
    assert_eq!(read.buildings.len(), usual);
}

#[test]
fn units_without_a_category_and_with_a_name_in_no_language_are_read() {
    let read = sound(&[
        ("unit.geojson", "\"category\": \"classroom\"", "\"category\": null"),
        (
            "unit.geojson",
            "{\"ru\": \"\\u043a\\u043e\\u043c\\u043d\\u0430\\u0442\\u0430\", \"en\": \"Room 1\"}",
            "\"Lab 7\"",
        ),
        ("unit.geojson", "\"en\": \"Hall\"", "\"en-US\": \"Hall\""),
    ]);
    let rooms: Vec<&RoomDraft> = read
        .buildings
        .iter()
        .flat_map(|building| &building.draft.levels)
        .flat_map(|level| &level.rooms)
        .collect();
    let room = |id: &str| rooms.iter().find(|room| room.id == id).expect("the unit");
    assert_eq!(
        (room("u-class").name.as_deref(), room("u-hall").name.as_deref()),
        (Some("Lab 7"), Some("Hall"))
    );
    assert_eq!(room("u-class").room_type, "laboratory");
}

#[test]
fn a_unit_that_is_called_no_more_than_a_room_has_the_type_of_its_name() {
    let type_of = |category: &str, name: &str| {
        let category = ("unit.geojson", "\"category\": \"classroom\"", category);
        let read = sound(&[category, ("unit.geojson", "\"en\": \"Room 1\"", name)]);
        let mut rooms = read
            .buildings
            .into_iter()
            .flat_map(|building| building.draft.levels)
            .flat_map(|level| level.rooms);
        rooms.find(|room| room.id == "u-class").expect("the unit").room_type
    };
    assert_eq!(type_of("\"category\": \"room\"", "\"en\": \"Meeting Room 4\""), "meeting_room");
    assert_eq!(type_of("\"category\": \"unspecified\"", "\"en\": \"Küche\""), "kitchen");
    assert_eq!(type_of("\"category\": \"office\"", "\"en\": \"Küche\""), "office");
    assert_eq!(type_of("\"category\": \"room\"", "\"en\": \"Room 4\""), GENERIC_ROOM_TYPE);
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn the_shared_buildings_stand_where_they_are_on_the_campus() {
    let Some(path) = folder("imdf-spbpu") else { return };
    let read = read(&path, &words()).unwrap_or_else(|faults| panic!("{faults}"));
    let [main, third] = &read.buildings[..] else { panic!("two buildings") };
    let apart = main.placement.position.distance(third.placement.position);
    assert!((200.0..1_000.0).contains(&apart), "{apart} m apart");
    let degrees = read.origin.expect("a place on earth").degrees(main.placement.position).unwrap();
    assert!((degrees - Point::new(30.3727, 60.0072)).abs().max_element() < 0.01, "{degrees}");
}

#[test]
fn broken_files_give_faults_with_their_place() {
    let cases = [
        ("unit.geojson", "\"category\": \"walkway\"", "\"category\": 7", (5, "found 7")),
        ("unit.geojson", "\"level_id\": \"level-a\", ", "", (5, "level_id")),
        ("unit.geojson", "\"features\": [", "\"features\": null, \"x\": [", (4, "found nothing")),
        ("level.geojson", "\"ordinal\": 1", "\"ordinal\": \"one\"", (5, "one")),
        ("opening.geojson", "[[30.", "[[\"30.", (5, "")),
    ];
    for (name, from, to, (line, message)) in cases {
        let faults = broken(name, from, to);
        let fault = faults.0.iter().find(|fault| fault.is_error()).unwrap();
        assert!(fault.message.contains(message), "{to}: {faults}");
        assert_eq!(fault.position.map(|(line, _)| line), Some(line), "{to}: {faults}");
        assert!(fault.file.ends_with(name));
    }
}

#[test]
fn features_that_cannot_be_placed_are_warnings() {
    let faults = broken("unit.geojson", "\"type\": \"Polygon\"", "\"type\": \"MultiPoint\"");
    let texts: Vec<&str> = faults.0.iter().map(|fault| fault.message.as_str()).collect();
    assert!(faults.0.iter().all(|fault| !fault.is_error()), "{faults}");
    assert!(texts.contains(&"unit u-hall is no area"), "{texts:?}");
    assert!(texts.contains(&"unit u-stray is on no level of a building"), "{texts:?}");
    assert!(texts.iter().any(|text| text.contains("unknown room word \"planetarium\"")), "{texts:?}");
}

#[test]
fn coordinates_that_are_no_degrees_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["building", "level", "unit"] {
        let path = Path::new("tests/cases/plan_import/campus").join(name).with_extension("geojson");
        let text = std::fs::read_to_string(path).unwrap().replace("[30.", "[305.").replace("[29.", "[295.");
        std::fs::write(folder.path().join(name).with_extension("geojson"), text).unwrap();
    }
    let faults = read(folder.path(), &words()).unwrap_err();
    assert!(faults.0.iter().any(|fault| fault.message.contains("nowhere on Earth")), "{faults}");
}

/// The archive `campus` with this many levels, of one unit and one opening each.
fn write_levels(count: usize) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for name in ["building", "level", "unit", "opening"] {
        let path = Path::new("tests/cases/plan_import/campus").join(name).with_extension("geojson");
        let text = std::fs::read_to_string(path).unwrap();
        let mut table: serde_json::Value = serde_json::from_str(&text).unwrap();
        if name != "building" {
            let feature = |number: usize| {
                let mut feature = table["features"][0].clone();
                feature["id"] = format!("{name}-{number}").into();
                let own = if name == "level" { "ordinal" } else { "level_id" };
                feature["properties"][own] =
                    if name == "level" { number.into() } else { format!("level-{number}").into() };
                feature
            };
            table["features"] = (0..count).map(feature).collect();
        }
        std::fs::write(folder.path().join(name).with_extension("geojson"), table.to_string()).unwrap();
    }
    folder
}

#[test]
fn time_to_read_grows_with_the_number_of_levels() {
    const STEEPEST: f64 = 1.3;
    let words = words();
    let run = |folder: tempfile::TempDir| {
        let found = read(folder.path(), &words).unwrap_or_else(|faults| panic!("{faults}"));
        let levels = &found.buildings[0].draft.levels;
        assert!(levels.iter().all(|level| (level.rooms.len(), level.openings.len()) == (1, 1)));
    };
    let power = growth(500, 8, STEEPEST, write_levels, run);
    assert!(power < STEEPEST, "time grows with the power {power:.2} of the levels");
}
