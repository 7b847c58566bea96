//! Small files, good and bad, as text.

use std::path::Path;

use glam::DVec3;
use serde_json::{Value, json};

use super::{Inventory, ReadLevel, parse_inventory, parse_level};
use crate::catalog::{Catalog, Size};
use crate::geometry::Point;
use crate::layout::Parent;
use crate::plan::OpeningKind;

/// Two rooms of 4 × 3 m with a door between them; a desk with a lamp on it in the first, nothing in the second.
fn file() -> Value {
    let room = |id: &str, from: f64, children: Value| {
        json!({"name": format!("room:{id}"), "children": children, "extras": {
            "kind": "room", "room": id, "type": "office", "style": "default", "seed": 7,
            "outline": [[from, 0.0], [from + 4.0, 0.0], [from + 4.0, 3.0], [from, 3.0]], "holes": [],
            "height": 2.5, "requested": 3, "placed": 2,
            "removed": [{"class": "chair", "reason": "no place", "required": true}]}})
    };
    let piece = |id: &str, parent: &str, at: Value| {
        let class = id.split('.').next().unwrap();
        json!({"name": format!("{id}@a"), "translation": at, "extras": {"kind": "furniture", "class": class,
            "id": id, "parent": parent, "side": "above", "size": [1.6, 0.8, 0.74], "variant": 0}})
    };
    let mut desk = piece("desk.1", "wall.2", json!([2.0, 0.0, -2.0]));
    desk["children"] = json!([5]);
    let column = json!({"name": "column.0@b", "extras": {"kind": "part", "part": "column", "id": "column.0",
        "tags": [], "outline": [[6.0, 1.0], [6.3, 1.0], [6.3, 1.3], [6.0, 1.3]], "height": 2.5}});
    let door = json!({"name": "door:d", "translation": [4.05, 0.0, -1.5], "extras": {"kind": "opening", "id": "d",
        "opening": "door", "closure": "passage", "rooms": ["a", "b"], "width": 0.9, "height": 2.0, "sill": 0.0,
        "sides": [{"room": "a", "wall": 1, "from": 1.05, "to": 1.95}, {"room": "b", "wall": 3, "from": 1.05, "to": 1.95}]}});
    json!({"asset": {"version": "2.0"}, "nodes": [
        {"name": "house/1", "children": [1, 2, 3], "extras": {"kind": "level", "building": "house", "level": "1",
            "elevation": 0.0, "height": 3.0, "seed": 1, "generator": "test"}},
        door, room("a", 0.0, json!([4])), room("b", 4.1, json!([6])), desk,
        piece("laptop.1", "desk.1", json!([0.5, 0.74, 0.1])), column]})
}

fn catalog() -> &'static Catalog {
    crate::catalog::builtin_catalog()
}

fn parse(file: &Value) -> ReadLevel {
    parse_level(Path::new("a.gltf"), file.to_string().as_bytes(), catalog()).unwrap()
}

/// Whether each room can be judged, and the faults.
fn judged(file: &Value) -> (Vec<bool>, String) {
    let read = parse(file);
    (read.furnished.iter().map(Option::is_some).collect(), read.faults.to_string())
}

#[test]
fn rooms_walls_doors_columns_and_furniture_are_read() {
    let read = parse(&file());
    assert!(read.faults.is_empty(), "{}", read.faults);
    assert_eq!((read.building.as_str(), read.level.id.as_str()), ("house", "1"));
    let door = &read.level.openings[0];
    assert_eq!(
        (door.kind, door.sides.len(), door.center),
        (OpeningKind::Passage, 2, Point::new(4.05f32.into(), 1.5))
    );
    assert_eq!(read.level.rooms[1].openings[0].wall, 3);
    assert_eq!((read.level.rooms[1].walls.len(), read.level.rooms[1].obstacles.len()), (4, 1));
    let furnished = read.furnished[0].as_ref().unwrap();
    let [desk, lamp] = &furnished.placements[..] else { panic!("{furnished:?}") };
    assert_eq!((desk.parent, lamp.parent), (Parent::Wall(2), Parent::Object(0)));
    assert!(lamp.position.distance(Point::new(2.5, 1.9)) < 1e-6 && (lamp.elevation - 0.74).abs() < 1e-6);
    assert!(furnished.removals[0].is_required);
    assert_eq!(furnished.requested, 3);
}

#[test]
fn a_moved_object_and_its_children_are_read_at_their_new_place() {
    let mut file = file();
    // A quarter turn counter-clockwise about glTF's Y.
    let half = core::f64::consts::FRAC_1_SQRT_2;
    file["nodes"][4]["rotation"] = json!([0.0, half, 0.0, half]);
    file["nodes"][4]["scale"] = json!([2.0, 1.0, 1.0]);
    let read = parse(&file);
    let placements = &read.furnished[0].as_ref().unwrap().placements;
    assert!((placements[0].angle - core::f64::consts::FRAC_PI_2).abs() < 1e-6);
    let Size { width, depth, height } = placements[0].size;
    assert!((width - 3.2).abs() < 1e-6 && (depth - 0.8).abs() < 1e-6 && (height - 0.74).abs() < 1e-6);
    // The lamp stood half a metre to the right and a tenth to the front: now north, twice as far, and east.
    assert!(placements[1].position.distance(Point::new(2.1, 3.0)) < 1e-6, "{}", placements[1].position);
}

#[test]
fn an_unknown_style_is_named_with_a_hint_and_not_taken_for_the_default_one() {
    let mut file = file();
    let is_first = |node: &&mut Value| node["extras"]["room"] == "a" && node["extras"]["kind"] == "room";
    let room = file["nodes"].as_array_mut().unwrap().iter_mut().find(is_first).unwrap();
    room["extras"]["style"] = "defautl".into();
    let (rooms, faults) = judged(&file);
    assert_eq!(rooms, [false, true]);
    assert!(faults.contains("is of an unknown style \"defautl\""), "{faults}");
    assert!(faults.contains("hint: did you mean \"default\"?"), "{faults}");
}

#[test]
fn an_unknown_class_is_named_with_a_hint_and_the_other_room_is_read() {
    let mut file = file();
    file["nodes"][4]["extras"]["class"] = "dekc".into();
    let (rooms, faults) = judged(&file);
    assert_eq!(rooms, [false, true]);
    assert!(faults.contains("a.gltf: node \"desk.1@a\" is of an unknown class \"dekc\""), "{faults}");
    assert!(faults.contains("hint: ") && !faults.contains("laptop.1@a"), "{faults}");
}

#[test]
fn a_fault_in_a_room_keeps_only_that_room_from_being_judged() {
    let faults: [(usize, &str, Value, &str); 12] = [
        (2, "/extras/outline", json!([[0.0, 0.0], [4.0, 0.0]]), "distinct corners"),
        (2, "/extras/outline", json!("square"), "extras that cannot be read"),
        (2, "/extras/outline", json!([[0, 0], [0, 3], [4, 3], [4, 0]]), "clockwise"),
        (2, "/extras/outline", json!([[0, 0], [4000, 0], [4000, 3000], [0, 3000]]), "is 4000 m wide"),
        (2, "/extras/height", json!(-1), "no height"),
        (2, "/extras/removed", json!([{"class": "chair", "reason": "boredom"}]), "unknown reason"),
        (4, "/extras/size", json!([1.0, 0.0, 1.0]), "has the size"),
        (4, "/extras/size", json!([1.0, null, 1.0]), "extras that cannot be read"),
        (4, "/extras/side", json!("inside"), "unknown side"),
        (4, "/extras/parent", json!("wall.9"), "which is not there"),
        (4, "/rotation", json!([0.5, 0.5, 0.5, 0.5]), "upright"),
        (5, "/extras/id", json!("desk.1"), "two objects of the same id"),
    ];
    for (node, pointer, value, message) in faults {
        let mut file = file();
        file["nodes"][node]["rotation"] = json!([0.0, 0.0, 0.0, 1.0]);
        *file["nodes"][node].pointer_mut(pointer).unwrap() = value;
        let (rooms, faults) = judged(&file);
        assert!(
            rooms.first() == Some(&false) && rooms.get(1) == Some(&true) || rooms == [true],
            "{message}: {rooms:?}"
        );
        assert!(faults.contains(message), "{message}: {faults}");
    }
}

#[test]
fn a_door_that_cannot_be_read_keeps_both_its_rooms_from_being_judged() {
    let mut file = file();
    file["nodes"][1]["extras"]["sides"][0]["to"] = 9.0.into();
    let (rooms, faults) = judged(&file);
    assert_eq!(rooms, [false, false]);
    assert!(faults.contains("reaches over the ends of wall 1"), "{faults}");
}

#[test]
fn furniture_outside_all_rooms_is_reported_and_the_rest_is_read() {
    let mut file = file();
    file["nodes"][2]["children"] = json!([]);
    let (rooms, faults) = judged(&file);
    assert_eq!(rooms, [true, true]);
    assert!(faults.contains("warning: node \"desk.1@a\" belongs to no room"), "{faults}");
}

#[test]
fn loops_and_shared_children_are_rejected() {
    let mut file = file();
    file["nodes"][5]["children"] = json!([4]);
    file["nodes"][3]["children"] = json!([6, 5, 999]);
    let (_, faults) = judged(&file);
    assert!(faults.contains("has two parents"), "{faults}");
    let mut file = self::file();
    file["nodes"][5]["children"] = json!([0]);
    let message = parse_level(Path::new("a.gltf"), file.to_string().as_bytes(), catalog()).unwrap_err();
    assert!(message.to_string().contains("has no level"), "{message}");
}

#[test]
fn invalid_numbers_are_faults() {
    for matrix in [json!([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1e39, 0, 0, 1]), json!(vec![0; 16])] {
        let mut file = file();
        file["nodes"][4]["matrix"] = matrix;
        let read = parse_level(Path::new("a.gltf"), file.to_string().as_bytes(), catalog());
        assert!(read.is_err() || read.is_ok_and(|read| read.furnished[0].is_none()));
    }
}

#[test]
fn files_without_a_level_and_files_cut_off_are_refused() {
    let refused = |bytes: &[u8]| parse_level(Path::new("a.glb"), bytes, catalog()).unwrap_err().to_string();
    assert!(
        refused(br#"{"asset": {"version": "2.0"}, "nodes": [{"name": "cube"}]}"#).contains("has no level")
    );
    let text = file().to_string();
    let mut glb = b"glTF\x02\0\0\0".to_vec();
    let padded = text.len().next_multiple_of(4);
    glb.extend(u32::try_from(20 + padded).unwrap().to_le_bytes());
    glb.extend(u32::try_from(padded).unwrap().to_le_bytes());
    glb.extend(b"JSON");
    glb.extend(text.as_bytes());
    glb.resize(20 + padded, b' ');
    assert!(parse_level(Path::new("a.glb"), &glb, catalog()).is_ok());
    for length in (0..60).chain([glb.len() / 2, glb.len() - 1]) {
        assert!(!refused(&glb[..length]).is_empty());
    }
}

/// The inventory of a file.
fn inventory(file: &Value) -> (Inventory, String) {
    let (read, faults) = parse_inventory(Path::new("a.gltf"), file.to_string().as_bytes()).unwrap();
    (read, faults.to_string())
}

#[test]
fn an_inventory_needs_no_catalogue_and_has_the_places_of_objects() {
    let mut file = file();
    file["nodes"][4]["extras"]["class"] = "throne".into();
    let half = core::f64::consts::FRAC_1_SQRT_2;
    file["nodes"][4]["rotation"] = json!([0.0, half, 0.0, half]);
    let (read, faults) = inventory(&file);
    assert!(faults.is_empty(), "{faults}");
    let room = &read.rooms["a"];
    let [desk, laptop] = &room.objects[..] else { panic!("{room:?}") };
    assert_eq!(
        (desk.class.as_str(), &*desk.parent.to_string(), &*laptop.parent.to_string()),
        ("throne", "wall.2", "desk.1")
    );
    // A quarter turn counter-clockwise from above: east becomes north.
    let east = desk.rotation * DVec3::X;
    assert!(east.distance(DVec3::Y) < 1e-6, "{east}");
    // Half a metre to the desk's right and a tenth to its front, 0.74 m up.
    assert!(laptop.position.distance(DVec3::new(2.1, 2.5, 0.74)) < 1e-6, "{}", laptop.position);
    assert_eq!(room.missing, [("chair".to_owned(), "no place".to_owned())]);
    // An outline, and in the other room a column.
    assert_eq!((room.rings.len(), read.rooms["b"].rings.len()), (1, 2));
    assert_eq!(read.openings[0].id.to_string(), "door:d");
}

#[test]
fn a_child_node_belongs_to_its_parent_node_whatever_its_extras_say() {
    let mut file = file();
    file["nodes"][5]["extras"]["parent"] = "floor".into();
    assert_eq!(inventory(&file).0.rooms["a"].objects[1].parent.to_string(), "desk.1");
}

#[test]
fn a_broken_piece_or_room_is_named_and_left_out() {
    for node in [2, 5] {
        let mut file = file();
        file["nodes"][node]["extras"]["style"] = json!([]);
        file["nodes"][node]["extras"]["variant"] = json!("red");
        let (read, faults) = inventory(&file);
        assert!(read.rooms.keys().eq(["b"]) && read.broken_rooms.contains("a"), "{read:?}");
        assert!(faults.contains("extras that cannot be read"), "{faults}");
    }
}

#[test]
fn seeds_may_be_text_as_blender_writes_them() {
    let mut file = file();
    file["nodes"][2]["extras"]["seed"] = "18446744073709551615".into();
    assert_eq!(inventory(&file).0.rooms["a"].seed, u64::MAX);
    assert_eq!(judged(&file).0, [true, true]);
    for wrong in [json!("many"), json!(-1), json!("18446744073709551616")] {
        file["nodes"][2]["extras"]["seed"] = wrong;
        assert_eq!(judged(&file).0, [true], "the room is left out");
    }
}

#[test]
fn a_model_is_its_triangles_and_bounds_not_its_corners() {
    let with = |corners: u64, indices: u64, top: f64| {
        let mut file = file();
        file["accessors"] = json!([
            {"componentType": 5126, "type": "VEC3", "count": corners, "min": [0, 0, 0], "max": [1.6, top, 0.8]},
            {"componentType": 5125, "type": "SCALAR", "count": indices}]);
        file["meshes"] = json!([{"name": "desk.0", "primitives": [
            {"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}]);
        file["materials"] = json!([{"name": "plain.wood"}]);
        file["nodes"][4]["mesh"] = 0.into();
        inventory(&file).0
    };
    let read = with(24, 36, 0.74);
    assert_eq!(read.rooms["a"].objects[0].materials, ["plain.wood"]);
    assert_eq!(read.looks.models, with(30, 36, 0.74).looks.models);
    assert_ne!(read.looks.models, with(24, 39, 0.74).looks.models);
    assert_ne!(read.looks.models, with(24, 36, 0.75).looks.models);
}
