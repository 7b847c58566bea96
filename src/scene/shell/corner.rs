//! Computes the corners where the outer faces of neighbouring walls meet.

use super::behind::{Behind, Quad, clipped};
use super::storey::Storey;
use super::thickness::{THIN_SHEET, built_thickness};
use crate::geometry::{Point, Polygon, Region};
use crate::plan::{Room, Wall};

/// A wall's body seen from above; see [`super::wall::WallShape`] for the frame. Metres.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Footprint {
    /// From inner to outer face, where no other room is in the way.
    pub thickness: f64,
    /// The outer face, from the wall's start to its end.
    pub back: Vec<Behind>,
}

impl Footprint {
    /// The least depth behind the inner face.
    pub(crate) fn least_depth(&self) -> f64 {
        self.back.iter().map(|point| point.outer.y).fold(self.thickness, f64::min)
    }
}

impl Footprint {
    /// The same without what reaches round the corner at the wall's start, or at its end.
    pub(crate) fn square_at(mut self, is_start: bool, length: f64) -> Self {
        let corner = if is_start { 0.0 } else { length };
        let is_beyond =
            |behind: &Behind| if is_start { behind.outer.x < 0.0 } else { behind.outer.x > length };
        let depth = if is_start { self.back.first() } else { self.back.last() };
        let depth = depth.map_or(self.thickness, |behind| behind.outer.y);
        let foot = Behind { inner: corner, outer: Point::new(corner, depth) };
        let had_tip = self.back.iter().any(is_beyond);
        self.back.retain(|behind| !is_beyond(behind));
        let is_square = self.back.iter().any(|behind| behind.inner == corner && behind.outer.x == corner);
        if had_tip && !is_square {
            self.back.insert(if is_start { 0 } else { self.back.len() }, foot);
        }
        self
    }
}

/// How far the outer face may reach round a sharp corner, in thicknesses of the thicker wall: 2.5 serves
/// corners down to 45 degrees in full; below that the tip is cut.
const MITRE_LIMIT: f64 = 2.5;
/// Sine below which two walls run straight on.
const STRAIGHT: f64 = 0.02;
/// Cosine between the directions of two walls from which a mitre between unlike thicknesses would run far along them: both
/// end at the line that halves the corner instead, and the thicker one shows its end.
const NEARLY_STRAIGHT: f64 = 0.85;
/// Cosine between the directions of two walls up to which they stand back to back.
const BACK_TO_BACK: f64 = -0.5;
/// Metres that two walls must share along their direction to stand back to back.
const LEAST_OVERLAP: f64 = 1e-3;
/// Metres within which two faces meet.
const TOUCHING: f64 = 1e-6;
/// Metres of depth that the shortest wall keeps, so that its faces have area.
const LEAST_DEPTH: f64 = 1e-3;
/// The share of the thickness that remains where the corners at both ends take all of the outer face: not the very
/// tip, where the body would have no back.
const TIP: f64 = 0.98;

/// The footprints of a room's walls, by wall: none enters a room of the level.
pub(crate) fn footprints(storey: &Storey<'_>, room: &Room) -> Vec<Footprint> {
    let quads = quads(room);
    let walls = room.walls.iter().zip(quads);
    walls.map(|(wall, quad)| footprint(storey, wall, quad)).collect()
}

fn footprint(storey: &Storey<'_>, wall: &Wall, quad: Quad) -> Footprint {
    let Quad { length, outer: [from, to], thickness } = quad;
    let corner = |inner: f64, outer: f64| Behind { inner, outer: Point::new(outer, thickness) };
    let back = clipped(storey, wall, quad).unwrap_or_else(|| vec![corner(0.0, from), corner(length, to)]);
    Footprint { thickness, back }
}

/// The bodies of a room's walls, by wall, as their corners make them.
fn quads(room: &Room) -> Vec<Quad> {
    let bodies: Vec<WallBody<'_>> = room
        .walls
        .iter()
        .map(|wall| {
            // Real outlines fold back on themselves without any gap: even there a wall has a body.
            let clear = clear_depth(wall, &room.walls).max(THIN_SHEET);
            WallBody { wall, thickness: built_thickness(wall).min(clear) }
        })
        .collect();
    let mut quads = Vec::with_capacity(bodies.len());
    let mut rest = bodies.as_slice();
    for (is_hole, count) in ring_lengths(&room.region) {
        let (ring, after) = rest.split_at(count.min(rest.len()));
        rest = after;
        quads.extend((0..ring.len()).map(|index| {
            let (next, last) = ((index + 1) % ring.len(), (index + ring.len() - 1) % ring.len());
            // Each edge of a hole is reversed, their order is not: there the walk goes backwards.
            let (before, after) = if is_hole { (next, last) } else { (last, next) };
            quad(&ring[before], &ring[index], &ring[after])
        }));
    }
    quads
}

/// A wall with the thickness that is built.
#[derive(Clone, Copy)]
struct WallBody<'r> {
    wall: &'r Wall,
    thickness: f64,
}

/// Half of the distance from a wall's inner face to the nearest face of the same room behind it: a thin
/// partition drawn as a notch in the outline must not come out on its other side.
fn clear_depth(wall: &Wall, walls: &[Wall]) -> f64 {
    let (direction, outward, length) = (wall.direction(), -wall.normal(), wall.length());
    let local = |point: Point| {
        let offset = point - wall.start;
        Point::new(offset.dot(direction), offset.dot(outward))
    };
    let mut depth = f64::INFINITY;
    for other in walls {
        // In the order of `u`: faces that look the other way run the other way.
        let (low, high) = (local(other.end), local(other.start));
        let (from, to) = (low.x.max(0.0), high.x.min(length));
        if wall.direction().dot(other.direction()) > BACK_TO_BACK || to - from < LEAST_OVERLAP {
            continue;
        }
        let at = |u: f64| low.y + (high.y - low.y) * (u - low.x) / (high.x - low.x);
        let (nearest, farthest) = (at(from).min(at(to)), at(from).max(at(to)));
        let is_fold = direction.perp_dot(other.direction()).abs() < STRAIGHT;
        if nearest > TOUCHING {
            depth = depth.min(nearest / 2.0);
        } else if is_fold && nearest > -TOUCHING {
            // Both meet at a corner too sharp for a mitre: the wide end of the gap counts.
            depth = depth.min(farthest / 2.0);
        }
    }
    depth
}

/// Whether a ring of walls goes round a hole, and how many walls it has.
fn ring_lengths(region: &Region) -> impl Iterator<Item = (bool, usize)> {
    let count = |polygon: &Polygon| polygon.corners().len();
    let holes = region.holes.iter().map(move |hole| (true, count(hole)));
    std::iter::once((false, count(&region.outline))).chain(holes)
}

fn quad(before: &WallBody<'_>, body: &WallBody<'_>, after: &WallBody<'_>) -> Quad {
    let (length, thickness) = (body.wall.length(), body.thickness);
    let corner_at = |one: &WallBody<'_>, two: &WallBody<'_>, other: &WallBody<'_>| {
        reach_round_corner(one.wall.direction(), two.wall.direction(), [thickness, other.thickness])
    };
    let outer_from = -corner_at(before, body, before);
    let outer_to = length + corner_at(body, after, after);
    if outer_from < outer_to {
        return Quad { length, outer: [outer_from, outer_to], thickness };
    }
    // Both mitres meet before the outer face: the body becomes (nearly) the triangle below that point.
    let share = TIP * length / (length + outer_from - outer_to);
    Quad {
        length,
        outer: [outer_from * share, length - (length - outer_to) * share],
        thickness: (thickness * share).max(LEAST_DEPTH),
    }
}

/// How far an outer face goes past (or, below zero, stops short of) its inner corner: to where it meets the
/// neighbour's outer face. `before` and `after` run along the two walls, the room on their left;
/// `thickness` is that of the wall itself, then its neighbour's. The same for the wall before the corner as
/// for the one after it.
fn reach_round_corner(before: Point, after: Point, [thickness, other]: [f64; 2]) -> f64 {
    let (sine, cosine) = (before.perp_dot(after), before.dot(after));
    if sine.abs() < STRAIGHT {
        return 0.0;
    }
    if cosine > NEARLY_STRAIGHT {
        return thickness * sine / (1.0 + cosine);
    }
    let reach = (other - thickness * cosine) / sine;
    reach.min(MITRE_LIMIT * thickness.max(other))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Segment;
    use crate::plan::WallKind;

    fn walls(corners: &[(f64, f64)], thickness: &[f64]) -> Vec<Quad> {
        let points: Vec<Point> = corners.iter().map(|&(x, y)| Point::new(x, y)).collect();
        let region = Region::simple(Polygon::new(&points).unwrap());
        let walls = region.borders().enumerate().map(|(index, Segment { start, end })| Wall {
            start,
            end,
            thickness: thickness[index % thickness.len()],
            is_exterior: true,
            kind: WallKind::Solid,
            tags: Vec::new(),
        });
        let room = Room {
            id: "1".to_owned(),
            number: 1,
            name: None,
            room_type: "room".to_owned(),
            style: None,
            dwelling: None,
            household: None,
            home: None,
            walls: walls.collect(),
            region,
            height: 2.5,
            obstacles: Vec::new(),
            openings: Vec::new(),
        };
        quads(&room)
    }

    #[test]
    fn a_square_corner_reaches_round_by_the_neighbours_thickness() {
        let prints = walls(&[(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)], &[0.3, 0.1]);
        assert!((prints[0].outer[0] + 0.1).abs() < 1e-12 && (prints[0].outer[1] - 4.1).abs() < 1e-12);
        assert!((prints[1].outer[0] + 0.3).abs() < 1e-12 && (prints[1].outer[1] - 3.3).abs() < 1e-12);
    }

    #[test]
    fn a_concave_corner_stops_short() {
        let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (2.0, 2.0), (2.0, 4.0), (0.0, 4.0)];
        let prints = walls(&corners, &[0.2]);
        // Wall 2 ends and wall 3 begins at the inner corner (2, 2).
        assert!((prints[2].outer[1] - 1.8).abs() < 1e-12, "{:?}", prints[2]);
        assert!((prints[3].outer[0] - 0.2).abs() < 1e-12);
    }

    #[test]
    fn a_narrow_nib_keeps_a_back() {
        let corners =
            [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (2.1, 3.0), (2.1, 2.0), (2.0, 2.0), (2.0, 3.0), (0.0, 3.0)];
        let nib = walls(&corners, &[0.2])[4];
        assert!(nib.outer[0] < nib.outer[1] && nib.thickness < 0.2, "{nib:?}");
        assert!(nib.outer[0] > 0.0 && nib.outer[1] < 0.1, "{nib:?}");
    }

    #[test]
    fn a_sharp_corner_is_cut() {
        let prints = walls(&[(0.0, 0.0), (10.0, 0.0), (10.0, 1.0)], &[0.2]);
        assert!(prints[0].outer[0] >= -MITRE_LIMIT * 0.2 - 1e-12);
    }

    #[test]
    fn unlike_walls_that_run_nearly_straight_on_stop_at_one_line() {
        let corners = [(0.0, 0.0), (2.0, 0.0), (4.0, -0.06), (4.0, 3.0), (0.0, 3.0)];
        let prints = walls(&corners, &[0.35, 0.07, 0.07, 0.07, 0.07]);
        let slope = |along: f64, depth: f64| along / depth;
        let (thick, thin) = (slope(prints[0].outer[1] - 2.0, 0.35), slope(prints[1].outer[0], 0.07));
        // The line that halves the corner, seen from either wall: both stop short where the corner points into the room.
        assert!((thick + thin).abs() < 1e-9 && thick < 0.0, "{thick} {thin}");
    }

    #[test]
    fn a_wall_going_straight_on_ends_square() {
        let corners = [(0.0, 0.0), (2.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)];
        let prints = walls(&corners, &[0.1, 0.3, 0.1, 0.1, 0.1]);
        assert_eq!(prints[0].outer[1], 2.0);
        assert_eq!(prints[1].outer[0], 0.0);
    }
}
