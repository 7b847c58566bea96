//! Which of several rows that are nearly as good a room has: a matter of taste, drawn once for all rows that look alike.
//!
//! Drawn for each row, chance changes little: a kitchen has hundreds of rows, the luckiest of each look are all about as lucky, and
//! the look that is best by a few tenths of a point comes out with every seed. Rows with faults that others do not have take no
//! part: taste is no reason for a fridge beside the hob.

use std::collections::BTreeMap;

use crate::catalog::FittedPart;
use crate::layout::fitted_row::walls_of;
use crate::layout::seed::Stream;

use super::lanes::ROUNDING;
use super::rows::Row;
use super::units::Units;

/// Points by which taste moves the rows of a look at most; a worktop that was asked for gives 1. Larger: more arrangements of a
/// kitchen, and fewer of the most units. From 3 to 8 it makes no difference to how many kitchens stand where architects drew them.
const TASTE: f64 = 4.0;
/// Metres along a wall within which a unit is in the same place to people.
const SAME_PLACE: f64 = 0.8;

/// What people see of a row at once: the walls that it stands at, and where along them sink, hob and tall units are.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct Look {
    walls: Vec<(usize, bool)>,
    units: Vec<(usize, usize, i64)>,
}

impl Look {
    fn of(units: &Units, row: &Row) -> Self {
        let is_seen =
            |part: FittedPart| matches!(part, FittedPart::Sink | FittedPart::Hob | FittedPart::Tall);
        let seen = row.standings.iter().filter(|standing| is_seen(units.unit(standing.unit).part));
        let place = |metres: f64| libm::floor(metres / SAME_PLACE) as i64;
        let mut places: Vec<(usize, usize, i64)> =
            seen.map(|standing| (standing.unit, standing.spot.wall, place(standing.from()))).collect();
        places.sort_unstable();
        Self { walls: walls_of(&row.standings), units: places }
    }
}

/// Adds the points of taste to the rows that have most of what a kitchen needs, of which the points are given for each row.
pub(super) fn add_taste(units: &Units, rows: &mut [Row], needs: &[f64], stream: &mut Stream) {
    let most = needs.iter().copied().fold(f64::NEG_INFINITY, f64::max) - ROUNDING;
    let mut tastes = BTreeMap::new();
    for (row, _) in rows.iter_mut().zip(needs).filter(|(_, needs)| **needs >= most) {
        row.points += *tastes.entry(Look::of(units, row)).or_insert_with(|| TASTE * stream.unit());
    }
}
