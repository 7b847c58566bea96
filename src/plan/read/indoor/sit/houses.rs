//! Which building each space is in.

use std::collections::BTreeMap;

use super::mapped::Mapped;
use super::sort::{Sorted, Space, corners};
use crate::geometry::{Bounds, Point};
use crate::plan::assemble::BoxIndex;
use crate::plan::read::foreign::{UniqueIds, slug};
use crate::plan::read::osm::holds;
use crate::plan::units::LocalPlane;

/// Metres from a building within which spaces outside of its outline are its own, as porches and cellars are.
const REACH: f64 = 30.0;

/// A building with rooms.
#[derive(Debug)]
pub(super) struct House<'a> {
    /// Unique in the map.
    pub(super) id: String,
    /// None of spaces that lie in no outline.
    pub(super) outline: Option<&'a Mapped>,
    /// Numbers of spaces, in their order.
    pub(super) spaces: Vec<usize>,
    /// Where its frame begins on the plane of the map, in whole metres.
    pub(super) position: Point,
}

/// The buildings with rooms, in the order of their outlines; last the one of spaces that are in none, which has the id of the map.
pub(super) fn houses<'a>(sorted: &'a Sorted, plane: &LocalPlane, own_id: &str) -> Vec<House<'a>> {
    let rings: Vec<(usize, Vec<Point>)> = sorted
        .outlines
        .iter()
        .enumerate()
        .flat_map(|(number, (_, areas))| areas.iter().map(move |area| (number, on_plane(&area.outer, plane))))
        .collect();
    let boxes = rings.iter().map(|(_, ring)| Bounds::around(ring.iter().copied()));
    let index = BoxIndex::of(boxes.zip(0..));
    let mut members: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    let mut middles = Vec::with_capacity(sorted.spaces.len());
    for (number, space) in sorted.spaces.iter().enumerate() {
        let bounds = bounds_of(space, plane);
        let house = holder(bounds.center(), &rings, &index).unwrap_or(sorted.outlines.len());
        members.entry(house).or_default().push(number);
        middles.push(bounds);
    }
    let mut ids = UniqueIds::default();
    members
        .into_iter()
        .map(|(house, spaces)| {
            let outline = sorted.outlines.get(house).map(|(outline, _)| outline);
            let around = spaces.iter().map(|&space| middles[space]).reduce(Bounds::union);
            let position = around.map_or(Point::ZERO, |bounds| bounds.center().round());
            House { id: id_of(outline, own_id, &mut ids), outline, spaces, position: position + Point::ZERO }
        })
        .collect()
}

/// The outline in which a place lies, the first of several; else the nearest within reach.
fn holder(place: Point, rings: &[(usize, Vec<Point>)], index: &BoxIndex<usize>) -> Option<usize> {
    let inside = index.near(Bounds::around_point(place, 0.0)).into_iter();
    let inside = inside.filter(|&ring| holds(&rings[ring].1, place)).map(|ring| rings[ring].0).min();
    inside.or_else(|| {
        let near = index.near(Bounds::around_point(place, REACH)).into_iter();
        let distance = |ring: usize| {
            rings[ring].1.iter().map(|corner| corner.distance(place)).fold(f64::INFINITY, f64::min)
        };
        let nearest = near.map(|ring| (distance(ring), rings[ring].0));
        nearest.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1))).map(|(_, house)| house)
    })
}

/// A name that reads well in paths, the id of the outline, or that of the map.
fn id_of(outline: Option<&Mapped>, own_id: &str, ids: &mut UniqueIds) -> String {
    let name = outline.and_then(|outline| outline.tag("name")).map(slug);
    ids.first_free(name).unwrap_or_else(|| ids.numbered(outline.map_or(own_id, |outline| &outline.id)))
}

fn bounds_of(space: &Space, plane: &LocalPlane) -> Bounds {
    Bounds::around(space.areas.iter().flat_map(corners).map(|corner| plane.project(corner.x, corner.y)))
}

fn on_plane(ring: &[Point], plane: &LocalPlane) -> Vec<Point> {
    ring.iter().map(|corner| plane.project(corner.x, corner.y)).collect()
}
