//! Levels that are listed, cut into shares by name, baked in folders of their own and joined again.

use super::world::{World, plan};

fn city() -> World {
    let world = World::new();
    world.write("plans/a.yaml", plan("alpha", 3));
    world.write("plans/b.yaml", plan("beta", 4));
    world.must(&["bake", "plans", "--out", "whole"]);
    world
}

fn listed(world: &World, extra: &[&str]) -> serde_json::Value {
    let ran = world.must(&[&["bake", "plans", "--list-levels", "--json"][..], extra].concat());
    serde_json::from_str(&ran.stdout).unwrap()
}

/// Writes a list with some of the levels, and bakes it as a share.
fn bake_share(world: &World, list: &serde_json::Value, levels: std::ops::Range<usize>, share: &str) {
    let mut some = list.clone();
    some["levels"] = list["levels"].as_array().unwrap()[levels].to_vec().into();
    world.write("share.json", some.to_string());
    let folder = format!("machine-{}", share.replace('/', "-of-"));
    let ran =
        world.must(&["bake", "plans", "--out", &folder, "--shard", share, "--only-levels", "share.json"]);
    assert!(ran.stdout.contains("roomwright merge"), "{}", ran.stdout);
    let name = format!("manifest.{}.json", share.replace('/', "-of-"));
    world.write(&format!("records/{name}"), world.read(&format!("{folder}/{name}")));
}

#[test]
fn a_list_has_every_level_with_its_rooms_and_inputs_and_nothing_is_baked() {
    let world = city();
    let list = listed(&world, &[]);
    let levels = list["levels"].as_array().unwrap();
    let paths: Vec<&str> = levels.iter().map(|level| level["path"].as_str().unwrap()).collect();
    assert_eq!(paths, ["alpha/1", "alpha/2", "alpha/3", "beta/1", "beta/2", "beta/3", "beta/4"]);
    assert_eq!(levels[0]["rooms"], serde_json::json!({"bedroom": 1, "study": 1}));
    let manifest: serde_json::Value = serde_json::from_slice(&world.read("whole/manifest.json")).unwrap();
    assert_eq!(levels[6]["inputs"], manifest["levels"][6]["inputs"]);
    assert_ne!(listed(&world, &["--seed", "2"])["levels"][0]["inputs"], levels[0]["inputs"]);
    let sources = list["sources"].as_array().unwrap();
    assert!(sources.iter().any(|path| path.as_str().unwrap().ends_with("plans")), "{sources:?}");
    assert!(!world.path("out").exists(), "nothing is written");
    let text = world.must(&["bake", "plans", "--list-levels"]).stdout;
    assert!(text.starts_with("alpha/1: 1 bedroom, 1 study\n"), "{text}");
}

#[test]
fn shares_of_listed_levels_are_joined_to_the_manifest_of_one_bake() {
    let world = city();
    let list = listed(&world, &[]);
    world.write("levels.json", list.to_string());
    for (levels, share) in [(0..5, "1/3"), (5..6, "2/3"), (6..7, "3/3")] {
        bake_share(&world, &list, levels, share);
    }
    world.must(&["merge", "--records", "records", "--levels", "levels.json", "--out", "joined.json"]);
    assert_eq!(world.read("joined.json"), world.read("whole/manifest.json"));
}

#[test]
fn a_share_of_all_levels_ends_as_a_part_too() {
    let world = city();
    let list = listed(&world, &[]);
    bake_share(&world, &list, 0..7, "1/1");
    assert!(!world.path("machine-1-of-1/manifest.json").exists());
    world.must(&["merge", "--records", "records"]);
    assert_eq!(world.read("records/manifest.json"), world.read("whole/manifest.json"));
}

#[test]
fn levels_that_no_share_has_are_reported() {
    let world = city();
    let list = listed(&world, &[]);
    world.write("levels.json", list.to_string());
    bake_share(&world, &list, 0..6, "1/1");
    let ran = world.run(&["merge", "--records", "records", "--levels", "levels.json", "--json"]);
    assert_eq!(ran.code, Some(1), "{}", ran.stderr);
    assert!(ran.stderr.contains("no part has level beta/4"), "{}", ran.stderr);
    let manifest = String::from_utf8(world.read("records/manifest.json")).unwrap();
    assert!(manifest.contains("beta/3.glb") && !manifest.contains("beta/4.glb"), "the others are joined");
}

#[test]
fn levels_of_other_plans_or_options_are_neither_baked_nor_joined() {
    let world = city();
    let mut list = listed(&world, &["--seed", "2"]);
    world.write("other.json", list.to_string());
    let bake = ["bake", "plans", "--out", "m", "--shard", "1/2", "--only-levels", "other.json"];
    let ran = world.run(&bake);
    assert_eq!(ran.code, Some(2), "{}", ran.stderr);
    assert!(
        ran.stderr.contains("alpha/1 has other inputs now") && ran.stderr.contains("hint"),
        "{}",
        ran.stderr
    );
    assert!(!world.path("m/alpha").exists());

    bake_share(&world, &listed(&world, &[]), 0..7, "1/1");
    let ran = world.run(&["merge", "--records", "records", "--levels", "other.json"]);
    assert_eq!(ran.code, Some(2), "{}", ran.stderr);
    assert!(ran.stderr.contains("alpha/1 of other inputs than the list"), "{}", ran.stderr);

    list["levels"].as_array_mut().unwrap().truncate(1);
    list["levels"][0]["building"] = "gamma".into();
    world.write("other.json", list.to_string());
    let ran = world.run(&bake);
    assert!(ran.stderr.contains("gamma/1 is not in the plans"), "{}", ran.stderr);
    list["program"] = "0.0.9".into();
    world.write("other.json", list.to_string());
    let ran = world.run(&bake);
    assert_eq!(ran.code, Some(2));
    assert!(ran.stderr.contains("lists levels for the program 0.0.9"), "{}", ran.stderr);
    world.write("other.json", "{\"levels\": 7}");
    assert!(world.run(&bake).stderr.contains("other.json"), "the file is named");
    assert_eq!(world.run(&["bake", "plans", "--only-levels", "other.json"]).code, Some(2), "without --shard");
}

/// A `tileset.json` is made of all levels: no share can write it.
#[test]
fn tiles_are_neither_listed_nor_baked_by_name_nor_joined_without_their_files() {
    let world = city();
    world.write("levels.json", listed(&world, &[]).to_string());
    for (command, option) in [
        (&["bake", "plans", "--format", "tiles", "--list-levels"][..], "--list-levels"),
        (&["tiles", "plans", "--list-levels"], "--list-levels"),
        (&["tiles", "plans", "--shard", "1/2", "--only-levels", "levels.json"], "--only-levels"),
    ] {
        let ran = world.run(command);
        assert_eq!(ran.code, Some(2), "{command:?}");
        let is_explained = ran.stderr.contains(&format!("{option}: does not go with the format tiles"))
            && ran.stderr.contains("roomwright tiles OUT");
        assert!(is_explained, "{}", ran.stderr);
    }
    assert!(!world.path("tiles").exists() && !world.path("out").exists());

    world.must(&["tiles", "plans", "--out", "parts/1", "--shard", "1/2"]);
    world.must(&["tiles", "plans", "--out", "parts/2", "--shard", "2/2"]);
    let ran = world.run(&["merge", "--records", "parts"]);
    assert_eq!(ran.code, Some(2), "{}", ran.stdout);
    assert!(ran.stderr.contains("whose tileset.json is made of all levels"), "{}", ran.stderr);
    assert!(!world.path("parts/manifest.json").exists());
}

#[test]
fn a_merge_says_that_the_tileset_is_missing_and_the_next_run_writes_it() {
    let world = city();
    world.must(&["tiles", "plans", "--out", "whole-tiles"]);
    world.must(&["tiles", "plans", "--out", "1", "--shard", "1/2"]);
    world.must(&["tiles", "plans", "--out", "2", "--shard", "2/2"]);
    for folder in ["1", "2"] {
        for (name, content) in world.contents(folder) {
            world.write(&format!("both/{name}"), content);
        }
    }
    let ran = world.run(&["merge", "both"]);
    assert_eq!(ran.code, Some(1), "{}", ran.stderr);
    assert!(ran.stderr.contains("tileset.json, and there is none"), "{}", ran.stderr);
    world.must(&["tiles", "plans", "--out", "both"]);
    assert_eq!(world.files("both"), world.files("whole-tiles"));
}
