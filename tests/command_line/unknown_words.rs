//! Rooms with unknown words are guessed, reported in few lines, and written with the guessed type.

use std::path::Path;

use serde_json::{Value, json};

use super::world::World;

/// Copies a case of foreign plans into the world.
fn copy_case(world: &World, case: &str) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases/plan_import").join(case);
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap();
        world.write(&format!("{case}/{name}"), std::fs::read(&path).unwrap());
    }
}

/// Takes the drawn walls out of the case `block`: their thickness is more than a native plan says.
fn forget_drawn_walls(world: &World) {
    let file = "block/react_planner_projects.json";
    let mut projects: Value = serde_json::from_slice(&world.read(file)).unwrap();
    for project in projects.as_array_mut().unwrap() {
        project["data"]["layers"]["layer-1"]["lines"] = json!({});
    }
    world.write(file, serde_json::to_vec(&projects).unwrap());
}

#[test]
fn an_import_with_unknown_words_bakes_to_the_same_bytes() {
    let world = World::new();
    copy_case(&world, "block");
    forget_drawn_walls(&world);
    let told = world.must(&["import", "block", "--out", "native.yaml", "--report"]);
    assert!(told.stdout.contains("guessed   1 room whose word is unknown"), "{}", told.stdout);
    let native = String::from_utf8(world.read("native.yaml")).unwrap();
    assert!(native.contains("id: \"105\"\n    type: storeroom"), "{native}");
    world.must(&["bake", "block", "--out", "one"]);
    world.must(&["bake", "native.yaml", "--out", "two"]);
    for floor in ["block/floor_0.glb", "block/floor_1.glb"] {
        assert!(world.read(&format!("one/{floor}")) == world.read(&format!("two/{floor}")), "{floor}");
    }
}

#[test]
fn check_reports_guesses_with_their_reasons() {
    let world = World::new();
    copy_case(&world, "campus");
    let ran = world.run(&["check", "campus"]);
    let told = format!("{}{}", ran.stdout, ran.stderr);
    let guess = "room \"u-odd\" (planetarium): read as classroom: 39.4 m², one door, among rooms of the family school";
    assert!(told.contains(guess), "{told}");
}

/// An archive with rooms whose words are all unknown and all different.
fn write_strange_rooms(world: &World, count: usize) {
    copy_case(world, "campus");
    let mut units: Value = serde_json::from_slice(&world.read("campus/unit.geojson")).unwrap();
    let unit = |number: usize| {
        let (west, south) = (30.0 + 0.0001 * (number % 50) as f64, 60.0 + 0.000_06 * (number / 50) as f64);
        let (east, north) = (west + 0.000_09, south + 0.000_05);
        let ring = [[west, south], [east, south], [east, north], [west, north], [west, south]];
        json!({"id": format!("u-{number}"), "type": "Feature", "feature_type": "unit",
            "geometry": {"type": "Polygon", "coordinates": [ring]},
            "properties": {"category": format!("zxq{number}"), "level_id": "level-a", "name": null}})
    };
    units["features"] = (0..count).map(unit).collect();
    world.write("campus/unit.geojson", serde_json::to_vec(&units).unwrap());
    world.write("campus/opening.geojson", "{\"type\": \"FeatureCollection\", \"features\": []}");
}

#[test]
fn thousands_of_unknown_words_are_reported_in_few_lines() {
    let world = World::new();
    write_strange_rooms(&world, 2000);
    let ran = world.run(&["import", "campus", "--out", "b.yaml"]);
    assert!(ran.stderr.contains("more rooms with unknown words: read as"), "{}", ran.stderr);
    assert!(ran.stderr.contains("1980 more unknown room words"), "{}", ran.stderr);
    let lines = ran.stderr.lines().count();
    assert!(lines < 250, "{lines} lines");
}
