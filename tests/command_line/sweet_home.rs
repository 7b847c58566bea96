//! Homes of Sweet Home 3D from the file to furnished levels. `tests/cases/sweet_home/README.md` says how they are made.

use std::path::Path;

use serde_json::Value;

use super::world::World;

/// Those that are read; the only other one is of an old version.
const HOMES: [&str; 8] =
    ["attic", "centre_lines", "doors", "flat", "groups", "round", "storeys", "without_rooms"];

/// A folder with homes.
fn world(names: &[&str]) -> World {
    let world = World::new();
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases/sweet_home");
    for name in names {
        let file = format!("{name}.sh3d");
        world.write(&format!("homes/{file}"), std::fs::read(cases.join(&file)).unwrap());
    }
    world
}

#[test]
fn an_imported_home_bakes_to_the_bytes_of_the_home() {
    let world = world(&HOMES);
    world.must(&["import", "homes", "--out", "plans"]);
    world.must(&["bake", "homes", "--out", "direct", "--effort", "1"]);
    world.must(&["bake", "plans", "--out", "native", "--effort", "1"]);
    let [direct, native] = ["direct", "native"].map(|folder| world.levels(folder));
    assert_eq!(direct.len(), 9);
    let names = |levels: &[(String, Vec<u8>)]| -> Vec<String> {
        levels.iter().map(|(name, _)| name.clone()).collect()
    };
    assert_eq!(names(&direct), names(&native));
    let differ: Vec<&str> = direct
        .iter()
        .zip(&native)
        .filter(|(one, other)| one.1 != other.1)
        .map(|(one, _)| one.0.as_str())
        .collect();
    assert!(differ.is_empty(), "{differ:?}");
}

#[test]
fn rooms_of_homes_are_furnished_and_their_doors_open() {
    let world = world(&["attic", "centre_lines", "flat", "groups", "round", "storeys", "without_rooms"]);
    world.must(&["bake", "homes", "--out", "out"]);
    let manifest: Value = serde_json::from_slice(&world.read("out/manifest.json")).unwrap();
    let audit = world.run(&["audit", "out", "--json"]);
    let answer: Value = serde_json::from_str(&audit.stdout).unwrap();
    assert_eq!(audit.code, Some(0), "{answer:#}");
    assert_eq!(manifest["levels"].as_array().unwrap().len(), 8, "{manifest:#}");
}

#[test]
fn kept_furniture_stays_where_the_home_has_it() {
    let world = world(&["flat"]);
    let told = world.must(&["import", "homes/flat.sh3d", "--out", "plans", "--keep-furniture", "--json"]);
    let answer: Value = serde_json::from_str(&told.stdout).unwrap();
    let kept = &answer["buildings"][0]["edits"];
    assert_eq!((&kept["kept"], &kept["drawn"]), (&Value::from(12), &Value::from(13)), "{answer:#}");
    let faults = answer["faults"].as_array().unwrap();
    let message = "no class for furniture \"Mannequin\": 1 piece left out";
    assert_eq!(faults.len(), 1, "{answer:#}");
    assert_eq!(faults[0]["message"], message);
    let edits = String::from_utf8(world.read("plans/flat.edits.yaml")).unwrap();
    for id in ["toilet.1", "bathtub.1", "cooker.1", "sink_unit.1", "single_bed.1", "wall_cabinet.1"] {
        assert!(edits.contains(&format!("{id}: {{add: true, lock: true")), "{id}: {edits}");
    }
    let baked = world.must(&["bake", "plans", "--out", "out"]);
    assert!(!baked.stderr.contains("warning"), "{}", baked.stderr);
    let manifest: Value = serde_json::from_slice(&world.read("out/manifest.json")).unwrap();
    let classes = &manifest["levels"][0]["classes"];
    assert!(classes["toilet"] == 1 && classes["bathtub"] == 1 && classes["cooker"] == 1, "{manifest:#}");
    // A second time nothing is overwritten.
    let again = world.run(&["import", "homes/flat.sh3d", "--out", "plans", "--keep-furniture"]);
    assert_eq!(again.code, Some(2), "{}", again.stderr);
}

#[test]
fn a_home_without_xml_is_refused_with_advice() {
    let world = world(&["before_5_3"]);
    let ran = world.run(&["check", "homes/before_5_3.sh3d"]);
    assert_ne!(ran.code, Some(0));
    let told = ran.stdout + &ran.stderr;
    assert!(told.contains("was saved without Home.xml") && told.contains("5.3 or later"), "{told}");
}
