//! Rooms from walls: the areas that walls enclose, and outlines that are drawn into the walls cut back to their faces.

use geo::{Area, BooleanOps};

use super::walls::Body;
use crate::geometry::{Bounds, Point, Segment, edges, ring_contains};
use crate::plan::assemble::BoxIndex;
use crate::plan::clean::{largest_part, ring_surface, to_points};
use crate::plan::read::walled::{SMALLEST_ROOM, WalledArea, are_tangled, joined, walled_areas};

/// Metres inside a wall at which an outline is drawn into it, rather than along its face.
const INTO_WALL: f64 = 0.02;
/// Share of an outline that is drawn into walls before it is cut back.
const SHARE_INTO_WALLS: f64 = 0.3;

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
        are_tangled(&self.index, self.all.iter().map(Body::bounds))
    }

    /// The areas that they enclose.
    pub(super) fn enclosed(&self) -> Vec<WalledArea> {
        walled_areas(&joined(outlines(self.all.iter())))
    }

    /// A room cut back to the faces of the walls, if much of its outline is drawn into them.
    pub(super) fn cut_back(&self, outline: &[Point]) -> Option<WalledArea> {
        let length: f64 = edges(outline).map(Segment::length).sum();
        let inside: f64 = edges(outline).map(|edge| self.share_inside(edge) * edge.length()).sum();
        if inside < length * SHARE_INTO_WALLS || !length.is_finite() {
            return None;
        }
        let bounds = Bounds::around(outline.iter().copied());
        let walls = joined(outlines(self.near(bounds)));
        let rest = ring_surface(outline).difference(&walls);
        let (part, _) = largest_part(rest).filter(|(part, _)| part.unsigned_area() >= SMALLEST_ROOM)?;
        Some(WalledArea {
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

fn outlines<'a>(bodies: impl Iterator<Item = &'a Body>) -> impl Iterator<Item = &'a [Point]> {
    bodies.map(|body| body.outline.as_slice())
}
