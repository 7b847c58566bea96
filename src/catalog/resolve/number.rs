//! Checks numbers against their bounds.

use std::ops::RangeInclusive;

use crate::catalog::WEALTH;
use crate::catalog::report::{Report, Spot};

/// Metres of anything that must be there: below is an error of unit, above is no furniture.
pub(super) const LENGTH: RangeInclusive<f64> = 0.001..=50.0;
/// Metres of a distance, which may be none.
pub(super) const DISTANCE: RangeInclusive<f64> = 0.0..=50.0;
/// Metres of a distance that may be below zero.
pub(super) const SIGNED_DISTANCE: RangeInclusive<f64> = -50.0..=50.0;
/// Metres beyond the far end of any room.
pub(super) const FAR: f64 = 1000.0;
/// Metres between any two objects of a room.
pub(super) const RANGE: RangeInclusive<f64> = 0.0..=FAR;
/// Degrees of a random or tolerated angle.
pub(super) const ANGLE: RangeInclusive<f64> = 0.0..=180.0;
/// Degrees of a turn.
pub(super) const TURN: RangeInclusive<f64> = -360.0..=360.0;
/// A share of a whole.
pub(super) const SHARE: RangeInclusive<f64> = 0.0..=1.0;
/// A factor or weight.
pub(super) const FACTOR: RangeInclusive<f64> = 0.0..=100.0;
/// A parameter of a recipe: a count of drawers or shelves, a share, or on and off.
pub(super) const PARAMETER: RangeInclusive<f64> = 0.0..=100.0;
/// Square metres of a room: no hall is larger.
pub(super) const AREA: RangeInclusive<f64> = 0.0..=1e6;
/// Pieces, places or looks: a line that asks for more is a slip of the keyboard.
pub(super) const COUNT: RangeInclusive<i64> = 0..=10_000;

/// A checked number: its name in messages, its unit and its bounds.
pub(super) struct Quantity {
    /// The name for messages.
    pub(super) name: &'static str,
    /// Its unit with a space before it, or nothing.
    pub(super) unit: &'static str,
    /// The allowed range.
    pub(super) range: RangeInclusive<f64>,
}

impl Quantity {
    /// A number of metres.
    pub(super) fn metres(name: &'static str, range: RangeInclusive<f64>) -> Self {
        Self { name, unit: " m", range }
    }

    /// A number of degrees.
    pub(super) fn degrees(name: &'static str, range: RangeInclusive<f64>) -> Self {
        Self { name, unit: "°", range }
    }

    /// A number without unit.
    pub(super) fn plain(name: &'static str, range: RangeInclusive<f64>) -> Self {
        Self { name, unit: "", range }
    }

    /// The number if it is within the bounds; else it is reported and stands at the nearest bound.
    pub(super) fn check(&self, value: f64, spot: &Spot, report: &mut Report<'_>) -> f64 {
        if self.range.contains(&value) {
            return value;
        }
        let Self { name, unit, range } = self;
        let hint = format!("it lies between {} and {}{unit}", range.start(), range.end());
        report.error_with_hint(spot, format!("{name} is {value}{unit}"), &hint);
        *range.start()
    }

    /// Two numbers within the bounds, the first not above the second.
    pub(super) fn check_pair(
        &self,
        (low, high): (f64, f64),
        spot: &Spot,
        report: &mut Report<'_>,
    ) -> (f64, f64) {
        if low > high {
            let message = format!("{} goes from {low} down to {high}{}", self.name, self.unit);
            report.error_with_hint(spot, message, "write the lower number first");
        }
        (self.check(low, spot, report), self.check(high, spot, report))
    }
}

/// A degree of wealth, or the lowest one after a report.
pub(super) fn check_wealth(value: f64, spot: &Spot, report: &mut Report<'_>) -> u32 {
    let (least, most) = WEALTH;
    if value.fract() != 0.0 {
        report.error_with_hint(spot, format!("wealth is {value}"), "it is a whole number");
    }
    Quantity::plain("wealth", f64::from(least)..=f64::from(most)).check(value, spot, report) as u32
}

/// A count within [`COUNT`], or the lowest one after a report.
pub(super) fn check_count(name: &str, value: i64, spot: &Spot, report: &mut Report<'_>) -> u32 {
    if !COUNT.contains(&value) {
        let hint = format!("it lies between {} and {}", COUNT.start(), COUNT.end());
        report.error_with_hint(spot, format!("{name} is {value}"), &hint);
        return 0;
    }
    u32::try_from(value).expect("counts are bounded")
}
