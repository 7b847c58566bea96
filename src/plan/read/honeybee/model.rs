//! What dragonfly and honeybee models have in common: storeys of spaces, whose edges have holes. Metres, z up.

use crate::document::PathStep;
use crate::geometry::Point;

/// Where something stands in the file.
pub(super) type Place = Vec<PathStep>;

/// The place of a part of something.
pub(super) fn part<const COUNT: usize>(place: &[PathStep], steps: [PathStep; COUNT]) -> Place {
    place.iter().cloned().chain(steps).collect()
}

/// A storey, or several equal ones on each other.
#[derive(Debug)]
pub(super) struct Storey {
    pub(super) name: String,
    /// Metres from floor to floor.
    pub(super) height: Option<f64>,
    pub(super) repeat: usize,
    pub(super) spaces: Vec<Space>,
    pub(super) place: Place,
}

/// A room.
#[derive(Clone, Debug)]
pub(super) struct Space {
    /// The identifier of the file, by which other rooms name it; parts of one room share it.
    pub(super) identifier: String,
    /// Unique in the file.
    pub(super) id: String,
    pub(super) name: Option<String>,
    /// The id of its program: `2019::SmallOffice::Storage`.
    pub(super) program: Option<String>,
    /// Metres above zero.
    pub(super) floor: f64,
    /// Metres from floor to ceiling.
    pub(super) height: f64,
    pub(super) outline: Vec<Point>,
    pub(super) holes: Vec<Vec<Point>>,
    pub(super) edges: Vec<Edge>,
    pub(super) place: Place,
}

/// A wall of a space, seen from above.
#[derive(Clone, Debug)]
pub(super) struct Edge {
    pub(super) start: Point,
    pub(super) end: Point,
    /// Identifier of the room behind.
    pub(super) far: Option<String>,
    /// Whether no wall stands there.
    pub(super) is_open: bool,
    pub(super) holes: Vec<Hole>,
}

impl Edge {
    /// Metres from start to end.
    pub(super) fn length(&self) -> f64 {
        self.start.distance(self.end)
    }

    /// A point so many metres from its start.
    pub(super) fn at(&self, along: f64) -> Point {
        self.start + (self.end - self.start).normalize_or_zero() * along
    }
}

/// A window or door in a wall.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Hole {
    pub(super) id: String,
    pub(super) is_door: bool,
    /// Metres along the edge, from its start.
    pub(super) from: f64,
    pub(super) to: f64,
    /// Metres above the floor of the room.
    pub(super) bottom: f64,
    pub(super) top: f64,
}

impl Hole {
    /// A hole around corners, of metres along the wall and above the floor.
    pub(super) fn around(id: String, is_door: bool, corners: impl Iterator<Item = (f64, f64)>) -> Self {
        const NONE: (f64, f64) = (f64::INFINITY, f64::NEG_INFINITY);
        let grown = |(low, high): (f64, f64), value: f64| (low.min(value), high.max(value));
        let (sides, heights) =
            corners.fold((NONE, NONE), |(sides, heights), (x, y)| (grown(sides, x), grown(heights, y)));
        Self { id, is_door, from: sides.0, to: sides.1, bottom: heights.0, top: heights.1 }
    }

    /// Metres along the wall.
    pub(super) fn width(&self) -> f64 {
        self.to - self.from
    }
}
