//! Every fault of an input is reported with place, value, hint and exit code, and leaves the output folder as it was.

use std::path::Path;

use super::world::{World, plan};

/// Bakes one bad plan; the command must refuse with these words and create nothing.
fn refused(file: &str, text: &str, words: &[&str]) {
    let world = World::new();
    world.write(file, text);
    let ran = world.run(&["bake", file]);
    assert_eq!(ran.code, Some(2), "{}{}", ran.stdout, ran.stderr);
    for word in words {
        assert!(ran.stderr.contains(word), "`{word}` is missing in:\n{}", ran.stderr);
    }
    assert!(!world.path("out").exists(), "nothing was created");
    assert_eq!(world.run(&["check", file]).code, Some(1));
}

/// Bakes a plan in which one room or opening is bad; the rest is written and the fault is reported.
fn told(text: &str, code: i32, words: &[&str]) {
    let world = World::new();
    world.write("a.yaml", text);
    let ran = world.run(&["bake", "a.yaml"]);
    for word in words {
        assert!(ran.stderr.contains(word), "`{word}` is missing in:\n{}", ran.stderr);
    }
    assert_eq!(ran.code, Some(code), "{}{}", ran.stdout, ran.stderr);
    let checked = world.run(&["check", "a.yaml"]);
    assert_eq!(checked.code, Some(i32::from(code != 0)), "{}", checked.stdout);
    assert!(words.iter().all(|word| checked.stdout.contains(word)), "{}", checked.stdout);
}

#[test]
fn an_id_that_the_name_of_a_file_gives() {
    let text = plan("a", 1).replace("id: a\n", "");
    refused("a:b.yaml", &text, &["id \"a:b\" holds the letter ':'", "rename the file or write `id:`"]);
}

#[test]
fn a_building_beyond_the_earth() {
    let project = "version: 1\nproject:\n  plans:\n    - {plan: a.yaml, position: [1e300, 0]}\n";
    refused("city.yaml", project, &["city.yaml:4:", "farther than 20,000 km", "metres east and north"]);
}

#[test]
fn an_unknown_key() {
    let text = plan("a", 1).replace("    height: 3\n", "    heigth: 3\n");
    refused("a.yaml", &text, &["a.yaml:8:5", "heigth", "did you mean \"height\"?"]);
}

#[test]
fn a_wrong_unit() {
    let text = plan("a", 1).replace("version: 1\n", "version: 1\nunits: furlongs\n");
    refused("a.yaml", &text, &["a.yaml:2:", "furlongs"]);
}

#[test]
fn truncated_json() {
    refused(
        "a.json",
        "{\"version\": 1, \"levels\": [{\"id\": \"1\", \"rooms\": [",
        &["a.json:1:", "is it complete?"],
    );
}

#[test]
fn not_a_number() {
    let text = plan("a", 1).replace("[0, 0, 4, 4]", "[0, .nan, 4, 4]");
    refused("a.yaml", &text, &["a.yaml:10:49", ".nan is not a finite number"]);
}

#[test]
fn a_missing_file() {
    let world = World::new();
    let ran = world.run(&["bake", "nowhere.yaml"]);
    assert_eq!(ran.code, Some(2));
    assert!(ran.stderr.contains("nowhere.yaml"), "{}", ran.stderr);
    assert!(!world.path("out").exists());
}

#[test]
fn a_file_of_two_gigabytes() {
    const LENGTH: u64 = 2 << 30;
    let world = World::new();
    // Sparse: it takes no room on the disk.
    std::fs::File::create(world.path("big.json")).unwrap().set_len(LENGTH).unwrap();
    let ran = world.run(&["bake", "big.json"]);
    assert_eq!(ran.code, Some(2), "{}", ran.stderr);
    assert!(ran.stderr.contains("big.json") && ran.stderr.contains("hint"), "{}", ran.stderr);
    assert!(!world.path("out").exists());
}

#[test]
fn a_self_crossing_outline() {
    let text = plan("a", 1).replace("rectangle: [0, 0, 4, 4]", "outline: [[0, 0], [4, 4], [4, 0], [0, 4]]");
    told(&text, 1, &["a.yaml:10:44", "crosses itself"]);
}

#[test]
fn a_door_wider_than_its_wall() {
    let text = plan("a", 1).replace("rooms: [bed, study]}", "rooms: [bed, study], width: 9}");
    told(&text, 1, &["a.yaml:13:", "9"]);
}

#[test]
fn a_room_without_a_door() {
    let text = plan("a", 1).replace("      - {kind: door, at: [4.05, 2], rooms: [bed, study]}\n", "");
    told(&text, 0, &["a.yaml:10:9: warning:", "room \"bed\" has no way in", "add a door"]);
}

#[test]
fn a_duplicate_id() {
    let text = plan("a", 1).replace("id: study", "id: bed").replace("[bed, study]", "[bed]");
    refused("a.yaml", &text, &["a.yaml:11:14", "room id \"bed\" is used twice"]);
}

#[test]
fn an_unknown_room_type() {
    let text = plan("a", 1).replace("type: study", "type: studdy");
    refused("a.yaml", &text, &["a.yaml:11:27", "unknown room type \"studdy\"", "did you mean \"study\"?"]);
}

#[test]
fn an_unknown_style() {
    let fault = |place: &str| format!("a.yaml:{place}: unknown style \"hottel\"");
    let hint = "hint: did you mean \"hotel\"?";
    let of_room = plan("a", 1).replace("type: study", "type: study, style: hottel");
    told(&of_room, 1, &[&fault("11:41"), hint, "in levels[0].rooms[1].style"]);
    let of_level = plan("a", 1).replace("    height: 3\n", "    height: 3\n    style: hottel\n");
    told(&of_level, 1, &[&fault("9:12"), hint]);
    let of_building = plan("a", 1).replace("version: 1\n", "version: 1\nstyle: hottel\n");
    told(&of_building, 1, &[&fault("2:8"), hint]);
    told(&plan("a", 1).replace("type: study", "type: study, style: hotel"), 0, &[]);
}

#[test]
fn an_unknown_style_of_a_project() {
    let world = World::new();
    world.write("a.yaml", plan("a", 1));
    let of_run = "version: 1\nproject:\n  style: hottel\n  plans: [{plan: a.yaml}]\n";
    world.write("project.yaml", of_run);
    let ran = world.run(&["bake", "project.yaml"]);
    assert_eq!(ran.code, Some(2), "no room would look as asked for: {}", ran.stderr);
    assert!(ran.stderr.contains("project.yaml:3:10: unknown style \"hottel\""), "{}", ran.stderr);
    assert!(ran.stderr.contains("did you mean \"hotel\"?") && !world.path("out").exists());
    world.write("project.yaml", "version: 1\nproject:\n  plans: [{plan: a.yaml, style: hottel}]\n");
    let ran = world.run(&["bake", "project.yaml"]);
    assert_eq!(ran.code, Some(1), "{}", ran.stderr);
    assert!(ran.stderr.contains("project.yaml:3:33: unknown style \"hottel\""), "{}", ran.stderr);
}

#[test]
fn a_style_on_the_command_line() {
    let world = World::new();
    world.write("a.yaml", plan("a", 1));
    let ran = world.run(&["bake", "a.yaml", "--style", "hottel"]);
    assert_eq!(ran.code, Some(2));
    assert!(ran.stderr.contains("--style: unknown style \"hottel\"") && ran.stderr.contains("\"hotel\""));
    assert!(!world.path("out").exists());
}

#[test]
fn two_buildings_of_one_id() {
    let world = World::new();
    world.write("a.yaml", plan("same", 1));
    world.write("b.yaml", plan("same", 1));
    let ran = world.run(&["bake", "a.yaml", "b.yaml"]);
    assert_eq!(ran.code, Some(1), "the first is written");
    assert!(ran.stderr.contains("b.yaml") && ran.stderr.contains("\"same\""), "{}", ran.stderr);
}

#[test]
fn one_bad_building_does_not_stop_the_others() {
    let world = World::new();
    world.write("plans/bad.yaml", "version: 1\nlevels: [{id: 1, rooms: 7}]\n");
    world.write("plans/good.yaml", plan("good", 1));
    let ran = world.run(&["bake", "plans"]);
    assert_eq!(ran.code, Some(1));
    assert!(ran.stderr.contains("bad.yaml:2:"), "{}", ran.stderr);
    assert_eq!(world.names("out"), ["good/1.glb", "manifest.json"]);
}

#[test]
fn one_bad_floor_does_not_stop_its_building() {
    let world = World::new();
    let block = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases/plan_import/block");
    for entry in std::fs::read_dir(block).unwrap() {
        let path = entry.unwrap().path();
        let text = std::fs::read_to_string(&path).unwrap();
        // The drawing of the upper floor comes first.
        let text = text.replacen("\"scale\": 1.0", "\"scale\": 0.0", 1);
        world.write(&format!("block/{}", path.file_name().unwrap().to_str().unwrap()), text);
    }
    let ran = world.run(&["bake", "block"]);
    assert_eq!(ran.code, Some(1), "{}", ran.stderr);
    assert!(ran.stderr.contains("react_planner_projects.json:8:13: scale 0 is no size"), "{}", ran.stderr);
    assert_eq!(world.names("out"), ["block/floor_0.glb", "manifest.json"]);
}

/// A faulty catalogue stops everything: no room could be trusted.
fn catalogue_refused(file: &str, text: &str, words: &[&str]) {
    let world = World::new();
    world.write("a.yaml", plan("a", 1));
    world.write(&format!("more/{file}"), text);
    let ran = world.run(&["bake", "a.yaml", "--catalog", "more"]);
    assert_eq!(ran.code, Some(2), "{}", ran.stderr);
    for word in words {
        assert!(ran.stderr.contains(word), "`{word}` is missing in:\n{}", ran.stderr);
    }
    assert!(!world.path("out").exists());
}

#[test]
fn an_unknown_class() {
    let text = "version: 1\nstyles:\n  mine:\n    extends: default\n    label: Mine\n    \
                additions: {study: [{class: dessk, count: 1}]}\n";
    catalogue_refused(
        "styles/mine.yaml",
        text,
        &["more/styles/mine.yaml:6:", "dessk", "did you mean \"desk\"?"],
    );
}

#[test]
fn cyclic_inheritance() {
    let text = "version: 1\nclasses:\n  one: {extends: two}\n  two: {extends: one}\n";
    catalogue_refused("classes/mine.yaml", text, &["more/classes/mine.yaml:3:", "one", "two"]);
}

#[test]
fn an_invalid_model_file() {
    let text = "version: 1\nclasses:\n  thing:\n    label: Thing\n    sizes: [[1, 1, 1]]\n    parents: [{on: floor}]\n    \
                model: {file: thing.glb}\n";
    catalogue_refused("classes/mine.yaml", text, &["thing.glb"]);
}

#[test]
fn a_folder_of_configuration_that_is_missing() {
    let world = World::new();
    world.write("a.yaml", plan("a", 1));
    let ran = world.run(&["bake", "a.yaml", "--catalog", "nowhere"]);
    assert_eq!(ran.code, Some(2));
    assert!(ran.stderr.contains("nowhere"), "{}", ran.stderr);
}

#[test]
fn check_reports_all_faults_of_all_files_at_once() {
    let world = World::new();
    let class = |id: &str, body: &str| format!("version: 1\nclasses:\n  {id}: {{{body}}}\n");
    world.write("mine/classes/wrong_key.yaml", class("tall_desk", "extends: desk, colour: red"));
    world.write("mine/classes/no_base.yaml", class("low_desk", "extends: dsek"));
    world.write("mine/classes/child.yaml", class("taller_desk", "extends: tall_desk"));
    world.write(
        "mine/rooms/den.yaml",
        "version: 1\nroom_types:\n  den:\n    extends: study\n    programme:\n    - {class: dragon}\n    - {class: tall_desk}\n",
    );
    world.write("plans/alpha.yaml", plan("alpha", 1).replace("type: study", "type: stduy"));
    world.write("plans/beta.yaml", plan("beta", 1).replace("    height: 3\n", "    heigth: 3\n"));
    let ran = world.run(&["check", "plans", "--catalog", "mine"]);
    assert_eq!(ran.code, Some(1));
    for (file, fault) in [
        ("mine/classes/wrong_key.yaml", "unknown key \"colour\""),
        ("mine/classes/no_base.yaml", "unknown class \"dsek\""),
        ("mine/rooms/den.yaml", "\"dragon\""),
        ("plans/alpha.yaml", "unknown room type \"stduy\""),
        ("plans/beta.yaml", "\"heigth\""),
    ] {
        let is_told = ran.stdout.lines().any(|line| line.starts_with(file) && line.contains(fault));
        assert!(is_told, "{file} {fault} is missing in:\n{}", ran.stdout);
    }
    assert!(!ran.stdout.contains("tall_desk\""), "what a faulty file defines is known:\n{}", ran.stdout);
    assert!(ran.stdout.contains(" 5 errors, 0 warnings"), "{}", ran.stdout);
}

/// A plan of one room, a door on its wall, and openings besides.
fn one_room(room: &str, height: f64, openings: &str) -> String {
    format!(
        "version: 1\nid: odd\nlevels:\n- id: \"1\"\n  height: {}\n  rooms:\n  - {{{room}, height: {height}}}\n  openings:\n  \
         - {{kind: door, id: front, at: [2, 0]}}\n{openings}",
        height + 0.3
    )
}

#[test]
fn implausible_rooms_are_warned_of_and_baked() {
    let world = World::new();
    for (room, height, question) in [
        ("id: a, type: bedroom, rectangle: [0, 0, 4, 4]", 9.0, "a bedroom that is 9.0 m high"),
        ("id: a, type: bathroom, rectangle: [0, 0, 14, 12]", 2.6, "a bathroom of 168.0 m²"),
        ("id: a, type: childrens_room, rectangle: [0, 0, 14, 12]", 2.6, "a childrens_room of 168.0 m²"),
        ("id: a, type: office, rectangle: [0, 0, 300, 300]", 3.0, "an office of 90000.0 m²"),
    ] {
        world.write("odd.yaml", one_room(room, height, ""));
        let ran = world.must(&["check", "odd.yaml"]);
        assert!(ran.stdout.contains(&format!("odd/1/a: warning: {question}")), "{}", ran.stdout);
        assert!(
            ran.stdout.contains("0 errors, 1 warning") && ran.stdout.contains("hint: "),
            "{}",
            ran.stdout
        );
    }
    world.write("odd.yaml", one_room("id: a, type: bedroom, rectangle: [0, 0, 4, 4]", 9.0, ""));
    let ran = world.must(&["bake", "odd.yaml", "--effort", "1"]);
    assert!(ran.stderr.contains("a bedroom that is 9.0 m high"), "{}", ran.stderr);
    world.write(
        "high/rooms/own.yaml",
        "version: 1\nroom_types:\n  bedroom: {extends: bedroom, plausible: {height: [2, 10]}}\n",
    );
    let ran = world.must(&["check", "odd.yaml", "--catalog", "high"]);
    assert!(ran.stdout.contains("0 errors, 0 warnings"), "{}", ran.stdout);
}

#[test]
fn implausible_rooms_of_many_levels_are_warned_of_once() {
    let world = World::new();
    let text = plan("tower", 3).replace("    height: 3\n", "    height: 9\n");
    assert_ne!(text, plan("tower", 3));
    world.write("tower.yaml", text);
    let ran = world.must(&["check", "tower.yaml"]);
    let questions = ran.stdout.lines().filter(|line| line.contains("m high")).count();
    let named = ran.stdout.matches("more rooms of the building").count();
    assert!(questions > 0 && questions == named && questions < 4, "{}", ran.stdout);
}

#[test]
fn a_door_on_no_wall_is_listed_in_the_manifest_of_its_level() {
    let world = World::new();
    let room = "id: a, type: bedroom, rectangle: [0, 0, 4, 4]";
    let note = |world: &World| {
        let manifest: serde_json::Value = serde_json::from_slice(&world.read("out/manifest.json")).unwrap();
        manifest["levels"][0]["left_out"].clone()
    };
    world.write("odd.yaml", one_room(room, 2.6, ""));
    world.must(&["bake", "odd.yaml", "--effort", "1"]);
    assert!(note(&world).is_null());
    world.write("odd.yaml", one_room(room, 2.6, "  - {kind: door, id: lost, at: [30, 30]}\n"));
    let ran = world.run(&["bake", "odd.yaml", "--effort", "1"]);
    assert_eq!(ran.code, Some(1), "{}", ran.stderr);
    let noted = note(&world);
    assert_eq!(noted.as_array().map(Vec::len), Some(1), "{noted}");
    assert_eq!(noted[0], "no wall within 1 m of opening \"lost\"");
    world.write("odd.yaml", one_room(room, 2.6, ""));
    world.must(&["bake", "odd.yaml", "--effort", "1"]);
    assert!(note(&world).is_null(), "the level is no longer kept as it was");
}
