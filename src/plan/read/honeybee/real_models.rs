//! The real models beside the project: their adjacencies, openings and areas.

use std::path::Path;

use super::model::{Space, Storey};
use super::notes::Notes;
use super::room_types::{NAME, Naming};
use super::schema::Model;
use super::{checked, level, room3d, storeys, storeys_of};
use crate::document::{Faults, Source};
use crate::geometry::{Point, signed_area};
use crate::plan::read::real_data::{folder, words};
use crate::plan::{Level, Room, Wall, assemble_level};

/// The figures of a model.
#[derive(Debug, Default, PartialEq, Eq)]
struct Figures {
    /// Walls that name a room of their level as adjacent, and those that face it.
    stated: usize,
    faced: usize,
    /// Among them those with a door or none at all, and those with an opening that joins both rooms.
    ways: usize,
    joined: usize,
    /// Openings that were drafted, and that lie in a wall.
    drafted: usize,
    attached: usize,
    /// Rooms, and those whose area is not that of the model.
    rooms: usize,
    other_areas: usize,
}

fn figures(path: &Path) -> Figures {
    let source = Source::read(path).unwrap();
    let model: Model = source.parse().unwrap_or_else(|faults: Faults| panic!("{faults}"));
    let mut notes = Notes::new(source);
    let unit = checked(&model, &mut notes).unwrap();
    let mut buildings: Vec<Vec<Storey>> = Vec::new();
    for building in model.buildings.iter().flatten() {
        buildings.push(storeys_of(building, unit, &Vec::new(), &mut notes));
    }
    if let Some(rooms) = &model.rooms {
        let spaces = room3d::spaces(rooms, unit, &Vec::new(), &mut notes);
        buildings.push(storeys::storeys(spaces, &Vec::new()));
    }
    let mut figures = Figures::default();
    for storey in buildings.into_iter().flatten() {
        let words = words();
        let mut naming = Naming::new(&words, NAME);
        let spaces = storey.spaces.clone();
        let draft = level::drafts(vec![Storey { repeat: 1, ..storey }], &mut naming, &mut notes).pop();
        let Some(draft) = draft else { continue };
        figures.drafted += draft.openings.len();
        let drawn: Vec<String> = draft.openings.iter().map(|opening| opening.id.clone()).collect();
        let (level, _) = assemble_level(draft);
        figures.attached += level.openings.iter().filter(|opening| drawn.contains(&opening.id)).count();
        figures.add(&spaces, &level);
    }
    figures
}

impl Figures {
    fn add(&mut self, spaces: &[Space], level: &Level) {
        let room = |id: &str| level.rooms.iter().position(|room| room.id == id);
        for space in spaces {
            let Some(own) = room(&space.id) else { continue };
            let area = signed_area(&space.outline).abs()
                - space.holes.iter().map(|hole| signed_area(hole).abs()).sum::<f64>();
            self.rooms += 1;
            self.other_areas += usize::from((level.rooms[own].region.area() / area - 1.0).abs() > 0.001);
            for edge in &space.edges {
                let Some(far) = edge.far.as_deref().and_then(room) else { continue };
                self.stated += 1;
                let (own_room, far_room) = (&level.rooms[own], &level.rooms[far]);
                let middle = edge.start.midpoint(edge.end);
                let is_faced = [own_room, far_room].iter().all(|room| is_at(room, middle));
                self.faced += usize::from(is_faced);
                if is_faced && (edge.is_open || edge.holes.iter().any(|hole| hole.is_door)) {
                    self.ways += 1;
                    self.joined += usize::from(has_way(level, own, far));
                }
            }
        }
    }
}

/// Whether a door or open boundary joins two rooms.
fn has_way(level: &Level, one: usize, other: usize) -> bool {
    let mut ways = level.openings.iter().filter(|opening| opening.kind.is_walkable());
    ways.any(|way| [one, other].iter().all(|room| way.sides.iter().any(|side| side.room == *room)))
}

/// Whether a wall of a room runs through a point.
fn is_at(room: &Room, point: Point) -> bool {
    room.walls.iter().any(|wall: &Wall| wall.segment().nearest(point).distance(point) < 0.02)
}

/// All adjacencies of the real models, their openings and areas. A door between two rooms is stated by both, and drafted once.
#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn real_models_are_read_as_they_say() {
    let cases = [
        ("dragonfly", "model_complete_simple.dfjson", [6, 0, 18, 6]),
        ("dragonfly", "model_with_doors_skylights.dfjson", [74, 20, 66, 15]),
        ("honeybee", "model_5vertex_sub_faces_interior.hbjson", [2, 2, 2, 2]),
        ("honeybee", "single_family_home.hbjson", [24, 0, 8, 7]),
    ];
    for (place, name, [adjacencies, ways, openings, rooms]) in cases {
        let Some(folder) = folder(place) else { return };
        let expected = Figures {
            stated: adjacencies,
            faced: adjacencies,
            ways,
            joined: ways,
            drafted: openings,
            attached: openings,
            rooms,
            other_areas: 0,
        };
        assert_eq!(figures(&folder.join(name)), expected, "{name}");
    }
}
