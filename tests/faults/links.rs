//! Symbolic links in the output folder, and to it, are not followed to other files.

use std::fs;
use std::os::unix::fs::symlink;

use super::world::{World, plan};

fn world() -> World {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 2));
    world.write("documents/thesis.txt", "years of work");
    world.write("documents/journal", "dear diary");
    world.write("documents/result-abc123", "of an experiment");
    world
}

/// Bakes while a link is in the way; nothing at its end changes.
fn baked(world: &World, code: i32) -> String {
    let before = world.files("documents");
    let ran = world.run_bounded(&["bake", "a.yaml", "--seed", "2"]);
    assert_eq!(ran.code, Some(code), "{}{}", ran.stdout, ran.stderr);
    assert_eq!(world.files("documents"), before);
    ran.stderr
}

#[test]
fn a_link_in_place_of_a_run_is_left_alone() {
    let world = world();
    world.must(&["bake", "a.yaml"]);
    fs::create_dir_all(world.path("out/.roomwright")).unwrap();
    symlink("../../documents", world.path("out/.roomwright/run-x")).unwrap();
    baked(&world, 0);
    assert!(world.path("out/.roomwright/run-x").is_symlink());
}

#[test]
fn a_link_in_place_of_the_records_is_refused() {
    let world = world();
    fs::create_dir_all(world.path("out")).unwrap();
    symlink("../documents", world.path("out/.roomwright")).unwrap();
    let stderr = baked(&world, 2);
    assert!(
        stderr.contains(".roomwright") && stderr.contains("is a link") && stderr.contains("hint"),
        "{stderr}"
    );
    let ran = world.run(&["merge", "out"]);
    assert_eq!(ran.code, Some(2), "{}", ran.stderr);
}

#[test]
fn foreign_files_in_a_run_folder_stay() {
    let world = world();
    world.write("out/.roomwright/run-old/journal", "{\"program\":\"0\"}\n");
    world.write("out/.roomwright/run-old/result-aB3dE6", "half a floor");
    world.write("out/.roomwright/run-old/thesis.txt", "years of work");
    world.write("out/.roomwright/joining-notes.txt", "mine");
    baked(&world, 0);
    let left = world.contents("out/.roomwright");
    let names: Vec<&str> = left.keys().map(String::as_str).collect();
    assert_eq!(names, ["joining-notes.txt", "lock", "run-old/thesis.txt"]);
}

#[test]
fn a_link_in_place_of_a_building_is_not_followed() {
    let world = world();
    fs::create_dir_all(world.path("out")).unwrap();
    symlink("../documents", world.path("out/alpha")).unwrap();
    let stderr = baked(&world, 2);
    assert!(stderr.contains("error[wrong_kind]") && stderr.contains("a link"), "{stderr}");
}

#[test]
fn a_link_in_place_of_a_file_is_neither_followed_nor_replaced() {
    let world = world();
    fs::create_dir_all(world.path("out/alpha")).unwrap();
    symlink("../../documents/thesis.txt", world.path("out/alpha/1.glb")).unwrap();
    let stderr = baked(&world, 1);
    assert!(stderr.contains("alpha/1") && stderr.contains("a link"), "{stderr}");
    assert!(world.path("out/alpha/1.glb").is_symlink());
}

#[test]
fn another_bake_behind_a_link_keeps_its_files() {
    let world = world();
    world.must(&["bake", "a.yaml", "--out", "before"]);
    world.must(&["bake", "a.yaml"]);
    let before = world.files("before");
    // The same content, so that it could be taken for a file of this folder.
    fs::remove_dir_all(world.path("out/alpha")).unwrap();
    symlink("../before/alpha", world.path("out/alpha")).unwrap();
    baked(&world, 2);
    assert_eq!(world.files("before"), before);
}

#[test]
fn the_output_folder_may_be_a_link() {
    let world = world();
    fs::create_dir_all(world.path("disk/bakes")).unwrap();
    symlink("disk/bakes", world.path("out")).unwrap();
    baked(&world, 0);
    assert_eq!(world.names("disk/bakes"), ["alpha/1.glb", "alpha/2.glb", "manifest.json"]);
}

#[test]
fn an_edits_file_behind_a_link_is_written_and_the_link_stays() {
    let world = world();
    world.must(&["bake", "a.yaml"]);
    let lock =
        |edits: &str| world.run_bounded(&["edits", "lock", "out/alpha/1.glb", "study", "--edits", edits]);
    world.write("documents/a.edits.yaml", "version: 1\nedits: []\n");
    symlink("documents/a.edits.yaml", world.path("a.edits.yaml")).unwrap();
    let ran = lock("a.edits.yaml");
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    assert!(world.path("a.edits.yaml").is_symlink());
    assert!(String::from_utf8(world.read("documents/a.edits.yaml")).unwrap().contains("lock: true"));
    symlink("nowhere", world.path("b.edits.yaml")).unwrap();
    let ran = lock("b.edits.yaml");
    assert_eq!(ran.code, Some(2), "{}", ran.stderr);
    assert!(ran.stderr.contains("leads nowhere") && ran.stderr.contains("hint"), "{}", ran.stderr);
    assert!(world.path("b.edits.yaml").is_symlink());
}

#[test]
fn a_device_named_as_output_stays_one() {
    let world = world();
    symlink("/dev/null", world.path("drawing.svg")).unwrap();
    for force in [&[][..], &["--force"]] {
        let ran = world
            .run_bounded(&[&["draw", "a.yaml", "--level", "1", "--out", "drawing.svg"][..], force].concat());
        assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    }
    assert!(world.path("drawing.svg").is_symlink() && !fs::metadata("/dev/null").unwrap().is_file());
}
