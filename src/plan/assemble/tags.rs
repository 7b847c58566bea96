//! Tags that walls carry by what they are (the paper's section 4), besides those of the plan.

use super::Assembly;
use super::walls::ray_hit;
use crate::plan::{Opening, OpeningKind, Room, WallKind};

/// Metres that a ray to the opposite wall starts inside the room.
const RAY_START: f64 = 0.01;

/// Adds the automatic tags of every wall and sorts all tags.
pub(super) fn tag_walls(assembly: &mut Assembly<'_>, openings: &[Opening]) {
    for room in &mut assembly.rooms {
        tag_room(room, openings);
    }
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
    for (index, tags) in tags.iter_mut().enumerate() {
        if !room.openings.iter().any(|entry| entry.wall == index) {
            tags.push("blind");
        }
    }
    if let Some(longest) = longest_wall(room) {
        tags[longest].push("longest");
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
    let start = entry.start + entry.direction() * at + entry.normal() * RAY_START;
    let hits = room.walls.iter().enumerate().filter(|(index, _)| *index != wall);
    hits.filter_map(|(index, far)| Some((index, ray_hit(start, entry.normal(), far.start, far.end)?)))
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .map(|(index, _)| index)
}

fn longest_wall(room: &Room) -> Option<usize> {
    let lengths = room.walls.iter().enumerate().map(|(index, wall)| (index, wall.length()));
    // The first of equals.
    lengths.reduce(|best, next| if next.1 > best.1 { next } else { best }).map(|(index, _)| index)
}
