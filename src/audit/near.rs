//! Broad phase: what is near a place, without asking everything (A. Guttman, "R-trees", 1984, by `rstar`).
//!
//! In a room that somebody filled with a thousand copies at one place everything is near everything. There each thing is
//! compared with some of the others only: a room of which that is true fails for what was compared.

use std::borrow::Cow;

use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, PointDistance, RTree};

use super::upright_box::UprightBox;
use crate::geometry::Point;

/// Others that a thing is compared with at most. A table that is laid for twelve touches some sixty; with more, a room
/// full of copies takes longer to judge.
pub(crate) const MOST_NEAR: usize = 128;

/// Boxes by where they are.
pub(crate) struct NearBoxes {
    tree: RTree<GeomWithData<Rectangle<[f64; 3]>, usize>>,
}

impl NearBoxes {
    pub(crate) fn new(boxes: impl Iterator<Item = UprightBox>) -> Self {
        let filled = boxes.enumerate().filter(|(_, bounds)| !bounds.is_empty());
        let entries = filled.map(|(index, bounds)| {
            let corners = (bounds.low.to_array(), bounds.high.to_array());
            GeomWithData::new(Rectangle::from_corners(corners.0, corners.1), index)
        });
        Self { tree: RTree::bulk_load(entries.collect()) }
    }

    /// The boxes that share a point with another, in no order that means anything; none touches an empty one.
    pub(crate) fn touching(&self, bounds: &UprightBox) -> impl Iterator<Item = usize> + use<'_> {
        // Of an empty box the corners are swapped, which the tree would take for the box between them.
        let around =
            (!bounds.is_empty()).then(|| AABB::from_corners(bounds.low.to_array(), bounds.high.to_array()));
        let found = around.map(|around| self.tree.locate_in_envelope_intersecting(&around));
        found.into_iter().flatten().map(|entry| entry.data)
    }

    /// All pairs of boxes that touch, as `(lower index, higher index)`, sorted; of a box that touches more than
    /// [`MOST_NEAR`] others, so many.
    pub(crate) fn touching_pairs(&self, boxes: impl Iterator<Item = UprightBox>) -> Vec<(usize, usize)> {
        let mut pairs = Vec::new();
        for (index, bounds) in boxes.enumerate() {
            let others = self.touching(&bounds).filter(|&other| other != index).take(MOST_NEAR);
            pairs.extend(others.map(|other| (index.min(other), index.max(other))));
        }
        // The tree has an order of its own that depends on all boxes; findings have that of the placements.
        pairs.sort_unstable();
        pairs.dedup();
        pairs
    }
}

/// Things at places.
pub(crate) struct NearPoints {
    /// In the order of their numbers.
    all: Vec<usize>,
    /// Where there are more than [`MOST_NEAR`].
    tree: Option<RTree<GeomWithData<[f64; 2], usize>>>,
}

impl NearPoints {
    /// Things by number, the lowest first.
    pub(crate) fn new(things: impl Iterator<Item = (usize, Point)>) -> Self {
        let entries: Vec<_> =
            things.map(|(number, place)| GeomWithData::new(place.to_array(), number)).collect();
        let all = entries.iter().map(|entry| entry.data).collect();
        // Fewer are looked through faster than a tree is made; then all are answered, in the order of their numbers.
        let tree = (entries.len() > MOST_NEAR).then(|| RTree::bulk_load(entries));
        Self { all, tree }
    }

    /// The things that are nearest to a place, so many at most: all of them where they are not many.
    pub(crate) fn nearest(&self, place: Point) -> Cow<'_, [usize]> {
        let Some(tree) = &self.tree else { return Cow::Borrowed(&self.all) };
        tree.nearest_neighbor_iter(&place.to_array()).take(MOST_NEAR).map(|entry| entry.data).collect()
    }

    /// Metres to the nearest thing.
    pub(crate) fn distance(&self, place: Point, position: impl Fn(usize) -> Point) -> Option<f64> {
        let place_of = place.to_array();
        match &self.tree {
            Some(tree) => tree.nearest_neighbor(&place_of).map(|entry| entry.distance_2(&place_of).sqrt()),
            None => self.all.iter().map(|&thing| position(thing).distance(place)).reduce(f64::min),
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;

    fn unit_box(x: f64, y: f64, z: f64) -> UprightBox {
        UprightBox { low: DVec3::new(x, y, z), high: DVec3::new(x + 1.0, y + 1.0, z + 1.0) }
    }

    fn share_a_point(one: UprightBox, other: UprightBox) -> bool {
        one.low.cmple(other.high).all() && other.low.cmple(one.high).all()
    }

    fn pairs(boxes: &[UprightBox]) -> Vec<(usize, usize)> {
        NearBoxes::new(boxes.iter().copied()).touching_pairs(boxes.iter().copied())
    }

    #[test]
    fn touching_boxes_are_pairs_and_stacked_ones_are_not() {
        let boxes = [
            unit_box(0.0, 0.0, 0.0),
            unit_box(5.0, 0.0, 0.0),
            unit_box(0.9, 0.9, 0.9),
            unit_box(0.0, 0.0, 2.0),
            UprightBox::EMPTY,
        ];
        assert_eq!(pairs(&boxes), [(0, 2)]);
        assert!(pairs(&[]).is_empty());
    }

    #[test]
    fn the_pairs_are_those_of_asking_every_pair() {
        let scatter = |i: u32, step: u32| f64::from((i * step) % 101) / 10.0;
        for tall in [0.5, 3.0] {
            let boxes: Vec<UprightBox> = (0..120)
                .map(|i| unit_box(scatter(i, 37), scatter(i, 53) * tall, scatter(i, 71) / 5.0))
                .collect();
            let every: Vec<(usize, usize)> = (0..boxes.len())
                .flat_map(|a| (a + 1..boxes.len()).map(move |b| (a, b)))
                .filter(|&(a, b)| share_a_point(boxes[a], boxes[b]))
                .collect();
            assert!(every.len() > 20);
            assert_eq!(pairs(&boxes), every);
        }
    }

    #[test]
    fn boxes_at_one_place_are_compared_with_some_of_the_others() {
        let count = |boxes: usize| pairs(&vec![unit_box(0.0, 0.0, 0.0); boxes]).len();
        assert_eq!(count(100), 100 * 99 / 2);
        assert!((400 * MOST_NEAR / 2..=400 * MOST_NEAR).contains(&count(400)));
    }

    #[test]
    fn of_many_things_the_nearest_are_found_and_of_few_all() {
        let place = |number: usize| Point::new(number as f64, 0.0);
        let things = |count: usize| NearPoints::new((0..count).map(|number| (number, place(number))));
        assert_eq!(*things(3).nearest(Point::ZERO), [0, 1, 2]);
        let many = things(10 * MOST_NEAR);
        let nearest = many.nearest(Point::new(500.2, 0.0));
        assert_eq!((nearest.len(), nearest[0], nearest[1]), (MOST_NEAR, 500, 501));
        for things in [things(3), many] {
            let distance = things.distance(Point::new(0.25, 0.0), place);
            assert_eq!(distance, Some(0.25));
        }
        assert_eq!(things(0).distance(Point::ZERO, place), None);
    }
}
