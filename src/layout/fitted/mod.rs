//! Rows of fitted units, such as kitchens, planned as a whole before any agent searches.
//!
//! A kitchen is one thing: a fridge at the end of a row, the sink near the pipes with the dishwasher beside it, worktop
//! between sink and hob, everything in one line. Agents that search one after the other find such rows by luck only. Here a room
//! - takes its units from the programme (`units`): all pieces whose class has a [`crate::catalog::FittedPart`],
//! - finds where rows could stand (`forms`): along one wall, around a corner, in two parts,
//! - makes rows for each (`rows`), compares them by points (`points`), and takes the best that is free of everything,
//! - hangs the wall units over it (`hanging`).
//!
//! Units without a place in the row are left out, unless no row holds all that is required: then all of them search by
//! themselves like other agents.

mod forms;
mod hanging;
mod points;
mod rows;

#[cfg(test)]
mod tests;
mod units;

use super::agent::State;
use super::arrange::take_size;
use super::at_wall::place_at;
use super::environment::Environment;
use super::furnished::RemovalReason;
use super::place::AgentIndex;
use super::seed::{Purpose, RoomKey, Stream};
use forms::{Form, forms_around_corners, forms_in_two_parts, straight_forms};
use points::Judge;
use rows::{Row, Standing, rows_in};
use units::Units;

/// Rows that are tried in the room, the best first; a room that refuses so many has something in the way everywhere.
const MOST_ROWS: usize = 32;
/// Rows that are free and compared by the space before their units.
const FREE_ROWS: usize = 8;
/// Steps that making and comparing one row counts for, each about a tenth of a microsecond.
const STEPS_A_ROW: u64 = 8;

/// Lets the fitted units of the room rest in a row, if one holds all that are required.
pub(crate) fn settle_fitted(environment: &mut Environment<'_>, key: &RoomKey) {
    let units = Units::of(environment);
    if units.is_no_row() || has_suggestion(environment, &units) {
        return;
    }
    let mut stream = key.stream(Purpose::Placement, "fitted", 0);
    let rows = rows_by_points(environment, &units, &mut stream);
    let Some(row) = best_free(environment, &units, &rows) else { return };
    stands(environment, &units, row);
    hanging::hang(environment, &units, row);
    leave_out_others(environment, &units);
}

/// The best of the first few rows that are free, with the space before their units; a later attempt at the room takes the
/// best at other walls, for something was wrong with those before.
fn best_free<'r>(environment: &mut Environment<'_>, units: &Units, rows: &'r [Row]) -> Option<&'r Row> {
    let mut free: Vec<(f64, &Row)> = Vec::with_capacity(FREE_ROWS);
    for row in rows.iter().take(MOST_ROWS) {
        if free.len() == FREE_ROWS {
            break;
        }
        if stands(environment, units, row) {
            free.push((row.points - points::tight_points(environment, units, row), row));
            take_away(environment, units, &row.standings);
        }
    }
    // Stable: of equal points the earlier row comes first.
    free.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut seen: Vec<Vec<usize>> = Vec::new();
    free.retain(|(_, row)| {
        let is_new = !seen.contains(&row.walls());
        seen.push(row.walls());
        is_new
    });
    let turn = environment.turn.min(free.len().checked_sub(1)?);
    Some(free[turn].1)
}

/// Takes units out of the room again.
fn take_away(environment: &mut Environment<'_>, units: &Units, standings: &[Standing]) {
    for standing in standings.iter().rev() {
        environment.unsettle(units.unit(standing.unit).agent);
    }
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
    let legs = forms::free_legs(environment, units, stream);
    let mut rows = Vec::new();
    let mut add = |forms: Vec<Form>, stream: &mut Stream| {
        for form in forms {
            for row in rows_in(units, &form) {
                environment.count_steps(STEPS_A_ROW);
                let points = judge.points(units, &form, &row) + stream.unit() * points::CHANCE;
                rows.push(Row { points, ..row });
            }
        }
        rows.iter().any(|row: &Row| row.is_complete)
    };
    let is_complete = add(straight_forms(&legs), stream);
    let turns = forms_around_corners(environment, &legs, units.corner_width());
    if !(add(turns, stream) || is_complete) {
        add(forms_in_two_parts(environment, &legs), stream);
    }
    rows.sort_by(|a, b| b.points.total_cmp(&a.points));
    rows
}

/// Lets the units of a row rest where it says; if one cannot, none does.
fn stands(environment: &mut Environment<'_>, units: &Units, row: &Row) -> bool {
    for (count, standing) in row.standings.iter().enumerate() {
        let agent = units.unit(standing.unit).agent;
        take_size(environment, agent, standing.variant);
        let place = place_at(environment, agent, standing.wall, standing.from, 0.0);
        if environment.is_free(agent, &place) {
            environment.settle(agent, &place);
            continue;
        }
        take_away(environment, units, &row.standings[..count]);
        return false;
    }
    true
}

/// Units that the row has no place for do not stand elsewhere by themselves.
fn leave_out_others(environment: &mut Environment<'_>, units: &Units) {
    for agent in units.agents() {
        if environment.agents[agent].state == State::Search {
            environment.agents[agent].state = State::Removed(RemovalReason::NoPlace);
        }
    }
}
