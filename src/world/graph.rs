//! What one sees and walks through between the rooms of a building: cells, portals, and stairs between levels.

use crate::catalog::Catalog;
use crate::geometry::{Bounds, Point, Segment};
use crate::plan::{Building, Level, Room, joined_rooms, neighbours};

/// A room of a building, both as indices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Place {
    /// Index into the levels of the building.
    pub(crate) level: usize,
    /// Index into the rooms of the level.
    pub(crate) room: usize,
}

/// A room of a world, as indices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Key {
    /// Index into the buildings of the plan.
    pub(crate) building: usize,
    /// The room of that building.
    pub(crate) place: Place,
}

/// The rooms of a building as one sees through them. Equal for all buildings that share a plan.
#[derive(Debug)]
pub(crate) struct BuildingGraph {
    /// The levels, in the order of the plan.
    pub(crate) levels: Vec<LevelGraph>,
}

/// The rooms of a level.
#[derive(Debug)]
pub(crate) struct LevelGraph {
    /// Metres of its floor above the building's zero.
    pub(crate) elevation: f64,
    /// The rooms, in the order of the level.
    pub(crate) cells: Vec<Cell>,
    /// The portals to the open air: cell, and index into its portals.
    pub(crate) outer: Vec<(usize, usize)>,
}

/// A room.
#[derive(Debug)]
pub(crate) struct Cell {
    /// The box around it.
    pub(crate) bounds: Bounds,
    /// Its openings.
    pub(crate) portals: Vec<Portal>,
    /// The rooms above and below to which stairs or a lift lead.
    pub(crate) joined: Vec<Place>,
}

/// An opening as seen from one of its rooms. Doors count as open: a room has to be there before its door is opened.
#[derive(Debug)]
pub(crate) struct Portal {
    /// The hole in the wall's inner face, the room on its left.
    pub(crate) face: Segment,
    /// The room behind; none in the open air.
    pub(crate) behind: Option<Behind>,
    /// Whether people walk through.
    pub(crate) is_walkable: bool,
}

/// The far side of a portal.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Behind {
    /// Index of the room.
    pub(crate) room: usize,
    /// The hole in the inner face of that room's wall, that room on its left.
    pub(crate) face: Segment,
}

impl BuildingGraph {
    /// The graph of a building; the catalogue says which types of rooms join levels.
    pub(crate) fn new(building: &Building, catalog: &Catalog) -> Self {
        let joins =
            |room: &Room| catalog.room_types.get(&room.room_type).is_some_and(|found| found.joins_levels);
        let mut levels: Vec<LevelGraph> = building.levels.iter().map(LevelGraph::new).collect();
        for (lower, upper) in neighbours(&building.levels) {
            for (below, above) in joined_rooms(&building.levels[lower], &building.levels[upper], joins) {
                let (below, above) =
                    (Place { level: lower, room: below }, Place { level: upper, room: above });
                levels[lower].cells[below.room].joined.push(above);
                levels[upper].cells[above.room].joined.push(below);
            }
        }
        Self { levels }
    }

    /// Whether a place is in no room of a level.
    pub(crate) fn is_outside(&self, building: &Building, level: usize, at: Point) -> bool {
        let cells = self.levels[level].cells.iter().zip(&building.levels[level].rooms);
        !cells.into_iter().any(|(cell, room)| cell.bounds.contains(at) && room.region.contains(at))
    }

    /// A room.
    pub(crate) fn cell(&self, place: Place) -> &Cell {
        &self.levels[place.level].cells[place.room]
    }
}

impl LevelGraph {
    fn new(level: &Level) -> Self {
        let cells: Vec<Cell> = (0..level.rooms.len()).map(|room| cell(level, room)).collect();
        let outer = cells.iter().enumerate().flat_map(|(room, cell)| {
            let portals = cell.portals.iter().enumerate();
            portals.filter(|(_, portal)| portal.behind.is_none()).map(move |(index, _)| (room, index))
        });
        let outer = outer.collect();
        Self { elevation: level.elevation, cells, outer }
    }
}

fn cell(level: &Level, index: usize) -> Cell {
    let room = &level.rooms[index];
    let portals = room.openings.iter().filter_map(|at| {
        let opening = &level.openings[at.opening];
        let sides = &opening.sides;
        let own = sides.iter().position(|side| side.room == index && side.wall == at.wall)?;
        let other = sides.iter().enumerate().find(|(side, _)| *side != own).map(|(_, side)| side);
        let behind = match other {
            // A door between two parts of one room shows nothing new.
            Some(side) if side.room == index => return None,
            Some(side) => Some(Behind {
                room: side.room,
                face: face(&level.rooms[side.room], side.wall, side.from, side.to),
            }),
            None => None,
        };
        let face = face(room, at.wall, at.from, at.to);
        Some(Portal { face, behind, is_walkable: opening.kind.is_walkable() })
    });
    Cell { bounds: room.region.outline.bounds(), portals: portals.collect(), joined: Vec::new() }
}

fn face(room: &Room, wall: usize, from: f64, to: f64) -> Segment {
    let wall = &room.walls[wall];
    let along = wall.direction();
    Segment::new(wall.start + along * from, wall.start + along * to)
}
