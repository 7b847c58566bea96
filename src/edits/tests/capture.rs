//! Levels as editors leave them.

use std::path::Path;

use serde_json::{Value, json};

use crate::edits::{Captured, EditsFile, RoomEntry, capture, merge, write_edits};
use crate::read_back::{Survey, parse_survey};

/// A level with two rooms; nodes below `a` are those given, each with its children.
fn floor(furniture: Vec<Value>, loose: Vec<Value>) -> Survey {
    let room = |id: &str| {
        json!({"name": format!("room:{id}"), "extras": {"kind": "room", "room": id, "type": "office", "style": "default",
            "seed": 7, "outline": [[0, 0], [4, 0], [4, 3], [0, 3]], "holes": [], "height": 2.5, "requested": 1,
            "placed": 1, "removed": []}})
    };
    let mut nodes = vec![
        json!({"name": "house/0", "children": [1, 2], "extras": {"kind": "level", "building": "house", "level": "0",
            "elevation": 0.0, "height": 3.0}}),
        room("a"),
        room("b"),
    ];
    let below: Vec<usize> = furniture.into_iter().map(|node| append(&mut nodes, node)).collect();
    nodes[1]["children"] = json!(below);
    for node in loose {
        append(&mut nodes, node);
    }
    let nodes: Vec<Value> = nodes
        .into_iter()
        .map(|mut node| {
            if node["children"].as_array().is_some_and(Vec::is_empty) {
                node.as_object_mut().unwrap().remove("children");
            }
            node
        })
        .collect();
    let text = json!({"asset": {"version": "2.0"}, "nodes": nodes}).to_string();
    parse_survey(Path::new("floor.gltf"), text.as_bytes()).unwrap()
}

/// Appends a node and its children; the answer is its index.
fn append(nodes: &mut Vec<Value>, mut node: Value) -> usize {
    let children = node.as_object_mut().unwrap().remove("children").unwrap_or(json!([]));
    nodes.push(node);
    let index = nodes.len() - 1;
    let below: Vec<usize> =
        children.as_array().unwrap().iter().map(|child| append(nodes, child.clone())).collect();
    nodes[index]["children"] = json!(below);
    index
}

/// A piece at a place of the plan, above the floor of its parent.
fn piece(name: &str, parent: &str, [x, y, z]: [f64; 3]) -> Value {
    let id = name.split('@').next().unwrap();
    json!({"name": name, "translation": [x, z, -y], "extras": {"kind": "furniture", "id": id,
        "class": id.split('.').next().unwrap(), "parent": parent, "side": "above", "size": [0.4, 0.4, 0.5], "variant": 0}})
}

fn with(mut node: Value, key: &str, value: Value) -> Value {
    node[key] = value;
    node
}

/// A desk with a lamp on it, and two chairs.
fn desk(place: [f64; 3], children: Vec<Value>) -> Value {
    with(piece("desk.1@a", "wall.0", place), "children", json!(children))
}

fn lamp() -> Value {
    piece("desk_lamp.1@a", "desk.1", [0.3, 0.1, 0.74])
}

fn chair(number: u32, x: f64) -> Value {
    piece(&format!("chair.{number}@a"), "floor", [x, 2.0, 0.0])
}

fn before() -> Survey {
    floor(vec![desk([1.0, 0.4, 0.0], vec![lamp()]), chair(1, 1.0), chair(2, 3.0)], Vec::new())
}

fn captured(after: &Survey) -> Captured {
    let catalog = crate::catalog::builtin_catalog();
    capture(&before(), after, catalog, Path::new("edited.glb")).unwrap()
}

/// The lines about objects, without the rooms; then the notes.
fn lines(after: &Survey) -> Vec<String> {
    let Captured { entries, notes } = captured(after);
    let objects = entries.iter().flat_map(|entry| {
        let file = EditsFile { version: 1, edits: vec![entry.clone()] };
        let text = write_edits(&file);
        let lines: Vec<String> =
            text.lines().filter(|line| line.starts_with("    ")).map(|line| line.trim().to_owned()).collect();
        lines
    });
    objects.chain(notes.0.into_iter().map(|note| note.message)).collect()
}

#[test]
fn an_unchanged_level_has_no_edits() {
    assert_eq!(lines(&before()), Vec::<String>::new());
}

#[test]
fn objects_on_a_moved_object_need_no_edit_of_their_own() {
    let after = floor(vec![desk([1.5, 0.4, 0.0], vec![lamp()]), chair(1, 1.0), chair(2, 3.0)], Vec::new());
    assert_eq!(lines(&after), ["desk.1: {at: [1.5, 0.4]}"]);
}

#[test]
fn roundings_do_not_add_up_from_an_object_to_what_stands_on_it() {
    let added = piece("desk_lamp.2@a", "desk.1", [-0.29996, 0.10004, 0.74]);
    let moved = desk([1.50004, 0.40004, 0.0], vec![lamp(), added]);
    let after = floor(vec![moved, chair(1, 1.0), chair(2, 3.0)], Vec::new());
    let expected = [
        "desk.1: {at: [1.5, 0.4]}",
        // In the level it is at 1.20008, 0.50008, and the desk will be at 1.5, 0.4.
        "desk_lamp.2: {add: true, variant: 0, parent: desk.1, side: above, at: [-0.2999, 0.1001, 0.74], turn: 0.0}",
    ];
    assert_eq!(lines(&after), expected);
}

#[test]
fn children_go_with_their_parent_and_copies_come_with_the_next_number() {
    let copy = with(chair(1, 2.2), "name", json!("chair.1@a.001"));
    let after = floor(vec![copy, chair(1, 1.0), chair(2, 3.0)], Vec::new());
    assert_eq!(
        lines(&after),
        [
            "chair.3: {add: true, variant: 0, parent: floor, side: above, at: [2.2, 2.0, 0.0], turn: 0.0}",
            "desk.1: {remove: true}"
        ]
    );
}

#[test]
fn a_parent_that_was_deleted_alone_leaves_its_children_on_the_floor() {
    let after = floor(vec![chair(1, 1.0), chair(2, 3.0)], vec![lamp()]);
    assert_eq!(
        lines(&after),
        ["desk.1: {remove: true}", "desk_lamp.1: {parent: floor, at: [0.3, 0.1, 0.74], turn: 0.0}"]
    );
}

#[test]
fn turns_heights_variants_and_classes_are_seen() {
    let turned = with(chair(1, 1.0), "rotation", json!([0.0, 0.382_683_4, 0.0, 0.923_879_5]));
    let mut other = piece("chair.2@a", "floor", [3.0, 2.0, 0.1]);
    (other["extras"]["class"], other["extras"]["variant"]) = (json!("armchair"), json!(2));
    let after = floor(vec![desk([1.0, 0.4, 0.0], vec![lamp()]), turned, other], Vec::new());
    assert_eq!(
        lines(&after),
        ["chair.1: {turn: 45.0}", "chair.2: {class: armchair, variant: 2, at: [3.0, 2.0, 0.1]}"]
    );
}

#[test]
fn changes_that_no_edit_can_express_are_reported() {
    let scaled = with(chair(1, 1.0), "scale", json!([1.5, 1.0, 1.0]));
    let tilted = with(chair(2, 3.0), "rotation", json!([0.3, 0.0, 0.0, 0.953_939_2]));
    let cube = json!({"name": "Cube", "mesh": 0});
    let after = floor(vec![desk([1.0, 0.4, 0.0], vec![lamp()]), scaled, tilted, cube], Vec::new());
    let told = lines(&after);
    assert!(told[0].contains("\"chair.1@a\" is scaled to 0.6 × 0.4 × 0.5 m"), "{told:?}");
    assert!(told[1].contains("\"chair.2@a\" does not stand upright"), "{told:?}");
    assert!(told[2].contains("\"Cube\" is no furniture"), "{told:?}");
    assert_eq!(told.len(), 3);
}

#[test]
fn the_place_of_an_object_with_moved_vertices_is_reported_and_not_captured() {
    let mut before = before();
    before.objects[2].bounds = Some([[-0.2, 0.0, -0.2], [0.2, 0.5, 0.2]]);
    let mut after = before.clone();
    after.objects[2].place.as_mut().unwrap().position.x = 0.0;
    let catalog = crate::catalog::builtin_catalog();
    let told = |after: &Survey| {
        let Captured { entries, notes } = capture(&before, after, catalog, Path::new("edited.glb")).unwrap();
        (entries.len(), notes.0.len())
    };
    assert_eq!(told(&after), (1, 0));
    after.objects[2].bounds = Some([[0.8, 0.0, 1.8], [1.2, 0.5, 2.2]]);
    assert_eq!(told(&after), (0, 1));
}

#[test]
fn an_object_moved_to_another_room_is_removed_and_added() {
    let moved = with(chair(2, 3.0), "name", json!("chair.2@a"));
    let mut after = floor(vec![desk([1.0, 0.4, 0.0], vec![lamp()]), chair(1, 1.0), moved], Vec::new());
    after.objects[3].room = Some("b".to_owned());
    let rooms: Vec<(String, Vec<String>)> = captured(&after)
        .entries
        .into_iter()
        .map(|RoomEntry { room, objects, .. }| (room, objects.into_keys().collect()))
        .collect();
    assert_eq!(
        rooms,
        [("a".to_owned(), vec!["chair.2".to_owned()]), ("b".to_owned(), vec!["chair.2".to_owned()])]
    );
}

#[test]
fn files_of_two_levels_are_not_compared() {
    let other = Survey { level: "1".to_owned(), ..before() };
    let catalog = crate::catalog::builtin_catalog();
    let fault = capture(&before(), &other, catalog, Path::new("edited.glb")).unwrap_err();
    assert!(fault.message.contains("is house/1, but the level before is house/0"), "{fault}");
}

/// Merges lines about objects of one room into others.
fn merged(known: &[&str], new: &[&str]) -> Vec<String> {
    let entry = |lines: &[&str]| RoomEntry {
        level: "0".to_owned(),
        room: "a".to_owned(),
        objects: super::edits(lines).objects.into_iter().map(|(id, edit)| (id, edit.entry)).collect(),
        ..RoomEntry::default()
    };
    let file = merge(Some(EditsFile { version: 1, edits: vec![entry(known)] }), vec![entry(new)]);
    write_edits(&file)
        .lines()
        .filter(|line| line.starts_with("    "))
        .map(|line| line.trim().to_owned())
        .collect()
}

#[test]
fn new_edits_are_added_to_what_a_file_says() {
    let moved = "chair.1: {at: [1.0, 2.0]}";
    assert_eq!(merged(&[moved], &["chair.1: {turn: 90}"]), ["chair.1: {at: [1.0, 2.0], turn: 90.0}"]);
    assert_eq!(merged(&[moved], &["chair.1: {remove: true}"]), ["chair.1: {remove: true}"]);
    let added = "chair.9: {add: true, at: [1.0, 2.0]}";
    assert_eq!(merged(&[added], &["chair.9: {at: [2.0, 2.0]}"]), ["chair.9: {add: true, at: [2.0, 2.0]}"]);
    assert_eq!(merged(&[added], &["chair.9: {remove: true}"]), Vec::<String>::new(), "it was never there");
}
