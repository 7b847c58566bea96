//! A usual room of a type, furnished and drawn.

use core::f64::consts::FRAC_PI_2;

use rayon::prelude::*;

use crate::best::{DEFAULT_EFFORT, furnish_best};
use crate::catalog::{Catalog, ClassIndex, ParentName, RoomType};
use crate::draw::{Drawing, draw_level};
use crate::geometry::Point;
use crate::layout::FurnishOptions;
use crate::plan::{
    LeafDraft, Level, LevelDraft, OpeningDraft, OpeningKind, OpeningPlace, RoomDraft, SitePlacement,
    assemble_level,
};

/// The description of the pictures.
pub(super) const DESCRIPTION: &str = "\
Each picture is a sample: a rectangular room of a usual size (the geometric mean of the type's usual areas, and 80 m² at most if
smaller rooms are usual). It has a door, and a window if people sit there. Corridors are long and have a door at both ends,
balconies and the like have railings, and garages have a gate. The samples are furnished as `bake` does, in the default style,
with seed 1.
";

/// Seed of all samples.
const SEED: u64 = 1;
/// Id of the building that the samples are rooms of.
const BUILDING: &str = "sample";
/// Square metres of a sample of a type that says nothing about them.
const USUAL: f64 = 20.0;
/// Square metres of the largest sample of a type that also has smaller rooms.
const LARGEST: f64 = 80.0;
/// Width by depth of a room, and of one that is a way; small rooms are as much deeper than wide.
const PROPORTIONS: (f64, f64) = (1.3, 6.0);
/// Metres to which walls are rounded.
const STEP: f64 = 0.1;
/// Square metres of rooms so small that they are deep and their door opens outward, and so large that it has two
/// leaves.
const DOOR_AREAS: (f64, f64) = (4.0, 60.0);
/// Metres of a level.
const HEIGHT: f64 = 3.0;
/// Share of the floor that furniture covers at most in a room that is a way.
const WAY_DENSITY: f64 = 0.2;
/// A group of classes that stands for work; a room that excludes it and holds little is a way.
const WORK: &str = "work";
/// A group of classes that people sit on.
const SEAT: &str = "seat";
/// A group of classes that drive in.
const VEHICLE: &str = "vehicle";

/// The facts that decide the shape of a sample and its openings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum SampleKind {
    /// A room with one door.
    Room,
    /// A room between two doors, that people pass through.
    Way,
    /// Walls on one side only.
    Outdoors,
}

/// Furnishes and draws a sample of each furnished room type, sorted by id; one that no level can hold is left out.
pub(super) fn draw_samples(catalog: &Catalog) -> Vec<(String, String)> {
    let room_types: Vec<&RoomType> =
        catalog.room_types.values().filter(|room_type| room_type.is_furnished).collect();
    let draw = |room_type: &&RoomType| {
        let level = sample_level(catalog, room_type)?;
        Some((room_type.id.clone(), draw_sample(catalog, &level)))
    };
    room_types.par_iter().filter_map(draw).collect()
}

fn draw_sample(catalog: &Catalog, level: &Level) -> String {
    let options = FurnishOptions::new(SEED, BUILDING);
    let judged = furnish_best(level.room(0), catalog, &options, DEFAULT_EFFORT);
    draw_level(&Drawing {
        building: BUILDING,
        site: SitePlacement::default(),
        level,
        furnished: &[judged.furnished],
        findings: &[judged.verdict.findings],
        catalog,
        seed: SEED,
        has_clearances: false,
        has_findings: false,
        has_legend: false,
    })
}

/// A level with one room of a type; `None` where its area is too small for any room.
fn sample_level(catalog: &Catalog, room_type: &RoomType) -> Option<Level> {
    let place = place_of(catalog, room_type);
    let size = size_of(room_type, place);
    let outline = [(0.0, 0.0), (size.x, 0.0), (size.x, size.y), (0.0, size.y)];
    let outline: Vec<Point> = outline.into_iter().map(|(x, y)| Point::new(x, y)).collect();
    let railings = if place == SampleKind::Outdoors { vec![railing(size)] } else { Vec::new() };
    let draft = LevelDraft {
        id: room_type.id.clone(),
        name: room_type.label.clone(),
        height: HEIGHT,
        exterior_thickness: 0.25,
        interior_thickness: 0.1,
        rooms: vec![RoomDraft {
            id: room_type.id.clone(),
            number: Some(1),
            room_type: room_type.id.clone(),
            outline,
            ..RoomDraft::default()
        }],
        openings: openings(catalog, room_type, place, size),
        railings,
        ..LevelDraft::default()
    };
    let (level, _) = assemble_level(draft);
    (level.rooms.len() == 1).then_some(level)
}

/// The outline of a railing around all sides but the south.
fn railing(size: Point) -> Vec<Point> {
    const HALF: f64 = 0.03;
    let Point { x, y } = size;
    let outer = [(x + HALF, 0.0), (x + HALF, y + HALF), (-HALF, y + HALF), (-HALF, 0.0)];
    let inner = [(HALF, 0.0), (HALF, y - HALF), (x - HALF, y - HALF), (x - HALF, 0.0)];
    outer.into_iter().chain(inner).map(|(x, y)| Point::new(x, y)).collect()
}

fn place_of(catalog: &Catalog, room_type: &RoomType) -> SampleKind {
    let mut classes = room_type.programme.iter().flat_map(|request| &request.classes);
    let hangs =
        |&class: &usize| catalog.classes[class].parents.iter().any(|rule| rule.parent == ParentName::Ceiling);
    if !classes.any(hangs) {
        // Whatever is furnished below a ceiling has a lamp.
        return SampleKind::Outdoors;
    }
    let excludes_work = room_type.excludes.iter().any(|group| group == WORK);
    if excludes_work && room_type.density.1 <= WAY_DENSITY { SampleKind::Way } else { SampleKind::Room }
}

/// Metres from west to east and from south to north.
fn size_of(room_type: &RoomType, place: SampleKind) -> Point {
    let (least, most) = room_type.area;
    let mean = if least > 0.0 { (least * most).sqrt() } else { USUAL };
    let area = mean.min(LARGEST).clamp(least, most);
    let proportion = match place {
        SampleKind::Way => PROPORTIONS.1,
        _ if area < DOOR_AREAS.0 => PROPORTIONS.0.recip(),
        _ => PROPORTIONS.0,
    };
    let depth = (area / proportion).sqrt();
    let rounded = |length: f64| (length / STEP).round() * STEP;
    Point::new(rounded(area / depth), rounded(depth))
}

/// The openings. Edges of the outline go around from the south wall: south, east, north, west.
fn openings(catalog: &Catalog, room_type: &RoomType, place: SampleKind, size: Point) -> Vec<OpeningDraft> {
    const SOUTH: usize = 0;
    const EAST: usize = 1;
    const NORTH: usize = 2;
    const WEST: usize = 3;
    let names = |opening| Names { room: &room_type.id, opening };
    let edge = |index, length| Edge { index, length };
    let area = size.x * size.y;
    let mut openings = match place {
        SampleKind::Way => {
            vec![door(names("west"), edge(WEST, size.y), area), door(names("east"), edge(EAST, size.y), area)]
        }
        SampleKind::Room | SampleKind::Outdoors => vec![door(names("door"), edge(SOUTH, size.x), area)],
    };
    if holds(catalog, room_type, VEHICLE) {
        openings.push(gate(names("gate"), edge(EAST, size.y)));
    }
    if has_window(catalog, room_type, place) {
        openings.push(window(names("window"), edge(NORTH, size.x)));
    }
    openings
}

/// Whether people sit there, other than in a hall that is filled with seats.
fn has_window(catalog: &Catalog, room_type: &RoomType, place: SampleKind) -> bool {
    let is_seat = |&class: &ClassIndex| catalog.classes[class].groups.iter().any(|group| group == SEAT);
    let is_filled = room_type
        .programme
        .iter()
        .any(|request| request.count.is_fill() && request.classes.iter().any(is_seat));
    place == SampleKind::Room && !is_filled && holds(catalog, room_type, SEAT)
}

/// Whether a room of the type may hold something of a group.
fn holds(catalog: &Catalog, room_type: &RoomType, group: &str) -> bool {
    let mut classes = room_type.programme.iter().flat_map(|request| &request.classes);
    classes.any(|&class| catalog.classes[class].groups.iter().any(|one| one == group))
}

/// Ids of an opening and of its room.
#[derive(Clone, Copy)]
struct Names<'a> {
    room: &'a str,
    opening: &'a str,
}

/// An edge of the outline.
#[derive(Clone, Copy)]
struct Edge {
    index: usize,
    /// Metres.
    length: f64,
}

/// Metres of an opening.
struct Extent {
    width: f64,
    bottom: f64,
    top: f64,
}

/// A door near the end of a wall, in the middle of a short one.
fn door(names: Names<'_>, edge: Edge, area: f64) -> OpeningDraft {
    const WIDTHS: [f64; 2] = [0.9, 1.6];
    const TO_CORNER: f64 = 0.35;
    let leaves = 1 + usize::from(area >= DOOR_AREAS.1);
    let width = WIDTHS[leaves - 1];
    let at = (TO_CORNER + width / 2.0).min(edge.length / 2.0);
    let into = (area >= DOOR_AREAS.0).then(|| names.room.to_owned());
    let leaf = LeafDraft::Swing { hinge_left: true, into, count: leaves as u32, angle: FRAC_PI_2 };
    opening(names, OpeningKind::Door, place_on(edge, at), Extent { width, bottom: 0.0, top: 2.05 }, leaf)
}

/// A gate in the middle of a wall, through which a car gets.
fn gate(names: Names<'_>, edge: Edge) -> OpeningDraft {
    const EXTENT: Extent = Extent { width: 2.5, bottom: 0.0, top: 2.2 };
    opening(names, OpeningKind::SlidingDoor, place_on(edge, edge.length / 2.0), EXTENT, LeafDraft::None)
}

/// A window in the middle of a wall.
fn window(names: Names<'_>, edge: Edge) -> OpeningDraft {
    const SHARE: f64 = 0.45;
    let extent = Extent { width: edge.length * SHARE, bottom: 0.9, top: 2.2 };
    opening(names, OpeningKind::Window, place_on(edge, edge.length / 2.0), extent, LeafDraft::None)
}

/// The place on an edge, metres from its start.
fn place_on(edge: Edge, at: f64) -> OpeningPlace {
    OpeningPlace::Edge { edge: edge.index, at }
}

fn opening(
    names: Names<'_>,
    kind: OpeningKind,
    place: OpeningPlace,
    extent: Extent,
    leaf: LeafDraft,
) -> OpeningDraft {
    let Extent { width, bottom, top } = extent;
    let (id, rooms) = (names.opening.to_owned(), vec![names.room.to_owned()]);
    OpeningDraft { id, kind, place, rooms, width, bottom, top, leaf }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::builtin_catalog;

    #[test]
    fn samples_are_of_a_usual_size_and_have_their_openings() {
        let catalog = builtin_catalog();
        for room_type in catalog.room_types.values().filter(|room_type| room_type.is_furnished) {
            let level = sample_level(catalog, room_type).unwrap();
            let area = level.rooms[0].region.area();
            let (least, most) = room_type.area;
            assert!(area > least * 0.95 && area < most * 1.05, "{}: {area}", room_type.id);
            let place = place_of(catalog, room_type);
            let has_window = has_window(catalog, room_type, place);
            let has_two_ways = place == SampleKind::Way || holds(catalog, room_type, VEHICLE);
            let count = 1 + usize::from(has_window) + usize::from(has_two_ways);
            assert_eq!(level.openings.len(), count, "{}", room_type.id);
        }
    }

    #[test]
    fn a_window_is_where_people_sit() {
        let catalog = builtin_catalog();
        let windows = |id: &str| {
            let level = sample_level(catalog, &catalog.room_types[id]).unwrap();
            level.openings.iter().filter(|opening| opening.kind == OpeningKind::Window).count()
        };
        assert_eq!(["bedroom", "office", "toilet", "cinema", "corridor"].map(windows), [1, 1, 0, 0, 0]);
    }

    #[test]
    fn a_small_room_keeps_its_floor_from_the_door() {
        let catalog = builtin_catalog();
        let leaf = |id: &str| {
            let level = sample_level(catalog, &catalog.room_types[id]).unwrap();
            let tip = level.openings[0].leaves[0].open_tip;
            (level.rooms[0].region.contains(tip), level.openings[0].leaves.len())
        };
        assert_eq!(["toilet", "bathroom", "lobby"].map(leaf), [(false, 1), (true, 1), (true, 2)]);
    }

    #[test]
    fn the_kind_of_a_sample_follows_from_its_programme() {
        let catalog = builtin_catalog();
        let place = |id: &str| place_of(catalog, &catalog.room_types[id]);
        assert_eq!(place("bedroom"), SampleKind::Room);
        assert_eq!(place("corridor"), SampleKind::Way);
        assert_eq!(place("ticket_hall"), SampleKind::Room);
        assert_eq!(place("balcony"), SampleKind::Outdoors);
    }
}
