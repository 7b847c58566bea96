//! Turns rings of a plan into simple polygons; each edge still knows its edge in the plan.

use std::fmt;

use super::limits::{COORDINATE, OUTLINE_CORNERS};
use crate::geometry::{CORNER_TOLERANCE, Point, Polygon, PolygonFault, Segment};

mod holes;
mod surface;
#[cfg(test)]
mod tests;
mod untangle;

pub(super) use holes::{HoleFault, clean_region, separate_holes};
pub(super) use surface::{largest_part, to_line, to_polygon, to_simple};
pub(crate) use surface::{region_without, ring_surface, to_points, to_surface};
pub(super) use untangle::untangled;

/// Corners closer than this many metres become one: surveyors' noise, too small for any wall.
pub(super) const NEAR_CORNERS: f64 = 0.02;
/// Outlines below this many square metres are drawing leftovers, not rooms.
pub(super) const SLIVER_AREA: f64 = 0.05;
/// Outlines narrower than this many metres on average are leftovers too.
pub(super) const SLIVER_WIDTH: f64 = 0.02;
/// A corner this close in metres to the line through its neighbours does not bend a wall.
const STRAIGHT_TOLERANCE: f64 = 0.002;
/// An outline that comes back on itself within this many metres is a spike, not a room part.
const SPIKE_WIDTH: f64 = 0.002;

/// A simple polygon whose edges remember their origin.
#[derive(Clone, Debug)]
pub(super) struct Ring {
    /// The polygon.
    pub(super) polygon: Polygon,
    /// By edge of `polygon`: the edge of the ring as found, where there is one.
    pub(super) edges: Vec<Option<usize>>,
}

/// Why a list of points is no usable ring; indices are those of the points as found.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum RingFault {
    /// The polygon itself is at fault.
    Polygon(PolygonFault),
    /// A corner and its distance from the origin in metres: too large a coordinate.
    TooFar(usize, f64),
    /// More corners than are checked.
    TooManyCorners(usize),
    /// Square metres and mean metres of width of a leftover.
    Sliver(f64, f64),
}

impl RingFault {
    /// The corner at fault, if one is.
    pub(super) fn corner(&self) -> Option<usize> {
        match self {
            Self::Polygon(PolygonFault::NotFinite(corner) | PolygonFault::SelfCrossing(corner, _))
            | Self::TooFar(corner, _) => Some(*corner),
            _ => None,
        }
    }
}

impl fmt::Display for RingFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Polygon(fault) => fault.fmt(f),
            Self::TooFar(corner, distance) => {
                let (distance, most) = (distance / 1000.0, COORDINATE / 1000.0);
                write!(f, "corner {corner} is {distance:.0} km from the origin, {most} km are the most")
            }
            Self::TooManyCorners(count) => write!(f, "outline has {count} corners"),
            Self::Sliver(area, width) => write!(f, "outline is a sliver of {area:.4} m², {width:.3} m wide"),
        }
    }
}

/// A corner of a ring in the making.
#[derive(Clone, Copy, Debug)]
struct Corner {
    point: Point,
    /// Index of the point as found.
    found: usize,
    /// The edge as found that leaves this corner.
    edge: usize,
}

/// Cleans one ring: closing point, repeated and nearly repeated corners, spikes, direction, straight corners.
///
/// `labels` groups the edges as found: a straight corner between edges of different label stays. Edges beyond
/// its end have label 0.
pub(super) fn clean_ring(points: &[Point], labels: &[usize]) -> Result<Ring, RingFault> {
    check_points(points)?;
    let mut corners = distinct_corners(points);
    remove_spikes(&mut corners);
    turn_counter_clockwise(&mut corners);
    let mut joined = corners.clone();
    join_near_corners(&mut joined);
    merge_straight_corners(&mut joined, labels);
    // Joining can close a gap of two centimetres and make a ring touch itself; then it stays as it was.
    build(&joined).or_else(|_| build(&corners))
}

/// Refuses a ring that is a leftover of drawing: below this many square metres, or thinner than any wall.
pub(super) fn refuse_sliver(ring: Ring, least_area: f64) -> Result<Ring, RingFault> {
    let (area, width) = (ring.polygon.area(), mean_width(&ring.polygon));
    if area < least_area || width < SLIVER_WIDTH { Err(RingFault::Sliver(area, width)) } else { Ok(ring) }
}

/// Area over half the perimeter: the width of a long thin rectangle.
pub(super) fn mean_width(polygon: &Polygon) -> f64 {
    let perimeter: f64 = polygon.edges().map(Segment::length).sum();
    2.0 * polygon.area() / perimeter
}

fn check_points(points: &[Point]) -> Result<(), RingFault> {
    if points.len() > OUTLINE_CORNERS {
        return Err(RingFault::TooManyCorners(points.len()));
    }
    if let Some(index) = points.iter().position(|point| !point.is_finite()) {
        return Err(RingFault::Polygon(PolygonFault::NotFinite(index)));
    }
    match points.iter().position(|point| point.abs().max_element() > COORDINATE) {
        Some(index) => Err(RingFault::TooFar(index, points[index].length())),
        None => Ok(()),
    }
}

fn distinct_corners(points: &[Point]) -> Vec<Corner> {
    let mut corners: Vec<Corner> = Vec::with_capacity(points.len());
    for (found, &point) in points.iter().enumerate() {
        match corners.last_mut() {
            // The edge that really leaves the place is that of its last copy.
            Some(last) if last.point.distance(point) <= CORNER_TOLERANCE => last.edge = found,
            _ => corners.push(Corner { point, found, edge: found }),
        }
    }
    while corners.len() > 1 && corners[0].point.distance(corners[corners.len() - 1].point) <= CORNER_TOLERANCE
    {
        corners.pop();
    }
    corners
}

/// Takes out corners at which the outline turns back on itself.
fn remove_spikes(corners: &mut Vec<Corner>) {
    let mut index = 0;
    let mut clean_steps = 0;
    while corners.len() > 3 && clean_steps < corners.len() {
        let count = corners.len();
        index %= count;
        let (before, after) = ((index + count - 1) % count, (index + 1) % count);
        if is_spike(corners[before].point, corners[index].point, corners[after].point) {
            let edge = corners[index].edge;
            let touches = corners[before].point.distance(corners[after].point) <= CORNER_TOLERANCE;
            corners[before].edge = if touches { corners[after].edge } else { edge };
            let mut gone = vec![index];
            gone.extend(touches.then_some(after));
            gone.sort_unstable_by(|a, b| b.cmp(a));
            for place in gone {
                corners.remove(place);
            }
            index = before.saturating_sub(1);
            clean_steps = 0;
        } else {
            index += 1;
            clean_steps += 1;
        }
    }
}

fn is_spike(before: Point, tip: Point, after: Point) -> bool {
    let (back, forth) = (before - tip, after - tip);
    let (short, long) = if back.length() < forth.length() { (back, forth) } else { (forth, back) };
    short.dot(long) > 0.0 && short.perp_dot(long.normalize_or_zero()).abs() < SPIKE_WIDTH
}

fn turn_counter_clockwise(corners: &mut [Corner]) {
    let count = corners.len();
    let base = corners.first().map_or(Point::ZERO, |corner| corner.point);
    let doubled: f64 =
        (0..count).map(|i| (corners[i].point - base).perp_dot(corners[(i + 1) % count].point - base)).sum();
    if doubled < 0.0 {
        corners.reverse();
        let edges: Vec<usize> = corners.iter().map(|corner| corner.edge).collect();
        for (index, corner) in corners.iter_mut().enumerate() {
            corner.edge = edges[(index + 1) % count];
        }
    }
}

/// Replaces two corners closer than [`NEAR_CORNERS`] by the place where their outer edges meet, or their middle.
fn join_near_corners(corners: &mut Vec<Corner>) {
    let mut index = 0;
    while index < corners.len() && corners.len() > 3 {
        let count = corners.len();
        let next = (index + 1) % count;
        let (a, b) = (corners[index].point, corners[next].point);
        if a.distance(b) >= NEAR_CORNERS {
            index += 1;
            continue;
        }
        let before = corners[(index + count - 1) % count].point;
        let after = corners[(next + 1) % count].point;
        let meeting = meeting_point(Segment::new(before, a), Segment::new(after, b))
            .filter(|meet| meet.distance(a) < NEAR_CORNERS && meet.distance(b) < NEAR_CORNERS);
        corners[index].point = meeting.unwrap_or_else(|| a.midpoint(b));
        corners[index].edge = corners[next].edge;
        corners.remove(next);
        // The joined corner may now be near the one before it.
        index = index.min(corners.len() - 1).saturating_sub(1);
    }
}

/// Where the line through `a` and `b` meets the line through `c` and `d`.
pub(super) fn meeting_point(one: Segment, other: Segment) -> Option<Point> {
    let (first, second) = (one.vector(), other.vector());
    let cross = first.perp_dot(second);
    // Below this sine the meeting point jumps about with the last digits.
    const SMALLEST_SINE: f64 = 0.02;
    if cross.abs() < SMALLEST_SINE * first.length() * second.length() || cross == 0.0 {
        return None;
    }
    Some(one.start + first * ((other.start - one.start).perp_dot(second) / cross))
}

/// Drops corners that do not bend the outline, so that a door or a sofa sees one wall, not two.
fn merge_straight_corners(corners: &mut Vec<Corner>, labels: &[usize]) {
    let count = corners.len();
    let label = |corner: &Corner| labels.get(corner.edge).copied().unwrap_or_default();
    // The lowest corner is always a true one: nothing of the outline lies beyond it.
    let Some(first) = (0..count).min_by(|&a, &b| {
        let (a, b) = (corners[a].point, corners[b].point);
        a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y))
    }) else {
        return;
    };
    corners.rotate_left(first);
    let mut kept = vec![corners[0]];
    let mut anchor = 0;
    for index in 1..count {
        let (start, end) = (corners[anchor].point, corners[(index + 1) % count].point);
        let is_straight = (anchor + 1..=index).all(|between| {
            label(&corners[between]) == label(&corners[anchor])
                && lies_between(start, end, corners[between].point)
        });
        if !is_straight {
            kept.push(corners[index]);
            anchor = index;
        }
    }
    // Walls are numbered from the plan's first edge.
    let lowest = (0..kept.len()).min_by_key(|&index| kept[index].edge).unwrap_or_default();
    kept.rotate_left(lowest);
    if kept.len() >= 3 {
        *corners = kept;
    }
}

fn lies_between(start: Point, end: Point, point: Point) -> bool {
    let along = (end - start).normalize_or_zero();
    let offset = point - start;
    let place = offset.dot(along);
    offset.perp_dot(along).abs() < STRAIGHT_TOLERANCE && place > 0.0 && place < start.distance(end)
}

fn build(corners: &[Corner]) -> Result<Ring, RingFault> {
    let points: Vec<Point> = corners.iter().map(|corner| corner.point).collect();
    let found = |index: usize| corners.get(index).map_or(index, |corner| corner.found);
    let polygon = Polygon::new(&points).map_err(|fault| {
        RingFault::Polygon(match fault {
            PolygonFault::SelfCrossing(a, b) => PolygonFault::SelfCrossing(found(a), found(b)),
            PolygonFault::NotFinite(index) => PolygonFault::NotFinite(found(index)),
            other => other,
        })
    })?;
    if polygon.corners() != points {
        return Err(RingFault::Polygon(PolygonFault::TooFewCorners(points.len())));
    }
    Ok(Ring { polygon, edges: corners.iter().map(|corner| Some(corner.edge)).collect() })
}
