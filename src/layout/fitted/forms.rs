//! Where rows could stand: the forms that kitchens are built in.

use crate::geometry::{Point, Segment};
use crate::layout::environment::Environment;
use crate::plan::Wall;

use super::legs::{AT_CORNER, LEAST_BAR, LEAST_LEG, Leg, PASSAGE};

/// Cosine of the angle between walls at a corner that units fit into: within 1° of a right one.
const SQUARE: f64 = 0.02;
/// Stretches of which two are joined to a row in two parts, the longest first.
const MOST_PARTS: usize = 5;
/// Metres between the nearest points of such stretches at most: across an aisle, around a shaft or beside a door.
const APART: f64 = 2.4;
/// Metres between the fronts of units that face each other: two people pass (NKBA: 1.07), and one reaches both sides.
const AISLE: core::ops::RangeInclusive<f64> = 1.0..=2.2;
/// Metres of a bar that a row turns into at most: farther on it would divide the room, not end the kitchen.
const LONGEST_BAR: f64 = 2.4;

/// How the legs of a row hang together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Joint {
    /// At a corner with a unit in it: one leg ends before it, the next begins after it.
    Corner,
    /// Not: across an aisle, or on both sides of a door or shaft.
    Gap,
}

/// The form of a row: along one stretch, around a corner, around two, or in two parts.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Form {
    /// The stretches in the order of the row, without the corners.
    pub(super) legs: Vec<Leg>,
    /// What joins each to the next; all are the same.
    pub(super) joint: Joint,
}

impl Form {
    /// Whether one walks from part to part.
    pub(super) fn is_in_two_parts(&self) -> bool {
        self.legs.len() > 1 && self.joint == Joint::Gap
    }

    /// Whether one of its legs is a bar.
    pub(super) fn has_bar(&self) -> bool {
        self.legs.iter().any(Leg::is_bar)
    }
}

/// A row along each stretch of wall.
pub(super) fn straight_forms(legs: &[Leg]) -> Vec<Form> {
    let at_walls = legs.iter().filter(|leg| !leg.is_bar());
    at_walls.map(|&leg| Form { legs: vec![leg], joint: Joint::Gap }).collect()
}

/// A row around each corner where two stretches meet at a right angle, and around each two with an aisle between them; none
/// without units to stand in the corners.
pub(super) fn forms_around_corners(
    environment: &Environment<'_>,
    legs: &[Leg],
    corner_widths: &[f64],
) -> Vec<Form> {
    let walls = &environment.brief.surroundings.room.walls;
    let Some(&corner) = corner_widths.first() else { return Vec::new() };
    let mut forms = Vec::new();
    for first in legs {
        for second in legs.iter().filter(|second| meet(walls, first, second)) {
            forms.extend(around(walls, &[*first, *second], corner));
            if corner_widths.len() < 2 {
                continue;
            }
            for third in legs.iter().filter(|third| meet(walls, second, third)) {
                forms.extend(around(walls, &[*first, *second, *third], corner));
            }
        }
    }
    forms
}

/// The row along stretches that meet, if each is long enough without the corners.
fn around(walls: &[Wall], legs: &[Leg], corner: f64) -> Option<Form> {
    let mut legs = legs.to_vec();
    for place in 1..legs.len() {
        let (before, after) = (legs[place - 1], legs[place]);
        legs[place - 1] = before.part(before.from, walls[before.wall].length() - after.before - corner);
        legs[place] = after.part(before.before + corner, after.to);
    }
    if let [first, .., last] = legs.as_mut_slice() {
        let most = |leg: &Leg| if leg.is_bar() { LONGEST_BAR } else { f64::INFINITY };
        *first = first.part(first.from.max(first.to - most(first)), first.to);
        *last = last.part(last.from, last.to.min(last.from + most(last)));
    }
    let is_long = legs.iter().all(|leg| leg.length() >= LEAST_LEG);
    let bars = legs.iter().filter(|leg| leg.is_bar()).count();
    // Across two corners the outer legs face each other over the one between them.
    let is_wide = legs.len() < 3 || AISLE.contains(&legs[1].length());
    (is_long && is_wide && bars < 2).then_some(Form { legs, joint: Joint::Corner })
}

/// Whether one stretch ends in the corner where the other begins, at a right angle into the room.
fn meet(walls: &[Wall], first: &Leg, second: &Leg) -> bool {
    meet_squarely(&walls[first.wall], &walls[second.wall])
        && first.to >= walls[first.wall].length() - second.before - AT_CORNER
        && second.from <= first.before + AT_CORNER
}

/// Whether one wall ends where the other begins, at a right angle into the room.
fn meet_squarely(first: &Wall, second: &Wall) -> bool {
    let (a, b) = (first.direction(), second.direction());
    first.end.distance(second.start) < 1e-6 && a.dot(b).abs() < SQUARE && a.perp_dot(b) > 0.0
}

/// Rows along each two stretches of wall that are near each other.
pub(super) fn forms_in_two_parts(environment: &Environment<'_>, legs: &[Leg]) -> Vec<Form> {
    let walls = &environment.brief.surroundings.room.walls;
    let mut longest: Vec<Leg> = legs.iter().copied().filter(|leg| !leg.is_bar()).collect();
    // Stable: of equal lengths the earlier wall comes first.
    longest.sort_by(|a, b| b.length().total_cmp(&a.length()));
    longest.truncate(MOST_PARTS);
    let mut forms = Vec::new();
    for (index, first) in longest.iter().enumerate() {
        for (other, second) in longest.iter().enumerate() {
            let meet = meet_squarely(&walls[first.wall], &walls[second.wall])
                || meet_squarely(&walls[second.wall], &walls[first.wall]);
            let is_near = distance(stretch(walls, first), stretch(walls, second)) <= APART;
            if other != index && is_near && !meet {
                forms.push(Form { legs: vec![*first, *second], joint: Joint::Gap });
            }
        }
    }
    forms
}

/// Rows along each stretch of wall with a bar across the aisle, as long as the stretch is.
pub(super) fn forms_with_bars(environment: &Environment<'_>, legs: &[Leg], depth: f64) -> Vec<Form> {
    let walls = &environment.brief.surroundings.room.walls;
    let bars = || legs.iter().filter(|leg| leg.is_bar());
    let at_walls = legs.iter().filter(|leg| !leg.is_bar());
    let form = |leg: &Leg, bar: &Leg| {
        let (wall, open) = (&walls[leg.wall], &walls[bar.wall]);
        let aisle = (wall.start - open.start).dot(open.normal()) - bar.before - 2.0 * depth;
        let faces = wall.normal().dot(open.normal()) < SQUARE - 1.0 && AISLE.contains(&aisle);
        let bar = if faces { before(walls, leg, bar) } else { None };
        bar.map(|bar| Form { legs: vec![*leg, bar], joint: Joint::Gap })
    };
    at_walls.flat_map(|leg| bars().filter_map(|bar| form(leg, bar)).collect::<Vec<_>>()).collect()
}

/// The part of a bar that is before a stretch of wall, and what is left between it and the wall beside it if nobody walks
/// through that; `None` if the two hardly face each other.
fn before(walls: &[Wall], leg: &Leg, bar: &Leg) -> Option<Leg> {
    let (open, faced) = (&walls[bar.wall], stretch(walls, leg));
    let along = |point: Point| (point - open.start).dot(open.direction());
    let (one, other) = (along(faced.start), along(faced.end));
    let (mut from, mut to) = (bar.from.max(one.min(other)), bar.to.min(one.max(other)));
    if bar.from <= AT_CORNER && from < PASSAGE {
        from = bar.from;
    }
    let length = open.length();
    if bar.to >= length - AT_CORNER && length - to < PASSAGE {
        to = bar.to;
    }
    let part = bar.part(from, to);
    (part.length() >= LEAST_BAR).then_some(part)
}

/// A leg in the plan frame.
fn stretch(walls: &[Wall], leg: &Leg) -> Segment {
    let wall = &walls[leg.wall];
    let at = |metres: f64| wall.after(metres);
    Segment::new(at(leg.from), at(leg.to))
}

/// Metres between stretches of walls, which do not cross.
fn distance(a: Segment, b: Segment) -> f64 {
    let to_ends = |a: Segment, b: Segment| a.distance(b.start).min(a.distance(b.end));
    to_ends(a, b).min(to_ends(b, a))
}
