//! Rooms from walls: the areas that walls enclose, and outlines that are drawn into the walls cut back to their faces.

use geo::{Area, BooleanOps, MultiPolygon, unary_union};

use super::walls::Body;
use crate::geometry::{Bounds, Point, Segment, edges, ring_contains, signed_area};
use crate::plan::assemble::BoxIndex;
use crate::plan::clean::{largest_part, ring_surface, to_points};

/// Square metres of the smallest enclosed area that is a room rather than a shaft or a gap between walls.
const SMALLEST_ROOM: f64 = 0.5;
/// Metres of the width of the narrowest, as twice its area over its perimeter.
const NARROWEST_ROOM: f64 = 0.2;
/// Walls that touch each other, counted in pairs, up to which areas are looked for: homes have some two per wall. Joining bodies
/// that all cross each other takes time by the pair.
const MOST_TOUCHES: usize = 20_000;
/// Metres inside a wall at which an outline is drawn into it, rather than along its face.
const INTO_WALL: f64 = 0.02;
/// Share of an outline that is drawn into walls before it is cut back.
const SHARE_INTO_WALLS: f64 = 0.3;

/// An area with corners of its own.
#[derive(Clone, Debug, Default)]
pub(super) struct Space {
    pub(super) outline: Vec<Point>,
    pub(super) holes: Vec<Vec<Point>>,
}

/// The bodies of a level, to be found by place.
pub(super) struct Bodies<'a> {
    pub(super) all: &'a [Body],
    index: BoxIndex<usize>,
}

impl<'a> Bodies<'a> {
    pub(super) fn of(all: &'a [Body]) -> Self {
        Self { all, index: BoxIndex::of(all.iter().map(Body::bounds).zip(0..)) }
    }

    /// Those whose boxes meet a box.
    pub(super) fn near(&self, bounds: Bounds) -> impl Iterator<Item = &'a Body> {
        self.index.near(bounds).into_iter().map(|number| &self.all[number])
    }

    /// Whether so many cross each other as in no building.
    pub(super) fn are_tangled(&self) -> bool {
        let mut touches = 0;
        self.all.iter().any(|body| {
            touches += self.index.meeting(body.bounds()).take(MOST_TOUCHES).count();
            touches > MOST_TOUCHES
        })
    }

    /// The areas that they enclose.
    pub(super) fn enclosed(&self) -> Vec<Space> {
        let joined = joined(self.all.iter());
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
            let islands = rings.iter().enumerate().filter(|(number, ring)| {
                *number != own && bounds.contains(ring[0]) && is_within(ring, &outline)
            });
            let islands: Vec<&Vec<Point>> = islands.map(|(_, ring)| ring).collect();
            // What lies within an island is no hole of this area.
            let is_outermost = |ring: &Vec<Point>| {
                !islands.iter().any(|other| !std::ptr::eq(*other, ring) && is_within(ring, other))
            };
            let holes =
                islands.iter().filter(|ring| is_outermost(ring)).map(|ring| (*ring).clone()).collect();
            areas.push(Space { outline, holes });
        }
        areas
    }

    /// A room cut back to the faces of the walls, if much of its outline is drawn into them.
    pub(super) fn cut_back(&self, outline: &[Point]) -> Option<Space> {
        let length: f64 = edges(outline).map(Segment::length).sum();
        let inside: f64 = edges(outline).map(|edge| self.share_inside(edge) * edge.length()).sum();
        if inside < length * SHARE_INTO_WALLS || !length.is_finite() {
            return None;
        }
        let bounds = Bounds::around(outline.iter().copied());
        let walls = joined(self.near(bounds));
        let rest = ring_surface(outline).difference(&walls);
        let (part, _) = largest_part(rest).filter(|(part, _)| part.unsigned_area() >= SMALLEST_ROOM)?;
        Some(Space {
            outline: to_points(part.exterior()),
            holes: part.interiors().iter().map(to_points).collect(),
        })
    }

    /// The share of an edge that lies deep inside walls, by a few places on it.
    fn share_inside(&self, edge: Segment) -> f64 {
        const PLACES: [f64; 3] = [0.25, 0.5, 0.75];
        let is_inside = |share: &&f64| {
            let place = edge.at(**share);
            self.near(Bounds::around_point(place, 0.0)).any(|body| {
                let is_deep = || edges(&body.outline).all(|face| face.distance(place) > INTO_WALL);
                ring_contains(&body.outline, place) && is_deep()
            })
        };
        PLACES.iter().filter(is_inside).count() as f64 / PLACES.len() as f64
    }
}

fn is_room(outline: &[Point]) -> bool {
    let perimeter: f64 = edges(outline).map(Segment::length).sum();
    let area = signed_area(outline).abs();
    area >= SMALLEST_ROOM && 2.0 * area >= NARROWEST_ROOM * perimeter
}

fn joined<'a>(bodies: impl Iterator<Item = &'a Body>) -> MultiPolygon<f64> {
    let surfaces: Vec<geo::Polygon<f64>> = bodies.map(|body| ring_surface(&body.outline)).collect();
    unary_union(&surfaces)
}
