//! Navigation meshes and occupancy maps of finished files.

use serde_json::Value;

use super::world::{World, plan};

fn json(world: &World, path: &str) -> Value {
    serde_json::from_slice(&world.read(path)).unwrap()
}

#[test]
fn each_level_has_a_mesh_and_a_map_and_the_index_lists_them() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 2));
    world.must(&["bake", "a.yaml", "--textures", "none"]);
    let ran = world.must(&["navigation"]);
    assert!(ran.stdout.contains("2 levels"), "{}", ran.stdout);
    let files = world.names("navigation");
    for name in
        ["alpha/1.navigation.json", "alpha/1.occupancy.png", "alpha/2.occupancy.yaml", "navigation.json"]
    {
        assert!(files.iter().any(|file| file == name), "{files:?}");
    }
    let (index, mesh) =
        (json(&world, "navigation/navigation.json"), json(&world, "navigation/alpha/2.navigation.json"));
    assert_eq!((&index["levels"][1]["level"], &mesh["level"]), (&Value::from("2"), &Value::from("2")));
    assert_eq!(index["levels"][1]["elevation"], 3.0);
    assert!(mesh["polygons"].as_array().is_some_and(|polygons| !polygons.is_empty()));
    let text = String::from_utf8(world.read("navigation/alpha/1.occupancy.yaml")).unwrap();
    assert!(text.starts_with("image: \"1.occupancy.png\"\n"), "{text}");
}

#[test]
fn the_same_files_give_the_same_bytes_and_nothing_of_others_is_overwritten() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 1));
    world.must(&["bake", "a.yaml", "--textures", "none"]);
    world.must(&["navigation"]);
    let before = world.files("navigation");
    world.must(&["navigation", "out/alpha/1.glb"]);
    assert_eq!(world.files("navigation"), before);
    // Other files of the command itself are written over, those of others are not.
    world.must(&["navigation", "--radius", "0.3"]);
    assert_ne!(world.files("navigation"), before);
    world.write("navigation/alpha/1.navigation.json", "mine");
    let refused = world.run(&["navigation"]);
    assert_eq!(refused.code, Some(2), "{}", refused.stderr);
    assert!(refused.stderr.contains("--force"), "{}", refused.stderr);
    assert_eq!(world.read("navigation/alpha/1.navigation.json"), b"mine");
    world.must(&["navigation", "--force"]);
    assert_eq!(world.files("navigation"), before);
    world.write("other/navigation.json", "{}");
    let refused = world.run(&["navigation", "--out", "other"]);
    assert!(refused.code == Some(2) && refused.stderr.contains("--out"), "{}", refused.stderr);
}

#[test]
fn files_of_one_name_and_faulty_ones_are_told() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 1));
    world.must(&["bake", "a.yaml", "--textures", "none", "--out", "one"]);
    world.must(&["bake", "a.yaml", "--textures", "none", "--out", "two"]);
    let refused = world.run(&["navigation", "one", "two"]);
    assert!(refused.code == Some(2) && refused.stderr.contains("second file"), "{}", refused.stderr);
    world.write("one/alpha/2.glb", "no glTF");
    let ran = world.run(&["navigation", "one/alpha/1.glb", "one/alpha/2.glb"]);
    assert!(ran.code == Some(1) && ran.stderr.contains("2.glb"), "{}", ran.stderr);
    for wrong in [["--resolution", "0"], ["--radius", "-1"], ["--height", "tall"]] {
        assert_eq!(world.run(&[&["navigation", "one"], wrong.as_slice()].concat()).code, Some(2));
    }
}
