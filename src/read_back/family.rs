//! Finds the parent of each object.
//!
//! The node tree says which object carries a piece. The extras say which object it was arranged by: a chair has its table
//! as parent, and its node is a child of the room. Editors may hang nodes elsewhere, and copies repeat the extras of
//! their originals.

use std::collections::BTreeMap;

use super::furniture::Spot;
use super::tree::Node;
use crate::contract::{ElementId, Extras, FurnitureExtras, ObjectId};

/// More pieces than stand on and beside each other in a row.
const LONGEST_CHAIN: usize = 256;

/// The furniture of a file, by what it says of itself.
pub(super) struct Family<'n> {
    nodes: &'n [Node],
    spots: &'n [Option<Spot>],
    /// By room and id; of equal ids the first.
    by_id: BTreeMap<(usize, &'n ObjectId), usize>,
}

impl<'n> Family<'n> {
    /// The objects among the nodes, each with its spot, if it is in a room.
    pub(super) fn new(nodes: &'n [Node], spots: &'n [Option<Spot>]) -> Self {
        let mut by_id = BTreeMap::new();
        for (index, spot) in spots.iter().enumerate() {
            if let (Some(spot), Some(extras)) = (spot, furniture(nodes, index)) {
                by_id.entry((spot.room, &extras.id)).or_insert(index);
            }
        }
        Self { nodes, spots, by_id }
    }

    /// The node of the object that the object of a node belongs to: the one that it names, as long as it hangs below that
    /// one, below what carries that one, or below no object; else the one that it was hung below.
    pub(super) fn parent_of(&self, node: usize) -> Option<usize> {
        let (spot, extras) = (self.spots[node]?, furniture(self.nodes, node)?);
        let named = self.named_by(node).filter(|&named| named != node);
        let Some(above) = spot.above else { return named };
        if furniture(self.nodes, above).is_some_and(|above| is_object(&extras.parent, &above.id)) {
            return Some(above);
        }
        let mut chain = std::iter::successors(named, |&object| self.named_by(object)).take(LONGEST_CHAIN);
        if chain.any(|object| object == above) { named } else { Some(above) }
    }

    /// The object of the same room that an object names as its parent.
    fn named_by(&self, node: usize) -> Option<usize> {
        let ElementId::Object(parent) = &furniture(self.nodes, node)?.parent else { return None };
        self.by_id.get(&(self.spots[node]?.room, parent)).copied()
    }
}

fn is_object(element: &ElementId, object: &ObjectId) -> bool {
    matches!(element, ElementId::Object(named) if named == object)
}

fn furniture(nodes: &[Node], index: usize) -> Option<&FurnitureExtras> {
    match &nodes[index].extras {
        Some(Extras::Furniture(extras)) => Some(extras),
        _ => None,
    }
}
