//! The inner faces of rooms: what their walls leave for doors and windows once inner walls have their thickness.

use std::cell::OnceCell;

use crate::geometry::{Point, Segment};
use crate::plan::inner_faces;

use super::dwelling::Cell;
use super::facade::{EdgeClass, Span};
use super::ring::bounds;
use super::spine::Ground;
use super::typology::Typologies;

/// Metres of face that the narrowest door needs on both sides of its wall.
const LEAST_FACE: f64 = 0.76;
/// Two faces run beside each other where their directions differ by less than this from opposite ones (cosine of 2 degrees).
const OPPOSITE: f64 = -0.9994;
/// Metres by which two faces may be farther apart than an inner wall is thick, or overlap.
const SLACK: f64 = 0.04;

/// The rooms of a level, and the walls between them as they are built.
#[derive(Debug)]
pub(super) struct Partition<'a> {
    /// The rooms, on the middles of inner walls and the inner faces of outer ones.
    pub(super) cells: &'a [Cell],
    /// What the rooms need.
    pub(super) typologies: &'a Typologies,
    /// By room: its inner faces, with the room on their left.
    pub(super) faces: Vec<Vec<Segment>>,
    /// By room: the others that a door may lead to, with the longest piece of wall that both have, along the middle of it and with
    /// the first room on its left.
    pub(super) borders: Vec<Vec<(usize, Segment)>>,
    /// Metres of inner walls.
    thickness: f64,
    /// By room: what is wrong with its form, once it was looked at.
    form_faults: Vec<OnceCell<Option<String>>>,
}

impl<'a> Partition<'a> {
    /// Rooms with inner walls of some metres between them.
    pub(super) fn new(cells: &'a [Cell], typologies: &'a Typologies, thickness: f64) -> Self {
        let rings: Vec<&[Point]> = cells.iter().map(|cell| cell.ring.as_slice()).collect();
        let faces = inner_faces(&rings, thickness);
        let borders = borders(cells, &faces, thickness);
        let form_faults = vec![OnceCell::new(); cells.len()];
        Self { cells, typologies, faces, borders, thickness, form_faults }
    }

    /// What is wrong with the form of a room, by a function of its number, which is asked once: levels that are alike share it.
    pub(super) fn form_fault(&self, room: usize, find: impl FnOnce() -> Option<String>) -> Option<&str> {
        self.form_faults[room].get_or_init(find).as_deref()
    }

    /// Whether people may walk through a room.
    pub(super) fn is_passage(&self, room: usize) -> bool {
        self.typologies.rooms.get(&self.cells[room].room_type).is_some_and(|needs| needs.passage)
    }

    /// Metres of the gate that vehicles come into a room by, if they do.
    pub(super) fn gate(&self, room: usize) -> Option<f64> {
        self.typologies.rooms.get(&self.cells[room].room_type)?.gate
    }

    /// Whether all may walk through a room: it is of no dwelling.
    pub(super) fn is_public(&self, room: usize) -> bool {
        self.cells[room].unit.is_none() && self.is_passage(room)
    }

    /// The pieces of a room's faces that light may come through.
    pub(super) fn light(&self, ground: &Ground, room: usize) -> Vec<Segment> {
        self.behind(ground, room, |span| span.class.is_free())
    }

    /// The pieces of a room's faces with so many metres of open air before them.
    pub(super) fn open_air(&self, ground: &Ground, room: usize, sight: f64) -> Vec<Segment> {
        self.behind(ground, room, |span| span.class.is_free() && span.sight >= sight)
    }

    /// The pieces of a room's faces at the street.
    pub(super) fn street(&self, ground: &Ground, room: usize) -> Vec<Segment> {
        self.behind(ground, room, |span| span.class == EdgeClass::Street)
    }

    fn behind(&self, ground: &Ground, room: usize, is_wanted: impl Fn(&Span) -> bool) -> Vec<Segment> {
        // A wall that is partly an inner one has one face, which is half an inner wall deeper.
        let depths = (ground.wall, ground.wall + 0.5 * self.thickness);
        let faces = self.faces[room].iter();
        let before = faces.flat_map(|&face| ground.facade.before(face, depths));
        before.filter(|(span, _)| is_wanted(span)).map(|(_, piece)| piece).collect()
    }
}

fn borders(cells: &[Cell], faces: &[Vec<Segment>], thickness: f64) -> Vec<Vec<(usize, Segment)>> {
    let boxes: Vec<_> = cells.iter().map(|cell| bounds(&cell.ring).inflated(0.01)).collect();
    let mut borders = vec![Vec::new(); cells.len()];
    for first in 0..cells.len() {
        for second in first + 1..cells.len() {
            if !boxes[first].touches(boxes[second]) {
                continue;
            }
            let border = longest_between(&faces[first], &faces[second], thickness);
            if let Some(border) = border.filter(|border| border.length() >= LEAST_FACE) {
                borders[first].push((second, border));
                borders[second].push((first, border.reversed()));
            }
        }
    }
    borders
}

/// The longest piece of wall between two rooms: from the one on its left to the other.
fn longest_between(left: &[Segment], right: &[Segment], thickness: f64) -> Option<Segment> {
    let pairs = left.iter().flat_map(|face| right.iter().map(move |other| (*face, *other)));
    let pieces = pairs.filter_map(|(face, other)| between(face, other, thickness));
    pieces.reduce(|a, b| if b.length() > a.length() + 1e-9 { b } else { a })
}

/// What two faces have in common, in the middle between them.
fn between(face: Segment, other: Segment, thickness: f64) -> Option<Segment> {
    let direction = face.direction();
    if direction.dot(other.direction()) > OPPOSITE {
        return None;
    }
    let gap = -face.normal().dot(other.middle() - face.start);
    if !(-SLACK..=thickness + SLACK).contains(&gap) {
        return None;
    }
    let low = (other.end - face.start).dot(direction).max(0.0);
    let high = (other.start - face.start).dot(direction).min(face.length());
    let at = |place: f64| face.start + direction * place - face.normal() * (0.5 * gap);
    (high > low).then(|| Segment::new(at(low), at(high)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cell<const N: usize>(corners: [(f64, f64); N]) -> Cell {
        Cell::shared(corners.map(Point::from).into(), "room")
    }

    #[test]
    fn a_wall_holds_a_door_as_far_as_both_rooms_see_it() {
        // The left room's wall goes on behind the upper right one.
        let cells = [
            cell([(0., 0.), (3., 0.), (3., 5.), (0., 5.)]),
            cell([(3., 0.), (6., 0.), (6., 2.), (3., 2.)]),
            cell([(3., 2.), (6., 2.), (6., 5.), (3., 5.)]),
        ];
        let typologies = Typologies::default();
        let level = Partition::new(&cells, &typologies, 0.2);
        let (_, border) = level.borders[0][0];
        assert!((border.length() - 1.9).abs() < 1e-9 && (border.middle().x - 3.0).abs() < 1e-9, "{border:?}");
        assert_eq!(level.borders[1].iter().map(|(room, _)| *room).collect::<Vec<_>>(), [0, 2]);
    }

    #[test]
    fn what_is_too_short_for_a_door_is_no_border() {
        let cells = [
            cell([(0., 0.), (3., 0.), (3., 5.), (0., 5.)]),
            cell([(3., 0.), (6., 0.), (6., 0.9), (3., 0.9)]),
            cell([(3., 0.9), (6., 0.9), (6., 5.), (3., 5.)]),
        ];
        let typologies = Typologies::default();
        assert_eq!(Partition::new(&cells, &typologies, 0.1).borders[0].len(), 2);
        assert_eq!(Partition::new(&cells, &typologies, 0.3).borders[0].len(), 1);
    }
}
