//! Round bodies that lie.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::recipes::kit::{Solid, cylinder, lathe};

/// Rings of a ball between its poles.
const RINGS: i32 = 5;

/// A body built upwards around the y axis, laid down so that its top looks to the right.
pub(in super::super) fn turned_sideways(solid: Solid) -> Solid {
    solid.turned_z(-FRAC_PI_2)
}

/// A disc or bar along x, from end to end, around the x axis.
pub(in super::super) fn across(radius: f64, x: [f64; 2], sides: usize) -> Solid {
    turned_sideways(cylinder(radius, x, sides))
}

/// A ball around the origin.
pub(in super::super) fn ball(radius: f64, sides: usize) -> Solid {
    let ring = |step: i32| {
        let (sine, cosine) = libm::sincos(PI * f64::from(step) / f64::from(RINGS + 1));
        (if step % (RINGS + 1) == 0 { 0.0 } else { radius * sine }, -radius * cosine)
    };
    let profile: Vec<(f64, f64)> = (0..=RINGS + 1).map(ring).collect();
    lathe(&profile, sides)
}
