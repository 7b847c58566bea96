//! Which rooms are near: the ways that one walks through openings and on stairs.

use std::collections::BTreeMap;

use super::graph::{BuildingGraph, Place};
use super::sight::rooms_at;
use crate::geometry::Point;
use crate::plan::Building;

/// Metres that stairs from one level to the next count as.
pub(crate) const STAIRS: f64 = 4.0;
/// Openings that are walked through at most, so that the time has a bound in every building.
const MOST_OPENINGS: usize = 1024;

/// The rooms that one reaches within a distance, with the metres to where one enters them.
///
/// The ways go straight from opening to opening, through walls of the same room and furniture too: they are never longer than those
/// that one walks.
pub(crate) fn near(
    graph: &BuildingGraph,
    building: &Building,
    (level, position): (usize, Point),
    reach: f64,
) -> BTreeMap<Place, f64> {
    let mut nearest: BTreeMap<Place, f64> = BTreeMap::new();
    let mut open: Vec<Way> = rooms_at(graph, building, level, position)
        .into_iter()
        .map(|room| Way { metres: 0.0, place: Place { level, room }, entry: position })
        .collect();
    let mut walked = 0;
    while let Some(way) = take_shortest(&mut open) {
        let known = nearest.entry(way.place).or_insert(f64::INFINITY);
        // The first way into a room is the shortest; others may be shorter to openings on its far side, but by less than the room.
        if way.metres >= *known || walked >= MOST_OPENINGS {
            continue;
        }
        *known = way.metres;
        walked += 1;
        let cell = graph.cell(way.place);
        for portal in cell.portals.iter().filter(|portal| portal.is_walkable) {
            let Some(behind) = portal.behind else { continue };
            let entry = behind.face.nearest(way.entry);
            let metres = way.metres + way.entry.distance(entry);
            if metres <= reach {
                open.push(Way { metres, place: Place { room: behind.room, ..way.place }, entry });
            }
        }
        let metres = way.metres + STAIRS;
        if metres <= reach {
            open.extend(cell.joined.iter().map(|&place| Way { metres, place, entry: way.entry }));
        }
    }
    nearest
}

/// A way into a room.
struct Way {
    metres: f64,
    place: Place,
    entry: Point,
}

fn take_shortest(open: &mut Vec<Way>) -> Option<Way> {
    let shortest = open.iter().enumerate().min_by(|(_, one), (_, other)| one.metres.total_cmp(&other.metres));
    let index = shortest.map(|(index, _)| index)?;
    Some(open.swap_remove(index))
}
