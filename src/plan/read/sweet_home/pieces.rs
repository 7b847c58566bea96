//! Furniture: stairs and free walls, which stay in the way, and what is kept on request.

use super::faces::Bodies;
use super::home::Piece;
use super::rooms::RoomIndex;
use crate::geometry::{Bounds, ring_contains, signed_area};
use crate::plan::{ObstacleDraft, RoomDraft};

/// Share of a room that stairs cover where it is their own: it is furnished as that.
const STAIRWELL_SHARE: f64 = 0.35;
/// Metres of the parapet around the opening above stairs.
const PARAPET: f64 = 0.9;
/// Metres of the widest piece that is taken for furniture; larger ones are gardens and streets.
const LARGEST_PIECE: f64 = 8.0;

/// The stairs that stand in rooms with other uses, as obstacles; `from_below` are those that come up through the floor.
pub(super) fn stairs(rooms: &[RoomDraft], pieces: &[&Piece], from_below: &[&Piece]) -> Vec<ObstacleDraft> {
    let index = RoomIndex::of(rooms);
    let is_in_the_way = |piece: &Piece| {
        let room = index.at(rooms, piece.center).map(|room| &rooms[room]);
        let covered = piece.size[0] * piece.size[1];
        room.is_some_and(|room| covered < STAIRWELL_SHARE * signed_area(&room.outline).abs())
    };
    let own = pieces.iter().map(|piece| (piece, Some(piece.size[2])));
    let risen = from_below.iter().map(|piece| (piece, Some(PARAPET)));
    own.chain(risen)
        .filter(|(piece, _)| piece.is_staircase && is_furniture(piece) && is_in_the_way(piece))
        .map(|(piece, height)| ObstacleDraft { outline: piece.corners(), height })
        .collect()
}

/// The walls that stand free in rooms, or reach into them, as obstacles.
pub(super) fn free_walls(rooms: &[RoomDraft], bodies: &Bodies<'_>) -> Vec<ObstacleDraft> {
    let index = RoomIndex::of(rooms);
    let stands_free = |body: &&super::walls::Body| {
        let middle = body.axis[body.axis.len() / 2 - 1].midpoint(body.axis[body.axis.len() / 2]);
        index
            .at(rooms, middle)
            .is_some_and(|room| !rooms[room].holes.iter().any(|hole| ring_contains(hole, middle)))
    };
    let free = bodies.all.iter().filter(stands_free);
    free.map(|body| ObstacleDraft { outline: body.outline.clone(), height: Some(body.heights[1]) }).collect()
}

/// Whether a piece is of a size that furniture has.
pub(super) fn is_furniture(piece: &Piece) -> bool {
    let [width, depth, height] = piece.size;
    let bounds = Bounds::around(piece.corners());
    width > 0.0 && depth > 0.0 && height > 0.0 && bounds.size().max_element() <= LARGEST_PIECE
}
