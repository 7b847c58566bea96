//! Counts over many rooms, for the manifest and for reports.

use std::collections::BTreeMap;

use serde::Serialize;

use super::finding::{Finding, Grade, Severity};

/// Verdicts of a level, a building or a whole run. The order in which rooms are added does not matter.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct AuditSummary {
    /// Rooms by grade.
    pub grades: GradeCounts,
    /// Findings by the name of their code; codes without a finding are left out.
    pub findings: BTreeMap<&'static str, u32>,
    /// The same of what the plans leave no other choice in; no part of the grades.
    pub given: BTreeMap<&'static str, u32>,
}

/// Rooms by the paper's three grades.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct GradeCounts {
    /// Without a finding.
    pub none: u32,
    /// With minor findings only.
    pub minor: u32,
    /// With a finding that fails the room.
    pub failed: u32,
}

impl AuditSummary {
    /// Adds the findings of one room.
    pub fn add_room(&mut self, findings: &[Finding]) {
        match Grade::of(findings) {
            Grade::None => self.grades.none += 1,
            Grade::Minor => self.grades.minor += 1,
            Grade::Failed => self.grades.failed += 1,
        }
        for finding in findings {
            let counts = match finding.severity {
                Severity::Given => &mut self.given,
                Severity::Minor | Severity::Failed => &mut self.findings,
            };
            *counts.entry(finding.code.name()).or_insert(0) += 1;
        }
    }

    /// Adds the counts of another part of the run.
    pub fn merge(&mut self, other: &Self) {
        self.grades.none += other.grades.none;
        self.grades.minor += other.grades.minor;
        self.grades.failed += other.grades.failed;
        for (own, others) in [(&mut self.findings, &other.findings), (&mut self.given, &other.given)] {
            for (&name, &count) in others {
                *own.entry(name).or_insert(0) += count;
            }
        }
    }

    /// How many rooms were judged.
    #[must_use]
    pub fn room_count(&self) -> u32 {
        self.grades.none + self.grades.minor + self.grades.failed
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::audit::Code;

    #[test]
    fn rooms_and_codes_are_counted_and_parts_add_up() {
        let collision = Finding::new(Code::Collision, vec!["a.1".into()], 0.1, 0.001);
        let unfulfilled = Finding::new(Code::Unfulfilled, Vec::new(), 0.5, 0.9);
        let mut first = AuditSummary::default();
        first.add_room(&[]);
        first.add_room(&[collision.clone(), collision, unfulfilled.clone()]);
        let mut second = AuditSummary::default();
        second.add_room(&[unfulfilled.clone(), unfulfilled.given()]);
        first.merge(&second);
        assert_eq!(first.grades, GradeCounts { none: 1, minor: 1, failed: 1 });
        assert_eq!(first.room_count(), 3);
        let json = serde_json::to_string(&first.findings).unwrap();
        assert_eq!(json, r#"{"collision":2,"unfulfilled":2}"#);
        assert_eq!(first.given, BTreeMap::from([("unfulfilled", 1)]));
    }
}
