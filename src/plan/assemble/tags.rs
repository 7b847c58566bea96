//! Tags walls by their properties (the paper's section 4), besides the tags of the plan.

use super::{Assembly, WallIndex};
use crate::geometry::{CORNER_TOLERANCE, Point, ray_hit};
use crate::plan::{Opening, OpeningKind, PIPES_TAG, Room, Wall, WallKind};

/// Metres that a ray to the opposite wall starts inside the room.
const RAY_START: f64 = 0.01;
/// The room type of what pipes run in.
const SHAFT: &str = "shaft";
/// Room types with pipes in their walls.
const WET: [&str; 6] = ["bathroom", "kitchen", "kitchen_dining", "kitchenette", "laundry", "toilet"];
/// Metres from the face of a wall up to which something is right behind it: the wall and its cladding.
const BEHIND: f64 = 0.6;
/// Walls that are looked at behind one.
const MOST_BEHIND: usize = 1024;
/// Metres that two walls must have in common to stand back to back: less holds no pipe.
const LEAST_SHARED: f64 = 0.1;
/// Cosine between the normals of walls that stand back to back.
const BACK_TO_BACK: f64 = -0.99;

/// Adds the automatic tags of every wall and sorts all tags.
pub(super) fn tag_walls(assembly: &mut Assembly<'_>, openings: &[Opening]) {
    for room in &mut assembly.rooms {
        tag_room(room, openings);
    }
    tag_pipes(&mut assembly.rooms);
}

/// Tags the walls of wet rooms behind which pipes run: those at a shaft; in rooms without one, those shared with
/// another wet room.
fn tag_pipes(rooms: &mut [Room]) {
    let is_wet = |room: &Room| WET.contains(&room.room_type.as_str());
    let places = WallIndex::of(rooms);
    let walls_of = |index: usize, counts: &dyn Fn(&Room) -> bool| -> Vec<usize> {
        let is_shared = |wall: &Wall| {
            let near = places.some_near(wall.segment(), BEHIND, MOST_BEHIND);
            let mut others = near.into_iter().filter(|far| far.room != index && counts(&rooms[far.room]));
            others.any(|far| stand_back_to_back(wall, &rooms[far.room].walls[far.wall]))
        };
        let walls = rooms[index].walls.iter().enumerate();
        walls.filter(|(_, wall)| is_shared(wall)).map(|(number, _)| number).collect()
    };
    let mut found = Vec::new();
    for index in (0..rooms.len()).filter(|&index| is_wet(&rooms[index])) {
        let at_shaft = walls_of(index, &|room| room.room_type == SHAFT);
        let walls = if at_shaft.is_empty() { walls_of(index, &is_wet) } else { at_shaft };
        found.extend(walls.into_iter().map(|wall| (index, wall)));
    }
    for (room, wall) in found {
        let tags = &mut rooms[room].walls[wall].tags;
        tags.push(PIPES_TAG.to_owned());
        tags.sort_unstable();
        tags.dedup();
    }
}

fn stand_back_to_back(wall: &Wall, other: &Wall) -> bool {
    let along = wall.direction();
    let depth = (wall.start - other.start).dot(wall.normal());
    let (a, b) = ((other.start - wall.start).dot(along), (other.end - wall.start).dot(along));
    let shared = a.max(b).min(wall.length()) - a.min(b).max(0.0);
    wall.normal().dot(other.normal()) < BACK_TO_BACK
        && (-RAY_START..BEHIND).contains(&depth)
        && shared >= LEAST_SHARED
}

fn tag_room(room: &mut Room, openings: &[Opening]) {
    let mut tags: Vec<Vec<&str>> = vec![Vec::new(); room.walls.len()];
    for (wall, tags) in room.walls.iter().zip(&mut tags) {
        tags.push(if wall.is_exterior { "exterior" } else { "interior" });
        if wall.kind != WallKind::Solid {
            tags.push("railing");
        }
    }
    for entry in &room.openings {
        let kind = openings[entry.opening].kind;
        tags[entry.wall].push(match kind {
            OpeningKind::Door | OpeningKind::SlidingDoor | OpeningKind::Passage => "door",
            OpeningKind::OpenBoundary => "open",
            OpeningKind::Window => "window",
        });
        if matches!(kind, OpeningKind::Door | OpeningKind::SlidingDoor | OpeningKind::Passage)
            && let Some(opposite) = opposite_wall(room, entry.wall, (entry.from + entry.to) / 2.0)
        {
            tags[opposite].push("opposite_door");
        }
    }
    let mut is_blind = vec![true; room.walls.len()];
    room.openings.iter().for_each(|entry| is_blind[entry.wall] = false);
    for (tags, _) in tags.iter_mut().zip(is_blind).filter(|(_, blind)| *blind) {
        tags.push("blind");
    }
    if let Some(longest) = longest_wall(room) {
        tags[longest].push("longest");
    }
    if let Some(end) = room.long_axis(openings).and_then(|axis| end_wall(room, axis.end)) {
        tags[end].push("end");
    }
    for (wall, tags) in room.walls.iter_mut().zip(tags) {
        wall.tags.extend(tags.into_iter().map(str::to_owned));
        wall.tags.sort_unstable();
        wall.tags.dedup();
    }
}

/// The first wall met straight ahead when one enters through a door.
fn opposite_wall(room: &Room, wall: usize, at: f64) -> Option<usize> {
    let entry = &room.walls[wall];
    let start = entry.after(at) + entry.normal() * RAY_START;
    let hits = room.walls.iter().enumerate().filter(|(index, _)| *index != wall);
    hits.filter_map(|(index, far)| Some((index, ray_hit(start, entry.normal(), far.segment())?)))
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .map(|(index, _)| index)
}

/// The wall at the end of the room's axis.
fn end_wall(room: &Room, end: Point) -> Option<usize> {
    let gaps = room.walls.iter().enumerate().map(|(index, wall)| (index, wall.segment().distance(end)));
    // The first of those that are as near, whatever the last digit says.
    gaps.reduce(|best, next| if next.1 < best.1 - CORNER_TOLERANCE { next } else { best })
        .map(|(index, _)| index)
}

fn longest_wall(room: &Room) -> Option<usize> {
    let lengths = room.walls.iter().enumerate().map(|(index, wall)| (index, wall.length()));
    // The first of equals.
    lengths.reduce(|best, next| if next.1 > best.1 { next } else { best }).map(|(index, _)| index)
}
