//! Things that stand on tables, and vessels to carry things in. Each geometry set has shapes of its own.

mod carrying;
mod drinking;
mod eating;

pub(super) use carrying::{BASKET, TRAY};
pub(super) use drinking::{BOTTLE, CUP, GLASS};
pub(super) use eating::{BOWL, PLATE};

use crate::recipes::kit::{Bay, Outline, Slice, Solid, loft};

/// Corners of plates, cups and bowls.
const SIDES: usize = 12;

/// What a round body goes through, from below upwards and, where it is hollow, down again inside: (share of the height,
/// share of the radius) pairs.
type Profile = &'static [(f64, f64)];

/// A slice of a round body that fills a box, at a share of its height.
fn ring(bay: Bay, share: f64, shrink: f64) -> Slice {
    let half = bay.extent() / 2.0;
    let middle = bay.center();
    Slice::new(bay.low.y + share * bay.height(), half.x * shrink, half.z * shrink).at(middle.x, middle.z)
}

/// A round body along a profile.
fn turned(bay: Bay, profile: &[(f64, f64)]) -> Solid {
    turned_coarse(bay, profile, SIDES)
}

/// The same of another number of corners.
fn turned_coarse(bay: Bay, profile: &[(f64, f64)], sides: usize) -> Solid {
    let slices: Vec<Slice> = profile.iter().map(|&(share, shrink)| ring(bay, share, shrink)).collect();
    loft(&Outline::Round(sides), &slices)
}
