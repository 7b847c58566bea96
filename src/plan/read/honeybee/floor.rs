//! The floor of a honeybee room, seen from above: one face as it is drawn, or what several cover together.

use geo::{Area, LineString, MultiPolygon, unary_union};

use super::schema::Face3d;
use crate::geometry::{Point, Segment, edges};
use crate::plan::clean::{ring_surface, to_line, to_points};

/// Coordinates in metres beyond these are no place, and break the clipping.
const FARTHEST: f64 = 1e8;
/// Corners of the floors of a room that are joined; joining compares edges with each other.
const MOST_CORNERS: usize = 512;
/// Metres between the edges of two faces that are one floor: models are drawn to a tolerance of a centimetre.
const GAP: f64 = 0.01;
/// Metres by which a gap is closed on either side.
const SEAM: f64 = 1e-4;
/// Sine of the largest angle between such edges.
const PARALLEL: f64 = 0.01;
/// Square metres of a part that is more than the noise of joining.
const LEAST_PART: f64 = 0.01;

/// A floor, or a part that does not hang together with the others.
#[derive(Debug)]
pub(super) struct Part {
    pub(super) outline: Vec<Point>,
    pub(super) holes: Vec<Vec<Point>>,
}

/// The parts of a floor, the largest first; each face comes with the metres of its unit.
///
/// # Errors
/// Why there is no floor, to stand behind the name of the room.
pub(super) fn floor_parts<'a>(faces: impl Iterator<Item = (&'a Face3d, f64)>) -> Result<Vec<Part>, String> {
    let parts: Vec<Part> = faces.map(|(face, unit)| flat(face, unit)).collect();
    if parts.is_empty() {
        return Err("has no floor".to_owned());
    }
    let corners = || parts.iter().flat_map(|part| part.holes.iter().chain([&part.outline]).flatten());
    // No number is not near either.
    let is_near = |corner: &Point| corner.is_finite() && corner.abs().max_element() <= FARTHEST;
    if !corners().all(is_near) {
        return Err("has a floor nowhere on Earth".to_owned());
    }
    if parts.iter().all(|part| part.outline.len() < 3) {
        return Err("has a floor of less than three corners".to_owned());
    }
    if parts.len() == 1 {
        return Ok(parts);
    }
    if corners().count() > MOST_CORNERS {
        return Err(format!("has floors of {} corners, {MOST_CORNERS} are the most", corners().count()));
    }
    let joined = joined(&parts);
    if joined.is_empty() { Err("has a floor without area".to_owned()) } else { Ok(joined) }
}

fn flat(face: &Face3d, unit: f64) -> Part {
    let ring = |ring: &Vec<[f64; 3]>| ring.iter().map(|&[x, y, _]| Point::new(x, y) * unit).collect();
    Part { outline: ring(&face.boundary), holes: face.holes.iter().flatten().map(ring).collect() }
}

fn joined(parts: &[Part]) -> Vec<Part> {
    let line = |ring: &Vec<Point>| to_line(ring);
    let surfaces: Vec<geo::Polygon> = parts
        .iter()
        .filter(|part| part.outline.len() > 2)
        .map(|part| geo::Polygon::new(line(&part.outline), part.holes.iter().map(line).collect()))
        .collect();
    // One by one first: floors may run around their corners in either direction, which would take one from another.
    let surfaces: Vec<MultiPolygon> = surfaces.iter().map(|surface| unary_union([surface])).collect();
    let seams = seams(parts);
    let MultiPolygon(mut found) = unary_union(surfaces.iter().flatten().chain(&seams));
    found.retain(|part| part.unsigned_area() >= LEAST_PART);
    found.sort_by(|one, two| two.unsigned_area().total_cmp(&one.unsigned_area()));
    // The last corner repeats the first.
    let ring = |line: &LineString| to_points(line).split_off(1);
    let part = |part: &geo::Polygon| Part {
        outline: ring(part.exterior()),
        holes: part.interiors().iter().map(ring).collect(),
    };
    found.iter().map(part).collect()
}

/// Strips over the gaps between faces whose edges run beside each other, which would be slits through the floor.
fn seams(parts: &[Part]) -> Vec<geo::Polygon> {
    let long_edges = |part: &Part| edges(&part.outline).filter(|edge| edge.length() > SEAM).collect();
    let edges: Vec<Vec<Segment>> = parts.iter().map(long_edges).collect();
    let mut seams = Vec::new();
    for (number, own) in edges.iter().enumerate() {
        let others = || edges[number + 1..].iter().flatten();
        seams.extend(own.iter().flat_map(|edge| others().filter_map(|other| seam(*edge, *other))));
    }
    seams
}

fn seam(edge: Segment, other: Segment) -> Option<geo::Polygon> {
    let along = edge.direction();
    let across = |point: Point| (point - edge.start).perp_dot(along).abs();
    let gap = across(other.start).max(across(other.end));
    if gap > GAP || along.perp_dot(other.direction()).abs() > PARALLEL {
        return None;
    }
    let ends = [other.start, other.end].map(|end| (end - edge.start).dot(along));
    let (low, high) = (ends[0].min(ends[1]).max(0.0), ends[0].max(ends[1]).min(edge.length()));
    if high - low <= SEAM {
        return None;
    }
    let side = along.perp() * (gap + SEAM);
    let (start, end) = (edge.start + along * low, edge.start + along * high);
    Some(ring_surface(&[start - side, end - side, end + side, start + side]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::signed_area;

    fn rectangle(from: [f64; 2], to: [f64; 2]) -> Face3d {
        let [[x, y], [east, north]] = [from, to];
        let boundary = vec![[x, y, 0.0], [east, y, 0.0], [east, north, 0.0], [x, north, 0.0]];
        Face3d { boundary, holes: None }
    }

    fn areas(faces: &[Face3d]) -> Vec<f64> {
        let parts = floor_parts(faces.iter().map(|face| (face, 1.0))).expect("a floor");
        parts.iter().map(|part| signed_area(&part.outline).abs()).collect()
    }

    #[test]
    fn faces_with_a_gap_within_the_tolerance_are_one_floor() {
        for gap in [0.0, 1e-9, 0.004, -0.004] {
            let faces = [rectangle([0.0, 0.0], [2.0, 3.0]), rectangle([2.0 + gap, 0.5], [5.0, 2.0])];
            let found = areas(&faces);
            assert!(found.len() == 1 && (found[0] - 10.5).abs() < 0.01, "{gap}: {found:?}");
        }
        let apart = [rectangle([0.0, 0.0], [2.0, 3.0]), rectangle([3.0, 0.0], [6.0, 3.0])];
        assert_eq!(areas(&apart).len(), 2);
    }

    #[test]
    fn what_is_no_floor_is_said_to_be_none() {
        let line = Face3d { boundary: vec![[0.0; 3], [1.0; 3]], holes: None };
        let far = rectangle([0.0, 0.0], [1e300, 1.0]);
        for (faces, fact) in [
            (vec![], "has no floor"),
            (vec![line], "less than three corners"),
            (vec![far], "nowhere on Earth"),
        ] {
            let fault = floor_parts(faces.iter().map(|face| (face, 1.0))).expect_err("no floor");
            assert!(fault.contains(fact), "{fault}");
        }
    }
}
