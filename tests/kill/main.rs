//! Bakes and merges that are killed at random moments: files at their final names are whole, and another run ends with
//! the same bytes as an undisturbed one, without further files.
//!
//! `ROOMWRIGHT_KILLS=n` kills more often, `ROOMWRIGHT_KILL_SEED=n` at other moments; `scripts/kill.sh` does both.
#![cfg(unix)]
// A test that cannot set up its folder fails; kills come at moments of the clock.
#![allow(clippy::unwrap_used, clippy::print_stdout, clippy::disallowed_methods)]

#[path = "../command_line/world.rs"]
#[allow(dead_code)] // of all that it offers, each test program needs a part
mod world;

mod draw;
mod in_place;
mod scene;

use std::time::Duration;

use chacha20::ChaCha8Rng;
use chacha20::rand_core::{Rng, SeedableRng};

use scene::{SCENES, Scene};

/// Kills of all scenes together, unless `ROOMWRIGHT_KILLS` says otherwise.
const KILLS: u64 = 20;

fn number(variable: &str, default: u64) -> u64 {
    std::env::var(variable).map_or(default, |text| text.parse().unwrap())
}

/// A draw below a bound.
fn below(draws: &mut ChaCha8Rng, bound: u64) -> u64 {
    (u64::from(draws.next_u32()) * bound) >> 32
}

#[test]
fn killed_bakes_leave_whole_files_and_continue_to_the_same_result() {
    let seed = number("ROOMWRIGHT_KILL_SEED", 1);
    let kills = number("ROOMWRIGHT_KILLS", KILLS);
    let mut draws = ChaCha8Rng::seed_from_u64(seed);
    let scenes: Vec<Scene> = SCENES.iter().map(Scene::new).collect();
    let (mut done, mut attempts) = (0, 0);
    while done < kills {
        for scene in &scenes {
            attempts += 1;
            println!("seed {seed}, attempt {attempts}: {}", scene.name());
            done += session(scene, &mut draws);
        }
        assert!(attempts < 20 + 4 * kills, "most bakes end before they can be killed: {done} of {attempts}");
    }
    println!("{done} kills in {attempts} folders");
}

/// Kills in one folder, once or several times, then runs to the end; answers how many processes were killed at work.
fn session(scene: &Scene, draws: &mut ChaCha8Rng) -> u64 {
    scene.prepare(below(draws, 2) == 1);
    let mut kills = 0;
    for _ in 0..=below(draws, 3) {
        let span = u64::try_from(scene.duration().as_micros()).unwrap();
        let moment = Duration::from_micros(below(draws, span));
        let signal = scene::SIGNALS[usize::try_from(below(draws, 3)).unwrap()];
        kills += scene.killed(moment, signal, below(draws, 2) == 1);
        in_place::check(&scene.out());
    }
    scene.complete();
    kills
}
