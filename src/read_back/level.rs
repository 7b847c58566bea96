//! Reads the empty level: rooms, walls, columns, openings.

use std::collections::BTreeMap;

use super::openings;
use super::outline::polygon;
use super::problem::Problem;
use super::tree::Node;
use crate::contract::{Extras, LevelExtras, Part, PartExtras, PartId, RoomExtras};
use crate::geometry::Region;
use crate::plan::limits::STOREY_HEIGHT;
use crate::plan::{Home, Level, Obstacle, Room, RoomRef};

/// A level and where its rooms are in the file.
pub(super) struct EmptyLevel {
    pub(super) building: String,
    pub(super) level: Level,
    /// By room of `level`: the index of its node.
    pub(super) room_nodes: Vec<usize>,
    /// Whether something of a room, but its furniture, cannot be read.
    pub(super) is_broken: Vec<bool>,
}

/// A room without its furniture.
#[derive(Clone, Copy)]
pub(super) struct EmptyRoomNode<'a> {
    pub(super) room: RoomRef<'a>,
    /// The index of its node.
    pub(super) node: usize,
}

impl EmptyLevel {
    /// A room by its index.
    pub(super) fn room(&self, index: usize) -> EmptyRoomNode<'_> {
        EmptyRoomNode { room: self.level.room(index), node: self.room_nodes[index] }
    }

    /// The index of the room that a node is.
    pub(super) fn room_of(&self, node: usize) -> Option<usize> {
        self.room_nodes.binary_search(&node).ok()
    }
}

/// Reads the level of a file.
///
/// # Errors
/// If there is none.
pub(super) fn read(nodes: &[Node], problems: &mut Vec<Problem>) -> Result<EmptyLevel, Problem> {
    let LevelExtras { building, level: id, elevation, height, .. } = level_extras(nodes)?;
    let mut empty = EmptyLevel {
        building,
        level: Level { elevation, ..Level::bare(&id, height, Vec::new()) },
        room_nodes: Vec::new(),
        is_broken: Vec::new(),
    };
    let mut known = BTreeMap::new();
    for (index, node) in nodes.iter().enumerate() {
        let Some(Extras::Room(extras)) = &node.extras else { continue };
        let number = empty.level.rooms.len();
        match known.insert(extras.room.clone(), number) {
            Some(_) => {
                problems.push(Problem::new(&node.name, format!("is a second room \"{}\"", extras.room)))
            }
            None => match read_room(extras, number) {
                Ok(room) => {
                    empty.level.rooms.push(room);
                    empty.room_nodes.push(index);
                    empty.is_broken.push(false);
                }
                Err(message) => {
                    known.remove(&extras.room);
                    problems.push(Problem::new(&node.name, message));
                }
            },
        }
    }
    parts(nodes, &mut empty, problems);
    openings::read(nodes, &mut empty, &known, problems);
    Ok(empty)
}

pub(super) fn level_extras(nodes: &[Node]) -> Result<LevelExtras, Problem> {
    let mut levels = nodes.iter().filter_map(|node| match &node.extras {
        Some(Extras::Level(level)) => Some((level, &node.name)),
        _ => None,
    });
    let Some((level, _)) = levels.next() else {
        let problem = Problem::new("", "has no level: no node's extras say {\"kind\": \"level\"}");
        return Err(
            problem.with_hint(
                "use files that bake wrote, or that keep their extras: in Blender, File > Export > glTF, Include > Custom \
                 Properties",
            )
        );
    };
    match levels.next() {
        Some((_, second)) => Err(Problem::new(second, "is a second level; a file has one")),
        None => Ok(level.clone()),
    }
}

fn read_room(extras: &RoomExtras, number: usize) -> Result<Room, String> {
    let outline = polygon(&extras.outline).map_err(|problem| format!("cannot be judged: {problem}"))?;
    let holes = extras.holes.iter().map(|hole| polygon(hole)).collect::<Result<Vec<_>, _>>();
    let holes = holes.map_err(|problem| format!("cannot be judged: a hole {problem}"))?;
    let region = Region { outline, holes };
    if !(extras.height.is_finite() && extras.height > 0.0 && region.area() > 0.0) {
        return Err("has no height or no floor".to_owned());
    }
    if extras.height > STOREY_HEIGHT.1 {
        return Err(format!("is {} m high, {} m are the most that is read", extras.height, STOREY_HEIGHT.1));
    }
    let number = u32::try_from(number).map_err(|_| "is one room too many".to_owned())?;
    // The audit needs only the places of walls; the rest is not in the file.
    let bare = Room::bare(&extras.room, &extras.room_type, region, extras.height, 0.0);
    let home = extras.household.as_ref().map(|household| Home {
        household: household.id.clone(),
        persons: household.persons,
        bedrooms: household.bedrooms,
        planned_type: extras.planned_type.clone(),
    });
    Ok(Room { number, style: Some(extras.style.clone()), home, ..bare })
}

/// By room and number.
type Columns = BTreeMap<(usize, usize), Obstacle>;

/// Adds columns, and the tags of walls.
fn parts(nodes: &[Node], empty: &mut EmptyLevel, problems: &mut Vec<Problem>) {
    let mut columns = Columns::new();
    for node in nodes {
        let Some(room) = node.parent.and_then(|parent| empty.room_of(parent)) else { continue };
        let problem = match &node.extras {
            Some(Extras::Part(part)) => add_part(empty, room, part, &mut columns).err(),
            // The fault is known; what the room lacks by it is not.
            _ => node.is_broken.then(String::new),
        };
        if let Some(message) = problem {
            empty.is_broken[room] = true;
            if !message.is_empty() {
                problems.push(Problem::new(&node.name, message));
            }
        }
    }
    // In the order of their numbers, whatever order an editor wrote them in.
    for ((room, number), column) in columns {
        let obstacles = &mut empty.level.rooms[room].obstacles;
        if number == obstacles.len() {
            obstacles.push(column);
        } else {
            let node = &nodes[empty.room_nodes[room]].name;
            problems.push(Problem::new(
                node,
                format!("has a column.{number}, but no column.{}", obstacles.len()),
            ));
            empty.is_broken[room] = true;
        }
    }
}

fn add_part(
    empty: &mut EmptyLevel,
    room: usize,
    part: &PartExtras,
    columns: &mut Columns,
) -> Result<(), String> {
    match part.id {
        PartId { part: Part::Wall, wall: None, number: Some(number) } => {
            let wall = empty.level.rooms[room].walls.get_mut(number);
            wall.ok_or("is a wall that the outline does not have")?.tags.clone_from(&part.tags);
        }
        PartId { part: Part::Column, wall: None, number: Some(number) } => {
            let (Some(outline), Some(height)) = (&part.outline, part.height) else {
                return Err("is a column without `outline` or `height`".to_owned());
            };
            let outline = polygon(outline).map_err(|problem| format!("cannot be judged: {problem}"))?;
            columns.insert((room, number), Obstacle { outline, height });
        }
        _ => {}
    }
    Ok(())
}
