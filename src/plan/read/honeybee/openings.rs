//! Turns the holes in the edges of spaces into openings of their level, each once, and finds the rooms behind.

use std::collections::{BTreeMap, BTreeSet};

use super::model::{Edge, Hole, Place, Space, part};
use super::notes::{APART, NO_NEIGHBOUR, NO_WAY_IN, Notes, OVER_DOOR, STACKED, TINY};
use crate::geometry::{Bounds, Point, Segment};
use crate::plan::assemble::BoxIndex;
use crate::plan::limits::LEVEL_OPENINGS;
use crate::plan::{LeafDraft, OpeningDraft, OpeningKind, OpeningPlace, RoomDraft};

/// Metres between an edge and the room behind it: as far as openings reach.
const BESIDE: f64 = 0.6;
/// Edges that are looked at near one.
const MOST_NEAR: usize = 512;
/// Metres of the narrowest and the lowest opening.
const LEAST_OPENING: f64 = 0.1;
/// Metres by which windows in one wall may overlap: drawing noise.
const OVERLAP: f64 = 0.01;
/// Share of a window that a door below may take.
const DOOR_SHARE: f64 = 0.6;
/// Metres of the widest door with leaves; wider ones slide.
const WIDEST_DOOR: f64 = 2.4;
/// Metres of the widest window that is read as one.
const WIDEST_WINDOW: f64 = 20.0;
/// Pieces of a window.
const MOST_PIECES: f64 = 50.0;
/// Metres between the middles of an opening that both of its rooms state.
const SAME_PLACE: f64 = 0.05;
/// Room types into which nobody walks.
const CLOSED_TYPES: [&str; 2] = ["shaft", "void"];

/// All openings of a level; `rooms` are the drafts of its spaces.
pub(super) fn openings(spaces: &[Space], rooms: &[RoomDraft], notes: &mut Notes) -> Vec<OpeningDraft> {
    let mut level = Level::of(spaces, rooms);
    for (number, space) in spaces.iter().enumerate() {
        for edge in 0..space.edges.len() {
            level.add_edge(number, edge, notes);
        }
    }
    for (number, room) in rooms.iter().enumerate() {
        if !level.has_way_in[number] && !CLOSED_TYPES.contains(&room.room_type.as_str()) {
            notes.count(NO_WAY_IN, || spaces[number].place.clone());
        }
    }
    level.openings
}

struct Level<'a> {
    spaces: &'a [Space],
    rooms: &'a [RoomDraft],
    /// The identifiers of all spaces.
    names: BTreeSet<&'a str>,
    /// Number of the space, by edge.
    edges: BoxIndex<usize>,
    openings: Vec<OpeningDraft>,
    /// Where openings are already, in cells of [`SAME_PLACE`], with the room that states each.
    taken: BTreeMap<(i64, i64), usize>,
    has_way_in: Vec<bool>,
}

impl<'a> Level<'a> {
    fn of(spaces: &'a [Space], rooms: &'a [RoomDraft]) -> Self {
        let edges = spaces.iter().enumerate().flat_map(|(number, space)| {
            space.edges.iter().map(move |edge| (Segment::new(edge.start, edge.end).bounds(), number))
        });
        Self {
            spaces,
            rooms,
            names: spaces.iter().map(|space| space.identifier.as_str()).collect(),
            edges: BoxIndex::of(edges),
            openings: Vec::new(),
            taken: BTreeMap::new(),
            has_way_in: vec![false; spaces.len()],
        }
    }

    fn add_edge(&mut self, number: usize, edge_number: usize, notes: &mut Notes) {
        let space = &self.spaces[number];
        let edge = &space.edges[edge_number];
        let far = self.room_behind(number, edge, notes);
        if let (true, Some(other)) = (edge.is_open, far)
            && edge.length() >= LEAST_OPENING
        {
            let (bottom, top) = (0.0, space.height.min(self.spaces[other].height));
            let id = format!("open.{}.{}", space.id, edge_number + 1);
            let hole = Hole { id, is_door: true, from: 0.0, to: edge.length(), bottom, top };
            self.add(number, far, edge, (&hole, OpeningKind::OpenBoundary));
        }
        let place = || part(&space.place, []);
        for hole in tidied(&edge.holes, &place, notes) {
            let kind = match (hole.is_door, hole.width() > WIDEST_DOOR) {
                (false, _) => OpeningKind::Window,
                (true, false) => OpeningKind::Door,
                (true, true) => OpeningKind::SlidingDoor,
            };
            self.add(number, far, edge, (&hole, kind));
        }
    }

    /// The room behind an edge, if the file names one of this level that lies there.
    fn room_behind(&self, own: usize, edge: &Edge, notes: &mut Notes) -> Option<usize> {
        let name = edge.far.as_deref()?;
        let place = || self.spaces[own].place.clone();
        if name == self.spaces[own].identifier || !self.names.contains(name) {
            notes.count(NO_NEIGHBOUR, place);
            return None;
        }
        let middle = edge.start.midpoint(edge.end);
        let mut near = self.edges.meeting(Bounds::around_point(middle, BESIDE)).take(MOST_NEAR);
        let far = near.find(|&near| self.spaces[near].identifier == name);
        if far.is_none() {
            notes.count(APART, place);
        }
        far
    }

    fn add(&mut self, own: usize, far: Option<usize>, edge: &Edge, (hole, kind): (&Hole, OpeningKind)) {
        if kind.is_walkable() {
            [Some(own), far].into_iter().flatten().for_each(|room| self.has_way_in[room] = true);
        }
        let center = edge.at((hole.from + hole.to) / 2.0);
        // More than are read: the level says so.
        if self.openings.len() > LEVEL_OPENINGS || !self.take(own, center, edge) {
            return;
        }
        let rooms = [Some(own), far].into_iter().flatten().map(|room| self.rooms[room].id.clone()).collect();
        self.openings.push(OpeningDraft {
            id: hole.id.clone(),
            kind,
            place: OpeningPlace::Points { center, along: Some(edge.end - edge.start) },
            rooms,
            width: hole.width(),
            bottom: if kind == OpeningKind::Window { hole.bottom.max(0.0) } else { 0.0 },
            top: hole.top,
            leaf: LeafDraft::Automatic,
        });
    }

    /// Whether no other room states an opening at a place: both rooms at a wall say what is in it, also where they draw their own
    /// faces of a thick one.
    fn take(&mut self, own: usize, center: Point, edge: &Edge) -> bool {
        let across = (edge.end - edge.start).normalize_or_zero().perp() * SAME_PLACE;
        let cell = |place: Point| {
            let cell = (place / SAME_PLACE).round();
            (cell.x as i64, cell.y as i64)
        };
        let steps = (BESIDE / SAME_PLACE).ceil() as i32;
        let is_taken = (-steps..=steps).any(|step| {
            let (x, y) = cell(center + across * f64::from(step));
            let mut around = (-1..=1).flat_map(|east| (-1..=1).map(move |north| (east, north)));
            around.any(|(east, north)| {
                let beside = (x.saturating_add(east), y.saturating_add(north));
                self.taken.get(&beside).is_some_and(|room| *room != own)
            })
        });
        if !is_taken {
            self.taken.insert(cell(center), own);
        }
        !is_taken
    }
}

/// The holes of a wall that are side by side: windows above each other are one, and none is above a door.
fn tidied(holes: &[Hole], place: &dyn Fn() -> Place, notes: &mut Notes) -> Vec<Hole> {
    let mut sound: Vec<Hole> = Vec::with_capacity(holes.len());
    for hole in holes {
        let height = hole.top - hole.bottom.max(0.0);
        // Written so that NaN fails.
        if hole.width() >= LEAST_OPENING && height >= LEAST_OPENING {
            sound.push(hole.clone());
        } else {
            notes.count(TINY, place);
        }
    }
    sound.sort_by(|one, two| one.from.total_cmp(&two.from));
    let (doors, windows): (Vec<Hole>, Vec<Hole>) = sound.into_iter().partition(|hole| hole.is_door);
    let mut joined: Vec<Hole> = Vec::new();
    for window in windows {
        match joined.last_mut().filter(|last| window.from < last.to - OVERLAP) {
            Some(last) => {
                last.to = last.to.max(window.to);
                (last.bottom, last.top) = (last.bottom.min(window.bottom), last.top.max(window.top));
                notes.count(STACKED, place);
            }
            None => joined.push(window),
        }
    }
    let all = joined.len();
    joined.retain(|window| covered(window, &doors) < window.width() * DOOR_SHARE);
    (joined.len()..all).for_each(|_| notes.count(OVER_DOOR, place));
    [doors, joined].concat().into_iter().flat_map(in_pieces).collect()
}

/// A window that is longer than one may be, as windows side by side.
fn in_pieces(hole: Hole) -> Vec<Hole> {
    let count = (hole.width() / WIDEST_WINDOW).ceil();
    // Walls are at most a kilometre long; what is longer has a wrong unit, and is reported as it is.
    if hole.is_door || !(2.0..=MOST_PIECES).contains(&count) {
        return vec![hole];
    }
    let width = hole.width() / count;
    let piece = |number: usize| {
        let from = hole.from + width * number as f64;
        Hole { id: format!("{}.{}", hole.id, number + 1), from, to: from + width, ..hole.clone() }
    };
    (0..count as usize).map(piece).collect()
}

/// Metres of a window over doors, which are sorted by their beginnings; none overlaps the next much.
fn covered(window: &Hole, doors: &[Hole]) -> f64 {
    let behind = doors.partition_point(|door| door.from < window.to);
    let before = doors[..behind].iter().rev().take(MOST_NEAR);
    before.map(|door| (door.to.min(window.to) - door.from.max(window.from)).max(0.0)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Source;

    fn hole(is_door: bool, from: f64, to: f64, heights: (f64, f64)) -> Hole {
        let id = format!("{from}");
        Hole { id, is_door, from, to, bottom: heights.0, top: heights.1 }
    }

    #[test]
    fn windows_above_each_other_are_one_and_none_is_above_a_door() {
        let holes = [
            hole(false, 3.0, 4.0, (1.0, 2.0)),
            hole(false, 0.0, 1.0, (0.9, 1.6)),
            hole(false, 0.0, 1.2, (1.7, 2.4)),
            hole(true, 5.0, 6.0, (0.0, 2.1)),
            hole(false, 5.0, 6.0, (2.2, 2.6)),
            hole(false, 7.0, 7.05, (1.0, 2.0)),
            hole(false, 8.0, f64::NAN, (1.0, 2.0)),
        ];
        let mut notes = Notes::new(Source::new(std::path::Path::new("a.json"), "{}"));
        let tidied = tidied(&holes, &Vec::new, &mut notes);
        let expected = [
            hole(true, 5.0, 6.0, (0.0, 2.1)),
            hole(false, 0.0, 1.2, (0.9, 2.4)),
            hole(false, 3.0, 4.0, (1.0, 2.0)),
        ];
        assert_eq!(tidied, expected);
        let pieces = in_pieces(hole(false, 1.0, 61.5, (0.0, 1.0)));
        assert_eq!(pieces.len(), 4);
        assert_eq!((pieces[0].from, pieces[3].to, pieces[3].id.as_str()), (1.0, 61.5, "1.4"));
        let counts = [STACKED, OVER_DOOR, TINY].map(|topic| notes.counted(topic));
        assert_eq!(counts, [1, 1, 2]);
    }
}
