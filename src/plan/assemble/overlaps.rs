//! Finds rooms that overlap, and cuts a room that is drawn inside another out of it.

use std::collections::{BTreeMap, BTreeSet};

use geo::{Area, BooleanOps};

use super::{Assembly, BoxIndex};
use crate::geometry::{Bounds, Polygon};
use crate::plan::clean::{separate_holes, to_surface};
use crate::plan::inset::CenterRoom;
use crate::plan::{Problem, Subject};

/// Overlaps up to this many square metres are drawing noise: a corner that slipped by a few millimetres.
const LARGEST_SLIP: f64 = 0.02;
/// A room that lies in another with this share of its area is one drawn inside it.
const ENCLOSED_SHARE: f64 = 0.9;
/// Larger rooms whose boxes meet that of a room and which are compared with it: more of them are rooms drawn over each
/// other many times, for which all pairs would take hours.
const COMPARED: usize = 256;
/// Rooms of a level of which each is compared with all larger ones, without a tree: it is slower for so few.
const FEW_ROOMS: usize = 128;
/// Larger rooms on which a room is said to lie.
const REPORTED: usize = 8;

/// Cuts rooms that are drawn inside another out of it, with a warning.
///
/// `borders` are in the order of `assembly.sources`.
pub(super) fn cut_enclosed(assembly: &mut Assembly<'_>, borders: &mut [CenterRoom]) {
    let mut enclosed = overlaps(borders);
    enclosed.retain(|pair| pair.area >= borders[pair.small].ring.polygon.area() * ENCLOSED_SHARE);
    let mut larger: BTreeMap<usize, BTreeSet<usize>> = BTreeMap::new();
    let mut cuts: BTreeMap<usize, BTreeSet<usize>> = BTreeMap::new();
    for &Overlap { large, small, area } in &enclosed {
        larger.entry(small).or_default().insert(large);
        cuts.entry(large).or_default().insert(small);
        let source = assembly.sources[small];
        let id = |room: usize| &assembly.draft.rooms[assembly.sources[room]].id;
        let fact = format!("room \"{}\" lies on {area:.2} m² of room \"{}\"", id(small), id(large));
        let hint = Some("it was cut out of the other room");
        assembly.problems.push(Problem::warning(Subject::Room(source), fact, hint));
    }
    let outlines: BTreeMap<usize, Polygon> =
        larger.keys().map(|&room| (room, borders[room].ring.polygon.clone())).collect();
    for (room, rooms_in_it) in cuts {
        // A room inside one of these is cut out together with it.
        let goes_with_another = |small: &usize| !larger[small].is_disjoint(&rooms_in_it);
        let own = rooms_in_it.iter().filter(|small| !goes_with_another(small));
        let holes = borders[room].holes.iter().cloned().chain(own.map(|small| outlines[small].clone()));
        let cleaned = separate_holes(borders[room].ring.clone(), holes.collect());
        borders[room] = CenterRoom { ring: cleaned.ring, holes: cleaned.holes };
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

/// Two rooms, by index, and the square metres they share.
struct Overlap {
    large: usize,
    small: usize,
    area: f64,
}

/// The pairs of rooms that share floor, by the smaller and then the larger index; of each room those with larger ones,
/// [`REPORTED`] at most.
fn overlaps(borders: &[CenterRoom]) -> Vec<Overlap> {
    let floors: Vec<Floor<'_>> = borders.iter().map(Floor::of).collect();
    // From the largest on; of equals the first in the plan is taken to be the larger.
    let mut order: Vec<usize> = (0..borders.len()).collect();
    order.sort_by(|&a, &b| floors[b].area.total_cmp(&floors[a].area).then(a.cmp(&b)));
    let by_rooms = |pair: &Overlap| (pair.large.min(pair.small), pair.large.max(pair.small));
    if let Some(mut found) = few_overlaps(&floors, &order) {
        found.sort_by_key(by_rooms);
        return found;
    }
    let mut larger = BoxIndex::of(std::iter::empty());
    let mut found = Vec::new();
    for small in order {
        let bounds = floors[small].bounds;
        let overlap = |large: usize| Overlap::of(&floors, large, small);
        found.extend(larger.meeting(bounds).take(COMPARED).filter_map(overlap).take(REPORTED));
        larger.add(bounds, small);
    }
    found.sort_by_key(by_rooms);
    found
}

/// The overlaps of so few rooms, from the largest on, that each may be compared with all larger ones; `None` of more rooms, or where
/// not all overlaps are reported.
fn few_overlaps(floors: &[Floor<'_>], order: &[usize]) -> Option<Vec<Overlap>> {
    if order.len() > FEW_ROOMS {
        return None;
    }
    let mut found = Vec::new();
    for (place, &small) in order.iter().enumerate() {
        let before = found.len();
        let larger =
            order[..place].iter().filter(|&&large| floors[large].bounds.touches(floors[small].bounds));
        found.extend(larger.filter_map(|&large| Overlap::of(floors, large, small)));
        if found.len() - before > REPORTED {
            return None;
        }
    }
    Some(found)
}

impl Overlap {
    fn of(floors: &[Floor<'_>], large: usize, small: usize) -> Option<Self> {
        let area = floors[large.min(small)].shared_with(&floors[large.max(small)]);
        (area > LARGEST_SLIP).then_some(Self { large, small, area })
    }
}

/// A room to be compared with others.
struct Floor<'a> {
    room: &'a CenterRoom,
    /// Square metres of its outline.
    area: f64,
    bounds: Bounds,
    /// Its holes by place: a floor that is drawn around all rooms has one for each.
    holes: BoxIndex<usize>,
}

impl<'a> Floor<'a> {
    fn of(room: &'a CenterRoom) -> Self {
        let outline = &room.ring.polygon;
        let holes = BoxIndex::of(room.holes.iter().map(Polygon::bounds).zip(0..));
        Self { room, area: outline.area(), bounds: outline.bounds(), holes }
    }

    /// Square metres on which both lie.
    fn shared_with(&self, other: &Self) -> f64 {
        let size = self.bounds.high.min(other.bounds.high) - self.bounds.low.max(other.bounds.low);
        if size.min_element() <= 0.0 || size.x * size.y <= LARGEST_SLIP {
            return 0.0;
        }
        self.surface_within(other.bounds).intersection(&other.surface_within(self.bounds)).unsigned_area()
    }

    /// Its surface; holes that do not reach into a box are ignored.
    fn surface_within(&self, bounds: Bounds) -> geo::Polygon<f64> {
        let holes = self.holes.near(bounds).into_iter().map(|hole| self.room.holes[hole].clone());
        to_surface(&self.room.ring.polygon, &holes.collect::<Vec<Polygon>>())
    }
}
