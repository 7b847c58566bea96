//! Turns one drawing and its areas into a drafted level.

use std::collections::BTreeSet;

use super::areas::{Area, Outline};
use super::drawing::{Drawing, Hole, Sweep, metres, outer_ring};
use crate::geometry::{Bounds, Point, Polygon, Region};
use crate::plan::assemble::BoxIndex;
use crate::plan::read::foreign::TypeOfWord;
use crate::plan::units::CENTIMETRE;
use crate::plan::{
    Leaf, LeafDraft, LevelDraft, ObstacleDraft, OpeningDraft, OpeningKind, OpeningPlace, OutlineKind,
    RoomDraft,
};

/// Metres of a door's head; the format never says.
const DOOR_HEAD: f64 = 2.0;
/// Metres of slab between ceiling and floor above.
const SLAB_THICKNESS: f64 = 0.3;
/// Metres of outer walls where the drawing shows none behind a room.
const EXTERIOR_THICKNESS: f64 = 0.35;
/// Metres of walls between rooms; only a fallback, gaps between areas say more.
const INTERIOR_THICKNESS: f64 = 0.12;
/// A bathroom below this many square metres without tub and shower is a guest toilet.
const LARGEST_TOILET: f64 = 3.0;
/// Fixtures that a guest toilet lacks.
const BATHS: [&str; 2] = ["bathtub", "shower"];

/// Heights in metres where the drawing says none.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Heights {
    /// Floor to ceiling.
    pub(crate) wall: f64,
    /// Sill of windows.
    pub(crate) window_low: f64,
    /// Head of windows.
    pub(crate) window_high: f64,
}

impl Default for Heights {
    fn default() -> Self {
        Self { wall: 2.6, window_low: 0.5, window_high: 2.4 }
    }
}

impl Heights {
    /// Metres from floor to floor.
    pub(crate) fn storey(&self) -> f64 {
        self.wall + SLAB_THICKNESS
    }
}

/// A room's type and title, found by the caller from the area's word.
pub(crate) struct Naming<'a> {
    /// The room type of an area, knowing whether it is a guest toilet.
    pub(crate) room_type: &'a mut dyn FnMut(&Area, bool) -> TypeOfWord,
    /// The apartment that an area belongs to.
    pub(crate) apartment: &'a dyn Fn(&Area) -> Option<String>,
}

/// The input for a floor.
pub(crate) struct Floor<'a> {
    pub(crate) drawing: &'a Drawing,
    /// Metres per pixel.
    pub(crate) pixel: f64,
    pub(crate) areas: Vec<(&'a Area, Vec<Outline>)>,
    pub(crate) heights: Heights,
    /// 0 is the ground floor.
    pub(crate) number: i32,
}

/// Translates a floor; the rooms keep the order of the areas, the openings that of their ids.
pub(crate) fn level(floor: &Floor<'_>, naming: &mut Naming<'_>) -> LevelDraft {
    let Floor { drawing, pixel, heights, number, .. } = *floor;
    let rings = |kinds: &[&str]| -> Vec<Vec<Point>> {
        let chosen = drawing.lines().filter(|line| kinds.contains(&line.kind.as_str()));
        chosen.map(|line| outer_ring(&line.coordinates, pixel)).collect()
    };
    LevelDraft {
        id: format!("floor_{number}"),
        name: format!("Floor {number}"),
        elevation: f64::from(number) * heights.storey(),
        height: heights.storey(),
        exterior_thickness: EXTERIOR_THICKNESS,
        interior_thickness: INTERIOR_THICKNESS,
        outlines: OutlineKind::Inner,
        rooms: rooms(floor, naming),
        openings: drawing.holes().filter_map(|(id, hole)| opening(id, hole, pixel, heights)).collect(),
        obstacles: columns(rings(&["column"]), floor),
        railings: rings(&["railing"]),
        // Nobody walks through a railing or a column either.
        wall_outlines: rings(&["wall", "railing", "column"]),
    }
}

/// The columns that stand free in an area; most are part of a wall, or cut out of the area already.
fn columns(outlines: Vec<Vec<Point>>, floor: &Floor<'_>) -> Vec<ObstacleDraft> {
    let areas: Vec<(Polygon, &Outline)> = floor
        .areas
        .iter()
        .flat_map(|(_, outlines)| outlines)
        .filter_map(|outline| Some((Polygon::new(&outline.outer).ok()?, outline)))
        .collect();
    let places = BoxIndex::of(areas.iter().map(|(outer, _)| outer.bounds()).zip(0..));
    let stands_free = |column: &Vec<Point>| {
        let middle = column.iter().sum::<Point>() / column.len().max(1) as f64;
        let encloses = |ring: &Vec<Point>| Polygon::new(ring).is_ok_and(|ring| ring.contains(middle));
        places.meeting(Bounds::around([middle])).any(|number| {
            let (outer, area) = &areas[number];
            outer.contains(middle) && !area.holes.iter().any(encloses)
        })
    };
    let free = outlines.into_iter().filter(stands_free);
    free.map(|outline| ObstacleDraft { outline, height: None }).collect()
}

fn rooms(floor: &Floor<'_>, naming: &mut Naming<'_>) -> Vec<RoomDraft> {
    let fixtures = Fixtures::of(floor);
    let mut rooms = Vec::new();
    for (area, outlines) in &floor.areas {
        for (part, outline) in outlines.iter().enumerate() {
            let id = if part == 0 { area.id.to_string() } else { format!("{}.{}", area.id, part + 1) };
            let kind = area.area_type.to_lowercase().replace('_', " ");
            let dwelling = (naming.apartment)(area);
            let name = dwelling.as_ref().map(|apartment| format!("{kind}, {apartment}"));
            let fixtures = fixtures.kinds_in(outline);
            let is_toilet = is_toilet(area, outline, &fixtures);
            let TypeOfWord { room_type, unknown_word } = (naming.room_type)(area, is_toilet);
            rooms.push(RoomDraft {
                id,
                name,
                dwelling,
                room_type,
                unknown_word,
                fixtures,
                outline: outline.outer.clone(),
                holes: outline.holes.clone(),
                height: Some(floor.heights.wall),
                ..RoomDraft::default()
            });
        }
    }
    rooms
}

/// The fixtures of a floor by place.
struct Fixtures {
    kinds: Vec<(Point, String)>,
    places: BoxIndex<usize>,
}

impl Fixtures {
    fn of(floor: &Floor<'_>) -> Self {
        let fixtures = floor.drawing.fixtures(floor.pixel).into_iter();
        let kinds: Vec<(Point, String)> =
            fixtures.map(|fixture| (fixture.center, fixture.kind.to_lowercase())).collect();
        let places = BoxIndex::of(kinds.iter().map(|(center, _)| Bounds::around([*center])).zip(0..));
        Self { kinds, places }
    }

    /// The kinds of fixtures in an outline; none if it is invalid.
    fn kinds_in(&self, outline: &Outline) -> BTreeSet<String> {
        let Ok(outer) = Polygon::new(&outline.outer) else { return BTreeSet::new() };
        let holes: Vec<Polygon> = outline.holes.iter().filter_map(|hole| Polygon::new(hole).ok()).collect();
        let bounds = outer.bounds();
        let room = Region { outline: outer, holes };
        let near = self.places.meeting(bounds).map(|number| &self.kinds[number]);
        near.filter(|(center, _)| room.contains(*center)).map(|(_, kind)| kind.clone()).collect()
    }
}

fn is_toilet(area: &Area, outline: &Outline, fixtures: &BTreeSet<String>) -> bool {
    let is_small = |room: Polygon| room.area() < LARGEST_TOILET;
    area.area_type == "BATHROOM"
        && !BATHS.iter().any(|bath| fixtures.contains(*bath))
        && Polygon::new(&outline.outer).is_ok_and(is_small)
}

/// `None` for kinds that are no openings.
fn opening(id: &str, hole: &Hole, pixel: f64, heights: Heights) -> Option<OpeningDraft> {
    let kind = match hole.kind.as_str() {
        "door" | "entrance_door" => OpeningKind::Door,
        "sliding_door" => OpeningKind::SlidingDoor,
        "window" => OpeningKind::Window,
        _ => return None,
    };
    let (center, along) = axis(&outer_ring(&hole.coordinates, pixel));
    let usual = if kind == OpeningKind::Window {
        (heights.window_low, heights.window_high)
    } else {
        (0.0, DOOR_HEAD)
    };
    let drawn = hole.properties.as_ref().and_then(|properties| properties.heights.as_ref());
    let height = |edge: Option<f64>, usual: f64| edge.map_or(usual, |edge| edge * CENTIMETRE);
    Some(OpeningDraft {
        id: id.to_owned(),
        kind,
        place: OpeningPlace::Points { center, along: Some(along) },
        rooms: Vec::new(),
        width: along.length(),
        bottom: height(drawn.and_then(|heights| heights.lower_edge), usual.0),
        top: height(drawn.and_then(|heights| heights.upper_edge), usual.1),
        leaf: hole.door_sweeping_points.as_ref().map_or(LeafDraft::Automatic, |sweep| leaf(sweep, pixel)),
    })
}

/// Middle and longer axis of a four-cornered ring; the axis lies along the wall. Zero for a broken ring, which
/// is reported as having no width.
fn axis(ring: &[Point]) -> (Point, Point) {
    let [a, b, c, d, ..] = ring[..] else { return (Point::ZERO, Point::ZERO) };
    let first = ((b - a) + (c - d)) / 2.0;
    let second = ((d - a) + (c - b)) / 2.0;
    let along = if first.length() >= second.length() { first } else { second };
    ((a + b + c + d) / 4.0, along)
}

fn leaf(sweep: &Sweep, pixel: f64) -> LeafDraft {
    LeafDraft::Points(vec![Leaf {
        hinge: metres(sweep.angle_point, pixel),
        closed_tip: metres(sweep.closed_point, pixel),
        open_tip: metres(sweep.opened_point, pixel),
    }])
}
