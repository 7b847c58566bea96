//! How good a row is: the habits of kitchen planners as points.
//!
//! Rows are compared by the sum; a worktop that was asked for and stands in the row gives 1.

use crate::catalog::FittedPart;
use crate::geometry::Solid;
use crate::layout::agent::Rest;
use crate::layout::body::append_solids;
use crate::layout::brief::Brief;
use crate::layout::constants::CONTACT_TOLERANCE;
use crate::layout::environment::Environment;
use crate::layout::fitted_row::FittedUnit;
use crate::layout::place::AgentIndex;
use crate::layout::surroundings::Surroundings;
use crate::plan::{OpeningKind, PIPES_TAG, Room};

use super::forms::{Form, Joint};
use super::lanes::ROUNDING;
use super::legs::{AT_CORNER, JOINT, Leg, USEFUL};
use super::rows::{Row, metres_between};
use super::units::{Unit, Units};

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
/// Points lost for a unit that takes light, and for a hob before any window, where curtains burn and nobody reaches the handle.
const BEFORE_WINDOW: f64 = 6.0;
/// Points lost for a unit that has less space before it than is good.
const TIGHT: f64 = 1.6;
/// Points lost by rows of slim units: less than [`TIGHT`], for who has space before them has it before all.
pub(super) const SLIM: f64 = 0.6;
/// Points for each end of a row that is an end of its stretch of wall.
const FLUSH: f64 = 0.3;
/// Points lost for each end of a row that leaves wall of no use beside it: more than chance gives, less than space is worth.
const USELESS: f64 = 1.0;
/// Points for a row with something tall that stands at such an end.
const TALL_AT_END: f64 = 0.7;
/// Points lost for each leg at an outer wall: windows and heating are there.
const OUTER_WALL: f64 = 0.5;
/// Points lost by rows in two parts: one walks from part to part.
const TWO_PARTS: f64 = 0.6;
/// Points for a bar along an open side: it divides the kitchen from the room that it opens to, as most architects draw it. More
/// than chance gives. From 0.5 to 4 it makes no difference to how many kitchens stand where architects drew them (two of three).
const BAR: f64 = 2.0;
/// Points lost by a hob on a bar, over which no hood hangs, and by something tall there.
const HOB_ON_BAR: f64 = 6.0;
const TALL_ON_BAR: f64 = 1.5;
/// Points lost by something tall that stands by itself.
const TALL_ALONE: f64 = 4.0;
/// Points lost by a fridge right beside the hob, which warms it, and the metres that keep it cool: the narrowest unit does, a
/// filler does not.
const TALL_AT_HOB: f64 = 3.0;
const COOL: f64 = 0.15;
/// Metres within which ends meet.
const MEETS: f64 = 0.02;

/// A window in the frame of its wall.
struct Window {
    wall: usize,
    from: f64,
    to: f64,
}

/// How good a row is.
pub(super) struct Merit {
    /// Points for what a kitchen needs, less those for what is wrong with it.
    pub(super) needs: f64,
    /// Points for what planners like, less those for what they do not.
    likes: f64,
}

impl Merit {
    /// The sum that rows are compared by.
    pub(super) fn points(&self) -> f64 {
        self.needs + self.likes
    }
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
    pub(super) fn merit(&self, units: &Units, form: &Form, row: &Row) -> Merit {
        let each = |points: fn(&Self, &Units, &FittedUnit) -> f64| -> f64 {
            row.standings.iter().map(|standing| points(self, units, standing)).sum()
        };
        let outer = form.legs.iter().filter(|leg| self.room.walls[leg.wall].is_exterior).count();
        let parts = match (form.has_bar(), form.is_in_two_parts()) {
            (true, _) => BAR,
            (false, true) => -TWO_PARTS,
            (false, false) => 0.0,
        };
        let needs = each(Self::needs_of_unit) + between_points(units, form, row)
            - useless_points(form, row)
            - on_bar_points(units, row)
            - warmed_points(units, row)
            - alone_points(units, row);
        let likes = each(Self::likes_of_unit) + self.ends_points(units, form, row) + parts
            - OUTER_WALL * outer as f64;
        Merit { needs, likes }
    }

    fn needs_of_unit(&self, units: &Units, standing: &FittedUnit) -> f64 {
        let unit = units.unit(standing.unit);
        let asked = if fills(unit) { 0.0 } else { UNIT };
        asked - if self.takes_window(unit, standing) { BEFORE_WINDOW } else { 0.0 }
    }

    fn likes_of_unit(&self, units: &Units, standing: &FittedUnit) -> f64 {
        let unit = units.unit(standing.unit);
        let filled = if fills(unit) && unit.part != FittedPart::Filler { FILL } else { 0.0 };
        if unit.part != FittedPart::Sink {
            return filled;
        }
        let has_pipes = self.room.walls[standing.spot.wall].tags.iter().any(|tag| tag == PIPES_TAG);
        let is_at_window = self.is_before_window(standing) && !self.takes_light(unit, standing);
        filled + if has_pipes { SINK_AT_PIPES } else { 0.0 } + if is_at_window { SINK_AT_WINDOW } else { 0.0 }
    }

    /// Points for ends of rows at ends of stretches; a bar is better begun at a wall than in the open.
    fn ends_points(&self, units: &Units, form: &Form, row: &Row) -> f64 {
        let mut points = 0.0;
        for leg in &form.legs {
            let length = self.room.walls[leg.wall].length();
            let (begins, ends) = if leg.is_bar() {
                (leg.from <= AT_CORNER, leg.to >= length - AT_CORNER)
            } else {
                (true, true)
            };
            for standing in row.standings.iter().filter(|standing| standing.is_along(leg)) {
                let is_at_end =
                    begins && standing.from() - leg.from < MEETS || ends && leg.to - standing.to() < MEETS;
                let is_tall = units.unit(standing.unit).part == FittedPart::Tall;
                points += if is_at_end { FLUSH } else { 0.0 };
                points += if is_at_end && is_tall { TALL_AT_END } else { 0.0 };
            }
        }
        points
    }

    fn is_before_window(&self, standing: &FittedUnit) -> bool {
        let overlap = |window: &Window| window.to.min(standing.to()) - window.from.max(standing.from());
        self.windows.iter().any(|window| window.wall == standing.spot.wall && overlap(window) > MEETS)
    }

    /// Whether a unit takes the light of a window, or is a hob before one.
    fn takes_window(&self, unit: &Unit, standing: &FittedUnit) -> bool {
        !self.windows.is_empty()
            && (self.takes_light(unit, standing)
                || unit.part == FittedPart::Hob && self.is_before_window(standing))
    }

    /// Whether a unit takes the light of a window, as the audit sees it: what is as low as a parapet does not, nor does a tap.
    fn takes_light(&self, unit: &Unit, standing: &FittedUnit) -> bool {
        let class = self.environment.class(unit.agent);
        let size = class.size(standing.variant);
        let Brief { catalog, surroundings, .. } = self.environment.brief;
        let rules = &catalog.audit.windows;
        let mut parts = Vec::new();
        append_solids(&mut parts, &class.shape, size, &standing.spot.pose(self.environment, size));
        parts.retain(|part| {
            part.high > rules.low_piece + ROUNDING && part.bounds.size().max_element() >= rules.slim_part
        });
        let is_dark = |strip: &Solid| parts.iter().any(|part| strip.overlaps(part, CONTACT_TOLERANCE));
        surroundings.window_strips.iter().any(is_dark)
    }
}

/// Whether a unit only fills what wall is left. A kitchen that has room for a hob is there to cook, however small.
fn fills(unit: &Unit) -> bool {
    match unit.part {
        FittedPart::Filler => true,
        FittedPart::Hob | FittedPart::BesideSink => false,
        _ => unit.is_fill,
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
    let metres = match metres_between(units, &row.standings) {
        Some(metres) => metres,
        None => around_corner(form, sink, hob),
    };
    if (BETWEEN.0..=BETWEEN.1).contains(&(metres + MEETS)) {
        BETWEEN_POINTS
    } else if metres > MEETS {
        BETWEEN_POINTS / 4.0
    } else {
        0.0
    }
}

/// Metres of worktop between two units on both sides of a corner, 0 where no corner is between them. Right at the corner one
/// would stand before both; else the corner is worktop, too.
fn around_corner(form: &Form, one: &FittedUnit, other: &FittedUnit) -> f64 {
    let corners = form.legs.windows(2).filter(|_| form.joint == Joint::Corner);
    let fronts = corners.filter_map(|legs| {
        let (before, after) = (&legs[0], &legs[1]);
        let (first, second) = if one.is_along(before) { (one, other) } else { (other, one) };
        let are_here = first.is_along(before) && second.is_along(after);
        let fronts = before.to - first.to() + second.from() - after.from;
        (are_here && fronts > MEETS).then_some(fronts + after.from - before.before)
    });
    fronts.fold(0.0, f64::max)
}

/// Points lost for wall of no use at the ends of legs.
fn useless_points(form: &Form, row: &Row) -> f64 {
    let is_useless = |metres: f64| metres > JOINT && metres < USEFUL;
    let ends = |leg: &Leg| {
        let [before, after] = leg.beyond;
        // With the filler that goes on past an end.
        let reached = Leg { from: leg.from - if before < USEFUL { before } else { 0.0 }, ..*leg };
        let here = || row.standings.iter().filter(|standing| standing.is_along(&reached));
        let from = here().map(FittedUnit::from).fold(f64::INFINITY, f64::min);
        let to = here().map(FittedUnit::to).fold(f64::NEG_INFINITY, f64::max);
        [before + from - leg.from, after + leg.to - to].into_iter().filter(|gap| is_useless(*gap)).count()
    };
    USELESS * form.legs.iter().map(ends).sum::<usize>() as f64
}

/// Points lost by what does not belong on a bar: a hob, which has no hood there, and what is tall.
fn on_bar_points(units: &Units, row: &Row) -> f64 {
    let on_bar = row.standings.iter().filter(|standing| standing.is_bar());
    let lost = on_bar.map(|standing| match units.unit(standing.unit).part {
        FittedPart::Hob => HOB_ON_BAR,
        FittedPart::Tall => TALL_ON_BAR,
        _ => 0.0,
    });
    lost.sum()
}

/// Points lost by tall units beside the hob.
fn warmed_points(units: &Units, row: &Row) -> f64 {
    let of = |part| row.standings.iter().filter(move |standing| units.unit(standing.unit).part == part);
    let is_warm =
        |tall: &FittedUnit, hob: &FittedUnit| apart(tall, hob).is_some_and(|metres| metres < COOL - ROUNDING);
    let warmed = of(FittedPart::Tall).filter(|tall| of(FittedPart::Hob).any(|hob| is_warm(tall, hob)));
    TALL_AT_HOB * warmed.count() as f64
}

/// Points lost by tall units that touch no other.
fn alone_points(units: &Units, row: &Row) -> f64 {
    let tall = row.standings.iter().filter(|standing| units.unit(standing.unit).part == FittedPart::Tall);
    let alone = tall.filter(|tall| !row.standings.iter().any(|other| touch(tall, other)));
    TALL_ALONE * alone.count() as f64
}

/// Metres between two units at one wall; below zero where they overlap.
fn apart(a: &FittedUnit, b: &FittedUnit) -> Option<f64> {
    let is_one_line = a.spot.wall == b.spot.wall && a.is_bar() == b.is_bar();
    is_one_line.then(|| (a.from() - b.to()).max(b.from() - a.to()))
}

/// Whether two units stand side by side at one wall.
fn touch(a: &FittedUnit, b: &FittedUnit) -> bool {
    apart(a, b).is_some_and(|metres| metres.abs() < MEETS)
}
