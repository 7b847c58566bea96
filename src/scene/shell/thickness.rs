//! The thickness of walls as they are built.

use crate::plan::{Wall, WallKind};

/// Thickness of a wall to the open air where the plan has none.
const SHEET: f64 = 0.01;
/// Thickness where the plan has none and another room lies behind: what stands against the wall there must
/// not be swallowed.
pub(super) const THIN_SHEET: f64 = 0.002;
/// Thickness of a railing that the plan gives none.
const RAILING: f64 = 0.05;

/// The thickness that is built.
pub(super) fn built_thickness(wall: &Wall) -> f64 {
    let least = match wall.kind {
        WallKind::Railing(_) => RAILING,
        WallKind::Solid if wall.is_exterior => SHEET,
        WallKind::Solid => THIN_SHEET,
    };
    if wall.thickness < THIN_SHEET { least } else { wall.thickness }
}
