//! Reads doors and windows in the walls of the rooms.

use std::collections::BTreeMap;

use super::level::EmptyLevel;
use super::outline::point;
use super::problem::Problem;
use super::tree::Node;
use crate::contract::{Closure, Extras, LeafExtras, OpeningExtras, SideExtras};
use crate::geometry::Point;
use crate::plan::{Leaf, Level, Opening, OpeningKind, OpeningSide, RoomOpening};
use crate::scene::plan_point;

/// Metres by which an opening may reach over the end of its wall: rounding.
const OVER_END: f64 = 1e-4;

/// Adds the openings; `rooms` are the indices of the rooms by id.
pub(super) fn read(
    nodes: &[Node],
    empty: &mut EmptyLevel,
    rooms: &BTreeMap<String, usize>,
    problems: &mut Vec<Problem>,
) {
    for node in nodes {
        let Some(Extras::Opening(extras)) = &node.extras else { continue };
        match read_opening(extras, node, &empty.level, rooms) {
            Ok(opening) => add(&mut empty.level, opening),
            Err(message) => {
                problems.push(Problem::new(&node.name, message));
                // Without its door a room would be judged as another one.
                let sides = extras.sides.iter().filter_map(|side| rooms.get(&side.room));
                sides.for_each(|&room| empty.is_broken[room] = true);
            }
        }
    }
    for room in &mut empty.level.rooms {
        room.openings.sort_by(|a, b| a.wall.cmp(&b.wall).then(a.from.total_cmp(&b.from)));
    }
}

fn add(level: &mut Level, opening: Opening) {
    let number = level.openings.len();
    for side in &opening.sides {
        let place = RoomOpening { opening: number, wall: side.wall, from: side.from, to: side.to };
        level.rooms[side.room].openings.push(place);
    }
    level.openings.push(opening);
}

fn read_opening(
    extras: &OpeningExtras,
    node: &Node,
    level: &Level,
    rooms: &BTreeMap<String, usize>,
) -> Result<Opening, String> {
    let numbers = [extras.width, extras.height, extras.sill];
    let leaves: Vec<Leaf> = extras.leaves.iter().map(leaf).collect();
    let tips = leaves.iter().flat_map(|leaf| [leaf.hinge, leaf.closed_tip, leaf.open_tip]);
    if !numbers.iter().all(|number| (0.0..1e4).contains(number)) || !{ tips }.all(is_near) {
        return Err("has a width, height, sill or leaf that cannot be".to_owned());
    }
    // A side in a room that is missing from the file, or cannot be read, is a side to the open air.
    let known = extras.sides.iter().filter_map(|side| Some((side, *rooms.get(&side.room)?)));
    let sides = known.map(|(side, room)| read_side(side, room, level)).collect::<Result<Vec<_>, _>>()?;
    let center = plan_point(node.local.w_axis.truncate()).truncate();
    if !is_near(center) {
        return Err("stands nowhere: its transform is no number".to_owned());
    }
    let along = sides.first().map_or(Point::X, |side| level.rooms[side.room].walls[side.wall].direction());
    Ok(Opening {
        id: extras.id.clone(),
        kind: match extras.closure {
            Closure::Door => OpeningKind::Door,
            Closure::Sliding => OpeningKind::SlidingDoor,
            Closure::Passage => OpeningKind::Passage,
            Closure::Open => OpeningKind::OpenBoundary,
            Closure::Window => OpeningKind::Window,
        },
        center,
        along,
        width: extras.width,
        bottom: extras.sill,
        top: extras.sill + extras.height,
        leaves,
        sides,
    })
}

fn leaf(extras: &LeafExtras) -> Leaf {
    Leaf { hinge: point(extras.hinge), closed_tip: point(extras.closed), open_tip: point(extras.open) }
}

fn is_near(point: Point) -> bool {
    point.is_finite() && point.abs().max_element() < 1e7
}

fn read_side(side: &SideExtras, room: usize, level: &Level) -> Result<OpeningSide, String> {
    let wall = level.rooms[room].walls.get(side.wall);
    let wall =
        wall.ok_or_else(|| format!("is in wall {} of room \"{}\", which has fewer", side.wall, side.room))?;
    let is_within = side.from < side.to && side.from > -OVER_END && side.to < wall.length() + OVER_END;
    if !is_within {
        return Err(format!("reaches over the ends of wall {} of room \"{}\"", side.wall, side.room));
    }
    Ok(OpeningSide { room, wall: side.wall, from: side.from, to: side.to })
}
