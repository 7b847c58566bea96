//! Drafts the level of a plan.

use std::collections::BTreeMap;

use geo::algorithm::buffer::{BufferStyle, LineJoin};
use geo::{Area, Buffer};

use super::geometry::Shapes;
use super::notes::{NAME, Notes, Place};
use super::sheet::Sheet;
use crate::document::counted;
use crate::geometry::Point;
use crate::plan::clean::{ring_surface, to_points};
use crate::plan::limits::{LEVEL_OPENINGS, LEVEL_ROOMS, OUTLINE_CORNERS, is_place};
use crate::plan::read::archilyse::areas::Outline;
use crate::plan::read::foreign::{TypeOfWord, WIDEST_LEAF};
use crate::plan::read::native::number_of_id;
use crate::plan::read::oriented::Oriented;
use crate::plan::read::solids::solid_pieces;
use crate::plan::{
    LeafDraft, LevelDraft, OpeningDraft, OpeningKind, OpeningPlace, OutlineKind, RoomDraft, RoomWords,
};

/// Metres from floor to ceiling and from floor to floor; the plans have no heights.
const ROOM_HEIGHT: f64 = 2.6;
const STOREY_HEIGHT: f64 = 2.9;
/// Metres of walls where the plan draws none behind a room.
const EXTERIOR_THICKNESS: f64 = 0.25;
const INTERIOR_THICKNESS: f64 = 0.12;
/// Metres of sill and head of windows, and of the head of doors.
const WINDOW: (f64, f64) = (0.9, 2.1);
const DOOR_HEAD: f64 = 2.0;
/// Half of the metres of strips that are no part of a room: where the data set cut kitchens out of living areas, frames of up to
/// 0.15 m stay around them.
const HALF_STRIP: f64 = 0.1;
/// Square metres that a room may lose with its strips and keep its outline: corners are not drawn to the millimetre.
const LOST_AREA: f64 = 0.01;
/// Square metres of the smallest room.
const SMALLEST_ROOM: f64 = 0.3;
/// Classes of solid walls.
const WALLS: [&str; 3] = ["wall", "interior_wall", "exterior_wall"];
/// Classes that are neither rooms nor openings.
const NO_ROOMS: [&str; 6] = ["inner", "land", "neighbor", "neighbour", "outer", "geom"];

/// Gives classes their room types, and remembers those that no table has.
pub(super) struct Classes<'a> {
    words: &'a RoomWords,
    /// Class → (its first place, how many shapes).
    unknown: BTreeMap<String, (Place, usize)>,
}

impl<'a> Classes<'a> {
    pub(super) fn new(words: &'a RoomWords) -> Self {
        Self { words, unknown: BTreeMap::new() }
    }

    /// Warnings for unknown classes. They are left out rather than guessed: most are areas around the flat.
    pub(super) fn report(&self, notes: &mut Notes) {
        for (class, (place, count)) in &self.unknown {
            let message = format!("unknown class \"{class}\": {} left out", counted(*count, "shape"));
            notes.warn(
                place,
                message,
                &format!("add it under formats.{NAME} in a room_words.yaml of yours if it is a room"),
            );
        }
    }
}

/// The level of a plan; `None` without rooms, which is noted.
pub(super) fn draft(
    sheet: &Sheet,
    metres: f64,
    classes: &mut Classes<'_>,
    notes: &mut Notes,
) -> Option<LevelDraft> {
    let mut level = LevelDraft {
        id: "floor".to_owned(),
        name: "Floor".to_owned(),
        height: STOREY_HEIGHT,
        exterior_thickness: EXTERIOR_THICKNESS,
        interior_thickness: INTERIOR_THICKNESS,
        outlines: OutlineKind::Inner,
        ..LevelDraft::default()
    };
    for (class, shapes) in &sheet.classes {
        match class.as_str() {
            "door" | "front_door" => {
                level.openings.extend(openings(class, shapes, OpeningKind::Door, metres))
            }
            "window" => level.openings.extend(openings(class, shapes, OpeningKind::Window, metres)),
            known if WALLS.contains(&known) => {
                let pieces = shapes.iter().flat_map(|(_, outline)| solid_pieces(outline));
                level.wall_outlines.extend(pieces.map(|ring| scaled(&ring, metres)));
            }
            known if NO_ROOMS.contains(&known) => {}
            _ => match classes.words.room_type(NAME, class) {
                Some(found) => {
                    level.rooms.extend(rooms(class, shapes, &TypeOfWord::known(class, found), metres))
                }
                None => {
                    classes.unknown.entry(class.clone()).or_insert_with(|| (shapes[0].0.clone(), 0)).1 +=
                        shapes.len()
                }
            },
        }
    }
    let (rooms, openings) = (level.rooms.len(), level.openings.len());
    if rooms == 0 {
        notes.error(
            &sheet.place,
            "the plan has no room",
            "rooms are polygons under keys such as \"bedroom\"",
        );
        return None;
    }
    if rooms > LEVEL_ROOMS || openings > LEVEL_OPENINGS {
        let message = format!("{rooms} rooms and {openings} openings are more than a level has");
        notes.error(&sheet.place, message, "is it one plan?");
        return None;
    }
    Some(level)
}

fn scaled(ring: &[Point], metres: f64) -> Vec<Point> {
    ring.iter().map(|corner| *corner * metres).collect()
}

/// The rooms of a class, numbered as they stand in the file.
fn rooms(class: &str, shapes: &Shapes, kind: &TypeOfWord, metres: f64) -> Vec<RoomDraft> {
    let outlines = shapes.iter().flat_map(|(_, outline)| {
        let holes = outline.holes.iter().map(|hole| scaled(hole, metres)).collect();
        without_strips(Outline { outer: scaled(&outline.outer, metres), holes })
    });
    let room = |(number, outline): (usize, Outline)| {
        let id = format!("{class}_{}", number + 1);
        RoomDraft {
            number: Some(number_of_id(&id)),
            name: Some(format!("{} {}", class.replace('_', " "), number + 1)),
            id,
            room_type: kind.room_type.clone(),
            unknown_word: kind.unknown_word.clone(),
            outline: outline.outer,
            holes: outline.holes,
            height: Some(ROOM_HEIGHT),
            ..RoomDraft::default()
        }
    };
    outlines.enumerate().map(room).collect()
}

/// An outline without the strips that hang on it; several where only strips joined them, none where it is one.
fn without_strips(outline: Outline) -> Vec<Outline> {
    if outline.outer.len() > OUTLINE_CORNERS || !outline.outer.iter().copied().all(is_place) {
        // Reported by the checks that all formats share.
        return vec![outline];
    }
    let holes = outline.holes.iter().map(|hole| ring_surface(hole).exterior().clone()).collect();
    let surface = geo::Polygon::new(ring_surface(&outline.outer).exterior().clone(), holes);
    let style = |by: f64| BufferStyle::new(by).line_join(LineJoin::Miter(std::f64::consts::FRAC_PI_6));
    let shrunk = surface.buffer_with_style(style(-HALF_STRIP));
    let opened = shrunk.buffer_with_style(style(HALF_STRIP));
    let lost = surface.unsigned_area() - opened.unsigned_area();
    if lost <= LOST_AREA || !lost.is_finite() {
        return vec![outline];
    }
    let parts = opened.into_iter().filter(|part| part.unsigned_area() >= SMALLEST_ROOM);
    parts
        .map(|part| Outline {
            outer: to_points(part.exterior()),
            holes: part.interiors().iter().map(to_points).collect(),
        })
        .collect()
}

/// The openings of a class by the rectangles around them; those without a length are none.
fn openings(class: &str, shapes: &Shapes, kind: OpeningKind, metres: f64) -> Vec<OpeningDraft> {
    let opening = |(number, (_, outline)): (usize, &(Place, Outline))| {
        let around = Oriented::around(&scaled(&outline.outer, metres))?;
        let kind = match kind {
            OpeningKind::Door if around.size.x > WIDEST_LEAF => OpeningKind::SlidingDoor,
            kind => kind,
        };
        let (bottom, top) = if kind == OpeningKind::Window { WINDOW } else { (0.0, DOOR_HEAD) };
        Some(OpeningDraft {
            id: format!("{class}_{}", number + 1),
            kind,
            place: OpeningPlace::Points { center: around.center, along: Some(around.axis) },
            rooms: Vec::new(),
            width: around.size.x,
            bottom,
            top,
            leaf: LeafDraft::Automatic,
        })
    };
    shapes.iter().enumerate().filter_map(opening).collect()
}
