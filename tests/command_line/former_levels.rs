//! Levels that the plans no longer have are reported, not counted, and removed on request only.

use serde_json::Value;

use super::world::{World, plan};

/// A baked building of three levels whose plan has two by now.
fn world() -> World {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 3));
    world.must(&["bake", "a.yaml"]);
    world.write("a.yaml", plan("alpha", 2));
    world.must(&["bake", "a.yaml", "--out", "fresh"]);
    world
}

#[test]
fn a_level_that_the_plan_no_longer_has_is_named_with_the_flag_that_removes_it() {
    let world = world();
    for _ in 0..2 {
        let ran = world.must(&["bake", "a.yaml"]);
        assert!(ran.stderr.contains("alpha/3") && ran.stderr.contains("--prune"), "{}", ran.stderr);
        assert!(world.path("out/alpha/3.glb").exists());
    }
    let report: Value = serde_json::from_str(&world.must(&["bake", "a.yaml", "--json"]).stdout).unwrap();
    assert_eq!(report["leftovers"]["levels"], serde_json::json!([{"building": "alpha", "level": "3"}]));
    assert_eq!(report["totals"]["rooms"], 4);
    let manifest: Value = serde_json::from_slice(&world.read("out/manifest.json")).unwrap();
    assert_eq!(
        (manifest["levels"].as_array().unwrap().len(), &manifest["totals"]["rooms"]),
        (2, &Value::from(4))
    );
    assert_eq!(manifest["former_levels"][0]["level"], "3");
}

#[test]
fn prune_leaves_what_a_fresh_bake_writes() {
    let world = world();
    world.write("b.yaml", plan("beta", 1));
    world.must(&["bake", "a.yaml", "b.yaml"]);
    // A building that left the plans goes with its folder.
    let ran = world.must(&["bake", "a.yaml", "--prune"]);
    assert!(ran.stderr.contains("alpha/3.glb") && ran.stderr.contains("beta/1.glb"), "{}", ran.stderr);
    assert_eq!(world.files("out"), world.files("fresh"));
    assert!(!world.path("out/beta").exists());
    let again = world.must(&["bake", "a.yaml", "--prune"]);
    assert!(!again.stderr.contains("Removed"), "{}", again.stderr);
}

#[test]
fn prune_removes_files_that_an_earlier_bake_listed_apart() {
    let world = world();
    world.must(&["bake", "a.yaml"]);
    world.must(&["bake", "a.yaml", "--seed", "2"]);
    world.must(&["bake", "a.yaml", "--prune"]);
    assert_eq!(world.files("out"), world.files("fresh"));
}

#[test]
fn a_level_that_comes_back_is_kept() {
    let world = world();
    world.must(&["bake", "a.yaml"]);
    world.write("a.yaml", plan("alpha", 3));
    let ran = world.must(&["bake", "a.yaml"]);
    assert!(ran.stdout.contains("Kept 3 levels"), "{}", ran.stdout);
    world.must(&["bake", "a.yaml", "--out", "whole"]);
    assert_eq!(world.files("out"), world.files("whole"));
}

#[test]
fn audit_and_diff_do_not_count_levels_that_the_plan_no_longer_has() {
    let world = world();
    world.must(&["bake", "a.yaml"]);
    for folder in ["out", "out/alpha"] {
        let ran = world.run(&["audit", folder, "--json"]);
        let report: Value = serde_json::from_str(&ran.stdout).unwrap();
        assert_eq!(report["levels"].as_array().unwrap().len(), 2, "{folder}");
        assert!(ran.stderr.contains("alpha/3.glb") && ran.stderr.contains("hint"), "{}", ran.stderr);
    }
    let named = world.run(&["audit", "out/alpha/3.glb", "--json"]);
    let report: Value = serde_json::from_str(&named.stdout).unwrap();
    assert_eq!(report["levels"].as_array().unwrap().len(), 1, "a file that is named is judged");
    world.must(&["diff", "fresh", "out", "--fail-on", "any"]);
}

#[test]
fn a_changed_file_is_not_pruned() {
    let world = world();
    world.write("out/alpha/3.glb", "edited by hand");
    world.write("out/alpha/notes.txt", "mine");
    let ran = world.must(&["bake", "a.yaml", "--prune"]);
    assert!(ran.stderr.contains("alpha/3.glb") && ran.stderr.contains("changed"), "{}", ran.stderr);
    assert_eq!(world.read("out/alpha/3.glb"), b"edited by hand");
    assert_eq!(world.read("out/alpha/notes.txt"), b"mine");
    assert_eq!(
        world.read("out/manifest.json"),
        world.read("fresh/manifest.json"),
        "nothing lists it any more"
    );
}

#[test]
fn nothing_is_pruned_while_a_plan_cannot_be_read() {
    let world = world();
    world.write("b.yaml", plan("beta", 1));
    world.must(&["bake", "a.yaml", "b.yaml", "--prune"]);
    let before = world.files("out");
    world.write("b.yaml", "version: 1\nlevels: [{id: 1, rooms: 7}]\n");
    let ran = world.run(&["bake", "a.yaml", "b.yaml", "--prune"]);
    assert_eq!(ran.code, Some(1), "{}", ran.stderr);
    assert!(ran.stderr.contains("nothing is pruned"), "{}", ran.stderr);
    assert_eq!(world.files("out"), before);
}

#[test]
fn shared_files_that_no_level_uses_are_named_and_pruned() {
    let world = world();
    world.must(&["bake", "a.yaml", "--prune"]);
    world.write("out/shared-textures/old.png", "wood");
    let sha256 = &world.files("out/shared-textures")["old.png"];
    let mut manifest: Value = serde_json::from_slice(&world.read("out/manifest.json")).unwrap();
    manifest["library"] =
        serde_json::json!([{"path": "shared-textures/old.png", "sha256": sha256, "bytes": 4}]);
    world.write("out/manifest.json", manifest.to_string());
    for _ in 0..2 {
        let ran = world.must(&["bake", "a.yaml"]);
        assert!(ran.stderr.contains("1 shared file") && ran.stderr.contains("--prune"), "{}", ran.stderr);
    }
    world.must(&["bake", "a.yaml", "--prune"]);
    assert_eq!(world.files("out"), world.files("fresh"));
}
