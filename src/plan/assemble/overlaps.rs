//! Rooms that lie on each other.

use geo::{Area, BooleanOps};

use super::Assembly;
use crate::geometry::{Point, Polygon};
use crate::plan::clean::{separate_holes, to_surface};
use crate::plan::inset::CenterRoom;
use crate::plan::{Problem, Subject};

/// Overlaps up to this many square metres are drawing noise: a corner that slipped by a few millimetres.
const LARGEST_SLIP: f64 = 0.02;
/// A room that lies in another with this share of its area is one drawn inside it.
const ENCLOSED_SHARE: f64 = 0.9;

/// Cuts a room that is drawn inside another out of it, with a warning.
///
/// `borders` are in the order of `assembly.sources`.
pub(super) fn cut_enclosed(assembly: &mut Assembly<'_>, borders: &mut [CenterRoom]) {
    for overlap in overlaps(borders) {
        if overlap.area >= borders[overlap.small].ring.polygon.area() * ENCLOSED_SHARE {
            let hole = borders[overlap.small].ring.polygon.clone();
            cut(&mut borders[overlap.large], hole);
            let [inner, outer] = [overlap.small, overlap.large].map(|room| assembly.sources[room]);
            let id = |source: usize| &assembly.draft.rooms[source].id;
            let (small, large, area) = (id(inner), id(outer), overlap.area);
            let fact = format!("room \"{small}\" lies on {area:.2} m² of room \"{large}\"");
            let hint = Some("it was cut out of the other room");
            assembly.problems.push(Problem::warning(Subject::Room(inner), fact, hint));
        }
    }
}

/// Warns of every pair of rooms that share floor; they stay as they are.
pub(super) fn report_overlaps(assembly: &mut Assembly<'_>, borders: &[CenterRoom]) {
    for Overlap { large, small, area } in overlaps(borders) {
        let mut pair = [large, small].map(|room| assembly.sources[room]);
        pair.sort_unstable();
        let [first, second] = pair.map(|source| &assembly.draft.rooms[source].id);
        let fact = format!("rooms \"{first}\" and \"{second}\" share {area:.2} m² of floor");
        let hint = Some("move their outlines apart, or cut a hole");
        assembly.problems.push(Problem::warning(Subject::Room(pair[1]), fact, hint));
    }
}

fn cut(room: &mut CenterRoom, hole: Polygon) {
    let mut holes = room.holes.clone();
    holes.push(hole);
    let cleaned = separate_holes(room.ring.clone(), holes);
    *room = CenterRoom { ring: cleaned.ring, holes: cleaned.holes };
}

/// Two rooms, by index, and the square metres they share.
struct Overlap {
    large: usize,
    small: usize,
    area: f64,
}

/// All pairs of rooms that share floor, by the smaller and then the larger index.
fn overlaps(borders: &[CenterRoom]) -> Vec<Overlap> {
    let bounds: Vec<(Point, Point)> = borders.iter().map(|room| room.ring.polygon.bounds()).collect();
    let mut order: Vec<usize> = (0..borders.len()).collect();
    order.sort_by(|&a, &b| bounds[a].0.x.total_cmp(&bounds[b].0.x));
    let mut pairs = Vec::new();
    for (place, &room) in order.iter().enumerate() {
        // Sorted from west to east: nobody after the first that begins east of this room touches it.
        let reached = order[place + 1..].iter().take_while(|&&other| bounds[other].0.x < bounds[room].1.x);
        for &other in reached {
            let size = bounds[room].1.min(bounds[other].1) - bounds[room].0.max(bounds[other].0);
            if size.min_element() > 0.0 && size.x * size.y > LARGEST_SLIP {
                pairs.push((room.min(other), room.max(other)));
            }
        }
    }
    pairs.sort_unstable();
    let overlap = |(first, second): (usize, usize)| {
        let area = shared_area(&borders[first], &borders[second]);
        let is_first_larger = borders[first].ring.polygon.area() >= borders[second].ring.polygon.area();
        let (large, small) = if is_first_larger { (first, second) } else { (second, first) };
        (area > LARGEST_SLIP).then_some(Overlap { large, small, area })
    };
    pairs.into_iter().filter_map(overlap).collect()
}

fn shared_area(first: &CenterRoom, second: &CenterRoom) -> f64 {
    let surface = |room: &CenterRoom| to_surface(&room.ring.polygon, &room.holes);
    surface(first).intersection(&surface(second)).unsigned_area()
}
