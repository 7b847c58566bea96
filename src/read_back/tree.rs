//! The nodes of a document with their extras; parents before children.

use glam::{DMat4, DQuat, DVec3};
use gltf::json::{Node as JsonNode, Root};

use super::problem::Problem;
use crate::contract::Extras;

/// A node of the file.
pub(super) struct Node {
    /// As the file names it.
    pub(super) name: String,
    /// The extras; `None` for nodes that are no part of the contract.
    pub(super) extras: Option<Extras>,
    /// Whether it has extras of the contract that cannot be read; a problem says so.
    pub(super) is_broken: bool,
    /// Index of its parent.
    pub(super) parent: Option<usize>,
    /// Its place in its parent.
    pub(super) local: DMat4,
    /// Index of its mesh in the document.
    pub(super) mesh: Option<usize>,
}

/// All nodes that hang below the roots of the document, each once.
///
/// Roots are the nodes without a parent, whatever scene they are in: a file has one level.
pub(super) fn nodes(document: &Root) -> (Vec<Node>, Vec<Problem>) {
    let count = document.nodes.len();
    let mut problems = Vec::new();
    let children = |index: usize| {
        let children = document.nodes[index].children.iter().flatten();
        children.map(gltf::json::Index::value).filter(move |&child| child < count)
    };
    let mut is_child = vec![false; count];
    (0..count).flat_map(children).for_each(|child| is_child[child] = true);
    let mut stack: Vec<(usize, Option<usize>)> =
        (0..count).rev().filter(|&index| !is_child[index]).map(|index| (index, None)).collect();
    let mut is_known = vec![false; count];
    let mut nodes: Vec<Node> = Vec::with_capacity(count);
    while let Some((index, parent)) = stack.pop() {
        if std::mem::replace(&mut is_known[index], true) {
            problems.push(Problem::new(&name(document, index), "has two parents"));
            continue;
        }
        let own = nodes.len();
        nodes.push(read_node(document, index, parent, &mut problems));
        let first = stack.len();
        stack.extend(children(index).map(|child| (child, Some(own))));
        stack[first..].reverse();
    }
    if let Some(index) = is_known.iter().position(|known| !known) {
        problems.push(Problem::new(&name(document, index), "is its own ancestor"));
    }
    (nodes, problems)
}

fn name(document: &Root, index: usize) -> String {
    document.nodes[index].name.clone().unwrap_or_else(|| format!("#{index}"))
}

fn read_node(document: &Root, index: usize, parent: Option<usize>, problems: &mut Vec<Problem>) -> Node {
    let node = &document.nodes[index];
    let name = name(document, index);
    let parsed = node.extras.as_ref().map_or(Ok(None), |text| Extras::parse(text.get()));
    let is_broken = parsed.is_err();
    let extras = parsed.unwrap_or_else(|message| {
        let problem = Problem::new(&name, format!("has extras that cannot be read: {message}"));
        problems.push(problem.with_hint("docs/output.md, \"Extras\", lists what they hold"));
        None
    });
    Node { name, extras, is_broken, parent, local: local(node), mesh: node.mesh.map(|mesh| mesh.value()) }
}

/// The node's place in its parent. A transform that is no number shows in the answer.
fn local(node: &JsonNode) -> DMat4 {
    if let Some(matrix) = node.matrix {
        return DMat4::from_cols_array(&matrix.map(f64::from));
    }
    let vector = |values: Option<[f32; 3]>, default: DVec3| {
        values.map_or(default, |values| DVec3::from_array(values.map(f64::from)))
    };
    let rotation =
        node.rotation.map_or(DQuat::IDENTITY, |rotation| DQuat::from_array(rotation.0.map(f64::from)));
    // Single precision leaves quaternions a little off unit length, which would scale what they turn.
    let rotation = if rotation.length_squared() > 0.0 { rotation.normalize() } else { rotation };
    let (scale, translation) = (vector(node.scale, DVec3::ONE), vector(node.translation, DVec3::ZERO));
    DMat4::from_scale_rotation_translation(scale, rotation, translation)
}
