//! Doors that are moved or added once every room is reached: a second bath leads off a bedroom, a closed kitchen also leads to the
//! living room.

use std::collections::BTreeSet;

use crate::geometry::Segment;

use super::faces::Partition;
use super::links::{LEAST_BORDER, Link, inner_door};
use super::ring::area;

/// Of two baths of a dwelling, one leads off its largest bedroom that borders on one of them; the hall keeps the other.
pub(super) fn move_doors_of_suites(partition: &Partition<'_>, links: &mut Vec<Link>) {
    let &Partition { cells, typologies, .. } = partition;
    let mut done = BTreeSet::new();
    for cell in cells {
        let is_suite = typologies.rooms.get(&cell.room_type).is_some_and(|needs| !needs.suite_of.is_empty());
        if is_suite && done.insert((cell.unit, cell.room_type.as_str())) {
            let is_alike = |room: &usize| {
                (cells[*room].unit, cells[*room].room_type.as_str()) == (cell.unit, cell.room_type.as_str())
            };
            move_door(partition, &(0..cells.len()).filter(is_alike).collect::<Vec<_>>(), links);
        }
    }
}

/// Moves the door of one of the rooms of a type of a dwelling, if there are several.
fn move_door(partition: &Partition<'_>, alike: &[usize], links: &mut Vec<Link>) {
    let &Partition { cells, typologies, ref borders, .. } = partition;
    let is_in_suite = |room: usize| {
        let suite_of = &typologies.rooms[&cells[room].room_type].suite_of;
        let others = links.iter().filter_map(|link| link.other(room));
        others.into_iter().any(|other| suite_of.contains(&cells[other].room_type))
    };
    if alike.len() < 2 || alike.iter().any(|&room| is_in_suite(room)) {
        return;
    }
    let ways = alike.iter().flat_map(|&room| {
        let suite_of = &typologies.rooms[&cells[room].room_type].suite_of;
        let is_way = move |&&(to, border): &&(usize, Segment)| {
            cells[to].unit == cells[room].unit
                && suite_of.contains(&cells[to].room_type)
                && border.length() >= LEAST_BORDER
        };
        borders[room]
            .iter()
            .filter(is_way)
            .map(move |&(to, border)| (area(&cells[to].ring), room, to, border))
    });
    let Some((_, room, to, border)) = ways.reduce(|a, b| if b.0 > a.0 { b } else { a }) else { return };
    // Its only door: nobody comes through it to another room.
    let mut own = (0..links.len()).filter(|&index| links[index].joins(room));
    if let (Some(index), None) = (own.next(), own.next()) {
        links.remove(index);
        let door = inner_door(cells, (room, to), border, links);
        links.insert(index, door);
    }
}

/// Rooms that might lie open to another, and do not, have a door to it as well.
pub(super) fn add_second_doors(partition: &Partition<'_>, links: &mut Vec<Link>) {
    let &Partition { cells, typologies, ref borders, .. } = partition;
    for (room, cell) in cells.iter().enumerate() {
        let Some(needs) = typologies.rooms.get(&cell.room_type) else { continue };
        let is_way = |&&(to, border): &&(usize, Segment)| {
            cells[to].unit == cell.unit
                && needs.open_to.contains(&cells[to].room_type)
                && border.length() >= LEAST_BORDER
                && !links.iter().any(|link| link.joins(room) && link.joins(to))
        };
        let way = borders[room].iter().find(is_way).copied();
        if let Some((to, border)) = way {
            let door = inner_door(cells, (room, to), border, links);
            links.push(door);
        }
    }
}
