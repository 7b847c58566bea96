//! Computes the part of the floor that a body covers.

use geo::orient::Direction;
use geo::{Area, BooleanOps, Coord, LineString, MultiPolygon, Orient, unary_union};
use glam::DVec3;

use super::profile::Rings;
use super::solid::IfcBody;
use crate::geometry::Point;
use crate::plan::clean::to_line;

/// Sine of the largest angle between a sweep and the vertical, and between a face and the horizontal.
const LEVEL: f64 = 0.02;
/// Metres by which parts of a floor may lie above each other.
const STEP: f64 = 0.05;
/// A lowest face that covers less than this share of all faces is a landing or a kerb, no floor.
const FLOOR_SHARE: f64 = 0.5;
/// Metres of a slit through a wall that goes all the way around something; wide enough that its sides are not one.
const SLIT: f64 = 1e-3;
/// Coordinates in metres beyond these are no place, and break the clipping.
const FARTHEST: f64 = 1e8;

/// The part of the floor that a product covers.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Footprint {
    pub(super) outer: Vec<Point>,
    pub(super) holes: Vec<Vec<Point>>,
    /// Metres of its lowest and highest point; equal for a bare outline.
    pub(super) low: f64,
    pub(super) high: f64,
}

impl Footprint {
    /// Outlines without holes that cover the same but for a slit to each hole. A slit begins at the corner farthest
    /// left, so that no line straight through the wall behind a room's edge meets it.
    pub(super) fn pieces(&self) -> Vec<Vec<Point>> {
        let line = |ring: &Vec<Point>| to_line(ring);
        if self.holes.is_empty() {
            return vec![self.outer.clone()];
        }
        let whole = turned(geo::Polygon::new(line(&self.outer), self.holes.iter().map(line).collect()));
        let left = self.outer.iter().map(|corner| corner.x).fold(f64::INFINITY, f64::min) - SLIT;
        let slits = self.holes.iter().filter_map(|hole| {
            let far = hole
                .iter()
                .copied()
                .reduce(|best, next| if (next.x, next.y) < (best.x, best.y) { next } else { best })?;
            let (low, high) = (Coord { x: left, y: far.y }, Coord { x: far.x + SLIT, y: far.y + SLIT });
            Some(geo::Rect::new(low, high).to_polygon())
        });
        let slits: Vec<geo::Polygon> = slits.collect();
        let open = unary_union([&whole]).difference(&unary_union(&slits));
        let outline = |part: &geo::Polygon| -> Vec<Point> {
            part.exterior().coords().map(|coord| Point::new(coord.x, coord.y)).collect()
        };
        open.0.iter().filter(|part| part.interiors().is_empty()).map(outline).collect()
    }
}

/// The part of the floor that bodies cover together, in one or several pieces; empty if they cover nothing.
pub(super) fn footprints(bodies: &[IfcBody]) -> Vec<Footprint> {
    let corners = || bodies.iter().flat_map(IfcBody::corners);
    if corners().any(|corner| !corner.is_finite() || corner.abs().max_element() > FARTHEST) {
        return Vec::new();
    }
    let (low, high) =
        corners().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| (low.min(at.z), high.max(at.z)));
    let part = |rings: &Rings| Footprint {
        outer: flat(&rings.outer),
        holes: rings.holes.iter().map(|hole| flat(hole)).collect(),
        low,
        high,
    };
    // Corners of a single prism are kept as drawn.
    if let [IfcBody::Swept(rings, sweep)] = bodies
        && is_upright(*sweep)
    {
        return vec![part(rings)];
    }
    let surfaces: Vec<MultiPolygon> = bodies.iter().map(covered).collect();
    let merged = unary_union(surfaces.iter().flatten());
    let ring = |line: &LineString| line.coords().map(|coord| Point::new(coord.x, coord.y)).collect();
    let parts = merged.0.iter().map(|part| Footprint {
        outer: ring(part.exterior()),
        holes: part.interiors().iter().map(ring).collect(),
        low,
        high,
    });
    parts.collect()
}

fn is_upright(sweep: DVec3) -> bool {
    sweep.truncate().length() <= sweep.length() * LEVEL
}

fn flat(ring: &[DVec3]) -> Vec<Point> {
    ring.iter().map(|corner| corner.truncate()).collect()
}

fn covered(body: &IfcBody) -> MultiPolygon {
    match body {
        IfcBody::Swept(rings, sweep) if is_upright(*sweep) => unary_union([&surface(rings)]),
        IfcBody::Swept(rings, sweep) => floor_of(&sides(rings, *sweep)),
        IfcBody::Faces(faces) => floor_of(faces),
    }
}

/// The faces of a profile that is swept sideways.
fn sides(rings: &Rings, sweep: DVec3) -> Vec<Rings> {
    let by = glam::DAffine3::from_translation(sweep);
    let mut faces = vec![rings.clone(), rings.moved(&by)];
    for ring in std::iter::once(&rings.outer).chain(&rings.holes) {
        for (index, &corner) in ring.iter().enumerate() {
            let next = ring[(index + 1) % ring.len()];
            let outer = vec![corner, next, next + sweep, corner + sweep];
            faces.push(Rings { outer, holes: Vec::new() });
        }
    }
    faces
}

/// The lowest level faces, or all that is covered where these are no floor.
fn floor_of(faces: &[Rings]) -> MultiPolygon {
    let leveled: Vec<(&Rings, f64)> = faces.iter().filter_map(|face| Some((face, level(face)?))).collect();
    let lowest = leveled.iter().map(|(_, height)| *height).fold(f64::INFINITY, f64::min);
    let floor: Vec<geo::Polygon> =
        leveled.iter().filter(|(_, height)| height - lowest <= STEP).map(|(face, _)| surface(face)).collect();
    let floor = unary_union(&floor);
    let all: Vec<geo::Polygon> = faces.iter().map(surface).collect();
    let shadow = unary_union(&all);
    if floor.unsigned_area() >= shadow.unsigned_area() * FLOOR_SHARE { floor } else { shadow }
}

/// The height of a face that lies level.
fn level(face: &Rings) -> Option<f64> {
    let ring = &face.outer;
    let (first, rest) = ring.split_first()?;
    // Twice the area as a vector, by the shoelace formula in space.
    let normal: DVec3 = rest.windows(2).map(|pair| (pair[0] - *first).cross(pair[1] - *first)).sum();
    let is_level = normal.truncate().length() <= normal.length() * LEVEL && normal.length() > 0.0;
    is_level.then(|| ring.iter().map(|corner| corner.z).sum::<f64>() / ring.len() as f64)
}

fn surface(rings: &Rings) -> geo::Polygon {
    let line = |ring: &Vec<DVec3>| {
        LineString::from_iter(ring.iter().map(|corner| Coord { x: corner.x, y: corner.y }))
    };
    turned(geo::Polygon::new(line(&rings.outer), rings.holes.iter().map(line).collect()))
}

/// Holes run the other way around than the outline: else the clipping fills them.
fn turned(surface: geo::Polygon) -> geo::Polygon {
    surface.orient(Direction::Default)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(corners: &[(f64, f64, f64)]) -> Vec<DVec3> {
        corners.iter().map(|&(x, y, z)| DVec3::new(x, y, z)).collect()
    }

    fn area(footprint: &Footprint) -> f64 {
        crate::geometry::Polygon::new(&footprint.outer).unwrap().area()
    }

    #[test]
    fn a_gable_swept_sideways_stands_on_its_floor() {
        let gable = ring(&[(0.0, 0.0, 1.0), (4.0, 0.0, 1.0), (2.0, 0.0, 3.0)]);
        let body = IfcBody::Swept(Rings { outer: gable, holes: Vec::new() }, DVec3::Y * 5.0);
        let found = footprints(&[body]);
        assert_eq!(found.len(), 1);
        assert!((area(&found[0]) - 20.0).abs() < 1e-6);
        assert_eq!((found[0].low, found[0].high), (1.0, 3.0));
    }

    #[test]
    fn parts_that_touch_become_one_room_and_others_several() {
        let part = |x: f64| {
            let outer = ring(&[(x, 0.0, 0.0), (x + 2.0, 0.0, 0.0), (x + 2.0, 2.0, 0.0), (x, 2.0, 0.0)]);
            IfcBody::Swept(Rings { outer, holes: Vec::new() }, DVec3::Z * 2.5)
        };
        assert_eq!(footprints(&[part(0.0), part(2.0)]).len(), 1);
        assert_eq!(footprints(&[part(0.0), part(3.0)]).len(), 2);
    }

    #[test]
    fn a_wall_around_a_house_is_no_house() {
        let square = |low: f64, high: f64| {
            ring(&[(low, low, 0.0), (high, low, 0.0), (high, high, 0.0), (low, high, 0.0)])
        };
        let rings = Rings { outer: square(0.0, 10.0), holes: vec![square(1.0, 9.0)] };
        let pieces = footprints(&[IfcBody::Swept(rings, DVec3::Z)])[0].pieces();
        let pieces = pieces.iter().map(|piece| crate::geometry::Polygon::new(piece).unwrap());
        let (inside, covered) = pieces.fold((false, 0.0), |(inside, covered), piece| {
            (inside || piece.contains(Point::splat(5.0)), covered + piece.area())
        });
        assert!(!inside && (covered - 36.0_f64).abs() < 0.01, "{covered}");
    }

    #[test]
    fn invalid_places_cover_no_floor() {
        for odd in [f64::NAN, f64::INFINITY, 1e300] {
            let outer = ring(&[(0.0, 0.0, 0.0), (odd, 0.0, 0.0), (1.0, 1.0, 0.0)]);
            assert!(footprints(&[IfcBody::Faces(vec![Rings { outer, holes: Vec::new() }])]).is_empty());
        }
        assert!(footprints(&[]).is_empty());
    }
}
