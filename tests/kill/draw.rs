//! Killed drawings and demos: the next run removes their temporary files.

use std::fs;
use std::thread::sleep;
use std::time::Duration;

use chacha20::ChaCha8Rng;
use chacha20::rand_core::SeedableRng;

use super::world::{World, plan};
use super::{below, number};

/// Microseconds in which a drawing is made, or the demo unpacked and read.
const SPAN: u64 = 60_000;

/// Kills a command at several moments.
fn kill(world: &World, arguments: &[&str], draws: &mut ChaCha8Rng) {
    for _ in 0..8 {
        let mut child = world.command(arguments).env("TMPDIR", world.path("temporary")).spawn().unwrap();
        sleep(Duration::from_micros(below(draws, SPAN)));
        child.kill().unwrap();
        child.wait().unwrap();
    }
}

#[test]
fn killed_drawings_leave_whole_files_and_nothing_else() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 1));
    let draw = |out| ["draw", "a.yaml", "--level", "1", "--quiet", "--force", "--out", out];
    world.must(&draw("whole.svg"));
    let mut draws = ChaCha8Rng::seed_from_u64(number("ROOMWRIGHT_KILL_SEED", 1));
    kill(&world, &draw("a.svg"), &mut draws);
    let whole = world.read("whole.svg");
    assert!(!world.path("a.svg").exists() || world.read("a.svg") == whole);
    // As a draw leaves it that is killed while it writes.
    world.write(".roomwright-a1B2c3", "<svg");
    world.must(&draw("a.svg"));
    assert_eq!(world.read("a.svg"), whole);
    assert_eq!(world.names("."), ["a.svg", "a.yaml", "whole.svg"]);
}

#[test]
fn a_killed_demo_leaves_no_folder_for_long() {
    let world = World::new();
    fs::create_dir(world.path("temporary")).unwrap();
    let mut draws = ChaCha8Rng::seed_from_u64(number("ROOMWRIGHT_KILL_SEED", 1));
    kill(&world, &["check"], &mut draws);
    let ran = world.command(&["check"]).env("TMPDIR", world.path("temporary")).output().unwrap();
    assert!(ran.status.success());
    assert_eq!(world.names("temporary"), Vec::<String>::new());
}
