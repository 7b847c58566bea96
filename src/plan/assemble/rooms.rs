//! Builds rooms with clean outlines along the inner faces of their walls.

use std::collections::BTreeSet;

use super::extents::{is_hopeless, refuse_excess, refuse_far, refuse_surplus};
use super::free::FreeNumbers;
use super::overlaps::{cut_enclosed, report_overlaps};
use super::walls::bare_walls;
use super::{Assembly, SLAB_THICKNESS, problems};
use crate::geometry::{Point, PolygonFault, Region};
use crate::plan::clean::{
    Ring, RingFault, SLIVER_AREA, clean_region, clean_ring, refuse_sliver, separate_holes, untangled,
};
use crate::plan::inset::{CenterRoom, inset_rooms};
use crate::plan::limits::{LEVEL_ROOMS, STOREY_HEIGHT};
use crate::plan::{OutlineKind, Problem, Room, RoomDraft, Subject};

/// Fills `assembly.rooms` and `assembly.sources` in the draft's order.
pub(super) fn build_rooms(assembly: &mut Assembly<'_>) {
    let draft = assembly.draft;
    let mut borders = sound_rooms(assembly);
    cut_enclosed(assembly, &mut borders);
    if draft.outlines == OutlineKind::Center {
        borders = inset_rooms(borders, draft.interior_thickness / 2.0);
        borders = borders.into_iter().map(separate).collect();
    }
    report_overlaps(assembly, &borders);
    let numbers = room_numbers(assembly);
    let sources = assembly.sources.clone();
    for ((border, &source), number) in borders.into_iter().zip(&sources).zip(numbers) {
        let room = build_room(assembly, source, border, number);
        assembly.places.insert(draft.rooms[source].id.as_str(), assembly.rooms.len());
        assembly.rooms.push(room);
    }
}

/// The rooms that can be, in the order of `assembly.sources`; all others are reported and left out.
fn sound_rooms(assembly: &mut Assembly<'_>) -> Vec<CenterRoom> {
    let draft = assembly.draft;
    let mut borders = Vec::new();
    let mut ids = BTreeSet::new();
    refuse_surplus(draft, &mut assembly.problems);
    for (number, room) in draft.rooms.iter().enumerate().take(LEVEL_ROOMS) {
        if room.id.is_empty() || !ids.insert(room.id.as_str()) {
            assembly.problems.push(problems::duplicate(Subject::Room(number), "room", &room.id));
        } else if let Some(sound) = sound_borders(assembly, number) {
            borders.push(sound);
            assembly.sources.push(number);
        }
    }
    borders = refuse_far(assembly, borders);
    if is_hopeless(assembly) {
        assembly.sources.clear();
        borders.clear();
    }
    let kept: BTreeSet<&str> = assembly.sources.iter().map(|&room| draft.rooms[room].id.as_str()).collect();
    let ids = draft.rooms.iter().map(|room| room.id.as_str());
    assembly.left_out = ids.filter(|id| !kept.contains(id)).collect();
    borders
}

/// Cleans outline and holes; `None` if no room remains.
fn sound_borders(assembly: &mut Assembly<'_>, number: usize) -> Option<CenterRoom> {
    let room = &assembly.draft.rooms[number];
    let ring =
        clean_ring(&room.outline, &edge_labels(room)).and_then(|ring| refuse_sliver(ring, SLIVER_AREA));
    let (ring, loops) = match ring {
        Ok(ring) => (ring, Vec::new()),
        Err(fault) => {
            let mended = mended(room, &fault);
            assembly.excess_count += usize::from(matches!(fault, RingFault::TooFar(..)));
            assembly.problems.push(match mended {
                Some(_) => problems::mended_outline(number, &room.id, &fault),
                None => problems::bad_outline(number, &room.id, &fault),
            });
            mended?
        }
    };
    if refuse_excess(assembly, number, &ring.polygon) {
        return None;
    }
    if !loops.is_empty() {
        // What becomes of the loops is part of the mending, and has no place in the plan.
        let cleaned = clean_region(ring, &[loops, room.holes.clone()].concat());
        return Some(CenterRoom { ring: cleaned.ring, holes: cleaned.holes });
    }
    let cleaned = clean_region(ring, &room.holes);
    let faults = cleaned.faults.iter().map(|fault| problems::hole(number, &room.id, fault));
    assembly.problems.extend(faults);
    Some(CenterRoom { ring: cleaned.ring, holes: cleaned.holes })
}

/// The ring and the loops of an outline that crosses itself a little. One whose edges have tags is not mended: they would get lost.
fn mended(room: &RoomDraft, fault: &RingFault) -> Option<(Ring, Vec<Vec<Point>>)> {
    let is_crossing = matches!(fault, RingFault::Polygon(PolygonFault::SelfCrossing(..)));
    if is_crossing && room.edge_tags.is_empty() { untangled(&room.outline) } else { None }
}

/// Edges with the same tags have the same label, edges without tags have label 0.
fn edge_labels(room: &RoomDraft) -> Vec<usize> {
    let mut kinds: Vec<BTreeSet<&str>> = vec![BTreeSet::new()];
    (0..room.outline.len())
        .map(|edge| {
            let tags = room.edge_tags.iter().filter(|(on, _)| *on == edge).map(|(_, tag)| tag.as_str());
            let tags: BTreeSet<&str> = tags.collect();
            kinds.iter().position(|known| *known == tags).unwrap_or_else(|| {
                kinds.push(tags);
                kinds.len() - 1
            })
        })
        .collect()
}

/// Moved borders may meet: holes are merged again.
fn separate(room: CenterRoom) -> CenterRoom {
    let cleaned = separate_holes(room.ring, room.holes);
    CenterRoom { ring: cleaned.ring, holes: cleaned.holes }
}

/// The drafted numbers, and for rooms without one their place in the draft or the next free number.
fn room_numbers(assembly: &mut Assembly<'_>) -> Vec<u32> {
    let draft = assembly.draft;
    let mut taken: BTreeSet<u32> = BTreeSet::new();
    let mut numbers: Vec<Option<u32>> = Vec::with_capacity(assembly.sources.len());
    for &source in &assembly.sources {
        let room = &draft.rooms[source];
        let number = room.number.filter(|&number| taken.insert(number));
        if let (Some(wanted), None) = (room.number, number) {
            assembly.problems.push(Problem::error(
                Subject::Room(source),
                format!("room \"{}\" has number {wanted}, which is taken", room.id),
                Some("numbers are unique in a level"),
            ));
        }
        numbers.push(number);
    }
    let mut free = FreeNumbers::beside(taken);
    let with_sources = numbers.into_iter().zip(&assembly.sources);
    let usual = |source: usize| u32::try_from(source).unwrap_or(u32::MAX).saturating_add(1);
    with_sources.map(|(number, &source)| number.unwrap_or_else(|| free.take(usual(source)))).collect()
}

fn build_room(assembly: &mut Assembly<'_>, source: usize, border: CenterRoom, number: u32) -> Room {
    let draft = &assembly.draft.rooms[source];
    let region = Region { outline: border.ring.polygon.clone(), holes: border.holes };
    let mut walls = bare_walls(&region);
    let tags = own_tags(draft, &border.ring);
    for (wall, tags) in walls.iter_mut().zip(tags) {
        wall.tags = tags;
    }
    let height = room_height(assembly, source);
    let draft = &assembly.draft.rooms[source];
    Room {
        id: draft.id.clone(),
        number,
        name: draft.name.clone(),
        room_type: draft.room_type.clone(),
        style: draft.style.clone(),
        dwelling: draft.dwelling.clone(),
        household: draft.household.clone(),
        home: None,
        region,
        height,
        walls,
        obstacles: Vec::new(),
        openings: Vec::new(),
    }
}

/// The drafted tags by edge of the cleaned outline.
fn own_tags(draft: &RoomDraft, ring: &Ring) -> Vec<Vec<String>> {
    let tags_of = |edge: &Option<usize>| {
        let own = draft.edge_tags.iter().filter(|(on, _)| Some(*on) == *edge);
        own.map(|(_, tag)| tag.clone()).collect()
    };
    ring.edges.iter().map(tags_of).collect()
}

fn room_height(assembly: &mut Assembly<'_>, source: usize) -> f64 {
    let draft = &assembly.draft.rooms[source];
    let usual = (assembly.draft.height - SLAB_THICKNESS).clamp(STOREY_HEIGHT.0, STOREY_HEIGHT.1);
    let Some(height) = draft.height else { return usual };
    // Too high ones are no rooms and left out before; what a drawing leaves too low is a room all the same.
    if (STOREY_HEIGHT.0..=STOREY_HEIGHT.1).contains(&height) {
        return height;
    }
    assembly.problems.push(Problem::error(
        Subject::Room(source),
        format!("room \"{}\" is {height} m high", draft.id),
        Some("rooms are 1 to 100 m high"),
    ));
    usual
}
