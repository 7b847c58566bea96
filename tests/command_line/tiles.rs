//! 3D Tiles of plans and of finished bakes.

use serde_json::Value;

use super::world::{World, plan};

fn json(world: &World, path: &str) -> Value {
    serde_json::from_slice(&world.read(path)).unwrap()
}

/// The files of the folder, without its own records.
fn tiles(world: &World, folder: &str) -> Vec<String> {
    world.files(folder).into_keys().filter(|name| name.ends_with(".glb")).collect()
}

#[test]
fn each_level_is_there_in_three_details_and_the_tileset_leads_to_them() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 2));
    let ran = world.must(&["tiles", "a.yaml"]);
    assert!(ran.stdout.contains("tileset.json"), "{}", ran.stdout);
    assert_eq!(tiles(&world, "tiles").len(), 6);
    let text = String::from_utf8(world.read("tiles/tileset.json")).unwrap();
    for level in ["1", "2"] {
        for detail in ["boxes", "reduced", "full"] {
            assert!(text.contains(&format!("\"alpha/{level}.{detail}.glb\"")), "{text}");
        }
    }
    let manifest = json(&world, "tiles/manifest.json");
    assert_eq!(manifest["index"][0]["path"], "tileset.json");
    assert_eq!(manifest["levels"][0]["files"].as_array().unwrap().len(), 3);
    assert_eq!(manifest["levels"][1]["bounds"]["elevation"], 3.0);
}

#[test]
fn unchanged_levels_keep_their_tiles_and_distances_change_the_tileset_alone() {
    let world = World::new();
    world.write("plans/a.yaml", plan("alpha", 2));
    world.must(&["tiles", "plans"]);
    let before = world.files("tiles");
    let again = world.must(&["tiles", "plans", "--json"]);
    let again: Value = serde_json::from_str(&again.stdout).unwrap();
    assert_eq!((&again["baked_levels"], &again["kept_levels"]), (&Value::from(0), &Value::from(2)));
    assert_eq!(world.files("tiles"), before);
    world.must(&["tiles", "plans", "--near", "200,50,20"]);
    let after = world.files("tiles");
    let changed: Vec<&String> = after.keys().filter(|name| after[*name] != before[*name]).collect();
    assert_eq!(changed, ["manifest.json", "tileset.json"]);
    // Another building is in the tileset; without it, the tileset is as before.
    world.write("plans/b.yaml", plan("beta", 1));
    world.must(&["tiles", "plans"]);
    assert!(String::from_utf8(world.read("tiles/tileset.json")).unwrap().contains("beta/1.full.glb"));
    std::fs::remove_file(world.path("plans/b.yaml")).unwrap();
    world.must(&["tiles", "plans", "--prune"]);
    assert_eq!(world.files("tiles"), before);
}

#[test]
fn a_finished_bake_becomes_the_same_tileset_with_what_is_in_its_files() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 2));
    world.must(&["tiles", "a.yaml"]);
    world.must(&["bake", "a.yaml"]);
    world.must(&["tiles", "out", "--out", "of-bake"]);
    assert_eq!(world.read("of-bake/tileset.json"), world.read("tiles/tileset.json"));
    assert_eq!(tiles(&world, "of-bake"), tiles(&world, "tiles"));
    let [whole, of_bake] =
        ["tiles", "of-bake"].map(|folder| json(&world, &format!("{folder}/manifest.json")));
    assert_eq!(whole["totals"], of_bake["totals"]);
    let again = world.must(&["tiles", "out", "--out", "of-bake", "--json"]);
    assert_eq!(serde_json::from_str::<Value>(&again.stdout).unwrap()["kept_levels"], 2);
    // A level that was baked anew is written anew, the other one is kept.
    world.must(&["bake", "a.yaml", "--reroll", "alpha/1/bed"]);
    let again = world.must(&["tiles", "out", "--out", "of-bake", "--json"]);
    let again: Value = serde_json::from_str(&again.stdout).unwrap();
    assert_eq!((&again["baked_levels"], &again["kept_levels"]), (&Value::from(1), &Value::from(1)));
}

#[test]
fn a_level_of_a_bake_that_cannot_be_read_is_named_and_the_others_are_written() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 2));
    world.must(&["bake", "a.yaml"]);
    world.write("out/alpha/1.glb", b"glTF, and nothing else");
    let ran = world.run(&["tiles", "out"]);
    assert_eq!(ran.code, Some(1), "{}", ran.stderr);
    assert!(ran.stderr.contains("alpha") && ran.stderr.contains("cut off"), "{}", ran.stderr);
    assert_eq!(tiles(&world, "tiles").len(), 3);
    assert!(!String::from_utf8(world.read("tiles/tileset.json")).unwrap().contains("alpha/1."));
}

#[test]
fn what_cannot_be_meant_is_refused() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 1));
    world.must(&["bake", "a.yaml"]);
    let refused = [
        (&["tiles", "a.yaml", "--near", "10,20,30"][..], "fall"),
        (&["tiles", "a.yaml", "--origin", "52.5,100"], "latitude"),
        (&["tiles", "a.yaml", "--heading", "20"], "--origin"),
        (&["tiles", "out", "a.yaml"], "one by one"),
        (&["tiles", "out", "--seed", "3"], "--seed does not apply"),
        (&["tiles", "out", "--out", "tiles.glb"], "name of a file"),
        (&["tiles", "out", "--out", "out"], "bake itself"),
    ];
    for (arguments, word) in refused {
        let ran = world.run(arguments);
        assert_eq!(ran.code, Some(2), "{arguments:?} {}", ran.stderr);
        assert!(ran.stderr.contains(word), "{arguments:?} {}", ran.stderr);
    }
    assert!(!world.path("tiles").exists());
}

#[test]
fn a_tileset_of_other_origin_is_not_overwritten() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 1));
    world.write("tiles/tileset.json", "{\"asset\": {\"version\": \"1.0\"}}");
    let ran = world.run(&["tiles", "a.yaml"]);
    assert_eq!(ran.code, Some(1), "{}", ran.stderr);
    assert!(ran.stderr.contains("tileset.json"), "{}", ran.stderr);
    assert!(world.read("tiles/tileset.json").starts_with(b"{\"asset\": {\"version\": \"1.0\"}}"));
    world.must(&["tiles", "a.yaml", "--force"]);
    assert!(String::from_utf8(world.read("tiles/tileset.json")).unwrap().contains("alpha/1.full.glb"));
}
