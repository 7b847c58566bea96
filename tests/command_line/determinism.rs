//! The same input gives the same bytes.

use super::world::{World, plan};

fn two_plans(world: &World) {
    world.write("plans/a.yaml", plan("alpha", 3));
    world.write("plans/b.yaml", plan("beta", 4));
}

#[test]
fn the_output_does_not_depend_on_threads() {
    let world = World::new();
    two_plans(&world);
    world.must(&["bake", "plans", "--out", "one", "--threads", "1"]);
    let one = world.files("one");
    assert_eq!(one.keys().filter(|name| name.ends_with(".glb")).count(), 7);
    for threads in ["2", "7", "32"] {
        world.must(&["bake", "plans", "--out", threads, "--threads", threads]);
        assert_eq!(world.files(threads), one, "{threads} threads");
    }
}

#[test]
fn the_output_does_not_depend_on_the_order_of_inputs_or_the_working_folder() {
    let world = World::new();
    two_plans(&world);
    world.must(&["bake", "plans/a.yaml", "plans/b.yaml", "--out", "one"]);
    world.must(&["bake", "plans/b.yaml", "plans/a.yaml", "--out", "two"]);
    let elsewhere = World::new();
    let absolute = world.path("plans");
    elsewhere.must(&["bake", absolute.to_str().unwrap(), "--out", "three"]);
    assert_eq!(world.files("one"), world.files("two"));
    assert_eq!(world.files("one"), elsewhere.files("three"));
}

#[test]
fn another_seed_gives_other_rooms() {
    let world = World::new();
    two_plans(&world);
    world.must(&["bake", "plans/a.yaml", "--out", "one"]);
    world.must(&["bake", "plans/a.yaml", "--out", "two", "--seed", "2"]);
    assert_ne!(world.read("one/alpha/1.glb"), world.read("two/alpha/1.glb"));
}

#[test]
fn shards_joined_are_one_run() {
    let world = World::new();
    two_plans(&world);
    world.must(&["bake", "plans", "--out", "whole"]);
    for shard in ["2/3", "1/3"] {
        let ran = world.must(&["bake", "plans", "--out", "shared", "--shard", shard]);
        assert!(ran.stdout.contains("roomwright merge"), "{}", ran.stdout);
        assert!(!world.path("shared/manifest.json").exists());
    }
    world.must(&["bake", "plans", "--out", "shared", "--shard", "3/3"]);
    assert_eq!(world.files("shared"), world.files("whole"), "the last shard joins");
}

#[test]
fn shards_from_several_machines_are_merged() {
    let world = World::new();
    two_plans(&world);
    world.must(&["bake", "plans", "--out", "whole"]);
    for (folder, shard) in [("one", "1/2"), ("two", "2/2")] {
        world.must(&["bake", "plans", "--out", folder, "--shard", shard]);
    }
    for folder in ["one", "two"] {
        for (name, content) in world.contents(folder) {
            world.write(&format!("joined/{name}"), content);
        }
    }
    world.must(&["merge", "joined"]);
    assert_eq!(world.files("joined"), world.files("whole"));
    world.must(&["merge", "joined"]);
    assert_eq!(world.files("joined"), world.files("whole"), "merging twice is merging once");
}

#[test]
fn processes_side_by_side_do_not_disturb_each_other() {
    let world = World::new();
    two_plans(&world);
    world.must(&["bake", "plans", "--out", "whole"]);
    let start = || world.command(&["bake", "plans", "--out", "shared", "--quiet"]).spawn().unwrap();
    let processes: Vec<_> = (0..4).map(|_| start()).collect();
    for mut process in processes {
        assert!(process.wait().unwrap().success());
    }
    assert_eq!(world.files("shared"), world.files("whole"));
}

#[test]
fn text_format_and_shared_library_are_the_same_every_time() {
    let world = World::new();
    two_plans(&world);
    for extra in [
        &["--format", "tiles"][..],
        &["--format", "gltf"],
        &["--shared-library"],
        &["--format", "gltf", "--shared-library"],
    ] {
        for (folder, threads) in [("one", "1"), ("two", "5")] {
            let _ = std::fs::remove_dir_all(world.path(folder));
            let common = ["bake", "plans", "--out", folder, "--threads", threads];
            world.must(&[&common[..], extra].concat());
        }
        assert_eq!(world.files("one"), world.files("two"), "{extra:?}");
    }
    let names = world.names("one");
    let shared: Vec<&String> = names.iter().filter(|name| name.contains("/shared-geometry/")).collect();
    assert!(shared.len() > 5 && shared.iter().all(|name| name.ends_with(".bin")), "{names:?}");
}
