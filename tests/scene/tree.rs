//! The node tree: names, extras, places.

use std::collections::BTreeSet;
use std::fmt::Write;
use std::path::Path;

use glam::{Quat, Vec3};
use roomwright::internals::gltf::write_glb;
use roomwright::internals::layout::Parent;
use roomwright::internals::scene::Node;

use crate::fixture::*;
use crate::golden::check_golden;

/// One line per node: name, kind, translation to 0.1 mm, turn about Y in degrees.
fn summary(node: &Node, depth: usize, text: &mut String) {
    let extras = serde_json::to_value(node.extras.as_ref().unwrap()).unwrap();
    let [x, y, z] = node.translation.to_array();
    let (axis, angle) = node.rotation.to_axis_angle();
    let degrees = (angle * axis.y).to_degrees();
    let indent = "  ".repeat(depth);
    writeln!(
        text,
        "{indent}{} {} {x:.4} {y:.4} {z:.4} {:.2} {}",
        node.name,
        extras["kind"].as_str().unwrap(),
        degrees + 0.0,
        if node.mesh.is_some() { "mesh" } else { "-" }
    )
    .unwrap();
    for child in &node.children {
        summary(child, depth + 1, text);
    }
}

fn find<'n>(node: &'n Node, name: &str) -> Option<&'n Node> {
    if node.name == name { Some(node) } else { node.children.iter().find_map(|child| find(child, name)) }
}

fn check_snapshot(name: &str, text: &str) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/scene/snapshots");
    check_golden(&folder.join(name).with_extension("txt"), text);
}

#[test]
fn a_small_level_has_this_tree() {
    let scene = scene(&two_rooms(), &two_furnished(&catalog()));
    let mut text = String::new();
    summary(&scene.root, 0, &mut text);
    check_snapshot("a_small_level_has_this_tree", &text);
}

#[test]
fn a_small_level_has_these_extras() {
    let scene = scene(&two_rooms(), &two_furnished(&catalog()));
    let names = [
        "tower/1",
        "door:d2",
        "window:w1",
        "room:102",
        "wall.0@101",
        "leaf@door:d2",
        "desk.1@101",
        "lamp.1@101",
        "chair.1@102",
    ];
    let lines: Vec<String> = names
        .iter()
        .map(|name| {
            let extras = find(&scene.root, name).unwrap().extras.as_ref().unwrap();
            format!("{name} {}", serde_json::to_string(extras).unwrap())
        })
        .collect();
    check_snapshot("a_small_level_has_these_extras", &(lines.join("\n") + "\n"));
}

#[test]
fn names_are_unique_and_survive_writing() {
    let bytes = write_glb(&scene(&two_rooms(), &two_furnished(&catalog()))).unwrap();
    let read = gltf::Gltf::from_slice(&bytes).unwrap();
    let names: Vec<&str> = read.nodes().map(|node| node.name().unwrap()).collect();
    let unique: BTreeSet<&str> = names.iter().copied().collect();
    assert_eq!(unique.len(), names.len());
    assert!(
        unique.contains("leaf@door:d1") && unique.contains("desk.1@101") && unique.contains("chair.1@102")
    );
}

/// Places of all nodes in the level's frame.
fn world(node: &Node, origin: (Vec3, Quat), found: &mut Vec<(String, Vec3, Quat)>) {
    let place = (origin.0 + origin.1 * node.translation, origin.1 * node.rotation);
    found.push((node.name.clone(), place.0, place.1));
    for child in &node.children {
        world(child, place, found);
    }
}

#[test]
fn one_metre_east_and_two_north_lands_at_x_1_z_minus_2() {
    let catalog = catalog();
    let level = level(vec![room("1", &[(-5.0, -5.0), (5.0, -5.0), (5.0, 5.0), (-5.0, 5.0)])]);
    let quarter = std::f64::consts::FRAC_PI_2;
    let fronts = [Vec3::Z, Vec3::X, Vec3::NEG_Z, Vec3::NEG_X];
    for (turn, front) in fronts.into_iter().enumerate() {
        let mut chair = placement(&catalog, "chair", 1, Parent::Floor);
        chair.position = point(1.0, 2.0);
        chair.angle = turn as f64 * quarter;
        let scene = scene(&level, &[furnished(0, vec![chair])]);
        let mut places = Vec::new();
        world(&scene.root, (Vec3::ZERO, Quat::IDENTITY), &mut places);
        let (_, position, rotation) = places.iter().find(|(name, ..)| name == "chair.1@1").unwrap();
        assert_eq!(*position, Vec3::new(1.0, 0.0, -2.0));
        assert!((*rotation * Vec3::Z).distance(front) < 1e-6, "turn {turn}");
    }
}

#[test]
fn carried_objects_are_child_nodes_and_arranged_ones_are_not() {
    let catalog = catalog();
    let scene = scene(&two_rooms(), &two_furnished(&catalog));
    let desk = find(&scene.root, "desk.1@101").unwrap();
    let children: Vec<&str> = desk.children.iter().map(|child| child.name.as_str()).collect();
    assert_eq!(children, ["lamp.1@101"], "what stands on it");
    let room: Vec<&str> =
        find(&scene.root, "room:101").unwrap().children.iter().map(|node| node.name.as_str()).collect();
    assert!(room.contains(&"chair.1@101"), "it belongs to the desk, but stands on the floor: {room:?}");
    let mut places = Vec::new();
    world(&scene.root, (Vec3::ZERO, Quat::IDENTITY), &mut places);
    let (_, lamp, turn) = places.iter().find(|(name, ..)| name == "lamp.1@101").unwrap();
    assert!(lamp.distance(Vec3::new(0.3, 0.74, -2.0)) < 1e-6, "{lamp}");
    assert!(turn.angle_between(Quat::IDENTITY) < 1e-3);
}

#[test]
fn walls_and_openings_face_their_room() {
    let level = two_rooms();
    let scene = bare_scene(&level);
    let mut places = Vec::new();
    world(&scene.root, (Vec3::ZERO, Quat::IDENTITY), &mut places);
    let front = |name: &str| {
        let (_, position, rotation) = places.iter().find(|(other, ..)| other == name).unwrap();
        (*position, *rotation * Vec3::Z)
    };
    for (index, wall) in level.rooms[0].walls.iter().enumerate() {
        let (position, found) = front(&format!("wall.{index}@101"));
        let (middle, normal) = ((wall.start + wall.end) / 2.0, wall.normal());
        assert!(position.distance(Vec3::new(middle.x as f32, 0.0, -middle.y as f32)) < 1e-6);
        assert!(found.distance(Vec3::new(normal.x as f32, 0.0, -normal.y as f32)) < 1e-6);
    }
    assert!(front("door:d2").1.distance(Vec3::NEG_X) < 1e-6, "d2 faces 101, which lies west of it");
    assert!(front("window:w1").1.distance(Vec3::NEG_Z) < 1e-6, "w1 faces 102, which lies north of it");
}
