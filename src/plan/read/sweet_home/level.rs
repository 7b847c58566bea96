//! Drafts the levels of a home.

use std::collections::BTreeMap;

use super::faces::Bodies;
use super::faults::Notes;
use super::home::{Home, HomeLevel, HomeRoom, HomeWall, Piece};
use super::openings::opening;
use super::pieces::{free_walls, stairs};
use super::rooms::{Naming, drawn_rooms, enclosed_rooms, note_fixtures};
use super::walls::{Body, bodies, usual_thicknesses};
use crate::document::counted;
use crate::geometry::Point;
use crate::plan::limits::STOREY_HEIGHT;
use crate::plan::read::foreign::UniqueIds;
use crate::plan::read::straight::straightened;
use crate::plan::{LevelDraft, OpeningPlace, OutlineKind, RoomDraft};

/// Metres of slabs in homes that say nothing of them.
const USUAL_FLOOR: f64 = 0.12;
/// Metres of outer and of inner walls on levels without a wall.
const USUAL_THICKNESSES: [f64; 2] = [0.2, 0.1];
/// Metres between two floors of which the upper stands on the lower.
const LOWEST_STOREY: f64 = 1.8;
/// Metres of the lowest ceiling: under a slope people stand where it is higher, and a lower one would leave rooms empty.
const LOWEST_CEILING: f64 = 2.0;
/// Walls of a level that are read: a home of 40 rooms has 150.
const MOST_WALLS: usize = 5_000;

/// A level with what stands on it.
pub(super) struct Storey<'a> {
    pub(super) level: HomeLevel,
    pub(super) id: String,
    rooms: Vec<&'a HomeRoom>,
    walls: Vec<&'a HomeWall>,
    pub(super) pieces: Vec<&'a Piece>,
}

/// The levels of a home, lowest first, with what belongs to each.
pub(super) fn storeys<'a>(home: &'a Home, notes: &mut Notes) -> Vec<Storey<'a>> {
    let mut levels = home.levels.clone();
    if levels.is_empty() {
        let floor_thickness = USUAL_FLOOR;
        let (id, name) = (String::new(), "Ground floor".to_owned());
        let height = home.wall_height;
        levels.push(HomeLevel { id, name, elevation: 0.0, floor_thickness, height, place: 0 });
    }
    // What names no level belongs to the first of the file.
    let first = levels[0].id.clone();
    levels.sort_by(|a, b| a.elevation.total_cmp(&b.elevation).then(a.place.cmp(&b.place)));
    for pair in levels.windows(2).filter(|pair| pair[0].elevation == pair[1].elevation) {
        let message = format!("levels \"{}\" and \"{}\" lie on the same height", pair[0].name, pair[1].name);
        notes.warn(pair[1].place, message, "both are read; delete one that is only a variant of the other");
    }
    let mut ids = UniqueIds::default();
    let mut storeys: Vec<Storey<'a>> = Vec::new();
    let mut numbers: BTreeMap<String, usize> = BTreeMap::new();
    for level in levels {
        numbers.entry(level.id.clone()).or_insert(storeys.len());
        let id = ids.of_name(&level.name, &format!("level_{}", storeys.len()));
        storeys.push(Storey { level, id, rooms: Vec::new(), walls: Vec::new(), pieces: Vec::new() });
    }
    let first = numbers[&first];
    let of = |level: &Option<String>| {
        level.as_ref().and_then(|level| numbers.get(level)).copied().unwrap_or(first)
    };
    home.rooms.iter().for_each(|room| storeys[of(&room.level)].rooms.push(room));
    home.walls.iter().for_each(|wall| storeys[of(&wall.level)].walls.push(wall));
    home.pieces.iter().for_each(|piece| storeys[of(&piece.level)].pieces.push(piece));
    storeys
}

/// Drafts the levels that have rooms.
pub(super) fn drafts(storeys: &[Storey<'_>], naming: &mut Naming<'_>, notes: &mut Notes) -> Vec<LevelDraft> {
    let drafted = storeys.iter().enumerate().map(|(number, storey)| {
        // Several variants of a level may lie on one height.
        let own = storey.level.elevation;
        let lower = storeys[..number].iter().map(|other| other.level.elevation).filter(|other| *other < own);
        let lower = lower.fold(f64::NEG_INFINITY, f64::max);
        let below = storeys[..number].iter().filter(|other| other.level.elevation == lower);
        let below: Vec<&Piece> = below.flat_map(|other| other.pieces.iter().copied()).collect();
        let above = storeys[number + 1..].iter().map(|other| other.level.elevation - own);
        let above = above.into_iter().find(|height| *height >= LOWEST_STOREY);
        storey.draft(above, &below, naming, notes)
    });
    let mut drafted: Vec<LevelDraft> = drafted.collect();
    drafted.retain(|level| !level.rooms.is_empty());
    drafted
}

impl Storey<'_> {
    /// `above` are the metres to the next floor, `below` what stands on the level below.
    fn draft(
        &self,
        above: Option<f64>,
        below: &[&Piece],
        naming: &mut Naming<'_>,
        notes: &mut Notes,
    ) -> LevelDraft {
        let level = &self.level;
        let walls = self.bounded_walls(notes);
        let all = bodies(&walls, level.height, notes);
        let bodies = Bodies::of(&all);
        let mut rooms = self.draft_rooms(&bodies, naming, notes);
        note_fixtures(&mut rooms, &self.pieces, naming.words);
        self.give_heights(&mut rooms, &all, notes);
        // Before outlines are made straight, which may leave the middle of a round wall inside.
        let obstacles = [stairs(&rooms, &self.pieces, below), free_walls(&rooms, &bodies)].concat();
        let openings = self.draft_openings(&mut rooms, &bodies);
        let [exterior_thickness, interior_thickness] = usual_thicknesses(&all).unwrap_or(USUAL_THICKNESSES);
        let outlines = |is_low: bool| {
            all.iter().filter(move |body| body.is_low() == is_low).map(|body| body.outline.clone()).collect()
        };
        LevelDraft {
            id: self.id.clone(),
            name: level.name.clone(),
            elevation: level.elevation,
            height: above.unwrap_or(level.height + level.floor_thickness),
            exterior_thickness,
            interior_thickness,
            outlines: OutlineKind::Inner,
            rooms,
            openings,
            obstacles,
            railings: outlines(true),
            wall_outlines: outlines(false),
        }
    }

    fn bounded_walls(&self, notes: &mut Notes) -> Vec<&HomeWall> {
        if let Some(excess) = self.walls.get(MOST_WALLS) {
            let message = format!("level \"{}\" has {} walls", self.level.name, self.walls.len());
            notes.error(excess.place, message, "the first 5000 are read; divide it into several levels");
        }
        self.walls.iter().take(MOST_WALLS).copied().collect()
    }

    fn draft_rooms(&self, bodies: &Bodies<'_>, naming: &mut Naming<'_>, notes: &mut Notes) -> Vec<RoomDraft> {
        let name = &self.level.name;
        let place = self.walls.first().map_or(self.level.place, |wall| wall.place);
        if !self.rooms.is_empty() {
            return drawn_rooms(&self.rooms, bodies, naming, notes);
        }
        if bodies.all.is_empty() {
            return Vec::new();
        }
        if bodies.are_tangled() {
            let message =
                format!("level \"{name}\" has no rooms, and more crossings of walls than any building");
            notes.error(place, message, "the level is left out; draw its rooms");
            return Vec::new();
        }
        let rooms = enclosed_rooms(bodies);
        if rooms.is_empty() {
            // A roof of walls, or a fence: the other levels are as sound as they were.
            let message = format!("level \"{name}\" has walls that enclose no room, and no room is drawn");
            notes.warn(place, message, "it is left out; join the ends of the walls, or draw the rooms");
        } else {
            let count = rooms.len();
            let message =
                format!("level \"{name}\" has no rooms: the {count} that its walls enclose are taken");
            notes.warn(
                place,
                message,
                "double-click between the walls with the tool for rooms, and name them",
            );
        }
        rooms
    }

    /// Rooms are as high as their level, those below sloping walls as high as the lower end of these.
    fn give_heights(&self, rooms: &mut [RoomDraft], bodies: &[Body], notes: &mut Notes) {
        let height = self.level.height.clamp(STOREY_HEIGHT.0, STOREY_HEIGHT.1);
        let sloping: Vec<&Body> = bodies.iter().filter(|body| body.heights[0] < body.heights[1]).collect();
        for room in rooms.iter_mut() {
            let lowest = sloping.iter().filter(|body| is_along(body, &room.outline));
            let lowest = lowest.map(|body| body.heights[0]).fold(height, f64::min);
            room.height = Some(lowest.max(LOWEST_CEILING.min(height)));
        }
        let low = rooms.iter().filter(|room| room.height.is_some_and(|own| own < height)).count();
        if low > 0 {
            let rooms = counted(low, "room");
            let message = format!(
                "level \"{}\": {rooms} with sloping walls, which are read as flat ones",
                self.level.name
            );
            let hint = "the ceiling is at the lower end of the walls, and 2 m high at least";
            notes.warn(self.level.place, message, hint);
        }
    }

    fn draft_openings(&self, rooms: &mut [RoomDraft], bodies: &Bodies<'_>) -> Vec<crate::plan::OpeningDraft> {
        let mut taken = UniqueIds::default();
        let mut drafts = Vec::new();
        for piece in &self.pieces {
            let Some(cut) = &piece.cut else { continue };
            let number = drafts.len() + 1;
            let own = piece.id.clone().unwrap_or_default();
            let Some(id) = taken.first_free([own, format!("opening_{number}")]) else { continue };
            let (draft, is_round) = opening(piece, cut, id, bodies);
            if let (true, OpeningPlace::Points { center, along: Some(along) }) = (is_round, &draft.place) {
                straighten(rooms, *center, *along, draft.width);
            }
            drafts.push(draft);
        }
        drafts
    }
}

/// Makes the outlines of rooms straight along an opening in a round wall.
fn straighten(rooms: &mut [RoomDraft], center: Point, along: Point, width: f64) {
    for room in rooms {
        for ring in std::iter::once(&mut room.outline).chain(&mut room.holes) {
            if let Some(straight) = straightened(ring, center, along, width) {
                *ring = straight;
            }
        }
    }
}

/// Whether a wall stands at the border of a room: at the side of its middle lies the room.
fn is_along(body: &Body, outline: &[Point]) -> bool {
    body.segments().any(|segment| {
        let reach = segment.normal() * (body.thickness / 2.0 + 0.05);
        [reach, -reach].iter().any(|by| crate::geometry::ring_contains(outline, segment.middle() + *by))
    })
}
