//! Reads the units of lengths and angles of a file.

use super::model::{Entity, Model, Read};
use crate::plan::units::si_prefix;

/// Factors to metres and radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Units {
    pub(super) length: f64,
    pub(super) angle: f64,
}

/// Where an `IfcProject` names its units.
const UNITS_OF_PROJECT: usize = 8;
/// A unit defined by a unit defined by a unit.
const DEEPEST: usize = 4;

impl Units {
    /// The units of the project; metres and radians, with a warning, where it names none.
    pub(super) fn of(model: &Model) -> Self {
        let mut units = Self { length: 1.0, angle: 1.0 };
        let project = model.all(&["IFCPROJECT"]).next();
        let assignment = project.as_ref().and_then(|project| project.value(UNITS_OF_PROJECT).reference());
        let assignment = assignment.or_else(|| model.ids(&["IFCUNITASSIGNMENT"]).next());
        let listed = assignment.and_then(|id| model.sound(model.get(id).and_then(|all| all.references(0))));
        let mut has_length = false;
        for id in listed.unwrap_or_default() {
            let Some(unit) = model.sound(model.get(id)) else { continue };
            let factor = match unit.value(1).word() {
                Some("LENGTHUNIT") => &mut units.length,
                Some("PLANEANGLEUNIT") => &mut units.angle,
                _ => continue,
            };
            if let Some(found) = model.sound(in_si(model, &unit, 0)) {
                *factor = found;
                has_length |= unit.value(1).word() == Some("LENGTHUNIT");
            }
        }
        if !has_length {
            let id = project.map_or(0, |project| project.id);
            model.warn(id, "no unit of length: metres are taken".to_owned(), "IfcUnitAssignment names it");
        }
        units
    }
}

/// Metres or radians in a unit.
fn in_si(model: &Model, unit: &Entity, depth: usize) -> Read<f64> {
    match unit.kind.as_str() {
        "IFCSIUNIT" => {
            let prefix = unit.value(2).word();
            let factor = prefix.map_or(Some(1.0), si_prefix);
            factor.ok_or_else(|| unit.trouble(format!("unknown prefix \"{}\"", prefix.unwrap_or_default())))
        }
        "IFCCONVERSIONBASEDUNIT" | "IFCCONVERSIONBASEDUNITWITHOFFSET" if depth < DEEPEST => {
            let measure = model.get(unit.reference(3)?)?;
            let base = model.get(measure.reference(1)?)?;
            Ok(measure.positive(0)? * in_si(model, &base, depth + 1)?)
        }
        _ => Err(unit.trouble("no unit that is known here")),
    }
}
