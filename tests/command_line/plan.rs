//! `plan`, and `bake` of a map of outlines: files, choices, faults.

use std::io::Write;

use flate2::{Compression, write::GzEncoder};
use serde_json::Value;

use super::world::World;

/// A map of one house, at a place in degrees of longitude.
fn house(id: &str, west: f64) -> String {
    let (east, south, north) = (west + 0.00015, 52.5, 52.50008);
    format!(
        r#"{{"type": "FeatureCollection", "features": [{{"type": "Feature", "id": "{id}",
  "properties": {{"building": "house", "building:levels": "2"}}, "geometry": {{"type": "Polygon", "coordinates":
  [[[{west}, {south}], [{east}, {south}], [{east}, {north}], [{west}, {north}], [{west}, {south}]]]}}}}]}}"#
    )
}

#[test]
fn a_bake_of_the_plans_furnishes_as_one_of_the_map() {
    let world = World::new();
    world.write("town.geojson", house("way/1", 13.4));
    world.must(&["bake", "town.geojson", "--out", "one", "--textures", "none", "--seed", "3"]);
    world.must(&["plan", "town.geojson", "--out", "plans", "--seed", "3", "--report", "report.json"]);
    let report: Value = serde_json::from_slice(&world.read("report.json")).unwrap();
    assert_eq!(report["buildings"][0]["typology"], "house");
    world.must(&["bake", "plans/project.yaml", "--out", "two", "--textures", "none"]);
    let furniture = |out: &str| -> Vec<(Value, Value)> {
        let manifest: Value = serde_json::from_slice(&world.read(&format!("{out}/manifest.json"))).unwrap();
        let levels = manifest["levels"].as_array().unwrap();
        levels.iter().map(|level| (level["classes"].clone(), level["totals"].clone())).collect()
    };
    assert_eq!(furniture("one").len(), 2);
    assert_eq!(furniture("one"), furniture("two"));
    let [one, two] = ["one", "two"].map(|out| world.levels(out));
    assert!(one.len() == 2 && one == two);
}

#[test]
fn a_use_that_nobody_knows_is_an_error_with_a_hint() {
    let world = World::new();
    world.write("town.geojson", house("way/1", 13.4));
    let told = world.run(&["plan", "town.geojson", "--out", "plans", "--use", "hotl"]);
    assert_eq!(told.code, Some(2), "{}", told.stderr);
    assert!(told.stderr.contains("unknown use \"hotl\"") && told.stderr.contains("hotel"), "{}", told.stderr);
    assert!(!world.path("plans").exists());
}

#[test]
fn a_map_that_is_not_there_is_told_as_such() {
    let told = World::new().run(&["plan", "town.geojson", "--out", "plans"]);
    assert_eq!(told.code, Some(2));
    assert!(told.stderr.contains("there is no such file"), "{}", told.stderr);
}

#[test]
fn what_is_no_map_is_told_by_name() {
    let world = World::new();
    for (name, bytes, told) in [
        ("a.zip", &b"PK\x03\x04"[..], "looks like a ZIP archive"),
        ("a.geojson", b"\xff\xfe{\0", "is text in UTF-16"),
        ("a.json", br#"{"type": "Topology"}"#, "GeoJSON features, CityJSON and OpenStreetMap"),
        // Packed, as its first bytes say, and nothing else.
        ("a.gz", b"\x1f\x8b\x08", "looks like a compressed file"),
    ] {
        world.write(name, bytes);
        let run = world.run(&["plan", name, "--out", "plans"]);
        assert_eq!(run.code, Some(2), "{name}: {}", run.stderr);
        assert!(run.stderr.contains(told), "{name}: {}", run.stderr);
    }
}

#[test]
fn a_packed_map_is_planned_as_what_it_holds() {
    let world = World::new();
    let map = house("way/1", 13.4);
    let mut packed = GzEncoder::new(Vec::new(), Compression::default());
    packed.write_all(map.as_bytes()).unwrap();
    let packed = packed.finish().unwrap();
    world.write("town.geojson", map);
    world.write("town.geojson.gz", &packed);
    world.write("cut.geojson.gz", &packed[..packed.len() - 9]);
    world.must(&["plan", "town.geojson", "--out", "plans"]);
    world.must(&["plan", "town.geojson.gz", "--out", "of-packed"]);
    assert_eq!(world.read("plans/w1.yaml"), world.read("of-packed/w1.yaml"));
    let run = world.run(&["plan", "cut.geojson.gz", "--out", "cut"]);
    assert_eq!(run.code, Some(2), "{}", run.stderr);
    assert!(
        run.stderr.contains("cannot be unpacked") && run.stderr.contains("fetch it again"),
        "{}",
        run.stderr
    );
    assert!(!world.path("cut").exists());
}

#[test]
fn of_two_buildings_with_one_id_the_first_stays_also_by_force() {
    let world = World::new();
    world.write("east.geojson", house("way/1", 13.4));
    world.write("west.geojson", house("way/1", 13.3));
    let told = world.run(&["plan", "east.geojson", "west.geojson", "--out", "plans", "--force"]);
    assert_eq!(told.code, Some(1), "{}", told.stderr);
    assert!(told.stderr.contains("is used by \"east.geojson\" too"), "{}", told.stderr);
    let project = String::from_utf8(world.read("plans/project.yaml")).unwrap();
    assert_eq!(project.matches("plan:").count(), 1, "{project}");
}
