//! Places of nodes.

use crate::geometry::Point;

/// Places of nodes, by their sorted ids; NaN where the file lacks a node.
#[derive(Debug, Default)]
pub(in crate::plan::read) struct Places {
    ids: Vec<i64>,
    places: Vec<Point>,
}

impl Places {
    /// Of the nodes that are wanted, still without places.
    pub(in crate::plan::read) fn of_nodes(mut ids: Vec<i64>) -> Self {
        ids.sort_unstable();
        ids.dedup();
        Self { places: vec![Point::NAN; ids.len()], ids }
    }

    /// Notes the place of a node, if it is wanted.
    pub(in crate::plan::read) fn note(&mut self, node: i64, place: Point) {
        if let Ok(index) = self.ids.binary_search(&node) {
            self.places[index] = place;
        }
    }

    /// The places of some nodes, if all are there.
    pub(in crate::plan::read) fn of(&self, nodes: &[i64]) -> Option<Vec<Point>> {
        let place = |node: &i64| self.ids.binary_search(node).ok().map(|index| self.places[index]);
        nodes.iter().map(|node| place(node).filter(|place| !place.is_nan())).collect()
    }
}
