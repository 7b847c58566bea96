//! How good a row is: the habits of kitchen planners as points.
//!
//! Rows are compared by the sum; a worktop that was asked for and stands in the row gives 1.

use crate::catalog::FittedPart;
use crate::layout::agent::Rest;
use crate::layout::body::box_solid;
use crate::layout::constants::CONTACT_TOLERANCE;
use crate::layout::environment::Environment;
use crate::layout::place::AgentIndex;
use crate::layout::surroundings::Surroundings;
use crate::plan::{OpeningKind, Room};

use super::forms::Form;
use super::rows::{Row, Standing, metres_between};
use super::units::{Unit, Units};
use crate::layout::at_wall::pose_at;

/// Points by which chance moves a row: of rows that are equally good a seed takes one. Larger: more variety, and more rows with
/// small faults.
pub(super) const CHANCE: f64 = 0.6;
/// Points for each unit that stands in the row, and for one that only fills.
const UNIT: f64 = 1.0;
const FILL: f64 = 0.35;
/// Metres of worktop between sink and hob that are good, and the points for it; a quarter of them for less that is still some.
const BETWEEN: (f64, f64) = (0.6, 1.8);
const BETWEEN_POINTS: f64 = 4.0;
/// Points for a sink under a window.
const SINK_AT_WINDOW: f64 = 0.7;
/// Points for a sink at a wall with pipes: long drains clog.
const SINK_AT_PIPES: f64 = 1.5;
/// The tag of such walls.
const PIPES: &str = "pipes";
/// Points lost for a unit that takes light, and for a hob before any window, where curtains burn and nobody reaches the handle.
const BEFORE_WINDOW: f64 = 6.0;
/// Points lost for a unit that has less space before it than is good.
const TIGHT: f64 = 0.8;
/// Points for each end of a row that is an end of its stretch of wall.
const FLUSH: f64 = 0.3;
/// Points for a row with something tall that stands at such an end.
const TALL_AT_END: f64 = 0.7;
/// Points lost for each leg at an outer wall: windows and heating are there.
const OUTER_WALL: f64 = 0.5;
/// Points lost by rows in two parts: one walks from part to part.
const TWO_PARTS: f64 = 0.6;
/// Points lost by something tall that stands by itself.
const TALL_ALONE: f64 = 4.0;
/// Points lost by a fridge right beside the hob, which warms it.
const TALL_AT_HOB: f64 = 1.5;
/// Metres within which ends meet.
const MEETS: f64 = 0.02;

/// A window in the frame of its wall.
struct Window {
    wall: usize,
    from: f64,
    to: f64,
}

/// What rows are judged by.
pub(super) struct Judge<'a> {
    environment: &'a Environment<'a>,
    room: &'a Room,
    windows: Vec<Window>,
}

impl<'a> Judge<'a> {
    /// For the rows of a room.
    pub(super) fn new(environment: &'a Environment<'a>) -> Self {
        let Surroundings { level, room, .. } = *environment.brief.surroundings;
        let is_window = |opening: usize| level.openings[opening].kind == OpeningKind::Window;
        let sides = room.openings.iter().filter(|side| is_window(side.opening));
        let windows = sides.map(|side| Window { wall: side.wall, from: side.from, to: side.to });
        Self { environment, room, windows: windows.collect() }
    }

    /// The points of a row in a form.
    pub(super) fn points(&self, units: &Units, form: &Form, row: &Row) -> f64 {
        let each = row.standings.iter().map(|standing| self.points_of_unit(units, standing));
        let legs = legs(form);
        let outer = legs.iter().filter(|leg| self.room.walls[leg.wall].is_exterior).count();
        let parts = if matches!(form, Form::InTwoParts(..)) { TWO_PARTS } else { 0.0 };
        each.sum::<f64>() + between_points(units, form, row) + ends_points(units, form, row)
            - OUTER_WALL * outer as f64
            - parts
            - warmed_points(units, row)
            - alone_points(units, row)
    }

    fn points_of_unit(&self, units: &Units, standing: &Standing) -> f64 {
        let unit = units.unit(standing.unit);
        let value = if unit.is_fill { FILL } else { UNIT };
        let is_sink = unit.part == FittedPart::Sink;
        let has_pipes = self.room.walls[standing.wall].tags.iter().any(|tag| tag == PIPES);
        value + self.window_points(unit, standing) + if is_sink && has_pipes { SINK_AT_PIPES } else { 0.0 }
    }

    fn window_points(&self, unit: &Unit, standing: &Standing) -> f64 {
        if self.windows.is_empty() {
            return 0.0;
        }
        let size = self.environment.class(unit.agent).size(standing.variant);
        let body = box_solid(size, &pose_at(self.environment, size, standing.wall, standing.from, 0.0));
        let mut strips = self.environment.brief.surroundings.window_strips.iter();
        let overlap = |window: &Window| window.to.min(standing.to()) - window.from.max(standing.from);
        let is_behind = |window: &Window| window.wall == standing.wall && overlap(window) > MEETS;
        match unit.part {
            _ if strips.any(|strip| body.overlaps(strip, CONTACT_TOLERANCE)) => -BEFORE_WINDOW,
            FittedPart::Hob if self.windows.iter().any(is_behind) => -BEFORE_WINDOW,
            FittedPart::Sink if self.windows.iter().any(is_behind) => SINK_AT_WINDOW,
            _ => 0.0,
        }
    }
}

fn legs(form: &Form) -> Vec<super::forms::Leg> {
    match form {
        Form::Straight(leg) => vec![*leg],
        Form::AroundCorner(first, second) | Form::InTwoParts(first, second) => vec![*first, *second],
    }
}

/// Points lost for want of space before the units of a row that stands.
pub(super) fn tight_points(environment: &Environment<'_>, units: &Units, row: &Row) -> f64 {
    let agents = row.standings.iter().map(|standing| units.unit(standing.unit).agent);
    let is_tight = |agent: &AgentIndex| {
        let place = environment.agents[*agent].rest().map(Rest::place);
        place.is_some_and(|place| !environment.has_clearances(*agent, &place, true, &mut ()))
    };
    TIGHT * agents.filter(is_tight).count() as f64
}

/// Points for the worktop between sink and hob.
fn between_points(units: &Units, form: &Form, row: &Row) -> f64 {
    let find = |part| row.standings.iter().find(|standing| units.unit(standing.unit).part == part);
    let (Some(sink), Some(hob)) = (find(FittedPart::Sink), find(FittedPart::Hob)) else { return 0.0 };
    let metres = match (metres_between(units, &row.standings), form) {
        (Some(metres), _) => metres,
        (None, Form::AroundCorner(before, after)) => {
            let (first, second) = if sink.wall == before.wall { (sink, hob) } else { (hob, sink) };
            // Right at the corner, one would stand before both; else the corner is worktop, too.
            let fronts = before.to - first.to() + second.from - after.from;
            if fronts > MEETS { fronts + after.from } else { 0.0 }
        }
        _ => return 0.0,
    };
    if (BETWEEN.0..=BETWEEN.1).contains(&(metres + MEETS)) {
        BETWEEN_POINTS
    } else if metres > MEETS {
        BETWEEN_POINTS / 4.0
    } else {
        0.0
    }
}

/// Points lost by tall units beside the hob.
fn warmed_points(units: &Units, row: &Row) -> f64 {
    let of = |part| row.standings.iter().filter(move |standing| units.unit(standing.unit).part == part);
    let warmed = of(FittedPart::Tall).filter(|tall| of(FittedPart::Hob).any(|hob| touch(tall, hob)));
    TALL_AT_HOB * warmed.count() as f64
}

/// Points lost by tall units that touch no other.
fn alone_points(units: &Units, row: &Row) -> f64 {
    let tall = row.standings.iter().filter(|standing| units.unit(standing.unit).part == FittedPart::Tall);
    let alone = tall.filter(|tall| !row.standings.iter().any(|other| touch(tall, other)));
    TALL_ALONE * alone.count() as f64
}

/// Whether two units stand side by side at one wall.
fn touch(a: &Standing, b: &Standing) -> bool {
    a.wall == b.wall && ((a.to() - b.from).abs() < MEETS || (b.to() - a.from).abs() < MEETS)
}

/// Points for ends of rows at ends of stretches.
fn ends_points(units: &Units, form: &Form, row: &Row) -> f64 {
    let mut points = 0.0;
    for leg in legs(form) {
        let here = || {
            row.standings
                .iter()
                .filter(|standing| standing.wall == leg.wall && standing.from + MEETS >= leg.from)
        };
        for standing in here() {
            let is_at_end = standing.from - leg.from < MEETS || leg.to - standing.to() < MEETS;
            if is_at_end {
                points += FLUSH;
                if units.unit(standing.unit).part == FittedPart::Tall {
                    points += TALL_AT_END;
                }
            }
        }
    }
    points
}
