//! Finds the outline of a space from the surfaces and curves of its `IfcRelSpaceBoundary` relations.
//!
//! Boundaries of floors say the outline themselves. Where there are none, or where they cover less than the walls enclose,
//! the lower edges of the upright boundaries are chained to a ring; those of doors and windows lie in the ones of walls.

use glam::{DAffine3, DVec3};

use super::curve::DEEPEST;
use super::footprint::{Footprint, footprints};
use super::model::{Entity, Read};
use super::placement::Geometry;
use super::profile::Rings;
use super::solid::IfcBody;
use crate::geometry::{Point, Segment, signed_area};

/// What lies in the boundary of a wall.
const FILLERS: [&str; 6] = [
    "IFCDOOR",
    "IFCDOORSTANDARDCASE",
    "IFCWINDOW",
    "IFCWINDOWSTANDARDCASE",
    "IFCOPENINGELEMENT",
    "IFCOPENINGSTANDARDCASE",
];
/// Boundaries of a space that are chained: each is compared with all.
const MOST_SIDES: usize = 512;
/// Metres between the ends of two boundaries that meet; columns and the ends of walls lie between.
const JOINT: f64 = 0.3;
/// Metres of the shortest side, and by which sides that are given twice may differ.
const SHORTEST: f64 = 0.01;
/// Share by which the ring of the walls must be larger than the floor to be believed instead.
const LARGER: f64 = 1.1;
/// Sine of the largest angle between an upright boundary and the vertical.
const UPRIGHT: f64 = 0.05;

/// The outline of a space by its boundaries, in the building's axes; `None` where they have no shape.
pub(super) fn bounded(
    geometry: &Geometry<'_>,
    frame: &DAffine3,
    space: &Entity,
    boundaries: &[u64],
) -> Read<Option<Footprint>> {
    let by = *frame * geometry.place(space)?;
    let mut faces: Vec<Rings> = Vec::new();
    let mut sides: Vec<Segment> = Vec::new();
    let mut heights = (f64::INFINITY, f64::NEG_INFINITY);
    for boundary in boundaries {
        let boundary = geometry.model.get(*boundary)?;
        let is_filler = boundary.value(5).reference().is_some_and(|of| geometry.model.is(of, &FILLERS));
        let Some(shape) = boundary.value(6).reference().filter(|_| !is_filler) else { continue };
        for face in geometry.connection(shape)?.iter().map(|face| face.moved(&by)) {
            for corner in face.corners() {
                heights = (heights.0.min(corner.z), heights.1.max(corner.z));
            }
            sides.extend(side(&face));
            faces.push(face);
        }
    }
    if faces.is_empty() {
        return Ok(None);
    }
    let area = |ring: &[Point]| signed_area(ring).abs();
    let floors = footprints(&[IfcBody::Faces(faces)]);
    let floor = floors
        .into_iter()
        .reduce(|best, next| if area(&next.outer) > area(&best.outer) { next } else { best });
    let ring = chained(sides);
    let of_ring = |outer| Footprint { outer, holes: Vec::new(), low: heights.0, high: heights.1 };
    Ok(match (floor, ring) {
        (Some(floor), Some(ring)) if area(&ring) > LARGER * area(&floor.outer) => Some(of_ring(ring)),
        (Some(floor), _) => Some(floor),
        (None, ring) => ring.map(of_ring),
    })
}

/// The stretch of floor along an upright face, or a curve that is drawn for it.
fn side(face: &Rings) -> Option<Segment> {
    let (first, rest) = face.outer.split_first()?;
    let normal: DVec3 = rest.windows(2).map(|pair| (pair[0] - *first).cross(pair[1] - *first)).sum();
    if normal.z.abs() > normal.length() * UPRIGHT {
        return None;
    }
    let flat = || face.outer.iter().map(|corner| corner.truncate());
    let farthest =
        |from: Point| {
            flat().fold(from, |best, next| {
                if next.distance_squared(from) > best.distance_squared(from) { next } else { best }
            })
        };
    let start = farthest(first.truncate());
    let segment = Segment::new(start, farthest(start));
    (segment.length() >= SHORTEST).then_some(segment)
}

/// The largest ring that sides make, each joined to the nearest that is left.
fn chained(sides: Vec<Segment>) -> Option<Vec<Point>> {
    if sides.len() > MOST_SIDES {
        return None;
    }
    let mut open: Vec<Segment> = Vec::new();
    for side in sides {
        let is_known =
            |known: &Segment| known.distance(side.start) < SHORTEST && known.distance(side.end) < SHORTEST;
        if !open.iter().any(is_known) {
            open.retain(|known| {
                side.distance(known.start) >= SHORTEST || side.distance(known.end) >= SHORTEST
            });
            open.push(side);
        }
    }
    let mut best: Option<Vec<Point>> = None;
    while let Some(first) = open.pop() {
        let mut chain = vec![first];
        let mut end = first.end;
        let is_closed = loop {
            let home = end.distance(first.start);
            let near = |side: &Segment| end.distance(side.start).min(end.distance(side.end));
            let next = (0..open.len()).min_by(|a, b| near(&open[*a]).total_cmp(&near(&open[*b])));
            match next.filter(|next| near(&open[*next]) < JOINT.min(home)) {
                Some(next) => {
                    let side = open.swap_remove(next);
                    let is_turned = end.distance(side.end) < end.distance(side.start);
                    let side = if is_turned { Segment::new(side.end, side.start) } else { side };
                    end = side.end;
                    chain.push(side);
                }
                None => break home < JOINT,
            }
        };
        let ring = corners(&chain);
        let is_larger = best.as_ref().is_none_or(|best| signed_area(best).abs() < signed_area(&ring).abs());
        if is_closed && chain.len() > 2 && is_larger {
            best = Some(ring);
        }
    }
    best
}

/// The corners of a closed chain: where the lines of neighbours cross, if that is near, else both their ends.
fn corners(chain: &[Segment]) -> Vec<Point> {
    let mut corners = Vec::with_capacity(chain.len());
    for (index, side) in chain.iter().enumerate() {
        let next = &chain[(index + 1) % chain.len()];
        let crossing = side.vector().perp_dot(next.vector());
        let along = (next.start - side.start).perp_dot(next.vector()) / crossing;
        let meeting = side.start + side.vector() * along;
        if crossing.abs() > 1e-9 && meeting.distance(side.end) < JOINT && meeting.distance(next.start) < JOINT
        {
            corners.push(meeting);
        } else {
            corners.extend([side.end, next.start]);
        }
    }
    corners
}

impl Geometry<'_> {
    /// The faces of an `IfcConnectionGeometry` on its space's side, in the coordinates of the space.
    fn connection(&self, id: u64) -> Read<Vec<Rings>> {
        let connection = self.model.get(id)?;
        match connection.kind.as_str() {
            "IFCCONNECTIONSURFACEGEOMETRY" => self.surface(connection.reference(0)?),
            "IFCCONNECTIONCURVEGEOMETRY" => {
                let line = self.curve(connection.reference(0)?, 0)?;
                let piece = |ends: &[DVec3]| Rings { outer: ends.to_vec(), holes: Vec::new() };
                Ok(line.windows(2).map(piece).collect())
            }
            _ => Ok(Vec::new()),
        }
    }

    fn surface(&self, id: u64) -> Read<Vec<Rings>> {
        let surface = self.model.get(id)?;
        match surface.kind.as_str() {
            "IFCCURVEBOUNDEDPLANE" => {
                let plane = self.model.get(surface.reference(0)?)?;
                let outer = self.curve(surface.reference(1)?, 0)?;
                let holes = surface.value(2).items().iter().filter_map(|hole| hole.reference());
                let holes = holes.map(|hole| self.curve(hole, 0)).collect::<Read<_>>()?;
                Ok(vec![Rings { outer, holes }.moved(&self.axes(plane.value(0))?)])
            }
            "IFCFACESURFACE" | "IFCADVANCEDFACE" | "IFCFACE" => self.faces(id),
            "IFCFACEBASEDSURFACEMODEL" | "IFCSHELLBASEDSURFACEMODEL" => {
                let bodies = self.shells(&surface.references(0)?)?;
                Ok(bodies.into_iter().flat_map(IfcBody::into_faces).collect())
            }
            "IFCSURFACEOFLINEAREXTRUSION" => {
                let profile = self.model.get(surface.reference(0)?)?;
                let line = self.curve(profile.reference(2)?, DEEPEST / 2)?;
                let frame = self.axes(surface.value(1))?;
                let direction = self.direction(surface.value(2))?.unwrap_or(DVec3::Z);
                let sweep = direction * (surface.positive(3)? * self.units.length);
                let wall = |ends: &[DVec3]| {
                    let outer = vec![ends[0], ends[1], ends[1] + sweep, ends[0] + sweep];
                    Rings { outer, holes: Vec::new() }.moved(&frame)
                };
                Ok(line.windows(2).map(wall).collect())
            }
            "IFCRECTANGULARTRIMMEDSURFACE" => {
                let plane = self.model.get(surface.reference(0)?)?;
                let mut ends = [0.0; 4];
                for (place, end) in ends.iter_mut().enumerate() {
                    *end = surface.number(place + 1)? * self.units.length;
                }
                let [u1, v1, u2, v2] = ends;
                let outer =
                    [(u1, v1), (u2, v1), (u2, v2), (u1, v2)].map(|(u, v)| DVec3::new(u, v, 0.0)).to_vec();
                Ok(vec![Rings { outer, holes: Vec::new() }.moved(&self.axes(plane.value(0))?)])
            }
            _ => Err(surface.trouble("boundaries of this kind are not read")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sides(ends: &[[(f64, f64); 2]]) -> Vec<Segment> {
        ends.iter().map(|[start, end]| Segment::new(Point::from(*start), Point::from(*end))).collect()
    }

    #[test]
    fn sides_in_any_order_and_direction_make_a_ring() {
        let square = sides(&[
            [(0.0, 0.0), (4.0, 0.0)],
            [(0.0, 3.0), (4.0, 3.0)],
            [(4.0, 0.1), (4.0, 3.0)],
            // Given twice, and in parts.
            [(0.0, 0.0), (4.0, 0.0)],
            [(1.0, 0.0), (2.0, 0.0)],
            [(0.0, 0.0), (0.0, 3.0)],
        ]);
        let ring = chained(square).unwrap();
        assert_eq!(ring.len(), 4, "{ring:?}");
        assert!((signed_area(&ring).abs() - 12.0).abs() < 1e-9, "{ring:?}");
    }

    #[test]
    fn sides_with_a_gap_make_none() {
        let open = sides(&[[(0.0, 0.0), (4.0, 0.0)], [(4.0, 0.0), (4.0, 3.0)], [(4.0, 3.0), (0.0, 3.0)]]);
        assert_eq!(chained(open), None);
        assert_eq!(chained(Vec::new()), None);
    }
}
