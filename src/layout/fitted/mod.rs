//! Rows of fitted units, such as kitchens, planned as a whole before any agent searches.
//!
//! A kitchen is one thing: a fridge at the end of a row, the sink near the pipes with the dishwasher beside it, worktop
//! between sink and hob, everything in one line. Agents that search one after the other find such rows by luck only. Here a room
//! - takes its units from the programme (`units`): all pieces whose class has a [`crate::catalog::FittedPart`],
//! - finds the stretches that are free (`legs`): of walls, and along open sides for bars,
//! - joins them to rows (`forms`): along one wall, around one corner or two, in two parts, with a bar across the aisle,
//! - makes rows for each (`rows`) of the units that fit side by side (`lanes`), compares them by points (`points`), to which those
//!   without faults add the taste of the seed (`taste`), and takes the best that is free of everything,
//! - hangs the wall units over it (`hanging`),
//! - does so again with slim units where somebody would have too little space before the usual ones.
//!
//! Units without a place in the row are left out, unless no row holds all that is required: then all of them search by
//! themselves like other agents.

mod forms;
mod hanging;
mod lanes;
mod legs;
mod points;
mod rows;
mod taste;
#[cfg(test)]
mod tests;
mod units;

use super::agent::State;
use super::arrange::take_size;
use super::environment::Environment;
use super::first_search::of_first_search;
use super::fitted_row::{FittedUnit, FreeRow, walls_of};
use super::furnished::RemovalReason;
use super::known::Found;
use super::place::{AgentIndex, Place};
use super::seed::{Purpose, RoomKey, Stream};
use crate::catalog::FittedPart;
use forms::{Form, forms_around_corners, forms_in_two_parts, forms_with_bars, straight_forms};
use points::Judge;
use rows::{Row, rows_in};
use taste::add_taste;
use units::{Depth, Units};

/// Rows that the room may refuse, the best first; one that refuses so many has something in the way everywhere.
const MOST_ROWS: usize = 32;
/// Rows along the same walls of those that are refused, before others are tried: what is in the way there is in the way of most.
const REFUSED_ROWS: usize = 6;
/// Rows that are free and compared by the space before their units.
const FREE_ROWS: usize = 8;
/// Steps that making and comparing one row counts for, each about a tenth of a microsecond.
const STEPS_A_ROW: u64 = 8;

/// Lets the fitted units of the room rest in a row, if one holds all that are required.
pub(crate) fn settle_fitted(environment: &mut Environment<'_>, key: &RoomKey) {
    let usual = Units::of(environment, Depth::Usual);
    if usual.is_no_row() || has_suggestion(environment, &usual) {
        return leave_out_fillers(environment, &usual);
    }
    let slim = Units::of(environment, Depth::Slim);
    let mut best = row_at_turn(environment, &usual, Depth::Usual, key).map(|row| (&usual, row));
    if best.as_ref().is_none_or(|(_, row)| row.is_tight) && slim.are_slim(environment) {
        let other = row_at_turn(environment, &slim, Depth::Slim, key);
        let other = other.map(|row| FreeRow { points: row.points - points::SLIM, ..row });
        let points = |row: Option<&FreeRow>| row.map(|row| row.points);
        // Of equals the usual.
        if points(other.as_ref()) > points(best.as_ref().map(|(_, row)| row)) {
            best = other.map(|row| (&slim, row));
        }
    }
    let Some((units, FreeRow { standings, .. })) = best else {
        take_drawn_sizes(environment, &usual);
        return leave_out_fillers(environment, &usual);
    };
    settle_row(environment, units, &standings);
    hanging::hang(environment, units, &standings);
    leave_out_others(environment, units);
}

/// The row that an attempt takes: the best at other walls than those that earlier attempts took, for something was wrong with them.
fn row_at_turn(
    environment: &mut Environment<'_>,
    units: &Units,
    depth: Depth,
    key: &RoomKey,
) -> Option<FreeRow> {
    take_drawn_sizes(environment, units);
    at_turn_of_first_search(environment, units, depth).or_else(|| {
        let rows = search(environment, units, depth, key).best_first;
        rows.get(environment.turn).or(rows.last()).cloned()
    })
}

/// The row that this attempt takes of those that the first attempt found. None where these are too few, or where it is not known to
/// find the same room, because somebody says where some fit: then leaves have their true arcs.
fn at_turn_of_first_search(
    environment: &mut Environment<'_>,
    units: &Units,
    depth: Depth,
) -> Option<FreeRow> {
    let brief = environment.brief;
    if !brief.alternative.suggestions.is_empty() {
        return None;
    }
    let known = &brief.known_rows[usize::from(depth == Depth::Slim)];
    of_first_search(
        environment,
        known,
        |environment| search(environment, units, depth, brief.key),
        |environment, rows| rows.get(environment.turn).cloned(),
    )
}

/// The best row of some units at each walls that have a free one, with the space before its units; the best first.
fn search(environment: &mut Environment<'_>, units: &Units, depth: Depth, key: &RoomKey) -> Found<FreeRow> {
    let before = environment.steps();
    let name = if depth == Depth::Slim { "fitted slim" } else { "fitted" };
    let rows = rows_by_points(environment, units, &mut key.stream(Purpose::Placement, name, 0));
    let mut free: Vec<FreeRow> = Vec::with_capacity(FREE_ROWS);
    let mut refused: Vec<Vec<(usize, bool)>> = Vec::with_capacity(MOST_ROWS);
    for row in rows {
        if free.len() == FREE_ROWS || refused.len() == MOST_ROWS {
            break;
        }
        let walls = walls_of(&row.standings);
        if refused.iter().filter(|other| **other == walls).count() < REFUSED_ROWS {
            match points_if_free(environment, units, &row) {
                Some(points) => {
                    let is_tight = points < row.points;
                    free.push(FreeRow { standings: row.standings, points, is_tight });
                }
                None => refused.push(walls),
            }
        }
    }
    // Stable: of equal points the earlier row comes first.
    free.sort_by(|a, b| b.points.total_cmp(&a.points));
    let mut seen: Vec<Vec<(usize, bool)>> = Vec::new();
    free.retain(|row| {
        let walls = walls_of(&row.standings);
        let is_new = !seen.contains(&walls);
        seen.push(walls);
        is_new
    });
    Found { best_first: free, steps: environment.steps() - before }
}

/// Whether somebody knows a place for one of the units: then they search by themselves.
fn has_suggestion(environment: &Environment<'_>, units: &Units) -> bool {
    let mut suggestions = environment.brief.alternative.suggestions.iter();
    suggestions.any(|suggested| {
        let is_of_class = |agent: AgentIndex| environment.agents[agent].piece.class == suggested.class;
        units.agents().any(is_of_class)
    })
}

/// The rows that are possible, best first; of equal points the earlier one.
fn rows_by_points(environment: &Environment<'_>, units: &Units, stream: &mut Stream) -> Vec<Row> {
    let judge = Judge::new(environment);
    let legs = legs::free_legs(environment, units, stream);
    let mut rows = Vec::new();
    let mut needs = Vec::new();
    let mut add = |forms: Vec<Form>, stream: &mut Stream| {
        for form in forms {
            for row in rows_in(units, &form) {
                environment.count_steps(STEPS_A_ROW);
                let merit = judge.merit(units, &form, &row);
                needs.push(merit.needs);
                rows.push(Row { points: merit.points() + stream.unit() * points::CHANCE, ..row });
            }
        }
        rows.iter().any(|row: &Row| row.is_complete)
    };
    let is_complete = add(straight_forms(&legs), stream);
    let turns = forms_around_corners(environment, &legs, &units.corner_widths());
    let has_turns = add(turns, stream);
    add(forms_with_bars(environment, &legs, units.depth(environment)), stream);
    // In a narrow kitchen the legs around a corner leave less space than two rows do.
    if !(has_turns || is_complete) || units.are_slim(environment) {
        add(forms_in_two_parts(environment, &legs), stream);
    }
    add_taste(units, &mut rows, &needs, stream);
    // Stable: of equal points the earlier row comes first.
    rows.sort_by(|a, b| b.points.total_cmp(&a.points));
    rows
}

/// The points of a row with those for the space before its units, if it is free. The room is as before.
fn points_if_free(environment: &mut Environment<'_>, units: &Units, row: &Row) -> Option<f64> {
    let mut standing = 0;
    for one in &row.standings {
        let place = take_place(environment, units, one);
        if !environment.is_free(units.unit(one.unit).agent, &place) {
            break;
        }
        environment.settle(units.unit(one.unit).agent, &place);
        standing += 1;
    }
    let is_free = standing == row.standings.len();
    let points = is_free.then(|| row.points - points::tight_points(environment, units, row));
    for one in row.standings[..standing].iter().rev() {
        environment.unsettle(units.unit(one.unit).agent);
    }
    points
}

/// Lets the units of a row that is free rest where it says.
fn settle_row(environment: &mut Environment<'_>, units: &Units, row: &[FittedUnit]) {
    for one in row {
        let place = take_place(environment, units, one);
        environment.settle(units.unit(one.unit).agent, &place);
    }
}

/// Gives a unit the size that it has in its row, and answers its place there.
fn take_place(environment: &mut Environment<'_>, units: &Units, standing: &FittedUnit) -> Place {
    let agent = units.unit(standing.unit).agent;
    take_size(environment, agent, standing.variant);
    standing.spot.place(environment, agent)
}

/// Gives units back the sizes that were drawn for them.
fn take_drawn_sizes(environment: &mut Environment<'_>, units: &Units) {
    for unit in units.indices().map(|index| units.unit(index)) {
        take_size(environment, unit.agent, unit.widths[0].variant);
    }
}

/// Fillers close gaps of rows: where units search by themselves there is no row.
fn leave_out_fillers(environment: &mut Environment<'_>, units: &Units) {
    for (_, unit) in units.of_part(FittedPart::Filler) {
        environment.agents[unit.agent].state = State::Removed(RemovalReason::NoPlace);
    }
}

/// Units that the row has no place for do not stand elsewhere by themselves.
fn leave_out_others(environment: &mut Environment<'_>, units: &Units) {
    for agent in units.agents() {
        if environment.agents[agent].state == State::Search {
            environment.agents[agent].state = State::Removed(RemovalReason::NoPlace);
        }
    }
}
