//! Nodes as the JSON has them.

use std::collections::BTreeSet;

use gltf_json::extensions;
use serde::Serialize;

use super::light::node_light;
use super::number::ShortNumber;
use crate::contract::Extras;
use crate::scene;

/// A node of the list, which refers to the scene instead of copying it.
#[derive(Serialize)]
pub(crate) struct Node<'s> {
    #[serde(skip_serializing_if = "Vec::is_empty")]
    children: Vec<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    extensions: Option<extensions::scene::Node>,
    #[serde(skip_serializing_if = "Option::is_none")]
    extras: Option<&'s Extras>,
    #[serde(skip_serializing_if = "Option::is_none")]
    mesh: Option<usize>,
    name: &'s str,
    /// The format's own default is left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    rotation: Option<[ShortNumber; 4]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    translation: Option<[ShortNumber; 3]>,
}

/// A node and all below it, parents first.
pub(crate) fn list_nodes(root: &scene::Node) -> Vec<Node<'_>> {
    let mut nodes = Vec::new();
    add_node(&mut nodes, root);
    nodes
}

/// The nodes of a tree as JSON, parents first, without meshes, and with the lights of those whose numbers are given.
pub(crate) fn bare_nodes(root: &scene::Node, lit: &BTreeSet<usize>) -> Vec<serde_json::Value> {
    let value = |(number, node): (usize, Node<'_>)| {
        let extensions = node.extensions.filter(|_| lit.contains(&number));
        let bare = Node { mesh: None, extensions, ..node };
        serde_json::to_value(bare).expect("names are strings and numbers are finite")
    };
    list_nodes(root).into_iter().enumerate().map(value).collect()
}

fn add_node<'s>(nodes: &mut Vec<Node<'s>>, source: &'s scene::Node) -> usize {
    let index = nodes.len();
    let is_moved = source.translation != glam::Vec3::ZERO;
    let is_turned = source.rotation != glam::Quat::IDENTITY;
    nodes.push(Node {
        children: Vec::new(),
        extensions: source.light.map(node_light),
        extras: source.extras.as_ref(),
        mesh: source.mesh,
        name: &source.name,
        rotation: is_turned.then(|| source.rotation.to_array().map(ShortNumber)),
        translation: is_moved.then(|| source.translation.to_array().map(ShortNumber)),
    });
    nodes[index].children = source.children.iter().map(|child| add_node(nodes, child)).collect();
    index
}
