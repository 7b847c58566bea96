//! Wall units over a row: in one line, flush with each other, beside the hood.

use crate::catalog::{FittedPart, ParentName};
use crate::geometry::{Intervals, Point, Solid};
use crate::layout::arrange::take_size;
use crate::layout::constants::CONTACT_TOLERANCE;
use crate::layout::environment::Environment;
use crate::layout::fitted_row::{FittedUnit, walls_of};
use crate::layout::place::AgentIndex;
use crate::layout::rules::floor_along;
use crate::layout::spot::Spot;
use crate::plan::OpeningKind;

use super::lanes::ROUNDING;
use super::legs::Leg;
use super::units::{Unit, Units};

/// Hangs the wall units of a room over the low units of a row, as many as there is room for.
pub(super) fn hang(environment: &mut Environment<'_>, units: &Units, row: &[FittedUnit]) {
    let mut hanging = units.of_part(FittedPart::WallUnit).map(|(_, unit)| unit);
    let Some(mut unit) = hanging.next() else { return };
    let Some(elevation) = elevation(environment, unit.agent) else { return };
    for (wall, _) in walls_of(row).into_iter().filter(|(_, is_bar)| !is_bar) {
        for &(from, to) in stretches(environment, units, row, wall, elevation).as_slice() {
            let mut stretch = Leg::open(wall, (from, to));
            while let Some(end) = hang_one(environment, unit, &stretch, elevation) {
                stretch.from = end;
                match hanging.next() {
                    Some(next) => unit = next,
                    None => return,
                }
            }
        }
    }
}

/// Hangs a unit at the beginning of a stretch, if that is long enough and free; answers where the unit ends.
fn hang_one(environment: &mut Environment<'_>, unit: &Unit, stretch: &Leg, elevation: f64) -> Option<f64> {
    let width = unit.width_within(stretch.length() + ROUNDING)?;
    take_size(environment, unit.agent, width.variant);
    let place =
        Spot { elevation, ..Spot::standing(stretch.wall, stretch.from) }.place(environment, unit.agent);
    if !environment.is_free(unit.agent, &place) {
        return None;
    }
    environment.settle(unit.agent, &place);
    Some(stretch.from + width.metres)
}

/// The metres above the floor at which a class hangs on walls.
fn elevation(environment: &Environment<'_>, agent: AgentIndex) -> Option<f64> {
    let rules = &environment.class(agent).parents;
    rules.iter().find(|rule| rule.parent == ParentName::Wall).map(|rule| rule.elevation.0)
}

/// The stretches of a wall over low units, without those before windows, over the hob, and in the corner that the wall
/// units of the other leg reach into.
fn stretches(
    environment: &Environment<'_>,
    units: &Units,
    row: &[FittedUnit],
    wall: usize,
    elevation: f64,
) -> Intervals {
    let here = || row.iter().filter(|standing| standing.spot.wall == wall && !standing.is_bar());
    let part = |standing: &FittedUnit| units.unit(standing.unit).part;
    let low = || here().filter(|standing| part(standing) != FittedPart::Tall);
    let from = low().map(|standing| standing.from()).fold(f64::INFINITY, f64::min);
    let to = low().map(FittedUnit::to).fold(0.0, f64::max);
    let surroundings = environment.brief.surroundings;
    // A row may go on past the end of its wall, up to what closes it; nothing hangs there.
    let mut free = Intervals::new(from.max(0.0), to.min(surroundings.room.walls[wall].length()));
    let hobs = here().filter(|standing| matches!(part(standing), FittedPart::Hob | FittedPart::Tall));
    hobs.for_each(|standing| free.subtract(standing.from(), standing.to()));
    if here().any(|standing| part(standing) == FittedPart::Corner) {
        let depth =
            units.of_part(FittedPart::WallUnit).map(|(_, unit)| environment.agents[unit.agent].size.depth);
        free.subtract(0.0, depth.fold(0.0, f64::max));
    }
    for side in surroundings.room.openings.iter().filter(|side| side.wall == wall) {
        let opening = &surroundings.level.openings[side.opening];
        if opening.kind != OpeningKind::Window || opening.top > elevation {
            free.subtract(side.from, side.to);
        }
    }
    if let Some((_, unit)) = units.of_part(FittedPart::WallUnit).next() {
        subtract_lights(environment, &line_of(environment, unit, wall, elevation), wall, &mut free);
    }
    free
}

/// What wall units would fill all along a wall.
fn line_of(environment: &Environment<'_>, unit: &Unit, wall: usize, elevation: f64) -> Solid {
    let (part, size) =
        (&environment.brief.surroundings.room.walls[wall], environment.agents[unit.agent].size);
    let half = Point::new(part.length() / 2.0, size.depth / 2.0);
    Solid::new(floor_along(part, half.y, half), elevation, elevation + size.height)
}

/// Leaves out the stretches of a line along a wall that are before windows, also those of the walls beside it.
fn subtract_lights(environment: &Environment<'_>, line: &Solid, wall: usize, free: &mut Intervals) {
    let surroundings = environment.brief.surroundings;
    let (start, along) = (surroundings.room.walls[wall].start, surroundings.room.walls[wall].direction());
    for strip in surroundings.window_strips.iter().filter(|strip| line.overlaps(strip, CONTACT_TOLERANCE)) {
        let (low, high) = strip.base.project(along);
        free.subtract(low - start.dot(along), high - start.dot(along));
    }
}
