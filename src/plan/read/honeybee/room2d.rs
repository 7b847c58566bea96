//! Turns dragonfly's buildings into storeys: rooms are floors with a height, and lists that go along their edges.

use std::collections::BTreeMap;

use super::model::{Edge, Place, Space, Storey, part};
use super::notes::{Notes, PLENUM, TOO_MANY};
use super::recipes::{Face, holes};
use super::room_types::is_plenum;
use super::schema::{Length, Properties, Room2d, Story, WindowParameters};
use crate::document::PathStep;
use crate::geometry::Point;

/// Window parameters of kinds that are unknown, by kind: their first place, and how many.
pub(super) type UnknownKinds = BTreeMap<String, (Place, usize)>;

/// The storeys of a building; `unit` are the metres of a length of 1.
pub(super) fn storeys(stories: &[Story], unit: f64, place: &Place, notes: &mut Notes) -> Vec<Storey> {
    let mut unknown = UnknownKinds::new();
    let mut window_count = MOST_WINDOWS;
    let mut storeys = Vec::new();
    for (number, story) in stories.iter().enumerate() {
        let place = part(place, ["unique_stories".into(), number.into()]);
        let mut reader = Reader { unit, unknown: &mut unknown, window_count: &mut window_count, notes };
        storeys.push(reader.storey(story, place));
    }
    warn_of_kinds(&unknown, notes);
    storeys
}

fn warn_of_kinds(unknown: &UnknownKinds, notes: &mut Notes) {
    for (kind, (place, count)) in unknown {
        let walls = if *count == 1 { "1 wall".to_owned() } else { format!("{count} walls") };
        let message =
            format!("window parameters \"{kind}\" are unknown or incomplete: {walls} without windows");
        notes.warn(place, message, "use ratios, sizes, or detailed windows");
    }
}

/// Windows that are made for all walls of a building.
const MOST_WINDOWS: usize = 200_000;

struct Reader<'a> {
    /// Metres of a length of 1.
    unit: f64,
    unknown: &'a mut UnknownKinds,
    /// Windows that may still be made.
    window_count: &'a mut usize,
    notes: &'a mut Notes,
}

impl Reader<'_> {
    fn storey(&mut self, story: &Story, place: Place) -> Storey {
        let height = Length::given(story.floor_to_floor_height.as_ref()).map(|given| given * self.unit);
        let is_plenum_story = story.story_type.as_deref().is_some_and(|kind| kind.contains("Plenum"));
        let mut spaces = Vec::new();
        for (number, room) in story.room_2ds.iter().enumerate() {
            let place = part(&place, ["room_2ds".into(), number.into()]);
            let program = Properties::program(room.properties.as_ref());
            if is_plenum_story || is_plenum(room.display_name.as_deref(), program.as_deref()) {
                self.notes.count(PLENUM, || place);
                continue;
            }
            spaces.extend(self.space(room, program, place));
        }
        Storey {
            name: story.display_name.clone().unwrap_or_else(|| story.identifier.clone()),
            height,
            repeat: story.multiplier.unwrap_or(1).max(1) as usize,
            spaces,
            place,
        }
    }

    fn space(&mut self, room: &Room2d, program: Option<String>, place: Place) -> Option<Space> {
        let count = room.floor_boundary.len();
        if count < 3 {
            let place = part(&place, ["floor_boundary".into()]);
            let message = format!("the floor of room \"{}\" has {count} corners", room.identifier);
            self.notes.error(&place, message, "the room is left out; a floor has three corners at least");
            return None;
        }
        let ring = |ring: &Vec<[f64; 2]>| -> Vec<Point> {
            ring.iter().map(|&corner| Point::from(corner) * self.unit).collect()
        };
        let outline = ring(&room.floor_boundary);
        let holes: Vec<Vec<Point>> = room.floor_holes.iter().flatten().map(ring).collect();
        let depth = |depth: Option<f64>| depth.unwrap_or(0.0).max(0.0) * self.unit;
        let (below, above) = (depth(room.floor_plenum_depth), depth(room.ceiling_plenum_depth));
        let floor = room.floor_height * self.unit + below;
        let height = room.floor_to_ceiling_height * self.unit - below - above;
        let mut space = Space {
            identifier: room.identifier.clone(),
            id: room.identifier.clone(),
            name: room.display_name.clone(),
            program,
            floor,
            height,
            edges: edges(&outline, &holes),
            outline,
            holes,
            place,
        };
        self.give_neighbours(room, &mut space);
        self.give_windows(room, &mut space, below);
        Some(space)
    }

    /// What lies behind the edges.
    fn give_neighbours(&mut self, room: &Room2d, space: &mut Space) {
        let count = space.edges.len();
        if let Some(conditions) = room.boundary_conditions.as_ref().filter(|list| !list.is_empty()) {
            self.check_count("boundary_conditions", conditions.len(), count, space);
            for (edge, condition) in space.edges.iter_mut().zip(conditions) {
                edge.far = condition.room().cloned();
            }
        }
        if let Some(open) = room.air_boundaries.as_ref().filter(|list| !list.is_empty()) {
            self.check_count("air_boundaries", open.len(), count, space);
            for (edge, is_open) in space.edges.iter_mut().zip(open) {
                edge.is_open = *is_open;
            }
        }
    }

    fn check_count(&mut self, key: &str, count: usize, edges: usize, space: &Space) {
        if count != edges {
            let message = format!("room \"{}\" has {edges} edges and {count} {key}", space.id);
            let place = part(&space.place, [key.into()]);
            self.notes.warn(
                &place,
                message,
                "there is one for each edge, holes included; the first ones are read",
            );
        }
    }

    fn give_windows(&mut self, room: &Room2d, space: &mut Space, below: f64) {
        let Some(parameters) = room.window_parameters.as_ref().filter(|list| !list.is_empty()) else {
            return;
        };
        self.check_count("window_parameters", parameters.len(), space.edges.len(), space);
        let Space { id, floor, height, edges, place, .. } = space;
        for (number, (edge, parameters)) in edges.iter_mut().zip(parameters).enumerate() {
            let Some(parameters) = parameters else { continue };
            let face = Face {
                start: edge.start,
                floor: *floor,
                along: (edge.end - edge.start).normalize_or_zero(),
                length: edge.length(),
                height: *height,
                unit: self.unit,
            };
            match holes(parameters, &face, &format!("{id}.{}", number + 1)) {
                Some(holes) if holes.len() > *self.window_count => {
                    self.notes.count(TOO_MANY, || part(place, ["window_parameters".into(), number.into()]));
                }
                Some(mut holes) => {
                    *self.window_count -= holes.len();
                    raise(&mut holes, parameters, below);
                    edge.holes = holes;
                }
                None => {
                    let place = || part(place, ["window_parameters".into(), PathStep::from(number)]);
                    self.unknown.entry(parameters.kind.clone()).or_insert_with(|| (place(), 0)).1 += 1;
                }
            }
        }
    }
}

/// Heights of drawn windows in the wall are above the slab, which lies lower than the floor if there is a plenum between; those of
/// points in space and of recipes are not.
fn raise(holes: &mut [super::model::Hole], parameters: &WindowParameters, below: f64) {
    let mut corners = parameters.polygons.iter().flatten().flatten();
    let is_in_wall = match parameters.kind.as_str() {
        "RectangularWindows" => true,
        "DetailedWindows" => corners.all(|corner| corner.len() < 3),
        _ => false,
    };
    if is_in_wall {
        for hole in holes {
            hole.bottom -= below;
            hole.top -= below;
        }
    }
}

/// The edges of an outline, then those of its holes.
fn edges(outline: &[Point], holes: &[Vec<Point>]) -> Vec<Edge> {
    let mut edges = Vec::new();
    for ring in std::iter::once(outline).chain(holes.iter().map(Vec::as_slice)) {
        let ends = ring.iter().copied().zip(ring.iter().copied().cycle().skip(1));
        edges.extend(ends.map(|(start, end)| Edge {
            start,
            end,
            far: None,
            is_open: false,
            holes: Vec::new(),
        }));
    }
    edges
}
