//! Leaves out rooms that are larger than any room, or farther away than any building reaches.

use super::Assembly;
use crate::geometry::{Bounds, Point, Polygon};
use crate::plan::inset::CenterRoom;
use crate::plan::limits::{LEVEL_REACH, LEVEL_ROOMS, STOREY_HEIGHT, median, mistaken_unit, room_excess};
use crate::plan::{LevelDraft, Problem, RoomDraft, Subject};

/// Reports a room that is too large or too high. Whether it is.
pub(super) fn refuse_excess(assembly: &mut Assembly<'_>, number: usize, outline: &Polygon) -> bool {
    let room = &assembly.draft.rooms[number];
    let side = outline.bounds().size().max_element();
    let (fact, allowed) = match (room_excess(outline), room.height) {
        (Some(excess), _) => (excess.fact, excess.allowed),
        (None, Some(height)) if height > STOREY_HEIGHT.1 => {
            (format!("is {height} m high"), format!("a room is at most {} m high", STOREY_HEIGHT.1))
        }
        _ => return false,
    };
    let unit = mistaken_unit(side).map(|unit| format!("; perhaps {unit}")).unwrap_or_default();
    let message = format!("room \"{}\" {fact}", room.id);
    assembly.excess_count += 1;
    assembly.problems.push(Problem::impossible(Subject::Room(number), message, &format!("{allowed}{unit}")));
    true
}

/// Leaves out the rooms behind the most that a level holds. The rest is read in the draft's order.
pub(super) fn refuse_surplus(draft: &LevelDraft, problems: &mut Vec<Problem>) {
    let count = draft.rooms.len();
    if count > LEVEL_ROOMS {
        let message =
            format!("the level has {count} rooms: those behind the first {LEVEL_ROOMS} were left out");
        problems.push(Problem::impossible(Subject::Level, message, "divide it into several levels"));
    }
}

/// Leaves out rooms that lie farther from the others than any building reaches. `borders` are in the order of
/// `assembly.sources`.
pub(super) fn refuse_far(assembly: &mut Assembly<'_>, borders: Vec<CenterRoom>) -> Vec<CenterRoom> {
    let middles: Vec<Point> = borders.iter().map(|room| middle(&room.ring.polygon)).collect();
    let center =
        Point::new(median(middles.iter().map(|point| point.x)), median(middles.iter().map(|point| point.y)));
    let is_near: Vec<bool> = middles.iter().map(|point| point.distance(center) <= LEVEL_REACH).collect();
    if is_near.iter().all(|&near| near) {
        return borders;
    }
    let sources = std::mem::take(&mut assembly.sources);
    for (place, &number) in sources.iter().enumerate() {
        if is_near[place] {
            assembly.sources.push(number);
        } else {
            let distance = middles[place].distance(center) / 1000.0;
            let id = &assembly.draft.rooms[number].id;
            let message = format!("room \"{id}\" lies {distance:.0} km from the other rooms of its level");
            let hint = format!("a level reaches {LEVEL_REACH} m from its middle; is a coordinate mistaken?");
            assembly.excess_count += 1;
            assembly.problems.push(Problem::impossible(Subject::Room(number), message, &hint));
        }
    }
    borders.into_iter().zip(is_near).filter_map(|(room, near)| near.then_some(room)).collect()
}

/// Whether most rooms of the level exceed the limits: then the unit is wrong, and those that seem right are not.
pub(super) fn is_hopeless(assembly: &mut Assembly<'_>) -> bool {
    let (wrong, all) = (assembly.excess_count, assembly.draft.rooms.len());
    if wrong * 2 <= all {
        return false;
    }
    // A level of one room says nothing more than that room's own fault.
    if all > 1 {
        let sides = assembly.draft.rooms.iter().map(side);
        let unit = mistaken_unit(median(sides)).map(|unit| format!(": perhaps {unit}")).unwrap_or_default();
        let message =
            format!("{wrong} of {all} rooms are too large, too high or too far away: none was read");
        let hint = format!("check the unit of length{unit}");
        assembly.problems.push(Problem::impossible(Subject::Level, message, &hint));
    }
    true
}

fn side(room: &RoomDraft) -> f64 {
    Bounds::around(room.outline.iter().copied()).size().max_element()
}

fn middle(outline: &Polygon) -> Point {
    outline.bounds().center()
}
