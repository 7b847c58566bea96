//! Rooms that stand on each other and join their levels: stairs and lifts.

use crate::geometry::Point;
use crate::plan::assemble::BoxIndex;
use crate::plan::{Level, Room};

/// Levels that lie on each other, the lower one first.
pub(crate) fn neighbours(levels: &[Level]) -> impl Iterator<Item = (usize, usize)> + '_ {
    let pairs = levels.iter().enumerate().flat_map(|(lower, below)| {
        levels.iter().enumerate().map(move |(upper, above)| ((lower, below), (upper, above)))
    });
    pairs.filter_map(|((lower, below), (upper, above))| {
        let gap = above.elevation - (below.elevation + below.height);
        // Mezzanines and the parts of a building on a slope are up to half a storey off.
        let is_next = above.elevation > below.elevation && gap.abs() <= below.height / 2.0;
        is_next.then_some((lower, upper))
    })
}

/// The pairs of rooms of one type that joins levels, of which one stands on the other.
pub(crate) fn joined_rooms(
    below: &Level,
    above: &Level,
    joins: impl Fn(&Room) -> bool,
) -> Vec<(usize, usize)> {
    let joining = |level: &Level| -> Vec<usize> {
        (0..level.rooms.len()).filter(|index| joins(&level.rooms[*index])).collect()
    };
    let bounds = |room: &Room| room.region.outline.bounds();
    let uppers = BoxIndex::of(joining(above).into_iter().map(|room| (bounds(&above.rooms[room]), room)));
    let mut pairs = Vec::new();
    for lower in joining(below) {
        let mut met: Vec<usize> = uppers.meeting(bounds(&below.rooms[lower])).collect();
        met.sort_unstable();
        for upper in met {
            let (one, other) = (&below.rooms[lower], &above.rooms[upper]);
            if one.room_type == other.room_type && (holds_middle(one, other) || holds_middle(other, one)) {
                pairs.push((lower, upper));
            }
        }
    }
    pairs
}

/// Whether the middle of a room lies in another.
fn holds_middle(room: &Room, other: &Room) -> bool {
    room.region.contains(middle(other))
}

/// The mean of the corners of a room: its middle, but for odd shapes.
pub(crate) fn middle(room: &Room) -> Point {
    let corners = room.region.outline.corners();
    corners.iter().copied().sum::<Point>() / corners.len() as f64
}
