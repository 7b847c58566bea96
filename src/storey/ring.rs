//! Rings of corners on a grid of a millimetre: cut by straight lines, joined along edges that they share.
//!
//! Storeys are made by cutting and by joining what was cut, never by placing things beside each other: so that rooms cover their
//! storey and do not overlap, whatever its outline.

pub(super) use crate::geometry::signed_area as area;
use crate::geometry::{Bounds, Point, Segment, edges};

/// Steps of the grid in a metre.
const GRID: f64 = 1000.0;
/// A corner this close in metres to a line lies on it: half a step of the grid, and what rounding adds.
const ON_LINE: f64 = 0.0011;
/// Square of the metres of an edge above which edges that run along it are not farther from it than [`BESIDE`].
const LEAST_SURE: f64 = 0.01;
/// Metres: an edge of 0.1 m and others whose ends are twice [`ON_LINE`], times that length, to its side are closer.
const BESIDE: f64 = 0.03;
/// Pieces below this many square metres are what rounding leaves.
const CRUMB: f64 = 0.01;

/// Corners of a simple polygon, counter-clockwise, each on the grid; the last is not the first.
pub(super) type Ring = Vec<Point>;

/// An axis of the frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Axis {
    /// East.
    X,
    /// North.
    Y,
}

/// The nearest point of the grid.
pub(super) fn on_grid(point: Point) -> Point {
    // Adding zero makes negative zero zero.
    Point::new(rounded(point.x * GRID) / GRID + 0.0, rounded(point.y * GRID) / GRID + 0.0)
}

/// As [`f64::round`], without the call of a function that it is on processors of no special kind.
fn rounded(number: f64) -> f64 {
    let whole = number as i64 as f64;
    let rest = number - whole;
    match rest.abs() < 1.0 {
        true => whole + f64::from(i8::from(rest >= 0.5) - i8::from(rest <= -0.5)),
        // No number, or none that has a fraction.
        false => number.round(),
    }
}

/// The box around a ring.
pub(super) fn bounds(ring: &[Point]) -> Bounds {
    Bounds::around(ring.iter().copied())
}

/// The coordinate of a point along an axis.
pub(super) fn along(point: Point, axis: Axis) -> f64 {
    match axis {
        Axis::X => point.x,
        Axis::Y => point.y,
    }
}

/// The pieces of a ring below and above a coordinate of an axis; largest first on each side.
pub(super) fn split(ring: &[Point], axis: Axis, at: f64) -> (Vec<Ring>, Vec<Ring>) {
    // A corner on the line counts as above, so that each edge crosses the line or does not.
    let height = |point: Point| along(point, axis) - at;
    let is_above = |corner: Point| height(corner) > -ON_LINE;
    let above_count = ring.iter().filter(|corner| is_above(**corner)).count();
    if above_count == ring.len() {
        return (Vec::new(), vec![ring.to_vec()]);
    }
    if above_count == 0 {
        return (vec![ring.to_vec()], Vec::new());
    }
    let (nodes, crossings) = with_crossings(ring, is_above, axis, at);
    // One cut between places that are no corners leaves two rings as simple as the whole.
    let near = |corner: &&Point| height(**corner).abs() <= 3.0 * ON_LINE;
    let is_plain = crossings.len() == 2 && !ring.iter().any(|corner| near(&corner));
    let partners = partners(&nodes, crossings, axis);
    let side = |above: bool| {
        let mut pieces = chains(&nodes, &partners, above);
        if !is_plain {
            pieces = pieces.into_iter().flat_map(unfolded).collect();
        }
        pieces.retain(|piece| piece.len() > 2 && area(piece) > CRUMB);
        if pieces.len() > 1 {
            pieces.sort_by(|a, b| area(b).total_cmp(&area(a)));
        }
        pieces
    };
    (side(false), side(true))
}

/// A corner of a ring that is cut, or a place where the cut crosses an edge.
#[derive(Clone, Copy)]
struct Node {
    point: Point,
    /// None of a crossing.
    is_above: Option<bool>,
    /// Whether the ring goes up at a crossing.
    goes_up: bool,
}

fn with_crossings(
    ring: &[Point],
    is_above: impl Fn(Point) -> bool,
    axis: Axis,
    at: f64,
) -> (Vec<Node>, Vec<usize>) {
    let mut nodes = Vec::with_capacity(ring.len() + 4);
    let mut crossings = Vec::new();
    for edge in edges(ring) {
        let (from, to) = (is_above(edge.start), is_above(edge.end));
        nodes.push(Node { point: edge.start, is_above: Some(from), goes_up: false });
        if from == to {
            continue;
        }
        let (low, high) = (along(edge.start, axis) - at, along(edge.end, axis) - at);
        let crossing = match (low.abs() <= ON_LINE, high.abs() <= ON_LINE) {
            (true, _) => edge.start,
            (false, true) => edge.end,
            (false, false) => {
                let point = edge.at(low / (low - high));
                on_grid(match axis {
                    Axis::X => Point::new(at, point.y),
                    Axis::Y => Point::new(point.x, at),
                })
            }
        };
        crossings.push(nodes.len());
        nodes.push(Node { point: crossing, is_above: None, goes_up: to });
    }
    (nodes, crossings)
}

/// Each node that is a crossing, rising, with the other end of the piece of the line inside the ring.
fn partners(nodes: &[Node], mut crossings: Vec<usize>, axis: Axis) -> Vec<(usize, usize)> {
    let other = if axis == Axis::X { Axis::Y } else { Axis::X };
    let place = |index: &usize| along(nodes[*index].point, other);
    crossings.sort_by(|a, b| place(a).total_cmp(&place(b)).then(a.cmp(b)));
    // Along the line the ring goes up and down by turns; of two crossings in one corner, either may be the first.
    for index in 1..crossings.len().saturating_sub(1) {
        let [before, here, next] = [crossings[index - 1], crossings[index], crossings[index + 1]];
        let is_out_of_turn = nodes[before].goes_up == nodes[here].goes_up;
        if is_out_of_turn && nodes[next].goes_up != nodes[here].goes_up && place(&here) == place(&next) {
            crossings.swap(index, index + 1);
        }
    }
    let mut pairs: Vec<(usize, usize)> =
        crossings.chunks_exact(2).flat_map(|pair| [(pair[0], pair[1]), (pair[1], pair[0])]).collect();
    pairs.sort_unstable();
    pairs
}

/// The rings on one side of the line.
fn chains(nodes: &[Node], partners: &[(usize, usize)], above: bool) -> Vec<Ring> {
    let mut is_done = vec![false; nodes.len()];
    let mut pieces = Vec::new();
    for start in 0..nodes.len() {
        if nodes[start].is_above != Some(above) || is_done[start] {
            continue;
        }
        let mut piece: Ring = Vec::new();
        let mut index = start;
        for _ in 0..2 * nodes.len() {
            let node = nodes[index];
            push_corner(&mut piece, node.point);
            is_done[index] = true;
            // Where the ring leaves this side, it goes on where it comes back.
            if node.is_above.is_none() && node.goes_up != above {
                let Ok(pair) = partners.binary_search_by_key(&index, |(from, _)| *from) else { break };
                let back = partners[pair].1;
                push_corner(&mut piece, nodes[back].point);
                is_done[back] = true;
                index = back;
            }
            index = (index + 1) % nodes.len();
            if index == start {
                break;
            }
        }
        pieces.push(tidy(piece));
    }
    pieces
}

fn push_corner(ring: &mut Ring, point: Point) {
    if ring.last() != Some(&point) {
        ring.push(point);
    }
}

/// Without repeated corners, and without spikes that go out and back.
pub(super) fn tidy(mut ring: Ring) -> Ring {
    let mut index = 0;
    let mut kept = 0;
    while ring.len() > 2 && kept < ring.len() {
        let count = ring.len();
        index %= count;
        let (before, here, after) =
            (ring[(index + count - 1) % count], ring[index], ring[(index + 1) % count]);
        if here == after || before == after {
            ring.remove(index);
            kept = 0;
        } else {
            index += 1;
            kept += 1;
        }
    }
    ring
}

/// The ring without corners at which it goes out and back along a line, or so close beside it that no width is left on the grid.
pub(super) fn without_spikes(mut ring: Ring) -> Ring {
    let is_spike = |ring: &Ring, index: usize| {
        let count = ring.len();
        let (before, here, after) =
            (ring[(index + count - 1) % count], ring[index], ring[(index + 1) % count]);
        let (there, back) = (Segment::new(before, here), Segment::new(here, after));
        let is_thin = there.distance(after) <= ON_LINE || back.distance(before) <= ON_LINE;
        is_thin && there.vector().dot(back.vector()) < 0.0
    };
    while let Some(index) = (0..ring.len()).find(|&index| ring.len() > 3 && is_spike(&ring, index)) {
        ring.remove(index);
    }
    ring
}

/// The ring without corners that lie on the line between their neighbours.
pub(super) fn without_straight_corners(ring: &[Point]) -> Ring {
    let count = ring.len();
    let bends = |index: &usize| {
        let (before, here, after) =
            (ring[(index + count - 1) % count], ring[*index], ring[(index + 1) % count]);
        Segment::new(before, after).side(here).abs() > ON_LINE
    };
    let kept: Ring = (0..count).filter(bends).map(|index| ring[index]).collect();
    if kept.len() > 2 { kept } else { ring.to_vec() }
}

/// One ring of two that share edges; `None` where they do not, or where a hole would be left between them.
pub(super) fn join(first: &[Point], second: &[Point]) -> Option<Ring> {
    let (first, second) = (with_corners_of(first, second), with_corners_of(second, first));
    let all: Vec<Side> = edges(&first).chain(edges(&second)).map(Side::of).collect();
    let count = all.len();
    let border = without_doubled(all);
    if border.len() == count {
        return None;
    }
    let [ring] = rings_of(&border)?.try_into().ok()?;
    (area(&ring) > 0.0).then(|| without_straight_corners(&tidy(ring)))
}

/// A ring that runs back along itself or touches itself, as the rings that it consists of.
fn unfolded(ring: Ring) -> Vec<Ring> {
    if !touches_itself(&ring) {
        return vec![ring];
    }
    let detailed = with_corners_of(&ring, &ring);
    let border = without_doubled(edges(&detailed).map(Side::of).collect());
    let rings = rings_of(&border).unwrap_or_else(|| vec![ring]);
    rings.into_iter().map(|ring| without_straight_corners(&tidy(ring))).collect()
}

/// Whether a ring meets itself in a corner or with a corner on an edge; where it does not, no edge runs there and back.
fn touches_itself(ring: &[Point]) -> bool {
    let mut keys: Vec<Key> = ring.iter().map(|&corner| key(corner)).collect();
    keys.sort_unstable();
    keys.windows(2).any(|pair| pair[0] == pair[1])
        || edges(ring).any(|edge| ring.iter().any(|&corner| place_on(edge, corner).is_some()))
}

/// A corner in steps of the grid.
pub(super) type Key = (i64, i64);

/// See [`Key`].
pub(super) fn key(point: Point) -> Key {
    (rounded(point.x * GRID) as i64, rounded(point.y * GRID) as i64)
}

/// An edge with the keys of its ends.
struct Side {
    edge: Segment,
    from: Key,
    to: Key,
}

impl Side {
    fn of(edge: Segment) -> Self {
        Self { edge, from: key(edge.start), to: key(edge.end) }
    }
}

/// Edges without those that run there and back.
fn without_doubled(mut all: Vec<Side>) -> Vec<Side> {
    let mut directed: Vec<(Key, Key)> = all.iter().map(|side| (side.from, side.to)).collect();
    directed.sort_unstable();
    all.retain(|side| directed.binary_search(&(side.to, side.from)).is_err());
    all
}

/// Edges linked into rings; `None` where they do not close. A ring that meets itself in a corner becomes two.
fn rings_of(border: &[Side]) -> Option<Vec<Ring>> {
    // By the corner that an edge begins at; the last of several is taken first.
    let mut next: Vec<(Key, Option<Point>)> =
        border.iter().map(|side| (side.from, Some(side.edge.end))).collect();
    next.sort_by_key(|(from, _)| *from);
    let mut take = |from: Key, is_taken: bool| {
        let first = next.partition_point(|(corner, _)| *corner < from);
        let same = next[first..].iter_mut().take_while(|(corner, _)| *corner == from);
        let end = same.map(|(_, end)| end).filter(|end| end.is_some()).last()?;
        if is_taken { end.take() } else { *end }
    };
    let mut rings = Vec::new();
    let mut path: Ring = Vec::with_capacity(border.len());
    // By corner of the path: its key, which would else be made anew for each comparison.
    let mut keys: Vec<Key> = Vec::with_capacity(border.len());
    for side in border {
        if take(side.from, false).is_none() {
            continue;
        }
        let mut at = side.edge.start;
        loop {
            let here = key(at);
            if let Some(place) = keys.iter().position(|&key| key == here) {
                rings.push(path.split_off(place));
                keys.truncate(place);
                if path.is_empty() && take(here, false).is_none() {
                    break;
                }
            }
            path.push(at);
            keys.push(here);
            at = take(here, true)?;
        }
    }
    Some(rings)
}

/// Metres along an edge at which a corner lies on it, between its ends.
fn place_on(edge: Segment, corner: Point) -> Option<f64> {
    // Most corners are elsewhere, which is told without a square root.
    if edge.side(corner).abs() >= 2.0 * ON_LINE || corner == edge.start || corner == edge.end {
        return None;
    }
    let place = (corner - edge.start).dot(edge.direction());
    (place > 0.0 && place < edge.length()).then_some(place)
}

/// A ring with the corners of another that lie on its edges.
fn with_corners_of(ring: &[Point], other: &[Point]) -> Ring {
    let mut corners = Vec::with_capacity(ring.len() + 4);
    let mut on_edge: Vec<(f64, Point)> = Vec::new();
    for edge in edges(ring) {
        push_corner(&mut corners, edge.start);
        on_edge.extend(other.iter().filter_map(|&corner| Some((place_on(edge, corner)?, corner))));
        on_edge.sort_by(|a, b| a.0.total_cmp(&b.0));
        on_edge.drain(..).for_each(|(_, corner)| push_corner(&mut corners, corner));
    }
    corners
}

/// Metres that two rings run beside each other, as segments with the first ring on their left.
pub(super) fn shared(first: &[Point], second: &[Point]) -> Vec<Segment> {
    let mut found = Vec::new();
    let reach = bounds(second).inflated(BESIDE);
    for edge in edges(first) {
        // Most edges are elsewhere, which is told by a box, or else without a square root.
        if edge.vector().length_squared() > LEAST_SURE && !edge.bounds().touches(reach) {
            continue;
        }
        let is_near = |far: &Segment| {
            edge.side(far.start).abs() <= 2.0 * ON_LINE && edge.side(far.end).abs() <= 2.0 * ON_LINE
        };
        for far in edges(second).filter(is_near) {
            let (length, direction) = (edge.length(), edge.direction());
            if far.direction().dot(direction) >= -0.9999 {
                continue;
            }
            let from = (far.end - edge.start).dot(direction).max(0.0);
            let to = (far.start - edge.start).dot(direction).min(length);
            if to - from > 2.0 * ON_LINE {
                found.push(Segment::new(edge.start + direction * from, edge.start + direction * to));
            }
        }
    }
    found
}

/// The longest of some pieces, the first of equals.
pub(super) fn longest(pieces: Vec<Segment>) -> Option<Segment> {
    pieces.into_iter().reduce(|best, next| if next.length() > best.length() { next } else { best })
}

/// Metres of all pieces together.
pub(super) fn total_length(pieces: &[Segment]) -> f64 {
    pieces.iter().map(|piece| piece.length()).sum()
}

/// Metres of the longest stretch that two rings share.
pub(super) fn shared_length(first: &[Point], second: &[Point]) -> f64 {
    longest(shared(first, second)).map_or(0.0, Segment::length)
}

/// Corners at which a ring turns inwards.
pub(super) fn inner_corners(ring: &[Point]) -> impl Iterator<Item = Point> + '_ {
    let count = ring.len();
    (0..count)
        .filter(move |&index| {
            let (before, here, after) =
                (ring[(index + count - 1) % count], ring[index], ring[(index + 1) % count]);
            Segment::new(before, here).direction().perp_dot(Segment::new(here, after).direction()) < -0.1
        })
        .map(move |index| ring[index])
}

/// The ring turned clockwise by a quarter, so that what ran north runs east.
pub(super) fn turned(ring: &[Point]) -> Ring {
    ring.iter().map(|corner| turned_point(*corner)).collect()
}

/// See [`turned`].
pub(super) fn turned_point(point: Point) -> Point {
    Point::new(point.y, -point.x)
}

/// The opposite of [`turned`].
pub(super) fn turned_back(point: Point) -> Point {
    Point::new(-point.y, point.x)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn rectangle(x: f64, y: f64, width: f64, depth: f64) -> Ring {
        Bounds::new(Point::new(x, y), Point::new(x + width, y + depth)).corners().into()
    }

    fn u_shape() -> Ring {
        let corners = [(0., 0.), (6., 0.), (6., 5.), (4., 5.), (4., 2.), (2., 2.), (2., 5.), (0., 5.)];
        corners.map(Point::from).into()
    }

    #[test]
    fn a_line_through_two_legs_leaves_three_pieces() {
        let (below, above) = split(&u_shape(), Axis::Y, 3.0);
        assert_eq!((below.len(), above.len()), (1, 2));
        assert!((area(&below[0]) - 16.0).abs() < 1e-9);
        assert!(above.iter().all(|piece| (area(piece) - 4.0).abs() < 1e-9));
    }

    #[test]
    fn spikes_without_width_are_taken_off_and_corners_are_kept() {
        let with_spike =
            [(0.0, 0.0), (6.0, 0.0), (5.6, -0.001), (5.6, 3.0), (0.0, 3.0)].map(Point::from).to_vec();
        let kept: Ring = [(0.0, 0.0), (5.6, -0.001), (5.6, 3.0), (0.0, 3.0)].map(Point::from).into();
        assert_eq!(without_spikes(with_spike), kept);
        assert_eq!(without_spikes(u_shape()), u_shape());
    }

    #[test]
    fn a_line_along_an_edge_leaves_no_crumb() {
        let (below, above) = split(&u_shape(), Axis::Y, 2.0);
        assert_eq!((below.len(), above.len()), (1, 2));
        assert!((area(&below[0]) - 12.0).abs() < 1e-9);
        let (below, above) = split(&rectangle(0., 0., 2., 2.), Axis::X, 2.0);
        assert_eq!((below.len(), above.len()), (1, 0));
    }

    #[test]
    fn a_line_through_a_corner_leaves_no_ring_that_touches_itself() {
        // A court whose inner end is at the line: the piece beyond it is parted there.
        let corners =
            [(0., 0.), (3., 0.), (2., 4.), (3., 8.), (6., 8.), (6., 0.), (9., 0.), (9., 9.), (0., 9.)];
        let (_, above) = split(&corners.map(Point::from), Axis::X, 2.0);
        let areas: Vec<f64> = above.iter().map(|piece| area(piece)).collect();
        assert!(above.iter().all(|piece| super::super::disc::is_simple(piece)), "{above:?}");
        assert!(areas.len() == 2 && areas.iter().sum::<f64>() > 20.0, "{areas:?}");
    }

    #[test]
    fn what_was_cut_joins_again() {
        let (below, above) = split(&u_shape(), Axis::Y, 3.0);
        let half = join(&below[0], &above[0]).unwrap();
        let whole = join(&half, &above[1]).unwrap();
        assert!((area(&whole) - area(&u_shape())).abs() < 1e-9);
        assert_eq!(whole.len(), u_shape().len());
        assert!(join(&above[0], &above[1]).is_none(), "they do not touch");
    }

    #[test]
    fn rings_of_unlike_length_share_a_part_of_their_edges() {
        let (first, second) = (rectangle(0., 0., 4., 2.), rectangle(1., 2., 2., 2.));
        assert!((shared_length(&first, &second) - 2.0).abs() < 1e-9);
        assert_eq!(join(&first, &second).unwrap().len(), 8);
    }

    proptest! {
        #[test]
        fn pieces_have_the_area_of_the_whole(
            radii in prop::collection::vec(1.0f64..9.0, 3..16), at in -8.0f64..8.0, is_x in any::<bool>(),
        ) {
            let count = radii.len() as f64;
            let corner = |(index, radius): (usize, &f64)| {
                on_grid(crate::geometry::direction(std::f64::consts::TAU * index as f64 / count) * *radius)
            };
            let ring: Ring = radii.iter().enumerate().map(corner).collect();
            prop_assume!(area(&ring) > 0.5);
            let (below, above) = split(&ring, if is_x { Axis::X } else { Axis::Y }, at);
            let sum: f64 = below.iter().chain(&above).map(|piece| area(piece)).sum();
            prop_assert!((sum - area(&ring)).abs() < 0.1, "{sum} {}", area(&ring));
        }
    }
}
