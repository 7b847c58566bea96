//! Resolves the thresholds of the audit.

use super::number::{ANGLE, AREA, DISTANCE, FACTOR, Quantity, SHARE};
use crate::catalog::AuditRules;
use crate::catalog::audit::{AuditFile, Unit};
use crate::catalog::report::{Report, Spot};

/// The built-in thresholds, and over them those of each file with its index.
pub(crate) fn resolve_audit(files: &[(usize, AuditFile)], report: &mut Report<'_>) -> AuditRules {
    let mut rules = AuditRules::default();
    for (source, file) in files {
        rules.overlay(file, |[section, key], unit, value| {
            let spot = Spot::definition(*source, "thresholds", section).key(key);
            quantity(unit).check(value, &spot, report)
        });
    }
    rules
}

fn quantity(unit: Unit) -> Quantity {
    match unit {
        Unit::Metres => Quantity::metres("the threshold", DISTANCE),
        Unit::Area => Quantity { name: "the threshold", unit: " m²", range: AREA },
        Unit::Degrees => Quantity::degrees("the threshold", ANGLE),
        Unit::Share => Quantity::plain("the threshold", SHARE),
        Unit::Factor => Quantity::plain("the threshold", FACTOR),
    }
}
