//! Questions about convex polygons, written for the audit alone: it judges the layout's own collision
//! code, and a shared mistake would judge itself right.
//!
//! Polygons are slices of corners, counter-clockwise, in plan metres.

use crate::geometry::{Point, Segment, edges};

/// How far one polygon must move for the two to part: above zero where they overlap, else at most zero.
///
/// The separating axis theorem: convex polygons are apart if and only if a line along one of their edges
/// parts them, and the axis of least overlap is the shortest way out.
pub(crate) fn penetration(a: &[Point], b: &[Point]) -> f64 {
    let first = separation(a, b);
    // The second search is half of the work and only needed where no edge of the first parts them.
    if first >= 0.0 { -first } else { -first.max(separation(b, a)) }
}

/// The widest gap that an edge of `a` leaves to all of `b`; below zero where none does.
fn separation(a: &[Point], b: &[Point]) -> f64 {
    let mut widest = f64::NEG_INFINITY;
    for edge in edges(a) {
        // Unit vectors, so that a gap is in metres and can be compared with limits.
        let outward = -edge.normal();
        let gap = b.iter().map(|&corner| outward.dot(corner - edge.start)).fold(f64::INFINITY, f64::min);
        widest = widest.max(gap);
    }
    widest
}

/// How deep a point lies inside: its distance to the nearest edge's line, below zero outside.
pub(crate) fn depth(polygon: &[Point], point: Point) -> f64 {
    edges(polygon).map(|edge| edge.normal().dot(point - edge.start)).fold(f64::INFINITY, f64::min)
}

/// The part of a segment that lies at least `margin` inside a polygon.
pub(crate) fn clip_segment(polygon: &[Point], segment: Segment, margin: f64) -> Option<Segment> {
    let (mut from, mut to) = (0.0_f64, 1.0_f64);
    for edge in edges(polygon) {
        let inward = edge.normal();
        let at_start = inward.dot(segment.start - edge.start) - margin;
        let slope = inward.dot(segment.vector());
        // Along the edge: all of it is on one side. Next to it `crossing` is far beyond both ends and cuts nothing.
        if slope == 0.0 {
            if at_start < 0.0 {
                return None;
            }
            continue;
        }
        let crossing = -at_start / slope;
        if slope > 0.0 {
            from = from.max(crossing);
        } else {
            to = to.min(crossing);
        }
    }
    (from <= to).then(|| Segment::new(segment.at(from), segment.at(to)))
}

/// The common part of two polygons (Sutherland and Hodgman 1974); empty where there is none.
pub(crate) fn intersection(a: &[Point], b: &[Point]) -> Vec<Point> {
    edges(b).fold(a.to_vec(), |kept, edge| half(&kept, |point| edge.side(point)))
}

/// The part of a polygon on the side of a line where `side`, a multiple of the distance to it, is not below zero.
pub(crate) fn half(polygon: &[Point], side: impl Fn(Point) -> f64) -> Vec<Point> {
    let mut kept = Vec::with_capacity(polygon.len() + 1);
    for Segment { start: from, end: to } in edges(polygon) {
        let (from_side, to_side) = (side(from), side(to));
        if from_side >= 0.0 {
            kept.push(from);
        }
        if (from_side >= 0.0) != (to_side >= 0.0) {
            kept.push(from.lerp(to, from_side / (from_side - to_side)));
        }
    }
    kept
}

/// Square metres of a polygon.
pub(crate) fn area(polygon: &[Point]) -> f64 {
    edges(polygon).map(|edge| (edge.start - polygon[0]).perp_dot(edge.end - polygon[0])).sum::<f64>() / 2.0
}

/// The mean of the corners; inside, for every convex polygon.
pub(crate) fn middle(polygon: &[Point]) -> Point {
    let count = f64::from(u32::try_from(polygon.len()).expect("a footprint has few corners"));
    polygon.iter().copied().sum::<Point>() / count
}

/// Metres between a polygon and a segment; zero where they touch.
pub(crate) fn segment_distance(polygon: &[Point], segment: Segment) -> f64 {
    if clip_segment(polygon, segment, 0.0).is_some() {
        return 0.0;
    }
    let from_corners = polygon.iter().map(|&corner| segment.distance(corner));
    let from_ends =
        edges(polygon).flat_map(|edge| [segment.start, segment.end].map(|end| edge.distance(end)));
    from_corners.chain(from_ends).fold(f64::INFINITY, f64::min)
}

/// Metres between two polygons; zero where they touch.
pub(crate) fn distance(a: &[Point], b: &[Point]) -> f64 {
    if penetration(a, b) >= 0.0 {
        return 0.0;
    }
    edges(b).map(|edge| segment_distance(a, edge)).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(x: f64, y: f64, side: f64) -> Vec<Point> {
        [(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)]
            .map(|(dx, dy)| Point::new(x + dx, y + dy))
            .to_vec()
    }

    #[test]
    fn penetration_is_the_shortest_way_out() {
        assert!((penetration(&square(0.0, 0.0, 1.0), &square(0.7, 0.1, 1.0)) - 0.3).abs() < 1e-12);
        assert!(penetration(&square(0.0, 0.0, 1.0), &square(1.0, 0.0, 1.0)).abs() < 1e-12);
        assert!(penetration(&square(0.0, 0.0, 1.0), &square(1.5, 0.0, 1.0)) < 0.0);
    }

    #[test]
    fn a_diamond_beside_a_corner_is_apart_though_their_boxes_overlap() {
        let diamond = [(1.9, 1.0), (2.8, 1.9), (1.9, 2.8), (1.0, 1.9)].map(|(x, y)| Point::new(x, y));
        let apart = square(0.0, 0.0, 1.4);
        assert!(penetration(&apart, &diamond) < 0.0);
        assert!(penetration(&diamond, &square(0.0, 0.0, 1.5)) > 0.0);
    }

    #[test]
    fn the_one_in_the_other_moves_out_over_the_nearest_edge() {
        let inner = square(0.1, 1.0, 0.5);
        assert!((penetration(&square(0.0, 0.0, 3.0), &inner) - 0.6).abs() < 1e-12);
    }

    #[test]
    fn depth_is_signed() {
        assert!((depth(&square(0.0, 0.0, 2.0), Point::new(0.3, 1.0)) - 0.3).abs() < 1e-12);
        assert!((depth(&square(0.0, 0.0, 2.0), Point::new(-0.3, 1.0)) + 0.3).abs() < 1e-12);
    }

    #[test]
    fn a_segment_is_clipped_to_the_shrunk_polygon() {
        let through = Segment::new(Point::new(-1.0, 0.5), Point::new(3.0, 0.5));
        let inside = clip_segment(&square(0.0, 0.0, 2.0), through, 0.1).unwrap();
        assert!((inside.start.x - 0.1).abs() < 1e-12 && (inside.end.x - 1.9).abs() < 1e-12);
        assert!(clip_segment(&square(0.0, 0.0, 2.0), through, 0.6).is_none());
    }

    #[test]
    fn distances_between_polygons_and_segments() {
        assert!((distance(&square(0.0, 0.0, 1.0), &square(4.0, 5.0, 1.0)) - 5.0).abs() < 1e-12);
        assert!(distance(&square(0.0, 0.0, 1.0), &square(0.5, 0.5, 1.0)).abs() < 1e-12);
        let wall = Segment::new(Point::new(-5.0, 1.2), Point::new(5.0, 1.2));
        assert!((segment_distance(&square(0.0, 0.0, 1.0), wall) - 0.2).abs() < 1e-12);
    }

    #[test]
    fn the_intersection_of_two_squares_is_their_common_square() {
        let common = intersection(&square(0.0, 0.0, 2.0), &square(1.0, 1.0, 2.0));
        assert!((middle(&common) - Point::splat(1.5)).length() < 1e-12);
        assert!(intersection(&square(0.0, 0.0, 1.0), &square(3.0, 0.0, 1.0)).is_empty());
    }
}
