//! Resolves the parent that the extras of each piece name.

use std::collections::{BTreeMap, BTreeSet};

use super::family::Family;
use super::furniture::Piece;
use super::level::EmptyRoomNode;
use super::problem::Problem;
use super::tree::Node;
use crate::contract::{ElementId, ObjectId};
use crate::layout::{Parent, Placement};
use crate::plan::RoomRef;

/// The placements with their parents, each after its parent.
pub(super) fn parents_first(
    nodes: &[Node],
    at: EmptyRoomNode<'_>,
    family: &Family<'_>,
    mut pieces: Vec<Piece<'_>>,
) -> Result<Vec<Placement>, Problem> {
    let ids: BTreeSet<&ObjectId> = pieces.iter().map(|piece| &piece.extras.id).collect();
    if ids.len() < pieces.len() {
        return Err(Problem::new(&nodes[at.node].name, "has two objects of the same id"));
    }
    let by_node: BTreeMap<usize, Option<usize>> =
        pieces.iter().map(|piece| (piece.node, family.parent_of(piece.node))).collect();
    // Those that stand on no other, then what stands on them, and so on.
    let mut waiting: BTreeMap<Option<usize>, Vec<usize>> = BTreeMap::new();
    for piece in &pieces {
        waiting.entry(by_node[&piece.node]).or_default().push(piece.node);
    }
    let mut sorted = waiting.remove(&None).unwrap_or_default();
    let mut next = 0;
    while let Some(&node) = sorted.get(next) {
        sorted.extend(waiting.remove(&Some(node)).unwrap_or_default());
        next += 1;
    }
    if let Some(&node) = waiting.values().flatten().next() {
        return Err(Problem::new(&nodes[node].name, "stands on itself"));
    }
    let order: BTreeMap<usize, usize> =
        sorted.into_iter().enumerate().map(|(index, node)| (node, index)).collect();
    pieces.sort_by_key(|piece| order[&piece.node]);
    let placed = pieces.into_iter().map(|piece| {
        let parent = match by_node[&piece.node] {
            Some(above) => Parent::Object(order[&above]),
            None => room_part(&piece.extras.parent, at.room).ok_or_else(|| {
                let message = format!("stands on \"{}\", which is not there", piece.extras.parent);
                Problem::new(&nodes[piece.node].name, message)
            })?,
        };
        Ok(Placement { parent, ..piece.placement })
    });
    placed.collect()
}

/// The part of a room, or the opening, that an id means: the other way of [`crate::layout::parent_id`].
pub(crate) fn room_part(id: &ElementId, at: RoomRef<'_>) -> Option<Parent> {
    let RoomRef { level, room, .. } = at;
    match id {
        ElementId::Floor => Some(Parent::Floor),
        ElementId::Ceiling => Some(Parent::Ceiling),
        &ElementId::Wall(wall) => (wall < room.walls.len()).then_some(Parent::Wall(wall)),
        &ElementId::Column(column) => (column < room.obstacles.len()).then_some(Parent::Column(column)),
        ElementId::Door(opening) | ElementId::Window(opening) => {
            let mut here = room.openings.iter().map(|place| place.opening);
            here.find(|&index| level.openings[index].id == *opening).map(Parent::Opening)
        }
        ElementId::Object(_) => None,
    }
}
