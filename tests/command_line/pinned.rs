//! Whole levels with known bytes: a house, a level of a hotel, an office around a corner.
//!
//! A change that is not meant to alter the output keeps these bytes. A change that is meant to alter it renews them:
//! `UPDATE_GOLDENS=1 cargo test --test command_line pinned`. From the first release on, it also says so in CHANGELOG.md.

use std::fs;
use std::path::{Path, PathBuf};

use super::world::World;

const PLANS: [&str; 3] =
    ["configs/plans/house.yaml", "configs/paper/hotel.yaml", "configs/paper/office_concave.yaml"];

/// Hash and path of each level, a line each.
fn pinned() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/command_line/pinned.txt")
}

#[test]
fn the_bytes_of_known_levels_are_what_they_were() {
    let world = World::new();
    let plans = PLANS.map(|plan| Path::new(env!("CARGO_MANIFEST_DIR")).join(plan));
    let mut arguments = vec!["bake"];
    arguments.extend(plans.iter().map(|plan| plan.to_str().unwrap()));
    // As a user bakes them: what is painted is in each file.
    arguments.extend(["--out", "out", "--textures", "small"]);
    world.must(&arguments);
    let levels = world.files("out").into_iter().filter(|(path, _)| path.ends_with(".glb"));
    let now: String = levels.map(|(path, hash)| format!("{hash}  {path}\n")).collect();
    if std::env::var_os("UPDATE_GOLDENS").is_some() {
        fs::write(pinned(), &now).unwrap();
        return;
    }
    let known = fs::read_to_string(pinned()).unwrap();
    assert_eq!(now, known, "output bytes differ; if they are meant to, renew with UPDATE_GOLDENS=1");
}
