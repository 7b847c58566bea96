//! The stretches that units could stand along: free walls, and bars along open sides.

use crate::catalog::{FittedPart, Size};
use crate::layout::environment::Environment;
use crate::layout::rules::{Line, closings, free_stretches};
use crate::layout::seed::Stream;
use crate::plan::{OpeningKind, RoomOpening, WallKind};

use super::units::Units;

/// Metres of the shortest stretch that is looked at: one narrow unit.
pub(super) const LEAST_LEG: f64 = 0.3;
/// Metres of the shortest bar: less divides nothing.
pub(super) const LEAST_BAR: f64 = 1.2;
/// Metres by which a bar may go on before the wall beside its open side.
const PAST_OPENING: f64 = 0.3;
/// Metres by which a stretch may miss the corner that it ends in.
pub(super) const AT_CORNER: f64 = 0.01;
/// Metres of wall beside a row that are of use: for a bin, a broom, a narrow shelf.
pub(super) const USEFUL: f64 = 0.6;
/// Metres between a row and a wall that are a joint.
pub(super) const JOINT: f64 = 0.03;
/// Metres of an open side that a bar leaves where it is the only way in: a main walkway (HUD: 0.91).
pub(super) const PASSAGE: f64 = 0.9;

/// A free stretch along a wall, in metres from the wall's start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Leg {
    /// Index of the wall.
    pub(super) wall: usize,
    /// Where it begins.
    pub(super) from: f64,
    /// Where it ends.
    pub(super) to: f64,
    /// Metres from the wall to the backs of the units: those before an open side leave the floor there free.
    pub(super) before: f64,
    /// Metres past its start and past its end to what closes it; infinite where nothing does, or a unit in a corner.
    pub(super) beyond: [f64; 2],
}

impl Leg {
    /// A stretch whose ends nothing closes.
    pub(super) fn open(wall: usize, (from, to): (f64, f64)) -> Self {
        Self { wall, from, to, before: 0.0, beyond: [f64::INFINITY; 2] }
    }

    /// A part of it; an end that moves is no longer closed.
    pub(super) fn part(&self, from: f64, to: f64) -> Self {
        let beyond = |moved: f64, beyond: f64| if moved.abs() < AT_CORNER { beyond } else { f64::INFINITY };
        let [start, end] = self.beyond;
        Self { from, to, beyond: [beyond(from - self.from, start), beyond(to - self.to, end)], ..*self }
    }

    /// Whether its start and its end are at what closes them.
    pub(super) fn is_closed(&self) -> [bool; 2] {
        self.beyond.map(|metres| metres < JOINT)
    }

    /// The same where nothing is farther off than a joint.
    pub(super) fn without_gaps(&self) -> Self {
        let beyond = self.beyond.map(|metres| if metres < JOINT { metres } else { f64::INFINITY });
        Self { beyond, ..*self }
    }

    /// Metres along it.
    pub(super) fn length(&self) -> f64 {
        self.to - self.from
    }

    /// Whether it is along an open side, with no wall behind.
    pub(super) fn is_bar(&self) -> bool {
        self.before > 0.0
    }
}

/// All stretches where low units could stand, in the order of the walls; then the bars.
pub(super) fn free_legs(environment: &Environment<'_>, units: &Units, stream: &mut Stream) -> Vec<Leg> {
    let low = [FittedPart::Worktop, FittedPart::Sink, FittedPart::Hob];
    let Some((_, model)) = low.into_iter().find_map(|part| units.of_part(part).next()) else {
        return Vec::new();
    };
    let size = Size { width: LEAST_LEG, ..environment.agents[model.agent].size };
    let walls = &environment.brief.surroundings.room.walls;
    let solid = || (0..walls.len()).filter(|&wall| walls[wall].kind == WallKind::Solid);
    let mut along = |wall: usize, before: f64| {
        let line = Line { agent: model.agent, size, wall, before_opening: before };
        let free = free_stretches(environment, &line, stream).into_iter();
        let mut legs: Vec<Leg> = free
            .map(|ends| Leg { before, ..Leg::open(wall, ends) })
            .filter(|leg| leg.length() >= LEAST_LEG)
            .collect();
        let closings = if legs.is_empty() { Vec::new() } else { closings(environment, &line) };
        legs.iter_mut().for_each(|leg| leg.beyond = beyond(leg, &closings));
        legs
    };
    let mut legs: Vec<Leg> = solid().flat_map(|wall| along(wall, 0.0)).collect();
    let depth = environment.brief.catalog.audit.doors.open_boundary_depth;
    let room = environment.brief.surroundings.room;
    for side in room.openings.iter().filter(|side| is_open(environment, side)) {
        let free = along(side.wall, depth);
        legs.extend(free.iter().flat_map(|leg| bars(environment, side, leg)));
    }
    legs
}

/// Metres past the ends of a stretch to what closes them.
fn beyond(leg: &Leg, closings: &[(f64, f64)]) -> [f64; 2] {
    let before = closings.iter().map(|&(_, to)| leg.from - to).filter(|metres| *metres > -AT_CORNER);
    let after = closings.iter().map(|&(from, _)| from - leg.to).filter(|metres| *metres > -AT_CORNER);
    [before.fold(f64::INFINITY, f64::min).max(0.0), after.fold(f64::INFINITY, f64::min).max(0.0)]
}

fn is_open(environment: &Environment<'_>, side: &RoomOpening) -> bool {
    environment.brief.surroundings.level.openings[side.opening].kind == OpeningKind::OpenBoundary
}

/// The bars along an open side in a free stretch: all of it where people walk around its end, through another open side that
/// begins there, else with a passage at either end.
fn bars(environment: &Environment<'_>, side: &RoomOpening, free: &Leg) -> Vec<Leg> {
    let room = environment.brief.surroundings.room;
    let length = room.walls[side.wall].length();
    // Less wall than is of use belongs to the bar.
    let past = |left: f64| if left < USEFUL { left } else { PAST_OPENING };
    let whole = free.part(
        free.from.max(side.from - past(side.from)),
        free.to.min(side.to + past(length - side.to)).min(length),
    );
    let ends = |side: &RoomOpening| {
        let wall = &room.walls[side.wall];
        [side.from, side.to].map(|metres| wall.after(metres))
    };
    let meets = |other: &RoomOpening| {
        ends(other).iter().any(|end| ends(side).iter().any(|corner| corner.distance(*end) < AT_CORNER))
    };
    let others = room.openings.iter().filter(|other| other.wall != side.wall);
    let is_way_in =
        |other: &RoomOpening| is_open(environment, other) && other.to - other.from >= PASSAGE && meets(other);
    let found = if others.into_iter().any(is_way_in) {
        vec![whole]
    } else {
        vec![
            whole.part(whole.from.max(side.from + PASSAGE), whole.to),
            whole.part(whole.from, whole.to.min(side.to - PASSAGE)),
        ]
    };
    found.into_iter().filter(|bar| bar.length() >= LEAST_BAR).collect()
}
