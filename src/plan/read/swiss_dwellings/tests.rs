//! An invented table, its faults, and tables that are made here of the shared apartment blocks, which the same program drew.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;
use tempfile::TempDir;

use super::{FORMAT, furniture, read};
use crate::catalog::builtin_catalog;
use crate::edits::keep_drawn;
use crate::plan::read::reader::ReadBuildings;
use crate::plan::read::real_data::{assert_comes_back, folder, words};
use crate::plan::{OpeningKind, PlanOptions, PlanReading, RoomWords, assemble_level, read_plans};
use crate::storey::{Choices, Typologies};

/// A table with two floors of one building and one of another, their rows mixed.
const TABLE: &str = "tests/cases/plan_import/swiss_dwellings/geometries.csv";

/// A table with these rows, in a file of any name.
fn written(text: &str) -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("table.txt");
    fs::write(&path, text).unwrap();
    (folder, path)
}

fn read_only(path: &Path, only: &[&str]) -> Result<ReadBuildings, String> {
    let words = words();
    let typologies = Typologies::default();
    let only = only.iter().map(|word| (*word).to_owned()).collect();
    let choices = Choices { only, ..Choices::default() };
    let options = PlanOptions::new(&words).with_planning(&typologies, &choices);
    read(path, &options).map_err(|faults| faults.to_string())
}

fn ids(read: &ReadBuildings) -> Vec<String> {
    let levels = read.buildings.iter().flat_map(|building| {
        building.draft.levels.iter().map(|level| format!("{}/{}", building.id, level.id))
    });
    levels.collect()
}

#[test]
fn floors_of_a_building_are_levels_by_elevation_whatever_the_order_of_rows() {
    let text = fs::read_to_string(TABLE).unwrap();
    let read = read_only(Path::new(TABLE), &[]).unwrap();
    assert_eq!(ids(&read), ["building_21/floor_211", "building_21/floor_212", "building_22/floor_221"]);
    let mut lines: Vec<&str> = text.lines().collect();
    lines[1..].reverse();
    let (_folder, path) = written(&lines.join("\r\n"));
    let reversed = read_only(&path, &[]).unwrap();
    for (one, other) in read.buildings.iter().zip(&reversed.buildings) {
        assert_eq!(format!("{:?}", one.draft), format!("{:?}", other.draft));
    }
}

#[test]
fn only_chosen_floors_are_read() {
    let chosen = |only: &[&str]| read_only(Path::new(TABLE), only).map(|read| ids(&read));
    assert_eq!(chosen(&["building_22"]).unwrap(), ["building_22/floor_221"]);
    assert_eq!(chosen(&["floor_212", "other"]).unwrap(), ["building_21/floor_212"]);
    assert_eq!(chosen(&["site_1"]).unwrap().len(), 3);
    let refused = chosen(&["building_7"]).unwrap_err();
    assert!(refused.contains("none of its 3 floors of 2 buildings is chosen"), "{refused}");
    assert!(refused.contains("--only building_21"), "{refused}");
}

#[test]
fn a_table_of_msd_has_other_columns_and_ids_as_numbers() {
    let text = fs::read_to_string(TABLE).unwrap();
    let rows = text.lines().enumerate().map(|(number, line)| match number {
        0 => format!(",{},zoning,roomtype", line.replace("geometry", "geom")),
        _ => format!("{number},{},Zone2,Kitchen", line.replacen(",21,", ",21.0,", 1)),
    });
    let (_folder, path) = written(&rows.collect::<Vec<_>>().join("\n"));
    assert!((FORMAT.recognises)(&path));
    assert_eq!(ids(&read_only(&path, &[]).unwrap()).len(), 3);
}

#[test]
fn openings_join_rooms_and_have_the_heights_of_their_rows() {
    let read = read_only(Path::new(TABLE), &["floor_211"]).unwrap();
    let (level, problems) = assemble_level(read.buildings[0].draft.levels[0].clone());
    assert!(problems.iter().all(|problem| !problem.is_error), "{problems:?}");
    let doors = level.openings.iter().filter(|opening| opening.kind == OpeningKind::Door);
    let sides: Vec<usize> = doors.map(|door| door.sides.len()).collect();
    assert_eq!(sides.iter().filter(|sides| **sides == 2).count(), 3, "{sides:?}");
    let window = level.openings.iter().find(|opening| opening.kind == OpeningKind::Window).unwrap();
    assert!((window.bottom - 0.9).abs() < 1e-6 && (window.top - 2.2).abs() < 1e-6, "{window:?}");
}

#[test]
fn faults_have_their_lines_and_come_all_at_once() {
    let head = "building_id,floor_id,entity_type,entity_subtype,geometry,elevation\n";
    let square = "\"POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))\"";
    let text = format!(
        "{head}1,2,area,ROOM,{square},0\n1,2,area,ROOM,\"POLYGON ((0 0, 4\",0\n,2,area,ROOM,{square},0\n\
         1,2,area\n1,2,area,ROOM,{square},high\n1,2,ghost,X,{square},0\n1,2,opening,HATCH,{square},0\n1,2,area,NAVE,{square},0\n"
    );
    let (_folder, path) = written(&text);
    assert!((FORMAT.recognises)(&path));
    let found = read_only(&path, &[]).unwrap();
    let shown: Vec<(usize, &str)> = found
        .faults
        .0
        .iter()
        .map(|fault| (fault.position.map_or(0, |place| place.0), fault.message.as_str()))
        .collect();
    for (line, message) in [
        (3, "broken well-known text"),
        (4, "\"\" is no id"),
        (5, "the row has 3 fields, the table 6"),
        (6, "\"high\" is no number"),
        (7, "unknown kind of element \"ghost\""),
        (8, "unknown kind of element \"HATCH\""),
        (9, "unknown room word \"NAVE\""),
    ] {
        let is_told = shown.iter().any(|(at, told)| *at == line && told.starts_with(message));
        assert!(is_told, "{line}: {message} in {shown:?}");
    }
    assert_eq!(shown.len(), 7, "{shown:?}");
}

#[test]
fn a_quote_that_is_never_closed_ends_the_reading_with_its_line() {
    let head = "building_id,floor_id,entity_type,entity_subtype,geometry\n";
    let row = "1,2,area,ROOM,\"POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))\"\n";
    let text = format!("{head}{row}1,2,area,ROOM,\"{}", "x,\n".repeat(8 << 20));
    let (_folder, path) = written(&text);
    let found = read_only(&path, &[]).unwrap();
    assert_eq!(ids(&found), ["building_1/floor_2"], "what stands before it is read");
    assert!(
        found.faults.0.iter().any(|fault| fault.message.contains("is a quote not closed?")),
        "{}",
        found.faults
    );
}

#[test]
fn a_table_without_a_needed_column_is_told_so() {
    let (_folder, path) = written("building_id,floor_id,entity_type,geometry\n");
    let refused = read_only(&path, &[]).unwrap_err();
    assert!(refused.contains("no column entity_subtype"), "{refused}");
    assert!(!(FORMAT.recognises)(&path));
}

#[test]
fn the_table_gives_the_same_levels_as_its_native_plan() {
    assert_comes_back(Path::new(TABLE));
}

#[test]
fn kitchens_and_baths_are_kept_at_their_walls() {
    let catalog = builtin_catalog();
    let options = PlanOptions::new(&catalog.room_words);
    let pieces = furniture(Path::new(TABLE), &options).unwrap();
    let keeping = PlanOptions { keeps_furniture: true, ..options };
    let read_with_rooms = read_plans(&[PathBuf::from(TABLE)], &keeping).furniture.remove(Path::new(TABLE));
    assert_eq!(read_with_rooms.as_ref(), Some(&pieces), "the table is not read once more");
    let PlanReading { plan, .. } = read_plans(&[PathBuf::from(TABLE)], &options);
    let placed = plan.buildings.iter().find(|placed| placed.id == "building_21").unwrap();
    let kept = keep_drawn(&pieces, placed, catalog);
    let objects: Vec<String> = kept.file.edits.iter().flat_map(|room| room.objects.keys().cloned()).collect();
    for class in ["sink_unit.1", "cooker.1", "worktop.1", "toilet.1", "shower.1", "washbasin.1"] {
        assert!(
            objects.iter().any(|object| object == class),
            "{class} in {objects:?}, left out {:?}",
            kept.left_out
        );
    }
    let on_walls = kept.file.edits.iter().flat_map(|room| room.objects.values());
    assert!(
        on_walls
            .clone()
            .all(|object| object.parent.as_ref().is_some_and(|parent| parent.starts_with("wall.")))
    );
    assert!(kept.unknown.is_empty(), "{:?}", kept.unknown);
}

/// The rows of a site of the program that made the data set, as the data set has them.
fn table_of(site: &Path) -> String {
    let parse = |name: &str| -> Value {
        serde_json::from_str(&fs::read_to_string(site.join(name)).unwrap()).unwrap()
    };
    let (floors, projects, areas) =
        (parse("floors.json"), parse("react_planner_projects.json"), parse("areas.json"));
    let mut rows = vec![
        "apartment_id,site_id,building_id,plan_id,floor_id,unit_id,area_id,unit_usage,entity_type,entity_subtype,geometry,elevation,height"
            .to_owned(),
    ];
    for floor in floors.as_array().unwrap() {
        let plan = &floor["plan_id"];
        let elevation = floor["floor_number"].as_f64().unwrap() * 2.9;
        let mut row = |area: &str, kind: &str, subtype: &str, wkt: &str, low: f64, height: f64| {
            let subtype = subtype.to_uppercase();
            let low = elevation + low;
            rows.push(format!(
                ",1440,{},{plan},{plan},,{area},RESIDENTIAL,{kind},{subtype},\"{wkt}\",{low},{height}",
                floor["building_id"]
            ));
        };
        for area in areas.as_array().unwrap().iter().filter(|area| area["plan_id"] == *plan) {
            let word = area["area_type"].as_str().unwrap();
            row(&area["id"].to_string(), "area", word, area["scaled_polygon"].as_str().unwrap(), 0.0, 2.6);
        }
        let project = projects.as_array().unwrap().iter().find(|row| row["plan_id"] == *plan).unwrap();
        let drawing = &project["data"];
        let metres = drawing["scale"].as_f64().unwrap().sqrt() / 100.0;
        let wkt = |element: &Value| {
            let corners = element["coordinates"][0].as_array().unwrap();
            let corner = |corner: &Value| {
                format!("{} {}", corner[0].as_f64().unwrap() * metres, corner[1].as_f64().unwrap() * metres)
            };
            format!("POLYGON (({}))", corners.iter().map(corner).collect::<Vec<_>>().join(", "))
        };
        let layer = &drawing["layers"]["layer-1"];
        for line in layer["lines"].as_object().unwrap().values() {
            let word = line["type"].as_str().unwrap();
            if word != "area_splitter" {
                row("", "separator", word, &wkt(line), 0.0, 2.6);
            }
        }
        for hole in layer["holes"].as_object().unwrap().values() {
            // The data set has no sliding doors.
            let word = hole["type"].as_str().unwrap().trim_start_matches("sliding_");
            let (low, height) = if word == "window" { (0.5, 1.9) } else { (0.0, 2.0) };
            row("", "opening", word, &wkt(hole), low, height);
        }
    }
    rows.join("\n")
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn a_table_of_the_shared_site_gives_the_rooms_and_openings_of_its_drawings() {
    let Some(data) = folder("archilyse") else { return };
    let (_folder, path) = written(&table_of(&data.join("site_1440")));
    let mut words: RoomWords = words();
    words.accept_everything();
    let options = PlanOptions::new(&words);
    let [table, drawings] = [&path, &data.join("site_1440")].map(|input| {
        let reading = read_plans(std::slice::from_ref(input), &options);
        assert!(!reading.faults.has_errors(), "{}", reading.faults);
        reading
    });
    let levels = |reading: &PlanReading| -> Vec<(usize, usize, usize)> {
        let counts =
            reading.reports.iter().flat_map(|report| &report.buildings).flat_map(|building| &building.levels);
        counts.map(|level| (level.rooms.read, level.openings.drawn, level.openings.read)).collect()
    };
    let (found, expected) = (levels(&table), levels(&drawings));
    assert_eq!(found.len(), 6);
    let joined = |reading: &PlanReading| -> usize {
        let levels =
            reading.reports.iter().flat_map(|report| &report.buildings).flat_map(|building| &building.levels);
        levels.map(|level| level.between_rooms).sum()
    };
    for (found, expected) in found.iter().zip(&expected) {
        assert_eq!(found, expected, "rooms, openings drawn and attached");
        assert!(found.2 * 100 >= found.1 * 99, "{found:?}");
    }
    assert_eq!(joined(&table), joined(&drawings));
}
