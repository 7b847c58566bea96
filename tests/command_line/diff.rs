//! `diff` reports the differences of two bakes, each kind in a test of its own.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use super::world::{World, plan};

/// The file that is edited.
const FILE: &str = "alpha/1.gltf";

/// A bake of two rooms in `old`, and the same files in `new`.
fn two_bakes() -> World {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 1));
    world.must(&["bake", "a.yaml", "--quiet", "--out", "old", "--format", "gltf"]);
    copy(&world);
    world
}

fn copy(world: &World) {
    for (name, bytes) in world.contents("old") {
        world.write(&format!("new/{name}"), bytes);
    }
}

fn parsed(bytes: impl AsRef<[u8]>) -> Value {
    serde_json::from_slice(bytes.as_ref()).unwrap()
}

/// Changes the document of `new`, which starts as that of `old`.
fn edit(world: &World, change: impl FnOnce(&mut Value)) {
    let mut document = parsed(world.read(&format!("old/{FILE}")));
    change(&mut document);
    world.write(&format!("new/{FILE}"), document.to_string());
}

fn node<'a>(document: &'a mut Value, name: &str) -> &'a mut Value {
    let nodes = document["nodes"].as_array_mut().unwrap();
    nodes.iter_mut().find(|node| node["name"] == name).unwrap_or_else(|| panic!("no {name}"))
}

/// The name of the bed's node.
fn bed(document: &Value) -> String {
    let is_bed = |node: &&Value| node["extras"]["class"].as_str().is_some_and(|class| class.ends_with("bed"));
    document["nodes"].as_array().unwrap().iter().find(is_bed).unwrap()["name"].as_str().unwrap().to_owned()
}

/// The name of a piece in the bedroom that carries nothing and is carried by nothing.
fn lone_piece(document: &Value) -> String {
    let nodes = document["nodes"].as_array().unwrap();
    let room = nodes.iter().find(|node| node["name"] == "room:bed").unwrap();
    let children = room["children"].as_array().unwrap().iter();
    let mut children = children.map(|child| &nodes[child.as_u64().unwrap() as usize]);
    let found = children.find(|node| {
        node["extras"]["kind"] == "furniture" && node["children"].as_array().is_none_or(Vec::is_empty)
    });
    found.unwrap()["name"].as_str().unwrap().to_owned()
}

/// Kinds and how many changes are of them; findings are those of today and not what is asked here.
fn kinds(world: &World, arguments: &[&str]) -> BTreeMap<String, u64> {
    let ran = world.run(&[&["diff", "old", "new", "--json"], arguments].concat());
    assert_ne!(ran.code, Some(2), "{}", ran.stderr);
    let counts: BTreeMap<String, u64> =
        serde_json::from_value(parsed(&ran.stdout)["summary"]["changes"].clone()).unwrap();
    let is_of_today =
        |kind: &str| kind.starts_with("findings") || kind == "failed-rooms" || kind.starts_with("missing");
    counts.into_iter().filter(|(kind, _)| !is_of_today(kind)).collect()
}

fn shift(node: &mut Value, metres: f64) {
    if node["translation"].is_null() {
        node["translation"] = json!([0.0, 0.0, 0.0]);
    }
    let x = node["translation"][0].as_f64().unwrap_or(0.0);
    node["translation"][0] = (x + metres).into();
}

/// Turns a node that stands upright by degrees.
fn turn(node: &mut Value, degrees: f64) {
    let quaternion = node
        .get("rotation")
        .map_or([0.0, 1.0], |old| [old[1].as_f64().unwrap_or(0.0), old[3].as_f64().unwrap_or(1.0)]);
    let half = libm::atan2(quaternion[0], quaternion[1]) + degrees.to_radians() / 2.0;
    node["rotation"] = json!([0.0, libm::sin(half), 0.0, libm::cos(half)]);
}

type Edit = fn(&mut Value);

/// The node of the piece that each edit changes.
fn lone(document: &mut Value) -> &mut Value {
    let name = lone_piece(document);
    node(document, &name)
}

#[test]
fn each_kind_of_difference_is_found_and_no_other() {
    let world = two_bakes();
    let edits: [(&str, Edit); 12] = [
        ("moved", |file| shift(lone(file), 0.2)),
        ("turned", |file| turn(lone(file), 5.0)),
        ("resized", |file| lone(file)["scale"] = json!([1.0, 1.1, 1.0])),
        ("class", |file| lone(file)["extras"]["class"] = "umbrella_stand".into()),
        ("variant", |file| lone(file)["extras"]["variant"] = 99.into()),
        ("parent", |file| lone(file)["extras"]["parent"] = "ceiling".into()),
        ("material", |file| drop(lone(file).as_object_mut().unwrap().remove("mesh"))),
        ("style", |file| node(file, "room:bed")["extras"]["style"] = "other".into()),
        ("type", |file| node(file, "room:bed")["extras"]["type"] = "study".into()),
        ("seed", |file| node(file, "room:bed")["extras"]["seed"] = 5.into()),
        ("looks", |file| file["materials"][0]["pbrMetallicRoughness"]["roughnessFactor"] = json!(0.123)),
        ("shell", |file| shift(node(file, "floor@bed"), 0.2)),
    ];
    for (kind, change) in edits {
        edit(&world, change);
        let found = kinds(&world, &[]);
        assert_eq!(found.into_iter().collect::<Vec<_>>(), [(kind.to_owned(), 1)]);
        assert_eq!(world.run(&["diff", "old", "new", "--fail-on", kind]).code, Some(1), "{kind}");
        assert_eq!(world.run(&["diff", "old", "new", "--fail-on", "levels"]).code, Some(0), "{kind}");
    }
}

#[test]
fn tolerances_decide_what_has_moved_or_turned() {
    let world = two_bakes();
    edit(&world, |file| {
        shift(lone(file), 0.05);
        turn(lone(file), 3.0);
    });
    let found = kinds(&world, &[]);
    assert!(found.contains_key("moved") && found.contains_key("turned"), "{found:?}");
    let found = kinds(&world, &["--move-tolerance", "0.2"]);
    assert!(!found.contains_key("moved") && found.contains_key("turned"), "{found:?}");
    let found = kinds(&world, &["--move-tolerance", "0.2", "--turn-tolerance", "4"]);
    assert!(!found.contains_key("moved") && !found.contains_key("turned"), "{found:?}");
    assert_eq!(world.run(&["diff", "old", "new", "--move-tolerance", "-1"]).code, Some(2));
}

#[test]
fn files_that_differ_in_bytes_only_are_reported_so() {
    let world = two_bakes();
    assert!(world.must(&["diff", "old", "new"]).stdout.contains("1 level, no difference."));
    edit(&world, |_| ());
    let text = format!("{} ", String::from_utf8(world.read(&format!("new/{FILE}"))).unwrap());
    world.write(&format!("new/{FILE}"), text);
    let ran = world.must(&["diff", "old", "new", "--fail-on", "any"]);
    assert!(ran.stdout.contains("the bytes differ, nothing else does"), "{}", ran.stdout);
    assert_eq!(world.run(&["diff", "old", "new", "--fail-on", "bytes"]).code, Some(1));
}

#[test]
fn an_edited_file_is_judged_as_it_is_now() {
    let world = two_bakes();
    edit(&world, |file| {
        let bed = bed(file);
        node(file, &bed)["translation"] = json!([3.0, 0.0, -2.0]);
    });
    let ran = world.run(&["diff", "old", "new", "--fail-on", "failed-rooms"]);
    assert_eq!(ran.code, Some(1), "{}{}", ran.stdout, ran.stderr);
    assert!(ran.stdout.contains("! collision: failed"), "{}", ran.stdout);
    // The other way round the fault goes, and no room fails that did not.
    let ran = world.run(&["diff", "new", "old", "--fail-on", "failed-rooms,findings"]);
    assert!(ran.code == Some(0) && ran.stdout.contains("− collision"), "{}", ran.stdout);
    // Two files by themselves are judged, too.
    let ran = world.run(&["diff", "old/alpha/1.gltf", "new/alpha/1.gltf", "--fail-on", "failed-rooms"]);
    assert_eq!(ran.code, Some(1), "{}{}", ran.stdout, ran.stderr);
}

#[test]
fn levels_buildings_rooms_and_doors_are_added_and_removed() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 1));
    world.must(&["bake", "a.yaml", "--quiet", "--out", "old"]);
    let wider = plan("alpha", 2).replace("width: 1.2", "width: 1.4").replace("id: study,", "id: office,");
    world.write("b.yaml", wider.replace("rooms: [bed, study]", "rooms: [bed, office]"));
    world.write("c.yaml", plan("gamma", 1));
    world.must(&["bake", "b.yaml", "c.yaml", "--quiet", "--out", "new"]);
    let report = parsed(&world.must(&["diff", "old", "new", "--json"]).stdout);
    assert_eq!(report["buildings"], json!({"gamma": "added"}));
    assert_eq!(report["summary"]["levels"]["added"], 2);
    let rooms: Vec<(&str, &str)> = report["levels"][0]["rooms"]
        .as_array()
        .unwrap()
        .iter()
        .map(|room| (room["room"].as_str().unwrap(), room["state"].as_str().unwrap()))
        .collect();
    assert!(rooms.contains(&("office", "added")) && rooms.contains(&("study", "removed")), "{rooms:?}");
    let openings = report["levels"][0]["changes"].as_array().unwrap();
    assert!(openings.iter().any(|change| change["kind"] == "openings"), "{openings:?}");
    assert_eq!(world.run(&["diff", "old", "new", "--fail-on", "rooms"]).code, Some(1));
    let text = world.must(&["diff", "new", "old"]).stdout;
    assert!(text.contains("− building gamma") && text.contains("− gamma / 1: level with 2 rooms"), "{text}");
}

#[test]
fn reports_obey_the_schema_and_repeat() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 2));
    world.must(&["bake", "a.yaml", "--quiet", "--out", "old"]);
    world.must(&["bake", "a.yaml", "--quiet", "--out", "new", "--seed", "2"]);
    let first = world.must(&["diff", "old", "new", "--json"]).stdout;
    assert_eq!(first, world.must(&["diff", "old", "new", "--json"]).stdout);
    let schema = parsed(include_str!("../../configs/schema/diff.schema.json"));
    let validator = jsonschema::validator_for(&schema).unwrap();
    let report = parsed(&first);
    let errors: Vec<String> = validator.iter_errors(&report).map(|error| error.to_string()).collect();
    assert!(errors.is_empty() && report["diff"] == 1, "{errors:?}");
    let changes = &report["summary"]["changes"];
    assert!(changes["seed"] == 4 && changes["settings"] == 2, "{changes}");
}

#[test]
fn the_page_and_the_pictures_need_no_other_file() {
    let world = two_bakes();
    edit(&world, |file| {
        let bed = bed(file);
        shift(node(file, &bed), 0.3);
    });
    world.must(&["diff", "old", "new", "--html", "diff.html", "--svg", "pictures", "--quiet"]);
    let page = String::from_utf8(world.read("diff.html")).unwrap();
    assert_eq!(page.matches("<svg").count(), 2, "before and after");
    for address in ["http:", "https:", "src=", "url(h", "<script", "<link"] {
        let known = page.matches("http://www.w3.org/2000/svg").count();
        let expected = if address == "http:" { known } else { 0 };
        assert_eq!(page.matches(address).count(), expected, "{address}");
    }
    assert_eq!(world.names("pictures"), ["alpha/1/bed.after.svg", "alpha/1/bed.before.svg"]);
    let after = String::from_utf8(world.read("pictures/alpha/1/bed.after.svg")).unwrap();
    assert!(after.contains("#d9770a"), "the bed is marked");
    // Nothing is overwritten unless that is asked for, and nothing is compared in vain before it is refused.
    let ran = world.run(&["diff", "old", "new", "--html", "diff.html"]);
    assert!(ran.code == Some(2) && ran.stderr.contains("--force") && ran.stdout.is_empty(), "{ran:?}");
    world.must(&["diff", "old", "new", "--html", "diff.html", "--svg", "pictures", "--force"]);
}

#[test]
fn files_that_cannot_be_compared_give_exit_code_two_and_a_hint() {
    let world = two_bakes();
    world.write(&format!("new/{FILE}"), "cut");
    let ran = world.run(&["diff", "old", "new"]);
    assert!(ran.code == Some(2) && ran.stdout.contains("? alpha / 1: cannot be compared"), "{ran:?}");
    assert!(ran.stderr.contains("1.gltf"), "{}", ran.stderr);
    std::fs::remove_file(world.path("new/manifest.json")).unwrap();
    let ran = world.run(&["diff", "old", "new"]);
    assert!(ran.code == Some(2) && ran.stderr.contains("hint: `roomwright bake` writes it"), "{ran:?}");
    let ran = world.run(&["diff", "old", "new", "--fail-on", "moves"]);
    assert!(ran.code == Some(2) && ran.stderr.contains("moved"), "{ran:?}");
}
