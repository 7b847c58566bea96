//! Rooms that lie on each other.

use geo::{Area, BooleanOps};

use super::Assembly;
use crate::geometry::{Point, Polygon, Region};
use crate::plan::clean::{separate_holes, to_surface};
use crate::plan::inset::CenterRoom;
use crate::plan::{Problem, Subject};

/// Overlaps below this many square metres are drawing noise.
const SMALLEST_OVERLAP: f64 = 0.05;
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

/// All pairs of rooms that share floor, by index.
fn overlaps(borders: &[CenterRoom]) -> Vec<Overlap> {
    let regions: Vec<Region> = borders
        .iter()
        .map(|room| Region { outline: room.ring.polygon.clone(), holes: room.holes.clone() })
        .collect();
    let bounds: Vec<(Point, Point)> = regions.iter().map(|region| region.outline.bounds()).collect();
    let mut found = Vec::new();
    for first in 0..regions.len() {
        for second in first + 1..regions.len() {
            let (low, high) = (bounds[first].0.max(bounds[second].0), bounds[first].1.min(bounds[second].1));
            let size = (high - low).max(Point::ZERO);
            let may_overlap = size.x * size.y >= SMALLEST_OVERLAP
                && (reaches_into(&regions[first], &regions[second])
                    || reaches_into(&regions[second], &regions[first]));
            let area = if may_overlap { shared_area(&regions[first], &regions[second]) } else { 0.0 };
            if area >= SMALLEST_OVERLAP {
                let is_first_larger = regions[first].outline.area() >= regions[second].outline.area();
                let (large, small) = if is_first_larger { (first, second) } else { (second, first) };
                found.push(Overlap { large, small, area });
            }
        }
    }
    found
}

/// A cheap look before the exact one: corners and middles of edges.
fn reaches_into(region: &Region, other: &Region) -> bool {
    let mut places = region.outline.edges().flat_map(|(a, b)| [a, a.midpoint(b)]);
    places.any(|place| other.contains(place))
}

fn shared_area(first: &Region, second: &Region) -> f64 {
    let first = to_surface(&first.outline, &first.holes);
    first.intersection(&to_surface(&second.outline, &second.holes)).unsigned_area()
}
