//! Counts and guarantees on the shared station, and faults of broken files.

use super::read;
use crate::plan::assemble_level;
use crate::plan::read::reader::ReadBuildings;
use crate::plan::read::real_data::{assert_comes_back, folder, words};

fn station() -> Option<ReadBuildings> {
    let path = folder("mlit-indoor")?;
    Some(read(&path, &words()).unwrap_or_else(|faults| panic!("{faults}")))
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn the_shared_station_has_the_counts_of_its_source() {
    let Some(read) = station() else { return };
    println!("{}", read.faults);
    assert!(!read.faults.has_errors());
    let ids: Vec<&str> = read.buildings.iter().map(|building| building.id.as_str()).collect();
    assert_eq!(ids, ["jrtokyosta"]);
    assert!(read.origin.is_some());
    let levels = &read.buildings[0].draft.levels;
    let ids: Vec<(&str, f64)> = levels.iter().map(|level| (level.id.as_str(), level.elevation)).collect();
    assert_eq!(ids, [("level_-1", -3.6), ("level_0", 0.0), ("level_1", 0.0)]);
    let is_part = |id: &str| id.contains('.');
    let rooms = levels.iter().flat_map(|level| &level.rooms).filter(|room| !is_part(&room.id));
    // 708 areas of one part, and one of several.
    assert_eq!(rooms.count(), 709);
    let (mut rooms, mut attached, mut joined) = (0, 0, 0);
    for draft in levels {
        let (level, problems) = assemble_level(draft.clone());
        for problem in problems {
            println!("{}: {}", level.id, problem.message);
        }
        rooms += level.rooms.len();
        attached += level.openings.len();
        joined += level.openings.iter().filter(|opening| opening.sides.len() == 2).count();
    }
    println!("{rooms} rooms; {attached} of 624 openings attached, {joined} join two rooms");
    assert!(rooms >= 709, "{rooms} rooms");
    assert!(attached * 100 >= 95 * 624, "{attached} openings");
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn the_shared_station_is_the_same_as_a_native_plan() {
    let Some(folder) = folder("mlit-indoor") else { return };
    assert_comes_back(&folder);
}

#[test]
fn a_space_without_a_category_is_guessed_and_no_unknown_word() {
    let folder = tempfile::tempdir().unwrap();
    let mut changed = 0;
    for entry in std::fs::read_dir("tests/cases/plan_import/indoor_mlit").unwrap() {
        let path = entry.unwrap().path();
        let text = std::fs::read_to_string(&path).unwrap();
        let mut table: serde_json::Value = serde_json::from_str(&text).unwrap();
        for feature in table["features"].as_array_mut().unwrap() {
            if let Some(category) = feature["properties"].get_mut("category") {
                *category = serde_json::Value::Null;
                changed += 1;
            }
        }
        std::fs::write(folder.path().join(path.file_name().unwrap()), table.to_string()).unwrap();
    }
    assert!(changed > 0);
    let read = read(folder.path(), &words()).unwrap_or_else(|faults| panic!("{faults}"));
    let mut rooms =
        read.buildings.iter().flat_map(|building| &building.draft.levels).flat_map(|level| &level.rooms);
    assert!(rooms.all(|room| room.unknown_word.as_deref() == Some("")));
    assert!(!read.faults.to_string().contains("unknown room word"), "{}", read.faults);
}
