//! Turns centre lines of walls into inner faces: takes half a wall's thickness off each edge that another room shares.
//!
//! ```text
//!   +-------+-------+          +------++------+
//!   |   a   |   b   |   ->     |  a   ||  b   |     outer edges stay where they are;
//!   +-------+-------+          +------++------+     their walls grow outwards
//! ```

use geo::{BooleanOps, unary_union};

use super::assemble::LooseIndex;
use super::clean::{Ring, clean_ring, largest_part, mean_width, meeting_point, to_points, to_surface};
use crate::geometry::{Point, Polygon, Segment};

/// Edges this close in metres to each other are the two sides of one centre line.
const SHARED_DISTANCE: f64 = 0.03;
/// Metres that two edges run beside each other before they count as shared.
const SHARED_LENGTH: f64 = 0.05;
/// Edges that are looked at beside one, and more of them for each of its metres. So many lie at one place only where rooms are
/// drawn upon each other.
const MOST_BESIDE: usize = 512;
const MOST_BESIDE_METRE: f64 = 64.0;
/// Sine of the largest angle between shared edges.
const SHARED_SINE: f64 = 0.03;
/// A room keeps at least this mean width in metres, or its inset is halved.
const NARROWEST_ROOM: f64 = 0.3;
/// How often an inset is halved before the room keeps its centre lines.
const HALVINGS: u32 = 3;
/// Parts that an inset may cut off, in square metres: a niche of a wall's width, no more.
const NEGLIGIBLE_PART: f64 = 0.1;
/// An edge this close in metres to an inset line came from it.
const SAME_LINE: f64 = 0.004;

/// A room's borders on centre lines.
#[derive(Clone, Debug)]
pub(super) struct CenterRoom {
    /// The outline.
    pub(super) ring: Ring,
    /// The holes.
    pub(super) holes: Vec<Polygon>,
}

/// Insets every room; the answer is in the order of `rooms`. Never loses a room: one that is too narrow gives less.
pub(super) fn inset_rooms(rooms: Vec<CenterRoom>, depth: f64) -> Vec<CenterRoom> {
    if depth <= 0.0 {
        return rooms;
    }
    let borders: Vec<Vec<Segment>> = rooms.iter().map(edges_of).collect();
    let index = LooseIndex::of(borders.iter().enumerate().flat_map(|(room, edges)| {
        let edges = edges.iter().enumerate();
        edges.map(move |(edge, segment)| (segment.bounds(), (room, edge)))
    }));
    let shared: Vec<Vec<bool>> = (0..rooms.len()).map(|room| shared_edges(room, &borders, &index)).collect();
    rooms.into_iter().zip(shared).map(|(room, shared)| inset_room(room, &shared, depth)).collect()
}

/// The inner faces of rooms whose outlines run along the middles of walls of some metres of thickness, each with the room on
/// its left; of a ring that encloses nothing there are none.
pub(crate) fn inner_faces(rings: &[&[Point]], thickness: f64) -> Vec<Vec<Segment>> {
    let cleaned: Vec<Option<Ring>> = rings.iter().map(|ring| clean_ring(ring, &[]).ok()).collect();
    let is_sound: Vec<bool> = cleaned.iter().map(Option::is_some).collect();
    let rooms = cleaned.into_iter().flatten().map(|ring| CenterRoom { ring, holes: Vec::new() }).collect();
    let mut inset = inset_rooms(rooms, thickness / 2.0).into_iter();
    let mut faces_of = |is_sound: bool| {
        let room = if is_sound { inset.next() } else { None };
        room.map(|room| room.ring.polygon.edges().collect()).unwrap_or_default()
    };
    is_sound.into_iter().map(&mut faces_of).collect()
}

/// The borders of a room in the order of [`crate::geometry::Region::borders`].
fn edges_of(room: &CenterRoom) -> Vec<Segment> {
    let holes = room.holes.iter().flat_map(Polygon::edges);
    room.ring.polygon.edges().chain(holes.map(Segment::reversed)).collect()
}

fn shared_edges(room: usize, borders: &[Vec<Segment>], index: &LooseIndex<(usize, usize)>) -> Vec<bool> {
    let own = &borders[room];
    let is_shared_by_any = |&border: &Segment| {
        let near = border.bounds().inflated(SHARED_DISTANCE);
        let most = MOST_BESIDE + (border.length() * MOST_BESIDE_METRE) as usize;
        let mut others = index.meeting(near).filter(|(other, _)| *other != room).take(most);
        others.any(|(other, edge)| is_shared(border, borders[other][edge]))
    };
    let mut shared: Vec<bool> = own.iter().map(is_shared_by_any).collect();
    // One straight wall has one face, also where it is part outer, part inner wall.
    let count = room_loop(own);
    let mut is_settled = false;
    while !is_settled {
        is_settled = true;
        for index in 0..count {
            let next = (index + 1) % count;
            if is_straight_on(own[index], own[next]) && shared[index] != shared[next] {
                (shared[index], shared[next]) = (true, true);
                is_settled = false;
            }
        }
    }
    shared
}

/// How many of the first edges form the closed outline.
fn room_loop(edges: &[Segment]) -> usize {
    edges.iter().position(|edge| edge.end == edges[0].start).map_or(edges.len(), |last| last + 1)
}

fn is_straight_on(first: Segment, second: Segment) -> bool {
    let (first, second) = (first.direction(), second.direction());
    first.dot(second) > 0.0 && first.perp_dot(second).abs() < SHARED_SINE
}

/// Whether the edges run in opposite directions on one line for a while.
fn is_shared(edge: Segment, far: Segment) -> bool {
    let along = edge.direction();
    if along.dot(far.direction()) > 0.0 || along.perp_dot(far.direction()).abs() > SHARED_SINE {
        return false;
    }
    let (from, to) = ((far.end - edge.start).dot(along), (far.start - edge.start).dot(along));
    let (low, high) = (from.max(0.0), to.min(edge.length()));
    if high - low < SHARED_LENGTH.min(edge.length() / 2.0) {
        return false;
    }
    // Distance of the far edge's line in the middle of the shared piece.
    let share = ((low + high) / 2.0 - from) / (to - from);
    let there = far.end + (far.start - far.end) * share;
    (there - edge.start).perp_dot(along).abs() < SHARED_DISTANCE
}

fn inset_room(room: CenterRoom, shared: &[bool], depth: f64) -> CenterRoom {
    let mut tried = depth;
    for _ in 0..=HALVINGS {
        let depths: Vec<f64> = shared.iter().map(|&shared| if shared { tried } else { 0.0 }).collect();
        if let Some(inset) = move_edges(&room, &depths).or_else(|| cut_strips(&room, &depths)) {
            return inset;
        }
        tried /= 2.0;
    }
    room
}

/// Moves each edge inwards and meets its neighbours again. `None` if an edge vanishes or the room gets too narrow.
fn move_edges(room: &CenterRoom, depths: &[f64]) -> Option<CenterRoom> {
    let count = room.ring.edges.len();
    let outline = move_loop(room.ring.polygon.corners(), &depths[..count])?;
    let polygon = Polygon::new(&outline).ok().filter(|polygon| polygon.corners() == outline)?;
    let mut first = count;
    let mut holes = Vec::with_capacity(room.holes.len());
    for hole in &room.holes {
        let edges = hole.corners().len();
        // Seen from inside the room a hole's border runs the other way, with negative depth.
        let inwards: Vec<f64> = depths[first..first + edges].iter().map(|depth| -depth).collect();
        holes.push(Polygon::new(&move_loop(hole.corners(), &inwards)?).ok()?);
        first += edges;
    }
    let inset = CenterRoom { ring: Ring { polygon, edges: room.ring.edges.clone() }, holes };
    is_wide_enough(&inset, room).then_some(inset)
}

fn is_wide_enough(inset: &CenterRoom, room: &CenterRoom) -> bool {
    let before = mean_width(&room.ring.polygon);
    // A room that was narrow to begin with may lose a third.
    mean_width(&inset.ring.polygon) >= NARROWEST_ROOM.min(before * 2.0 / 3.0)
}

fn move_loop(corners: &[Point], depths: &[f64]) -> Option<Vec<Point>> {
    let count = corners.len();
    let line = |index: usize| {
        let edge = Segment::new(corners[index], corners[(index + 1) % count]);
        edge.moved(edge.normal() * depths[index])
    };
    let moved: Vec<Point> = (0..count)
        .map(|index| {
            let (before, after) = (line((index + count - 1) % count), line(index));
            meeting_point(before, after).unwrap_or_else(|| before.end.midpoint(after.start))
        })
        .collect();
    let keeps_direction = (0..count).all(|index| {
        let next = (index + 1) % count;
        (moved[next] - moved[index]).dot(corners[next] - corners[index]) > 0.0
    });
    keeps_direction.then_some(moved)
}

/// Takes strips along the shared edges off the room: slower, but niches may vanish.
fn cut_strips(room: &CenterRoom, depths: &[f64]) -> Option<CenterRoom> {
    let edges = edges_of(room).into_iter().zip(depths);
    let strips: Vec<geo::Polygon<f64>> =
        edges.filter(|(_, depth)| **depth > 0.0).filter_map(|(edge, depth)| strip(edge, *depth)).collect();
    let surface = to_surface(&room.ring.polygon, &room.holes);
    let (part, rest) = largest_part(surface.difference(&unary_union(strips.iter())))?;
    let ring = clean_ring(&to_points(part.exterior()), &[]).ok()?;
    let holes = part
        .interiors()
        .iter()
        .filter_map(|hole| clean_ring(&to_points(hole), &[]).ok())
        .map(|hole| hole.polygon)
        .collect();
    let edges = trace(&ring.polygon, &room.ring, depths);
    let inset = CenterRoom { ring: Ring { polygon: ring.polygon, edges }, holes };
    (rest < NEGLIGIBLE_PART && is_wide_enough(&inset, room)).then_some(inset)
}

/// The piece of wall on the inside of an edge, longer than the edge so that corners are filled.
fn strip(edge: Segment, depth: f64) -> Option<geo::Polygon<f64>> {
    let along = edge.direction();
    let inwards = along.perp() * depth;
    // Not quite the full depth: the strip must not reach past the neighbour's own strip.
    let (start, end) = (edge.start - along * depth * 0.999, edge.end + along * depth * 0.999);
    let outwards = along.perp() * -SAME_LINE;
    let corners = [start + outwards, end + outwards, end + inwards, start + inwards];
    Some(to_surface(&Polygon::new(&corners).ok()?, &[]))
}

/// Finds for each edge of the cut room the edge of the centre line from which it comes.
fn trace(polygon: &Polygon, origin: &Ring, depths: &[f64]) -> Vec<Option<usize>> {
    let comes_from = |edge: Segment, source: Segment, depth: f64| {
        let along = source.direction();
        let middle = edge.middle() - source.start;
        let offset = along.perp_dot(middle);
        along.dot(edge.vector()) > 0.0
            && along.perp_dot(edge.vector()).abs() < SAME_LINE
            && (offset - depth).abs() < SAME_LINE
            && middle.dot(along) > 0.0
            && middle.dot(along) < source.length()
    };
    polygon
        .edges()
        .map(|edge| {
            let mut sources = origin.polygon.edges().zip(&origin.edges).zip(depths);
            sources.find_map(|((source, &found), &depth)| comes_from(edge, source, depth).then_some(found)?)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::sample::points;

    fn room(list: &[(f64, f64)]) -> CenterRoom {
        CenterRoom { ring: clean_ring(&points(list), &[]).unwrap(), holes: Vec::new() }
    }

    fn block(x: f64, y: f64, width: f64, depth: f64) -> CenterRoom {
        room(&[(x, y), (x + width, y), (x + width, y + depth), (x, y + depth)])
    }

    /// Square metres by room, in units of a square centimetre so that they compare.
    fn areas(rooms: Vec<CenterRoom>, depth: f64) -> Vec<i64> {
        let inset = inset_rooms(rooms, depth);
        let area =
            |room: &CenterRoom| room.ring.polygon.area() - room.holes.iter().map(Polygon::area).sum::<f64>();
        inset.iter().map(|room| square_centimetres(area(room))).collect()
    }

    fn square_centimetres(area: f64) -> i64 {
        (area * 1e4).round() as i64
    }

    fn expected<const N: usize>(areas: [f64; N]) -> Vec<i64> {
        areas.map(square_centimetres).to_vec()
    }

    #[test]
    fn only_shared_edges_move() {
        let rooms = vec![block(0.0, 0.0, 4.0, 3.0), block(4.0, 0.0, 2.0, 3.0)];
        assert_eq!(areas(rooms.clone(), 0.1), expected([3.9 * 3.0, 1.9 * 3.0]));
        assert_eq!(areas(rooms, 0.0), expected([12.0, 6.0]));
        let apart = vec![block(0.0, 0.0, 4.0, 3.0), block(4.2, 0.0, 2.0, 3.0)];
        assert_eq!(areas(apart, 0.1), expected([12.0, 6.0]));
    }

    #[test]
    fn a_wall_that_is_half_outer_moves_as_one() {
        // The long room's north wall has a neighbour on half its length.
        let rooms = vec![block(0.0, 0.0, 8.0, 2.0), block(0.0, 2.0, 4.0, 2.0)];
        assert_eq!(areas(rooms, 0.1), expected([8.0 * 1.9, 4.0 * 1.9]));
    }

    #[test]
    fn reflex_corners_are_mitred() {
        let bent = room(&[(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (2.0, 4.0), (2.0, 2.0), (0.0, 2.0)]);
        let rooms = vec![bent, block(0.0, 2.0, 2.0, 2.0)];
        assert_eq!(areas(rooms, 0.1), expected([12.0 - 2.0 * 0.2 - 0.01, 1.9 * 1.9]));
    }

    #[test]
    fn a_niche_narrower_than_the_wall_vanishes_and_the_room_stays() {
        let niche = room(&[
            (0.0, 0.0),
            (4.0, 0.0),
            (4.0, 1.0),
            (4.1, 1.0),
            (4.1, 1.15),
            (4.0, 1.15),
            (4.0, 3.0),
            (0.0, 3.0),
        ]);
        let around = room(&[
            (4.0, 0.0),
            (8.0, 0.0),
            (8.0, 3.0),
            (4.0, 3.0),
            (4.0, 1.15),
            (4.1, 1.15),
            (4.1, 1.0),
            (4.0, 1.0),
        ]);
        let found = areas(vec![niche, around], 0.1);
        assert!((found[0] - square_centimetres(3.9 * 3.0)).abs() < 200, "{found:?}");
        assert!((found[1] - square_centimetres(3.9 * 3.0)).abs() < 800, "{found:?}");
    }

    #[test]
    fn narrow_rooms_give_less() {
        let rooms = vec![block(0.0, 0.0, 4.0, 3.0), block(0.0, 3.0, 4.0, 0.4), block(0.0, 3.4, 4.0, 3.0)];
        let found = areas(rooms, 0.1);
        // 0.05 m from each side: the next try that leaves 0.3 m.
        assert_eq!(found, expected([4.0 * 2.9, 4.0 * 0.3, 4.0 * 2.9]));
    }

    #[test]
    fn a_room_in_a_hole_keeps_a_wall_around_it() {
        let mut outer = block(0.0, 0.0, 6.0, 6.0);
        outer.holes.push(block(2.0, 2.0, 2.0, 2.0).ring.polygon);
        let found = areas(vec![outer, block(2.0, 2.0, 2.0, 2.0)], 0.1);
        assert_eq!(found, expected([36.0 - 2.2 * 2.2, 1.8 * 1.8]));
    }

    #[test]
    fn edges_keep_their_origin() {
        let rooms = vec![block(0.0, 0.0, 4.0, 3.0), block(4.0, 0.0, 2.0, 3.0)];
        let inset = inset_rooms(rooms, 0.1);
        assert_eq!(inset[0].ring.edges, [0, 1, 2, 3].map(Some));
        assert!(inset[0].ring.polygon.corners().contains(&Point::new(3.9, 3.0)));
    }
}
