//! Drafts the levels of a building from its storeys.

use std::collections::BTreeMap;

use super::model::{Space, Storey, part};
use super::notes::{Notes, STEPPED};
use super::openings::openings;
use super::room_types::{Naming, type_of};
use crate::plan::limits::{BUILDING_LEVELS, BUILDING_ROOMS, LEVEL_OPENINGS};
use crate::plan::read::foreign::{TypeOfWord, UniqueIds, number_rooms};
use crate::plan::{LevelDraft, OutlineKind, RoomDraft};

/// Metres of walls to the open air; models draw their inner faces, and give them layers instead of a thickness.
const EXTERIOR_THICKNESS: f64 = 0.25;
/// Metres of slabs where a model says nothing of the next floor.
const USUAL_FLOOR: f64 = 0.3;
/// Metres from a floor to one that lies above it.
const LOWEST_STOREY: f64 = 1.8;
/// How often a storey stands on itself at most: the highest towers have 163 storeys.
const MOST_REPEATED: usize = 200;
/// Corners of all rooms of a building.
const MOST_CORNERS: usize = 2_000_000;
/// Metres by which floors of a storey may differ and count as level.
const LEVEL: f64 = 0.02;

/// The levels of a building, lowest first; equal storeys are repeated.
pub(super) fn drafts(
    mut storeys: Vec<Storey>,
    naming: &mut Naming<'_>,
    notes: &mut Notes,
) -> Vec<LevelDraft> {
    storeys.retain(|storey| !storey.spaces.is_empty());
    storeys.sort_by(|one, two| usual_floor(&one.spaces).total_cmp(&usual_floor(&two.spaces)));
    let elevations: Vec<f64> = storeys.iter().map(|storey| usual_floor(&storey.spaces)).collect();
    let mut building = Building {
        ids: UniqueIds::default(),
        levels: Vec::new(),
        room_count: 0,
        opening_count: 0,
        corner_count: 0,
    };
    for (number, storey) in storeys.iter().enumerate() {
        let above =
            elevations.get(number + 1).map(|above| (above - elevations[number]) / storey.repeat as f64);
        let draft = draft(storey, above, naming, notes);
        building.add(storey, draft, notes);
    }
    building.levels
}

struct Building {
    ids: UniqueIds,
    levels: Vec<LevelDraft>,
    room_count: usize,
    opening_count: usize,
    corner_count: usize,
}

impl Building {
    /// Adds a storey as often as it stands there.
    fn add(&mut self, storey: &Storey, draft: LevelDraft, notes: &mut Notes) {
        let rings = draft.rooms.iter().flat_map(|room| room.holes.iter().chain([&room.outline]));
        let corner_count: usize = rings.map(Vec::len).sum();
        for copy in 0..storey.repeat {
            let rooms = self.room_count + draft.rooms.len();
            let openings = self.opening_count + draft.openings.len();
            self.corner_count = self.corner_count.saturating_add(corner_count);
            // A first copy is read in any case: what is too much of it is reported as a level's.
            let is_excess = rooms > BUILDING_ROOMS
                || openings > LEVEL_OPENINGS
                || self.corner_count > MOST_CORNERS
                || copy >= MOST_REPEATED;
            if (is_excess && copy > 0) || self.levels.len() >= BUILDING_LEVELS {
                let message =
                    format!("storey \"{}\": {} levels are left out", storey.name, storey.repeat - copy);
                let hint = format!("a storey stands on itself {MOST_REPEATED} times at most");
                notes.error(&part(&storey.place, ["multiplier".into()]), message, &hint);
                return;
            }
            (self.room_count, self.opening_count) = (rooms, openings);
            let name = if copy == 0 { draft.name.clone() } else { format!("{} ({})", draft.name, copy + 1) };
            let elevation = draft.elevation + draft.height * copy as f64;
            let id = self.ids.of_name(&storey.name, "level");
            self.levels.push(LevelDraft { id, name, elevation, ..draft.clone() });
        }
    }
}

/// The height on which most floors of a storey lie, the lowest of equals. Metres.
fn usual_floor(spaces: &[Space]) -> f64 {
    let mut counts: BTreeMap<i64, (usize, f64)> = BTreeMap::new();
    for space in spaces {
        counts.entry((space.floor / LEVEL).round() as i64).or_insert((0, space.floor)).0 += 1;
    }
    let most = counts.into_values().reduce(|best, next| if next.0 > best.0 { next } else { best });
    most.map_or(0.0, |(_, floor)| floor)
}

/// The lowest of the levels that a storey is; `above` are the metres to the next floor.
fn draft(storey: &Storey, above: Option<f64>, naming: &mut Naming<'_>, notes: &mut Notes) -> LevelDraft {
    let spaces = &storey.spaces;
    let elevation = usual_floor(spaces);
    for space in spaces.iter().filter(|space| (space.floor - elevation).abs() > LEVEL) {
        notes.count(STEPPED, || space.place.clone());
    }
    let highest = spaces.iter().map(|space| space.height).fold(0.0, f64::max);
    let is_storey = |height: &f64| *height >= LOWEST_STOREY;
    let height = storey.height.filter(is_storey).or(above.filter(is_storey));
    let mut room = |space: &Space| {
        let TypeOfWord { room_type, unknown_word } = type_of(space, naming);
        RoomDraft {
            id: space.id.replace('/', "_"),
            name: space.name.clone(),
            room_type,
            unknown_word,
            outline: space.outline.clone(),
            holes: space.holes.clone(),
            height: Some(space.height),
            ..RoomDraft::default()
        }
    };
    let mut rooms: Vec<RoomDraft> = spaces.iter().map(&mut room).collect();
    number_rooms(&mut rooms);
    LevelDraft {
        name: storey.name.clone(),
        elevation,
        height: height.unwrap_or(highest + USUAL_FLOOR),
        exterior_thickness: EXTERIOR_THICKNESS,
        // Floors of models reach to each other: with walls between them, they would have less area than the model says.
        outlines: OutlineKind::Inner,
        openings: openings(spaces, &rooms, notes),
        rooms,
        ..LevelDraft::default()
    }
}
