//! Unchanged levels are not baked again, and a killed run continues.

use super::world::{World, plan};

fn kept(stdout: &str) -> bool {
    stdout.contains("Baked 0 levels") && stdout.contains("Kept")
}

#[test]
fn a_second_run_keeps_everything_untouched() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 2));
    world.must(&["bake", "a.yaml"]);
    let before = world.files("out");
    let written = world.path("out/alpha/1.glb").metadata().unwrap().modified().unwrap();
    assert!(kept(&world.must(&["bake", "a.yaml"]).stdout));
    assert_eq!(world.files("out"), before);
    assert_eq!(world.path("out/alpha/1.glb").metadata().unwrap().modified().unwrap(), written);
}

#[test]
fn only_what_changed_is_baked_again() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 2));
    world.write("b.yaml", plan("beta", 2));
    world.must(&["bake", "a.yaml", "b.yaml"]);
    world.write("b.yaml", plan("beta", 2).replace("[0, 0, 4, 4]", "[0.2, 0, 3.8, 4]"));
    let ran = world.must(&["bake", "a.yaml", "b.yaml"]);
    assert!(ran.stdout.contains("Baked 2 levels") && ran.stdout.contains("Kept 2 levels"), "{}", ran.stdout);
    world.must(&["bake", "a.yaml", "b.yaml", "--out", "fresh"]);
    assert_eq!(world.files("out"), world.files("fresh"), "history leaves no trace");
}

#[test]
fn seed_style_and_configuration_are_inputs() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 1));
    world.write("more/styles/mine.yaml", "version: 1\nstyles:\n  mine: {extends: default, label: Mine}\n");
    world.must(&["bake", "a.yaml"]);
    let changed: [&[&str]; 3] =
        [&["--seed", "7"], &["--catalog", "more"], &["--catalog", "more", "--style", "mine"]];
    for extra in changed {
        let arguments = [&["bake", "a.yaml"][..], extra].concat();
        assert!(world.must(&arguments).stdout.contains("Baked 1 level,"), "{extra:?}");
        assert!(kept(&world.must(&arguments).stdout), "{extra:?}");
    }
}

#[test]
fn a_missing_or_shortened_file_is_baked_again() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 2));
    world.must(&["bake", "a.yaml"]);
    let before = world.files("out");
    std::fs::remove_file(world.path("out/alpha/2.glb")).unwrap();
    assert!(world.must(&["bake", "a.yaml"]).stdout.contains("Baked 1 level,"));
    assert_eq!(world.files("out"), before);
}

#[test]
fn another_format_replaces_our_own_files() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 1));
    world.must(&["bake", "a.yaml"]);
    world.must(&["bake", "a.yaml", "--format", "gltf"]);
    assert_eq!(world.names("out"), ["alpha/1.bin", "alpha/1.gltf", "manifest.json"]);
    world.must(&["bake", "a.yaml"]);
    assert_eq!(world.names("out"), ["alpha/1.glb", "manifest.json"]);
}

/// Waits until the bake has written more than `count` levels, then kills it; whether it was still at work.
fn kill_after(world: &World, count: usize) -> bool {
    let mut process = world.command(&["bake", "a.yaml", "--quiet"]).spawn().unwrap();
    while world.levels_written("out") <= count && process.try_wait().unwrap().is_none() {
        std::thread::yield_now();
    }
    process.kill().unwrap();
    !process.wait().unwrap().success()
}

#[test]
fn a_killed_run_continues_to_the_same_bytes() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 80));
    world.must(&["bake", "a.yaml", "--out", "whole"]);
    let whole = world.files("whole");
    let mut interrupted = 0;
    for written in [0, 1, 10, 20] {
        interrupted += usize::from(kill_after(&world, written));
        for (name, content) in world.files("out") {
            if name.ends_with(".glb") {
                assert_eq!(Some(&content), whole.get(&name), "{name} is whole");
            }
        }
    }
    assert!(interrupted > 0, "no run was interrupted: make the plan larger");
    world.must(&["bake", "a.yaml"]);
    assert_eq!(world.files("out"), whole, "no temporary file is left either");
}

#[test]
fn a_killed_run_with_another_plan_afterwards_knows_its_own_files() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 40));
    kill_after(&world, 0);
    world.write("a.yaml", plan("alpha", 40).replace("[0, 0, 4, 4]", "[0.2, 0, 3.8, 4]"));
    world.must(&["bake", "a.yaml"]);
    world.must(&["bake", "a.yaml", "--out", "fresh"]);
    assert_eq!(world.files("out"), world.files("fresh"));
}
