//! How large a unit of a plan is.

use super::geometry::Shapes;
use super::notes::Notes;
use super::sheet::Sheet;
use crate::geometry::signed_area;
use crate::plan::read::archilyse::areas::Outline;

/// The class of the area within the outer walls.
const INNER: &str = "inner";
/// Classes of the rooms of a flat.
const INDOORS: [&str; 6] = ["living", "bedroom", "bathroom", "kitchen", "storage", "stair"];
/// How many times the stated area the drawn one may be where the units are metres: canvases are hundreds of times as large.
const AREA_FACTOR: f64 = 10.0;
/// Metres between which a unit lies: a plan is between 3 m and 300 m wide on a canvas of 256 to 2000 units.
const UNIT: (f64, f64) = (1e-4, 10.0);

/// Metres of a unit; `None` if nothing says it, which is noted.
///
/// `net_area` is the area within the outer walls (`inner`), or of the rooms where that is not drawn; the data set lacks it for a
/// third of the plans. `area` is set against `inner` as `compute_scale_from_meta` of the data set's own `resplan_utils.py` does.
pub(super) fn metres_per_unit(sheet: &Sheet, given: Option<f64>, notes: &mut Notes) -> Option<f64> {
    if given.is_some() {
        return given;
    }
    let drawn = |class: &str| sheet.classes.get(class).map_or(0.0, area);
    let rooms: f64 = INDOORS.iter().map(|class| drawn(class)).sum();
    let inner = Some(drawn(INNER)).filter(|area| *area > 0.0).unwrap_or(rooms);
    let stated = sheet.net_area.or(sheet.area);
    // Files that were written with a unit and without a scale say both, and are wrong about the unit.
    let is_plausible = |stated: f64| inner <= stated * AREA_FACTOR;
    if sheet.is_metres && stated.is_none_or(is_plausible) {
        return Some(1.0);
    }
    let Some(stated) = stated else {
        let hint = "name the metres of one unit with --scale, or add \"net_area\" in m²";
        notes.error(&sheet.place, "the plan has no scale: neither \"net_area\" nor \"area\" is stated", hint);
        return None;
    };
    let metres = (stated / inner).sqrt();
    if (UNIT.0..=UNIT.1).contains(&metres) {
        return Some(metres);
    }
    let message = format!("{stated} m² are no scale for rooms of {inner} square units");
    notes.error(&sheet.place, message, "name the metres of one unit with --scale");
    None
}

fn area(shapes: &Shapes) -> f64 {
    let of_outline = |outline: &Outline| {
        let holes: f64 = outline.holes.iter().map(|hole| signed_area(hole).abs()).sum();
        (signed_area(&outline.outer).abs() - holes).max(0.0)
    };
    shapes.iter().map(|(_, outline)| of_outline(outline)).sum()
}
