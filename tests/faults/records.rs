//! Manifests and journals that were tampered with.

use super::world::{World, plan};

/// A world with a baked level, and files beside the output folder that no bake may touch.
fn world() -> World {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 2));
    world.must(&["bake", "a.yaml", "--out", "whole"]);
    world.must(&["bake", "a.yaml"]);
    world.write("victim", "precious");
    world
}

fn sha256(bytes: &[u8]) -> String {
    use sha2::{Digest, Sha256};
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The manifest with the first file of the first level replaced by one outside, with its right hash and length.
fn tampered(world: &World, path: &str) -> serde_json::Value {
    let mut manifest: serde_json::Value = serde_json::from_slice(&world.read("out/manifest.json")).unwrap();
    manifest["levels"][0]["files"][0] =
        serde_json::json!({"path": path, "sha256": sha256(b"precious"), "bytes": 8});
    manifest
}

#[test]
fn a_manifest_that_names_a_file_outside_deletes_nothing() {
    let world = world();
    let absolute = world.path("victim").to_str().unwrap().to_owned();
    for path in ["../victim", "alpha/../../victim", &absolute] {
        world.write("out/manifest.json", tampered(&world, path).to_string());
        let ran = world.must(&["bake", "a.yaml"]);
        assert_eq!(world.read("victim"), b"precious", "{path}");
        let words = ["manifest.json:1:", "warning", &format!("{path:?}"), "levels[0].files[0].path", "hint"];
        assert!(words.iter().all(|word| ran.stderr.contains(word)), "{}", ran.stderr);
        assert_eq!(world.files("out"), world.files("whole"));
    }
}

#[test]
fn a_journal_that_names_a_file_outside_deletes_nothing() {
    let world = world();
    let level = tampered(&world, "../victim")["levels"][0].clone();
    let shared = serde_json::json!({"path": "../victim", "sha256": sha256(b"precious"), "bytes": 8});
    let lines = [
        serde_json::json!({"program": "0"}),
        serde_json::json!({"writing": [shared]}),
        serde_json::json!({"library": shared}),
        serde_json::json!({"level": level}),
    ];
    let text: String = lines.iter().map(|line| format!("{line}\n")).collect();
    world.write("out/.roomwright/run-old/journal", text);
    let ran = world.must(&["bake", "a.yaml", "--seed", "2"]);
    assert_eq!(world.read("victim"), b"precious");
    for place in ["journal:2:1: warning", "journal:3:1: warning", "journal:4:1: warning"] {
        assert!(ran.stderr.contains(place), "{}", ran.stderr);
    }
    world.must(&["bake", "a.yaml", "--seed", "2", "--out", "fresh"]);
    assert_eq!(world.files("out"), world.files("fresh"), "the journal is gone too");
}

#[test]
fn a_record_that_claims_the_file_of_another_level_is_left_out() {
    let world = world();
    let mut manifest: serde_json::Value = serde_json::from_slice(&world.read("out/manifest.json")).unwrap();
    manifest["levels"][1]["files"] = manifest["levels"][0]["files"].clone();
    world.write("out/manifest.json", manifest.to_string());
    let ran = world.must(&["bake", "a.yaml", "--seed", "1"]);
    assert!(ran.stderr.contains("is no file of level \"2\""), "{}", ran.stderr);
    assert_eq!(world.files("out"), world.files("whole"));
}

#[test]
fn an_invalid_record_is_reported_and_its_level_baked_again() {
    let world = world();
    let mut manifest: serde_json::Value = serde_json::from_slice(&world.read("out/manifest.json")).unwrap();
    // The part that decides whether the level is up to date is whole; the rest is not.
    manifest["levels"][0]["rooms"] = serde_json::json!("many");
    world.write("out/manifest.json", manifest.to_string());
    let ran = world.must(&["bake", "a.yaml"]);
    assert!(ran.stderr.contains("is no record of a level"), "{}", ran.stderr);
    assert!(ran.stdout.contains("Baked 1 level,"), "{}", ran.stdout);
    assert_eq!(world.files("out"), world.files("whole"));
}

#[test]
fn merge_reports_and_leaves_out_invalid_records() {
    let world = world();
    world.write("out/manifest.json", tampered(&world, "../victim").to_string());
    let ran = world.run(&["merge", "out"]);
    assert_eq!(ran.code, Some(1), "a level is missing now: {}", ran.stderr);
    assert!(ran.stderr.contains("../victim") && ran.stderr.contains("hint"), "{}", ran.stderr);
    assert_eq!(world.read("victim"), b"precious");
}

#[test]
fn merge_of_a_folder_without_records_is_a_fault() {
    let world = World::new();
    world.write("empty/notes.txt", "mine");
    let ran = world.run(&["merge", "empty"]);
    assert_eq!(ran.code, Some(2), "{}", ran.stdout);
    assert!(ran.stderr.contains("error[nothing_to_join]") && ran.stderr.contains("hint"), "{}", ran.stderr);
    assert_eq!(world.files("empty").len(), 1, "nothing was created");
}

#[test]
fn diff_opens_nothing_outside_its_folders() {
    let world = world();
    world.write("out/manifest.json", tampered(&world, "../victim").to_string());
    let ran = world.run(&["diff", "out", "whole"]);
    assert_eq!(ran.code, Some(2));
    assert!(ran.stderr.contains("outside its folder") && ran.stderr.contains("../victim"), "{}", ran.stderr);
}

#[test]
fn counts_beyond_the_largest_number_are_added_without_overflow() {
    let world = world();
    let mut manifest: serde_json::Value = serde_json::from_slice(&world.read("out/manifest.json")).unwrap();
    for level in 0..2 {
        for count in ["rooms", "requested", "placed", "removed", "none", "minor", "failed"] {
            manifest["levels"][level]["totals"][count] = u64::MAX.into();
        }
        manifest["levels"][level]["totals"]["score"] =
            serde_json::json!({"rooms": u64::MAX, "sum": 1e300, "mean": 1});
    }
    world.write("out/manifest.json", manifest.to_string());
    let ran = world.must(&["merge", "out"]);
    assert!(ran.stdout.contains(&u64::MAX.to_string()), "{}", ran.stdout);
    assert_eq!(world.run(&["diff", "out", "out"]).code, Some(0));
}
