//! Drafts the rooms of a level: their outlines, ids and types.

use std::collections::BTreeSet;

use super::faces::Bodies;
use super::faults::Notes;
use super::home::{HomeRoom, Piece};
use crate::geometry::{Bounds, Point, ring_contains};
use crate::plan::assemble::BoxIndex;
use crate::plan::limits::LEVEL_ROOMS;
use crate::plan::read::foreign::{TypeOfWord, UniqueIds, number_rooms};
use crate::plan::read::room_names::{TypedNames, plain_words};
use crate::plan::read::walled::WalledArea;
use crate::plan::{RoomDraft, RoomWords};

/// Rooms of a level that are compared with its walls; larger levels are no homes.
const MOST_COMPARED: usize = 5_000;

/// The types of rooms; a place is a byte of the text.
pub(super) type Naming<'a> = TypedNames<'a, usize>;

/// The rooms of a level as they are drawn, cut back where they are drawn into the walls.
pub(super) fn drawn_rooms(
    rooms: &[&HomeRoom],
    bodies: &Bodies<'_>,
    naming: &mut Naming<'_>,
    notes: &mut Notes,
) -> Vec<RoomDraft> {
    let mut ids = UniqueIds::default();
    let is_compared = rooms.len() <= MOST_COMPARED && !bodies.are_tangled();
    let mut cut_count = 0;
    let mut first_cut = None;
    let mut drafts = Vec::new();
    for room in rooms.iter().take(LEVEL_ROOMS) {
        if room.outline.len() < 3 {
            let count = room.outline.len();
            notes.error(room.place, format!("a room has {count} corners"), "it is left out; draw it again");
            continue;
        }
        let cut = if is_compared { bodies.cut_back(&room.outline) } else { None };
        if cut.is_some() {
            cut_count += 1;
            first_cut = first_cut.or(Some(room.place));
        }
        let WalledArea { outline, holes } =
            cut.unwrap_or_else(|| WalledArea { outline: room.outline.clone(), holes: Vec::new() });
        let TypeOfWord { room_type, unknown_word } = naming.of_name(room.name.as_deref(), || room.place);
        // A name that people gave, else the id of the program that wrote the file.
        let own = room.id.as_deref().filter(|own| !own.is_empty() && !own.contains('/'));
        let id = ids.of_name(room.name.as_deref().unwrap_or_default(), own.unwrap_or("room"));
        let name = room.name.clone();
        drafts.push(RoomDraft { id, name, room_type, unknown_word, outline, holes, ..RoomDraft::default() });
    }
    if let Some(place) = first_cut {
        let rooms = if cut_count == 1 { "1 room is".to_owned() } else { format!("{cut_count} rooms are") };
        let message = format!("{rooms} drawn into the walls and cut back to their faces");
        notes.warn(
            place,
            message,
            "double-click between the walls with the tool for rooms to draw one that fits",
        );
    }
    number_rooms(&mut drafts);
    drafts
}

/// The areas that the walls of a level enclose, as rooms without a name.
pub(super) fn enclosed_rooms(bodies: &Bodies<'_>) -> Vec<RoomDraft> {
    let mut ids = UniqueIds::default();
    let rooms = bodies.enclosed().into_iter().map(|WalledArea { outline, holes }| {
        let TypeOfWord { room_type, unknown_word } = TypeOfWord::unknown("");
        let id = ids.numbered("room");
        RoomDraft { id, room_type, unknown_word, outline, holes, ..RoomDraft::default() }
    });
    let mut rooms: Vec<RoomDraft> = rooms.take(LEVEL_ROOMS).collect();
    number_rooms(&mut rooms);
    rooms
}

/// Notes in each room what stands in it, as far as guesses of its type ask for it.
pub(super) fn note_fixtures(rooms: &mut [RoomDraft], pieces: &[&Piece], words: &RoomWords) {
    let telling: BTreeSet<&str> =
        words.guesses.iter().flat_map(|rule| &rule.fixtures).map(String::as_str).collect();
    let index = RoomIndex::of(rooms);
    for piece in pieces.iter().filter(|piece| piece.cut.is_none()) {
        if let Some(room) = index.at(rooms, piece.center) {
            let words = words_of(piece).into_iter().filter(|word| telling.contains(word.as_str()));
            rooms[room].fixtures.extend(words);
        }
    }
}

/// The words of a piece: those of its name, which people translate, and of its id, which they do not.
fn words_of(piece: &Piece) -> BTreeSet<String> {
    let id = piece.catalog_id.as_deref().unwrap_or_default();
    let id = id.rsplit('#').next().unwrap_or_default();
    // `toiletUnit`, `bed140x190`
    let mut spaced = String::new();
    for letter in id.chars() {
        if letter.is_uppercase() || letter.is_numeric() {
            spaced.push(' ');
        }
        spaced.push(letter);
    }
    let mut words: BTreeSet<String> = plain_words(&spaced).into_iter().collect();
    words.extend(plain_words(&piece.name));
    if piece.is_staircase {
        words.insert("stairs".to_owned());
    }
    words
}

/// Rooms by place.
pub(super) struct RoomIndex(BoxIndex<usize>);

impl RoomIndex {
    pub(super) fn of(rooms: &[RoomDraft]) -> Self {
        let boxes = rooms.iter().map(|room| Bounds::around(room.outline.iter().copied()));
        Self(BoxIndex::of(boxes.zip(0..)))
    }

    /// The room in which a point lies; the first if rooms overlap.
    pub(super) fn at(&self, rooms: &[RoomDraft], point: Point) -> Option<usize> {
        /// Rooms drawn on each other that are looked at.
        const MOST_LAYERS: usize = 64;
        let mut near: Vec<usize> =
            self.0.meeting(Bounds::around_point(point, 0.0)).take(MOST_LAYERS).collect();
        near.sort_unstable();
        near.into_iter().find(|room| ring_contains(&rooms[*room].outline, point))
    }
}
