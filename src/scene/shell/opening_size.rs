//! The height of an opening in the wall, and the width of the boards around it.

use super::SLAB;
use super::ticks::Ticks;
use crate::plan::{Level, Opening, OpeningKind, OpeningSide, WallKind};

/// Metres of the boards around a doorway, and the narrowest ones.
const CASING: f64 = 0.06;
const LEAST_CASING: f64 = 0.02;
/// Metres that the boards keep from the corners of a room.
const CORNER: f64 = 0.015;

/// Lower and upper edge of the hole of an opening. Where one walks, the hole goes through the floor's
/// thickness too and the threshold fills it; an open boundary ends at the lower of the two ceilings.
pub(super) fn opening_heights(level: &Level, opening: &Opening) -> (Ticks, Ticks) {
    let bottom = Ticks::of(opening.bottom);
    let low = if opening.kind.is_walkable() && bottom <= Ticks(0) { -SLAB } else { bottom };
    let ceilings = opening.sides.iter().map(|side| level.rooms[side.room].height);
    let lowest = Ticks::of(ceilings.fold(f64::INFINITY, f64::min));
    let high = match opening.kind {
        OpeningKind::OpenBoundary => lowest,
        _ => Ticks::of(opening.top).min(lowest),
    };
    (low, high)
}

/// Width of the boards around a doorway: less where a corner, another opening or the ceiling is near, zero where
/// there is next to no room for them.
pub(super) fn casing(level: &Level, opening: &Opening) -> Ticks {
    let is_framed =
        matches!(opening.kind, OpeningKind::Door | OpeningKind::SlidingDoor | OpeningKind::Passage);
    if !is_framed || opening.sides.is_empty() {
        return Ticks(0);
    }
    let clear = opening.sides.iter().map(|side| clear_beside(level, opening, side)).fold(CASING, f64::min);
    if clear < LEAST_CASING { Ticks(0) } else { Ticks::of(clear) }
}

/// Metres of wall beside and above an opening in one room; half of them to the next opening.
fn clear_beside(level: &Level, opening: &Opening, side: &OpeningSide) -> f64 {
    let room = &level.rooms[side.room];
    let wall = &room.walls[side.wall];
    if wall.kind != WallKind::Solid {
        return 0.0;
    }
    let places = room.openings.iter().filter(|place| place.wall == side.wall);
    let others = places.filter(|place| (place.from, place.to) != (side.from, side.to));
    let beside = others.map(|other| (other.from - side.to).max(side.from - other.to) / 2.0);
    // The casing of a door in the next wall stands out as far as this one does.
    let to_ends = side.from.min(wall.length() - side.to) - CORNER;
    beside.fold(to_ends.min(room.height - opening.top), f64::min)
}
