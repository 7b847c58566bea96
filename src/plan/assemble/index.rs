//! Finds walls and outlines by place, so that levels of thousands of rooms stay fast.

use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

use crate::geometry::{Bounds, Polygon, Segment};
use crate::plan::Room;

type Boxed<T> = GeomWithData<Rectangle<[f64; 2]>, T>;

/// Things by bounding box.
#[derive(Debug)]
pub(in crate::plan) struct BoxIndex<T>(RTree<Boxed<T>>);

impl<T: Copy + Ord> BoxIndex<T> {
    /// Indexes items by their boxes; items without a place are left out.
    pub(in crate::plan) fn of(boxes: impl Iterator<Item = (Bounds, T)>) -> Self {
        let boxes = boxes.filter(|(bounds, _)| bounds.low.is_finite() && bounds.high.is_finite());
        Self(RTree::bulk_load(boxes.map(|(bounds, thing)| boxed(bounds, thing)).collect()))
    }

    /// The items whose box meets a box, sorted.
    pub(in crate::plan) fn near(&self, bounds: Bounds) -> Vec<T> {
        let mut things: Vec<T> = self.meeting(bounds).collect();
        // The tree's own order depends on how it was built; later ties must not.
        things.sort_unstable();
        things
    }

    /// As [`BoxIndex::near`] in the tree's own order, which is the same for the same boxes; not looked further than asked.
    pub(in crate::plan) fn meeting(&self, bounds: Bounds) -> impl Iterator<Item = T> {
        let envelope = AABB::from_corners(bounds.low.to_array(), bounds.high.to_array());
        self.0.locate_in_envelope_intersecting(&envelope).map(|item| item.data)
    }

    /// Adds an item.
    pub(in crate::plan) fn add(&mut self, bounds: Bounds, thing: T) {
        self.0.insert(boxed(bounds, thing));
    }
}

/// Things by bounding box, of which those that are found come in no order that counts: few of them are looked through one by one,
/// which is faster than a tree.
#[derive(Debug)]
pub(in crate::plan) struct LooseIndex<T> {
    few: Vec<(Bounds, T)>,
    many: Option<BoxIndex<T>>,
}

/// Things that are looked through one by one, at most: those of a storey with thirty rooms.
const FEW: usize = 192;

impl<T: Copy + Ord> LooseIndex<T> {
    /// As [`BoxIndex::of`].
    pub(in crate::plan) fn of(boxes: impl Iterator<Item = (Bounds, T)>) -> Self {
        let mut few: Vec<(Bounds, T)> = boxes.collect();
        if few.len() > FEW {
            return Self { many: Some(BoxIndex::of(few.into_iter())), few: Vec::new() };
        }
        few.retain(|(bounds, _)| bounds.low.is_finite() && bounds.high.is_finite());
        Self { few, many: None }
    }

    /// The items whose box meets a box.
    pub(in crate::plan) fn meeting(&self, bounds: Bounds) -> impl Iterator<Item = T> {
        let few = self.few.iter().filter(move |(own, _)| own.touches(bounds)).map(|(_, thing)| *thing);
        few.chain(self.many.iter().flat_map(move |many| many.meeting(bounds)))
    }
}

/// A wall of a level.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::plan) struct WallPlace {
    /// Index of the room.
    pub(in crate::plan) room: usize,
    /// Index of the wall in the room.
    pub(in crate::plan) wall: usize,
}

/// All walls of a level by bounding box.
pub(in crate::plan) struct WallIndex(LooseIndex<WallPlace>);

impl WallIndex {
    /// Indexes the walls of all rooms.
    pub(in crate::plan) fn of(rooms: &[Room]) -> Self {
        let boxes = rooms.iter().enumerate().flat_map(|(room, value)| {
            value
                .walls
                .iter()
                .enumerate()
                .map(move |(wall, piece)| (piece.segment().bounds(), WallPlace { room, wall }))
        });
        Self(LooseIndex::of(boxes))
    }

    /// As [`WallIndex::near_segment`]; of more than `most` walls those that the tree names first, which are the same for the
    /// same walls. So many lie at one place only where rooms are drawn upon each other.
    pub(in crate::plan) fn some_near(&self, segment: Segment, reach: f64, most: usize) -> Vec<WallPlace> {
        let all = self.0.meeting(segment.bounds().inflated(reach));
        let mut places: Vec<WallPlace> = all.take(most).collect();
        places.sort_unstable();
        places
    }

    /// The walls whose bounding box comes within `reach` metres of that of a segment, sorted.
    pub(in crate::plan) fn near_segment(&self, segment: Segment, reach: f64) -> Vec<WallPlace> {
        self.some_near(segment, reach, usize::MAX)
    }
}

/// Outlines by bounding box.
pub(in crate::plan) struct OutlineIndex {
    outlines: Vec<Polygon>,
    index: BoxIndex<usize>,
}

impl OutlineIndex {
    /// Indexes outlines.
    pub(in crate::plan) fn of(outlines: Vec<Polygon>) -> Self {
        let boxes = outlines.iter().map(Polygon::bounds).zip(0..);
        let index = BoxIndex::of(boxes);
        Self { outlines, index }
    }

    /// The outlines whose bounding box meets a box, in their order.
    pub(in crate::plan) fn near(&self, bounds: Bounds) -> Vec<&Polygon> {
        self.index.near(bounds).into_iter().map(|index| &self.outlines[index]).collect()
    }

    /// Whether there is none.
    pub(in crate::plan) fn is_empty(&self) -> bool {
        self.outlines.is_empty()
    }
}

fn boxed<T>(bounds: Bounds, thing: T) -> Boxed<T> {
    GeomWithData::new(Rectangle::from_corners(bounds.low.to_array(), bounds.high.to_array()), thing)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Point;

    #[test]
    fn few_things_and_many_are_found_alike() {
        let bounds = |number: usize| {
            let low = Point::new((number % 20) as f64, (number / 20) as f64);
            Bounds::new(low, low + Point::splat(if number.is_multiple_of(7) { f64::NAN } else { 1.0 }))
        };
        for count in [0, 30, FEW, FEW + 1, 2 * FEW] {
            let boxes = || (0..count).map(|number| (bounds(number), number));
            let (loose, tree) = (LooseIndex::of(boxes()), BoxIndex::of(boxes()));
            assert_eq!(loose.many.is_some(), count > FEW);
            for place in 0..60 {
                let place = bounds(place).low + Point::splat(0.5);
                let mut found: Vec<usize> = loose.meeting(Bounds::around_point(place, 1.0)).collect();
                found.sort_unstable();
                assert_eq!(found, tree.near(Bounds::around_point(place, 1.0)));
            }
        }
    }
}
