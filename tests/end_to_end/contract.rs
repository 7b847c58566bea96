//! Checks the contract of the output on the bytes of every level, through the `gltf` crate.

use std::collections::{BTreeMap, BTreeSet};

use glam::{DMat4, DVec3, Mat4};
use gltf::Gltf;
use serde_json::Value;

use roomwright::internals::audit::{Finding, Severity};
use roomwright::internals::catalog::Catalog;
use roomwright::internals::geometry::{Point, Region};

use crate::pipeline::BakedLevel;

/// Metres: the audit lets bodies stick out this far, and files hold single precision.
const OUTSIDE: f64 = 0.0065;
/// Metres: a mesh lies in its box to a millimetre.
const BOX: f64 = 0.0015;

/// A node as the file has it.
struct ReadNode<'g> {
    name: String,
    extras: Value,
    parent: Option<usize>,
    world: DMat4,
    mesh: Option<gltf::Mesh<'g>>,
}

/// Asserts everything that holds for the file of a level.
pub fn check_level(baked: &BakedLevel<'_>, catalog: &Catalog) {
    let place = format!("{}/{}", baked.building, baked.level.id);
    let file = Gltf::from_slice(&baked.glb).unwrap_or_else(|error| panic!("{place}: {error}"));
    let nodes = read_nodes(&file);
    check_names(&nodes, &place);
    assert_eq!(nodes[0].name, place);
    for (index, room) in baked.level.rooms.iter().enumerate() {
        let node = nodes.iter().position(|node| node.name == format!("room:{}", room.id));
        let node = node.unwrap_or_else(|| panic!("{place}: room {} has no node", room.id));
        check_room(baked, index, &nodes, node);
        check_furniture((baked, index), &nodes, catalog);
    }
}

/// The findings that no room may have, a line each: all that make a room fail.
pub fn grave_findings(baked: &BakedLevel<'_>) -> Vec<String> {
    let rooms = baked.level.rooms.iter().zip(&baked.verdicts);
    let lines = rooms.flat_map(|(room, verdict)| {
        let grave = verdict.findings.iter().filter(|finding| finding.severity == Severity::Failed);
        grave.map(move |finding| {
            let Finding { code, objects, measured, .. } = finding;
            let place = format!("{}/{}/{}", baked.building, baked.level.id, room.id);
            format!("{place} ({}): {} {objects:?} {measured:.4}", room.room_type, code.name())
        })
    });
    lines.collect()
}

/// Parents before children, starting with the only root.
fn read_nodes(file: &Gltf) -> Vec<ReadNode<'_>> {
    let scene = file.default_scene().expect("a file has a default scene");
    assert_eq!(scene.nodes().count(), 1, "a level is the only root");
    let mut stack: Vec<(gltf::Node<'_>, Option<usize>)> = scene.nodes().map(|node| (node, None)).collect();
    let mut nodes: Vec<ReadNode<'_>> = Vec::new();
    while let Some((node, parent)) = stack.pop() {
        let local = Mat4::from_cols_array_2d(&node.transform().matrix()).as_dmat4();
        let world = parent.map_or(local, |parent: usize| nodes[parent].world * local);
        let extras = node.extras().as_ref().expect("every node says what it is");
        let index = nodes.len();
        nodes.push(ReadNode {
            name: node.name().expect("every node has a name").to_owned(),
            extras: serde_json::from_str(extras.get()).unwrap(),
            parent,
            world,
            mesh: node.mesh(),
        });
        let children: Vec<gltf::Node<'_>> = node.children().collect();
        stack.extend(children.into_iter().rev().map(|child| (child, Some(index))));
    }
    nodes
}

fn check_names(nodes: &[ReadNode<'_>], place: &str) {
    let mut names = BTreeSet::new();
    for node in nodes {
        assert!(names.insert(&node.name), "{place}: two nodes are named {}", node.name);
    }
}

/// The room's extras against plan and layout.
fn check_room(baked: &BakedLevel<'_>, index: usize, nodes: &[ReadNode<'_>], node: usize) {
    let (room, furnished) = (&baked.level.rooms[index], &baked.furnished[index]);
    let extras = &nodes[node].extras;
    assert_eq!(extras["type"], room.room_type.as_str());
    assert_eq!(extras["placed"], furnished.placements.len());
    assert_eq!(extras["removed"].as_array().unwrap().len(), furnished.removals.len());
    assert_eq!(extras["findings"].as_array().unwrap().len(), baked.verdicts[index].findings.len());
    assert_eq!(extras["grade"], serde_json::to_value(baked.verdicts[index].grade()).unwrap());
    assert_eq!(extras["score"].as_f64(), baked.verdicts[index].score.map(|score| score.value));
    assert_eq!(extras["outline"].as_array().unwrap().len(), room.region.outline.corners().len());
    assert_eq!(nodes[node].parent, Some(0));
}

/// Every placement has its node: under what carries it, where the layout put it, filling its box, inside its room.
fn check_furniture((baked, index): (&BakedLevel<'_>, usize), nodes: &[ReadNode<'_>], catalog: &Catalog) {
    let (room, furnished) = (&baked.level.rooms[index], &baked.furnished[index]);
    let by_name: BTreeMap<&str, &ReadNode<'_>> =
        nodes.iter().map(|node| (node.name.as_str(), node)).collect();
    for placement in &furnished.placements {
        let id = format!("{}.{}", catalog.classes[placement.class].id, placement.number);
        let name = format!("{id}@{}", room.id);
        let node = by_name.get(name.as_str()).unwrap_or_else(|| panic!("{name} has no node"));
        assert_eq!(node.extras["id"], id.as_str());
        check_parent(node, nodes, (&by_name, &room.id));
        let origin = node.world.transform_point3(DVec3::ZERO);
        let expected = DVec3::new(placement.position.x, placement.elevation, -placement.position.y);
        // Single precision far from the origin: a tenth of a millimetre at a kilometre.
        assert!(origin.distance(expected) < 1e-3, "{name} stands at {origin}, not at {expected}");
        check_box(node, &name);
        check_inside(node, (&room.region, room.height), &name);
    }
    let furniture = nodes.iter().filter(|node| node.name.ends_with(&format!("@{}", room.id)));
    let count = furniture.filter(|node| node.extras["kind"] == "furniture").count();
    assert_eq!(count, furnished.placements.len(), "room {} holds nothing else", room.id);
}

/// What a node hangs below carries it: its own parent of the layout, or one of that one's; all others hang below the room,
/// and what stands on its floor does so always.
fn check_parent(
    node: &ReadNode<'_>,
    nodes: &[ReadNode<'_>],
    (by_name, room): (&BTreeMap<&str, &ReadNode<'_>>, &str),
) {
    let above = &nodes[node.parent.unwrap()];
    let elevation = node.world.transform_point3(DVec3::ZERO).y;
    if above.extras["kind"] != "furniture" {
        assert_eq!(above.name, format!("room:{room}"), "{}", node.name);
        return;
    }
    assert!(elevation > 0.01, "{} stands on the floor, but hangs below {}", node.name, above.name);
    let named = |node: &&ReadNode<'_>| {
        by_name.get(format!("{}@{room}", node.extras["parent"].as_str().unwrap()).as_str()).copied()
    };
    let mut chain = std::iter::successors(named(&node), named);
    assert!(chain.any(|parent| parent.name == above.name), "{} hangs below {}", node.name, above.name);
}

/// Corners of the mesh's bounding box in the node's frame.
fn mesh_box(node: &ReadNode<'_>) -> (DVec3, DVec3) {
    let mesh = node.mesh.as_ref().unwrap_or_else(|| panic!("{} has no mesh", node.name));
    mesh.primitives().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), primitive| {
        let bounds = primitive.bounding_box();
        let corner = |corner: [f32; 3]| DVec3::from_array(corner.map(f64::from));
        (low.min(corner(bounds.min)), high.max(corner(bounds.max)))
    })
}

fn check_box(node: &ReadNode<'_>, name: &str) {
    let size: Vec<f64> =
        node.extras["size"].as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect();
    let (low, high) = mesh_box(node);
    let (width, depth, height) = (size[0], size[1], size[2]);
    let expected =
        (DVec3::new(-width / 2.0, 0.0, -depth / 2.0), DVec3::new(width / 2.0, height, depth / 2.0));
    let off = (low - expected.0).abs().max_element().max((high - expected.1).abs().max_element());
    assert!(off < BOX, "{name}: the mesh reaches from {low} to {high}, its size is {size:?}");
}

/// The origin, and the height of the box; that whole bodies are inside is the audit's verdict.
fn check_inside(node: &ReadNode<'_>, (region, height): (&Region, f64), name: &str) {
    let (low, high) = mesh_box(node);
    let base = node.world.transform_point3(DVec3::ZERO);
    let position = Point::new(base.x, -base.z);
    assert!(region.contains(position), "{name} stands outside its room at {position}");
    assert!(base.y + low.y > -OUTSIDE && base.y + high.y < height + OUTSIDE, "{name} leaves its storey");
}
