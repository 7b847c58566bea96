//! Finds what is behind each wall: thickness, open air, railings.

use super::index::{OutlineIndex, WallIndex, WallPlace};
use crate::geometry::{Bounds, Point, Polygon, Region, Segment, ray_hit};
use crate::plan::{LevelDraft, Room, Wall, WallKind};

/// A neighbouring room is looked for this many metres behind a wall; thicker inner walls count as outer ones.
const THICKEST_INNER_WALL: f64 = 0.6;
/// Metres between the rays of a wall.
const RAY_INTERVAL: f64 = 0.5;
/// Walls that are looked at behind one, and more of them for each of its rays.
const MOST_BEHIND: usize = 256;
const MOST_BEHIND_RAY: usize = 16;
/// Metres that a ray starts inside the room, so that a face shared with the neighbour is hit.
const RAY_BACKSTEP: f64 = 0.02;
/// Cosine between a ray and the wall it may hit: no grazing hits.
const FACING: f64 = 0.7;
/// A railing this close in metres to a room's edge stands on it.
const RAILING_REACH: f64 = 0.12;
/// Metres of a railing from its inner to its outer face, at most: the walls of the building are no measure for it.
const RAILING_THICKNESS: f64 = 0.12;
/// Metres through a drawn railing, at most, where it runs along a wall; one that ends at a wall is deeper, seen from there.
const THICKEST_RAILING: f64 = 0.4;
/// Metres of a railing above the floor; formats that draw railings give no height that can be used.
const RAILING_HEIGHT: f64 = 1.0;
/// Metres of the thinnest outer wall that a drawing may show.
const THINNEST_OUTER_WALL: f64 = 0.02;

/// The walls of a region before anything behind them is known, in the order of [`Region::borders`].
pub(super) fn bare_walls(region: &Region) -> Vec<Wall> {
    region
        .borders()
        .map(|Segment { start, end }| Wall {
            start,
            end,
            thickness: 0.0,
            is_exterior: true,
            kind: WallKind::Solid,
            tags: Vec::new(),
        })
        .collect()
}

/// The parts of the drawing besides rooms.
pub(super) struct Drawn<'a> {
    /// Outlines of solid walls.
    pub(super) solids: &'a OutlineIndex,
    /// Outlines of railings.
    pub(super) railings: &'a OutlineIndex,
}

/// Finds thickness, `is_exterior` and kind of every wall of the level.
pub(super) fn back_walls(rooms: &mut [Room], drawn: &Drawn<'_>, draft: &LevelDraft) {
    let index = WallIndex::of(rooms);
    let railed: Vec<Vec<bool>> = rooms.iter().map(|room| railed(&room.walls, drawn.railings)).collect();
    for (room, number) in places(rooms) {
        let backing = backing_of(rooms, &index, WallPlace { room, wall: number });
        let wall = &mut rooms[room].walls[number];
        let is_railed = railed[room][number];
        if is_railed {
            wall.kind = WallKind::Railing(RAILING_HEIGHT);
        }
        wall.is_exterior = backing.is_exterior;
        wall.thickness = match backing.gap {
            Some(gap) if !backing.is_exterior => gap / 2.0,
            gap => {
                let outer = drawn_thickness(wall, drawn.solids).unwrap_or(draft.exterior_thickness);
                let outer = if is_railed { outer.min(RAILING_THICKNESS) } else { outer };
                gap.map_or(outer, |gap| outer.min(gap / 2.0))
            }
        };
    }
}

fn places(rooms: &[Room]) -> Vec<(usize, usize)> {
    rooms
        .iter()
        .enumerate()
        .flat_map(|(room, value)| (0..value.walls.len()).map(move |wall| (room, wall)))
        .collect()
}

/// The findings of rays that go out behind a wall.
struct Backing {
    /// Metres to the nearest room behind, if any ray met one.
    gap: Option<f64>,
    /// Whether most rays met none.
    is_exterior: bool,
}

fn backing_of(rooms: &[Room], index: &WallIndex, place: WallPlace) -> Backing {
    let wall = &rooms[place.room].walls[place.wall];
    let outwards = -wall.normal();
    let origins = ray_origins(wall);
    let most = MOST_BEHIND + MOST_BEHIND_RAY * origins.len();
    let near = index.some_near(wall.segment(), THICKEST_INNER_WALL, most);
    // What a ray may enter a room through.
    let near = near.into_iter().filter(|&far| far != place).map(|far| &rooms[far.room].walls[far.wall]);
    let faces: Vec<Segment> =
        near.filter(|far| far.normal().dot(outwards) > FACING).map(Wall::segment).collect();
    let gaps: Vec<f64> = origins
        .iter()
        .filter_map(|&origin| {
            let start = origin - outwards * RAY_BACKSTEP;
            faces.iter().filter_map(|face| ray_hit(start, outwards, *face)).min_by(f64::total_cmp)
        })
        .map(|distance| (distance - RAY_BACKSTEP).max(0.0))
        .filter(|&gap| gap <= THICKEST_INNER_WALL)
        .collect();
    Backing { gap: gaps.iter().copied().min_by(f64::total_cmp), is_exterior: gaps.len() * 2 < origins.len() }
}

fn ray_origins(wall: &Wall) -> Vec<Point> {
    let count = (wall.length() / RAY_INTERVAL).ceil().clamp(3.0, 400.0) as usize;
    (0..count).map(|i| wall.start.lerp(wall.end, (i as f64 + 0.5) / count as f64)).collect()
}

/// Metres of solid wall that the drawing shows behind the middle of a wall.
fn drawn_thickness(wall: &Wall, solids: &OutlineIndex) -> Option<f64> {
    let middle = wall.start.midpoint(wall.end);
    let outwards = -wall.normal();
    let far = middle + outwards * THICKEST_INNER_WALL;
    let start = middle + outwards * THINNEST_OUTER_WALL;
    let near = solids.near(Segment::new(middle, far).bounds());
    let solid = near.into_iter().find(|solid| solid.contains(start))?;
    let exit = solid.edges().filter_map(|edge| ray_hit(start, outwards, edge)).min_by(f64::total_cmp)?;
    (exit <= THICKEST_INNER_WALL).then_some(exit + THINNEST_OUTER_WALL)
}

/// Which walls of a room are railings: those on which railings stand, in stretches of walls that meet. Where a railing only ends at
/// a wall, the stretch is as wide as the railing, and stays a wall.
fn railed(walls: &[Wall], railings: &OutlineIndex) -> Vec<bool> {
    if railings.is_empty() {
        return vec![false; walls.len()];
    }
    let shares: Vec<[f64; 2]> = walls.iter().map(|wall| railed_shares(wall, railings)).collect();
    let mut is_railed: Vec<bool> = shares.iter().map(|&[near, _]| near > 0.5).collect();
    let is_next = |one: usize, two: usize| {
        let (one, two) = (&walls[one], &walls[two]);
        // The edges of a hole are reversed, their order is not.
        one.end == two.start || one.start == two.end
    };
    let mut stretches: Vec<Vec<usize>> = Vec::new();
    for index in (0..walls.len()).filter(|&index| is_railed[index]) {
        match stretches.last_mut().filter(|stretch| is_next(stretch[stretch.len() - 1], index)) {
            Some(stretch) => stretch.push(index),
            None => stretches.push(vec![index]),
        }
    }
    if let [first, .., last] = &mut stretches[..]
        && is_next(last[last.len() - 1], first[0])
    {
        // Round the first corner of the outline.
        first.append(last);
    }
    for stretch in stretches {
        let length: f64 = stretch.iter().map(|&index| walls[index].length()).sum();
        let along: f64 = stretch.iter().map(|&index| walls[index].length() * shares[index][1]).sum();
        if along < 0.5 * length {
            stretch.iter().for_each(|&index| is_railed[index] = false);
        }
    }
    is_railed
}

/// The shares of a wall on which railings stand, and of it along which they run.
fn railed_shares(wall: &Wall, railings: &OutlineIndex) -> [f64; 2] {
    if railings.near(wall.segment().bounds().inflated(RAILING_REACH)).is_empty() {
        return [0.0; 2];
    }
    let origins = ray_origins(wall);
    let outwards = -wall.normal();
    let mut counts = [0, 0];
    for &origin in &origins {
        let start = origin - outwards * RAY_BACKSTEP;
        let near = railings.near(Bounds::around_point(origin, RAILING_REACH));
        let depths: Vec<f64> =
            near.into_iter().filter_map(|railing| railing_depth(railing, start, outwards)).collect();
        counts[0] += usize::from(!depths.is_empty());
        counts[1] += usize::from(depths.iter().any(|&depth| depth <= THICKEST_RAILING));
    }
    counts.map(|count| count as f64 / origins.len() as f64)
}

/// Metres that a ray goes through a railing near its start; none where it meets none there.
fn railing_depth(railing: &Polygon, start: Point, outwards: Point) -> Option<f64> {
    let mut hits: Vec<f64> = railing.edges().filter_map(|edge| ray_hit(start, outwards, edge)).collect();
    hits.sort_by(f64::total_cmp);
    // A ray that begins in the railing only leaves it.
    let from = if railing.contains(start) { 0.0 } else { hits.first().copied()? };
    let to = hits.iter().copied().find(|&hit| hit > from).unwrap_or(from);
    (from < RAILING_REACH).then_some(to - from)
}
