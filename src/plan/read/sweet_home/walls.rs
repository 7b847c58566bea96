//! Turns walls into the bodies that they have on the floor: mitred where two meet, in short pieces where they are round.
//!
//! ```text
//!   left face   -----------+      the faces of two walls that meet are
//!   centre line - - - - - -|\     prolonged or cut to where they cross
//!   right face  -------+   | |
//! ```

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use super::faults::Notes;
use super::home::HomeWall;
use crate::geometry::{Bounds, Point, Segment};
use crate::plan::assemble::BoxIndex;
use crate::plan::limits::WALL_THICKNESS;

/// Metres between the middle of a piece of a round wall and its arc; the application draws walls so, too.
const SAGITTA: f64 = 0.0035;
/// Pieces of a round wall at most.
const MOST_PIECES: usize = 128;
/// Metres between the ends of two walls that meet.
const MEETING: f64 = 0.01;
/// Thicknesses that a mitre reaches beyond the end of its wall at most: of a sharper angle it would be a spike.
const LONGEST_MITRE: f64 = 2.0;
/// Metres of the lowest wall that is more than a parapet or a bar.
const LOWEST_WALL: f64 = 1.3;

/// A wall on the floor of its level.
#[derive(Clone, Debug)]
pub(super) struct Body {
    /// Its centre line, from start to end.
    pub(super) axis: Vec<Point>,
    pub(super) outline: Vec<Point>,
    pub(super) thickness: f64,
    /// Metres of its lower and of its higher end.
    pub(super) heights: [f64; 2],
}

impl Body {
    /// Whether one can look over it.
    pub(super) fn is_low(&self) -> bool {
        self.heights[1] < LOWEST_WALL
    }

    /// The straight pieces of its centre line.
    pub(super) fn segments(&self) -> impl Iterator<Item = Segment> + '_ {
        self.axis.windows(2).map(|ends| Segment::new(ends[0], ends[1]))
    }

    pub(super) fn bounds(&self) -> Bounds {
        Bounds::around(self.outline.iter().copied())
    }
}

/// The bodies of the walls of a level, `height` metres high where they say nothing.
pub(super) fn bodies(walls: &[&HomeWall], height: f64, notes: &mut Notes) -> Vec<Body> {
    let sound: Vec<(&HomeWall, Vec<Point>)> =
        walls.iter().filter(|wall| is_sound(wall, notes)).map(|wall| (*wall, axis(wall))).collect();
    let ends = sound
        .iter()
        .zip(0..)
        .flat_map(|((_, axis), wall)| [(axis[0], (wall, false)), (axis[axis.len() - 1], (wall, true))]);
    let index = BoxIndex::of(ends.map(|(end, which)| (Bounds::around_point(end, MEETING), which)));
    let bodies = sound.iter().enumerate().map(|(number, (wall, axis))| {
        let neighbour = |end: Point, is_end: bool| {
            let near = index.near(Bounds::around_point(end, 0.0));
            // Three walls that meet leave no gap that a mitre would close: their bodies overlap.
            let mut others = near.into_iter().filter(|other| *other != (number, is_end));
            match (others.next(), others.next()) {
                (Some((other, at_end)), None) if other != number => {
                    let (wall, axis) = &sound[other];
                    Some((departing(axis, at_end), wall.thickness))
                }
                _ => None,
            }
        };
        let first = neighbour(axis[0], false);
        let last = neighbour(axis[axis.len() - 1], true);
        let own = wall.height.unwrap_or(height);
        let far = wall.height_at_end.unwrap_or(own);
        Body {
            outline: mitred(axis, wall.thickness, [first, last]),
            axis: axis.clone(),
            thickness: wall.thickness,
            heights: [own.min(far), own.max(far)],
        }
    });
    bodies.collect()
}

fn is_sound(wall: &HomeWall, notes: &mut Notes) -> bool {
    if !(WALL_THICKNESS.0..=WALL_THICKNESS.1).contains(&wall.thickness) || wall.thickness == 0.0 {
        let message = format!("a wall is {} m thick", wall.thickness);
        notes.warn(wall.place, message, "it is left out; walls are up to 3 m thick");
        return false;
    }
    // The application leaves such walls behind when points are dragged together.
    wall.start.distance(wall.end) > MEETING
}

/// The centre line; of a round wall the corners of its pieces.
fn axis(wall: &HomeWall) -> Vec<Point> {
    let chord = wall.end - wall.start;
    let half = (wall.arc / 2.0).clamp(-TAU / 2.01, TAU / 2.01);
    if half.abs() < 0.01 {
        return vec![wall.start, wall.end];
    }
    // The centre lies on the bisector of the chord: to the left of an arc that turns to the left by less than half a turn.
    let center = wall.start.midpoint(wall.end) + chord.perp() / (2.0 * libm::tan(half));
    let radius = center.distance(wall.start);
    let step = 2.0 * libm::acos((1.0 - SAGITTA / radius).clamp(-1.0, 1.0));
    let count = ((2.0 * half.abs() / step.max(1e-6)).ceil() as usize).clamp(2, MOST_PIECES);
    let arm = wall.start - center;
    let inner = (1..count).map(|number| {
        let (sine, cosine) = libm::sincos(2.0 * half * number as f64 / count as f64);
        center + Point::new(cosine, sine).rotate(arm)
    });
    std::iter::once(wall.start).chain(inner).chain(std::iter::once(wall.end)).collect()
}

/// Unit vector along a wall away from one of its ends.
fn departing(axis: &[Point], at_end: bool) -> Point {
    let count = axis.len();
    let step = if at_end { axis[count - 2] - axis[count - 1] } else { axis[1] - axis[0] };
    step.normalize_or_zero()
}

/// The direction and the thickness of the wall that goes on from an end.
type Neighbour = Option<(Point, f64)>;

/// The outline of a wall with mitres at the ends where it meets others. A wall shorter than its mitres, such as the end of a pier, has
/// square ends: its faces would cross.
fn mitred(axis: &[Point], thickness: f64, neighbours: [Neighbour; 2]) -> Vec<Point> {
    let count = axis.len();
    let ring = outline(axis, thickness, neighbours);
    let runs_on = |face: &[Point], number: usize| {
        (face[number + 1] - face[number]).dot(axis[number + 1] - axis[number]) > 0.0
    };
    let right: Vec<Point> = ring[count..].iter().rev().copied().collect();
    let faces = [&ring[..count], &right[..]];
    let is_sound = faces.iter().all(|face| (0..count - 1).all(|number| runs_on(face, number)));
    if is_sound { ring } else { outline(axis, thickness, [None, None]) }
}

/// Both faces of a wall as one ring: the left one from start to end, the right one back.
fn outline(axis: &[Point], thickness: f64, [first, last]: [Neighbour; 2]) -> Vec<Point> {
    let half = thickness / 2.0;
    let count = axis.len();
    let mut faces = [Vec::with_capacity(count), Vec::with_capacity(count)];
    for (number, &point) in axis.iter().enumerate() {
        let corners = if number == 0 {
            let [right, left] = end_corners(point, departing(axis, false), half, first);
            [left, right]
        } else if number == count - 1 {
            end_corners(point, departing(axis, true), half, last)
        } else {
            let before = (point - axis[number - 1]).normalize_or_zero();
            let after = (axis[number + 1] - point).normalize_or_zero();
            let across = (before + after).normalize_or_zero().perp();
            let reach = half / across.dot(before.perp()).max(0.5);
            [point + across * reach, point - across * reach]
        };
        faces[0].push(corners[0]);
        faces[1].push(corners[1]);
    }
    let [left, right] = faces;
    left.into_iter().chain(right.into_iter().rev()).collect()
}

/// The corners of a wall at an end, seen along `inward` from there: to the right, then to the left.
fn end_corners(end: Point, inward: Point, half: f64, neighbour: Neighbour) -> [Point; 2] {
    let square = [end - inward.perp() * half, end + inward.perp() * half];
    let Some((away, thickness)) = neighbour else { return square };
    let sine = inward.perp_dot(away);
    let other = thickness / 2.0;
    // The right face of this wall meets the left face of the other, both seen from their common end.
    let crossing = |side: f64| {
        let own = end + inward.perp() * (half * side);
        let far = end - away.perp() * (other * side);
        let along = (far - own).perp_dot(away) / sine;
        (along.abs() <= LONGEST_MITRE * (half + other)).then(|| own + inward * along)
    };
    let is_straight_on = sine.abs() < 0.02;
    if is_straight_on {
        return square;
    }
    match (crossing(-1.0), crossing(1.0)) {
        (Some(right), Some(left)) => [right, left],
        _ => square,
    }
}

/// The usual thicknesses of walls of a level: of outer ones, the upper quarter by length, and of all.
pub(super) fn usual_thicknesses(bodies: &[Body]) -> Option<[f64; 2]> {
    let mut lengths: BTreeMap<u64, f64> = BTreeMap::new();
    for body in bodies.iter().filter(|body| !body.is_low()) {
        // Of numbers above zero the bits have the order of the numbers.
        *lengths.entry(body.thickness.to_bits()).or_default() +=
            body.segments().map(Segment::length).sum::<f64>();
    }
    let total: f64 = lengths.values().sum();
    let at = |share: f64| {
        let mut passed = 0.0;
        let found = lengths.iter().find(|(_, length)| {
            passed += **length;
            passed >= total * share
        });
        found.map(|(bits, _)| f64::from_bits(*bits))
    };
    Some([at(0.75)?, at(0.25)?])
}
