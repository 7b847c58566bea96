//! Finding walls and outlines by place, so that levels of thousands of rooms stay fast.

use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

use crate::geometry::{Point, Polygon};
use crate::plan::Room;

type Box<T> = GeomWithData<Rectangle<[f64; 2]>, T>;

/// A wall of a level.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::plan) struct WallPlace {
    /// Index of the room.
    pub(in crate::plan) room: usize,
    /// Index of the wall in the room.
    pub(in crate::plan) wall: usize,
}

/// All walls of a level by bounding box.
pub(in crate::plan) struct WallIndex(RTree<Box<WallPlace>>);

impl WallIndex {
    /// Indexes the walls of all rooms.
    pub(in crate::plan) fn of(rooms: &[Room]) -> Self {
        let boxes = rooms.iter().enumerate().flat_map(|(room, value)| {
            value.walls.iter().enumerate().map(move |(wall, piece)| {
                boxed(piece.start.min(piece.end), piece.start.max(piece.end), WallPlace { room, wall })
            })
        });
        Self(RTree::bulk_load(boxes.collect()))
    }

    /// The walls whose bounding box comes within `reach` metres of that of a segment, sorted.
    pub(in crate::plan) fn near_segment(&self, start: Point, end: Point, reach: f64) -> Vec<WallPlace> {
        let (low, high) = (start.min(end) - reach, start.max(end) + reach);
        let envelope = AABB::from_corners(low.to_array(), high.to_array());
        let mut places: Vec<WallPlace> =
            self.0.locate_in_envelope_intersecting(&envelope).map(|item| item.data).collect();
        // The tree's own order depends on how it was built; later ties must not.
        places.sort_unstable();
        places
    }
}

/// Outlines by bounding box.
pub(in crate::plan) struct OutlineIndex {
    outlines: Vec<Polygon>,
    tree: RTree<Box<usize>>,
}

impl OutlineIndex {
    /// Indexes outlines.
    pub(in crate::plan) fn of(outlines: Vec<Polygon>) -> Self {
        let boxes = outlines.iter().enumerate().map(|(index, outline)| {
            let (low, high) = outline.bounds();
            boxed(low, high, index)
        });
        let tree = RTree::bulk_load(boxes.collect());
        Self { outlines, tree }
    }

    /// The outlines whose bounding box meets the box from `low` to `high`, in their order.
    pub(in crate::plan) fn near(&self, low: Point, high: Point) -> Vec<&Polygon> {
        let envelope = AABB::from_corners(low.to_array(), high.to_array());
        let mut found: Vec<usize> =
            self.tree.locate_in_envelope_intersecting(&envelope).map(|item| item.data).collect();
        found.sort_unstable();
        found.into_iter().map(|index| &self.outlines[index]).collect()
    }

    /// Whether there is none.
    pub(in crate::plan) fn is_empty(&self) -> bool {
        self.outlines.is_empty()
    }
}

fn boxed<T>(low: Point, high: Point, data: T) -> Box<T> {
    GeomWithData::new(Rectangle::from_corners(low.to_array(), high.to_array()), data)
}
