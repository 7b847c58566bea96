//! Mistakes of beginners are answered with the fact, the place, the value and a hint.

use std::path::Path;

use super::world::{World, plan};

/// A folder with a plan of two levels in `plans/`.
fn world() -> World {
    let world = World::new();
    world.write("plans/house.yaml", plan("house", 2));
    world
}

/// Runs a command that must end with a code and say all these words, without a panic.
fn answered(world: &World, words: &[&str], code: i32, expected: &[&str]) {
    let ran = world.run(words);
    let said = format!("{}{}", ran.stdout, ran.stderr);
    assert_eq!(ran.code, Some(code), "{words:?}: {said}");
    for word in expected {
        assert!(said.contains(word), "{words:?}: no {word:?} in\n{said}");
    }
    assert!(!said.contains("panicked"), "{said}");
}

#[test]
fn invalid_numbers_on_the_command_line() {
    let world = world();
    for (words, expected) in [
        (&["bake", "plans", "--seed", "-3"][..], &["'-3'", "--seed", "a whole number from 0 on"][..]),
        (&["bake", "plans", "--seed", "many"], &["'many'", "a whole number from 0 on"]),
        (&["bake", "plans", "--effort", "0"], &["'0'", "from 1 to 1000"]),
        (&["bake", "plans", "--threads", "-1"], &["'-1'", "from 1 to 1024"]),
        (&["bake", "plans", "--door-angle", "45°"], &["'45°'", "from 0 to 180, without a unit"]),
        (&["diff", "a", "b", "--move-tolerance", "14ft"], &["'14ft'", "metres without a unit: write 4.2672"]),
        (&["diff", "a", "b", "--move-tolerance", "-1"], &["'-1'", "metres, as a number from 0 to 999999"]),
        (&["diff", "a", "b", "--turn-tolerance", "few"], &["'few'", "degrees, as a number from 0 to 999999"]),
    ] {
        answered(&world, words, 2, expected);
    }
    assert!(!world.path("out").exists());
}

#[test]
fn lengths_with_units_in_a_plan() {
    let world = World::new();
    world.write("feet.yaml", plan("a", 1).replace("[0, 0, 4, 4]", "[0, 0, 14ft, 4]"));
    answered(&world, &["check", "feet.yaml"], 1, &["feet.yaml:10:52", "\"14ft\"", "`units: ft`"]);
    let in_feet = "version: 1\nunits: ft\nlevels:\n- {id: g, height: 9, rooms: [{id: bed, type: bedroom, rectangle: [0, 0, 14, 13]}]}\n";
    world.write("whole.yaml", in_feet);
    world.must(&["bake", "whole.yaml"]);
}

#[test]
fn a_room_that_is_missing_or_not_named() {
    let world = world();
    answered(
        &world,
        &["bake", "plans", "--reroll", "nope"],
        2,
        &["--reroll: no room \"nope\"", "possible here: bed, study\n"],
    );
    answered(&world, &["explain", "plans"], 2, &["ROOM: which room?", "possible here: bed, study"]);
    answered(&world, &["explain", "plans", "1/stdy"], 2, &["did you mean \"1/study\"?"]);
}

#[test]
fn a_folder_without_plans() {
    let world = World::new();
    std::fs::create_dir(world.path("empty")).unwrap();
    let expected = ["empty: the folder is empty", "hint: ", "roomwright formats"];
    answered(&world, &["bake", "empty"], 2, &expected);
    answered(&world, &["check", "empty"], 1, &expected);
    answered(&world, &["audit", "empty"], 2, &["empty: holds no level", "roomwright bake"]);
    answered(&world, &["diff", "empty", "empty"], 2, &["empty/manifest.json", "hint: "]);
}

#[test]
fn files_that_are_no_plans() {
    let world = world();
    world.must(&["bake", "plans"]);
    world.write("notes.txt", "living room 14 by 12, kitchen\n");
    answered(&world, &["bake", "notes.txt", "--out", "new"], 2, &["notes.txt"]);
    answered(&world, &["bake", "out/house/1.glb", "--out", "new"], 2, &["out/house/1.glb", "hint: "]);
    assert!(!world.path("new").exists());
}

#[test]
fn a_damaged_floor() {
    let world = world();
    world.must(&["bake", "plans"]);
    let whole = world.read("out/house/1.glb");
    for (content, fact) in [
        (&whole[..1000], "is cut off: it has 1000 of the"),
        (&whole[..10], "is cut off within its header"),
        (&b"nonsense"[..], "is no glTF document"),
        (&[][..], "is no glTF document"),
    ] {
        world.write("damaged.glb", content);
        let expected = [format!("damaged.glb: {fact}"), "hint: ".to_owned()];
        let expected: Vec<&str> = expected.iter().map(String::as_str).collect();
        answered(&world, &["audit", "damaged.glb"], 2, &expected);
        answered(&world, &["edits", "capture", "out/house/1.glb", "damaged.glb"], 2, &expected);
        answered(&world, &["diff", "out/house/1.glb", "damaged.glb"], 2, &expected);
        assert!(!world.run(&["audit", "damaged.glb"]).stdout.contains("0 rooms"));
    }
}

#[test]
fn a_file_name_in_place_of_the_output_folder() {
    let world = world();
    answered(
        &world,
        &["bake", "plans", "--out", "house.glb"],
        2,
        &["house.glb: is the name of a file", "--out house"],
    );
    assert!(!world.path("house.glb").exists());
}

#[test]
fn a_plan_in_place_of_a_command() {
    let world = world();
    answered(&world, &["plans/house.yaml"], 2, &["unrecognized", "roomwright bake plans/house.yaml"]);
    let ran = world.run(&["baek"]);
    assert!(ran.stderr.contains("'bake'") && !ran.stderr.contains("To bake it"), "{}", ran.stderr);
}

#[test]
fn a_missing_furnished_room() {
    let world = world();
    world.must(&["bake", "plans"]);
    answered(
        &world,
        &["edits", "lock", "out/house/1.glb", "kitchen"],
        2,
        &["\"kitchen\", but in bed, study"],
    );
}

#[test]
fn files_that_are_missing_folders_or_closed() {
    let world = world();
    answered(&world, &["bake", "nowhere.yaml"], 2, &["nowhere.yaml", "there is no such file"]);
    answered(&world, &["audit", "nowhere"], 2, &["nowhere: does not exist", "hint: "]);
    answered(&world, &["edits", "capture", "a.glb", "b.glb"], 2, &["a.glb"]);
    answered(
        &world,
        &["check", "plans", "--catalog", "plans/house.yaml"],
        1,
        &["plans/house.yaml", "hint: "],
    );
    answered(&world, &["check", "plans", "--edits", "plans"], 1, &["plans"]);
    world.write("file", "");
    answered(&world, &["draw", "plans", "--out", "file"], 2, &["file", "hint: "]);
    answered(&world, &["draw", "plans", "--out", "file/a.svg"], 2, &["file", "hint: "]);
    answered(&world, &["import", "plans", "--out", "file"], 2, &["file", "hint: "]);
    assert_eq!(world.read("file"), b"");
    assert!(Path::new(&world.path("plans/house.yaml")).exists());
}

#[test]
fn words_for_rooms_and_doors_in_several_languages_are_understood() {
    let world = World::new();
    for (typed, meant) in [
        ("hallway", "corridor"),
        ("kinderzimmer", "childrens_room"),
        ("salle_de_bain", "bathroom"),
        ("dormitorio", "bedroom"),
        ("soggiorno", "living_room"),
        ("woonkamer", "living_room"),
        ("kjøkken", "kitchen"),
        ("łazienka", "bathroom"),
        ("cozinha", "kitchen"),
        ("genkan", "corridor"),
        ("open_plan_living", "living_kitchen"),
    ] {
        world.write("a.yaml", plan("alpha", 1).replace("type: study", &format!("type: {typed}")));
        let expected = [format!("unknown room type \"{typed}\""), format!("did you mean \"{meant}\"?")];
        answered(&world, &["check", "a.yaml"], 1, &expected.each_ref().map(String::as_str));
    }
    world.write("a.yaml", plan("alpha", 1).replace("kind: door", "kind: front_door"));
    answered(&world, &["check", "a.yaml"], 1, &["front_door", "did you mean \"door\"?"]);
}

#[test]
fn an_open_kitchen_is_furnished_to_live_and_to_cook_in() {
    let world = World::new();
    world.write(
        "a.yaml",
        "version: 1\nid: flat\nlevels:\n- id: \"1\"\n  height: 2.8\n  rooms:\n  - {id: main, type: living_kitchen, rectangle: [0, 0, 8, 5]}\n  openings:\n  - {kind: door, at: [7, 0]}\n  - {kind: window, at: [2, 5], width: 1.6}\n",
    );
    world.must(&["bake", "a.yaml"]);
    let manifest: serde_json::Value = serde_json::from_slice(&world.read("out/manifest.json")).unwrap();
    let classes = &manifest["levels"][0]["classes"];
    for class in ["cooker", "fridge", "sink_unit", "lounge_sofa", "dining_table", "dining_chair"] {
        assert!(classes[class].as_u64() > Some(0), "{class}: {classes}");
    }
}

#[test]
fn mistakes_in_a_first_plan_get_a_hint_that_mends_them() {
    let world = World::new();
    let good = plan("alpha", 1);
    for (from, to, expected) in [
        ("version: 1\n", "", "begin the file with `version: 1`"),
        ("version: 1\n", "version: 1\nunits: feet\n", "did you mean \"ft\"?"),
        ("version: 1\n", "version: 1\nunits: millimeters\n", "did you mean \"mm\"?"),
        ("height: 3\n", "height: 3m\n", "write 3 alone"),
    ] {
        assert!(good.contains(from), "{good}");
        world.write("a.yaml", good.replacen(from, to, 1));
        answered(&world, &["check", "a.yaml"], 1, &["a.yaml:", "hint: ", expected]);
    }
    world.write("a.yaml", "version: 1\nlevels:\n- id: g\n\theight: 3\n");
    answered(&world, &["check", "a.yaml"], 1, &["found a tab", "spaces, not tabs"]);
    world.write("a.yaml", "version: 1\nlevels:\n  ground: {rooms: []}\n");
    answered(&world, &["check", "a.yaml"], 1, &["expected a list, found a mapping", "each behind `- `"]);
}

#[test]
fn folders_and_files_in_each_others_place() {
    let world = world();
    answered(
        &world,
        &["import", "plans", "--out", "x.dxf"],
        2,
        &["x.dxf: plans are written as YAML", "--out x.yaml"],
    );
    assert!(!world.path("x.dxf").exists());
    answered(
        &world,
        &["merge", "nowhere"],
        2,
        &["nowhere: cannot", "the folder that `roomwright bake --out` wrote into"],
    );
    world.write("mine/classes/a.yaml", "version: 1\nclasses:\n  tall_desk: {extends: desk}\n");
    answered(
        &world,
        &["check", "plans", "--catalog", "mine/classes"],
        0,
        &["name the folder that it lies in"],
    );
    answered(&world, &["check", "plans", "--catalog", "mine/classes/a.yaml"], 1, &["that holds classes/"]);
}
