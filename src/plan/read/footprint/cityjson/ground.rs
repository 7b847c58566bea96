//! The ground that an object covers, from its geometry:
//!
//! 1. the faces that the file calls ground, of the finest level of detail that has some;
//! 2. the surfaces of level of detail 0;
//! 3. the faces at the bottom of the coarsest solid, if they cover most of it;
//! 4. all its faces as seen from above;
//! 5. rings that the file has among the attributes.

use geo::{Area, MultiPolygon, unary_union};
use serde_json::Value;

use super::geometry::{Face, Geometry, Vertices};
use crate::geometry::{Bounds, Point};
use crate::plan::clean::to_points;
use crate::plan::limits::OUTLINE_CORNERS;
use crate::plan::read::footprint::drawn::Rings;
use crate::plan::read::footprint::sound::are_heaped;

/// Metres above the lowest point up to which a face is at the bottom: ground is not level.
const BOTTOM_REACH: f64 = 0.3;
/// The share of what all faces cover that those at the bottom must cover.
const BOTTOM_SHARE: f64 = 0.5;
/// Square units of the smallest face as seen from above; walls have none.
const SMALLEST_FACE: f64 = 1e-9;

/// The ground under an object, and how high it is.
#[derive(Debug, Default)]
pub(super) struct Ground {
    /// In the units of the file.
    pub(super) areas: Vec<Rings>,
    /// From the lowest point to the highest.
    pub(super) height: Option<f64>,
}

/// The ground under an object.
pub(super) fn ground_of(geometries: &[Geometry], vertices: &Vertices, attribute: Option<&Value>) -> Ground {
    let mut by_level: Vec<&Geometry> = geometries.iter().collect();
    by_level.sort_by(|a, b| a.level().total_cmp(&b.level()));
    let mut ground = Ground::default();
    for geometry in by_level.iter().rev() {
        let faces = geometry.faces(vertices);
        ground.height = ground.height.or_else(|| height_of(&faces));
        if ground.areas.is_empty() {
            ground.areas = seen_from_above(faces.iter().filter(|face| face.is_ground));
        }
    }
    if ground.areas.is_empty() {
        let flat = by_level.iter().find(|geometry| geometry.is_of_surfaces() && geometry.level() < 1.0);
        let faces = flat.map(|geometry| geometry.faces(vertices)).unwrap_or_default();
        ground.areas = seen_from_above(&faces);
    }
    let mut solids = by_level.iter().filter(|geometry| geometry.level() >= 1.0);
    while let (true, Some(geometry)) = (ground.areas.is_empty(), solids.next()) {
        ground.areas = bottom_of(&geometry.faces(vertices));
    }
    if ground.areas.is_empty() {
        ground.areas = attribute.and_then(rings_of).into_iter().collect();
    }
    ground
}

/// Metres from the lowest point of some faces to the highest, if that is more than a slab.
fn height_of(faces: &[Face]) -> Option<f64> {
    let (low, high) = extent(faces);
    (high - low > 1.0).then_some(high - low)
}

fn extent(faces: &[Face]) -> (f64, f64) {
    let heights = faces.iter().flat_map(|face| face.rings.iter().flatten()).map(|vertex| vertex[2]);
    heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), z| (low.min(z), high.max(z)))
}

/// The faces at the bottom, or all of them where those at the bottom are few.
fn bottom_of(faces: &[Face]) -> Vec<Rings> {
    let (low, _) = extent(faces);
    let is_bottom = |face: &&Face| face.rings.iter().flatten().all(|vertex| vertex[2] - low <= BOTTOM_REACH);
    let bottom = union(faces.iter().filter(is_bottom));
    let all = union(faces);
    let covered = |pieces: &MultiPolygon<f64>| pieces.unsigned_area();
    rings(if covered(&bottom) >= BOTTOM_SHARE * covered(&all) { bottom } else { all })
}

fn seen_from_above<'a>(faces: impl IntoIterator<Item = &'a Face>) -> Vec<Rings> {
    rings(union(faces))
}

/// What faces cover together as seen from above: nothing where they are heaped upon each other. Faces with more corners than an
/// outline may have are left out.
fn union<'a>(faces: impl IntoIterator<Item = &'a Face>) -> MultiPolygon<f64> {
    use geo::Orient;
    use geo::algorithm::orient::Direction;
    let line = |ring: &Vec<[f64; 3]>| {
        ring.iter().map(|vertex| geo::Coord { x: vertex[0], y: vertex[1] }).collect::<geo::LineString<f64>>()
    };
    let faces =
        faces.into_iter().filter(|face| face.rings.iter().map(Vec::len).sum::<usize>() <= OUTLINE_CORNERS);
    let flat = faces.filter_map(|face| {
        let mut rings = face.rings.iter().map(line);
        let surface = geo::Polygon::new(rings.next()?, rings.collect());
        (surface.unsigned_area() > SMALLEST_FACE).then(|| surface.orient(Direction::Default))
    });
    let flat: Vec<_> = flat.collect();
    let boxes = flat.iter().map(|surface| {
        Bounds::around(surface.exterior().coords().map(|corner| Point::new(corner.x, corner.y)))
    });
    if are_heaped(&boxes.collect::<Vec<_>>()) {
        return MultiPolygon::new(Vec::new());
    }
    unary_union(&flat)
}

fn rings(pieces: MultiPolygon<f64>) -> Vec<Rings> {
    let piece = |piece: geo::Polygon<f64>| Rings {
        outer: to_points(piece.exterior()),
        holes: piece.interiors().iter().map(to_points).collect(),
    };
    pieces.0.into_iter().map(piece).collect()
}

/// Rings among the attributes: an outer one and holes, as lists of places.
fn rings_of(value: &Value) -> Option<Rings> {
    let point = |place: &Value| Some(Point::new(place.get(0)?.as_f64()?, place.get(1)?.as_f64()?));
    let ring = |ring: &Value| ring.as_array()?.iter().map(point).collect::<Option<Vec<Point>>>();
    let mut rings = value.as_array()?.iter().map(ring).collect::<Option<Vec<_>>>()?.into_iter();
    Some(Rings { outer: rings.next()?, holes: rings.collect() })
}
