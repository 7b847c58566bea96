//! Turns a drafted level into a checked one: cleans outlines, builds walls and attaches openings, the same for every
//! format.

use std::collections::{BTreeMap, BTreeSet};

use super::attach::{
    NARROWEST_OPENING, Request, attach, attach_pieces, enlist, hang_leaves, open_boundaries, request,
};
use super::clean::to_simple;
use super::digest::level_digest;
use super::limits::{COORDINATE, LEVEL_OPENINGS, STOREY_HEIGHT, WALL_THICKNESS};
use super::{LeafDraft, Level, LevelDraft, Opening, OpeningKind, Problem, Room, Shared, Subject};

mod alike;
mod extents;
mod free;
mod index;
mod obstacles;
mod overlaps;
mod problems;
#[cfg(test)]
mod properties;
mod rooms;
#[cfg(test)]
mod scaling;
mod tags;
#[cfg(test)]
mod tests;
mod walls;

pub(super) use alike::Storeys;
use free::OpeningIds;
pub(super) use index::{BoxIndex, LooseIndex, OutlineIndex, WallIndex, WallPlace};

/// Metres from floor to floor where a draft names no usable height.
const USUAL_LEVEL_HEIGHT: f64 = 3.0;
/// Metres of slab between a ceiling and the floor above.
const SLAB_THICKNESS: f64 = 0.3;

/// A level being put together.
pub(super) struct Assembly<'a> {
    /// The draft, with invalid numbers replaced.
    pub(super) draft: &'a LevelDraft,
    /// The rooms so far.
    pub(super) rooms: Vec<Room>,
    /// Index into the draft's rooms, by room.
    pub(super) sources: Vec<usize>,
    /// Index into `rooms` by id, once they are there.
    pub(super) places: BTreeMap<&'a str, usize>,
    /// Ids of drafted rooms that were left out: what names them is left out too, without a word of its own.
    pub(super) left_out: BTreeSet<&'a str>,
    /// How many of them exceed the limits of [`super::limits`].
    pub(super) excess_count: usize,
    /// The problems found so far.
    pub(super) problems: Vec<Problem>,
}

impl<'a> Assembly<'a> {
    fn new(draft: &'a LevelDraft, problems: Vec<Problem>) -> Self {
        Self {
            draft,
            rooms: Vec::new(),
            sources: Vec::new(),
            places: BTreeMap::new(),
            left_out: BTreeSet::new(),
            excess_count: 0,
            problems,
        }
    }
}

/// Checks a drafted level and completes it; whatever is left out is named among the problems.
///
/// The level keeps the guarantees of [`super`] for any draft. Rooms and openings keep the draft's order; open
/// boundaries found between rooms come last. Problems come by step: level, rooms, columns, openings.
#[must_use]
pub fn assemble_level(mut draft: LevelDraft) -> (Level, Vec<Problem>) {
    let mut problems = Vec::new();
    check_level(&mut draft, &mut problems);
    let mut assembly = Assembly::new(&draft, problems);

    // Sound outlines, on the inner faces of the walls.
    rooms::build_rooms(&mut assembly);
    // The structure behind each wall.
    let solids = OutlineIndex::of(draft.wall_outlines.iter().filter_map(|ring| to_simple(ring)).collect());
    let railings = OutlineIndex::of(draft.railings.iter().filter_map(|ring| to_simple(ring)).collect());
    walls::back_walls(&mut assembly.rooms, &walls::Drawn { solids: &solids, railings: &railings }, &draft);
    // Columns before doors, so that no leaf is hung against one.
    let mut openings = Vec::new();
    // Where the unit is wrong no room is left, and nothing can be said about what belongs to one.
    if !assembly.rooms.is_empty() || assembly.excess_count == 0 {
        obstacles::place_obstacles(&mut assembly);
        openings = place_openings(&mut assembly, &solids);
    }
    tags::tag_walls(&mut assembly, &openings);

    let Assembly { mut rooms, problems, .. } = assembly;
    shrink(&mut rooms, &mut openings);
    let LevelDraft { id, name, elevation, height, .. } = draft;
    let name = if name.is_empty() { id.clone() } else { name };
    let mut level = Level {
        id,
        name,
        elevation,
        height,
        rooms: rooms.into(),
        openings: openings.into(),
        stairs: Shared::default(),
        left_out: Vec::new(),
        digest: [0; 32],
    };
    level.digest = level_digest(&level);
    (level, problems)
}

/// Gives back the spare memory of lists that grew: a city has millions of them.
fn shrink(rooms: &mut [Room], openings: &mut [Opening]) {
    for room in rooms {
        room.walls.shrink_to_fit();
        room.walls.iter_mut().for_each(|wall| wall.tags.shrink_to_fit());
        room.obstacles.shrink_to_fit();
        room.openings.shrink_to_fit();
    }
    for opening in openings {
        opening.leaves.shrink_to_fit();
        opening.sides.shrink_to_fit();
    }
}

/// Puts usable numbers in place of those that are none.
fn check_level(draft: &mut LevelDraft, problems: &mut Vec<Problem>) {
    let mut report = |message: String, hint: String| {
        problems.push(Problem::impossible(Subject::Level, message, &hint));
    };
    if !draft.elevation.is_finite() || draft.elevation.abs() > COORDINATE {
        let hint = format!("floors lie within {COORDINATE} m of the building's zero; 0 is taken");
        report(format!("elevation {} m is no place of a floor", draft.elevation), hint);
        draft.elevation = 0.0;
    }
    if !(STOREY_HEIGHT.0..=STOREY_HEIGHT.1).contains(&draft.height) {
        let (least, most) = STOREY_HEIGHT;
        let hint = format!("{least} to {most} m are possible; {USUAL_LEVEL_HEIGHT} m are taken");
        report(format!("height {} m from floor to floor", draft.height), hint);
        draft.height = USUAL_LEVEL_HEIGHT;
    }
    for (thickness, what) in
        [(&mut draft.exterior_thickness, "outer"), (&mut draft.interior_thickness, "inner")]
    {
        if !(WALL_THICKNESS.0..=WALL_THICKNESS.1).contains(thickness) {
            let (least, most) = WALL_THICKNESS;
            let hint = format!("{least} to {most} m are possible; walls without thickness are taken");
            report(format!("{what} walls are {thickness} m thick"), hint);
            *thickness = 0.0;
        }
    }
}

/// Attaches all openings and finds the open boundaries; the answer is in the draft's order.
fn place_openings(assembly: &mut Assembly<'_>, solids: &OutlineIndex) -> Vec<Opening> {
    let draft = assembly.draft;
    let index = WallIndex::of(&assembly.rooms);
    let mut ids = OpeningIds::default();
    let mut numbers: Vec<usize> = Vec::new();
    if draft.openings.len() > LEVEL_OPENINGS {
        let count = draft.openings.len();
        let message =
            format!("the level has {count} openings: those behind the first {LEVEL_OPENINGS} were left out");
        assembly.problems.push(Problem::impossible(Subject::Level, message, "divide it into several levels"));
    }
    for (number, opening) in draft.openings.iter().enumerate().take(LEVEL_OPENINGS) {
        if let Some(room) = opening.rooms.iter().find(|room| assembly.left_out.contains(room.as_str())) {
            assembly.problems.push(problems::of_lost_room(number, &opening.id, room));
            continue;
        }
        if opening.id.is_empty() || !ids.claim(&opening.id) {
            assembly.problems.push(problems::duplicate(Subject::Opening(number), "opening", &opening.id));
        } else {
            numbers.push(number);
        }
    }
    // Where a door and a window claim the same stretch of wall, the door has it.
    numbers.sort_by_key(|&number| (!draft.openings[number].kind.is_walkable(), number));
    let mut placed: Vec<(usize, Opening)> = Vec::new();
    for number in numbers {
        match place_opening(assembly, number, &index, &mut ids) {
            Ok(pieces) => placed.extend(pieces.into_iter().map(|piece| (number, piece))),
            Err(problem) => assembly.problems.push(problem),
        }
    }
    if !solids.is_empty() {
        for boundary in open_boundaries(&assembly.rooms, &index, solids) {
            // A door or window that is drawn there already takes its stretch; what is left may be too short.
            let opening = place_boundary(assembly, boundary, &index, &mut ids);
            placed.extend(opening.map(|opening| (draft.openings.len(), opening)));
        }
    }
    number_openings(assembly, placed)
}

fn place_opening(
    assembly: &mut Assembly<'_>,
    number: usize,
    index: &WallIndex,
    ids: &mut OpeningIds,
) -> Result<Vec<Opening>, Problem> {
    let draft = &assembly.draft.openings[number];
    let subject = Subject::Opening(number);
    let request = request(draft, assembly, index)
        .map_err(|(message, hint)| Problem::error(subject, message, hint.as_deref()))?;
    let mut pieces = attach_pieces(&request, &assembly.rooms, index)
        .map_err(|fault| problems::unattached(number, &request, &fault, &assembly.rooms))?;
    if let Some(high) = pieces.iter().find(|piece| piece.top - piece.bottom < NARROWEST_OPENING) {
        return Err(problems::above_ceiling(number, high));
    }
    if pieces.len() > 1 {
        assembly.problems.push(problems::cut_to_pieces(number, &request.id, pieces.len()));
    }
    for (copy, piece) in pieces.iter_mut().enumerate() {
        if copy > 0 {
            piece.id = ids.copy_of(&request.id);
        }
        piece.leaves = hang_leaves(piece, &assembly.rooms, &draft.leaf);
        enlist(piece, number, &mut assembly.rooms);
    }
    if let LeafDraft::Swing { into: Some(room), .. } = &draft.leaf
        && draft.kind == OpeningKind::Door
        && !pieces[0].sides.iter().any(|side| assembly.rooms[side.room].id == *room)
    {
        assembly.problems.push(problems::leaf_elsewhere(number, &request.id, room));
    }
    Ok(pieces)
}

fn place_boundary(
    assembly: &mut Assembly<'_>,
    mut boundary: Request,
    index: &WallIndex,
    ids: &mut OpeningIds,
) -> Option<Opening> {
    let opening = attach(&boundary, &assembly.rooms, index).ok()?;
    if !ids.claim(&boundary.id) {
        boundary.id = ids.copy_of(&boundary.id);
    }
    enlist(&opening, usize::MAX, &mut assembly.rooms);
    Some(Opening { id: boundary.id, ..opening })
}

/// Numbers the openings by the draft's order and fills the rooms' lists anew.
fn number_openings(assembly: &mut Assembly<'_>, mut placed: Vec<(usize, Opening)>) -> Vec<Opening> {
    placed.sort_by_key(|(number, _)| *number);
    let mut openings: Vec<Opening> = placed.into_iter().map(|(_, opening)| opening).collect();
    for room in &mut assembly.rooms {
        room.openings.clear();
    }
    for (number, opening) in openings.iter().enumerate() {
        enlist(opening, number, &mut assembly.rooms);
    }
    for (number, room) in assembly.rooms.iter_mut().enumerate() {
        part_neighbours(number, room, &mut openings);
    }
    openings
}

/// Two openings side by side share their end exactly, whatever the last digits say.
fn part_neighbours(number: usize, room: &mut Room, openings: &mut [Opening]) {
    for index in 1..room.openings.len() {
        let (before, entry) = (room.openings[index - 1], &mut room.openings[index]);
        if before.wall != entry.wall || before.to <= entry.from {
            continue;
        }
        entry.from = before.to;
        let sides = &mut openings[entry.opening].sides;
        for side in sides.iter_mut().filter(|side| side.room == number && side.wall == entry.wall) {
            side.from = before.to;
        }
    }
}
