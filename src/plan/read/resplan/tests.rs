//! An invented plan in the forms of the data set, its scale, and its faults.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};
use tempfile::TempDir;

use super::{FORMAT, read};
use crate::plan::read::reader::ReadBuildings;
use crate::plan::read::real_data::{assert_comes_back, words};
use crate::plan::{Level, LevelDraft, OpeningKind, PlanOptions, assemble_level};
use crate::storey::{Choices, Typologies};

const FLAT: &str = "tests/cases/plan_import/resplan/flat_7.json";

fn flat() -> Value {
    serde_json::from_str(&fs::read_to_string(FLAT).unwrap()).unwrap()
}

fn written(document: &Value) -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("plan.json");
    fs::write(&path, document.to_string()).unwrap();
    (folder, path)
}

fn read_scaled(path: &Path, metres_per_unit: Option<f64>) -> Result<ReadBuildings, String> {
    let words = words();
    let typologies = Typologies::default();
    let choices = Choices { metres_per_unit, ..Choices::default() };
    let options = PlanOptions::new(&words).with_planning(&typologies, &choices);
    read(path, &options).map_err(|faults| faults.to_string())
}

fn level_of(read: &ReadBuildings) -> &LevelDraft {
    &read.buildings[0].draft.levels[0]
}

fn assembled(read: &ReadBuildings) -> Level {
    let (level, problems) = assemble_level(level_of(read).clone());
    assert!(problems.iter().all(|problem| !problem.is_error), "{problems:?}");
    level
}

#[test]
fn a_plan_has_its_rooms_in_metres_without_the_frame_around_its_kitchen() {
    let read = read_scaled(Path::new(FLAT), None).unwrap();
    let level = assembled(&read);
    let area = |id: &str| level.rooms.iter().find(|room| room.id == id).unwrap().region.area();
    // 200 by 160 units are 80 m².
    for (id, expected) in
        [("bedroom_1", 22.05), ("kitchen_1", 9.9), ("living_1", 22.35), ("bathroom_1", 5.28)]
    {
        assert!((area(id) - expected).abs() < 0.06, "{id}: {}", area(id));
    }
    assert_eq!(level.rooms.len(), 6);
}

#[test]
fn doors_and_windows_attach_and_the_kitchen_is_open_to_the_living_area() {
    let level = assembled(&read_scaled(Path::new(FLAT), None).unwrap());
    let sides = |kind: OpeningKind| -> Vec<usize> {
        let openings = level.openings.iter().filter(|opening| opening.kind == kind);
        openings.map(|opening| opening.sides.len()).collect()
    };
    assert_eq!(sides(OpeningKind::Door).len(), 5);
    assert_eq!(
        sides(OpeningKind::Door).iter().filter(|sides| **sides == 2).count(),
        4,
        "the front door leads outside"
    );
    assert_eq!(sides(OpeningKind::Window), [1]);
    assert_eq!(sides(OpeningKind::OpenBoundary), [2]);
}

/// The classes of the flat: five of rooms, four of walls and openings, and the area within the walls.
const CLASSES: [&str; 10] =
    ["living", "kitchen", "bathroom", "bedroom", "balcony", "wall", "door", "front_door", "window", "inner"];

/// The polygons of a class of the flat as coordinates of GeoJSON, in units of this many metres.
fn polygons(class: &str, unit: f64) -> Vec<Value> {
    let geometry = &flat()[class];
    let polygons = match geometry["type"].as_str() {
        Some("MultiPolygon") => geometry["coordinates"].as_array().unwrap().clone(),
        _ => vec![geometry["coordinates"].clone()],
    };
    let scaled =
        |corner: &Value| json!([corner[0].as_f64().unwrap() * unit, corner[1].as_f64().unwrap() * unit]);
    let ring = |ring: &Value| Value::Array(ring.as_array().unwrap().iter().map(scaled).collect());
    let rings = |rings: &Value| Value::Array(rings.as_array().unwrap().iter().map(ring).collect());
    polygons.iter().map(rings).collect()
}

/// The flat with well-known text under `geometries`, in a list.
fn flat_as_text() -> Value {
    let text = |rings: &Value| {
        let corners = rings[0].as_array().unwrap().iter();
        let corners: Vec<String> = corners.map(|corner| format!("{} {}", corner[0], corner[1])).collect();
        json!(format!("POLYGON (({}))", corners.join(", ")))
    };
    let texts = |class: &&str| -> (String, Value) {
        ((*class).to_owned(), polygons(class, 1.0).iter().map(text).collect())
    };
    let geometries: serde_json::Map<String, Value> = CLASSES.iter().map(texts).collect();
    json!([{"id": 7, "geometries": geometries, "net_area": 80.0}])
}

/// The flat as instances in metres.
fn flat_as_instances() -> Value {
    let instance = |rings: &Value| json!({"id": "X", "geom": {"type": "Polygon", "coordinates": rings}});
    let of = |classes: &[&str]| -> serde_json::Map<String, Value> {
        let instances = |class: &&str| -> (String, Value) {
            ((*class).to_owned(), polygons(class, 0.05).iter().map(instance).collect())
        };
        classes.iter().map(instances).collect()
    };
    let metadata = json!({"dataset": "ResPlan", "units": "m", "net_area": 80.0});
    let instances = json!({"room": of(&CLASSES[..5]), "structural": of(&CLASSES[5..9])});
    json!({"metadata": metadata, "instances": instances})
}

#[test]
fn shapes_as_text_and_as_instances_in_metres_give_the_same_level() {
    let original = read_scaled(Path::new(FLAT), None).unwrap();
    for document in [flat_as_text(), flat_as_instances()] {
        let (_folder, path) = written(&document);
        assert!((FORMAT.recognises)(&path), "{document}");
        let found = read_scaled(&path, None).unwrap();
        let (found, original) = (level_of(&found), level_of(&original));
        assert_eq!(found.openings.len(), original.openings.len());
        assert_eq!(found.rooms.len(), original.rooms.len());
        for (one, other) in found.rooms.iter().zip(&original.rooms) {
            assert_eq!((&one.id, one.outline.len()), (&other.id, other.outline.len()));
            let gap = one.outline.iter().zip(&other.outline).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
            assert!(gap < 1e-6, "{}: {gap}", one.id);
        }
    }
}

#[test]
fn a_map_with_the_words_of_rooms_as_values_is_no_plan() {
    let rooms = ["kitchen", "bathroom", "bedroom"].map(|word| json!({"room": word, "door": "yes"}));
    let (_folder, path) = written(&json!({"type": "Polygon", "elements": rooms}));
    assert!(!(FORMAT.recognises)(&path));
}

#[test]
fn the_scale_is_stated_or_given_or_a_fault() {
    let mut plan = flat();
    let width = |read: &ReadBuildings| {
        let bedroom = level_of(read).rooms.iter().find(|room| room.id == "bedroom_1").unwrap();
        crate::geometry::Bounds::around(bedroom.outline.iter().copied()).size().x
    };
    let (_folder, path) = written(&plan);
    assert!((width(&read_scaled(&path, None).unwrap()) - 4.9).abs() < 1e-9);
    assert!((width(&read_scaled(&path, Some(0.1)).unwrap()) - 9.8).abs() < 1e-9);
    plan["net_area"] = Value::Null;
    let (_folder, path) = written(&plan);
    let by_area = width(&read_scaled(&path, None).unwrap());
    assert!((by_area - 4.9 * (96.5f64 / 80.0).sqrt()).abs() < 1e-9, "{by_area}");
    // Metres that are hundreds of times the stated area are none.
    plan["units"] = json!("m");
    let (_folder, path) = written(&plan);
    assert!((width(&read_scaled(&path, None).unwrap()) - by_area).abs() < 1e-9);
    plan["units"] = Value::Null;
    plan["area"] = json!("unknown");
    let (_folder, path) = written(&plan);
    let refused = read_scaled(&path, None).unwrap_err();
    assert!(refused.contains("the plan has no scale") && refused.contains("--scale"), "{refused}");
}

#[test]
fn faults_have_their_places_and_come_all_at_once() {
    let mut plan = flat();
    plan["kitchen"] = json!("POLYGON ((0 0, 4");
    plan["bedroom"]["coordinates"][1] = json!("wide");
    plan["bathroom"] = json!({"type": "Polygon", "coordinates": [[[0, "a"]]]});
    let (_folder, path) = written(&json!([plan, 5]));
    let found = read_scaled(&path, None).unwrap();
    let shown: Vec<(String, &str)> = found
        .faults
        .0
        .iter()
        .map(|fault| (crate::document::show_path(&fault.path), fault.message.as_str()))
        .collect();
    for (place, message) in [
        ("[0].bathroom.coordinates", "are no coordinates of a Polygon"),
        ("[0].bedroom.coordinates", "are no coordinates of a MultiPolygon"),
        ("[0].kitchen", "broken well-known text"),
        ("[0].sauna", "unknown class \"sauna\": 1 shape left out"),
        ("[1]", "is no plan"),
    ] {
        let is_told = shown.iter().any(|(at, told)| at == place && told.starts_with(message));
        assert!(is_told, "{place}: {message} in {shown:?}");
    }
    assert_eq!(shown.len(), 5, "{shown:?}");
}

#[test]
fn plans_of_a_list_have_ids_of_their_own() {
    let (_folder, path) = written(&json!([flat(), flat()]));
    let read = read_scaled(&path, None).unwrap();
    let ids: Vec<&str> = read.buildings.iter().map(|building| building.id.as_str()).collect();
    assert_eq!(ids, ["plan_7", "plan_7_2"]);
}

#[test]
fn the_plan_gives_the_same_level_as_its_native_plan() {
    assert_comes_back(Path::new(FLAT));
}
