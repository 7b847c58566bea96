//! The areas that walls enclose, as rooms of plans that draw walls and no rooms.

use geo::{MultiPolygon, unary_union};

use crate::geometry::{Bounds, Point, Segment, edges, ring_contains, signed_area};
use crate::plan::assemble::BoxIndex;
use crate::plan::clean::{ring_surface, to_points};

/// Square metres of the smallest enclosed area that is a room rather than a shaft or a gap between walls.
pub(super) const SMALLEST_ROOM: f64 = 0.5;
/// Metres of the width of the narrowest, as twice its area over its perimeter.
const NARROWEST_ROOM: f64 = 0.2;
/// Walls that touch each other, counted in pairs, up to which areas are looked for: homes have some two per wall. Joining bodies
/// that all cross each other takes time by the pair.
const MOST_TOUCHES: usize = 20_000;

/// An area with corners of its own.
#[derive(Clone, Debug, Default)]
pub(super) struct WalledArea {
    pub(super) outline: Vec<Point>,
    pub(super) holes: Vec<Vec<Point>>,
}

impl WalledArea {
    /// Whether a point lies in it.
    pub(super) fn contains(&self, point: Point) -> bool {
        ring_contains(&self.outline, point) && !self.holes.iter().any(|hole| ring_contains(hole, point))
    }
}

/// Whether so many of the boxes, which the index holds, cross each other as in no building.
pub(super) fn are_tangled(index: &BoxIndex<usize>, mut boxes: impl Iterator<Item = Bounds>) -> bool {
    let mut touches = 0;
    boxes.any(|bounds| {
        touches += index.meeting(bounds).take(MOST_TOUCHES).count();
        touches > MOST_TOUCHES
    })
}

/// What outlines cover together.
pub(super) fn joined<'a>(outlines: impl Iterator<Item = &'a [Point]>) -> MultiPolygon<f64> {
    let surfaces: Vec<geo::Polygon<f64>> = outlines.map(ring_surface).collect();
    unary_union(&surfaces)
}

/// The areas that joined walls enclose.
pub(super) fn walled_areas(joined: &MultiPolygon<f64>) -> Vec<WalledArea> {
    let rings: Vec<Vec<Point>> = joined.0.iter().map(|part| to_points(part.exterior())).collect();
    let insides = joined
        .0
        .iter()
        .enumerate()
        .flat_map(|(own, part)| part.interiors().iter().map(move |ring| (own, to_points(ring))));
    let is_within = |ring: &[Point], outline: &[Point]| {
        ring.first().is_some_and(|corner| ring_contains(outline, *corner))
    };
    let mut areas = Vec::new();
    for (own, outline) in insides.filter(|(_, outline)| is_room(outline)) {
        let bounds = Bounds::around(outline.iter().copied());
        let islands = rings
            .iter()
            .enumerate()
            .filter(|(number, ring)| *number != own && bounds.contains(ring[0]) && is_within(ring, &outline));
        let islands: Vec<&Vec<Point>> = islands.map(|(_, ring)| ring).collect();
        // What lies within an island is no hole of this area.
        let is_outermost = |ring: &Vec<Point>| {
            !islands.iter().any(|other| !std::ptr::eq(*other, ring) && is_within(ring, other))
        };
        let holes = islands.iter().filter(|ring| is_outermost(ring)).map(|ring| (*ring).clone()).collect();
        areas.push(WalledArea { outline, holes });
    }
    areas
}

fn is_room(outline: &[Point]) -> bool {
    let perimeter: f64 = edges(outline).map(Segment::length).sum();
    let area = signed_area(outline).abs();
    area >= SMALLEST_ROOM && 2.0 * area >= NARROWEST_ROOM * perimeter
}
