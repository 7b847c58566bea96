//! Fills the rows of a spine with rooms: which room in which row, in which order, and how wide.

use crate::layout::seed::Stream;

use super::hall::{Hall, shorten};
use super::spine::Row;
use super::typology::{Light, RoomNeeds};

/// Metres of border with the hall that a door needs: the door, its frame, and a hand's breadth beside it.
pub(super) const DOOR_STRETCH: f64 = 1.05;
/// Metres of outer wall that a window needs.
pub(super) const WINDOW_STRETCH: f64 = 1.0;
/// How much larger or smaller than wished all rooms of a row may be.
const ROW_SCALE: (f64, f64) = (0.5, 3.2);
/// Metres of outer wall with light for each room that needs windows, for any way of dividing it.
pub(super) const LIGHT_EACH: f64 = 1.6;
/// Metres of width for the walls of a room, and for places that are rounded.
const MARGIN: f64 = 0.15;
/// Metres by which a slice is wider and deeper than its room needs: rows are not quite rectangles.
const MORE_THAN_NEEDED: f64 = 0.1;
/// Least width of a room that ends before the outer wall, beside the side of a square of its size.
const INNER_WIDTH: f64 = 0.75;
/// Longer rooms than this many times their width are corridors to look at.
const SLENDER: f64 = 2.0;
/// Cost of each metre that a room lacks of the width at which it is good to furnish: a bedroom that is too narrow for a double bed
/// is worse than a hall that is two metres longer.
const NARROW_COST: f64 = 4.0;

/// A room that is wished for.
#[derive(Clone, Debug)]
pub(super) struct Wish<'a> {
    /// Id of its room type.
    pub(super) room_type: &'a str,
    /// Square metres.
    pub(super) area: f64,
    /// What such rooms need.
    pub(super) needs: &'a RoomNeeds,
}

impl Wish<'_> {
    /// Metres along a row and across it that its room has at least.
    fn least(&self) -> f64 {
        self.needs.width + MORE_THAN_NEEDED
    }

    /// Metres of outer wall that its room usually takes.
    fn stretch(&self) -> f64 {
        0.8 * self.area.sqrt()
    }
}

/// A room's place in a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Slice {
    /// Index of the wish.
    pub(super) wish: usize,
    /// Index of the row.
    pub(super) row: usize,
    /// From where to where along the strip.
    pub(super) from: f64,
    /// See `from`.
    pub(super) to: f64,
    /// Whether it borders on the strip so far that a door may lead there.
    pub(super) is_at_strip: bool,
    /// Whether its door leads to the hall: else to another room.
    pub(super) is_at_hall: bool,
}

/// Rooms in rows.
#[derive(Clone, Debug)]
pub(super) struct Filling {
    /// The slices, row by row, in order along the strip.
    pub(super) slices: Vec<Slice>,
    /// How far it is from what was wished for: 0 is perfect.
    pub(super) cost: f64,
    /// From where to where the hall reaches along the strip, where it may end before that does.
    pub(super) hall: Option<(f64, f64)>,
    /// What that costs.
    pub(super) hall_cost: f64,
}

impl Filling {
    fn total(&self) -> f64 {
        self.cost + self.hall_cost
    }
}

/// What rooms are set into.
#[derive(Clone, Copy)]
pub(super) struct Floor<'a> {
    /// The rows.
    pub(super) rows: &'a [Row],
    /// The hall between them, where it may end before the strip does.
    pub(super) hall: Option<Hall<'a>>,
}

/// The best of several ways to fill the rows; `None` if none keeps to what rooms need.
pub(super) fn fill(
    floor: Floor<'_>,
    wishes: &[Wish<'_>],
    tries: u32,
    stream: &mut Stream,
) -> Option<Filling> {
    let rows = floor.rows;
    if rows.is_empty() || rows.len() > wishes.len() {
        return None;
    }
    // Rooms that need windows share what light there is.
    let lengths: Vec<f64> = rows.iter().map(|row| row.light_between(row.from - 1.0, row.to + 1.0)).collect();
    let needing = wishes.iter().filter(|wish| wish.needs.light == Light::Required);
    let mut stretches: Vec<f64> = needing.map(|wish| wish.stretch()).collect();
    stretches.sort_by(f64::total_cmp);
    let housed: usize = lengths.iter().map(|&length| housed_behind(length, &stretches)).sum();
    if housed < stretches.len() || lengths.iter().sum::<f64>() < LIGHT_EACH * stretches.len() as f64 {
        return None;
    }
    // Each row takes one of them at least.
    let suits = |row: &Row, wish: &Wish<'_>| wish.least() <= row.depth().min(row.length());
    let is_used = |row: &Row| wishes.iter().any(|wish| suits(row, wish));
    let is_housed = |wish: &Wish<'_>| rows.iter().any(|row| suits(row, wish));
    if !rows.iter().all(is_used) || !wishes.iter().all(is_housed) {
        return None;
    }
    let mut best: Option<Filling> = None;
    for attempt in 0..tries {
        let way = shuffled(rows, wishes, &lengths, stream).and_then(|order| place(floor, wishes, &order));
        if let Some(way) = way.filter(|way| best.as_ref().is_none_or(|best| way.total() < best.total())) {
            best = Some(way);
        }
        // Where nothing came out so far, hardly anything will.
        if best.is_none() && attempt >= tries / 2 {
            return None;
        }
    }
    best
}

/// How many rooms that take these stretches, rising, have light behind so many metres of outer wall at most.
fn housed_behind(length: f64, stretches: &[f64]) -> usize {
    let mut rest = length;
    let has_light = |stretch: &&f64| {
        let is_lit = rest >= WINDOW_STRETCH;
        rest -= **stretch;
        is_lit
    };
    stretches.iter().take_while(has_light).count()
}

/// The wishes of each row in an order.
fn shuffled(
    rows: &[Row],
    wishes: &[Wish<'_>],
    lengths: &[f64],
    stream: &mut Stream,
) -> Option<Vec<Vec<usize>>> {
    let total: f64 = wishes.iter().map(|wish| wish.area).sum();
    let available: f64 = rows.iter().map(Row::area).sum();
    let mut room: Vec<f64> = rows.iter().map(|row| row.area() * total / available).collect();
    let mut light = lengths.to_vec();
    let mut free: Vec<f64> = rows.iter().map(Row::length).collect();
    let depths: Vec<f64> = rows.iter().map(Row::depth).collect();
    let mut order: Vec<(f64, usize)> = wishes
        .iter()
        .enumerate()
        .map(|(index, wish)| (wish.area * stream.between(0.6, 1.6), index))
        .collect();
    order.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    let mut chosen: Vec<Vec<usize>> = vec![Vec::new(); rows.len()];
    for (_, index) in order {
        let wish = &wishes[index];
        let mut best: Option<(f64, usize)> = None;
        for row in 0..rows.len() {
            let needs_light = wish.needs.light == Light::Required;
            let is_wide = wish.least() <= free[row].min(depths[row]);
            if !is_wide || (needs_light && light[row] < WINDOW_STRETCH) {
                continue;
            }
            let is_lit = lengths[row] > WINDOW_STRETCH;
            let waste = if !needs_light && is_lit { 0.5 } else { 0.0 };
            let worth = room[row] / wish.area.max(1.0) - waste + stream.between(0.0, 0.6);
            if best.is_none_or(|(known, _)| worth > known) {
                best = Some((worth, row));
            }
        }
        let (_, row) = best?;
        room[row] -= wish.area;
        free[row] -= wish.least();
        light[row] -= wish.stretch();
        let at = stream.below(chosen[row].len() + 1);
        chosen[row].insert(at, index);
    }
    chosen.iter().all(|row| !row.is_empty()).then_some(chosen)
}

fn place(Floor { rows, hall }: Floor<'_>, wishes: &[Wish<'_>], order: &[Vec<usize>]) -> Option<Filling> {
    let mut slices = Vec::with_capacity(wishes.len());
    let mut cost = 0.0;
    for (row, chosen) in order.iter().enumerate() {
        let wished: f64 = chosen.iter().map(|&wish| wishes[wish].area).sum();
        let scale = rows[row].area() / wished;
        if !(ROW_SCALE.0..=ROW_SCALE.1).contains(&scale) {
            return None;
        }
        let areas = shares(chosen, wishes, &rows[row]);
        let mut taken = 0.0;
        let mut from = rows[row].from;
        let first = slices.len();
        for (place, (&wish, area)) in chosen.iter().zip(areas).enumerate() {
            taken += area;
            let is_last = place + 1 == chosen.len();
            let to = if is_last { rows[row].to } else { (rows[row].place_of(taken) * 20.0).round() / 20.0 };
            slices.push(Slice { wish, row, from, to, is_at_strip: false, is_at_hall: false });
            from = to;
        }
        cost += judge_row(&rows[row], wishes, &mut slices[first..], scale)?;
    }
    let Some(hall) = hall else { return Some(Filling { slices, cost, hall: None, hall_cost: 0.0 }) };
    let (reach, hall_cost) = shorten(rows, wishes, hall, &mut slices)?;
    Some(Filling { slices, cost, hall: Some(reach), hall_cost })
}

/// Square metres of each room of a row, which fill it: where there is more than was wished for, baths and stores grow less than
/// rooms to live in, but to the width that they need.
fn shares(chosen: &[usize], wishes: &[Wish<'_>], row: &Row) -> Vec<f64> {
    let wished: f64 = chosen.iter().map(|&wish| wishes[wish].area).sum();
    let (available, depth) = (row.area(), row.depth());
    let scale = available / wished;
    let is_large = |wish: usize| wishes[wish].needs.light == Light::Required;
    let small = |wish: usize| {
        let grown = wishes[wish].area * if scale > 1.0 { scale.sqrt() } else { scale };
        let width = wishes[wish].needs.width + MARGIN;
        // A room that ends before the outer wall is not much deeper than it is wide.
        let width =
            if wishes[wish].needs.inner { width.max(INNER_WIDTH * wishes[wish].area.sqrt()) } else { width };
        grown.max(width * depth)
    };
    let of_small: f64 = chosen.iter().filter(|&&wish| !is_large(wish)).map(|&wish| small(wish)).sum();
    let of_large: f64 = chosen.iter().filter(|&&wish| is_large(wish)).map(|&wish| wishes[wish].area).sum();
    let (for_large, for_small) = match of_large > 0.0 {
        true => ((available - of_small).max(0.0) / of_large, 1.0),
        false => (0.0, available / of_small),
    };
    let share =
        |&wish: &usize| if is_large(wish) { wishes[wish].area * for_large } else { small(wish) * for_small };
    chosen.iter().map(share).collect()
}

fn judge_row(row: &Row, wishes: &[Wish<'_>], slices: &mut [Slice], scale: f64) -> Option<f64> {
    let mut cost = 0.0;
    for slice in &mut *slices {
        let needs = wishes[slice.wish].needs;
        let (length, depth) = (slice.to - slice.from, row.depth());
        if length.min(depth) < wishes[slice.wish].least() {
            return None;
        }
        if needs.light == Light::Required && row.light_between(slice.from, slice.to) < WINDOW_STRETCH {
            return None;
        }
        let contact = row.contact_between(slice.from, slice.to).map_or(0.0, |(from, to)| to - from);
        slice.is_at_strip = contact >= DOOR_STRETCH;
        slice.is_at_hall = slice.is_at_strip;
        let slenderness = length.max(depth) / length.min(depth);
        let narrowness = needs.good_width.map_or(0.0, |good| (good - length.min(depth)).max(0.0));
        cost += libm::log(scale).abs() + (slenderness - SLENDER).max(0.0) + NARROW_COST * narrowness;
    }
    for index in 0..slices.len() {
        if slices[index].is_at_hall {
            continue;
        }
        // A room that the hall does not reach is entered from a neighbour that may be walked through.
        let neighbours = [index.checked_sub(1), Some(index + 1).filter(|&next| next < slices.len())];
        let doors = &wishes[slices[index].wish].needs.doors;
        let leads = |other: usize| {
            slices[other].is_at_hall && doors.iter().any(|door| door == wishes[slices[other].wish].room_type)
        };
        if !neighbours.into_iter().flatten().any(leads) {
            return None;
        }
        cost += 0.4;
    }
    Some(cost)
}

/// From where to where along the strip the hall is needed by these slices: each keeps [`DOOR_STRETCH`] of it.
pub(super) fn needed(rows: &[Row], slices: &[Slice]) -> Option<(f64, f64)> {
    let contacts = slices
        .iter()
        .filter(|slice| slice.is_at_hall)
        .filter_map(|slice| rows[slice.row].contact_between(slice.from, slice.to));
    let reach = contacts.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), (from, to)| {
        (low.min(to - DOOR_STRETCH), high.max(from + DOOR_STRETCH))
    });
    (reach.0 < reach.1).then_some(reach)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn light_is_for_as_many_rooms_as_have_a_stretch_of_it() {
        assert_eq!(housed_behind(0.9, &[2.0, 2.0]), 0, "no window has a place");
        assert_eq!(housed_behind(4.5, &[2.0, 3.0, 3.0]), 2);
        assert_eq!(housed_behind(30.0, &[2.0, 3.0]), 2);
    }
}
