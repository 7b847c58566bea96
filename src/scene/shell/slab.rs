//! Floors, ceilings and columns: an outline with holes, given a thickness.

use glam::Vec3;

use super::solid::{Grain, Solid};
use super::ticks::{Ticks, point_in_ticks};
use crate::geometry::{Point, Polygon, Region};
use crate::recipes::Slot;

/// An upright prism. Outlines are in plan axes relative to the node that carries it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct SlabShape {
    /// Seen from above; more than one where stairs divide a floor.
    pub pieces: Vec<Piece>,
    /// Height of the underside.
    pub bottom: Ticks,
    /// Height of the top.
    pub top: Ticks,
    /// Material.
    pub slot: Slot,
    /// Which way it runs.
    pub grain: Grain,
}

/// A part of a floor.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Piece {
    /// Counter-clockwise.
    pub outline: Vec<[Ticks; 2]>,
    /// Counter-clockwise.
    pub holes: Vec<Vec<[Ticks; 2]>>,
}

impl SlabShape {
    /// Regions between two heights, as seen from `anchor`.
    pub(crate) fn of_regions(regions: &[Region], anchor: Point, heights: [Ticks; 2], slot: Slot) -> Self {
        let ring = |polygon: &Polygon| without_straight_corners(polygon, anchor);
        let piece = |region: &Region| Piece {
            outline: ring(&region.outline),
            holes: region.holes.iter().map(ring).collect(),
        };
        Self {
            pieces: regions.iter().map(piece).collect(),
            bottom: heights[0],
            top: heights[1],
            slot,
            grain: Grain::Level,
        }
    }

    /// With the grain along a direction of the plan: a unit vector.
    pub(crate) fn laid_along(self, direction: Point) -> Self {
        Self { grain: Grain::Along([Ticks::of(direction.x), Ticks::of(-direction.y)]), ..self }
    }

    /// The closed bodies.
    pub(crate) fn build(&self) -> Solid {
        let mut solid = Solid::new(self.slot).with_grain(self.grain);
        self.pieces.iter().for_each(|piece| self.piece(piece, &mut solid));
        solid
    }

    fn piece(&self, piece: &Piece, solid: &mut Solid) {
        let rings: Vec<&Vec<[Ticks; 2]>> = std::iter::once(&piece.outline).chain(&piece.holes).collect();
        let corners: Vec<[Ticks; 2]> = rings.iter().flat_map(|ring| ring.iter().copied()).collect();
        let triangles = piece.triangulate(&corners);
        let at =
            |height: Ticks| corners.iter().map(|&corner| scene_corner(corner, height)).collect::<Vec<Vec3>>();
        solid.triangles(&at(self.top), Vec3::Y, triangles.iter().flatten().copied());
        let reversed = triangles.iter().flat_map(|&[a, b, c]| [a, c, b]);
        solid.triangles(&at(self.bottom), Vec3::NEG_Y, reversed);
        for (index, ring) in rings.iter().enumerate() {
            self.sides(ring, index > 0, solid);
        }
    }

    fn sides(&self, ring: &[[Ticks; 2]], is_hole: bool, solid: &mut Solid) {
        for index in 0..ring.len() {
            let (a, b) = (ring[index], ring[(index + 1) % ring.len()]);
            let (a, b) = if is_hole { (b, a) } else { (a, b) };
            solid.face(&[
                scene_corner(a, self.bottom),
                scene_corner(b, self.bottom),
                scene_corner(b, self.top),
                scene_corner(a, self.top),
            ]);
        }
    }
}

impl Piece {
    /// Counter-clockwise triangles of the plan outline.
    fn triangulate(&self, corners: &[[Ticks; 2]]) -> Vec<[u32; 3]> {
        let mut hole_starts: Vec<u32> = Vec::with_capacity(self.holes.len());
        let mut next = self.outline.len();
        for hole in &self.holes {
            hole_starts.push(u32::try_from(next).expect("an outline has few corners"));
            next += hole.len();
        }
        let plain = corners.iter().map(|corner| corner.map(|ticks| f64::from(ticks.0)));
        let mut indices: Vec<u32> = Vec::new();
        earcut::Earcut::new().earcut(plain, &hole_starts, &mut indices);
        let doubled_area = |[a, b, c]: [u32; 3]| {
            let point = |index: u32| corners[index as usize].map(|ticks| i128::from(ticks.0));
            let ([ax, ay], [bx, by], [cx, cy]) = (point(a), point(b), point(c));
            (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        };
        let oriented = |[a, b, c]: [u32; 3]| match doubled_area([a, b, c]) {
            0 => None,
            area if area > 0 => Some([a, b, c]),
            _ => Some([a, c, b]),
        };
        indices.as_chunks::<3>().0.iter().filter_map(|&triangle| oriented(triangle)).collect()
    }
}

/// The plan's (x, y, z) as (x, z, −y), like [`crate::scene::axes`], but from ticks.
pub(super) fn scene_corner([x, y]: [Ticks; 2], height: Ticks) -> Vec3 {
    Vec3::new(x.narrow(), height.narrow(), (-y).narrow())
}

/// The ring in ticks without corners in the middle of a straight line: the triangulation skips those, and
/// the sides would not meet it.
fn without_straight_corners(polygon: &Polygon, anchor: Point) -> Vec<[Ticks; 2]> {
    let mut ring: Vec<[Ticks; 2]> =
        polygon.corners().iter().map(|&corner| point_in_ticks(corner, anchor)).collect();
    ring.dedup();
    let mut index = 0;
    while ring.len() > 3 && index < ring.len() {
        let count = ring.len();
        if is_straight(ring[(index + count - 1) % count], ring[index], ring[(index + 1) % count]) {
            ring.remove(index);
            index = index.saturating_sub(1);
        } else {
            index += 1;
        }
    }
    ring
}

fn is_straight(a: [Ticks; 2], b: [Ticks; 2], c: [Ticks; 2]) -> bool {
    let step = |from: [Ticks; 2], to: [Ticks; 2]| {
        [i128::from(to[0].0) - i128::from(from[0].0), i128::from(to[1].0) - i128::from(from[1].0)]
    };
    let (before, after) = (step(a, b), step(b, c));
    before[0] * after[1] == before[1] * after[0]
}
