//! Steps, landings and handrails.

use std::collections::BTreeSet;

use glam::Vec3;

use super::slab::scene_corner;
use super::slots::RAILING_SLOT;
use super::solid::Solid;
use super::ticks::{Ticks, point_in_ticks};
use crate::geometry::{Bounds, Point, Segment};
use crate::plan::{Flight, RailPoint, Step, Well};
use crate::recipes::Slot;

/// What leads up from a floor, and what stands around the hole through which one comes up to it; in plan axes relative to the
/// node that carries it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct StairsShape {
    /// The lowest first.
    pub steps: Vec<StepShape>,
    /// Handrails, each by the places under it.
    pub rails: Vec<Vec<Foot>>,
    /// Material of the steps.
    pub slot: Slot,
}

/// A place under a handrail, and the height there.
type Foot = ([Ticks; 2], Ticks);

/// A step: counter-clockwise corners, each with the height of the underside there.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct StepShape {
    pub corners: Vec<([Ticks; 2], Ticks)>,
    pub top: Ticks,
}

/// Metres of a flight under the inner edges of its steps, and of a landing.
const WAIST: f64 = 0.14;
/// See [`WAIST`].
const LANDING: f64 = 0.2;
/// Metres of handrails above what one stands on. (Approved Document K, section 1: 0.9 m to 1 m.)
pub(super) const RAIL_HEIGHT: f64 = 0.95;
/// Side of a post's square section.
const POST: f64 = 0.024;
/// Metres across a handrail, and of its height.
const HANDRAIL: f64 = 0.044;
/// Metres between the posts of a balustrade, at most. (Approved Document K, section 3: no gap that lets a ball of 0.1 m through.)
const POST_INTERVAL: f64 = 0.12;
/// Metres that a piece of a handrail ends before the middle of its post, so that each is a closed and convex body: physics engines
/// take them one by one.
const PIECE_GAP: f64 = 0.001;
/// The sine of the angle below which a handrail goes straight on.
const STRAIGHT: f64 = 0.02;
/// Metres between the sides of a flight and the walls along its longer side.
const SIDE_GAP: f64 = 0.004;
/// Metres that a balustrade stands inside the edge of a well: it is fixed to the side of the floor.
const GUARD_INSET: f64 = 0.03;

impl StairsShape {
    /// The shape of what a room has, as seen from `anchor`.
    pub(crate) fn of(up: Option<&Flight>, well: Option<&Well>, anchor: Point, slot: Slot) -> Self {
        let step = |flight: &Flight, step: &Step| {
            let corners = step.corners.iter().map(|&corner| within(flight, corner)).collect();
            StepShape::of(&Step { corners, ..*step }, anchor)
        };
        let steps = up.iter().flat_map(|flight| flight.steps.iter().map(|one| step(flight, one))).collect();
        let handrails = up.iter().flat_map(|flight| &flight.handrails).cloned();
        let guards = well.iter().flat_map(|well| &well.guards).map(|guard| guard_points(*guard));
        let point = |point: RailPoint| (point_in_ticks(point.at, anchor), Ticks::of(point.foot));
        let rails = handrails.chain(guards).map(|rail| rail.into_iter().map(point).collect());
        Self { steps, rails: joined(rails), slot }
    }

    /// The closed bodies: steps, and what is of metal. The first steps stand in the floor, down to `bottom`, and posts as deep in
    /// what they stand on: faces in one plane flicker.
    pub(crate) fn build(&self, bottom: Ticks) -> [Solid; 2] {
        let (mut steps, mut rails) = (Solid::new(self.slot), Solid::new(RAILING_SLOT));
        self.steps.iter().for_each(|step| step.build(bottom, &mut steps));
        let posts: BTreeSet<Foot> = self.rails.iter().flatten().copied().collect();
        for (at, foot) in posts {
            post(at, [foot + bottom, foot + Ticks::of(RAIL_HEIGHT)], &mut rails);
        }
        for rail in &self.rails {
            for piece in 0..rail.len().saturating_sub(1) {
                let cuts = [piece, piece + 1].map(|at| if turns(rail, at) { HANDRAIL / 2.0 } else { 0.0 });
                handrail([rail[piece], rail[piece + 1]], cuts, &mut rails);
            }
        }
        [steps, rails]
    }
}

/// A corner of a flight a little inside what it takes of the floor: its sides lie in no plane with the faces of walls.
fn within(flight: &Flight, corner: Point) -> Point {
    let Bounds { low, high } = flight.opening.bounds();
    let middle = (low + high) / 2.0;
    middle + (corner - middle) * (1.0 - 2.0 * SIDE_GAP / (high - low).max_element())
}

/// Handrails that begin where the one before ends are one, with one post there.
fn joined(rails: impl Iterator<Item = Vec<Foot>>) -> Vec<Vec<Foot>> {
    let mut all: Vec<Vec<Foot>> = Vec::new();
    for rail in rails.filter(|rail| rail.len() > 1) {
        match all.last_mut().filter(|last| last.last() == rail.first()) {
            Some(last) => last.extend(&rail[1..]),
            None => all.push(rail),
        }
    }
    all
}

/// Whether a handrail turns at one of its places.
fn turns(rail: &[Foot], at: usize) -> bool {
    let point = |at: usize| rail.get(at).map(|([x, y], _)| Point::new(x.metres(), y.metres()));
    let around = [at.checked_sub(1).and_then(point), point(at), point(at + 1)];
    let [Some(before), Some(here), Some(after)] = around else { return false };
    let ways = [here - before, after - here].map(Point::normalize_or_zero);
    ways[0].perp_dot(ways[1]).abs() > STRAIGHT
}

/// The posts of a balustrade along an edge that has the hole on its left.
fn guard_points(edge: Segment) -> Vec<RailPoint> {
    let length = edge.length() - 2.0 * GUARD_INSET;
    if length < POST_INTERVAL {
        return Vec::new();
    }
    let fields = (length / POST_INTERVAL).ceil();
    let at = |post: f64| edge.after(GUARD_INSET + length * post / fields) + edge.normal() * GUARD_INSET;
    (0..=fields as u32).map(|post| RailPoint { at: at(f64::from(post)), foot: 0.0 }).collect()
}

impl StepShape {
    fn of(step: &Step, anchor: Point) -> Self {
        let under = |corner: usize| {
            let below = match corner {
                _ if step.is_landing => LANDING,
                0 | 1 => step.rise + WAIST,
                2 | 3 => WAIST,
                _ => WAIST + step.rise / 2.0,
            };
            Ticks::of(step.top - below)
        };
        let corners = step.corners.iter().enumerate();
        let corners = corners.map(|(number, &corner)| (point_in_ticks(corner, anchor), under(number)));
        Self { corners: corners.collect(), top: Ticks::of(step.top) }
    }

    fn build(&self, bottom: Ticks, solid: &mut Solid) {
        let tops: Vec<Vec3> =
            self.corners.iter().map(|&(corner, _)| scene_corner(corner, self.top)).collect();
        let unders: Vec<Vec3> =
            self.corners.iter().map(|&(corner, under)| scene_corner(corner, under.max(bottom))).collect();
        solid.face(&tops);
        // The underside of a step that turns is not flat.
        for next in 1..unders.len() - 1 {
            solid.face(&[unders[0], unders[next + 1], unders[next]]);
        }
        for corner in 0..tops.len() {
            let next = (corner + 1) % tops.len();
            solid.face(&[unders[corner], unders[next], tops[next], tops[corner]]);
        }
    }
}

/// A post between two heights.
fn post([x, y]: [Ticks; 2], [low, high]: [Ticks; 2], solid: &mut Solid) {
    let half = Ticks::of(POST / 2.0);
    solid.cuboid([x - half, low, -y - half], [x + half, high, -y + half]);
}

/// A handrail between two posts, level or not; where it turns, it ends beyond the post by a cut, and the next begins as much later.
fn handrail(ends: [Foot; 2], cuts: [f64; 2], solid: &mut Solid) {
    let points = ends.map(|([x, y], _)| Point::new(x.metres(), y.metres()));
    let Some(along) = (points[1] - points[0]).try_normalize() else { return };
    let across = along.perp() * (HANDRAIL / 2.0);
    let section = |end: usize| {
        let foot = ends[end].1.metres() + RAIL_HEIGHT - HANDRAIL / 2.0;
        let at = points[end] + along * (cuts[end] + PIECE_GAP * if end == 0 { 1.0 } else { -1.0 });
        let corner = |side: f64, height: f64| {
            let place = at + across * side;
            scene_corner([Ticks::of(place.x), Ticks::of(place.y)], Ticks::of(foot + height))
        };
        [corner(-1.0, 0.0), corner(1.0, 0.0), corner(1.0, HANDRAIL), corner(-1.0, HANDRAIL)]
    };
    let (start, end) = (section(0), section(1));
    for corner in 0..start.len() {
        let next = (corner + 1) % start.len();
        solid.face(&[start[corner], start[next], end[next], end[corner]]);
    }
    solid.face(&[start[3], start[2], start[1], start[0]]);
    solid.face(&end);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn step(corners: &[(f64, f64)], top: f64) -> Step {
        let corners = corners.iter().map(|&(x, y)| Point::new(x, y)).collect();
        Step { corners, top, rise: 0.18, is_landing: false }
    }

    /// Six times the volume of a closed body of triangles that look outwards, in cubic metres.
    fn volume(solid: Solid) -> f32 {
        let primitive = solid.finish();
        let corner = |index: u32| Vec3::from_array(primitive.positions[index as usize]);
        let triangles = primitive.indices.as_chunks::<3>().0.iter();
        triangles.map(|&[a, b, c]| corner(a).dot(corner(b).cross(corner(c)))).sum::<f32>() / 6.0
    }

    #[test]
    fn a_step_and_a_rail_are_closed_and_look_outwards() {
        let flat = step(&[(0.0, 0.0), (1.0, 0.0), (1.0, 0.25), (0.0, 0.25)], 0.6);
        let shape = StepShape::of(&flat, Point::ZERO);
        let mut solid = Solid::new(Slot::Stone);
        shape.build(Ticks(-1_000), &mut solid);
        // As thick at the back as the waist, at the front by a rise more.
        let wanted = 0.25 * (WAIST + 0.09);
        assert!((f64::from(volume(solid)) - wanted).abs() < 1e-4);
        let mut rail = Solid::new(RAILING_SLOT);
        let ends = [(0.0, 0.2), (0.25, 0.38)].map(|(x, foot)| ([Ticks::of(x), Ticks(0)], Ticks::of(foot)));
        handrail(ends, [0.0; 2], &mut rail);
        let wanted = (0.25 - 2.0 * PIECE_GAP) * HANDRAIL * HANDRAIL;
        assert!((f64::from(volume(rail)) - wanted).abs() < 1e-5);
    }

    #[test]
    fn the_first_step_stands_in_the_floor() {
        let first = step(&[(0.0, 0.0), (1.0, 0.0), (1.0, 0.25), (0.0, 0.25)], 0.18);
        let mut solid = Solid::new(Slot::Stone);
        StepShape::of(&first, Point::ZERO).build(Ticks(-1_000), &mut solid);
        let heights = solid.finish().positions.into_iter().map(|[_, height, _]| height);
        assert_eq!(heights.fold(f32::INFINITY, f32::min), -0.01);
    }
}
