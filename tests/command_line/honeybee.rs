//! Models of dragonfly and honeybee from the file to furnished levels; they are cases of `tests/cases/plan_import`.

use std::path::Path;

use serde_json::Value;

use super::world::World;

/// A folder with both models.
fn world() -> World {
    let world = World::new();
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases/plan_import");
    for (name, file) in [("clinic", "clinic.dfjson"), ("bungalow", "bungalow.hbjson")] {
        world.write(&format!("models/{file}"), std::fs::read(cases.join(name).join(file)).unwrap());
    }
    world
}

#[test]
fn an_imported_model_bakes_to_the_bytes_of_the_model() {
    let world = world();
    world.must(&["import", "models", "--out", "plans"]);
    world.must(&["bake", "models", "--out", "direct", "--effort", "1"]);
    world.must(&["bake", "plans", "--out", "native", "--effort", "1"]);
    let [direct, native] = ["direct", "native"].map(|folder| world.levels(folder));
    assert_eq!(direct.len(), 4);
    let is_equal = direct.iter().zip(&native).all(|(one, other)| one == other);
    assert!(is_equal && native.len() == direct.len());
}

#[test]
fn the_name_of_a_model_does_not_matter() {
    let world = world();
    std::fs::rename(world.path("models/clinic.dfjson"), world.path("models/clinic.txt")).unwrap();
    let told = world.must(&["import", "models/clinic.txt", "--out", "plans", "--json"]);
    let answer: Value = serde_json::from_str(&told.stdout).unwrap();
    assert_eq!(answer["buildings"][0]["id"], "clinic", "{answer:#}");
}
