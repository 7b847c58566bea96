//! Finds walls and outlines by place, so that levels of thousands of rooms stay fast.

use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

use crate::geometry::{Point, Polygon};
use crate::plan::Room;

type Boxed<T> = GeomWithData<Rectangle<[f64; 2]>, T>;

/// Things by bounding box.
#[derive(Debug)]
pub(in crate::plan) struct BoxIndex<T>(RTree<Boxed<T>>);

impl<T: Copy + Ord> BoxIndex<T> {
    /// Indexes items by the low and the high corner of their boxes; items without a place are left out.
    pub(in crate::plan) fn of(boxes: impl Iterator<Item = (Point, Point, T)>) -> Self {
        let boxes = boxes.filter(|(low, high, _)| low.is_finite() && high.is_finite());
        Self(RTree::bulk_load(boxes.map(|(low, high, thing)| boxed(low, high, thing)).collect()))
    }

    /// The items whose box meets the box from `low` to `high`, sorted.
    pub(in crate::plan) fn near(&self, low: Point, high: Point) -> Vec<T> {
        let mut things: Vec<T> = self.meeting(low, high).collect();
        // The tree's own order depends on how it was built; later ties must not.
        things.sort_unstable();
        things
    }

    /// As [`BoxIndex::near`] in the tree's own order, which is the same for the same boxes; not looked further than asked.
    pub(in crate::plan) fn meeting(&self, low: Point, high: Point) -> impl Iterator<Item = T> {
        let envelope = AABB::from_corners(low.to_array(), high.to_array());
        self.0.locate_in_envelope_intersecting(&envelope).map(|item| item.data)
    }

    /// Adds an item.
    pub(in crate::plan) fn add(&mut self, low: Point, high: Point, thing: T) {
        self.0.insert(boxed(low, high, thing));
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
pub(in crate::plan) struct WallIndex(BoxIndex<WallPlace>);

impl WallIndex {
    /// Indexes the walls of all rooms.
    pub(in crate::plan) fn of(rooms: &[Room]) -> Self {
        let boxes = rooms.iter().enumerate().flat_map(|(room, value)| {
            value.walls.iter().enumerate().map(move |(wall, piece)| {
                (piece.start.min(piece.end), piece.start.max(piece.end), WallPlace { room, wall })
            })
        });
        Self(BoxIndex::of(boxes))
    }

    /// As [`WallIndex::near_segment`]; of more than `most` walls those that the tree names first, which are the same for the
    /// same walls. So many lie at one place only where rooms are drawn upon each other.
    pub(in crate::plan) fn some_near(
        &self,
        (start, end): (Point, Point),
        reach: f64,
        most: usize,
    ) -> Vec<WallPlace> {
        let all = self.0.meeting(start.min(end) - reach, start.max(end) + reach);
        let mut places: Vec<WallPlace> = all.take(most).collect();
        places.sort_unstable();
        places
    }

    /// The walls whose bounding box comes within `reach` metres of that of a segment, sorted.
    pub(in crate::plan) fn near_segment(&self, start: Point, end: Point, reach: f64) -> Vec<WallPlace> {
        self.0.near(start.min(end) - reach, start.max(end) + reach)
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
        let index = BoxIndex::of(outlines.iter().enumerate().map(|(index, outline)| {
            let (low, high) = outline.bounds();
            (low, high, index)
        }));
        Self { outlines, index }
    }

    /// The outlines whose bounding box meets the box from `low` to `high`, in their order.
    pub(in crate::plan) fn near(&self, low: Point, high: Point) -> Vec<&Polygon> {
        self.index.near(low, high).into_iter().map(|index| &self.outlines[index]).collect()
    }

    /// Whether there is none.
    pub(in crate::plan) fn is_empty(&self) -> bool {
        self.outlines.is_empty()
    }
}

fn boxed<T>(low: Point, high: Point, thing: T) -> Boxed<T> {
    GeomWithData::new(Rectangle::from_corners(low.to_array(), high.to_array()), thing)
}
