//! The files of `init` are complete and work.

use serde_json::Value;

use super::world::World;

#[test]
fn the_next_two_commands_work_as_they_are_printed() {
    let world = World::new();
    let shown = world.must(&["init", "my house"]).stdout;
    let (_, next) = shown.split_once("Next:\n").unwrap();
    assert_eq!(next.lines().count(), 2, "{shown}");
    let program = env!("CARGO_BIN_EXE_roomwright");
    for line in next.lines() {
        let line = line.trim().replacen("roomwright", &format!("'{program}'"), 1);
        let line = if line.contains(" bake ") { line + " --textures none" } else { line };
        let status = std::process::Command::new("sh")
            .args(["-c", &line])
            .current_dir(world.path("."))
            .env("ROOMWRIGHT_CACHE", "none")
            .status();
        assert!(status.unwrap().success(), "{line}");
    }
    assert!(world.path("my house/out/house/upper.glb").exists());
    assert!(world.read("my house/house.svg").starts_with(b"<svg"));
}

#[test]
fn the_first_house_has_no_faults_and_no_findings() {
    let world = World::new();
    world.must(&["init"]);
    assert!(world.must(&["check", "project.yaml"]).stdout.contains("0 errors, 0 warnings"));
    let baked = world.must(&["bake", "project.yaml", "--json"]).stdout;
    let totals = &serde_json::from_str::<Value>(&baked).unwrap()["totals"];
    assert_eq!((&totals["minor"], &totals["failed"]), (&0.into(), &0.into()), "{totals}");
    let explained = world.must(&["explain", "project.yaml", "study"]).stdout;
    assert!(explained.contains("style mine") && explained.contains("armchair.1"), "{explained}");
}

#[test]
fn existing_files_stay_as_they_are() {
    let world = World::new();
    world.write("plans/house.yaml", "mine");
    let ran = world.must(&["init"]);
    assert!(ran.stderr.contains("plans/house.yaml: is there already and stays as it is"), "{}", ran.stderr);
    assert_eq!(world.read("plans/house.yaml"), b"mine");
    let before = world.files(".");
    let report: Value = serde_json::from_str(&world.must(&["init", "--json"]).stdout).unwrap();
    assert_eq!(report["written"], serde_json::json!([]));
    assert_eq!(report["kept"].as_array().unwrap().len(), before.len());
    assert_eq!(world.files("."), before);
}

#[test]
fn a_file_in_place_of_the_folder_is_named() {
    let world = World::new();
    world.write("file", "");
    let ran = world.run(&["init", "file"]);
    assert_eq!(ran.code, Some(2));
    assert!(ran.stderr.contains("file") && !ran.stdout.contains("Next"), "{}", ran.stderr);
}
