//! Units side by side along one stretch: which of them fit, in which widths, and what closes the rest.

use crate::catalog::FittedPart;

use super::legs::{JOINT, Leg, USEFUL};
use super::units::{Unit, Units, Width, widest_within};
use crate::layout::fitted_row::FittedUnit;
use crate::layout::spot::Spot;

/// Metres of worktop between sink and hob that are wanted where there is room: NKBA asks for 0.91 m of preparation area.
const BETWEEN: f64 = 1.2;
/// Metres of it for which units are taken narrower than they were drawn, and then for which what stands beside the sink is
/// given up: a pot and a board; the narrowest unit.
pub(super) const ENOUGH_BETWEEN: f64 = 0.6;
const LEAST_BETWEEN: f64 = 0.3;
/// Metres of it at most: one carries pots farther than that.
const MOST_BETWEEN: f64 = 1.8;
/// Metres of worktop on the other side of the hob that are wanted; NKBA asks for 0.38 m.
const LANDING: f64 = 0.6;
/// Metres by which units may be wider than their stretch together: rounding.
pub(super) const ROUNDING: f64 = 1e-6;

/// A place in the order of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Slot {
    Tall,
    Beside,
    Sink,
    /// Worktop between sink and hob.
    Between,
    Hob,
    /// Worktop on the other side of the hob.
    Landing,
    /// Worktop where wall is left.
    Rest,
}

impl FittedUnit {
    /// Whether it stands along a leg.
    pub(super) fn is_along(&self, leg: &Leg) -> bool {
        self.spot.wall == leg.wall && self.is_bar() == leg.is_bar() && self.from() + ROUNDING >= leg.from
    }
}

/// A unit in the width that it has in a lane.
#[derive(Clone, Copy, Debug)]
pub(super) struct Packed {
    unit: usize,
    width: Width,
    /// What the unit is there for.
    pub(super) part: FittedPart,
}

/// How many units of which a row has several are used up.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Taken {
    worktops: usize,
    fillers: usize,
}

/// An end of a stretch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum End {
    Start,
    End,
}

/// Units side by side along one stretch.
#[derive(Clone)]
pub(super) struct Lane {
    pub(super) packed: Vec<Packed>,
    /// The next panel that closes what is left, by index.
    panel: Option<usize>,
    /// What is used up, with that of earlier lanes.
    pub(super) taken: Taken,
    /// Metres of the stretch that are left.
    pub(super) left: f64,
}

impl Lane {
    /// Packs the units of some slots into so many metres, after those that others took. `None` if what is required does not
    /// fit.
    pub(super) fn pack(units: &Units, slots: &[Slot], metres: f64, taken: Taken) -> Option<Self> {
        let metres = metres + ROUNDING;
        let fixed = fixed_units(units, slots, metres)?;
        let used: f64 = fixed.iter().map(|packed| packed.width.metres).sum();
        let mut shelf = Worktops { units, taken: taken.worktops, left: metres - used };
        let tops = shelf.stock(slots);
        let left = shelf.left.max(0.0);
        let panel = units.of_part(FittedPart::Filler).nth(taken.fillers).map(|(unit, _)| unit);
        let taken = Taken { worktops: shelf.taken, fillers: taken.fillers + 1 };
        let mut packed = Vec::with_capacity(fixed.len() + taken.worktops + 1);
        for (slot, tops) in slots.iter().zip(tops) {
            packed.extend(fixed.iter().filter(|packed| slot_of(packed.part) == Some(*slot)));
            packed.extend(tops);
        }
        Some(Self { packed, panel, taken, left })
    }

    /// The same on a stretch that is so many metres longer.
    pub(super) fn within(self, longer: f64) -> Self {
        Self { left: self.left + longer, ..self }
    }

    /// The same units from the last to the first.
    pub(super) fn turned(&self) -> Self {
        Self { packed: self.packed.iter().rev().copied().collect(), ..self.clone() }
    }

    /// The ways in which the units stand along a leg: with a filler at an end that is closed, else from its start, and from its
    /// end.
    pub(super) fn ways(&self, units: &Units, leg: &Leg) -> Vec<Vec<FittedUnit>> {
        let [starts_closed, ends_closed] = leg.is_closed();
        let rest = |is_other_closed: bool| if is_other_closed { self.left } else { 0.0 };
        let at_start = self.filled(units, leg, End::Start, rest(ends_closed));
        let at_end = self.filled(units, leg, End::End, rest(starts_closed));
        // The room may refuse a filler that goes on past an end.
        let is_sure = starts_closed && ends_closed && (at_start.is_some() || at_end.is_some());
        let mut ways: Vec<Vec<FittedUnit>> = [at_start, at_end].into_iter().flatten().collect();
        if !is_sure {
            ways.push(self.from(leg, 0.0));
        }
        if !is_sure && self.left > ROUNDING {
            ways.push(self.from(leg, self.left));
        }
        ways
    }

    /// The units with their filler at an end of a leg, beside which so many metres of what is left lie; `None` where it closes
    /// nothing. It stands between what is tall at the end and the others, for a wall is no good neighbour of a low panel; but
    /// where something comes into the depth of the row at its end, the filler goes on past that, to the wall.
    pub(super) fn filled(&self, units: &Units, leg: &Leg, end: End, rest: f64) -> Option<Vec<FittedUnit>> {
        let (unit, beyond) = (self.panel?, leg.beyond[end as usize]);
        let is_past = beyond >= JOINT;
        let panel = units.unit(unit);
        let (widths, gap) = if is_past { (&panel.slim, rest + beyond) } else { (&panel.widths, rest) };
        let width = widest_within(widths, gap + ROUNDING).filter(|width| gap - width.metres < JOINT)?;
        let is_tall = |packed: Option<&Packed>| packed.is_some_and(|packed| packed.part == FittedPart::Tall);
        let (count, is_inside) = (self.packed.len(), !is_past && self.packed.len() > 1);
        let (at, offset) = match end {
            End::Start => (usize::from(is_inside && is_tall(self.packed.first())), rest - width.metres),
            End::End => (count - usize::from(is_inside && is_tall(self.packed.last())), self.left - rest),
        };
        let mut lane = self.clone();
        lane.packed.insert(at, Packed { unit, width, part: FittedPart::Filler });
        Some(lane.from(leg, offset))
    }

    /// The units where they stand if the first begins so many metres after the start of the stretch.
    pub(super) fn from(&self, leg: &Leg, offset: f64) -> Vec<FittedUnit> {
        let mut from = leg.from + offset;
        let stand = |packed: &Packed| {
            let Width { metres: width, variant } = packed.width;
            let spot = Spot { before: leg.before, ..Spot::standing(leg.wall, from) };
            let standing = FittedUnit { unit: packed.unit, variant, spot, width };
            from += width;
            standing
        };
        self.packed.iter().map(stand).collect()
    }
}

/// The units of some slots that are no worktops, as wide as they fit together: as drawn, else narrow, else without those
/// beside the sink, else without the tall ones, else without a hob that nobody requires.
fn fixed_units(units: &Units, slots: &[Slot], metres: f64) -> Option<Vec<Packed>> {
    let is_here = |unit: &Unit| slot_of(unit.part).is_some_and(|slot| slots.contains(&slot));
    let indices = units.indices().filter(|&index| is_here(units.unit(index)));
    let as_drawn = |unit: usize| {
        let Unit { part, widths, .. } = units.unit(unit);
        Packed { unit, width: widths[0], part: *part }
    };
    let mut packed: Vec<Packed> = indices.map(as_drawn).collect();
    // At a corner, too, it begins beside the sink or the hob that is nearer.
    let has = |slot: &Slot| slots.contains(slot);
    let has_worktop = has(&Slot::Between) && (has(&Slot::Sink) || has(&Slot::Hob));
    let leaves = |packed: &[Packed], between: f64| {
        let used: f64 = packed.iter().map(|packed| packed.width.metres).sum();
        used + if has_worktop { between } else { 0.0 } <= metres
    };
    if !leaves(&packed, ENOUGH_BETWEEN) {
        packed.iter_mut().for_each(|packed| packed.width = units.unit(packed.unit).narrowest());
    }
    if !leaves(&packed, ENOUGH_BETWEEN) {
        packed.retain(|packed| {
            let unit = units.unit(packed.unit);
            unit.part != FittedPart::BesideSink || !unit.is_fill
        });
    }
    // A hob right at the sink is still better than none.
    let last =
        [(FittedPart::BesideSink, LEAST_BETWEEN), (FittedPart::Tall, LEAST_BETWEEN), (FittedPart::Hob, 0.0)];
    for (part, between) in last {
        if !leaves(&packed, between) {
            packed.retain(|packed| {
                let unit = units.unit(packed.unit);
                unit.part != part || unit.is_required
            });
        }
    }
    leaves(&packed, 0.0).then_some(packed)
}

/// The slot that a part stands in; worktops have several.
fn slot_of(part: FittedPart) -> Option<Slot> {
    match part {
        FittedPart::Sink => Some(Slot::Sink),
        FittedPart::BesideSink => Some(Slot::Beside),
        FittedPart::Hob => Some(Slot::Hob),
        FittedPart::Tall => Some(Slot::Tall),
        FittedPart::Worktop | FittedPart::Corner | FittedPart::WallUnit | FittedPart::Filler => None,
    }
}

/// The worktops that are not used up, and the metres that are left for them.
struct Worktops<'a> {
    units: &'a Units,
    taken: usize,
    left: f64,
}

impl Worktops<'_> {
    /// The worktops of each slot: first those that are needed between sink and hob and beside it, then those for the rest.
    fn stock(&mut self, slots: &[Slot]) -> Vec<Vec<Packed>> {
        let mut tops = vec![Vec::new(); slots.len()];
        let has = |slot: Slot| slots.contains(&slot);
        let wants_landing = has(Slot::Landing) && has(Slot::Hob);
        // A corner between sink and hob is worktop already.
        let is_between = has(Slot::Sink) && has(Slot::Hob);
        for (index, slot) in slots.iter().enumerate() {
            if *slot == Slot::Between {
                let has_enough = self.left >= ENOUGH_BETWEEN + LEAST_BETWEEN;
                let reserved = if wants_landing && has_enough { LEAST_BETWEEN } else { 0.0 };
                let wanted = if is_between { BETWEEN } else { LANDING };
                tops[index] = self.take(wanted.min(self.left - reserved));
            }
        }
        for (index, slot) in slots.iter().enumerate() {
            if *slot == Slot::Landing && wants_landing {
                tops[index] = self.take(LANDING);
            }
        }
        if let Some(index) = slots.iter().rposition(|slot| *slot == Slot::Rest) {
            tops[index] = self.take(f64::INFINITY);
        }
        if self.left < USEFUL {
            let most = |slot: &Slot| match slot {
                Slot::Between if is_between => MOST_BETWEEN,
                Slot::Between => 0.0,
                _ => f64::INFINITY,
            };
            let limits: Vec<f64> = slots.iter().map(most).collect();
            while self.widen(&mut tops, &limits) {}
        }
        tops
    }

    /// Takes worktops for so many metres at most, as wide as they are made.
    fn take(&mut self, metres: f64) -> Vec<Packed> {
        let mut metres = metres.min(self.left);
        let mut taken = Vec::new();
        while let Some((unit, worktop)) = self.units.of_part(FittedPart::Worktop).nth(self.taken) {
            let Some(width) = worktop.width_within(metres + ROUNDING) else { break };
            taken.push(Packed { unit, width, part: FittedPart::Worktop });
            (metres, self.left) = (metres - width.metres, self.left - width.metres);
            self.taken += 1;
        }
        taken
    }

    /// Makes the worktop wider that closes most of what is left, each slot up to its metres; whether there was one.
    fn widen(&mut self, tops: &mut [Vec<Packed>], limits: &[f64]) -> bool {
        let mut best: Option<(f64, usize, usize, Width)> = None;
        for (slot, packed) in tops.iter().enumerate() {
            let used: f64 = packed.iter().map(|packed| packed.width.metres).sum();
            for (place, one) in packed.iter().enumerate() {
                let most = self.left.min(limits[slot] - used) + one.width.metres;
                let wider = widest_within(&self.units.unit(one.unit).widths, most + ROUNDING);
                let gain = wider.map_or(0.0, |width| width.metres - one.width.metres);
                // Of equal ones the first, so that the order of the row decides.
                if let Some(width) = wider
                    && gain > best.map_or(ROUNDING, |best| best.0 + ROUNDING)
                {
                    best = Some((gain, slot, place, width));
                }
            }
        }
        let Some((gain, slot, place, width)) = best else { return false };
        tops[slot][place].width = width;
        self.left -= gain;
        true
    }
}
