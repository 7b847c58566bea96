//! Changes by hand are kept by later bakes.

use serde_json::{Value, json};

use super::world::{Ran, World, plan};

/// A folder with a plan of two levels, and these edits beside it.
fn world(edits: &str) -> World {
    let world = World::new();
    world.write("house.yaml", plan("house", 2));
    if !edits.is_empty() {
        world.write("house.edits.yaml", format!("version: 1\nedits:\n{edits}"));
    }
    world
}

/// The edits of the study on the first level.
fn study(objects: &str) -> String {
    format!("- level: \"1\"\n  room: study\n  objects:\n    {objects}\n")
}

fn bake(world: &World, options: &[&str]) -> Ran {
    world.run(&[&["bake", "house.yaml", "--effort", "1", "--format", "gltf"], options].concat())
}

fn level(world: &World, folder: &str, level: u32) -> Value {
    serde_json::from_slice(&world.read(&format!("{folder}/house/{level}.gltf"))).unwrap()
}

/// The node of a name.
fn node<'a>(level: &'a Value, name: &str) -> Option<&'a Value> {
    level["nodes"].as_array().unwrap().iter().find(|node| node["name"] == name)
}

fn translation(level: &Value, name: &str) -> Vec<f64> {
    let node = node(level, name).unwrap_or_else(|| panic!("there is no {name}"));
    node["translation"].as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
}

/// Changes a level as an editor would.
fn edit(world: &World, path: &str, change: impl FnOnce(&mut Vec<Value>)) {
    let mut document: Value = serde_json::from_slice(&world.read("out/house/1.gltf")).unwrap();
    change(document["nodes"].as_array_mut().unwrap());
    world.write(path, document.to_string());
}

fn set(nodes: &mut [Value], name: &str, key: &str, value: Value) {
    let node = nodes.iter_mut().find(|node| node["name"] == name).unwrap();
    node[key] = value;
}

#[test]
fn an_edited_room_is_baked_with_its_edits_and_the_others_as_before() {
    let world = world("");
    assert_eq!(bake(&world, &[]).code, Some(0));
    let plain = world.files("out");
    world.write("house.edits.yaml", format!("version: 1\nedits:\n{}", study("plant.1: {remove: true}")));
    let ran = bake(&world, &[]);
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    assert!(ran.stdout.contains("Kept 1 level"), "the other level has no edits: {}", ran.stdout);
    assert!(node(&level(&world, "out", 1), "plant.1@study").is_none());
    assert!(bake(&world, &[]).stdout.contains("Kept 2 levels"));
    bake(&world, &["--no-edits"]);
    assert_eq!(world.files("out")["house/1.gltf"], plain["house/1.gltf"]);
}

#[test]
fn a_rejected_edit_is_reported_with_its_place_and_stays() {
    let world = world(&study("desk.9: {at: [1, 1]}"));
    let before = world.read("house.edits.yaml");
    let ran = bake(&world, &[]);
    assert_eq!(ran.code, Some(1));
    assert!(
        ran.stderr.contains("house.edits.yaml:6:13: there is no desk.9 in room \"study\""),
        "{}",
        ran.stderr
    );
    assert!(ran.stdout.contains("Rejected edits: 1."), "{}", ran.stdout);
    assert_eq!(world.read("house.edits.yaml"), before);
    let manifest: Value = serde_json::from_slice(&world.read("out/manifest.json")).unwrap();
    let room =
        &manifest["levels"][0]["rooms"].as_array().unwrap().iter().find(|room| room["room"] == "study");
    assert_eq!(room.unwrap()["misfits"], json!(["there is no desk.9 in room \"study\""]));
    let again = bake(&world, &[]);
    assert_eq!(again.code, Some(1), "a level that is kept has the same edits");
}

#[test]
fn an_edit_that_fails_the_room_is_applied_and_reported() {
    // Outside of the room, where it meets nothing else, whatever the layout is.
    let world = world(&study("desk.1: {at: [4.2, -0.5]}"));
    let ran = world.run(&["bake", "house.yaml", "--effort", "1", "--format", "gltf", "--json"]);
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    let summary: Value = serde_json::from_str(&ran.stdout).unwrap();
    let misfit = &summary["misfits"][0];
    assert_eq!((&misfit["room"], &misfit["is_made"]), (&json!("study"), &json!(true)));
    assert!(misfit["fault"]["message"].as_str().unwrap().contains("out_of_room"), "{misfit}");
    let place = translation(&level(&world, "out", 1), "desk.1@study");
    assert!((place[0] - 4.2).abs() < 1e-6 && (place[2] - 0.5).abs() < 1e-6, "{place:?}");
}

#[test]
fn explain_lists_objects_that_are_edited_after_the_layout() {
    let world = world(&study("desk.1: {turn: 30}"));
    let explain = |more: &[&str]| {
        let words = ["explain", "house.yaml", "study", "--level", "1", "--effort", "1"];
        world.must(&[&words, more].concat()).stdout
    };
    assert!(explain(&[]).contains("edited after the layout, not explained: desk.1"));
    assert!(!explain(&["--no-edits"]).contains("edited"));
}

#[test]
fn check_reports_faults_of_edits_files() {
    let world = world(&study("desk.1: {att: [0, 0]}"));
    let ran = world.run(&["check", "house.yaml"]);
    assert_eq!(ran.code, Some(1));
    assert!(ran.stdout.contains("house.edits.yaml:6:14: unknown key \"att\""), "{}", ran.stdout);
}

#[test]
fn a_room_that_is_rolled_again_is_another_one_and_stays_so_when_it_is_written_down() {
    let world = world("");
    bake(&world, &[]);
    let first = [1, 2].map(|number| level(&world, "out", number));
    let ran = bake(&world, &["--reroll", "1/study", "--out", "rolled"]);
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    assert!(ran.stderr.contains("house/1/study: seed 2"), "{}", ran.stderr);
    let seed = |level: &Value, room: &str| node(level, room).unwrap()["extras"]["seed"].clone();
    let rolled = level(&world, "rolled", 1);
    assert_ne!(seed(&rolled, "room:study"), seed(&first[0], "room:study"));
    assert_eq!(seed(&rolled, "room:bed"), seed(&first[0], "room:bed"));
    assert_eq!(level(&world, "rolled", 2), first[1]);
    let ambiguous = bake(&world, &["--reroll", "study", "--out", "rolled"]);
    assert_eq!(ambiguous.code, Some(2));
    assert!(ambiguous.stderr.contains("2 rooms are called \"study\""), "{}", ambiguous.stderr);

    world.must(&["edits", "reroll", "house.yaml", "1/study"]);
    bake(&world, &["--out", "kept"]);
    assert_eq!(world.files("kept")["house/1.gltf"], world.files("rolled")["house/1.gltf"]);
    world.must(&["edits", "reroll", "house.yaml", "1/study"]);
    world.must(&["edits", "reroll", "house.yaml", "1/bed", "--to", "40"]);
    let text = String::from_utf8(world.read("house.edits.yaml")).unwrap();
    assert!(text.contains("seed: 3") && text.contains("seed: 40"), "{text}");
}

#[test]
fn locked_objects_stay_under_another_seed() {
    let world = world("");
    bake(&world, &[]);
    let before = translation(&level(&world, "out", 1), "desk.1@study");
    world.must(&["edits", "lock", "out/house/1.gltf", "study", "desk.1", "--edits", "house.edits.yaml"]);
    bake(&world, &["--seed", "2", "--no-edits", "--out", "other"]);
    bake(&world, &["--seed", "2", "--out", "locked"]);
    assert_ne!(translation(&level(&world, "other", 1), "desk.1@study"), before);
    let after = translation(&level(&world, "locked", 1), "desk.1@study");
    assert!(before.iter().zip(&after).all(|(a, b)| (a - b).abs() < 1e-4), "{before:?} {after:?}");
    let ran = world.run(&["edits", "lock", "out/house/1.gltf", "study", "desk.7"]);
    assert_eq!(ran.code, Some(2));
    assert!(ran.stderr.contains("there is no desk.7 in room \"study\", but"), "{}", ran.stderr);
}

#[test]
fn changes_in_an_editor_are_captured_and_baked_again() {
    let world = world("");
    bake(&world, &[]);
    let desk = translation(&level(&world, "out", 1), "desk.1@study");
    let moved = json!([desk[0] - 0.1, desk[1], desk[2]]);
    edit(&world, "edited/1.gltf", |nodes| {
        set(nodes, "desk.1@study", "translation", moved.clone());
        let copy = nodes.iter().find(|node| node["name"] == "plant.1@study").unwrap().clone();
        nodes.push(copy);
        let index = nodes.len() - 1;
        nodes[index]["name"] = json!("plant.1@study.001");
        nodes[index]["translation"] = json!([6.0, 0.0, -2.0]);
        let room = nodes.iter_mut().find(|node| node["name"] == "room:study").unwrap();
        room["children"].as_array_mut().unwrap().push(json!(index));
    });
    let ran =
        world.must(&["edits", "capture", "out/house/1.gltf", "edited/1.gltf", "--edits", "house.edits.yaml"]);
    // The chair and the drawers belong to the desk, but do not move with it: nobody moved them.
    assert!(ran.stdout.contains("1/study: desk.1, drawer_unit.1, office_chair.1, plant.2"), "{}", ran.stdout);
    let ran = bake(&world, &["--out", "again"]);
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    let again = level(&world, "again", 1);
    assert!((translation(&again, "desk.1@study")[0] - (desk[0] - 0.1)).abs() < 1e-4);
    assert_eq!(translation(&again, "plant.2@study"), [6.0, 0.0, -2.0]);
    let chair = |level: &Value| translation(level, "office_chair.1@study");
    let (before, after) = (chair(&level(&world, "out", 1)), chair(&again));
    assert!(before.iter().zip(&after).all(|(a, b)| (a - b).abs() < 2e-4), "{before:?} {after:?}");
    // Nothing is left to capture.
    let ran = world.must(&[
        "edits",
        "capture",
        "again/house/1.gltf",
        "again/house/1.gltf",
        "--edits",
        "house.edits.yaml",
    ]);
    assert_eq!(ran.stdout, "Nothing was changed.\n");
}

/// Runs the command with a folder of the world for what is kept between runs.
fn must_with_notes(world: &World, arguments: &[&str]) -> String {
    let output = world.command(arguments).env("ROOMWRIGHT_CACHE", world.path("notes")).output().unwrap();
    let said = String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned();
    assert!(output.status.success(), "{arguments:?}: {said}");
    said
}

#[test]
fn captured_edits_go_beside_the_plan_or_project_that_was_baked() {
    let world = World::new();
    world.write("plans/house.yaml", plan("house", 1));
    world.write(
        "sites/row.yaml",
        "version: 1\nproject:\n  plans: [{plan: ../plans/house.yaml, id: \"row-{n}\", count: 2}]\n",
    );
    let rolled = |input: &str, seed: &str, out: &str| {
        must_with_notes(&world, &["bake", input, "--effort", "1", "--seed", seed, "--out", out, "--no-edits"])
    };
    rolled("plans", "1", "out");
    rolled("plans", "2", "other");
    let said = must_with_notes(&world, &["edits", "capture", "out/house/1.glb", "other/house/1.glb"]);
    assert!(said.contains("Written to plans/house.edits.yaml"), "{said}");
    assert!(world.must(&["check", "plans"]).stdout.contains("0 errors, 0 warnings"));
    rolled("sites/row.yaml", "1", "row");
    let said = must_with_notes(&world, &["edits", "lock", "row/row-2/1.glb", "bed"]);
    assert!(said.contains("Written to sites/row.edits.yaml"), "{said}");
    let is_edits = |name: &String| name.ends_with(".edits.yaml");
    let written: Vec<String> = world.names(".").into_iter().filter(is_edits).collect();
    assert_eq!(written, ["plans/house.edits.yaml", "sites/row.edits.yaml"]);
}

#[test]
fn an_output_folder_is_the_same_wherever_its_plans_lie() {
    let world = World::new();
    world.write("plans/house.yaml", plan("house", 1));
    world.write("far/away/plans/house.yaml", plan("house", 1));
    for (input, out) in [("plans", "out"), ("far/away/plans", "other")] {
        must_with_notes(&world, &["bake", input, "--effort", "1", "--out", out]);
    }
    assert!(world.contents("out") == world.contents("other"));
}

#[test]
fn without_a_note_of_the_plan_the_edits_file_must_be_named() {
    let world = World::new();
    world.write("plans/house.yaml", plan("house", 1));
    must_with_notes(&world, &["bake", "plans", "--effort", "1"]);
    world.write("mail/1.glb", world.read("out/house/1.glb"));
    for (floor, cache) in
        [("mail/1.glb", "notes"), ("out/house/1.glb", "none"), ("out/house/1.glb", "nowhere")]
    {
        let ran = world.run(&["edits", "lock", floor, "bed", "--cache", cache]);
        assert_eq!(ran.code, Some(2));
        assert!(
            ran.stderr.contains("the plan of building \"house\" is not known")
                && ran.stderr.contains("--edits plans/house.edits.yaml"),
            "{}",
            ran.stderr
        );
    }
    world.must(&["edits", "lock", "mail/1.glb", "bed", "--edits", "mine.yaml"]);
}

#[test]
fn one_finding_about_two_locked_objects_is_reported_once() {
    let locks = "desk.1: {lock: true, at: [6, 2]}\n    bookshelf.1: {lock: true, at: [6, 2.1]}";
    let world = world(&study(locks));
    let ran = bake(&world, &[]);
    let collisions = ran.stderr.matches("collision of bookshelf.1 and desk.1").count();
    assert_eq!(collisions, 1, "{}", ran.stderr);
}

#[test]
fn a_rejected_edit_for_many_buildings_is_reported_once_with_their_number() {
    let world = world(&study("desk.9: {at: [1, 1]}"));
    world.write("row.yaml", "version: 1\nproject:\n  plans: [{plan: house.yaml, count: 3}]\n");
    let ran = world.run(&["bake", "row.yaml", "--effort", "1"]);
    assert_eq!(ran.code, Some(1));
    assert_eq!(ran.stderr.matches("there is no desk.9").count(), 1, "{}", ran.stderr);
    assert!(
        ran.stderr.contains("(in 3 rooms)") && ran.stdout.contains("Rejected edits: 3."),
        "{}",
        ran.stderr
    );
}

#[test]
fn draw_reports_rejected_edits() {
    let world = world(&study("desk.9: {at: [1, 1]}"));
    let ran = world.run(&["draw", "house.yaml", "--effort", "1", "--out", "house.svg"]);
    assert_eq!(ran.code, Some(1));
    assert!(ran.stderr.contains("house.edits.yaml:6:13: there is no desk.9"), "{}", ran.stderr);
    assert!(world.path("house.svg").exists());
}

#[test]
fn files_without_extras_cannot_be_captured() {
    let world = world("");
    bake(&world, &[]);
    edit(&world, "edited/1.gltf", |nodes| {
        nodes.iter_mut().for_each(|node| drop(node.as_object_mut().unwrap().remove("extras")));
    });
    let ran = world.run(&["edits", "capture", "out/house/1.gltf", "edited/1.gltf"]);
    assert_eq!(ran.code, Some(2));
    assert!(ran.stderr.contains("Custom Properties"), "{}", ran.stderr);
    assert!(!world.path("house.edits.yaml").exists());
}
