//! Limits of the system: lengths of files, open files, memory, closed streams, no home folder.

use super::world::{Ran, World, plan};

fn world() -> World {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 3));
    world.must(&["bake", "a.yaml", "--out", "whole"]);
    world
}

const BAKE: [&str; 3] = ["bake", "a.yaml", "--quiet"];

/// After a bake that was limited: what is in place is whole, and run again all is as it was never limited.
fn goes_on(world: &World) {
    for (name, bytes) in world.contents("out").iter().filter(|(name, _)| name.ends_with(".glb")) {
        assert!(gltf::Gltf::from_slice(bytes).is_ok(), "{name} is not whole");
    }
    world.must(&BAKE);
    assert_eq!(world.files("out"), world.files("whole"));
}

/// Run to an end of its own, by success or a fault that says what to do.
fn is_told(ran: &Ran, word: &str) {
    assert!(matches!(ran.code, Some(0..=2)), "{:?}: {}", ran.code, ran.stderr);
    let is_clear = ran.stderr.contains(word) && ran.stderr.contains("error");
    assert!(ran.code == Some(0) || is_clear, "{}", ran.stderr);
}

#[test]
fn files_that_may_not_grow_are_reported_and_leave_nothing() {
    let world = world();
    let ran = world.run_within("ulimit -f 40; exec \"$0\" \"$@\"", &BAKE);
    is_told(&ran, "ulimit -f");
    assert_ne!(ran.code, Some(0));
    let left: Vec<String> =
        world.contents("out").into_keys().filter(|name| name.contains("result-")).collect();
    assert_eq!(left, Vec::<String>::new());
    goes_on(&world);
    let draw = ["draw", "a.yaml", "--level", "1", "--out", "a.svg", "--force"];
    let ran = world.run_within("ulimit -f 8; exec \"$0\" \"$@\"", &draw);
    is_told(&ran, "a.svg");
    assert_ne!(ran.code, Some(0));
    let begun = world.names(".").into_iter().filter(|name| name.contains("roomwright-") || name == "a.svg");
    assert_eq!(begun.collect::<Vec<_>>(), Vec::<String>::new());
}

#[test]
fn few_open_files_are_enough_or_reported() {
    let world = world();
    for count in [8, 12, 20] {
        let _ = std::fs::remove_dir_all(world.path("out"));
        let ran = world.run_within(&format!("ulimit -n {count}; exec \"$0\" \"$@\""), &BAKE);
        is_told(&ran, "Too many open files");
        goes_on(&world);
    }
}

#[test]
fn little_memory_leaves_whole_files() {
    let world = world();
    for kilobytes in [60_000, 150_000, 400_000] {
        let _ = std::fs::remove_dir_all(world.path("out"));
        // Without memory a process may end anywhere, but not leave half a file.
        world.run_within(&format!("ulimit -v {kilobytes}; exec \"$0\" \"$@\" --threads 2"), &BAKE);
        goes_on(&world);
    }
}

#[test]
fn closed_standard_streams_damage_no_file() {
    let world = world();
    for closed in [">&-", "2>&-", ">&- 2>&-", "<&- >&- 2>&-"] {
        let _ = std::fs::remove_dir_all(world.path("out"));
        let ran = world.run_within(&format!("exec \"$0\" \"$@\" {closed}"), &["bake", "a.yaml"]);
        assert!(matches!(ran.code, Some(0..=2)), "{closed}: {:?}", ran.code);
        assert_eq!(world.files("out"), world.files("whole"), "{closed}");
        let draw = ["draw", "a.yaml", "--level", "1", "--out", "a.svg", "--force"];
        world.run_within(&format!("exec \"$0\" \"$@\" {closed}"), &draw);
        assert!(String::from_utf8(world.read("a.svg")).unwrap().contains("</svg>"), "{closed}");
    }
}

#[test]
fn a_missing_home_folder_stops_no_bake() {
    let world = world();
    let ran = world.run_within("exec env -i \"$0\" \"$@\"", &BAKE);
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    assert_eq!(world.files("out"), world.files("whole"));
    let _ = std::fs::remove_dir_all(world.path("out"));
    let ran =
        world.run_within("exec env -i HOME=/nonexistent/home XDG_CACHE_HOME=/proc \"$0\" \"$@\"", &BAKE);
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    assert_eq!(world.files("out"), world.files("whole"));
}
