//! Finds the rooms above and below a room.

use std::collections::BTreeSet;

use crate::geometry::{Bounds, Point};
use crate::plan::assemble::BoxIndex;
use crate::plan::{BuildingDraft, LevelDraft};

/// Share of the ground that two rooms, taken as boxes, cover together which both cover, if they are at the same place.
const SAME_PLACE: f64 = 0.6;
/// Rooms looked at around the middle of another; more lie there only where rooms are drawn upon each other.
const MOST_MET: usize = 64;

/// The rooms with known words of the levels of a building.
#[derive(Default)]
pub(super) struct Stack(Vec<KnownRooms>);

/// Those of a level.
struct KnownRooms {
    rooms: Vec<(Bounds, String)>,
    places: BoxIndex<usize>,
}

impl Stack {
    pub(super) fn of(draft: &BuildingDraft) -> Self {
        Self(draft.levels.iter().map(KnownRooms::of).collect())
    }

    /// Types of the known rooms at the place of an outline on the levels next to a level.
    pub(super) fn types_at(&self, level: usize, outline: &[Point]) -> BTreeSet<&str> {
        let Some(place) = box_of(outline) else { return BTreeSet::new() };
        let levels = [level.checked_sub(1), level.checked_add(1)].into_iter().flatten();
        levels.filter_map(|next| self.0.get(next)).flat_map(|known| known.types_at(place)).collect()
    }
}

impl KnownRooms {
    fn of(level: &LevelDraft) -> Self {
        let known = level.rooms.iter().filter(|room| room.unknown_word.is_none());
        let rooms: Vec<(Bounds, String)> =
            known.filter_map(|room| Some((box_of(&room.outline)?, room.room_type.clone()))).collect();
        let places = BoxIndex::of(rooms.iter().map(|(bounds, _)| *bounds).zip(0..));
        Self { rooms, places }
    }

    fn types_at(&self, place: Bounds) -> impl Iterator<Item = &str> {
        // A box that covers more than half of another holds its middle.
        let middle = place.center();
        let met =
            self.places.meeting(Bounds::around([middle])).take(MOST_MET).map(|number| &self.rooms[number]);
        met.filter(move |(other, _)| is_same_place(*other, place)).map(|(_, kind)| kind.as_str())
    }
}

fn box_of(outline: &[Point]) -> Option<Bounds> {
    (!outline.is_empty()).then(|| Bounds::around(outline.iter().copied()))
}

fn is_same_place(a: Bounds, b: Bounds) -> bool {
    let area = |bounds: Bounds| bounds.size().max(Point::ZERO).element_product();
    let both = area(Bounds::new(a.low.max(b.low), a.high.min(b.high)));
    both > SAME_PLACE * (area(a) + area(b) - both)
}
