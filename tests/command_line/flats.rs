//! Swiss Dwellings and ResPlan from the file to furnished levels.

use std::path::Path;

use serde_json::Value;

use super::world::World;

/// A folder with the table and the flat of the cases.
fn world() -> World {
    let world = World::new();
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases/plan_import");
    for file in ["swiss_dwellings/geometries.csv", "resplan/flat_7.json"] {
        let name = Path::new(file).file_name().unwrap().to_str().unwrap();
        world.write(&format!("flats/{name}"), std::fs::read(cases.join(file)).unwrap());
    }
    world
}

#[test]
fn imported_flats_bake_to_the_bytes_of_their_files() {
    let world = world();
    world.must(&["import", "flats", "--out", "plans"]);
    world.must(&["bake", "flats", "--out", "direct", "--effort", "1"]);
    world.must(&["bake", "plans", "--out", "native", "--effort", "1"]);
    let [direct, native] = ["direct", "native"].map(|folder| world.levels(folder));
    assert_eq!(direct.len(), 4, "three floors of the table and the flat");
    assert!(direct == native, "the same names and bytes");
}

#[test]
fn a_chosen_floor_is_imported_with_its_kitchen_and_bath() {
    let world = world();
    let import = ["import", "flats/geometries.csv", "--only", "floor_211", "--keep-furniture", "--json"];
    let told = world.must(&[&import[..], &["--out", "plans"]].concat());
    let answer: Value = serde_json::from_str(&told.stdout).unwrap();
    let buildings = answer["buildings"].as_array().unwrap();
    assert_eq!((buildings.len(), &buildings[0]["levels"]), (1, &Value::from(1)), "{answer:#}");
    // A kitchen of four units, a toilet, a shower and a basin.
    let kept = &buildings[0]["edits"];
    assert_eq!((&kept["kept"], &kept["drawn"]), (&Value::from(7), &Value::from(7)), "{answer:#}");
    world.must(&["bake", "plans", "--out", "out"]);
    let manifest: Value = serde_json::from_slice(&world.read("out/manifest.json")).unwrap();
    let classes = &manifest["levels"][0]["classes"];
    assert!(classes["toilet"] == 1 && classes["shower"] == 1 && classes["cooker"] == 1, "{classes:#}");
}

#[test]
fn a_given_scale_comes_before_the_stated_area() {
    let world = world();
    world.must(&["import", "flats/flat_7.json", "--scale", "0.1", "--out", "plans"]);
    let plan = String::from_utf8(world.read("plans/flat_7.yaml")).unwrap();
    assert!(plan.contains("9.8"), "98 units are 9.8 m: {plan}");
}

#[test]
fn pickles_are_refused_with_advice() {
    let world = world();
    world.write("flats.pkl", b"\x80\x04\x95\x10\0\0\0\0\0\0\0]\x94.".as_slice());
    let ran = world.run(&["check", "flats.pkl"]);
    assert_ne!(ran.code, Some(0));
    let told = ran.stdout + &ran.stderr;
    assert!(told.contains("looks like a Python pickle") && told.contains("docs/importing.md"), "{told}");
}
