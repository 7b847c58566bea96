//! Where rows could stand: the forms that kitchens are built in.

use crate::catalog::{FittedPart, Size};
use crate::geometry::Segment;
use crate::layout::environment::Environment;
use crate::layout::rules::free_wall;
use crate::layout::seed::Stream;
use crate::plan::{Wall, WallKind};

use super::units::Units;

/// Metres of the shortest stretch of wall that is looked at: one narrow unit.
const LEAST_LEG: f64 = 0.3;
/// Metres by which a stretch may miss the corner that it ends in.
const AT_CORNER: f64 = 0.01;
/// Cosine of the angle between walls at a corner that units fit into: within 1° of a right one.
const SQUARE: f64 = 0.02;
/// Stretches of which two are joined to a row in two parts, the longest first.
const MOST_PARTS: usize = 5;
/// Metres between the nearest points of such stretches at most: across an aisle, around a shaft or beside a door.
const APART: f64 = 2.4;

/// A free stretch of a wall, in metres from the wall's start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Leg {
    /// Index of the wall.
    pub(super) wall: usize,
    /// Where it begins.
    pub(super) from: f64,
    /// Where it ends.
    pub(super) to: f64,
}

impl Leg {
    /// Metres of wall.
    pub(super) fn length(&self) -> f64 {
        self.to - self.from
    }
}

/// The form of a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Form {
    /// Along one wall.
    Straight(Leg),
    /// Along two walls that meet: the first ends before the corner, the second begins after it.
    AroundCorner(Leg, Leg),
    /// In two parts, along walls that face each other or on both sides of a door or shaft.
    InTwoParts(Leg, Leg),
}

/// All stretches of wall where low units could stand, in the order of the walls.
pub(super) fn free_legs(environment: &Environment<'_>, units: &Units, stream: &mut Stream) -> Vec<Leg> {
    let low = [FittedPart::Worktop, FittedPart::Sink, FittedPart::Hob];
    let Some((_, model)) = low.into_iter().find_map(|part| units.of_part(part).next()) else {
        return Vec::new();
    };
    let size = Size { width: LEAST_LEG, ..environment.agents[model.agent].size };
    let walls = &environment.brief.surroundings.room.walls;
    let solid = (0..walls.len()).filter(|&wall| walls[wall].kind == WallKind::Solid);
    solid
        .flat_map(|wall| {
            let free = free_wall(environment, model.agent, size, wall, stream);
            free.into_iter().map(move |(from, to)| Leg { wall, from, to })
        })
        .filter(|leg| leg.length() >= LEAST_LEG)
        .collect()
}

/// A row along each stretch.
pub(super) fn straight_forms(legs: &[Leg]) -> Vec<Form> {
    legs.iter().map(|&leg| Form::Straight(leg)).collect()
}

/// A row around each corner where two stretches meet at a right angle; none without a unit to stand in the corner.
pub(super) fn forms_around_corners(
    environment: &Environment<'_>,
    legs: &[Leg],
    corner_width: Option<f64>,
) -> Vec<Form> {
    let Some(corner) = corner_width else { return Vec::new() };
    let walls = &environment.brief.surroundings.room.walls;
    let ends = |leg: &&Leg| leg.to >= walls[leg.wall].length() - AT_CORNER;
    let begins = |leg: &&Leg| leg.from <= AT_CORNER;
    let mut forms = Vec::new();
    for first in legs.iter().filter(ends) {
        for second in legs.iter().filter(begins) {
            if meet_squarely(&walls[first.wall], &walls[second.wall]) {
                let before = Leg { to: walls[first.wall].length() - corner, ..*first };
                let after = Leg { from: corner, ..*second };
                if before.length() >= LEAST_LEG && after.length() >= LEAST_LEG {
                    forms.push(Form::AroundCorner(before, after));
                }
            }
        }
    }
    forms
}

/// Whether one wall ends where the other begins, at a right angle into the room.
fn meet_squarely(first: &Wall, second: &Wall) -> bool {
    let (a, b) = (first.direction(), second.direction());
    first.end.distance(second.start) < 1e-6 && a.dot(b).abs() < SQUARE && a.perp_dot(b) > 0.0
}

/// Rows along each two stretches that are near each other.
pub(super) fn forms_in_two_parts(environment: &Environment<'_>, legs: &[Leg]) -> Vec<Form> {
    let walls = &environment.brief.surroundings.room.walls;
    let mut longest = legs.to_vec();
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
                forms.push(Form::InTwoParts(*first, *second));
            }
        }
    }
    forms
}

/// A leg in the plan frame.
fn stretch(walls: &[Wall], leg: &Leg) -> Segment {
    let wall = &walls[leg.wall];
    let at = |metres: f64| wall.start + wall.direction() * metres;
    Segment::new(at(leg.from), at(leg.to))
}

/// Metres between stretches of walls, which do not cross.
fn distance(a: Segment, b: Segment) -> f64 {
    let to_ends = |a: Segment, b: Segment| a.distance(b.start).min(a.distance(b.end));
    to_ends(a, b).min(to_ends(b, a))
}
