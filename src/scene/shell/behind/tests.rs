use chacha20::ChaCha8Rng;
use chacha20::rand_core::{Rng, SeedableRng};

use super::super::corner::{Footprint, footprints};
use super::super::storey::Storey;
use crate::geometry::{Point, Polygon, Region, direction};
use crate::plan::{Level, Opening, OpeningKind, OpeningSide, Room, RoomOpening, Wall};

/// Metres that a wall may be in a room.
const LIMIT: f64 = 0.01;
/// Metres between the points of a footprint that are measured.
const STEP: f64 = 0.05;
const THICKNESSES: [f64; 7] = [0.0, 0.01, 0.07, 0.1, 0.2, 0.35, 0.5];
const GAPS: [f64; 7] = [0.0, 0.001, 0.03, 0.1, 0.2, 0.4, 0.7];

fn room(id: &str, corners: &[Point]) -> Room {
    Room::bare(id, "room", Region::simple(Polygon::new(corners).unwrap()), 2.5, 0.2)
}

fn rectangle(id: &str, low: (f64, f64), high: (f64, f64)) -> Room {
    room(
        id,
        &[(low.0, low.1), (high.0, low.1), (high.0, high.1), (low.0, high.1)].map(|(x, y)| Point::new(x, y)),
    )
}

/// The ring of a wall's body in the level's frame.
fn ring(wall: &Wall, footprint: &Footprint) -> Vec<Point> {
    let at = |point: Point| wall.after(point.x) - wall.normal() * point.y;
    let back = footprint.back.iter().map(|behind| at(behind.outer));
    let mut ring = vec![wall.end, wall.start];
    ring.extend(back);
    ring
}

/// Metres that a point lies inside of a room.
fn depth_in(room: &Room, point: Point) -> f64 {
    if !room.region.outline.bounds().contains(point) || !room.region.contains(point) {
        return 0.0;
    }
    let distances = room.region.borders().map(|border| border.distance(point));
    distances.fold(f64::INFINITY, f64::min)
}

/// Metres that the deepest point of any wall lies inside of any room, and the place.
fn deepest(level: &Level) -> (f64, Point) {
    let storey = Storey::of(level);
    let mut deepest = (0.0, Point::ZERO);
    for owner in &level.rooms {
        for (wall, footprint) in owner.walls.iter().zip(footprints(&storey, owner)) {
            for point in points_along(&ring(wall, &footprint)) {
                let depth = level.rooms.iter().map(|room| depth_in(room, point)).fold(0.0, f64::max);
                if depth > deepest.0 {
                    deepest = (depth, point);
                }
            }
        }
    }
    deepest
}

fn points_along(ring: &[Point]) -> Vec<Point> {
    let mut points = Vec::new();
    for (index, &start) in ring.iter().enumerate() {
        let end = ring[(index + 1) % ring.len()];
        let count = (start.distance(end) / STEP).ceil().clamp(1.0, 200.0) as usize;
        points.extend((0..count).map(|i| start.lerp(end, i as f64 / count as f64)));
    }
    points
}

#[test]
fn a_wall_ends_halfway_to_the_room_behind() {
    let mut one = rectangle("1", (0.0, 0.0), (4.0, 3.0));
    one.walls[1].thickness = 0.5;
    let other = rectangle("2", (4.2, 1.0), (6.0, 2.0));
    let level = Level::bare("1", 2.8, vec![one, other]);
    let back = footprints(&Storey::of(&level), &level.rooms[0])[1].back.clone();
    let depth_at = |u: f64| {
        let index = back.iter().rposition(|behind| behind.outer.x <= u).unwrap();
        back[index].outer.y
    };
    assert!((depth_at(1.5) - 0.1).abs() < 1e-9, "{back:?}");
    assert!((depth_at(0.5) - 0.5).abs() < 1e-9 && (depth_at(2.5) - 0.5).abs() < 1e-9, "{back:?}");
}

#[test]
fn a_mitre_ends_at_the_side_of_a_doorway_in_the_next_wall() {
    let corners = [(0.0, 0.0), (6.0, 0.0), (6.0, 2.5), (2.5, 2.5), (2.5, 5.0), (0.0, 5.0)];
    let mut one = room("1", &corners.map(|(x, y)| Point::new(x, y)));
    one.walls[2].thickness = 0.3;
    one.walls[3].thickness = 0.3;
    let mut level = Level::bare("1", 2.8, vec![one, rectangle("2", (2.8, 2.6), (6.0, 5.0))]);
    join(&mut level, [(0, 3), (1, 3)], (0.15, 1.0));
    let back = &footprints(&Storey::of(&level), &level.rooms[0])[2].back;
    // Not farther than the doorway begins, and up to it where the mitre comes so far.
    let deepest = back.iter().rfind(|behind| behind.outer.x > 3.2).unwrap().outer;
    assert!((deepest.y - 0.155).abs() < 1e-3 && (deepest.x - 3.345).abs() < 1e-3, "{back:?}");
}

#[test]
fn a_corner_of_unlike_walls_reaches_into_no_room() {
    // The thick wall in the south would send the eastern one 0.5 m round the corner, into the room in the south-east.
    let mut one = rectangle("1", (0.0, 0.0), (4.0, 3.0));
    one.walls[0].thickness = 0.5;
    let other = rectangle("2", (4.05, -3.0), (8.0, 0.0));
    let level = Level::bare("1", 2.8, vec![one, other]);
    let (depth, place) = deepest(&level);
    assert!(depth < LIMIT, "{depth} m at {place}");
}

#[test]
fn a_corner_reaches_into_no_doorway() {
    let mut level = Level::bare(
        "1",
        2.8,
        vec![
            rectangle("1", (0.0, 0.0), (4.0, 3.0)),
            rectangle("2", (4.3, 0.0), (8.0, 3.0)),
            rectangle("3", (0.0, -2.0), (4.1, -0.1)),
        ],
    );
    join(&mut level, [(0, 1), (1, 3)], (0.02, 0.9));
    // The third room's corner lies before the doorway; its thick wall in the north goes up into it.
    level.rooms[2].walls[2].thickness = 0.6;
    level.rooms[2].walls[1].thickness = 0.6;
    let storey = Storey::of(&level);
    for (wall, footprint) in level.rooms[2].walls.iter().zip(footprints(&storey, &level.rooms[2])) {
        let is_in_door = |point: &Point| point.x > 4.01 && point.x < 4.29 && point.y > 0.04 && point.y < 0.88;
        assert!(!points_along(&ring(wall, &footprint)).iter().any(is_in_door), "{footprint:?}");
    }
}

/// Adds a door between two walls, each by room and number, in metres along the first; the second runs against it.
fn join(level: &mut Level, walls: [(usize, usize); 2], (from, to): (f64, f64)) {
    let wall_of = |(room, wall): (usize, usize)| level.rooms[room].walls[wall].clone();
    let [first, second] = walls.map(wall_of);
    let ends = [from, to].map(|at| (first.after(at) - second.start).dot(second.direction()));
    let spans = [(from, to), (ends[1].max(0.0), ends[0].min(second.length()))];
    if spans.iter().any(|(from, to)| from >= to) {
        return;
    }
    let side = |(room, wall): (usize, usize), (from, to)| OpeningSide { room, wall, from, to };
    let sides = vec![side(walls[0], spans[0]), side(walls[1], spans[1])];
    let index = level.openings.len();
    for side in &sides {
        let OpeningSide { room, wall, from, to } = *side;
        level.rooms[room].openings.push(RoomOpening { opening: index, wall, from, to });
    }
    level.openings.push(Opening {
        id: index.to_string(),
        kind: OpeningKind::Passage,
        center: first.after(f64::midpoint(from, to)),
        along: first.direction(),
        width: to - from,
        bottom: 0.0,
        top: 2.0,
        leaves: Vec::new(),
        sides,
    });
}

/// Draws what random levels are made of.
struct Draw(ChaCha8Rng);

impl Draw {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * f64::from(self.0.next_u32()) / f64::from(u32::MAX)
    }

    fn below(&mut self, count: usize) -> usize {
        self.0.next_u32() as usize % count
    }

    /// A level of one room in the shape of a star, or of some between lines that are nearly straight or bent.
    fn level(&mut self) -> Level {
        let rooms = if self.below(3) == 0 { vec![self.star()] } else { self.row() };
        let mut level = Level::bare("1", 2.8, rooms);
        for room in &mut level.rooms {
            let is_even = self.below(2) == 0;
            let common = THICKNESSES[self.below(THICKNESSES.len())];
            for wall in &mut room.walls {
                let own = THICKNESSES[self.below(THICKNESSES.len())];
                wall.thickness = if is_even { common } else { own };
                wall.is_exterior = self.below(2) == 0;
            }
        }
        level
    }

    fn star(&mut self) -> Room {
        loop {
            let count = 3 + self.below(8);
            let mut angles: Vec<f64> =
                (0..count).map(|_| self.between(0.0, core::f64::consts::TAU)).collect();
            angles.sort_by(f64::total_cmp);
            let corners: Vec<Point> =
                angles.iter().map(|&angle| direction(angle) * self.between(0.5, 4.0)).collect();
            if let Ok(outline) = Polygon::new(&corners) {
                return Room::bare("1", "room", Region::simple(outline), 2.5, 0.2);
            }
        }
    }

    /// Rooms beside each other: the borders of neighbours are nearly parallel, or not at all.
    fn row(&mut self) -> Vec<Room> {
        let mut heights = vec![0.0];
        for _ in 0..2 + self.below(5) {
            heights.push(heights[heights.len() - 1] + self.between(0.03, 1.5));
        }
        let bend = [0.0, 0.01, 0.05, 0.4][self.below(4)];
        let mut west: Vec<Point> =
            heights.iter().map(|&y| Point::new(self.between(-bend, bend), y)).collect();
        let mut rooms = Vec::new();
        for number in 0..1 + self.below(3) {
            let width = self.between(1.0, 4.0);
            let east: Vec<Point> = west
                .iter()
                .map(|point| Point::new(point.x + width + self.between(0.0, bend), point.y))
                .collect();
            let last = west.len() - 1;
            let mut corners = vec![west[0], west[0].lerp(east[0], 0.5) - Point::Y * self.between(0.0, bend)];
            corners.extend(&east);
            corners.push(west[last].lerp(east[last], 0.5) + Point::Y * self.between(0.0, bend));
            corners.extend(west[1..].iter().rev());
            if let Ok(outline) = Polygon::new(&corners) {
                rooms.push(Room::bare(&number.to_string(), "room", Region::simple(outline), 2.5, 0.2));
            }
            let gap = GAPS[self.below(GAPS.len())];
            let more = GAPS[self.below(GAPS.len())];
            west = east
                .iter()
                .map(|point| Point::new(point.x + gap + self.between(0.0, more), point.y))
                .collect();
        }
        rooms
    }
}

/// 10,000 levels of one to three rooms; debug builds look at each tenth.
#[test]
fn no_wall_enters_a_room_of_random_levels() {
    let step = if cfg!(debug_assertions) { 10 } else { 1 };
    for seed in (0..10_000).step_by(step) {
        let level = Draw(ChaCha8Rng::seed_from_u64(seed)).level();
        let (depth, place) = deepest(&level);
        assert!(depth < LIMIT, "seed {seed}: {depth} m at {place}");
    }
}
