//! The long axis of a room, from the end where people come in to the end that they look at.

use super::{Opening, OpeningKind, Room};
use crate::geometry::{LONGER, Point, Segment, main_axis};

impl Room {
    /// The line along which the room is longest, in the middle of its width. It ends where doors are farthest: people look there.
    /// `openings` are those of the level.
    #[must_use]
    pub fn long_axis(&self, openings: &[Opening]) -> Option<Segment> {
        let edges: Vec<Segment> = self.region.borders().collect();
        let longest =
            edges.iter().copied().reduce(|a, b| if b.length() > a.length() + LONGER { b } else { a })?;
        let doors: Vec<Point> = self.doors(openings).collect();
        let gap = |end: Point| doors.iter().map(|door| door.distance(end)).fold(f64::INFINITY, f64::min);
        let axis = main_axis(&edges, longest.direction(), gap)?;
        Some(if gap(axis.start) > gap(axis.end) + LONGER { axis.reversed() } else { axis })
    }

    /// The middles of its doors and passages, on its walls.
    fn doors(&self, openings: &[Opening]) -> impl Iterator<Item = Point> {
        let is_door = |kind: OpeningKind| {
            matches!(kind, OpeningKind::Door | OpeningKind::SlidingDoor | OpeningKind::Passage)
        };
        let doors = self.openings.iter().filter(move |side| is_door(openings[side.opening].kind));
        doors.map(|side| self.walls[side.wall].after(f64::midpoint(side.from, side.to)))
    }
}
