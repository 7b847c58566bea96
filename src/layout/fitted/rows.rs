//! The rows that can be made of the units of a room in a form.

use crate::catalog::FittedPart;

use super::forms::{Form, Joint};
use super::lanes::{ENOUGH_BETWEEN, End, Lane, Packed, ROUNDING, Slot, Taken};
use super::legs::{Leg, USEFUL};
use super::units::{Unit, Units, Width};
use crate::layout::fitted_row::FittedUnit;
use crate::layout::spot::Spot;

/// Metres of the second part of a row in two parts at most: a fridge with worktops.
const SECOND_PART: f64 = 1.25;
/// Metres between two corners that no unit is narrow enough for.
const PANEL: f64 = 0.15;

/// The orders that a row is built in, and from its other end: what is brought home goes from the fridge to the sink, to the
/// worktop, to the hob; or the fridge stands behind the worktop beside the hob.
const ORDERS: [[Slot; 8]; 2] = [
    [Slot::Tall, Slot::Rest, Slot::Beside, Slot::Sink, Slot::Between, Slot::Hob, Slot::Landing, Slot::Rest],
    [Slot::Rest, Slot::Beside, Slot::Sink, Slot::Between, Slot::Hob, Slot::Landing, Slot::Rest, Slot::Tall],
];

/// A row: the units of a room in one order.
#[derive(Clone, Debug)]
pub(super) struct Row {
    /// Who stands where; units in corners first.
    pub(super) standings: Vec<FittedUnit>,
    /// Whether all units stand in it but those that only fill, with enough worktop between sink and hob.
    pub(super) is_complete: bool,
    /// How good it is, once that was asked.
    pub(super) points: f64,
}

/// All rows in a form that hold the units that are required.
pub(super) fn rows_in(units: &Units, form: &Form) -> Vec<Row> {
    let mut rows = Vec::new();
    for order in &ORDERS {
        let reversed: Vec<Slot> = order.iter().rev().copied().collect();
        for slots in [order.as_slice(), &reversed] {
            match (form.legs.as_slice(), form.joint) {
                ([leg], _) => add_straight(units, leg, slots, &mut rows),
                ([first, second], Joint::Gap) => add_parts(units, first, second, slots, &mut rows),
                (legs, _) => add_around_corners(units, legs, slots, &mut rows),
            }
        }
    }
    rows
}

/// Rows from the one end of a stretch and from the other.
fn add_straight(units: &Units, leg: &Leg, slots: &[Slot], rows: &mut Vec<Row>) {
    let Some(lane) = Lane::pack(units, slots, leg.length(), Taken::default()) else { return };
    rows.extend(lane.ways(units, leg).into_iter().filter_map(|standings| row(units, standings)));
}

/// Rows that turn at each place of their order, once for each corner; legs begin at corners.
fn add_around_corners(units: &Units, legs: &[Leg], slots: &[Slot], rows: &mut Vec<Row>) {
    let corners: Vec<FittedUnit> = legs[1..].iter().zip(legs).zip(units.corners()).map(in_corner).collect();
    // The room may refuse a filler that goes on past an end.
    let plain: Vec<Leg> = legs.iter().map(Leg::without_gaps).collect();
    let plain = (plain != legs).then_some(plain);
    for first in (1..slots.len()).filter(|&turn| !parts_water(slots, turn)) {
        let seconds = if legs.len() > 2 { first + 1..slots.len() } else { slots.len()..slots.len() + 1 };
        for second in seconds.filter(|&turn| !parts_water(slots, turn)) {
            let parts = [&slots[..first], &slots[first..second], &slots[second..]];
            for legs in [Some(legs), plain.as_deref()].into_iter().flatten() {
                let Some(mut standings) = along_legs(units, legs, &parts) else { continue };
                standings.splice(0..0, corners.iter().copied());
                rows.extend(row(units, standings));
            }
        }
    }
}

/// Whether a row that turns there has the sink on one side of the turn and what belongs beside it on the other.
fn parts_water(slots: &[Slot], turn: usize) -> bool {
    let is_wet = |slot: Option<&Slot>| matches!(slot, Some(Slot::Sink | Slot::Beside));
    is_wet(slots.get(turn - 1)) && is_wet(slots.get(turn))
}

/// The unit in the corner before a leg.
fn in_corner(((after, before), (unit, corner)): ((&Leg, &Leg), (usize, &Unit))) -> FittedUnit {
    let Width { metres: width, variant } = corner.narrowest();
    let spot = Spot { before: after.before, ..Spot::standing(after.wall, before.before) };
    FittedUnit { unit, variant, spot, width }
}

/// The units of each part of an order along its leg; `None` if they do not fit.
fn along_legs(units: &Units, legs: &[Leg], parts: &[&[Slot]]) -> Option<Vec<FittedUnit>> {
    let (mut standings, mut taken) = (Vec::new(), Taken::default());
    let is_tall = |packed: Option<&Packed>| packed.is_none_or(|packed| packed.part == FittedPart::Tall);
    for (place, (leg, slots)) in legs.iter().zip(parts).enumerate() {
        let lane = Lane::pack(units, slots, leg.length(), taken)?;
        let (is_first, is_last) = (place == 0, place + 1 == legs.len());
        // Nothing tall in a corner: its door opens against the other leg.
        if !is_first && is_tall(lane.packed.first()) || !is_last && is_tall(lane.packed.last()) {
            return None;
        }
        // A hole between two corners belongs to nobody: a panel closes a small one.
        if !is_first && !is_last && lane.left > PANEL {
            return None;
        }
        taken = lane.taken;
        let end = if is_first { End::Start } else { End::End };
        let closed = if is_first || is_last { *leg } else { Leg { beyond: [0.0; 2], ..*leg } };
        let plain = || lane.from(leg, if is_first { lane.left } else { 0.0 });
        standings.extend(lane.filled(units, &closed, end, lane.left).unwrap_or_else(plain));
    }
    Some(standings)
}

/// Rows whose ends stand at another wall, the fridge or it and worktops, or are a bar.
fn add_parts(units: &Units, first: &Leg, second: &Leg, slots: &[Slot], rows: &mut Vec<Row>) {
    let turns = [slots.len() - 2, slots.len() - 1];
    for turn in turns.into_iter().filter(|&turn| !parts_water(slots, turn)) {
        let Some(one) = Lane::pack(units, &slots[..turn], first.length(), Taken::default()) else { continue };
        // The second part is short, for the table needs the other walls, but a bar is no wall, and what is left is of use.
        let is_short = second.is_bar() || second.length() < SECOND_PART + USEFUL;
        let metres = if is_short { second.length() } else { SECOND_PART };
        let Some(two) = Lane::pack(units, &slots[turn..], metres, one.taken) else { continue };
        if one.packed.is_empty() || two.packed.is_empty() {
            continue;
        }
        let two = two.within(second.length() - metres);
        let turned = two.turned();
        let seconds: Vec<Vec<FittedUnit>> =
            [&two, &turned].iter().flat_map(|lane| lane.ways(units, second)).collect();
        for one in one.ways(units, first) {
            rows.extend(seconds.iter().filter_map(|two| row(units, [one.as_slice(), two].concat())));
        }
    }
}

/// A row of these units; `None` if it lacks a required one.
fn row(units: &Units, standings: Vec<FittedUnit>) -> Option<Row> {
    let stands = |index: usize| standings.iter().any(|standing| standing.unit == index);
    let low = |part: &FittedPart| *part != FittedPart::WallUnit;
    let all = units.indices().filter(|&index| low(&units.unit(index).part));
    let missing: Vec<usize> = all.filter(|&index| !stands(index)).collect();
    if missing.iter().any(|&index| units.unit(index).is_required) {
        return None;
    }
    let is_complete = missing.iter().all(|&index| units.unit(index).is_fill);
    let is_spacious =
        metres_between(units, &standings).is_none_or(|metres| metres >= ENOUGH_BETWEEN - ROUNDING);
    Some(Row { standings, is_complete: is_complete && is_spacious, points: 0.0 })
}

/// Metres from the sink to the hob at one wall.
pub(super) fn metres_between(units: &Units, standings: &[FittedUnit]) -> Option<f64> {
    let find = |part| standings.iter().find(|standing| units.unit(standing.unit).part == part);
    let (sink, hob) = (find(FittedPart::Sink)?, find(FittedPart::Hob)?);
    let is_one_leg = sink.spot.wall == hob.spot.wall && sink.is_bar() == hob.is_bar();
    is_one_leg.then(|| (sink.from() - hob.to()).max(hob.from() - sink.to()))
}
