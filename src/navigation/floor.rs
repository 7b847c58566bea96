//! The free floor of a level, room by room: what an agent can be in, and what stands in its way.

use crate::catalog::{Catalog, WalkingRules};
use crate::geometry::{Bounds, Point};
use crate::layout::{Furnished, solids};
use crate::plan::{Level, OpeningKind, OpeningSide, Room, ring_surface, to_points};
use crate::walk::is_in_the_way;

use super::file::Agent;
use super::shape::{self, Area};

/// Metres by which agents are thinner than they say: a way as wide as the agent is one.
const SLACK: f64 = 0.0025;
/// Metres that a strip through a door reaches into the room, so that both are one area.
const INTO_ROOM: f64 = 0.01;
/// Deepest wall of a door in metres: sides that are further from each other are joined by a mistake in the file.
const DEEPEST_WALL: f64 = 3.0;

/// A level with what stands on its floor.
#[derive(Clone, Debug)]
pub struct LevelFloor<'a> {
    pub(super) level: &'a Level,
    pub(super) catalog: &'a Catalog,
    /// By room; none where the furniture is not known, whose floor is not known either.
    rooms: Vec<Option<Vec<Body>>>,
}

/// Something that stands on the floor.
#[derive(Clone, Debug)]
pub(super) struct Body {
    /// Counter-clockwise.
    pub(super) footprint: Vec<Point>,
    bounds: Bounds,
}

impl Body {
    fn new(footprint: &[Point]) -> Self {
        Self { footprint: footprint.to_vec(), bounds: Bounds::around(footprint.iter().copied()) }
    }
}

/// A door, passage or open boundary as the floor within its wall.
#[derive(Clone, Debug)]
pub(super) struct Threshold {
    /// Index into the level's openings.
    pub(super) opening: usize,
    /// The corners of both of its sides; of a door to the open air the outer face of the wall.
    pub(super) corners: [Point; 4],
    /// Metres from face to face.
    depth: f64,
    /// Unit vector out of the first room.
    outward: Point,
}

impl<'a> LevelFloor<'a> {
    /// The furniture is that of the rooms, in their order; of a room that has none known the floor is left out.
    #[must_use]
    pub fn new(
        level: &'a Level,
        furnished: &[Option<Furnished>],
        catalog: &'a Catalog,
        agent: Agent,
    ) -> Self {
        let rooms = level.rooms.iter().enumerate().map(|(index, room)| {
            let furnished = furnished.get(index)?.as_ref()?;
            Some(bodies(level, (index, room), furnished, (catalog, agent)))
        });
        Self { level, catalog, rooms: rooms.collect() }
    }

    /// What stands in a room; none where that is not known.
    pub(super) fn bodies(&self, room: usize) -> Option<&[Body]> {
        self.rooms[room].as_deref()
    }

    /// The floor within the walls, of openings between rooms that are known.
    pub(super) fn thresholds(&self) -> impl Iterator<Item = Threshold> + '_ {
        let openings = self.level.openings.iter().enumerate();
        let walkable = openings.filter(|(_, opening)| opening.kind.is_walkable());
        walkable.filter_map(|(index, opening)| match opening.sides.as_slice() {
            [side] => Some(self.to_open_air(index, side)),
            [first, second] => self.between(index, first, second),
            _ => None,
        })
    }

    fn to_open_air(&self, opening: usize, side: &OpeningSide) -> Threshold {
        let wall = &self.level.rooms[side.room].walls[side.wall];
        let [from, to] = face(&self.level.rooms[side.room], side);
        let outward = -wall.normal();
        let beyond = outward * wall.thickness;
        Threshold { opening, corners: [from, to, to + beyond, from + beyond], depth: wall.thickness, outward }
    }

    fn between(&self, opening: usize, first: &OpeningSide, second: &OpeningSide) -> Option<Threshold> {
        let [from, to] = face(&self.level.rooms[first.room], first);
        let [across_from, across_to] = face(&self.level.rooms[second.room], second);
        let outward = -self.level.rooms[first.room].walls[first.wall].normal();
        let depth = (across_from - from).dot(outward).max((across_to - from).dot(outward)).max(0.0);
        (depth <= DEEPEST_WALL).then_some(Threshold {
            opening,
            corners: [from, to, across_from, across_to],
            depth,
            outward,
        })
    }

    /// Where the middle of an agent may be: in each room, and in each opening.
    pub(super) fn free(&self, radius: f64) -> (Vec<Area>, Vec<(usize, Area)>) {
        let radius = (radius - SLACK).max(0.0);
        let thresholds: Vec<Threshold> = self.thresholds().collect();
        let mut of_room: Vec<Vec<&Threshold>> = vec![Vec::new(); self.level.rooms.len()];
        for threshold in &thresholds {
            for side in &self.level.openings[threshold.opening].sides {
                of_room[side.room].push(threshold);
            }
        }
        let mut within_walls = Vec::new();
        let rooms = (0..self.level.rooms.len()).map(|room| {
            let Some(bodies) = self.bodies(room) else { return Area::new(Vec::new()) };
            let reached = self.reached((room, bodies), &of_room[room], radius);
            // The floor in a wall is that of the first room beside it.
            for threshold in &of_room[room] {
                let first_known = self.sides(threshold).find(|&side| self.bodies(side).is_some());
                if first_known == Some(room) {
                    let floor = shape::around(&threshold.corners).into();
                    within_walls.push((threshold.opening, shape::common(&reached, &floor)));
                }
            }
            shape::common(&reached, &shape::of_region(&self.level.rooms[room].region))
        });
        let rooms = rooms.collect();
        within_walls.sort_by_key(|(opening, _)| *opening);
        (rooms, within_walls)
    }

    fn sides(&self, threshold: &Threshold) -> impl Iterator<Item = usize> + '_ {
        self.level.openings[threshold.opening].sides.iter().map(|side| side.room)
    }

    /// Where the middle of an agent may be in a room and a little beyond its doors.
    fn reached(&self, (room, bodies): (usize, &[Body]), doors: &[&Threshold], radius: f64) -> Area {
        // Beyond a door the floor goes on; who stands on the threshold needs some of it.
        let strips: Vec<geo::Polygon<f64>> =
            doors.iter().map(|door| self.strip(door, room, door.depth + 2.0 * radius)).collect();
        let floor = shape::of_region(&self.level.rooms[room].region);
        let floor = shape::union(floor.0.iter().chain(&strips));
        let near = |body: &Body, strip: &geo::Polygon<f64>| {
            body.bounds.overlaps(Bounds::around(to_points(strip.exterior())), 0.0)
        };
        // What stands beyond a door is in the way as far as it stands before it: not through the wall.
        let beyond = doors.iter().zip(&strips).flat_map(|(door, strip)| {
            let others = self.sides(door).filter(move |&side| side != room);
            let bodies = others.filter_map(|side| self.bodies(side)).flatten();
            let bodies = bodies.filter(move |body| near(body, strip));
            bodies.flat_map(move |body| {
                shape::common(&ring_surface(&body.footprint).into(), &strip.clone().into()).0
            })
        });
        let own = bodies.iter().map(|body| ring_surface(&body.footprint));
        let in_the_way: Vec<geo::Polygon<f64>> = own.chain(beyond).collect();
        let taken = shape::grown(&shape::union(&in_the_way), radius);
        shape::without(&shape::grown(&floor, -radius), &taken)
    }

    /// The floor of a door as seen from a room, as deep as said.
    fn strip(&self, door: &Threshold, room: usize, depth: f64) -> geo::Polygon<f64> {
        let side = self.level.openings[door.opening].sides.iter().find(|side| side.room == room);
        let side = side.expect("doors are listed with the rooms on their sides");
        let [from, to] = face(&self.level.rooms[room], side);
        let outward = -self.level.rooms[room].walls[side.wall].normal();
        let (near, far) = (-outward * INTO_ROOM, outward * depth);
        shape::around(&[from + near, to + near, to + far, from + far])
    }
}

impl Threshold {
    /// The floor with a little of the rooms on both sides, for cells whose middles lie on the face of a wall.
    pub(super) fn widened(&self, by: f64) -> Vec<Point> {
        let [a, b, c, d] = self.corners;
        let (back, on) = (-self.outward * by, self.outward * by);
        let hull = shape::around(&[a + back, b + back, c + on, d + on]);
        // The last corner repeats the first.
        to_points(hull.exterior()).split_off(1)
    }
}

/// The ends of an opening on the inner face of its wall.
fn face(room: &Room, side: &OpeningSide) -> [Point; 2] {
    let wall = &room.walls[side.wall];
    [side.from, side.to].map(|along| wall.after(along))
}

/// What is in the way of an agent in a room: furniture, columns, leaves of doors that stand open in it, and stairs, at which its floor
/// ends.
fn bodies(
    level: &Level,
    (index, room): (usize, &Room),
    furnished: &Furnished,
    (catalog, agent): (&Catalog, Agent),
) -> Vec<Body> {
    let rules = WalkingRules { body_height: agent.height, step: agent.step, ..catalog.audit.walking };
    let pieces = furnished.placements.iter().flat_map(|placement| {
        let parts = solids(&catalog.classes[placement.class], placement);
        parts.into_iter().filter(|part| is_in_the_way(&rules, part)).map(|part| Body::new(part.footprint()))
    });
    let columns = room.obstacles.iter().filter(|column| column.height > agent.step);
    let columns = columns.map(|column| Body::new(column.outline.corners()));
    let doors = room.openings.iter().map(|place| &level.openings[place.opening]);
    let leaves =
        doors.filter(|opening| opening.kind == OpeningKind::Door).flat_map(|opening| &opening.leaves);
    let here = |leaf: &Point| level.rooms[index].region.contains(*leaf);
    let open = leaves.filter(|leaf| here(&leaf.open_tip)).filter_map(|leaf| leaf.standing_open());
    let leaves = open.map(|[leaf, _handle]| Body::new(&leaf));
    let stairs = level.stairs_of(index).and_then(|stairs| stairs.footprint());
    let stairs = stairs.map(|footprint| Body::new(footprint.corners()));
    pieces.chain(columns).chain(stairs).chain(leaves).collect()
}
