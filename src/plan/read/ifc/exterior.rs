//! Measures how thick the outer walls of a storey are drawn, for those of its outer walls that are not.

use super::level::Storey;
use crate::geometry::{Bounds, Point, Segment, edges, ray_hit, ring_contains, signed_area};
use crate::plan::assemble::BoxIndex;

/// Metres of the thickest wall that is measured, and of the thinnest.
const THICKEST: f64 = 0.8;
const THINNEST: f64 = 0.05;
/// Metres behind a face at which its wall is looked for, and beyond the wall at which a room is.
const BEHIND: f64 = 0.01;
const BEYOND: f64 = 0.1;
/// Metres of the shortest edge of a room that is asked.
const SHORTEST: f64 = 0.3;
/// Walls and rooms that are looked at behind one edge.
const MOST_NEAR: usize = 64;
/// Edges of rooms that are asked, and corners of walls that are: the middle of fewer is as good.
const MOST_EDGES: usize = 10_000;
const MOST_CORNERS: usize = 256;
/// Steps to a metre of the thickness that a plan names.
const STEPS: f64 = 1000.0;

impl Storey {
    /// Takes the thickness of outer walls that are not drawn from those that are: that of the middle metre of all.
    pub(super) fn measure_outer_walls(&mut self) {
        let simple = self.draft.wall_outlines.iter().zip(0..).filter(|(wall, _)| wall.len() <= MOST_CORNERS);
        let walls = BoxIndex::of(simple.map(|(wall, number)| (bounds(wall), number)));
        let rooms = self.rooms_by_place();
        let mut measured: Vec<(f64, f64)> = Vec::new();
        let outlines = self.draft.rooms.iter().map(|room| room.outline.as_slice());
        let sides = outlines.flat_map(|outline| {
            let turn = signed_area(outline).signum();
            edges(outline).map(move |edge| (edge, -edge.vector().normalize_or_zero().perp() * turn))
        });
        for (edge, outwards) in sides.filter(|(edge, _)| edge.length() >= SHORTEST).take(MOST_EDGES) {
            let thickness = self.thickness_behind(&walls, edge.middle(), outwards);
            let Some(thickness) = thickness else { continue };
            let beyond = edge.middle() + outwards * (thickness + BEYOND);
            if !self.is_in_room(&rooms, beyond) {
                measured.push((thickness, edge.length()));
            }
        }
        measured.sort_by(|a, b| a.0.total_cmp(&b.0));
        let half = measured.iter().map(|(_, length)| length).sum::<f64>() / 2.0;
        let mut passed = 0.0;
        let middle = measured.iter().find(|(_, length)| {
            passed += length;
            passed >= half
        });
        if let Some((thickness, _)) = middle {
            self.draft.exterior_thickness = (thickness * STEPS).round() / STEPS;
        }
    }

    /// Metres of the drawn wall behind a place on the edge of a room.
    fn thickness_behind(&self, walls: &BoxIndex<usize>, place: Point, outwards: Point) -> Option<f64> {
        let start = place + outwards * BEHIND;
        let mut near: Vec<usize> = walls.meeting(Bounds::around_point(start, 0.0)).take(MOST_NEAR).collect();
        near.sort_unstable();
        let outlines = near.into_iter().map(|wall| &self.draft.wall_outlines[wall]);
        let wall = outlines.into_iter().find(|wall| ring_contains(wall, start))?;
        let exits = edges(wall).filter_map(|side: Segment| ray_hit(start, outwards, side));
        let thickness = exits.reduce(f64::min)? + BEHIND;
        (THINNEST..=THICKEST).contains(&thickness).then_some(thickness)
    }

    fn is_in_room(&self, rooms: &BoxIndex<usize>, place: Point) -> bool {
        let near = rooms.meeting(Bounds::around_point(place, 0.0)).take(MOST_NEAR);
        near.into_iter().any(|room| ring_contains(&self.draft.rooms[room].outline, place))
    }
}

fn bounds(ring: &[Point]) -> Bounds {
    Bounds::around(ring.iter().copied())
}
